//! Coefficient rings and numbers beyond `f64`: exact rationals, floats of any precision, and the product of
//! integer polynomials.

mod big_float;
mod function;
mod integer_polynomial;
mod rational;
mod ring;

pub(crate) use big_float::BigFloat;
pub use function::Function;
pub(crate) use integer_polynomial::product;
pub use rational::{NotARational, Rational};
pub(crate) use ring::Ring;
