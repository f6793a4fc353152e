//! The apparatus: lengths and masses of the pendulum with their uncertainties.

use super::{PlaceOptions, bob, correlation, text};
use crate::query_error::{QueryError, option};
use libration::quantity::Quantity;
use libration_lab::fit::{AIR_DENSITY, Apparatus, Bob, Corrections, Correlation, PeriodDamping, Uncertain};

/// The options that give g and the budget of its uncertainty.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Apparatus, for gravity and the budget of its uncertainty")]
pub(crate) struct ApparatusOptions {
    /// Distance from the pivot to the centre of the bob, with its uncertainty, such as 0.57m±0.004m, or "0.57m±5mm rectangular" for a half-width: gives gravity
    #[arg(long, value_name = "LENGTH", value_parser = text::length_with_uncertainty)]
    length: Option<Quantity>,
    #[command(flatten)]
    corrections: CorrectionOptions,
    /// Relative uncertainty of the scale of all angles, such as 0.01 or 1%
    #[arg(long, value_name = "PART", value_parser = text::part, requires = "length")]
    angle_scale: Option<f64>,
    /// Relative uncertainty of the clock or frame rate, such as 0.1% if 29.97 frames/s may have been taken as 30
    #[arg(long, value_name = "PART", value_parser = text::part, requires = "length")]
    clock: Option<f64>,
    /// Correlation coefficient of two inputs, such as length,bob-radius=0.9
    #[arg(long, value_name = "NAME,NAME=R", value_parser = correlation::correlation, requires = "length", allow_hyphen_values = true)]
    correlation: Vec<Correlation>,
    #[command(flatten)]
    place: PlaceOptions,
}

/// The options of the corrections of g, which all fits share.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Apparatus, for gravity and the budget of its uncertainty")]
pub(crate) struct CorrectionOptions {
    /// Radius of the bob, a ball, such as 20.0(1)mm
    #[arg(long, value_name = "LENGTH", value_parser = text::length_with_uncertainty)]
    bob_radius: Option<Quantity>,
    /// A bob that is not a ball: disc:radius=5cm,thickness=1cm (swings in its plane), cylinder:radius=2cm,height=5cm (along the rod), ring:radius=5cm,inner=3cm, cap:radius=5cm,height=3cm (of a ball), or gyration:radius=2cm, the root of its moment of inertia over its mass
    #[arg(long, value_name = "SHAPE:LENGTHS", value_parser = bob::bob, conflicts_with = "bob_radius")]
    bob: Option<Bob>,
    /// Mass of the bob, or of a bar, such as 42.0g±0.5g
    #[arg(long, value_name = "MASS", value_parser = text::mass_with_uncertainty)]
    bob_mass: Option<Quantity>,
    /// Density of the bob, or of a bar, such as 7.85g/cm^3 [default: by its mass and size]
    #[arg(long, value_name = "DENSITY", value_parser = text::density_with_uncertainty)]
    bob_density: Option<Quantity>,
    /// Mass of the rod or string
    #[arg(long, value_name = "MASS", value_parser = text::mass_with_uncertainty, requires = "bob_mass")]
    rod_mass: Option<Quantity>,
    /// Distance from the pivot to the end of the rod [default: to the surface of the bob]
    #[arg(long, value_name = "LENGTH", value_parser = text::length_with_uncertainty, requires = "rod_mass")]
    rod_length: Option<Quantity>,
    /// Density of the air [default: 1.20(2)kg/m^3]
    #[arg(long, value_name = "DENSITY", value_parser = text::density_with_uncertainty)]
    air_density: Option<Quantity>,
    /// Stretch of the string under the hanging bob
    #[arg(long, value_name = "LENGTH", value_parser = text::length_with_uncertainty)]
    stretch: Option<Quantity>,
    /// Coefficient of thermal expansion of the pendulum, such as 12(1)e-6/K for steel
    #[arg(long, value_name = "EXPANSION", value_parser = text::expansion_with_uncertainty, requires = "warmer")]
    expansion: Option<Quantity>,
    /// Temperature of the pendulum during the swings minus that during the measurement of its length, such as 3K±1K, or -3K if it was
    /// colder
    #[arg(long, value_name = "KELVINS", value_parser = text::temperature_difference, requires = "expansion", allow_hyphen_values = true)]
    warmer: Option<Quantity>,
    /// Horizontal stiffness of the support, such as 20(2)N/mm: with the mass of the bob, L is longer by m g/K
    #[arg(long, value_name = "STIFFNESS", value_parser = text::stiffness_with_uncertainty, requires = "bob_mass")]
    support_stiffness: Option<Quantity>,
    /// Radius of curvature of a knife edge or rounded pivot that rolls: L is shorter by it
    #[arg(long, value_name = "LENGTH", value_parser = text::length_with_uncertainty)]
    edge_radius: Option<Quantity>,
}

impl CorrectionOptions {
    /// The corrections that were given.
    pub(crate) fn corrections(&self) -> Corrections {
        Corrections {
            bob: self.bob.or_else(|| self.bob_radius.map(Bob::ball)),
            bob_mass: self.bob_mass,
            bob_density: self.bob_density,
            rod_mass: self.rod_mass,
            rod_length: self.rod_length,
            air_density: self.air_density.unwrap_or(AIR_DENSITY),
            stretch: self.stretch,
            expansion: self.expansion,
            warming: self.warmer,
            support_stiffness: self.support_stiffness,
            edge_radius: self.edge_radius,
        }
    }

    /// The first option of a bob or string, which a bar does not have.
    pub(crate) fn of_string(&self) -> Option<&'static str> {
        let given = [
            ("bob-radius", self.bob_radius.is_some()),
            ("bob", self.bob.is_some()),
            ("rod-mass", self.rod_mass.is_some()),
            ("stretch", self.stretch.is_some()),
        ];
        given.into_iter().find_map(|(name, is_given)| is_given.then_some(name))
    }

    /// The first option that was given.
    fn first(&self) -> Option<&'static str> {
        let given = [
            ("bob-mass", self.bob_mass.is_some()),
            ("bob-density", self.bob_density.is_some()),
            ("air-density", self.air_density.is_some()),
            ("expansion", self.expansion.is_some()),
            ("edge-radius", self.edge_radius.is_some()),
        ];
        self.of_string().or_else(|| given.into_iter().find_map(|(name, is_given)| is_given.then_some(name)))
    }
}

/// The damping of a period that contains it.
#[derive(Clone, Copy, Debug, clap::Args)]
#[command(next_help_heading = "Apparatus, for gravity and the budget of its uncertainty")]
pub(crate) struct LinearDampingOption {
    /// Coefficient of linear damping, such as 0.030(1)/s: the amplitude falls as exp(-b t/2) [default: not corrected]
    #[arg(long, alias = "linear-damping", value_name = "RATE", value_parser = text::rate_with_uncertainty, requires = "length")]
    linear: Option<Quantity>,
}

impl LinearDampingOption {
    pub(crate) fn damping(self) -> PeriodDamping {
        self.linear.map_or(PeriodDamping::Unknown, PeriodDamping::Contained)
    }
}

impl ApparatusOptions {
    /// The length; `None` if gravity is not requested.
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

    /// The apparatus; `None` without a length, without which gravity is not determined.
    ///
    /// # Errors
    /// Fails for a correction of gravity without the length.
    pub(crate) fn apparatus(&self) -> Result<Option<Apparatus>, QueryError> {
        let corrections = self.corrections.corrections();
        match (self.length, self.corrections.first()) {
            (Some(length), _) => Ok(Some(Apparatus { length, corrections })),
            (None, None) => Ok(None),
            (None, Some(name)) => {
                Err(QueryError::usage(option(name), "it corrects gravity, which needs <--length>"))
            }
        }
    }

    /// Normal gravity at the place of measurement; `None` without a latitude.
    ///
    /// # Errors
    /// Fails for a place that is not on the Earth, and without the length.
    pub(crate) fn normal_gravity(&self) -> Result<Option<Uncertain>, QueryError> {
        let normal = self.place.normal_gravity()?;
        match (normal, self.length) {
            (Some(_), None) => Err(QueryError::usage(
                option("latitude"),
                "gravity is compared there, which needs <--length>",
            )),
            _ => Ok(normal),
        }
    }
}
