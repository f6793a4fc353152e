//! −1 below zero, 0 at zero, 1 above zero.

use super::entry::{Entry, Growth, Parity, Rule};
use crate::algebra::{BigFloat, Rational};

pub(super) const ENTRY: Entry = Entry {
    name: "sign",
    word: "sgn",
    latex: ["\\operatorname{sgn}\\left(", "\\right)"],
    parity: Some(Parity::Odd),
    growth: Growth::Power,
    has_zeros: true,
    domain: None,
    rule: Rule::Step,
    double: of_double,
    float: of_float,
    rational: of_rational,
};

fn of_double(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

fn of_float(x: &BigFloat, precision: usize) -> Option<BigFloat> {
    let zero = BigFloat::from_integer(0, precision);
    let sign = if x.is_zero() {
        0
    } else if *x > zero {
        1
    } else {
        -1
    };
    Some(BigFloat::from_integer(sign, precision))
}

fn of_rational(x: &Rational) -> Option<Rational> {
    let sign = if x.is_zero() {
        0
    } else if x.is_negative() {
        -1
    } else {
        1
    };
    Some(Rational::from(sign))
}
