//! The force of an oscillator by powers of the displacement.

use libration_motion::oscillator::{Kind, Oscillator};
use libration_numbers::algebra::{Rational, Rationals};
use libration_numbers::{
    expression::Symbol,
    internals::expression::{Jet, Tape},
};

/// The coefficients g₁, g₂, … of the restoring force g(y) = −F(xₑ + y) by powers of the displacement y from the
/// equilibrium, as many as requested: the input of [`OpenGauge`](super::OpenGauge) and
/// [`TruncatedSystem`](super::TruncatedSystem). `None` when the velocity enters the force, or a coefficient is not
/// rational.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::oscillator::Oscillator;
/// use libration::perturbation::restoring_force;
/// let pendulum = Oscillator::new(&"x'' = -4*sin(x)".parse()?)?;
/// let coefficients = restoring_force(&pendulum, 3).unwrap();
/// assert_eq!(coefficients, ["4", "0", "-2/3"].map(|text| text.parse().unwrap()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn restoring_force(oscillator: &Oscillator, powers: usize) -> Option<Vec<Rational>> {
    if *oscillator.kind() != Kind::Conservative {
        return None;
    }
    let x = Symbol { name: oscillator.variable().to_owned(), primes: 0 };
    let tape = Tape::new(&[oscillator.acceleration()], &[x]).ok()?;
    let mut jet = Jet::new(&Rationals, &tape, &[oscillator.equilibrium().exact()?.clone()]).ok()?;
    for power in 1..=powers {
        jet.extend(&[Rational::from(i64::from(power == 1))]).ok()?;
    }
    Some(jet.result(0).iter().skip(1).map(|coefficient| -coefficient.clone()).collect())
}
