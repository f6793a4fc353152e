//! What a laboratory knows of its pendulum: sizes, masses, and the period it has found.

use libration::quantity::Quantity;

/// The density of air in a room, in kg/m³: 1.20 ± 0.02 from 15 to 25 °C at 1013 hPa and less.
pub const AIR_DENSITY: Quantity = Quantity { value: 1.20, uncertainty: Some(0.02) };

/// The pendulum: a ball on a rod or string. Lengths are metres, masses kilograms, densities kg/m³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apparatus {
    /// From the pivot to the centre of the bob.
    pub length: Quantity,
    /// Of the bob, a ball.
    pub bob_radius: Option<Quantity>,
    /// Of the bob.
    pub bob_mass: Option<Quantity>,
    /// Of the bob; by its mass and radius where it is not given.
    pub bob_density: Option<Quantity>,
    /// Of the rod or string, which is as thick everywhere.
    pub rod_mass: Option<Quantity>,
    /// From the pivot to its end; to the surface of the bob where it is not given.
    pub rod_length: Option<Quantity>,
    /// Of the air.
    pub air_density: Quantity,
    /// By how much the bob at rest stretches the string.
    pub stretch: Option<Quantity>,
}

impl Apparatus {
    /// A pendulum of which only the length is known.
    #[must_use]
    pub fn of_length(length: Quantity) -> Self {
        Self {
            length,
            bob_radius: None,
            bob_mass: None,
            bob_density: None,
            rod_mass: None,
            rod_length: None,
            air_density: AIR_DENSITY,
            stretch: None,
        }
    }
}

/// The period of small swings, and what was done to find it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredPeriod {
    /// T0, in seconds.
    pub t0: Quantity,
    /// The amplitude, in radians, whose T/T0 is the mean of those that were measured; they were corrected by the exact law.
    pub amplitude: Option<f64>,
    /// The relative standard uncertainty of all angles: 0.01 where a degree may be 0.99 or 1.01 of one.
    pub angle_scale: Option<f64>,
    /// The relative standard uncertainty of the clock or frame rate: 0.001 where 29.97 frames a second were taken for 30.
    pub clock: Option<f64>,
    /// The relative standard uncertainty of T0 by fits that contradict each other.
    pub model: Option<f64>,
    /// The degrees of freedom of the uncertainty of T0; infinite where that is taken as known.
    pub degrees_of_freedom: f64,
    /// What is known of the damping.
    pub damping: PeriodDamping,
}

/// What damping has to do with a period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PeriodDamping {
    /// Nothing is known of it.
    Unknown,
    /// T0 contains it: this is the coefficient of the linear one, in 1/s.
    Contained(Quantity),
    /// A fit of the damped motion gave T0, which contains none: the coefficient of the linear one, in 1/s, zero for other kinds.
    Fitted(f64),
}

impl MeasuredPeriod {
    /// T0 of which nothing else is known.
    #[must_use]
    pub fn of_small_swings(t0: Quantity) -> Self {
        Self {
            t0,
            amplitude: None,
            angle_scale: None,
            clock: None,
            model: None,
            degrees_of_freedom: f64::INFINITY,
            damping: PeriodDamping::Unknown,
        }
    }
}
