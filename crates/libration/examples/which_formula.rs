//! Choice of a formula for the period that is good enough at 40°.
//!
//!     cargo run --release -p libration --example which_formula
#![expect(clippy::print_stdout, reason = "an example shows its answer")]

use libration::pendulum::Amplitude;
use libration::period_formulas::{ErrorTable, catalogue};
use libration::progress::{Interrupted, Quiet};
use libration::quantity::Angle;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let angle: Angle = "40deg".parse()?;
    println!("exact T/T0 at 40°: {}\n", Amplitude::new(angle)?.period_ratio());
    print_errors(&angle);
    print_simplest(&angle)?;
    Ok(())
}

/// Every formula of the catalogue, the worst first.
fn print_errors(amplitude: &Angle) {
    let mut errors: Vec<_> =
        catalogue().iter().map(|formula| (formula.fractional_error(amplitude), formula)).collect();
    errors.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    for (error, formula) in errors {
        println!("{error:>+10.1e}  {}", formula.name());
    }
}

/// The formula with the least arithmetic that keeps each tolerance at this amplitude and all below.
fn print_simplest(amplitude: &Angle) -> Result<(), Interrupted> {
    let table = ErrorTable::new(catalogue(), &Quiet)?;
    println!();
    for tolerance in [1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-12] {
        match table.simplest(amplitude, tolerance).first() {
            Some(formula) => println!("within {tolerance:e}: {}", formula.name()),
            None => println!("within {tolerance:e}: none of the catalogue"),
        }
    }
    Ok(())
}
