//! Inputs from which g is computed.

use super::effects::Values;

/// An input of a budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BudgetInput {
    /// Distance from the pivot to the centre of the bob.
    Length,
    /// T0.
    Period,
    /// The slope of T²/4π² against the length.
    Slope,
    /// Factor by which all times are to be multiplied.
    Clock,
    /// Factor by which the times are to be multiplied because of the common error of all readings by hand.
    SharedTiming,
    /// Factor by which T0 is to be multiplied where the model is another.
    Model,
    /// Factor by which all angles are to be multiplied.
    AngleScale,
    /// Radius of the bob.
    BobRadius,
    /// Height or thickness of the bob.
    BobHeight,
    /// Radius of the hole of a ring.
    BobInnerRadius,
    /// Mass of the bob.
    BobMass,
    /// Density of the bob.
    BobDensity,
    /// Mass of the rod or string.
    RodMass,
    /// Distance from the pivot to the rod's end.
    RodLength,
    /// Density of the air.
    AirDensity,
    /// Factor by which the mass of the accelerated air is to be multiplied.
    AddedMass,
    /// Stretch of the string by the bob at rest.
    Stretch,
    /// The coefficient of linear damping.
    Damping,
    /// Coefficient of thermal expansion.
    Expansion,
    /// Difference of temperatures between the swings and the measurement of the length.
    Warming,
    /// Horizontal stiffness of the support.
    SupportStiffness,
    /// Radius of curvature of the knife edge.
    EdgeRadius,
    /// Difference of the distances of two knife edges from the centre of mass.
    CentreOfMass,
}

impl BudgetInput {
    /// All inputs.
    pub const ALL: [Self; 23] = [
        Self::Length,
        Self::Period,
        Self::Slope,
        Self::Clock,
        Self::SharedTiming,
        Self::Model,
        Self::AngleScale,
        Self::BobRadius,
        Self::BobHeight,
        Self::BobInnerRadius,
        Self::BobMass,
        Self::BobDensity,
        Self::RodMass,
        Self::RodLength,
        Self::AirDensity,
        Self::AddedMass,
        Self::Stretch,
        Self::Damping,
        Self::Expansion,
        Self::Warming,
        Self::SupportStiffness,
        Self::EdgeRadius,
        Self::CentreOfMass,
    ];

    /// Name of the input: `length`, `bob radius` and so on.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Length => "length",
            Self::Period => "period",
            Self::Slope => "slope",
            Self::Clock => "clock",
            Self::SharedTiming => "shared timing",
            Self::Model => "model",
            Self::AngleScale => "angle scale",
            Self::BobRadius => "bob radius",
            Self::BobHeight => "bob height",
            Self::BobInnerRadius => "bob inner radius",
            Self::BobMass => "bob mass",
            Self::BobDensity => "bob density",
            Self::RodMass => "rod mass",
            Self::RodLength => "rod length",
            Self::AirDensity => "air density",
            Self::AddedMass => "added mass",
            Self::Stretch => "stretch",
            Self::Damping => "damping",
            Self::Expansion => "expansion",
            Self::Warming => "warming",
            Self::SupportStiffness => "support stiffness",
            Self::EdgeRadius => "edge radius",
            Self::CentreOfMass => "centre of mass",
        }
    }

    /// Unit of the input's value; `1` for a factor.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Length
            | Self::BobRadius
            | Self::BobHeight
            | Self::BobInnerRadius
            | Self::RodLength
            | Self::Stretch
            | Self::EdgeRadius
            | Self::CentreOfMass => "m",
            Self::Period => "s",
            Self::Slope => "s^2/m",
            Self::Clock | Self::SharedTiming | Self::Model | Self::AngleScale | Self::AddedMass => "1",
            Self::BobMass | Self::RodMass => "kg",
            Self::BobDensity | Self::AirDensity => "kg/m^3",
            Self::Damping => "1/s",
            Self::Expansion => "1/K",
            Self::Warming => "K",
            Self::SupportStiffness => "N/m",
        }
    }

    /// Unit of ∂g/∂x.
    #[must_use]
    pub fn unit_of_sensitivity(self) -> &'static str {
        match self {
            Self::Length
            | Self::BobRadius
            | Self::BobHeight
            | Self::BobInnerRadius
            | Self::RodLength
            | Self::Stretch
            | Self::EdgeRadius
            | Self::CentreOfMass => "1/s^2",
            Self::Period => "m/s^3",
            Self::Slope => "m^2/s^4",
            Self::Clock | Self::SharedTiming | Self::Model | Self::AngleScale | Self::AddedMass => "m/s^2",
            Self::BobMass | Self::RodMass => "m/(s^2 kg)",
            Self::BobDensity | Self::AirDensity => "m^4/(s^2 kg)",
            Self::Damping => "m/s",
            Self::Expansion => "m K/s^2",
            Self::Warming => "m/(s^2 K)",
            Self::SupportStiffness => "m^2/(s^2 N)",
        }
    }

    /// Slot of the input among the values; `None` for inputs of tables of lengths.
    pub(super) fn slot(self, values: &mut Values) -> Option<&mut f64> {
        match self {
            Self::Length => Some(&mut values.length),
            Self::Period => Some(&mut values.t0),
            Self::Slope | Self::CentreOfMass => None,
            Self::Clock => Some(&mut values.clock),
            Self::SharedTiming => Some(&mut values.shared_timing),
            Self::Model => Some(&mut values.model),
            Self::AngleScale => Some(&mut values.angle_scale),
            Self::BobRadius => Some(&mut values.bob.radius),
            Self::BobHeight => Some(&mut values.bob.height),
            Self::BobInnerRadius => Some(&mut values.bob.inner),
            Self::BobMass => Some(&mut values.bob_mass),
            Self::BobDensity => Some(&mut values.bob_density),
            Self::RodMass => Some(&mut values.rod_mass),
            Self::RodLength => Some(&mut values.rod_length),
            Self::AirDensity => Some(&mut values.air_density),
            Self::AddedMass => Some(&mut values.added_mass),
            Self::Stretch => Some(&mut values.stretch),
            Self::Damping => Some(&mut values.damping),
            Self::Expansion => Some(&mut values.expansion),
            Self::Warming => Some(&mut values.warming),
            Self::SupportStiffness => Some(&mut values.stiffness),
            Self::EdgeRadius => Some(&mut values.edge_radius),
        }
    }
}
