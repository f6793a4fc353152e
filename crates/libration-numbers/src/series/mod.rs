//! Truncated power series over any ring: product, reciprocal, root, composition, reversion, elementary functions.
//!
//! Internally, long series with integer coefficients are kept in integers, as ordinary ones, Σ yₙxⁿ, or as even exponential ones, Σ yₙxⁿ/(2n)!,
//! so that greatest common divisors are computed only at the end.
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

#[doc(hidden)]
pub(crate) mod online;
mod power_series;
#[doc(hidden)]
pub(crate) mod recurrences;
#[doc(hidden)]
pub(crate) mod truncated;

use dashu_int::IBig;

pub use power_series::PowerSeries;
pub use truncated::{SeriesPowers, powers, powers_of_inverse, product, reciprocal, square_root_of_unit};

use online::{BLOCK, Convolution, Weight};

/// The first `length` coefficients of exp(Σ_{j≥1} hⱼxʲ/j), which the caller knows to be integers: n·eₙ = Σ hⱼe_{n−j}. `derivative` is h₀, h₁, …;
/// h₀ is not used.
pub fn exponential(derivative: &[IBig], length: usize) -> Vec<IBig> {
    let divided = |n: usize, sum: IBig| sum / IBig::from(n);
    Convolution { factor: derivative, weight: Weight::Ordinary, finish: &divided, block: BLOCK }
        .solve(IBig::ONE, length)
}

/// The first `length` integers bₙ of Σ bₙxⁿ/(2n)! = 1 / Σ aₙxⁿ/(2n)!, where a₀ = 1.
pub fn even_reciprocal(a: &[IBig], length: usize) -> Vec<IBig> {
    let negated = |_: usize, sum: IBig| -sum;
    Convolution { factor: a, weight: Weight::EvenFactorial, finish: &negated, block: BLOCK }
        .solve(IBig::ONE, length)
}
