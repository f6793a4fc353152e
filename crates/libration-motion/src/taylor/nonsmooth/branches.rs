//! The sign of the argument of each absolute value, or the fact that it stays at zero.

use crate::taylor::Cause;
use crate::taylor::program::expander::{Expander, Surroundings};
use crate::taylor::step::block::Block;
use crate::taylor::step::sign_change::{first_sign_change, scaled};

/// The arguments of all absolute values in all lanes.
#[derive(Debug)]
pub(in crate::taylor) struct Branches<const N: usize> {
    /// Number of leading coefficients of each argument that are zero at the start of the step, and that can differ from zero only by rounding.
    zeros: Vec<[usize; N]>,
    /// `true` until the first step of a motion that begins in this lane.
    begins: [bool; N],
}

impl<const N: usize> Branches<N> {
    pub(in crate::taylor) fn new(moduli: usize) -> Self {
        Self { zeros: vec![[0; N]; moduli], begins: [false; N] }
    }

    /// Begins a motion in a lane.
    pub(in crate::taylor) fn start(&mut self, lane: usize) {
        self.pass(lane);
        self.begins[lane] = true;
    }

    /// Forgets the zeros that a lane has passed.
    pub(in crate::taylor) fn pass(&mut self, lane: usize) {
        for zeros in &mut self.zeros {
            zeros[lane] = 0;
        }
    }

    /// Continues a motion in a lane.
    pub(in crate::taylor) fn resume(&mut self, lane: usize, zeros: impl Iterator<Item = usize>) {
        self.begins[lane] = false;
        for (counts, zeros) in self.zeros.iter_mut().zip(zeros) {
            counts[lane] = zeros;
        }
    }

    /// The number of leading coefficients of an argument that are zero where the next step begins.
    pub(in crate::taylor) fn zeros(&self, modulus: usize, lane: usize) -> usize {
        self.zeros[modulus][lane]
    }

    /// Expands steps of which only the starts are set, with the signs that the arguments have after these.
    pub(in crate::taylor) fn settle(
        &mut self,
        expander: &Expander<'_>,
        block: &mut Block<N>,
        surroundings: &mut Surroundings<N>,
        backward: &[bool; N],
    ) -> [Result<(), Cause>; N] {
        // Each attempt may reveal one more wrong sign.
        for _ in 0..2 * self.zeros.len() {
            expander.expand(block, surroundings);
            if !self.correct(expander, block, surroundings, backward).iter().flatten().any(|wrong| *wrong) {
                return self.decided(expander, block, surroundings, backward);
            }
        }
        expander.expand(block, surroundings);
        let wrong = self.correct(expander, block, surroundings, backward);
        self.stick(&wrong, expander, block, surroundings)
    }

    /// The outcome for signs that agree with the series: undecided where a motion begins at a zero and the opposite sign agrees as well, because a
    /// force jumps there and leads away on both sides.
    fn decided(
        &self,
        expander: &Expander<'_>,
        block: &mut Block<N>,
        surroundings: &mut Surroundings<N>,
        backward: &[bool; N],
    ) -> [Result<(), Cause>; N] {
        let mut outcomes = [Ok(()); N];
        for modulus in 0..self.zeros.len() {
            let (argument, sticks) = (expander.argument(modulus), surroundings.sticks[modulus]);
            let value = block[argument][0];
            let is_open = |lane: usize| self.begins[lane] && !sticks[lane] && value[lane] == 0.0;
            let open: Vec<usize> = (0..N).filter(|&lane| is_open(lane)).collect();
            if open.is_empty() {
                continue;
            }
            let signs = surroundings.signs[modulus];
            open.iter().for_each(|&lane| surroundings.signs[modulus][lane] = -signs[lane]);
            expander.expand(block, surroundings);
            for lane in open {
                let series = block[argument].iter().map(|c| c[lane]).enumerate();
                if sign_behind(series, backward[lane]) == Some(-signs[lane]) {
                    outcomes[lane] = Err(Cause::Undecided);
                }
            }
            surroundings.signs[modulus] = signs;
            expander.expand(block, surroundings);
        }
        outcomes
    }

    /// Sets the signs to those of the series of the arguments, and releases components that no sign from −1 to 1 keeps at zero. Returns
    /// `true` for each argument and lane whose series had another sign.
    fn correct(
        &self,
        expander: &Expander<'_>,
        block: &Block<N>,
        surroundings: &mut Surroundings<N>,
        backward: &[bool; N],
    ) -> Vec<[bool; N]> {
        let mut wrong = vec![[false; N]; self.zeros.len()];
        for (modulus, wrong) in wrong.iter_mut().enumerate() {
            for lane in 0..N {
                let sign = surroundings.signs[modulus][lane];
                let sign_now = if surroundings.sticks[modulus][lane] {
                    let needed = block[expander.sign(block, modulus)][0][lane];
                    surroundings.sticks[modulus][lane] = needed.abs() <= 1.0;
                    wrong[lane] = needed.abs() > 1.0;
                    if wrong[lane] { needed.signum() } else { sign }
                } else {
                    let series = block[expander.argument(modulus)].iter().map(|c| c[lane]);
                    let behind = series.enumerate().skip(self.zeros[modulus][lane]);
                    let corrected = sign_behind(behind, backward[lane]).unwrap_or(sign);
                    wrong[lane] = corrected * sign < 0.0;
                    corrected
                };
                surroundings.signs[modulus][lane] = sign_now;
            }
        }
        wrong
    }

    /// Keeps at zero the velocities, and other arguments whose rate of change is given by an equation, that can leave zero to neither side.
    fn stick(
        &mut self,
        wrong: &[[bool; N]],
        expander: &Expander<'_>,
        block: &mut Block<N>,
        surroundings: &mut Surroundings<N>,
    ) -> [Result<(), Cause>; N] {
        let mut outcomes = [Ok(()); N];
        for (modulus, wrong) in wrong.iter().enumerate() {
            for lane in (0..N).filter(|&lane| wrong[lane]) {
                match expander.system.driven_in_modulus(modulus) {
                    Some(number) => {
                        block.stop(number, lane);
                        surroundings.sticks[modulus][lane] = true;
                    }
                    None => outcomes[lane] = Err(Cause::NoWayOn),
                }
            }
        }
        expander.expand(block, surroundings);
        for (modulus, wrong) in wrong.iter().enumerate() {
            let sign = block[expander.sign(block, modulus)][0];
            for lane in (0..N).filter(|&lane| wrong[lane] && sign[lane].abs() > 1.0) {
                outcomes[lane] = Err(Cause::NoWayOn);
            }
        }
        outcomes
    }

    /// Ends the steps where an argument first changes its sign, or where a sticking velocity is released.
    pub(in crate::taylor) fn cut(
        &mut self,
        expander: &Expander<'_>,
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
        expander: &Expander<'_>,
        block: &mut Block<N>,
        surroundings: &mut Surroundings<N>,
    ) {
        let length = block.end[lane] - block.start[lane];
        let units = length / block.unit[lane];
        let changes: Vec<Option<f64>> = (0..self.zeros.len())
            .map(|modulus| match surroundings.sticks[modulus][lane] {
                true => release(block[expander.sign(block, modulus)].iter().map(|c| c[lane]), units),
                false => {
                    let series = block[expander.argument(modulus)].iter().map(|c| c[lane]);
                    let terms = scaled(series, units).into_iter().skip(self.zeros[modulus][lane]);
                    first_sign_change(&terms.skip_while(|term| *term == 0.0).collect::<Vec<_>>())
                }
            })
            .collect();
        let first = changes.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        if first.is_finite() {
            block.end[lane] = block.start[lane] + first * length;
        }
        let moves = (block.end[lane] - block.start[lane]).abs() > 0.0;
        self.begins[lane] &= !moves;
        for (modulus, change) in changes.iter().enumerate() {
            let changes_now = *change == Some(first);
            let zeros = &mut self.zeros[modulus][lane];
            let sign = &mut surroundings.signs[modulus][lane];
            if changes_now && surroundings.sticks[modulus][lane] {
                surroundings.sticks[modulus][lane] = false;
                let series = block[expander.sign(block, modulus)].iter().map(|c| c[lane]);
                *sign = scaled(series, first * units).iter().sum::<f64>().signum();
                // Two coefficients are zero, for example the velocity and the acceleration.
                *zeros = 2;
            } else if changes_now {
                *sign = -*sign;
                *zeros = 1;
            } else if moves {
                // A step of length zero keeps zeros unchanged.
                *zeros = 0;
            }
        }
    }
}

/// The sign of a series next to its centre; `None` if the series vanishes.
fn sign_behind(mut terms: impl Iterator<Item = (usize, f64)>, backward: bool) -> Option<f64> {
    let (n, c) = terms.find(|(_, c)| *c != 0.0)?;
    Some(if backward && n % 2 == 1 { -c.signum() } else { c.signum() })
}

/// The fraction of the step after which a sign leaves the range from −1 to 1.
fn release(sign: impl Iterator<Item = f64>, length: f64) -> Option<f64> {
    let sign = scaled(sign, length);
    let from = |limit: f64| {
        let mut distance: Vec<f64> = sign.iter().map(|c| -limit * c).collect();
        *distance.first_mut()? += 1.0;
        first_sign_change(&distance)
    };
    let (above, below) = (from(1.0), from(-1.0));
    above.into_iter().chain(below).reduce(f64::min)
}
