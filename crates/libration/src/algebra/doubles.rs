//! Double-precision numbers as a ring, for searches and motions in time.

use super::lanewise;
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

    /// That of one lane.
    fn convolution(&self, a: &[f64], b: &[f64]) -> f64 {
        let [sum] = lanewise::convolution::<1>(a.as_chunks().0, b.as_chunks().0);
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn convolutions_of_every_length_are_those_of_whole_numbers() {
        let numbers = |factor: u32, length: u32| (0..length).map(move |n| f64::from(n * n * factor % 17));
        for length in 0..20 {
            let (a, b): (Vec<f64>, Vec<f64>) = (numbers(3, length).collect(), numbers(5, length).collect());
            let plain: f64 = a.iter().zip(b.iter().rev()).map(|(a, b)| a * b).sum();
            assert_eq!(Doubles.convolution(&a, &b).to_bits(), (plain + 0.0).to_bits(), "{length}");
        }
    }
}
