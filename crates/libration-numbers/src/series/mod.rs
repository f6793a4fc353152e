//! Truncated power series over any ring: product, reciprocal, root, composition, reversion, elementary functions.
//!
//! Inside, long series with integer coefficients, integers all the way: they are ordinary ones with integer coefficients, Σ yₙxⁿ, or even
//! exponential ones, Σ yₙxⁿ/(2n)!, so that no greatest common divisor is taken before the end.
//!
//! ```
//! # extern crate libration_numbers as libration;
//! use libration::algebra::{Function, Ring};
//! use libration::series::PowerSeries;
//!
//! // sin x/cos x, in exact fractions.
//! let series = PowerSeries::rational(6);
//! let x = series.variable().ok_or("no variable")?;
//! let (sine, cosine) = (series.value(Function::Sin, &x), series.value(Function::Cos, &x));
//! let tangent = series.divide(&sine.ok_or("no sine")?, &cosine.ok_or("no cosine")?).ok_or("no quotient")?;
//! assert_eq!(tangent[5].to_string(), "2/15");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod online;
mod power_series;
#[doc(hidden)]
pub(crate) mod recurrences;
#[doc(hidden)]
pub(crate) mod truncated;

use dashu_int::IBig;

pub use power_series::PowerSeries;
pub use truncated::{SeriesPowers, powers, powers_of_inverse, product, reciprocal, square_root_of_unit};

use online::{BLOCK, Convolution, Weight};

/// The first `length` coefficients of exp(Σ_{j≥1} hⱼxʲ/j), which are integers whenever they are said to be:
/// n·eₙ = Σ hⱼe_{n−j}. `derivative` is h₀, h₁, …; h₀ is not used.
pub fn exponential(derivative: &[IBig], length: usize) -> Vec<IBig> {
    let divided = |n: usize, sum: IBig| sum / IBig::from(n);
    Convolution { known: derivative, weight: Weight::Ordinary, finish: &divided, block: BLOCK }
        .solve(IBig::ONE, length)
}

/// The first `length` integers bₙ of Σ bₙxⁿ/(2n)! = 1 / Σ aₙxⁿ/(2n)!, where a₀ = 1.
pub fn even_reciprocal(a: &[IBig], length: usize) -> Vec<IBig> {
    let negated = |_: usize, sum: IBig| -sum;
    Convolution { known: a, weight: Weight::EvenFactorial, finish: &negated, block: BLOCK }
        .solve(IBig::ONE, length)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integers(values: &[i64]) -> Vec<IBig> {
        values.iter().copied().map(IBig::from).collect()
    }

    #[test]
    fn exponential_of_a_logarithm_gives_the_geometric_series() {
        // −ln(1 − x) = Σ xʲ/j.
        let length = 300;
        assert_eq!(exponential(&vec![IBig::ONE; length], length), vec![IBig::ONE; length]);
    }

    #[test]
    fn reciprocal_of_the_cosine_gives_the_euler_numbers() {
        // OEIS A000364.
        let cosine: Vec<IBig> = (0..8).map(|n| IBig::from(1 - 2 * (n % 2))).collect();
        let euler = integers(&[1, 1, 5, 61, 1385, 50521, 2702765, 199360981]);
        assert_eq!(even_reciprocal(&cosine, 8), euler);
    }

    #[test]
    fn reciprocal_of_the_reciprocal_is_the_series() {
        let a: Vec<IBig> = (0..260_i64).map(|n| IBig::from(1 + n * (n - 7)).pow(3)).collect();
        let b = even_reciprocal(&a, a.len());
        assert_eq!(even_reciprocal(&b, a.len()), a);
    }
}
