//! The motion near the bottom, and the amplitude by the time for which the bob blocks the gate.
//!
//! In that time the bob goes an angle w between the two edges, and not with one speed. Without damping sin(θ/2) = sin(A/2)·sn(ω0t) at the time t
//! after the bottom, so that the angle between two times is known for any amplitude. A drag that takes the part q of the velocity in a second
//! multiplies this θ by e^(−qt/2), with a relative error of the order qt·θ²: a bob that comes to the gate before the bottom is faster there than
//! one of the same amplitude that comes after it. The middle of both times is zero for a gate at the centre; off it passages are
//! T/2 ± 2τ apart.

use libration::elliptic::Modulus;
use libration::roots::{Tolerance, zero_between};

/// The largest amplitude of the search, in radians: a period is 4.2 times as long there. With 3.0 and 3.141 no T0 of 86 records
/// changed by 1e-9.
const LARGEST: f64 = 3.13;

/// The motion of a pendulum near the bottom, which it passes at time zero; its amplitude is that of its speed there.
#[derive(Clone, Copy, Debug)]
pub struct NearBottom {
    /// The angular frequency of small swings, in rad/s.
    pub omega0: f64,
    /// The fraction of the velocity that is lost in a second.
    pub drag: f64,
}

impl NearBottom {
    /// The amplitude, in radians, of a pendulum that blocks a gate for this time with an angle of this width, with the middle of that time
    /// `from_bottom` seconds after the passage of the bottom; `None` where it goes over the top.
    pub fn amplitude(&self, width: f64, blocked: f64, from_bottom: f64) -> Option<f64> {
        let ends = [0.5, -0.5].map(|part| from_bottom + part * blocked);
        let excess = |amplitude: f64| {
            let [later, earlier] = ends.map(|time| self.angle_at(amplitude, time));
            later - earlier - width
        };
        let largest = excess(LARGEST);
        if largest.is_nan() || largest <= 0.0 {
            return None;
        }
        // In radians: far below what the resolution of a clock leaves.
        zero_between([(0.0, -width), (LARGEST, largest)], Tolerance::absolute(1e-13), excess)
    }

    /// The angle at a time.
    pub fn angle_at(&self, amplitude: f64, time: f64) -> f64 {
        let sine = libm::sin(0.5 * amplitude);
        let Ok(modulus) = Modulus::from_modulus(sine) else { return f64::NAN };
        2.0 * libm::asin(sine * modulus.jacobi(self.omega0 * time).sn) * libm::exp(-0.5 * self.drag * time)
    }

    /// The time at which it reaches an angle, or the turning point if the angle is beyond it.
    pub fn time_at(&self, amplitude: f64, angle: f64) -> Option<f64> {
        /// Each round is nearer by the part qt/2: with 4 and 16 no T0 of the tests changed by 1e-12.
        const ROUNDS: usize = 8;
        let modulus = Modulus::from_modulus(libm::sin(0.5 * amplitude)).ok()?;
        let without_drag = |time: f64| {
            let sine = libm::sin(0.5 * angle * libm::exp(0.5 * self.drag * time));
            modulus.incomplete_first(libm::asin((sine / modulus.modulus()).clamp(-1.0, 1.0))) / self.omega0
        };
        Some((0..ROUNDS).fold(0.0, |time, _| without_drag(time)))
    }
}

/// The mean of the squared velocity in a swing relative to that at the bottom: ∫cn² over a quarter period, (E − k′²K)/k²K.
pub(super) fn mean_squared_velocity(amplitude: f64) -> Option<f64> {
    let modulus = Modulus::from_modulus(libm::sin(0.5 * amplitude)).ok()?;
    let (first, complementary) = (modulus.first(), modulus.complementary_parameter());
    Some((modulus.second() - complementary * first) / (modulus.parameter() * first))
}
