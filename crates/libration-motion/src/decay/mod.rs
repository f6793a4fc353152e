//! The decay of the amplitude of a damped pendulum, θ″ + Σ cₙ θ′|θ′|ⁿ⁻¹ + ω0² sin θ = 0: by integration from turning point to turning point, by
//! averaging with the exact energy loss per cycle at any amplitude, and by the law of small amplitudes.
//!
//! n = 0 is dry friction, n = 1 viscous damping, n = 2 the drag in a fast flow. Averaging replaces each cycle by
//! one of the undamped pendulum. It holds as long as a cycle removes a small part of the energy, and also of the
//! energy difference to the top, on which the period depends; its error falls with the square of the damping.
//! Next to the top it fails however weak the damping is, and for n < 1 also at the end of every motion.
//!
//! ```
//! # extern crate libration_motion as libration;
//! use libration::decay::{Damping, Decay, EnvelopeLaw};
//! use libration::pendulum::Pendulum;
//!
//! // A pendulum of one metre with viscous damping, released from 60°: the amplitude after each half swing, and the averaged law.
//! let pendulum = Pendulum::new(1.0, 9.80665)?;
//! let decay = Decay::new(pendulum, Damping::of_degree(1.0, 0.02)?, "60deg".parse()?)?;
//! for turning_point in decay.swings().take(10) {
//!     let turning_point = turning_point?;
//!     let averaged = decay.envelope(EnvelopeLaw::Averaged).amplitude_at(turning_point.time);
//!     assert!((turning_point.amplitude.radians() - averaged).abs() < 1e-4);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod damping;
mod kind;
mod cycle;
mod envelope;
mod turning;
mod ending;
#[doc(hidden)]
pub(crate) mod half_swing;
mod swings;

use cycle::Cycle;
use libration_numbers::quantity::Angle;
use libration_pendulum::pendulum::{Amplitude, Pendulum};

pub use cycle::{cycle_integral, small_cycle_integral};
pub use damping::{Damping, PowerLawTerm};
pub use ending::DecayEnding;
pub use envelope::{DecayEnvelope, EnvelopeLaw};
pub use error::DecayError;
pub use kind::DampingKind;
pub use swings::{Swings, TurningPoint};

/// A damped pendulum released from rest.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::decay::{Damping, Decay, EnvelopeLaw};
/// use libration::pendulum::Pendulum;
///
/// // Quadratic drag, ω0 = 1, released from 1 rad.
/// let pendulum = Pendulum::from_angular_frequency(1.0)?;
/// let decay = Decay::new(pendulum, Damping::of_degree(2.0, 0.1)?, "1rad".parse()?)?;
/// let fourth_return = decay.swings().nth(8).ok_or("it does not come back")??;
/// assert!((fourth_return.time - 25.925822606154).abs() < 1e-11);
/// assert!((fourth_return.amplitude.radians() - 0.475469880639).abs() < 1e-11);
/// assert!((decay.envelope(EnvelopeLaw::Averaged).amplitude_at(fourth_return.time) - 0.475444).abs() < 1e-6);
/// assert!((decay.envelope(EnvelopeLaw::SmallAmplitude).amplitude_at(fourth_return.time) - 0.476117).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Decay {
    pendulum: Pendulum,
    damping: Damping,
    /// The damping with 1/ω0 as the unit of time.
    scaled: Damping,
    start: Amplitude,
}

/// Smallest amplitude; lower ones count as zero.
const LEAST_AMPLITUDE: f64 = 1e-100;

impl Decay {
    /// The motion after release from rest at an angle of either sign.
    ///
    /// # Errors
    /// An angle at or beyond ±π, or below 1e-100 rad; a damping whose coefficients leave the range of numbers in units of the pendulum.
    pub fn new(pendulum: Pendulum, damping: Damping, start: Angle) -> Result<Self, DecayError> {
        let start = Amplitude::new(start)?;
        if start.radians() < LEAST_AMPLITUDE {
            return Err(DecayError::AtRest(start.radians()));
        }
        let scaled = damping.scaled(pendulum.angular_frequency())?;
        Ok(Self { pendulum, damping, scaled, start })
    }

    /// The pendulum.
    #[must_use]
    pub fn pendulum(&self) -> Pendulum {
        self.pendulum
    }

    /// The damping of the pendulum.
    #[must_use]
    pub fn damping(&self) -> &Damping {
        &self.damping
    }

    /// The terms of the damping with 1/ω0 as the unit of time.
    #[doc(hidden)]
    pub fn scaled_terms(&self) -> &[PowerLawTerm] {
        self.scaled.terms()
    }

    /// The amplitude of the release.
    #[must_use]
    pub fn start(&self) -> Amplitude {
        self.start
    }

    /// The fraction of its energy that the pendulum would lose in a cycle of the undamped motion. If it is not small, averaging does not hold.
    #[must_use]
    pub fn loss_in_a_cycle(&self, amplitude: &Amplitude) -> f64 {
        let modulus = amplitude.modulus().modulus();
        let cycle = Cycle::of_tangent(modulus / amplitude.modulus().complementary_modulus());
        0.5 * (cycle.loss(&self.scaled) / modulus) / modulus
    }

    /// The amplitude at or below which dry friction holds the pendulum at a turning point; it also holds it from π minus this amplitude on. Zero
    /// without dry friction, a right angle if friction holds everywhere.
    #[must_use]
    pub fn sticking_amplitude(&self) -> f64 {
        libm::asin(self.scaled.coefficient_of(0.0).min(1.0))
    }

    /// The amplitude as a function of time, by one of the laws.
    #[must_use]
    pub fn envelope(&self, law: EnvelopeLaw) -> DecayEnvelope<'_> {
        DecayEnvelope::new(self, law)
    }

    /// The consecutive turning points, by integration of the equation of motion; the first is the start.
    #[must_use]
    pub fn swings(&self) -> Swings<'_> {
        Swings::new(self)
    }
}
