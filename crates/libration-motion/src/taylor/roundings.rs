//! Numbers with what rounding may have made of them, so that a formula tells how far its value in double precision may be off.

use libration_numbers::algebra::{Function, Rational, Ring};
use libration_numbers::internals::expression::{Jet, Tape};

/// The most by which rounding changes a number, as a part of it.
pub(super) const ROUNDING: f64 = f64::EPSILON / 2.0;

/// A number, and by how many [`ROUNDING`]s of one it may be wrong.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rounded {
    pub(super) value: f64,
    pub(super) error: f64,
}

/// The values of formulas with what is lost by rounding on the way, where the inputs are exact; `None` where one has no value.
pub(super) fn rounded_values(tape: &Tape, inputs: &[f64]) -> Option<Vec<Rounded>> {
    let inputs: Vec<Rounded> = inputs.iter().map(|&value| Rounded { value, error: 0.0 }).collect();
    let jet = Jet::new(&Roundings, tape, &inputs).ok()?;
    Some((0..tape.results().len()).map(|formula| jet.result(formula)[0]).collect())
}

/// Each operation adds its own rounding to what it makes of those of its operands.
#[derive(Clone, Copy, Debug)]
struct Roundings;

impl Rounded {
    fn new(value: f64, inherited: f64) -> Self {
        Self { value, error: inherited + value.abs() }
    }

    fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// The value of a function here, whose slope is taken from values so near that it changes little and so far that they tell it.
    fn through(self, function: impl Fn(f64) -> f64) -> Self {
        let Self { value: at, error } = self;
        let value = function(at);
        if error <= 0.0 {
            return Self::new(value, 0.0);
        }
        let apart = libm::ldexp(at.abs(), -20) + libm::ldexp(error, -40);
        let rise = |to: f64| (function(to) - value).abs();
        let steeper = f64::max(rise(at + apart), rise(at - apart));
        Self::new(value, steeper / apart * error)
    }
}

impl Ring for Roundings {
    type Element = Rounded;

    fn zero(&self) -> Rounded {
        Rounded::exact(0.0)
    }

    fn is_zero(&self, a: &Rounded) -> bool {
        a.value.abs() + a.error <= 0.0
    }

    fn rational(&self, value: &Rational) -> Option<Rounded> {
        let double = value.to_f64();
        Some(if value.is_double() { Rounded::exact(double) } else { Rounded::new(double, 0.0) })
    }

    fn add(&self, a: &Rounded, b: &Rounded) -> Rounded {
        Rounded::new(a.value + b.value, a.error + b.error)
    }

    fn subtract(&self, a: &Rounded, b: &Rounded) -> Rounded {
        Rounded::new(a.value - b.value, a.error + b.error)
    }

    fn negate(&self, a: &Rounded) -> Rounded {
        Rounded { value: -a.value, ..*a }
    }

    fn multiply(&self, a: &Rounded, b: &Rounded) -> Rounded {
        Rounded::new(a.value * b.value, a.value.abs() * b.error + b.value.abs() * a.error)
    }

    #[expect(clippy::cast_precision_loss, reason = "rounded as every product is")]
    fn times_integer(&self, a: &Rounded, factor: i64) -> Rounded {
        self.multiply(a, &Rounded::exact(factor as f64))
    }

    fn divide(&self, a: &Rounded, divisor: &Rounded) -> Option<Rounded> {
        let value = a.value / divisor.value;
        Some(Rounded::new(value, (a.error + value.abs() * divisor.error) / divisor.value.abs()))
    }

    #[expect(clippy::cast_precision_loss, reason = "rounded as every quotient is")]
    fn over_integer(&self, a: &Rounded, divisor: u64) -> Option<Rounded> {
        self.divide(a, &Rounded::exact(divisor as f64))
    }

    fn value(&self, function: Function, at: &Rounded) -> Option<Rounded> {
        Some(at.through(|x| function.at_double(x)))
    }

    fn power(&self, a: &Rounded, exponent: &Rational) -> Option<Rounded> {
        let exponent = exponent.to_f64();
        Some(a.through(|x| libm::pow(x, exponent)))
    }

    fn pi(&self) -> Option<Rounded> {
        Some(Rounded::new(std::f64::consts::PI, 0.0))
    }
}
