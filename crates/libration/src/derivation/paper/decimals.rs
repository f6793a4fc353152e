//! The ring of `f64` numbers, for what is checked numerically.

use crate::algebra::{Function, Rational, Ring};

#[derive(Clone, Copy, Debug)]
pub(super) struct Decimals;

impl Ring for Decimals {
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

    #[expect(clippy::cast_precision_loss, reason = "the factors are small")]
    fn times_integer(&self, a: &f64, factor: i64) -> f64 {
        a * factor as f64
    }

    fn divide(&self, a: &f64, divisor: &f64) -> Option<f64> {
        Some(a / divisor)
    }

    #[expect(clippy::cast_precision_loss, reason = "the divisors are small")]
    fn over_integer(&self, a: &f64, divisor: u64) -> Option<f64> {
        Some(a / divisor as f64)
    }

    fn value(&self, function: Function, at: &f64) -> Option<f64> {
        let of = match function {
            Function::Sqrt => f64::sqrt,
            Function::Sin => libm::sin,
            Function::Cos => libm::cos,
            Function::Tan => libm::tan,
            Function::Asin => libm::asin,
            Function::Acos => libm::acos,
            Function::Atan => libm::atan,
            Function::Sinh => libm::sinh,
            Function::Cosh => libm::cosh,
            Function::Tanh => libm::tanh,
            Function::Exp => libm::exp,
            Function::Ln => libm::log,
            Function::Abs => f64::abs,
        };
        Some(of(*at))
    }

    fn power(&self, a: &f64, exponent: &Rational) -> Option<f64> {
        Some(libm::pow(*a, exponent.to_f64()))
    }

    fn pi(&self) -> Option<f64> {
        Some(std::f64::consts::PI)
    }
}
