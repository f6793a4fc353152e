//! On which side of zero the argument of each absolute value is.

use super::expander::Expander;
use super::sign_change::first_sign_change;
use super::{Cause, Step};

/// The sign of each argument during a step.
#[derive(Debug)]
pub(super) struct Branches {
    signs: Vec<f64>,
    /// Arguments that are zero where the step begins, and of which only rounding makes something else.
    at_zero: Vec<bool>,
}

impl Branches {
    pub(super) fn new(moduli: usize) -> Self {
        Self { signs: vec![1.0; moduli], at_zero: vec![false; moduli] }
    }

    /// Expands a step that has only its start, with the signs that the arguments have behind it.
    pub(super) fn settle(
        &mut self,
        expander: &mut Expander,
        step: &mut Step,
        backward: bool,
    ) -> Result<(), Cause> {
        // Each attempt may show one more sign to be wrong.
        for _ in 0..=2 * self.signs.len() {
            let outcome = self.expand(expander, step);
            if !self.correct(expander, backward) {
                return outcome;
            }
        }
        Err(Cause::NoWayOn)
    }

    /// The series of a step, with the signs as they are.
    pub(super) fn expand(&self, expander: &mut Expander, step: &mut Step) -> Result<(), Cause> {
        let outcome = expander.expand(step.start, &self.signs, &mut step.series);
        let finite = step.series.iter().flatten().all(|c| c.is_finite());
        outcome.ok().filter(|()| finite).ok_or(Cause::Singularity)
    }

    /// Gives the signs that the series of the arguments have; whether one was another.
    fn correct(&mut self, expander: &Expander, backward: bool) -> bool {
        let mut wrong = false;
        for (modulus, (sign, zero)) in self.signs.iter_mut().zip(&self.at_zero).enumerate() {
            let found = sign_behind(expander.argument(modulus), *zero, backward).unwrap_or(*sign);
            wrong |= found * *sign < 0.0;
            *sign = found;
        }
        wrong
    }

    /// Ends the step where an argument first changes its sign.
    pub(super) fn cut(&mut self, expander: &Expander, step: &mut Step) {
        let length = step.end - step.start;
        let change = |(modulus, zero): (usize, &bool)| {
            first_sign_change(&scaled(expander.argument(modulus), *zero, length))
        };
        let changes: Vec<Option<f64>> = self.at_zero.iter().enumerate().map(change).collect();
        let first = changes.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        if first.is_finite() {
            step.end = step.start + first * length;
        }
        let moves = (step.end - step.start).abs() > 0.0;
        for ((change, sign), zero) in changes.iter().zip(&mut self.signs).zip(&mut self.at_zero) {
            let changes_now = *change == Some(first);
            *sign = if changes_now { -*sign } else { *sign };
            // A step without length leaves what is zero at zero.
            *zero = changes_now || (*zero && !moves);
        }
    }

    /// How far the accelerations at a time are from those of the step's polynomials, as a part of the latter's size.
    pub(super) fn defect(&self, expander: &mut Expander, step: &Step, time: f64) -> f64 {
        let state: Vec<f64> = step.state_at(time);
        let coordinates = state.len() / 2;
        let exact = expander.accelerations(time, &self.signs, &state);
        let parts = exact.iter().enumerate().map(|(i, exact)| {
            let own = step.slope_at(coordinates + i, time - step.start);
            let size = exact.abs().max(own.abs());
            if size == 0.0 { 0.0 } else { (exact - own).abs() / size }
        });
        // What is not finite is no agreement.
        parts.fold(0.0, |largest, part| if part <= largest { largest } else { part })
    }
}

/// The sign of a series next to its centre; `None` when it vanishes.
fn sign_behind(series: &[f64], zero: bool, backward: bool) -> Option<f64> {
    let mut terms = series.iter().enumerate().skip(usize::from(zero));
    let (n, c) = terms.find(|(_, c)| **c != 0.0)?;
    Some(if backward && n % 2 == 1 { -c.signum() } else { c.signum() })
}

/// The coefficients of the part of the step as variable, divided by it as long as the polynomial is zero at zero.
fn scaled(series: &[f64], zero: bool, length: f64) -> Vec<f64> {
    let mut power = 1.0;
    let terms = series.iter().map(|c| {
        let term = c * power;
        power *= length;
        term
    });
    terms.skip(usize::from(zero)).skip_while(|term| *term == 0.0).collect()
}
