//! The amplitude as the formulas take it, relatively accurate at the bottom and at the top.

use super::real::Real;
use crate::algebra::BigFloat;
use crate::double_double::DoubleDouble;
use crate::elementary::two_word;
use crate::quantity::Angle;

/// An amplitude within [0, π), given by what is smaller of it and its complement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum SwingAmplitude {
    /// θ0.
    FromBottom(DoubleDouble),
    /// π − θ0.
    FromTop(DoubleDouble),
}

impl SwingAmplitude {
    /// `None` at and beyond π, and for angles with turns.
    pub(super) fn from_angle(angle: &Angle) -> Option<Self> {
        let (amplitude, complement) = (angle.in_turn_words().abs(), angle.complement_words());
        let swings = angle.turns() == 0 && amplitude.is_finite() && complement.hi > 0.0;
        let lower = amplitude.hi <= complement.hi;
        swings.then_some(if lower { Self::FromBottom(amplitude) } else { Self::FromTop(complement) })
    }

    /// `None` outside [0, π).
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

    pub(super) fn radians(self) -> f64 {
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

/// What the formulas are written in: the amplitude and the functions of it that several share.
#[derive(Clone, Debug)]
pub(super) struct Swing<R> {
    /// θ0.
    pub(super) amplitude: R,
    /// π − θ0.
    pub(super) complement: R,
    /// cos(θ0/2), from the complement near the top.
    pub(super) cos_half: R,
    /// sin(θ0/2).
    pub(super) sin_half: R,
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

/// 2⁻¹⁰: there the error of the best formulas with a root or a logarithm is near 10⁻¹⁴ and what two words are off 2⁻⁸⁶.
pub(super) const NEAREST_BOTTOM: f64 = 0.0009765625;
/// 2⁻³⁶.
pub(super) const NEAREST_TOP: f64 = 1.4551915228366852e-11;

impl Swing<DoubleDouble> {
    /// `None` next to the bottom, where errors are so small that two words do not show them, and so near the top that its digits were not
    /// tried.
    #[inline(always)]
    pub(super) fn in_two_words(amplitude: SwingAmplitude) -> Option<Self> {
        match amplitude {
            SwingAmplitude::FromBottom(amplitude) if amplitude.hi >= NEAREST_BOTTOM => {
                let (sin_half, cos_half) = two_word::sin_cos_inline(amplitude.scaled(0.5));
                Some(Self { amplitude, complement: DoubleDouble::PI - amplitude, cos_half, sin_half })
            }
            SwingAmplitude::FromTop(complement) if complement.hi >= NEAREST_TOP => {
                let (cos_half, sin_half) = two_word::sin_cos_inline(complement.scaled(0.5));
                Some(Self { amplitude: DoubleDouble::PI - complement, complement, cos_half, sin_half })
            }
            _ => None,
        }
    }

    /// T/T0 = 1/agm(1, cos(θ0/2)), in ten steps at most.
    #[inline(always)]
    pub(super) fn exact_ratio(&self) -> DoubleDouble {
        let (mut a, mut b) = (DoubleDouble::ONE, self.cos_half);
        while a.hi - b.hi > 1e-9 {
            (a, b) = ((a + b).scaled(0.5), (a * b).sqrt());
        }
        // Two more steps double the digits that agree, of which the second takes only the mean.
        (a, b) = ((a + b).scaled(0.5), (a * b).sqrt());
        DoubleDouble::ONE / (a + b).scaled(0.5)
    }
}

impl Swing<BigFloat> {
    pub(super) fn with_precision(amplitude: SwingAmplitude, precision: usize) -> Self {
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

    /// T/T0 = 1/agm(1, cos(θ0/2)), exactly but for rounding (DLMF 19.8.5).
    pub(super) fn exact_ratio(&self) -> BigFloat {
        self.number(1) / self.number(1).agm(&self.cos_half)
    }
}
