//! On which side of zero the argument of each absolute value is.

use super::Cause;
use super::block::Block;
use super::expander::{Expander, Surroundings};
use super::sign_change::first_sign_change;

/// The arguments of all absolute values in all lanes.
#[derive(Debug)]
pub(super) struct Branches<const N: usize> {
    /// Of each argument: arguments that are zero where the step begins, and of which only rounding makes something else.
    at_zero: Vec<[bool; N]>,
}

impl<const N: usize> Branches<N> {
    pub(super) fn new(moduli: usize) -> Self {
        Self { at_zero: vec![[false; N]; moduli] }
    }

    /// Begins a motion in a lane.
    pub(super) fn launch(&mut self, lane: usize) {
        for at_zero in &mut self.at_zero {
            at_zero[lane] = false;
        }
    }

    /// Expands steps that have only their starts, with the signs that the arguments have behind these.
    pub(super) fn settle(
        &mut self,
        expander: &mut Expander<'_, N>,
        block: &mut Block<N>,
        surroundings: &mut Surroundings<N>,
        backward: &[bool; N],
    ) -> [Result<(), Cause>; N] {
        // Each attempt may show one more sign to be wrong.
        for _ in 0..2 * self.at_zero.len() {
            expander.expand(block, surroundings);
            if !self.correct(expander, surroundings, backward).contains(&true) {
                return [Ok(()); N];
            }
        }
        expander.expand(block, surroundings);
        let wrong = self.correct(expander, surroundings, backward);
        wrong.map(|wrong| if wrong { Err(Cause::NoWayOn) } else { Ok(()) })
    }

    /// Gives the signs that the series of the arguments have; in which lanes one was another.
    fn correct(
        &self,
        expander: &Expander<'_, N>,
        surroundings: &mut Surroundings<N>,
        backward: &[bool; N],
    ) -> [bool; N] {
        let mut wrong = [false; N];
        for (modulus, (signs, at_zero)) in surroundings.signs.iter_mut().zip(&self.at_zero).enumerate() {
            let argument = expander.argument(modulus);
            for lane in 0..N {
                let series = argument.iter().map(|c| c[lane]).enumerate().skip(usize::from(at_zero[lane]));
                let found = sign_behind(series, backward[lane]).unwrap_or(signs[lane]);
                wrong[lane] |= found * signs[lane] < 0.0;
                signs[lane] = found;
            }
        }
        wrong
    }

    /// Ends the steps where an argument first changes its sign.
    pub(super) fn cut(
        &mut self,
        expander: &Expander<'_, N>,
        block: &mut Block<N>,
        surroundings: &mut Surroundings<N>,
    ) {
        for lane in 0..N {
            self.cut_lane(lane, expander, block, surroundings);
        }
    }

    fn cut_lane(
        &mut self,
        lane: usize,
        expander: &Expander<'_, N>,
        block: &mut Block<N>,
        surroundings: &mut Surroundings<N>,
    ) {
        let length = block.end[lane] - block.start[lane];
        let change = |(modulus, at_zero): (usize, &[bool; N])| {
            let series = expander.argument(modulus).iter().map(|c| c[lane]);
            first_sign_change(&scaled(series, at_zero[lane], length))
        };
        let changes: Vec<Option<f64>> = self.at_zero.iter().enumerate().map(change).collect();
        let first = changes.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        if first.is_finite() {
            block.end[lane] = block.start[lane] + first * length;
        }
        let moves = (block.end[lane] - block.start[lane]).abs() > 0.0;
        for ((change, signs), zero) in changes.iter().zip(&mut surroundings.signs).zip(&mut self.at_zero) {
            let changes_now = *change == Some(first);
            signs[lane] = if changes_now { -signs[lane] } else { signs[lane] };
            // A step without length leaves what is zero at zero.
            zero[lane] = changes_now || (zero[lane] && !moves);
        }
    }
}

/// The sign of a series next to its centre; `None` when it vanishes.
fn sign_behind(mut terms: impl Iterator<Item = (usize, f64)>, backward: bool) -> Option<f64> {
    let (n, c) = terms.find(|(_, c)| *c != 0.0)?;
    Some(if backward && n % 2 == 1 { -c.signum() } else { c.signum() })
}

/// The coefficients of the part of the step as variable, divided by it as long as the polynomial is zero at zero.
fn scaled(series: impl Iterator<Item = f64>, zero: bool, length: f64) -> Vec<f64> {
    let mut power = 1.0;
    let terms = series.map(|c| {
        let term = c * power;
        power *= length;
        term
    });
    terms.skip(usize::from(zero)).skip_while(|term| *term == 0.0).collect()
}
