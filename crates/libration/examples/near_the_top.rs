//! A pendulum released at rest 1e-12 rad from the upright position: the duration near the top, and the fall.
//!
//!     cargo run --release -p libration --example near_the_top
#![expect(clippy::print_stdout, reason = "an example shows its answer")]

use libration::pendulum::{Motion, Pendulum};
use libration::quantity::Angle;
use std::error::Error;
use std::f64::consts::PI;

fn main() -> Result<(), Box<dyn Error>> {
    let pendulum = Pendulum::new(1.0, 9.80665)?;
    let motion = pendulum.released_from(Angle::from_complement(1e-12)?)?;
    // The nearest angle to π − 1e-12 that an `f64` can hold is another start, and so another motion.
    let rounded = pendulum.released_from(Angle::from_radians(PI - 1e-12)?)?;

    println!("period {:.12} s, {:.6} times that of small swings", motion.period(), ratio(&pendulum, &motion));
    println!("from the rounded angle {:.12} s\n", rounded.period());
    print_fall(&pendulum, &motion);
    Ok(())
}

fn ratio(pendulum: &Pendulum, motion: &Motion) -> f64 {
    motion.period() / pendulum.small_angle_period()
}

/// The fall to the bottom, a quarter period, compared with δ·cosh ω0t, which holds while the pendulum is nearly upright.
fn print_fall(pendulum: &Pendulum, motion: &Motion) {
    println!("    t / s    pi - angle / rad   1e-12 cosh(w0 t)    velocity / (rad/s)");
    let step_of_time = motion.period() / 32.0;
    for step in 0..=8 {
        let time = step_of_time * f64::from(step);
        let state = motion.state_at(time);
        let linear = 1e-12 * libm::cosh(pendulum.angular_frequency() * time);
        println!("{time:>9.5}  {:>18.9e} {linear:>18.9e}  {:>20.12}", state.complement, state.velocity);
    }
}
