//! Coefficient rings and numbers beyond `f64`: exact rationals, floats of any precision, polynomials in
//! named variables, the product of integer polynomials, and complex numbers.
//!
//! ```
//! # extern crate libration_numbers as libration;
//! use libration::algebra::{BigFloat, Polynomial, Rational};
//!
//! // Fractions are exact, and letters remain symbols.
//! let third = Rational::new(1, 3).ok_or("zero")?;
//! assert_eq!((third.clone() + third.clone() + third).to_string(), "1");
//! let (a, b) = (Polynomial::variable("a"), Polynomial::variable("b"));
//! assert_eq!(((a.clone() + b.clone()) * (a - b)).to_string(), "a^2 - b^2");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod big_float;
mod big_sine;
#[doc(hidden)]
pub(crate) mod common_denominator;
#[doc(hidden)]
pub(crate) mod complex;
mod decimal_digits;
mod doubles;
mod expected_denominators;
mod floats;
#[doc(hidden)]
pub(crate) mod function;
#[doc(hidden)]
pub(crate) mod harmonics;
#[doc(hidden)]
pub(crate) mod in_order;
#[doc(hidden)]
pub(crate) mod integer_polynomial;
#[doc(hidden)]
pub(crate) mod lanes;
#[doc(hidden)]
pub(crate) mod lanewise;
mod laurent;
#[doc(hidden)]
pub(crate) mod mixed_radix;
#[doc(hidden)]
pub(crate) mod ordered_map;
#[doc(hidden)]
pub(crate) mod pi_powers;
mod pi_sum;
mod polynomial;
#[doc(hidden)]
pub(crate) mod prime_field;
#[doc(hidden)]
pub(crate) mod prime_fields;
#[doc(hidden)]
pub(crate) mod primes;
#[doc(hidden)]
pub(crate) mod quadratic_field;
mod rational;
mod rationals;
#[doc(hidden)]
pub(crate) mod reconstruction;
mod ring;
#[doc(hidden)]
pub(crate) mod sampled_harmonics;
mod sampled_values;
mod surd;
#[doc(hidden)]
pub(crate) mod tower;
#[doc(hidden)]
pub(crate) mod univariate;

pub use big_float::BigFloat;
pub use complex::Complex;
pub use doubles::Doubles;
pub use floats::Floats;
pub use function::Function;
pub(crate) use function::{Divisor, Domain, Growth, Pair, Parity, Rule, Slope};
pub(crate) use harmonics::{HarmonicPair, PhaseRing};
pub(crate) use integer_polynomial::product;
pub use laurent::{LaurentPolynomial, LaurentPolynomials, LetterPower};
pub use pi_sum::PiSum;
pub use polynomial::{Monomial, Polynomial, Polynomials, Variable};
pub(crate) use prime_field::PrimeField;
pub(crate) use prime_fields::{LANES, PrimeFields, Residues};
pub use rational::{ParseRationalError, Rational};
pub use rationals::Rationals;
pub use ring::Ring;
pub use surd::Surd;
