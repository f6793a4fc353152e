//! The period of the drive as a function of the parameters.

use super::error::BranchError;
use libration_motion::chaos::drive_frequency;
use libration_numbers::algebra::{BigFloat, Doubles, Floats, Ring};
use libration_numbers::{
    expression::{Equation, Expression, Symbol},
    internals::expression::{Jet, Tape},
};
use std::f64::consts::TAU;

/// T = n·2π/ω(p, …).
#[derive(Clone, Debug)]
pub(super) struct DriveLaw {
    /// ω, followed by its derivative with respect to each parameter.
    frequency: Tape,
    times: i32,
}

impl DriveLaw {
    pub(super) fn new(equation: &Equation, parameters: &[&str]) -> Result<Self, BranchError> {
        let (frequency, times) = drive_frequency(equation).ok_or(BranchError::NotDriven)?;
        let symbols: Vec<Symbol> = parameters.iter().map(|name| Symbol::plain(name)).collect();
        let slopes: Vec<Expression> =
            symbols.iter().map(|symbol| frequency.derivative(symbol).simplified()).collect();
        let formulas: Vec<&Expression> = std::iter::once(&frequency).chain(&slopes).collect();
        Ok(Self { frequency: Tape::new(&formulas, &symbols)?, times })
    }

    /// The period and its derivatives; `None` if it is undefined.
    pub(super) fn period(&self, parameters: &[f64]) -> Option<(f64, Vec<f64>)> {
        let jet = Jet::new(&Doubles, &self.frequency, parameters).ok()?;
        let frequency = jet.result(0)[0];
        let period = f64::from(self.times) * TAU / frequency.abs();
        let slope = |number: usize| -period * jet.result(number)[0] / frequency;
        (period > 0.0 && period.is_finite()).then(|| (period, (1..=parameters.len()).map(slope).collect()))
    }

    /// The period as a function of one parameter, in many bits.
    pub(super) fn precise_period(&self, ring: Floats, parameter: &BigFloat) -> Option<BigFloat> {
        let jet = Jet::new(&ring, &self.frequency, std::slice::from_ref(parameter)).ok()?;
        let frequency = jet.result(0)[0].clone();
        let turn = ring.times_integer(&BigFloat::pi(ring.precision), 2 * i64::from(self.times));
        let period = ring.divide(&turn, &frequency)?;
        Some(if period < ring.zero() { ring.negate(&period) } else { period })
    }
}
