//! A cycle of the undamped pendulum, and the energy that damping would remove in it.
//!
//! With sin(θ/2) = k cos φ, θ′ = 2k sin φ and ω0 = 1 the loss is ∮|θ′|ⁿ⁺¹ dt = 4(2k)ⁿ⁺¹ ∫ sinⁿ⁺¹φ/√(k′²
//! + k² sin²φ) dφ over a right angle. For integer n it is elementary (n even) or elliptic (n odd).

use std::f64::consts::{FRAC_PI_2, PI};

use super::Damping;
use libration_kernels::double_double::DoubleDouble;
use libration_kernels::elementary::two_word;
use libration_kernels::internals::elliptic::{Complete, complete};
use libration_numbers::internals::quadrature::equal_steps;
use libration_pendulum::pendulum::Amplitude;

/// The cycle of one amplitude.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cycle {
    /// k = sin(θ0/2).
    modulus: DoubleDouble,
    /// k′ = cos(θ0/2).
    complementary: DoubleDouble,
    integrals: Complete,
}

/// ∮|θ′|ⁿ⁺¹ dt over an undamped cycle with ω0 = 1: 4θ0 for n = 0, 16(E − k′²K) for n = 1, 8(sin θ0 − θ0 cos θ0) for n = 2, and so on.
///
/// # Domain
/// n ≥ 0; NaN elsewhere. Amplitudes down to 1e-100.
///
/// # Accuracy
/// Relative error 2e-15; for n other than 0, 1, 2 and 3 by quadrature, with a relative error of 2e-14 (`tests/data/decay_cycles.csv`).
#[must_use]
pub fn cycle_integral(exponent: f64, amplitude: &Amplitude) -> f64 {
    let modulus = amplitude.modulus();
    Cycle::new(modulus.modulus_words(), modulus.complementary_words()).integral(exponent)
}

/// The limit of that integral at small amplitudes, 2βAⁿ⁺¹ with β = ∫ sinⁿ⁺¹ over half a turn = √π Γ(n/2 + 1)/Γ((n + 3)/2).
#[must_use]
pub fn small_cycle_integral(exponent: f64, amplitude: f64) -> f64 {
    let beta = match exponent {
        0.0 => 2.0,
        1.0 => FRAC_PI_2,
        2.0 => 4.0 / 3.0,
        3.0 => 0.375 * PI,
        _ => PI.sqrt() * libm::exp(libm::lgamma(0.5 * exponent + 1.0) - libm::lgamma(0.5 * exponent + 1.5)),
    };
    2.0 * beta * amplitude * libm::pow(amplitude, exponent)
}

/// Modulus k below which the third term of a series in k² is beyond the last digit.
const SMALL: f64 = 5e-5;

impl Cycle {
    fn new(modulus: DoubleDouble, complementary: DoubleDouble) -> Self {
        Self { modulus, complementary, integrals: complete(modulus, complementary) }
    }

    /// The cycle with this tan(θ0/2).
    pub(super) fn of_tangent(tangent: f64) -> Self {
        let tangent = DoubleDouble::from(tangent);
        // The smaller of the two is relatively accurate, and nothing overflows.
        if tangent.hi <= 1.0 {
            let cosine = (DoubleDouble::ONE + tangent.square()).sqrt().recip();
            return Self::new(tangent * cosine, cosine);
        }
        let cotangent = tangent.recip();
        let sine = (DoubleDouble::ONE + cotangent.square()).sqrt().recip();
        Self::new(sine, cotangent * sine)
    }

    /// θ0.
    pub(super) fn amplitude(&self) -> f64 {
        2.0 * libm::atan2(self.modulus.hi, self.complementary.hi)
    }

    /// sin θ0.
    pub(super) fn sine(&self) -> f64 {
        2.0 * self.modulus.hi * self.complementary.hi
    }

    /// The period of the cycle.
    pub(super) fn period(&self) -> f64 {
        4.0 * self.integrals.first.to_f64()
    }

    /// The energy that damping dissipates in the cycle.
    pub(super) fn loss(&self, damping: &Damping) -> f64 {
        damping.terms().iter().map(|term| term.coefficient * self.integral(term.exponent)).sum()
    }

    fn integral(&self, exponent: f64) -> f64 {
        match exponent {
            0.0 => 4.0 * self.amplitude(),
            1.0 => 16.0 * self.integrals.second_less_scaled_first.to_f64(),
            2.0 => 8.0 * self.sine_less_product(),
            3.0 => 64.0 * self.fourth_moment(),
            _ if exponent >= 0.0 => self.by_quadrature(exponent),
            _ => f64::NAN,
        }
    }

    /// sin θ0 − θ0 cos θ0, in two words because the result is of third order in θ0.
    fn sine_less_product(&self) -> f64 {
        let (k, complementary) = (self.modulus, self.complementary);
        if k.hi < SMALL {
            let angle = self.amplitude();
            return angle * angle * angle * (1.0 / 3.0 - angle * angle / 30.0);
        }
        let angle = two_word::atan2(k, complementary).scaled(2.0);
        let (sine, cosine) = ((k * complementary).scaled(2.0), (complementary - k) * (complementary + k));
        (sine - angle * cosine).to_f64()
    }

    /// k⁴ ∫ cn⁴ over a quarter period = (2(k² − k′²)(E − k′²K) + k²k′²K)/3, in two words because the result is of order k⁴.
    fn fourth_moment(&self) -> f64 {
        let (m, m1) = (self.modulus.square(), self.complementary.square());
        if self.modulus.hi < SMALL {
            return m.hi * m.hi * (3.0 * PI / 16.0) * (1.0 + m.hi / 12.0);
        }
        let first = ((m - m1) * self.integrals.second_less_scaled_first).scaled(2.0);
        ((first + m * m1 * self.integrals.first) / DoubleDouble::from(3.0)).to_f64()
    }

    /// With t = tan φ the integral is ∫ sinⁿ⁺²φ/√(k′² + t²) d ln t over the whole line. The integrand is analytic in ln t up to ±iπ/2 for every
    /// k′, so that equal steps are optimal: their error is of order exp(−π²/h) = 4e-22, and so are the omitted tails.
    fn by_quadrature(&self, exponent: f64) -> f64 {
        const STEPS_PER_UNIT: f64 = 5.0;
        const TAIL: f64 = 45.0;
        let (k, complementary) = (self.modulus.hi, self.complementary.hi);
        let term = |step: i32| {
            let tangent = libm::exp(f64::from(step) / STEPS_PER_UNIT);
            let square = tangent * tangent;
            let sine = tangent / (1.0 + square).sqrt();
            // The sum exponent + 1 would be rounded.
            libm::pow(2.0 * k * sine, exponent) * 2.0 * k * sine * sine
                / (complementary * complementary + square).sqrt()
        };
        let above = (1..).take_while(|&step| f64::from(step) < TAIL * STEPS_PER_UNIT);
        let below = (0..).take_while(|&step| f64::from(step) * (exponent + 1.0) < TAIL * STEPS_PER_UNIT);
        4.0 * equal_steps(STEPS_PER_UNIT, above.chain(below.map(|step: i32| -step)), term).value
    }
}
