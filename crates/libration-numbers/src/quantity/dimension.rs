//! Dimensions of quantities.

use std::fmt;

/// Dimension of a quantity, which also determines the SI unit of its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Dimension {
    /// Length, in metres.
    Length,
    /// Time, in seconds.
    Time,
    /// Acceleration, in metres per second squared.
    Acceleration,
    /// Angle, in radians.
    Angle,
    /// Angular velocity, in radians per second.
    AngularVelocity,
    /// Velocity, in metres per second.
    Velocity,
    /// Mass, in kilograms.
    Mass,
    /// Density, in kilograms per cubic metre.
    Density,
    /// Rate, in one per second.
    Rate,
    /// Stiffness, in newtons per metre.
    Stiffness,
    /// Difference of temperatures, in kelvins.
    TemperatureDifference,
    /// Coefficient of thermal expansion, in one per kelvin.
    Expansion,
    /// Number without a unit.
    Number,
}

impl Dimension {
    /// Examples of how to write a quantity of this dimension.
    #[must_use]
    pub fn examples(self) -> &'static str {
        match self {
            Self::Length => "1m, 120 cm, 35 in, 1.200(3) m or 1.200 ± 0.003 m (a bare number is in metres)",
            Self::Time => "2s, 500ms, 2.007(2) s or 2.007 ± 0.002 s (a bare number is in seconds)",
            Self::Acceleration => "9.81m/s^2, 981 cm/s^2 or 9.81 ± 0.02 m/s^2 (a bare number is in m/s^2)",
            Self::Angle => "0.3rad, 17deg or 17.0(5) deg (a bare number is in radians)",
            Self::AngularVelocity => "0.3rad/s, 30deg/s or 33 rpm (a bare number is in rad/s)",
            Self::Velocity => "0.3m/s, 20 cm/s or 5 km/h (a bare number is in m/s)",
            Self::Mass => "31g, 2.032 kg or 42.0 ± 0.5 g (a bare number is in kilograms)",
            Self::Density => "7850kg/m^3, 7.85 g/cm^3 or 1.20(2) kg/m^3 (a bare number is in kg/m^3)",
            Self::Rate => "0.03/s, 0.030(1)/s or 0.030 ± 0.001 1/s (a bare number is in 1/s)",
            Self::Stiffness => "2e4N/m, 20 N/mm or 2.0(2)e4 N/m (a bare number is in N/m)",
            Self::TemperatureDifference => "3K, -1.5K or 3.0 ± 0.5 K (a bare number is in kelvins)",
            Self::Expansion => "1.2e-5/K, 12 ppm/K or 1.2(1)e-5/K (a bare number is in 1/K)",
            Self::Number => "1.07, 1.070(2), 1.070 ± 0.002 or 7%",
        }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Length => "a length",
            Self::Time => "a time",
            Self::Acceleration => "an acceleration",
            Self::Angle => "an angle",
            Self::AngularVelocity => "an angular velocity",
            Self::Velocity => "a velocity",
            Self::Mass => "a mass",
            Self::Density => "a density",
            Self::Rate => "a rate",
            Self::Stiffness => "a stiffness",
            Self::TemperatureDifference => "a difference of temperatures",
            Self::Expansion => "a coefficient of expansion",
            Self::Number => "a number",
        })
    }
}
