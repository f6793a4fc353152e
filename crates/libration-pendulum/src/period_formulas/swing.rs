//! The amplitude in the variables of the formulas, relatively accurate at the bottom and at the top.

use super::real::Real;
use libration_kernels::double_double::DoubleDouble;
use libration_numbers::algebra::BigFloat;
use libration_numbers::quantity::Angle;

/// An amplitude within [0, π), given by the smaller of it and its complement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SwingAmplitude {
    /// θ0.
    FromBottom(DoubleDouble),
    /// π − θ0.
    FromTop(DoubleDouble),
}

impl SwingAmplitude {
    /// The amplitude of an angle; `None` at and beyond π, and for angles with turns.
    pub(super) fn from_angle(angle: &Angle) -> Option<Self> {
        let (amplitude, complement) = (angle.in_turn_words().abs(), angle.complement_words());
        let swings = angle.turns() == 0 && amplitude.is_finite() && complement.hi > 0.0;
        let lower = amplitude.hi <= complement.hi;
        swings.then_some(if lower { Self::FromBottom(amplitude) } else { Self::FromTop(complement) })
    }

    /// The amplitude in radians; `None` outside [0, π).
    pub(super) fn from_radians(amplitude: f64) -> Option<Self> {
        let swings = (0.0..=std::f64::consts::PI).contains(&amplitude);
        let angle = Angle::from_radians(amplitude).ok().filter(|_| swings)?;
        Self::from_angle(&angle)
    }

    pub(super) fn to_angle(self) -> Option<Angle> {
        match self {
            Self::FromBottom(amplitude) => Angle::from_radians(amplitude.to_f64()).ok(),
            Self::FromTop(complement) => Some(Angle::from_complement_words(complement)),
        }
    }

    pub fn radians(self) -> f64 {
        match self {
            Self::FromBottom(amplitude) => amplitude.to_f64(),
            Self::FromTop(complement) => (DoubleDouble::PI - complement).to_f64(),
        }
    }

    pub(super) fn complement(self) -> f64 {
        match self {
            Self::FromBottom(amplitude) => (DoubleDouble::PI - amplitude).to_f64(),
            Self::FromTop(complement) => complement.to_f64(),
        }
    }
}

/// The variables of the formulas: the amplitude, and functions of it that several formulas share.
#[derive(Clone, Copy, Debug)]
pub struct Swing<R> {
    /// θ0.
    pub amplitude: R,
    /// π − θ0.
    pub complement: R,
    /// cos(θ0/2), from the complement near the top.
    pub cos_half: R,
    /// sin(θ0/2).
    pub sin_half: R,
}

impl<R: Real> Swing<R> {
    /// 1 − cos(θ0/2), without cancellation.
    pub(super) fn versine_half(&self) -> R {
        self.sin_half.square() / (self.number(1) + self.cos_half.clone())
    }

    pub(super) fn number(&self, integer: i16) -> R {
        self.amplitude.number(integer)
    }
}

impl Swing<f64> {
    pub(super) fn new(amplitude: SwingAmplitude) -> Self {
        let (radians, complement) = (amplitude.radians(), amplitude.complement());
        let (cos_half, sin_half) = match amplitude {
            SwingAmplitude::FromBottom(_) => (libm::cos(radians / 2.0), libm::sin(radians / 2.0)),
            SwingAmplitude::FromTop(_) => (libm::sin(complement / 2.0), libm::cos(complement / 2.0)),
        };
        Self { amplitude: radians, complement, cos_half, sin_half }
    }
}

/// 2⁻¹⁰: there the error of the best formulas with a root or a logarithm is near 10⁻¹⁴ and the error of two words 2⁻⁸⁶.
pub const NEAREST_BOTTOM: f64 = 0.0009765625;
/// 2⁻³⁶.
pub const NEAREST_TOP: f64 = 1.4551915228366852e-11;

impl SwingAmplitude {
    /// Half of the smaller of the amplitude and its complement.
    #[inline(always)]
    pub(super) fn half_distance(self) -> DoubleDouble {
        let (Self::FromBottom(distance) | Self::FromTop(distance)) = self;
        distance.scaled(0.5)
    }

    /// Returns `false` next to the bottom, where errors are too small for two words, and closer to the top than two words were tested.
    #[inline(always)]
    pub(super) fn suits_two_words(self) -> bool {
        match self {
            Self::FromBottom(amplitude) => amplitude.hi >= NEAREST_BOTTOM,
            Self::FromTop(complement) => complement.hi >= NEAREST_TOP,
        }
    }
}

/// Difference of two means below which all their digits agree after two more steps, the second of which needs only the arithmetic mean.
pub(super) const AGREEING: f64 = 1e-9;

/// A step of the arithmetic-geometric mean.
#[inline(always)]
pub(super) fn next_means(a: DoubleDouble, b: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    ((a + b).scaled(0.5), (a * b).sqrt())
}

/// The inverse of the arithmetic-geometric mean of two numbers that differ by at most [`AGREEING`].
#[inline(always)]
pub(super) fn inverse_of_agreeing(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    let (a, b) = next_means(a, b);
    DoubleDouble::ONE / (a + b).scaled(0.5)
}

impl Swing<DoubleDouble> {
    /// The swing from the sine and the cosine of [`SwingAmplitude::half_distance`].
    #[inline(always)]
    pub(super) fn in_two_words(
        amplitude: SwingAmplitude,
        (sine, cosine): (DoubleDouble, DoubleDouble),
    ) -> Self {
        match amplitude {
            SwingAmplitude::FromBottom(amplitude) => {
                Self { amplitude, complement: DoubleDouble::PI - amplitude, cos_half: cosine, sin_half: sine }
            }
            SwingAmplitude::FromTop(complement) => Self {
                amplitude: DoubleDouble::PI - complement,
                complement,
                cos_half: sine,
                sin_half: cosine,
            },
        }
    }

    /// T/T0 = 1/agm(1, cos(θ0/2)), in ten steps at most.
    #[inline(always)]
    pub(super) fn exact_ratio(&self) -> DoubleDouble {
        let (mut a, mut b) = (DoubleDouble::ONE, self.cos_half);
        while a.hi - b.hi > AGREEING {
            (a, b) = next_means(a, b);
        }
        inverse_of_agreeing(a, b)
    }
}

impl Swing<BigFloat> {
    pub fn with_precision(amplitude: SwingAmplitude, precision: usize) -> Self {
        let pi = BigFloat::pi(precision);
        match amplitude {
            SwingAmplitude::FromBottom(words) => {
                let amplitude = BigFloat::from_words(words, precision);
                let (sin_half, cos_half) = amplitude.clone().halved().sin_cos();
                let complement = pi - amplitude.clone();
                Self { amplitude, complement, cos_half, sin_half }
            }
            SwingAmplitude::FromTop(words) => {
                let complement = BigFloat::from_words(words, precision);
                let (cos_half, sin_half) = complement.clone().halved().sin_cos();
                let amplitude = pi - complement.clone();
                Self { amplitude, complement, cos_half, sin_half }
            }
        }
    }

    /// T/T0 = 1/agm(1, cos(θ0/2)), exact up to rounding (DLMF 19.8.5).
    pub fn exact_ratio(&self) -> BigFloat {
        self.number(1) / self.number(1).agm(&self.cos_half)
    }
}
