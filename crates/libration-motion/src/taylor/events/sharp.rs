//! Formulas of events that change by orders of magnitude within a step.
//!
//! Steps are as long as the accelerations allow. The series of e^(−20000(x − 2)²) about x = 3 vanishes to all digits, and that about x = 2
//! converges in a part of the step only. The series of such a formula are therefore computed again for parts of the step, which end at the
//! extrema of steep exponents, and are halved until each series agrees with the value of the formula at the state. The same is done for a
//! formula with a pole, such as 1/x, which the motion and its steps pass.

use libration_numbers::internals::algebra::InOrder;
use std::collections::VecDeque;

use super::boundary::{boundaries, reached};
use super::steep::{Steep, steep_places};
use crate::taylor::Step;
use crate::taylor::step::allowance::ROUNDING;
use crate::taylor::step::larger::larger_or_nan;
use crate::taylor::step::sign_change::scaled;
use libration_numbers::algebra::Doubles;
use libration_numbers::{
    expression::{Expression, Symbol},
    internals::expression::{Jet, Operation, Tape},
};

/// A formula that contains a steep function, or has a boundary.
#[derive(Clone, Debug)]
pub(in crate::taylor) struct SharpFormula {
    tape: Tape,
    steep: Vec<Steep<usize>>,
    /// `true` if the formula has a divisor, a root or the like, beyond whose zero its series are not valid.
    pub(in crate::taylor) ends: bool,
}

/// A part of a step.
pub(in crate::taylor) struct Part {
    pub(in crate::taylor) start: f64,
    pub(in crate::taylor) length: f64,
    /// Coefficients of the formula, in powers of the fraction of this part; none if it contains a pole.
    pub(in crate::taylor) coefficients: Vec<f64>,
}

/// A part that is still to be examined.
#[derive(Clone, Copy)]
struct Waiting {
    start: f64,
    length: f64,
    halvings: u32,
}

/// Order of the series: powers above a third of it are steep.
const ORDER: usize = 18;
/// Maximum number of halvings, after which a part is accepted: there the formula jumps, has a pole or no value.
const MOST_HALVINGS: u32 = 40;
/// Length of the shortest parts as a fraction of the step, 2⁻⁴⁰ for that number of halvings.
pub(in crate::taylor) const SHORTEST_PART: f64 = 9.094_947_017_729_282e-13;
/// Maximum number of parts that are examined; the rest is accepted. A formula
/// that is non-zero in a part 2⁻⁴⁰ of a step needs about 80, a pole 900.
const MOST_PARTS: usize = 2000;
/// Largest difference between the series of a formula and its values, relative to the largest of them, unless the tolerance is smaller.
const MISFIT: f64 = 1e-9;
/// Number of rounding errors of the state in the series of a part, which are about another centre.
pub(in crate::taylor) const SHIFTED: f64 = 16.0;
/// Fraction of a part beyond which a turn counts as its end.
const INSIDE: f64 = 0.999;

impl SharpFormula {
    /// The formula, which contains the sign of the argument of each |…| in its place; `None` if the series of whole steps represent it.
    pub(in crate::taylor) fn new(formula: &Expression, inputs: &[Symbol]) -> Option<Self> {
        let tape = Tape::new(&[formula], inputs).ok()?;
        let mut steep = steep_places(&tape, 1, ORDER);
        let divisors = reached(&tape, 1).into_iter().filter_map(|slot| match tape.operations()[slot] {
            Operation::Divide(_, divisor) if !tape.is_constant(divisor) => Some(Steep::divisor(divisor)),
            _ => None,
        });
        steep.extend(divisors);
        let ends = !boundaries(&tape, 1, inputs.len()).is_empty();
        (ends || !steep.is_empty()).then_some(Self { tape, steep, ends })
    }

    /// The parts of a step in each of which the series of the formula, with these open parameters and signs, holds
    /// to the tolerance. None where the formula has no value in double precision.
    pub(in crate::taylor) fn parts(&self, step: &Step<'_>, constants: &[f64], tolerance: f64) -> Vec<Part> {
        let allowed = tolerance.clamp(ROUNDING, MISFIT);
        let (start, length) = (step.start(), step.end() - step.start());
        let mut parts = vec![];
        // The longest part comes first, so that positions at which halving does not help leave no other part unexamined.
        let mut waiting = VecDeque::from([Waiting { start, length, halvings: MOST_HALVINGS }]);
        let mut tried = 0;
        while let Some(part) = waiting.pop_front() {
            tried += 1;
            let is_last = part.halvings == 0 || tried > MOST_PARTS;
            let jet = self.jet(step, constants, part);
            let cut = match &jet {
                _ if is_last => None,
                Some(jet) => self.cut(jet, step, constants, part, allowed),
                None => self.has_values(step, constants, part).then_some(0.5),
            };
            match (cut, jet) {
                (Some(cut), _) => waiting.extend(part.cut_at(cut)),
                (None, Some(jet)) => {
                    let coefficients = match is_last && !self.agrees(&jet, step, constants, part, allowed) {
                        true => self.in_shortest_part(&jet, step, constants, part),
                        false => jet.result(0).to_vec(),
                    };
                    parts.push(Part { start: part.start, length: part.length, coefficients });
                }
                (None, None) => {}
            }
        }
        parts.put_in_order(|a, b| (a.start * length.signum()).total_cmp(&(b.start * length.signum())));
        parts
    }

    /// The position at which a part has to be cut in two; `None` if no cut is necessary.
    fn cut(
        &self,
        jet: &Jet<'_, Doubles>,
        step: &Step<'_>,
        constants: &[f64],
        part: Waiting,
        allowed: f64,
    ) -> Option<f64> {
        let turns = self.steep.iter().filter_map(|steep| steep.first_turn_of(jet.series(steep.of)));
        match turns.reduce(f64::min) {
            Some(turn) if turn < INSIDE => Some(turn),
            _ => (!self.agrees(jet, step, constants, part, allowed)).then_some(0.5),
        }
    }

    /// Returns `true` if the series agree with the formula in the states of the step, within rounding errors.
    fn agrees(
        &self,
        jet: &Jet<'_, Doubles>,
        step: &Step<'_>,
        constants: &[f64],
        part: Waiting,
        allowed: f64,
    ) -> bool {
        /// Largest effect of the rounding errors of the state, relative to the values elsewhere in the part: next to a pole it is larger.
        const POLE: f64 = 1e6;
        let series = jet.result(0);
        let (mut largest, mut others) = (series[0].abs(), 0.0);
        let mut worst = (0.0, part.start, 0.0);
        for look in looks() {
            let time = part.start + look * part.length;
            // The fraction is computed from the time, which is rounded.
            let look = (time - part.start) / part.length;
            let value = self.value(step, constants, time);
            let error = (value - series.iter().rev().fold(0.0, |sum, c| sum * look + c)).abs();
            largest = larger_or_nan(largest, value.abs());
            let looked = (error, time, value.abs());
            let other = if error <= worst.0 { looked } else { std::mem::replace(&mut worst, looked) };
            others = larger_or_nan(others, other.2);
        }
        let (error, time, _) = worst;
        let is_rounding = || {
            let rounding = self.rounding(step, constants, time, 1.0);
            error <= rounding && rounding <= POLE * others
        };
        largest.is_finite() && (error <= allowed * largest || is_rounding())
    }

    /// The effect on the formula of deviations of a state by this number of rounding errors.
    pub(in crate::taylor) fn rounding(
        &self,
        step: &Step<'_>,
        constants: &[f64],
        time: f64,
        errors: f64,
    ) -> f64 {
        let values = self.values_nearby(step, constants, time, errors);
        let value = values.first().copied().unwrap_or(0.0);
        0.5 * values.iter().map(|other| (other - value).abs()).sum::<f64>()
    }

    /// The values of the formula in a state and in states that deviate from it by this number of rounding errors in one component, those that
    /// exist: next to the end of its domain, a formula has values in some of them.
    fn values_nearby(&self, step: &Step<'_>, constants: &[f64], time: f64, errors: f64) -> Vec<f64> {
        let state = step.state_at(time);
        let moved = |number: usize, errors: f64| {
            let size: f64 = (0..step.terms)
                .scan(1.0, |power, n| {
                    let term = (step.coefficient(number, n) * *power).abs();
                    *power *= (time - step.start()) / step.unit;
                    Some(term)
                })
                .sum();
            let mut state = state.clone();
            state[number] += errors * ROUNDING * size;
            self.value_in(&state, time, constants)
        };
        let moves = (0..state.len()).flat_map(|number| [moved(number, errors), moved(number, -errors)]);
        let all = [self.value_in(&state, time, constants)].into_iter().chain(moves);
        all.filter(|value| value.is_finite()).collect()
    }

    /// The coefficients of a part that cannot be halved any more: those of a straight line, where the formula jumps or has a root, and none at a
    /// pole.
    fn in_shortest_part(
        &self,
        jet: &Jet<'_, Doubles>,
        step: &Step<'_>,
        constants: &[f64],
        part: Waiting,
    ) -> Vec<f64> {
        if self.has_pole(jet, step, constants, part) {
            return vec![];
        }
        let value = |time: f64| self.values_nearby(step, constants, time, SHIFTED).first().copied();
        match [value(part.start), value(part.start + part.length)] {
            [Some(first), Some(last)] => {
                let mut line = vec![0.0; step.terms];
                line[..2].copy_from_slice(&[first, last - first]);
                line
            }
            _ => jet.result(0).to_vec(),
        }
    }

    /// Returns `true` if the series do not represent the formula, and a pole lies in the part.
    fn has_pole(&self, jet: &Jet<'_, Doubles>, step: &Step<'_>, constants: &[f64], part: Waiting) -> bool {
        /// Difference of series and formula, relative to its values, from which they do not represent it.
        const NOTHING: f64 = 0.1;
        !self.agrees(jet, step, constants, part, NOTHING)
            && self.grows_towards(step, constants, [part.start, part.start + part.length])
    }

    /// Returns `true` if a contact at a time is a pole: series may agree with a formula whose value next to its pole is all rounding error.
    pub(in crate::taylor) fn has_pole_at(&self, step: &Step<'_>, constants: &[f64], time: f64) -> bool {
        let length = step.end() - step.start();
        let near = (SHORTEST_PART * length.abs()).max(4.0 * f64::EPSILON * time.abs()) * length.signum();
        self.ends && self.grows_towards(step, constants, [time - near, time + near])
    }

    /// Returns `true` if the values of the formula at both ends of a short time are much larger than at a distance of a million such times from
    /// them, which excludes a jump and a zero.
    fn grows_towards(&self, step: &Step<'_>, constants: &[f64], [start, end]: [f64; 2]) -> bool {
        /// Distance in short times: over it a pole of x^(-1/4) grows by `GROWTH`, and a weaker one is not recognised.
        const AWAY: f64 = 1e6;
        const GROWTH: f64 = 32.0;
        let [from, to] = [step.start(), step.end()];
        let value = |time: f64| self.value(step, constants, time.clamp(from.min(to), from.max(to))).abs();
        let length = end - start;
        let at_end = [start - from, to - end].map(|way| way.abs() <= length.abs());
        let sides = [(start, start - AWAY * length), (end, end + AWAY * length)];
        let grows = sides.map(|(near, far)| value(near) > GROWTH * value(far));
        (0..2).all(|side| grows[side] || at_end[side])
    }

    fn has_values(&self, step: &Step<'_>, constants: &[f64], part: Waiting) -> bool {
        let mut times = looks().map(|look| part.start + look * part.length).chain([part.start]);
        times.any(|time| self.value(step, constants, time).is_finite())
    }

    /// The value of the formula; NaN if it has none.
    fn value(&self, step: &Step<'_>, constants: &[f64], time: f64) -> f64 {
        self.value_in(&step.state_at(time), time, constants)
    }

    fn value_in(&self, state: &[f64], time: f64, constants: &[f64]) -> f64 {
        let inputs = [state, &[time], constants].concat();
        Jet::new(&Doubles, &self.tape, &inputs).map_or(f64::NAN, |jet| jet.result(0)[0])
    }

    /// The series of all slots in a part of a step; `None` if one has no value.
    fn jet(
        &self,
        step: &Step<'_>,
        constants: &[f64],
        Waiting { start, length, .. }: Waiting,
    ) -> Option<Jet<'_, Doubles>> {
        let states: Vec<Vec<f64>> =
            (0..step.numbers()).map(|number| moved(step, number, start, length)).collect();
        let coefficient = |n: usize| {
            let time = [start, length].get(n).copied().unwrap_or(0.0);
            let fixed = constants.iter().map(|value| if n == 0 { *value } else { 0.0 });
            states.iter().map(|series| series[n]).chain([time]).chain(fixed).collect::<Vec<f64>>()
        };
        let mut jet = Jet::new(&Doubles, &self.tape, &coefficient(0)).ok()?;
        for n in 1..step.terms {
            jet.extend(&coefficient(n)).ok()?;
        }
        jet.result(0).iter().all(|c| c.is_finite()).then_some(jet)
    }
}

impl Waiting {
    fn cut_at(self, cut: f64) -> [Self; 2] {
        let (length, halvings) = (cut * self.length, self.halvings - 1);
        let second = Self { start: self.start + length, length: self.length - length, halvings };
        [Self { length, halvings, ..self }, second]
    }
}

/// Positions in a part at which its series are compared with the formula.
fn looks() -> impl Iterator<Item = f64> {
    const LOOKS: u32 = 8;
    (1..=LOOKS).map(|look| f64::from(look) / f64::from(LOOKS))
}

/// A state component as a series in powers of the fraction of a part of the step.
fn moved(step: &Step<'_>, number: usize, start: f64, length: f64) -> Vec<f64> {
    let mut series: Vec<f64> = (0..step.terms).map(|n| step.coefficient(number, n)).collect();
    let shift = (start - step.start()) / step.unit;
    for first in 0..series.len() {
        for n in (first..series.len() - 1).rev() {
            series[n] += shift * series[n + 1];
        }
    }
    // Next to a pole the rounding errors of these sums are not negligible.
    series[0] = step.component_at(number, start).to_f64();
    scaled(series.into_iter(), length / step.unit)
}
