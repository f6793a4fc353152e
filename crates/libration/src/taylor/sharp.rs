//! Formulas of events that change by powers of ten within a step.
//!
//! Steps are as long as the accelerations allow. Of e^(−20000(x − 2)²) they show nothing from where x is 3, and what they show from
//! where x is 2 holds for the part of a step only. So the series of such a formula are made anew for parts of the step, which end where
//! what is steep turns, and are halved until the series are what the formula says of the state.

use super::Step;
use super::boundary::reached;
use super::steep::{Steep, steep_places};
use crate::algebra::Doubles;
use crate::expression::{Expression, Jet, Operation, Symbol, Tape};

/// A formula in which something is steep.
#[derive(Clone, Debug)]
pub(super) struct SharpFormula {
    tape: Tape,
    steep: Vec<Steep<usize>>,
}

/// A part of a step.
pub(super) struct Part {
    pub(super) start: f64,
    pub(super) length: f64,
    /// Of the formula, in powers of the part of this part.
    pub(super) coefficients: Vec<f64>,
}

/// Powers beyond the third part of this order are steep.
const ORDER: usize = 18;
/// Halvings after which a part is taken as it is: there the formula jumps or has no value.
const MOST_HALVINGS: u32 = 40;
/// Parts that are looked at before the rest is taken as it is. A formula that is felt in a part 2⁻⁴⁰ of a step needs about 80.
const MOST_PARTS: usize = 2000;
/// By this part of the largest of its values the series of a formula may differ from it.
const MISFIT: f64 = 1e-9;
/// A part that ends at a turn has it next to its end.
const INSIDE: f64 = 0.999;

impl SharpFormula {
    /// `None` for what the series of whole steps show.
    pub(super) fn new(formula: &Expression, inputs: &[Symbol]) -> Option<Self> {
        let tape = Tape::new(&[formula], inputs).ok()?;
        let mut steep = steep_places(&tape, 1, ORDER);
        let divisors = reached(&tape, 1).into_iter().filter_map(|place| match tape.operations()[place] {
            Operation::Divide(_, divisor) if !tape.is_constant(divisor) => Some(Steep::divisor(divisor)),
            _ => None,
        });
        steep.extend(divisors);
        (!steep.is_empty()).then_some(Self { tape, steep })
    }

    /// The step in parts in which the formula is its series. Where it has no value in double precision there are none.
    pub(super) fn parts(&self, step: &Step<'_>, parameters: &[f64]) -> Vec<Part> {
        let mut parts = vec![];
        let mut waiting = vec![((step.start(), step.end() - step.start()), MOST_HALVINGS)];
        let mut tried = 0;
        while let Some((part, halvings)) = waiting.pop() {
            tried += 1;
            let jet = self.jet(step, parameters, part);
            let cut = match &jet {
                _ if halvings == 0 || tried > MOST_PARTS => None,
                Some(jet) => self.cut(jet, step, parameters, part),
                None => self.has_values(step, parameters, part).then_some(0.5),
            };
            let (start, length) = part;
            match (cut, jet) {
                (Some(cut), _) => {
                    waiting.push(((start + cut * length, (1.0 - cut) * length), halvings - 1));
                    waiting.push(((start, cut * length), halvings - 1));
                }
                (None, Some(jet)) => parts.push(Part { start, length, coefficients: jet.result(0).to_vec() }),
                (None, None) => {}
            }
        }
        parts
    }

    /// Where a part has to be cut in two.
    fn cut(
        &self,
        jet: &Jet<'_, Doubles>,
        step: &Step<'_>,
        parameters: &[f64],
        part: (f64, f64),
    ) -> Option<f64> {
        let turns = self.steep.iter().filter_map(|steep| steep.first_turn_of(jet.series(steep.of)));
        match turns.reduce(f64::min) {
            Some(turn) if turn < INSIDE => Some(turn),
            _ => (!self.agrees(jet, step, parameters, part)).then_some(0.5),
        }
    }

    /// Whether the series are what the formula says of the state.
    fn agrees(&self, jet: &Jet<'_, Doubles>, step: &Step<'_>, parameters: &[f64], part: (f64, f64)) -> bool {
        let series = jet.result(0);
        let pairs: Vec<(f64, f64)> = looks()
            .map(|look| {
                let own = series.iter().rev().fold(0.0, |sum, c| sum * look + c);
                (self.value(step, parameters, part.0 + look * part.1), own)
            })
            .collect();
        let largest = pairs.iter().map(|(value, _)| value.abs()).fold(series[0].abs(), f64::max);
        largest.is_finite() && pairs.iter().all(|(value, own)| (value - own).abs() <= MISFIT * largest)
    }

    fn has_values(&self, step: &Step<'_>, parameters: &[f64], part: (f64, f64)) -> bool {
        let mut times = looks().map(|look| part.0 + look * part.1).chain([part.0]);
        times.any(|time| self.value(step, parameters, time).is_finite())
    }

    /// The formula itself; NaN where it has no value.
    fn value(&self, step: &Step<'_>, parameters: &[f64], time: f64) -> f64 {
        let inputs = [&step.state_at(time)[..], &[time], parameters].concat();
        Jet::new(&Doubles, &self.tape, &inputs).map_or(f64::NAN, |jet| jet.result(0)[0])
    }

    /// The series of all places in a part of a step; `None` where one has no value.
    fn jet(
        &self,
        step: &Step<'_>,
        parameters: &[f64],
        (start, length): (f64, f64),
    ) -> Option<Jet<'_, Doubles>> {
        let states: Vec<Vec<f64>> =
            (0..step.numbers()).map(|number| moved(step, number, start, length)).collect();
        let coefficient = |n: usize| {
            let time = [start, length].get(n).copied().unwrap_or(0.0);
            let constants = parameters.iter().map(|value| if n == 0 { *value } else { 0.0 });
            states.iter().map(|series| series[n]).chain([time]).chain(constants).collect::<Vec<f64>>()
        };
        let mut jet = Jet::new(&Doubles, &self.tape, &coefficient(0)).ok()?;
        for n in 1..step.terms {
            jet.extend(&coefficient(n)).ok()?;
        }
        jet.result(0).iter().all(|c| c.is_finite()).then_some(jet)
    }
}

/// Places in a part at which its series are compared with the formula.
fn looks() -> impl Iterator<Item = f64> {
    const LOOKS: u32 = 8;
    (1..=LOOKS).map(|look| f64::from(look) / f64::from(LOOKS))
}

/// A number of the state in powers of a part of the step.
fn moved(step: &Step<'_>, number: usize, start: f64, length: f64) -> Vec<f64> {
    let mut series: Vec<f64> = (0..step.terms).map(|n| step.coefficient(number, n)).collect();
    let shift = (start - step.start()) / step.unit;
    for first in 0..series.len() {
        for n in (first..series.len() - 1).rev() {
            series[n] += shift * series[n + 1];
        }
    }
    super::sign_change::scaled(series.into_iter(), length / step.unit)
}
