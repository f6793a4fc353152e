//! Gravity from a measured period, amplitude and length, with its uncertainty; and what the small-angle
//! formula would have made of the same numbers.
//!
//!     cargo run --release -p libration --example gravity_from_period
#![expect(clippy::print_stdout, reason = "an example shows its answer")]

use libration::pendulum::{Amplitude, Pendulum};
use libration::quantity::{Angle, Dimension, Quantity, parse};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let length = parse("0.9940(5) m", Dimension::Length)?;
    let period = parse("2.0154(4) s", Dimension::Time)?;
    let (angle, angle_uncertainty): (Angle, Angle) = ("20deg".parse()?, "0.5deg".parse()?);

    let amplitude = Amplitude::new(angle)?;
    let pendulum = Pendulum::from_length_and_period(length.value, period.value, &amplitude)?;
    let gravity = pendulum.gravity().expect("it was made from its length and so has a gravity");

    // g = 4π²l(T/T0)²/T², and T/T0 follows the amplitude by its condition number.
    let of_ratio = amplitude.condition() * angle_uncertainty.radians() / angle.radians();
    let relative = root_of_squares([of(length), 2.0 * of(period), 2.0 * of_ratio]);
    println!("g = {gravity:.4} ± {:.4} m/s² from the exact period", gravity * relative);

    let ratio = amplitude.period_ratio();
    println!("g = {:.4} m/s² if the period is taken for that of small swings", gravity / (ratio * ratio));
    Ok(())
}

/// The relative uncertainty of a quantity.
fn of(quantity: Quantity) -> f64 {
    quantity.uncertainty.unwrap_or(0.0) / quantity.value
}

fn root_of_squares(parts: [f64; 3]) -> f64 {
    parts.iter().map(|part| part * part).sum::<f64>().sqrt()
}
