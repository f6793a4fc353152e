//! Pendulums and motions as a line of text.

use std::fmt;

use super::{Motion, Pendulum, Size};
use libration_numbers::quantity::rounded;

/// Displays the quantities by which the pendulum was given.
///
/// # Examples
/// ```
/// # extern crate libration_pendulum as libration;
/// use libration::pendulum::Pendulum;
/// assert_eq!(Pendulum::new(0.994, 9.81)?.to_string(), "pendulum of 0.994 m at 9.81 m/s²");
/// assert_eq!(Pendulum::from_angular_frequency(2.5)?.to_string(), "pendulum of ω0 = 2.5 rad/s");
/// # Ok::<(), libration::pendulum::PendulumError>(())
/// ```
impl fmt::Display for Pendulum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.size {
            Size::LengthAndGravity { length, gravity } => {
                write!(f, "pendulum of {length} m at {gravity} m/s²")
            }
            Size::AngularFrequency(omega0) => write!(f, "pendulum of ω0 = {omega0} rad/s"),
        }
    }
}

/// Displays the regime, with the amplitude in radians and the period to twelve digits if they exist.
///
/// # Examples
/// ```
/// # extern crate libration_pendulum as libration;
/// use libration::pendulum::Pendulum;
/// let pendulum = Pendulum::new(1.0, 9.80665)?;
/// let swing = pendulum.released_from("pi-1e-6".parse()?)?;
/// assert_eq!(swing.to_string(), "libration: amplitude pi-1e-6 rad, period 20.3029374681 s");
/// assert_eq!(pendulum.launched("0rad".parse()?, 7.0)?.to_string(), "rotation: period 1.29053742379 s");
/// assert_eq!(pendulum.on_separatrix().to_string(), "separatrix");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
impl fmt::Display for Motion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let regime = self.regime();
        let period = rounded(self.period(), 12);
        match self {
            Self::Libration(swing) => {
                write!(f, "{regime}: amplitude {} rad, period {period} s", swing.amplitude().angle())
            }
            Self::Rotation(_) => write!(f, "{regime}: period {period} s"),
            Self::Rest(_) | Self::Separatrix(_) => write!(f, "{regime}"),
        }
    }
}
