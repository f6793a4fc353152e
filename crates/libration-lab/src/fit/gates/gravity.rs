//! g by the times of a gate: the angular width of the bob, and the correlations of T0 with the sizes that it depends on.

use super::width::{PassingDisc, PassingFlag};
use super::{GatesFit, T0Source};
use crate::fit::budget::{
    Apparatus, Budget, BudgetError, BudgetInput, Correlation, MeasuredPeriod, PeriodDamping, evaluate_budget,
};
use crate::fit::uncertain::Uncertain;
use libration::quantity::Quantity;

/// The shape of the object that blocks the gate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FlagShape {
    /// A ball, or a disc seen from the side.
    #[default]
    Ball,
    /// Flat, with straight edges parallel to the rod.
    Flat,
}

/// The pendulum with its gate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GateGeometry {
    apparatus: Apparatus,
    diameter: Option<Quantity>,
    distance: Option<Quantity>,
    shape: FlagShape,
}

/// Reasons why a geometry of a gate is impossible.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GateGeometryError {
    /// The object that blocks the gate reaches the pivot.
    #[error(
        "a bob or flag of diameter {diameter:?} m whose middle is {distance:?} m from the pivot would reach the pivot: check the two \
         lengths and their units"
    )]
    ReachesPivot {
        /// Diameter of the object that blocks the gate, in m.
        diameter: f64,
        /// Distance of its middle from the pivot, in m.
        distance: f64,
    },
    /// A bob that does not reach the gate, without anything else that would block it.
    #[error(
        "a bob of radius {radius:?} m and {length:?} m from the pivot does not pass a gate {distance:?} m from the pivot: check the \
         distance of the gate, or give the diameter of the flag that blocks it"
    )]
    BobMissesGate {
        /// Radius of the bob, in m.
        radius: f64,
        /// Distance from the pivot to its centre, in m.
        length: f64,
        /// Distance of the gate from the pivot, in m.
        distance: f64,
    },
}

impl GateGeometry {
    /// Describes a pendulum with its gate: the object that blocks the gate, if its diameter in m is given, passes it with its middle; otherwise it is
    /// the bob, by its radius, which a gate above or below its middle cuts in a chord. The distance of the gate from the pivot, in m, is the
    /// length of the pendulum where it is not given.
    ///
    /// # Errors
    /// Fails if the object that blocks the gate reaches the pivot, or if the bob does not reach the gate.
    pub fn new(
        apparatus: Apparatus,
        diameter: Option<Quantity>,
        distance: Option<Quantity>,
    ) -> Result<Self, GateGeometryError> {
        let geometry = Self { apparatus, diameter, distance, shape: FlagShape::Ball };
        let Some((PassingDisc { radius, centre, beam }, _)) = geometry.disc() else { return Ok(geometry) };
        if radius >= centre {
            return Err(GateGeometryError::ReachesPivot { diameter: 2.0 * radius, distance: centre });
        }
        if (beam - centre).abs() >= radius {
            return Err(GateGeometryError::BobMissesGate { radius, length: centre, distance: beam });
        }
        Ok(geometry)
    }

    /// Returns the geometry with another shape of the object with the given diameter, which is then the width of the flag. The bob itself is a ball.
    #[must_use]
    pub fn with_shape(self, shape: FlagShape) -> Self {
        Self { shape, ..self }
    }

    /// Returns the flat flag, if the object is one.
    fn flag(&self, disc: PassingDisc) -> Option<PassingFlag> {
        let is_flat = self.shape == FlagShape::Flat && self.diameter.is_some();
        is_flat.then_some(PassingFlag { half: disc.radius, beam: disc.beam })
    }

    fn distance(&self) -> Quantity {
        self.distance.unwrap_or(self.apparatus.length)
    }

    /// The object that passes the gate, with its radius: centred on the gate if its diameter is given, otherwise the bob.
    fn disc(&self) -> Option<(PassingDisc, Quantity)> {
        let beam = self.distance().value;
        let half = |diameter: Quantity| Quantity {
            value: 0.5 * diameter.value,
            uncertainty: diameter.uncertainty.map(|spread| 0.5 * spread),
        };
        let (radius, centre) = match self.diameter {
            Some(diameter) => (half(diameter), beam),
            None => (self.apparatus.corrections.bob?.outline_radius()?, self.apparatus.length.value),
        };
        Some((PassingDisc { radius: radius.value, centre, beam }, radius))
    }

    /// The angle through which the bob moves while it blocks the gate, in radians; `None` if neither diameter nor radius is known.
    #[must_use]
    pub fn width(&self) -> Option<Quantity> {
        let (disc, _) = self.disc()?;
        let value = self.flag(disc).map_or_else(|| disc.width(), |flag| flag.width());
        let [by_radius, by_length, by_distance] = self.changes_of_width()?;
        let uncertainty = Some(libm::hypot(libm::hypot(by_radius, by_length), by_distance));
        Some(Quantity { value, uncertainty })
    }

    /// Changes of the width with one standard uncertainty of the radius, of the length, and of a separate distance, in radians.
    fn changes_of_width(&self) -> Option<[f64; 3]> {
        let (disc, radius) = self.disc()?;
        let [by_radius, by_centre, by_beam] = match self.flag(disc) {
            Some(flag) => {
                let [by_half, by_beam] = flag.slopes();
                [by_half, 0.0, by_beam]
            }
            None => disc.slopes(),
        };
        let (by_length, by_distance) = match (self.diameter, self.distance) {
            (_, None) => (by_centre + by_beam, 0.0),
            (Some(_), Some(_)) => (0.0, by_centre + by_beam),
            (None, Some(_)) => (by_centre, by_beam),
        };
        let spread = |quantity: Quantity| quantity.uncertainty.unwrap_or(0.0);
        Some([
            by_radius * spread(radius),
            by_length * spread(self.apparatus.length),
            by_distance * self.distance.map_or(0.0, spread),
        ])
    }

    /// The changes of the width by inputs of g, each with its input.
    fn changes_by_inputs(&self) -> impl Iterator<Item = (BudgetInput, f64)> {
        let [by_radius, by_length, _] = self.changes_of_width().unwrap_or_default();
        let by_radius = if self.diameter.is_none() { by_radius } else { 0.0 };
        let changes = [(BudgetInput::Length, by_length), (BudgetInput::BobRadius, by_radius)];
        changes.into_iter().filter(|(_, change)| *change != 0.0)
    }
}

impl GatesFit {
    /// Returns `true` if the times contain no information on the uncertainty of a period, as if they are few or exactly even: it is then not known.
    #[must_use]
    pub fn is_exact(&self, period: Uncertain) -> bool {
        /// Largest fraction of a period that counts as rounding.
        const ROUNDING: f64 = 1e-12;
        period.uncertainty < ROUNDING * period.value
    }

    /// The correlation of T0 with a length whose standard uncertainty changes the angular width by this, in radians; `None` if
    /// T0 does not come from the width.
    #[must_use]
    pub fn correlation_by_width(&self, change: f64) -> Option<f64> {
        let spread = Some(self.t0_by_times?.uncertainty).filter(|spread| *spread > 0.0)?;
        Some((self.t0_by_width? * change / spread).clamp(-1.0, 1.0))
    }

    /// Correlations of T0 with the sizes that the width is computed from.
    #[must_use]
    pub fn correlations(&self, geometry: &GateGeometry) -> Vec<Correlation> {
        let correlation = |(input, change): (BudgetInput, f64)| {
            let coefficient = self.correlation_by_width(change)?;
            Some(Correlation { between: [input, BudgetInput::Period], coefficient })
        };
        geometry.changes_by_inputs().filter_map(correlation).collect()
    }

    /// Computes g with its budget; `None` without T0. The relative uncertainties of all angles and of the clock apply to the given
    /// amplitude and to all times. The damping derived from the fall of the amplitudes is corrected for if it is not given.
    ///
    /// # Errors
    /// Fails as [`evaluate_budget`] does.
    pub fn gravity(
        &self,
        geometry: &GateGeometry,
        angle_scale: Option<f64>,
        clock: Option<f64>,
        damping: PeriodDamping,
        correlations: &[Correlation],
    ) -> Result<Option<Budget>, BudgetError> {
        let Some(t0) = self.t0_by_times else { return Ok(None) };
        let angle_scale = match self.t0_source {
            // The uncertainty by the width of the bob is part of T0's already.
            Some(T0Source::Speeds) => Some(0.0),
            _ => angle_scale,
        };
        let damping = match (damping, self.drag) {
            (PeriodDamping::Unknown, Some(drag)) => PeriodDamping::Observed(drag),
            (given, _) => given,
        };
        let period = MeasuredPeriod {
            model: self.contradiction.as_ref().map(|contradiction| contradiction.uncertainty() / t0.value),
            t0: Quantity { uncertainty: (!self.is_exact(t0)).then_some(t0.uncertainty), value: t0.value },
            amplitude: self.amplitude,
            angle_scale,
            clock,
            shared_timing: None,
            degrees_of_freedom: self.t0_degrees_of_freedom,
            damping,
        };
        let all = [correlations, &self.correlations(geometry)].concat();
        evaluate_budget(&geometry.apparatus, &period, &all).map(Some)
    }
}
