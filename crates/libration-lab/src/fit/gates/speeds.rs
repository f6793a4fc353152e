//! The amplitude by the time for which the bob blocks the gate.
//!
//! In that time the bob goes an angle w, so that θ′ = w/Δt at the gate. A pendulum that passes the gate a time τ after the
//! bottom has θ′ = 2ω0 sin(A/2) cn(ω0τ): τ is zero at the centre, and off it the passages are T/2 ± 2τ apart.

use libration::elliptic::Modulus;
use libration::roots::{Tolerance, bisect};

/// The largest amplitude that is looked for, in radians: a period is 4.2 times as long there. With 3.0 and 3.141 no T0 of 86 records
/// changed by 1e-9.
const LARGEST: f64 = 3.13;

/// The amplitude, in radians, of a pendulum of this ω0 that blocks a gate for this time with an angle of this width, so long
/// from the bottom; none where it goes over the top.
pub fn amplitude(omega0: f64, width: f64, blocked: f64, from_bottom: f64) -> Option<f64> {
    let wanted = 0.5 * width / (blocked * omega0);
    let speed = |amplitude: f64| {
        let sine = libm::sin(0.5 * amplitude);
        Modulus::from_modulus(sine).map_or(f64::NAN, |modulus| sine * modulus.jacobi(omega0 * from_bottom).cn)
    };
    if wanted.is_nan() || wanted >= speed(LARGEST) {
        return None;
    }
    let [amplitude, _] = bisect([0.0, LARGEST], Tolerance::absolute(1e-12), |it| speed(it) < wanted);
    Some(amplitude)
}
