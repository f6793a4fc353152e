//! The pendulum as a laboratory knows it: lengths and masses with their uncertainties.

use super::{correlation, text};
use libration::quantity::Quantity;
use libration_lab::fit::{AIR_DENSITY, Apparatus, Correlation, PeriodDamping};

/// The options that give g and the budget of its uncertainty.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Apparatus, for gravity and the budget of its uncertainty")]
pub(crate) struct ApparatusOptions {
    /// Distance from the pivot to the centre of the bob, with its uncertainty, such as 0.57m±0.004m: gives gravity
    #[arg(long, value_name = "LENGTH", value_parser = text::length_with_uncertainty)]
    length: Option<Quantity>,
    /// Radius of the bob, a sphere, such as 20.0(1)mm
    #[arg(long, value_name = "LENGTH", value_parser = text::length_with_uncertainty, requires = "length")]
    bob_radius: Option<Quantity>,
    /// Mass of the bob, such as 42.0g±0.5g
    #[arg(long, value_name = "MASS", value_parser = text::mass_with_uncertainty, requires = "length")]
    bob_mass: Option<Quantity>,
    /// Density of the bob, such as 7.85g/cm^3 [default: by its mass and radius]
    #[arg(long, value_name = "DENSITY", value_parser = text::density_with_uncertainty, requires = "length")]
    bob_density: Option<Quantity>,
    /// Mass of the rod or string
    #[arg(long, value_name = "MASS", value_parser = text::mass_with_uncertainty, requires = "bob_mass")]
    rod_mass: Option<Quantity>,
    /// Distance from the pivot to the end of the rod [default: to the surface of the bob]
    #[arg(long, value_name = "LENGTH", value_parser = text::length_with_uncertainty, requires = "rod_mass")]
    rod_length: Option<Quantity>,
    /// Density of the air [default: 1.20(2)kg/m^3]
    #[arg(long, value_name = "DENSITY", value_parser = text::density_with_uncertainty, requires = "length")]
    air_density: Option<Quantity>,
    /// Stretch of the string under the hanging bob
    #[arg(long, value_name = "LENGTH", value_parser = text::length_with_uncertainty, requires = "length")]
    stretch: Option<Quantity>,
    /// Relative uncertainty of the scale of all angles, such as 0.01 or 1%
    #[arg(long, value_name = "PART", value_parser = text::part, requires = "length")]
    angle_scale: Option<f64>,
    /// Relative uncertainty of the clock or frame rate, such as 0.1% where 29.97 frames/s may have been taken for 30
    #[arg(long, value_name = "PART", value_parser = text::part, requires = "length")]
    clock: Option<f64>,
    /// Correlation coefficient of two inputs, such as length,bob-radius=0.9
    #[arg(long, value_name = "NAME,NAME=R", value_parser = correlation::correlation, requires = "length", allow_hyphen_values = true)]
    correlation: Vec<Correlation>,
}

/// The damping of a period that contains it.
#[derive(Clone, Copy, Debug, clap::Args)]
#[command(next_help_heading = "Apparatus, for gravity and the budget of its uncertainty")]
pub(crate) struct DampingOptions {
    /// Coefficient of linear damping, such as 0.030(1)/s: the amplitude falls as exp(-b t/2) [default: not corrected]
    #[arg(long, alias = "linear-damping", value_name = "RATE", value_parser = text::rate_with_uncertainty, requires = "length")]
    linear: Option<Quantity>,
}

impl DampingOptions {
    pub(crate) fn damping(self) -> PeriodDamping {
        self.linear.map_or(PeriodDamping::Unknown, PeriodDamping::Contained)
    }
}

impl ApparatusOptions {
    /// The length; none when gravity is not requested.
    pub(crate) fn length(&self) -> Option<Quantity> {
        self.length
    }

    /// The relative uncertainty of the angles.
    pub(crate) fn angle_scale(&self) -> Option<f64> {
        self.angle_scale
    }

    /// The relative uncertainty of the clock.
    pub(crate) fn clock(&self) -> Option<f64> {
        self.clock
    }

    /// The correlations that were given.
    pub(crate) fn correlations(&self) -> &[Correlation] {
        &self.correlation
    }

    /// The apparatus; none when no length is given, without which there is no gravity.
    pub(crate) fn apparatus(&self) -> Option<Apparatus> {
        Some(Apparatus {
            length: self.length?,
            bob_radius: self.bob_radius,
            bob_mass: self.bob_mass,
            bob_density: self.bob_density,
            rod_mass: self.rod_mass,
            rod_length: self.rod_length,
            air_density: self.air_density.unwrap_or(AIR_DENSITY),
            stretch: self.stretch,
        })
    }
}
