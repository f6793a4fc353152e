//! Coefficient rings and numbers beyond `f64`: exact rationals, floats of any precision, polynomials in
//! named variables, the product of integer polynomials, and complex numbers.
//!
//! ```
//! use libration::algebra::{BigFloat, Polynomial, Rational};
//!
//! // One third is one third, and letters stay letters.
//! let third = Rational::new(1, 3).ok_or("zero")?;
//! assert_eq!((third.clone() + third.clone() + third).to_string(), "1");
//! let (a, b) = (Polynomial::variable("a"), Polynomial::variable("b"));
//! assert_eq!(((a.clone() + b.clone()) * (a - b)).to_string(), "a^2 - b^2");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod big_float;
mod big_sine;
mod common_denominator;
mod complex;
mod decimal_digits;
mod doubles;
mod expected_denominators;
mod floats;
mod function;
mod harmonics;
mod integer_polynomial;
mod lanes;
mod lanewise;
mod laurent;
mod mixed_radix;
mod pi_powers;
mod pi_sum;
mod polynomial;
mod prime_field;
mod prime_fields;
mod primes;
mod quadratic_field;
mod rational;
mod rationals;
mod reconstruction;
mod ring;
mod sampled_harmonics;
mod sampled_values;
mod surd;
mod tower;
pub(crate) mod univariate;

pub use big_float::BigFloat;
pub use complex::Complex;
pub use doubles::Doubles;
pub use floats::Floats;
pub use function::Function;
pub(crate) use function::{Divisor, Domain, Growth, Pair, Parity, Rule, Slope};
pub(crate) use harmonics::{HarmonicPair, HarmonicSum, HarmonicSums, Number, PhaseRing};
pub(crate) use integer_polynomial::product;
pub(crate) use lanes::{Lanes, prepared_reciprocal, sin_cos_in_lanes};
pub(crate) use lanewise::{Rounded, any, convolution, integral, lanes, quotient, square};
pub use laurent::{LaurentPolynomial, LaurentPolynomials, LetterPower};
pub(crate) use pi_powers::{PiPolynomial, PiPowers};
pub use pi_sum::PiSum;
pub use polynomial::{Monomial, Polynomial, Polynomials, Variable};
pub(crate) use prime_field::PrimeField;
pub(crate) use prime_fields::{LANES, PrimeFields, Residues};
pub(crate) use primes::primes_with_roots;
pub(crate) use quadratic_field::{Quadratic, QuadraticField};
pub use rational::{NotARational, Rational};
pub use rationals::Rationals;
pub(crate) use reconstruction::{Images, Place, Stopped, reconstruct};
pub use ring::Ring;
pub(crate) use sampled_harmonics::{SampledHarmonics, Symmetry};
pub use surd::Surd;
pub(crate) use tower::Tower;
