//! Double-precision numbers as a ring, for searches and motions in time.

use super::{Function, Rational, Ring};

/// The `f64`s; NaN where there is no value.
#[derive(Clone, Copy, Debug)]
pub struct Doubles;

impl Ring for Doubles {
    type Element = f64;

    fn zero(&self) -> f64 {
        0.0
    }

    fn is_zero(&self, a: &f64) -> bool {
        *a == 0.0
    }

    fn rational(&self, value: &Rational) -> Option<f64> {
        Some(value.to_f64())
    }

    fn add(&self, a: &f64, b: &f64) -> f64 {
        a + b
    }

    fn subtract(&self, a: &f64, b: &f64) -> f64 {
        a - b
    }

    fn negate(&self, a: &f64) -> f64 {
        -a
    }

    fn multiply(&self, a: &f64, b: &f64) -> f64 {
        a * b
    }

    #[expect(clippy::cast_precision_loss, reason = "rounded as every product is")]
    fn times_integer(&self, a: &f64, factor: i64) -> f64 {
        a * factor as f64
    }

    fn divide(&self, a: &f64, divisor: &f64) -> Option<f64> {
        Some(a / divisor)
    }

    #[expect(clippy::cast_precision_loss, reason = "rounded as every quotient is")]
    fn over_integer(&self, a: &f64, divisor: u64) -> Option<f64> {
        Some(a / divisor as f64)
    }

    fn value(&self, function: Function, at: &f64) -> Option<f64> {
        Some(function.at_double(*at))
    }

    fn power(&self, a: &f64, exponent: &Rational) -> Option<f64> {
        Some(libm::pow(*a, exponent.to_f64()))
    }

    fn pi(&self) -> Option<f64> {
        Some(std::f64::consts::PI)
    }

    fn convolution(&self, a: &[f64], b: &[f64]) -> f64 {
        a.iter().zip(b.iter().rev()).fold(0.0, |sum, (a, b)| sum + a * b)
    }
}
