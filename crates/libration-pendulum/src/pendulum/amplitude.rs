//! The amplitude of a libration and the quantities that depend on it alone.

use super::{PendulumError, period};
use libration_kernels::dispatch::{Kernel, dispatch};
use libration_kernels::double_double::DoubleDouble;
use libration_kernels::elementary::two_word;
use libration_kernels::elliptic::{self, Modulus};
use libration_kernels::internals::elliptic::complete_and_nome;
use libration_kernels::internals::elliptic::{Complete, complete};
use libration_numbers::quantity::Angle;

/// Complement below which its half would be subnormal, and rounded.
pub(super) const SMALLEST_HALVED: f64 = 2.0 * f64::MIN_POSITIVE;

/// The amplitude of a libration: an angle of at least zero and less than π, with its complement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amplitude {
    pub(super) angle: Angle,
}

impl Amplitude {
    /// The amplitude |angle|.
    ///
    /// # Errors
    /// An angle at or beyond ±π.
    pub fn new(angle: Angle) -> Result<Self, PendulumError> {
        let angle = angle.abs();
        if angle.turns() != 0 || angle.complement() <= 0.0 {
            return Err(PendulumError::AmplitudeBeyondTop(angle.radians()));
        }
        Ok(Self { angle })
    }

    /// The amplitude with sin(θ0/2) and cos(θ0/2) in the ratio of these two positive numbers.
    pub(super) fn from_half_angle(sine: DoubleDouble, cosine: DoubleDouble) -> Self {
        let angle = two_word::atan2(sine, cosine).scaled(2.0);
        let complement = two_word::atan2(cosine, sine).scaled(2.0);
        Self { angle: Angle::from_parts(0, angle, complement) }
    }

    /// The amplitude as an angle.
    #[must_use]
    pub fn angle(&self) -> Angle {
        self.angle
    }

    /// θ0 in radians.
    #[must_use]
    pub fn radians(&self) -> f64 {
        self.angle.in_turn()
    }

    /// π − θ0 in radians.
    #[must_use]
    pub fn complement(&self) -> f64 {
        self.angle.complement()
    }

    /// T/T0, within 0.56 ulp.
    #[must_use]
    pub fn period_ratio(&self) -> f64 {
        self.ratio_and_excess().0
    }

    /// T/T0 − 1, within 0.9 ulp from θ0 = 1e-150 on.
    #[must_use]
    pub fn period_excess(&self) -> f64 {
        self.ratio_and_excess().1
    }

    pub(super) fn ratio_and_excess(&self) -> (f64, f64) {
        period::ratio_and_excess(self.angle.in_turn_words(), self.angle.complement_words())
    }

    /// The nome q = exp(−πK′/K) of the modulus sin(θ0/2).
    #[must_use]
    pub fn nome(&self) -> f64 {
        let (k, complementary) = self.half_angle();
        if self.complement() >= SMALLEST_HALVED {
            return elliptic::nome_of_words(k, complementary);
        }
        // K′ is π/2 for such an amplitude.
        two_word::exp(-(DoubleDouble::FRAC_PI_2 * DoubleDouble::PI / self.integrals().first)).to_f64()
    }

    /// The condition number (θ0/T)·dT/dθ0 of the period with respect to the amplitude: the ratio of the relative error of the period to that of
    /// the amplitude; ∞ below a complement of 2.5e-311. From DLMF 19.4.1.
    #[must_use]
    pub fn condition(&self) -> f64 {
        self.condition_with(self.logarithmic_slope())
    }

    fn condition_with(&self, slope: DoubleDouble) -> f64 {
        condition_of(self.angle.in_turn_words(), slope)
    }

    /// (1/T)·dT/dθ0 = (E − k′²K)/(2kk′K), in 1/rad.
    pub(super) fn logarithmic_slope(&self) -> DoubleDouble {
        self.slope_with(self.half_angle(), &self.integrals())
    }

    fn slope_with(
        &self,
        (k, complementary): (DoubleDouble, DoubleDouble),
        integrals: &Complete,
    ) -> DoubleDouble {
        let complement = self.angle.complement_words();
        let twice = if complement.hi < SMALLEST_HALVED { complement } else { complementary.scaled(2.0) };
        slope_of(k, integrals.cosine_part, integrals.first, twice)
    }

    /// The period in units of 4/ω0, the nome and the condition number, with one common preparation.
    pub(super) fn of_modulus(&self) -> OfModulus {
        if self.complement() < SMALLEST_HALVED {
            let first = self.integrals().first;
            return OfModulus { first, nome: self.nome(), condition: self.condition() };
        }
        let words = self.half_angle();
        let (integrals, nome) = complete_and_nome(words.0, words.1);
        let condition = self.condition_with(self.slope_with(words, &integrals));
        OfModulus { first: integrals.first, nome, condition }
    }

    /// The integrals of the modulus; if k′ would be rounded, from K(k′) = K(2k′) + ln 2.
    fn integrals(&self) -> Complete {
        let (k, complementary) = self.half_angle();
        let complement = self.angle.complement_words();
        if complement.hi >= SMALLEST_HALVED {
            return complete(k, complementary);
        }
        let doubled = complete(k, complement);
        Complete { first: doubled.first + DoubleDouble::LN_2, ..doubled }
    }

    /// The modulus k = sin(θ0/2) with its complement k′ = cos(θ0/2), rounded to an `f64` if it is below 2.2e-308.
    #[must_use]
    pub fn modulus(&self) -> Modulus {
        let (k, complementary) = self.half_angle();
        Modulus::from_words(k, complementary)
    }

    /// sin θ0, relatively accurate near the top too.
    #[doc(hidden)]
    pub fn sine(&self) -> f64 {
        let (k, complementary) = self.half_angle();
        (k * complementary).to_f64() * 2.0
    }

    /// sin(θ0/2) and cos(θ0/2), each relatively accurate.
    pub(super) fn half_angle(&self) -> (DoubleDouble, DoubleDouble) {
        half_angle(&self.angle)
    }

    /// 2πR/ω0.
    pub(super) fn period_in_units_of(&self, angular_frequency: DoubleDouble) -> f64 {
        period_of_quarter(self.integrals().first, angular_frequency)
    }
}

/// (E − k′²K)/k²·k/K/2k′, given twice k′.
#[inline(always)]
pub(super) fn slope_of(
    k: DoubleDouble,
    cosine_part: DoubleDouble,
    first: DoubleDouble,
    twice: DoubleDouble,
) -> DoubleDouble {
    k * cosine_part / first / twice
}

/// The condition number of the period, given its logarithmic slope.
#[inline(always)]
pub(super) fn condition_of(amplitude: DoubleDouble, slope: DoubleDouble) -> f64 {
    // 1/δ overflows for the smallest complements.
    let product = (amplitude * slope).to_f64();
    if slope.is_finite() { product } else { f64::INFINITY }
}

/// 4K/ω0.
#[inline(always)]
pub(super) fn period_of_quarter(first: DoubleDouble, angular_frequency: DoubleDouble) -> f64 {
    (first.scaled(4.0) / angular_frequency).to_f64()
}

/// The result of [`Amplitude::of_modulus`].
pub(super) struct OfModulus {
    /// K.
    pub(super) first: DoubleDouble,
    pub(super) nome: f64,
    pub(super) condition: f64,
}

/// The sine and cosine of half the angle in the turn; the cosine is computed from the complement where it is small.
pub(super) fn half_angle(angle: &Angle) -> (DoubleDouble, DoubleDouble) {
    dispatch(HalfAngle(angle))
}

struct HalfAngle<'a>(&'a Angle);

impl Kernel for HalfAngle<'_> {
    type Output = (DoubleDouble, DoubleDouble);
    #[inline(always)]
    fn run(self) -> (DoubleDouble, DoubleDouble) {
        let (in_turn, complement) = (self.0.in_turn_words(), self.0.complement_words());
        if complement.hi > std::f64::consts::FRAC_PI_2 {
            return two_word::sin_cos_series(in_turn.scaled(0.5));
        }
        let (cosine, sine) = two_word::sin_cos_series(complement.scaled(0.5));
        (if in_turn.hi < 0.0 { -sine } else { sine }, cosine)
    }
}
