//! Symmetries of motions that are known before the motions are computed.

use super::extremes::extremes;
use super::half_turns::{BothTurns, half_turns};
use super::lindstedt::{Family, Wave};
use super::phase_origin::PhaseOrigin;
use libration_motion::oscillator::Kind;
use libration_numbers::{algebra::Ring, internals::algebra::HarmonicPair};

/// The symmetry of the motions of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Limit cycles, whose amplitude is determined.
    Cycle,
    /// Even in time about both turning points.
    Asymmetric,
    /// Even in time about both turning points, which are opposite.
    Odd,
    /// Odd in time about a passage through the equilibrium, so that the turning points are opposite.
    Mirrored,
}

/// The shape of the motions of an oscillator, given the parity of its acceleration.
pub(crate) fn shape_of(kind: &Kind, odd: bool) -> Shape {
    match kind {
        Kind::LimitCycle { .. } => Shape::Cycle,
        Kind::Mirrored => Shape::Mirrored,
        Kind::Conservative | Kind::Reversible | Kind::TwoSided if odd => Shape::Odd,
        Kind::Conservative | Kind::Reversible | Kind::TwoSided => Shape::Asymmetric,
    }
}

impl From<Shape> for PhaseOrigin {
    fn from(shape: Shape) -> Self {
        match shape {
            Shape::Cycle => Self::FirstHarmonic,
            Shape::Asymmetric | Shape::Odd => Self::TurningPoint,
            Shape::Mirrored => Self::Passage,
        }
    }
}

impl Shape {
    /// The harmonics of motions about a centre.
    pub(crate) fn wave(self) -> Wave {
        if self == Self::Mirrored { Wave::Sine } else { Wave::Cosine }
    }

    /// The largest and the smallest displacement; `None` when a number is not in the ring.
    pub(crate) fn turning_points<R: Ring>(
        self,
        ring: &R,
        family: &Family<R::Element>,
    ) -> Option<BothTurns<R::Element>> {
        match self {
            Self::Cycle => extremes(ring, family),
            Self::Asymmetric | Self::Odd => Some(half_turns(ring, family)),
            Self::Mirrored => of_sines(ring, family),
        }
    }
}

/// The turning points next to τ = ±π/2.
fn of_sines<R: Ring>(ring: &R, family: &Family<R::Element>) -> Option<BothTurns<R::Element>> {
    let (mut x_max, mut x_min) = extremes(ring, &a_quarter_later(ring, family))?;
    x_max.insert(0, ring.zero());
    x_min.insert(0, ring.zero());
    Some((x_max, x_min))
}

/// The displacement over the variable, by the phase τ − π/2.
fn a_quarter_later<R: Ring>(ring: &R, family: &Family<R::Element>) -> Family<R::Element> {
    let turned = |k: usize, sine: &R::Element| {
        let signed = if k % 4 < 2 { sine.clone() } else { ring.negate(sine) };
        let wave = if k.is_multiple_of(2) { Wave::Sine } else { Wave::Cosine };
        wave.pair(signed, ring.zero())
    };
    let harmonic = |(k, series): (usize, &Vec<HarmonicPair<R::Element>>)| {
        series.iter().skip(1).map(|pair| turned(k, &pair.sine)).collect()
    };
    Family {
        frequency: family.frequency.clone(),
        harmonics: family.harmonics.iter().enumerate().map(harmonic).collect(),
    }
}
