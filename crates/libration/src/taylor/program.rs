//! The tape of a system as a list of instructions on the block, without anything that is the same at every order.
//!
//! A `Jet` asks at every order what is constant, weighted or linear in the time. Integrations go through the tape a
//! million times a second, so that here it is asked once.

use std::ops::Range;

use super::System;
use super::block::{Block, Row};
use crate::algebra::{Doubles, Function, Lanes, Ring, lanes};
use crate::expression::{Operation, Slope};
use crate::series::recurrences::{
    Both, quotient, weighted_integral, weighted_integral_of_quotient, weighted_power,
};

/// Instructions for all coefficients of a system's formulas.
#[derive(Clone, Debug)]
pub(super) struct Program {
    /// How the zeroth coefficients come about.
    values: Vec<(Row, Value)>,
    /// What is linear in the time: the coefficients of order one.
    linear: Vec<Instruction>,
    /// The coefficients of every order from one on.
    every: Vec<Instruction>,
    /// Where the formulas are.
    results: Vec<Row>,
    rows: usize,
}

/// How the zeroth coefficient of a row comes about.
#[derive(Clone, Copy, Debug)]
enum Value {
    Constant(f64),
    Negate(Row),
    Add(Row, Row),
    Subtract(Row, Row),
    Multiply(Row, Row),
    Divide(Row, Row),
    Power(Row, f64),
    Function(Function, Row),
}

/// How the next coefficient of a row comes about. A row is weighted when it holds n times its coefficients.
#[derive(Clone, Copy, Debug)]
enum Instruction {
    Weight { of: Row, out: Row },
    Negate { a: Row, out: Row },
    Add { a: Row, b: Row, out: Row },
    Subtract { a: Row, b: Row, out: Row },
    /// The first factor is constant.
    Scale { factor: Row, a: Row, out: Row },
    Multiply { a: Row, b: Row, out: Row },
    /// The divisor is constant.
    DivideByConstant { a: Row, divisor: Row, out: Row },
    Divide { a: Row, b: Row, out: Row },
    Power { exponent: f64, a: Weighted, out: Weighted },
    Exp { weighted: Row, out: Row },
    /// Two functions with the derivatives of each other, the second with a sign; of a series of so many terms.
    Pair { weighted: Row, degree: usize, first: Row, second: Row, slope: Slope },
    Tangent { function: Function, weighted: Row, square: Row, out: Row },
    Inverse { weighted: Row, divisor: Row, out: Weighted },
}

/// A row and its weighted form.
#[derive(Clone, Copy, Debug)]
struct Weighted {
    plain: Row,
    weighted: Row,
}
