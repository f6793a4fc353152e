//! Warnings about the cycles of a trace.

use std::fmt;

use super::error::counted;
use crate::measurement::Observable;
use libration::quantity::{rounded, short};

/// A warning about the cycles of a trace.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CyclesWarning {
    /// Swings that go over the top, which are not cycles.
    OverTheTop {
        /// Number of swings.
        swings: usize,
    },
    /// Cycles without the time of a passage or an extreme: too few rows there, or an extreme below four standard
    /// deviations of the noise.
    Incomplete {
        /// Number of cycles.
        cycles: usize,
    },
    /// Cycles whose period is further from the law than [`outlier_threshold`](super::CyclesOptions::outlier_threshold) robust standard
    /// deviations.
    FarFromTheLaw {
        /// Number of cycles.
        cycles: usize,
    },
    /// The end of the trace, in which no swing can be distinguished from the noise.
    LostInNoise {
        /// Time in seconds after which the swing is lost.
        from: f64,
    },
    /// The centres of single swings differ by more than the noise explains, so that the centre is followed.
    CentreWanders {
        /// The standard deviation of the centres, in the unit of the observable.
        deviation: f64,
        /// The observable, which determines the unit.
        observable: Observable,
    },
}

impl CyclesWarning {
    /// A stable name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::OverTheTop { .. } => "cycles_over_the_top",
            Self::Incomplete { .. } => "cycles_incomplete",
            Self::FarFromTheLaw { .. } => "cycles_far_from_the_law",
            Self::LostInNoise { .. } => "cycles_lost_in_noise",
            Self::CentreWanders { .. } => "centre_wanders",
        }
    }
}

impl fmt::Display for CyclesWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::OverTheTop { swings } => {
                write!(f, "left out because they go over the top: {}", counted(swings, "swing"))
            }
            Self::Incomplete { cycles } => write!(
                f,
                "left out as incomplete (gaps, too few rows, or too faint): {}",
                counted(cycles, "cycle")
            ),
            Self::FarFromTheLaw { cycles } => {
                write!(f, "left out because the period is far from the law: {}", counted(cycles, "cycle"))
            }
            Self::LostInNoise { from } => write!(
                f,
                "from {} s on the swing is lost in the noise: the cycles are those before",
                short(from, 6)
            ),
            Self::CentreWanders { deviation, observable } => write!(
                f,
                "the centre of the swing wanders by {} (standard deviation), more than the noise explains; it was followed from \
                 swing to swing",
                match observable {
                    Observable::Angle => format!("{}°", rounded(deviation.to_degrees(), 2)),
                    Observable::AngularVelocity => format!("{} rad/s", rounded(deviation, 2)),
                }
            ),
        }
    }
}
