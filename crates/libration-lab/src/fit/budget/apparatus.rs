//! Known properties of a laboratory's pendulum: sizes, masses, and the measured period.

use super::bob::Bob;
use libration::quantity::Quantity;

/// The density of air in a room, in kg/m³: 1.20 ± 0.02 from 15 to 25 °C at 1013 hPa and less.
pub const AIR_DENSITY: Quantity = Quantity { value: 1.20, uncertainty: Some(0.02) };

/// The pendulum: a bob on a rod or string. Lengths are metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apparatus {
    /// Distance from the pivot to the centre of the bob.
    pub length: Quantity,
    /// All other corrections of g.
    pub corrections: Corrections,
}

/// Known properties of a pendulum besides its length, each of which corrects g. Lengths are metres, masses kilograms, densities kg/m³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corrections {
    /// Shape and size of the bob.
    pub bob: Option<Bob>,
    /// Mass of the bob.
    pub bob_mass: Option<Quantity>,
    /// Density of the bob; computed from its mass and size where it is not given.
    pub bob_density: Option<Quantity>,
    /// Mass of the rod or string, whose thickness is uniform.
    pub rod_mass: Option<Quantity>,
    /// Distance from the pivot to the rod's end; to the surface of the bob where it is not given.
    pub rod_length: Option<Quantity>,
    /// Density of the air.
    pub air_density: Quantity,
    /// Length by which the bob at rest stretches the string.
    pub stretch: Option<Quantity>,
    /// Coefficient of thermal expansion of the pendulum, in 1/K.
    pub expansion: Option<Quantity>,
    /// Difference of the temperatures of the pendulum, in K: during the swings less that at which the length was measured.
    pub warming: Option<Quantity>,
    /// Horizontal stiffness of the support, in N/m.
    pub support_stiffness: Option<Quantity>,
    /// Radius of curvature of the knife edge or rounded pivot on which the pendulum rolls.
    pub edge_radius: Option<Quantity>,
}

impl Default for Corrections {
    /// No correction except for air in a room, for bobs with a given density.
    fn default() -> Self {
        Self {
            bob: None,
            bob_mass: None,
            bob_density: None,
            rod_mass: None,
            rod_length: None,
            air_density: AIR_DENSITY,
            stretch: None,
            expansion: None,
            warming: None,
            support_stiffness: None,
            edge_radius: None,
        }
    }
}

impl Apparatus {
    /// A pendulum of which only the length is known.
    #[must_use]
    pub fn of_length(length: Quantity) -> Self {
        Self { length, corrections: Corrections::default() }
    }
}

/// The period of small swings, and the method by which it was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredPeriod {
    /// T0, in seconds.
    pub t0: Quantity,
    /// The amplitude, in radians, whose T/T0 is the mean of those measured, which were corrected by the exact law.
    pub amplitude: Option<f64>,
    /// The relative standard uncertainty of all angles: 0.01 where a degree may be 0.99 or 1.01 of one.
    pub angle_scale: Option<f64>,
    /// The relative standard uncertainty of the clock or frame rate: 0.001 where 29.97 frames a second were taken for 30.
    pub clock: Option<f64>,
    /// The relative standard uncertainty of T0 by the common error of all readings by hand, such as that of an observer who stops late.
    pub shared_timing: Option<f64>,
    /// The relative standard uncertainty of T0 by fits that contradict each other.
    pub model: Option<f64>,
    /// The degrees of freedom of the uncertainty of T0; infinite where that is taken as known.
    pub degrees_of_freedom: f64,
    /// Known damping.
    pub damping: PeriodDamping,
}

/// Relation of the damping to a period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PeriodDamping {
    /// The damping is unknown.
    Unknown,
    /// T0 contains the effect of linear damping with this coefficient, in 1/s.
    Contained(Quantity),
    /// T0 contains the effect of damping of an unknown kind, by which the amplitudes fall as by linear damping with this coefficient, in 1/s.
    Observed(f64),
    /// A fit of the damped motion gave T0, which excludes damping: the coefficient of linear damping, in 1/s, zero for other kinds.
    Fitted(f64),
}

impl MeasuredPeriod {
    /// Returns T0 alone, with nothing else known.
    #[must_use]
    pub fn of_small_swings(t0: Quantity) -> Self {
        Self {
            t0,
            amplitude: None,
            angle_scale: None,
            clock: None,
            shared_timing: None,
            model: None,
            degrees_of_freedom: f64::INFINITY,
            damping: PeriodDamping::Unknown,
        }
    }
}
