//! g by the times of a gate: the angular width of the bob, and what T0 has in common with the sizes that it is made of.

use super::{GatesFit, T0Source};
use crate::fit::budget::{
    Apparatus, Budget, BudgetError, BudgetInput, Correlation, MeasuredPeriod, PeriodDamping, budget,
};
use libration::quantity::Quantity;

/// The pendulum beside its gate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GateGeometry {
    apparatus: Apparatus,
    diameter: Option<Quantity>,
    distance: Option<Quantity>,
}

/// Why a pendulum cannot stand beside its gate like this.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GateGeometryError {
    /// What blocks the gate reaches to the pivot.
    #[error(
        "a bob or flag of diameter {diameter:?} m that passes a gate {distance:?} m from the pivot would reach the pivot: check the \
         two lengths and their units"
    )]
    ReachesPivot {
        /// Of what blocks the gate, in m.
        diameter: f64,
        /// Of the gate from the pivot, in m.
        distance: f64,
    },
    /// A bob that does not reach the gate, and nothing else that would block it.
    #[error(
        "a bob of radius {radius:?} m and {length:?} m from the pivot does not pass a gate {distance:?} m from the pivot: check the \
         distance of the gate, or give the diameter of the flag that blocks it"
    )]
    BobMissesGate {
        /// Of the bob, in m.
        radius: f64,
        /// From the pivot to its centre, in m.
        length: f64,
        /// Of the gate from the pivot, in m.
        distance: f64,
    },
}

impl GateGeometry {
    /// A pendulum beside its gate: the diameter of what blocks the gate, in m, is twice the radius of the bob where it is not given,
    /// and the distance of the gate from the pivot, in m, the length of the pendulum.
    ///
    /// # Errors
    /// What blocks the gate reaches to the pivot, or the bob does not reach the gate.
    pub fn new(
        apparatus: Apparatus,
        diameter: Option<Quantity>,
        distance: Option<Quantity>,
    ) -> Result<Self, GateGeometryError> {
        let geometry = Self { apparatus, diameter, distance };
        let length = apparatus.length.value;
        let at_gate = geometry.distance().value;
        if let Some(diameter) = geometry.diameter().map(|diameter| diameter.value)
            && 0.5 * diameter >= at_gate
        {
            return Err(GateGeometryError::ReachesPivot { diameter, distance: at_gate });
        }
        if let (Some(radius), None) = (apparatus.bob_radius.map(|radius| radius.value), diameter)
            && (at_gate - length).abs() >= radius
        {
            return Err(GateGeometryError::BobMissesGate { radius, length, distance: at_gate });
        }
        Ok(geometry)
    }

    fn diameter(&self) -> Option<Quantity> {
        let twice = |radius: Quantity| Quantity {
            value: 2.0 * radius.value,
            uncertainty: radius.uncertainty.map(|spread| 2.0 * spread),
        };
        self.diameter.or_else(|| self.apparatus.bob_radius.map(twice))
    }

    fn distance(&self) -> Quantity {
        self.distance.unwrap_or(self.apparatus.length)
    }

    /// The angle that the bob goes while it blocks the gate, in radians; none where neither diameter nor radius is known.
    #[must_use]
    pub fn width(&self) -> Option<Quantity> {
        let (diameter, distance) = (self.diameter()?, self.distance());
        let value = diameter.value / distance.value;
        let uncertainty = Some(value * libm::hypot(relative(diameter), relative(distance)));
        Some(Quantity { value, uncertainty })
    }

    /// By which part the width changes with one standard uncertainty of length and radius, where it is made of these.
    fn changes_of_width(&self) -> impl Iterator<Item = (BudgetInput, f64)> {
        let length = self.distance.is_none().then(|| -relative(self.apparatus.length));
        let radius = self.apparatus.bob_radius.filter(|_| self.diameter.is_none()).map(relative);
        let changes = [(BudgetInput::Length, length), (BudgetInput::BobRadius, radius)];
        changes.into_iter().filter_map(|(input, part)| Some((input, part.filter(|part| *part != 0.0)?)))
    }
}

fn relative(quantity: Quantity) -> f64 {
    quantity.uncertainty.unwrap_or(0.0) / quantity.value
}

impl GatesFit {
    /// The correlation of T0 with a size one standard uncertainty of which changes the angular width by this, in radians; none
    /// where T0 does not come from the width.
    #[must_use]
    pub fn correlation_by_width(&self, change: f64) -> Option<f64> {
        let spread = Some(self.t0?.uncertainty).filter(|spread| *spread > 0.0)?;
        Some((self.t0_by_width? * change / spread).clamp(-1.0, 1.0))
    }

    /// What T0 has in common with the sizes that the width comes from.
    #[must_use]
    pub fn correlations(&self, geometry: &GateGeometry) -> Vec<Correlation> {
        let Some(width) = geometry.width() else { return vec![] };
        let correlation = |(input, part): (BudgetInput, f64)| {
            let coefficient = self.correlation_by_width(width.value * part)?;
            Some(Correlation { between: [input, BudgetInput::Period], coefficient })
        };
        geometry.changes_of_width().filter_map(correlation).collect()
    }

    /// g with its budget; none without T0. The relative uncertainties of all angles and of the clock are of the amplitude that was
    /// given and of all times.
    ///
    /// # Errors
    /// As [`budget`].
    pub fn gravity(
        &self,
        geometry: &GateGeometry,
        angle_scale: Option<f64>,
        clock: Option<f64>,
        damping: PeriodDamping,
        correlations: &[Correlation],
    ) -> Result<Option<Budget>, BudgetError> {
        let Some(t0) = self.t0 else { return Ok(None) };
        let angle_scale = match self.t0_source {
            // What the width of the bob is worth is part of T0 already.
            Some(T0Source::Speeds) => Some(0.0),
            _ => angle_scale,
        };
        let period = MeasuredPeriod {
            t0: t0.into(),
            amplitude: self.amplitude,
            angle_scale,
            clock,
            degrees_of_freedom: self.t0_degrees_of_freedom,
            damping,
        };
        let all = [correlations, &self.correlations(geometry)].concat();
        budget(&geometry.apparatus, &period, &all).map(Some)
    }
}
