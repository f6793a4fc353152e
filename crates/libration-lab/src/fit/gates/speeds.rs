//! The amplitude by the time for which the bob blocks the gate.
//!
//! In that time the bob goes an angle w between the two edges, and not with one speed. Without damping sin(θ/2) = sin(A/2)·sn(ω0t) at the time t
//! after the bottom, so that the angle between two times is known for any amplitude. The middle of both is zero for a gate at the centre; off
//! it passages are T/2 ± 2τ apart.

use libration::elliptic::Modulus;
use libration::roots::{Tolerance, bisect};

/// The largest amplitude of the search, in radians: a period is 4.2 times as long there. With 3.0 and 3.141 no T0 of 86 records
/// changed by 1e-9.
const LARGEST: f64 = 3.13;

/// The amplitude, in radians, of a pendulum of this ω0 that blocks a gate for this time with an angle of this width, with the middle of that time
/// `from_bottom` seconds from the passage of the bottom; `None` where it goes over the top.
pub fn amplitude(omega0: f64, width: f64, blocked: f64, from_bottom: f64) -> Option<f64> {
    let half = 0.5 * blocked;
    let between = |amplitude: f64| {
        let sine = libm::sin(0.5 * amplitude);
        let Ok(modulus) = Modulus::from_modulus(sine) else { return f64::NAN };
        let angle = |time: f64| 2.0 * libm::asin(sine * modulus.jacobi(omega0 * time).sn);
        angle(from_bottom + half) - angle(from_bottom - half)
    };
    if width.is_nan() || width >= between(LARGEST) {
        return None;
    }
    let [amplitude, _] = bisect([0.0, LARGEST], Tolerance::absolute(1e-12), |it| between(it) < width);
    Some(amplitude)
}
