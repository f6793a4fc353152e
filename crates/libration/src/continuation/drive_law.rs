//! The period of the drive as a function of the parameter.

use super::error::NoBranch;
use crate::algebra::Doubles;
use crate::chaos::drive_frequency;
use crate::expression::{Equation, Jet, Symbol, Tape};
use std::f64::consts::TAU;

/// T = n·2π/ω(p).
#[derive(Clone, Debug)]
pub(super) struct DriveLaw {
    /// ω and dω/dp.
    frequency: Tape,
    times: f64,
}

impl DriveLaw {
    pub(super) fn new(equation: &Equation, parameter: &str) -> Result<Self, NoBranch> {
        let (frequency, times) = drive_frequency(equation).ok_or(NoBranch::NotDriven)?;
        let symbol = Symbol::plain(parameter);
        let slope = frequency.derivative(&symbol).simplified();
        Ok(Self { frequency: Tape::new(&[&frequency, &slope], &[symbol])?, times: f64::from(times) })
    }

    /// The period and its derivative; `None` where there is none.
    pub(super) fn period(&self, parameter: f64) -> Option<[f64; 2]> {
        let jet = Jet::new(&Doubles, &self.frequency, &[parameter]).ok()?;
        let [frequency, slope] = [0, 1].map(|result| jet.result(result)[0]);
        let period = self.times * TAU / frequency.abs();
        (period > 0.0 && period.is_finite()).then_some([period, -period * slope / frequency])
    }
}
