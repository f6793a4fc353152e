//! Coefficient rings and numbers beyond `f64`: exact rationals, floats of any precision, and the product of
//! integer polynomials.

mod big_float;
mod integer_polynomial;
mod rational;

pub(crate) use big_float::BigFloat;
pub(crate) use integer_polynomial::product;
pub use rational::{NotARational, Rational};
