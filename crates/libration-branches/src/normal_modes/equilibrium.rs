//! Equilibria of a system: Newton's method of `roots` from a guess, and rational equilibria at which all forces provably vanish.
//!
//! In double precision a force vanishes by rounding where it decreases slowly, as √(x² + a) − x does far out, and a double zero is known to half
//! the digits. So Newton's method continues with numbers of 256 bits, where only a simple zero attracts it quadratically.

use super::error::{ModesError, SearchEnd};
use libration_numbers::algebra::{BigFloat, Doubles, Floats, Rational, Rationals, Ring};
use libration_numbers::internals::roots::{NewtonError, Unsolved, correction, newton};
use libration_numbers::{
    expression::{Equation, Expression, Symbol},
    internals::expression::{Jet, Tape},
};

/// An equilibrium.
#[derive(Clone, Debug)]
pub(super) struct Equilibrium {
    pub(super) at: Vec<f64>,
    /// The equilibrium in fractions, if the accelerations provably vanish there.
    pub(super) exact: Option<Vec<Rational>>,
    /// The equilibrium to [`PRECISION`] bits, if it is a simple zero that is not known in fractions.
    pub(super) precise: Option<Vec<BigFloat>>,
}

/// Bits of a precise equilibrium.
pub(super) const PRECISION: usize = 256;
/// Rounding of a precise equilibrium, with a margin: three quarters of the bits are 1e-58.
const PRECISE: f64 = 1e-50;

/// The equilibrium that Newton's method finds from a guess.
pub(super) fn equilibrium(equation: &Equation, guess: &[f64]) -> Result<Equilibrium, ModesError> {
    let at_rest: Vec<Expression> =
        equation.accelerations().iter().map(|acceleration| at_rest(acceleration, equation)).collect();
    let names: Vec<Symbol> = equation.variables().iter().map(|name| Symbol::plain(name)).collect();
    if let Some(exact) = proved(&at_rest, &names, guess, 0.0) {
        return Ok(Equilibrium { at: guess.to_vec(), exact: Some(exact), precise: None });
    }
    let near = zero_near(&at_rest, &names, guess)?;
    let to_f64 = |at: &[BigFloat]| at.iter().map(BigFloat::to_f64).collect::<Vec<_>>();
    let (to, established, rounding) = match precise_zero(&at_rest, &names, &near)? {
        Ok(precise) => (to_f64(&precise), Ok(Some(precise)), PRECISE),
        // Along a free direction the equilibria are a curve, on which the guess lies.
        Err(Unsolved { reason: NewtonError::NoSlope, .. }) => (near, Ok(None), 4.0 * f64::EPSILON),
        Err(Unsolved { at, .. }) => (to_f64(&at), Err(SearchEnd::Rounding), PRECISE),
    };
    if let Some(exact) = proved(&at_rest, &names, &to, rounding) {
        let at = exact.iter().map(Rational::to_f64).collect();
        return Ok(Equilibrium { at, exact: Some(exact), precise: None });
    }
    match established {
        Ok(precise) => Ok(Equilibrium { at: to, exact: None, precise }),
        Err(end) => Err(ModesError::NoEquilibrium { from: guess.to_vec(), to, end }),
    }
}

/// An acceleration at zero velocities.
fn at_rest(formula: &Expression, equation: &Equation) -> Expression {
    let velocities = equation.variables().iter().map(|name| Symbol::plain(name).with_primes(1));
    let still = velocities
        .fold(formula.clone(), |partial, velocity| partial.substitute(&velocity, &Expression::from(0)));
    still.simplified()
}

/// Simple fractions next to the numbers, if all formulas vanish there; coordinates below a part of the largest are zero.
fn proved(formulas: &[Expression], names: &[Symbol], at: &[f64], part: f64) -> Option<Vec<Rational>> {
    let largest = at.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let fraction = |x: &f64| if x.abs() <= part * largest { Some(0.into()) } else { simplest(*x, x.abs()) };
    let fractions: Vec<Rational> = at.iter().map(fraction).collect::<Option<_>>()?;
    let vanishes = |formula: &Expression| {
        substituted(formula, names, &fractions).to_rational().is_some_and(|value| value.is_zero())
    };
    formulas.iter().all(vanishes).then_some(fractions)
}

/// The formula after substitution of fractions for symbols.
pub(super) fn substituted(formula: &Expression, names: &[Symbol], values: &[Rational]) -> Expression {
    let pairs = names.iter().zip(values);
    pairs.fold(formula.clone(), |partial, (name, value)| {
        partial.substitute(name, &Expression::Number(value.clone()))
    })
}

/// The fraction with the smallest denominator within 1e-12 of a size from a number.
pub(super) fn simplest(x: f64, size: f64) -> Option<Rational> {
    let value = BigFloat::from_f64(x, 64)?.to_rational();
    if value.is_zero() {
        return Some(value);
    }
    let size = BigFloat::from_f64(size, 64)?.to_rational();
    let width = Rationals.multiply(&size, &Rational::new(1, 1_000_000_000_000)?);
    Some(Rational::simplest_between(&Rationals.subtract(&value, &width), &Rationals.add(&value, &width)))
}

fn zero_near(formulas: &[Expression], names: &[Symbol], guess: &[f64]) -> Result<Vec<f64>, ModesError> {
    const MOST_STEPS: usize = 100;
    let tape = Tape::new(&formulas.iter().collect::<Vec<_>>(), names)?;
    let size = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let is_last =
        |step: &[f64], at: &[f64]| size(step) <= 4.0 * f64::EPSILON * size(at).max(f64::MIN_POSITIVE);
    let step = |at: &[f64]| {
        correction(&Doubles, |x| x.abs(), &tape, at).map(|step| shortened(step, at, |at| largest(&tape, at)))
    };
    newton(&Doubles, guess, MOST_STEPS, step, is_last).map_err(|Unsolved { at: to, reason }| {
        let end = match reason {
            NewtonError::NoValue => SearchEnd::NoValue,
            NewtonError::NoSlope => SearchEnd::NoSlope,
            NewtonError::Unsettled => SearchEnd::Unsettled,
        };
        ModesError::NoEquilibrium { from: guess.to_vec(), to, end }
    })
}

/// The zero to which Newton's method converges from an approximate one, to [`PRECISION`] bits.
fn precise_zero(
    formulas: &[Expression],
    names: &[Symbol],
    near: &[f64],
) -> Result<Result<Vec<BigFloat>, Unsolved<BigFloat>>, ModesError> {
    /// A double zero needs one step for each bit; the place reached is then compared with fractions.
    const MOST_STEPS: usize = 64;
    let ring = Floats { precision: PRECISION };
    let tape = Tape::new(&formulas.iter().collect::<Vec<_>>(), names)?;
    let start: Option<Vec<BigFloat>> = near.iter().map(|&x| BigFloat::from_f64(x, PRECISION)).collect();
    let start = start.expect("Newton's method in double precision ends at finite numbers");
    let size = |values: &[BigFloat]| values.iter().filter_map(BigFloat::exponent).max();
    let bits = isize::try_from(PRECISION * 3 / 4).unwrap_or(isize::MAX);
    let is_last = |step: &[BigFloat], at: &[BigFloat]| {
        size(step).is_none_or(|step| size(at).is_some_and(|at| step < at - bits))
    };
    let step = |at: &[BigFloat]| correction(&ring, |x| x.to_f64().abs(), &tape, at);
    Ok(newton(&ring, &start, MOST_STEPS, step, is_last))
}

/// The largest acceleration; infinite where one has no value.
fn largest(tape: &Tape, at: &[f64]) -> f64 {
    let Ok(jet) = Jet::new(&Doubles, tape, at) else { return f64::INFINITY };
    let sizes = (0..at.len()).map(|i| jet.result(i)[0].abs());
    sizes.fold(0.0, |most, size| {
        if size <= most {
            most
        } else if size.is_nan() {
            f64::INFINITY
        } else {
            size
        }
    })
}

/// A step, halved until it reduces the largest acceleration: a full one may cross a singularity to another equilibrium. The full step if none does,
/// as at rounding errors.
fn shortened(step: Vec<f64>, at: &[f64], largest: impl Fn(&[f64]) -> f64) -> Vec<f64> {
    /// Next to a singularity a step is a few times too long; where no part of it down to 1/4096 is better, rounding errors are the reason.
    const HALVINGS: u32 = 12;
    let before = largest(at);
    let part = |halvings: u32| step.iter().map(move |x| x * libm::exp2(-f64::from(halvings)));
    let reduces = |halvings: &u32| {
        let next: Vec<f64> = at.iter().zip(part(*halvings)).map(|(x, by)| x + by).collect();
        largest(&next) < before
    };
    let halvings = (0..=HALVINGS).find(reduces).unwrap_or(0);
    part(halvings).collect()
}
