//! A tape evaluated on power series, one order after the other.
//!
//! # Method
//! A formula becomes a tape (`tape.rs`): a list of elementary operations without repetitions. A jet holds the power series of every position of
//! the tape, over any `Ring`, and appends one coefficient after the other by the recurrence of each operation (`series/recurrences.rs`), which
//! is written once. The last coefficients of all positions depend linearly on the last ones of the inputs; the factors are the first
//! coefficients of another jet (`Jet::gains`). An unknown coefficient can therefore be left out, solved for, and inserted (`Jet::amend`): in
//! this way the same tape solves for a motion.

use super::instruction::{Evaluator, Instruction, Value, Weighted};
use super::tape::{Operation, Tape};
use crate::algebra::{Rational, Ring};

/// Reason why a formula has no series: an operation has no value in the ring, or is not analytic at the point of evaluation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SeriesError {
    /// The index of the operation on the tape.
    pub(crate) position: usize,
}

/// The first coefficients of every result on a tape.
#[derive(Debug)]
pub struct Jet<'a, R: Ring> {
    ring: &'a R,
    tape: &'a Tape,
    places: Vec<Series<R::Element>>,
}

/// The coefficients of one position, and n times them if a later operation needs these.
#[derive(Clone, Debug)]
struct Series<E> {
    plain: Vec<E>,
    weighted: Vec<E>,
}

impl<'a, R: Ring> Jet<'a, R> {
    /// A jet with the values at these zeroth coefficients of the inputs.
    pub fn new(ring: &'a R, tape: &'a Tape, inputs: &[R::Element]) -> Result<Self, SeriesError> {
        let mut jet = Self::empty(ring, tape);
        jet.restart(inputs)?;
        Ok(jet)
    }

    /// Restarts with other zeroth coefficients, in the same memory.
    pub fn restart(&mut self, inputs: &[R::Element]) -> Result<(), SeriesError> {
        for position in 0..self.places.len() {
            let keep = usize::from(self.tape.is_constant(position));
            self.places[position].plain.truncate(keep);
            self.places[position].weighted.truncate(keep);
            if self.places[position].plain.is_empty() {
                let value = self.value(position, inputs).ok_or(SeriesError { position })?;
                self.push(position, value);
            }
        }
        Ok(())
    }

    /// A jet with zeroth coefficients that were computed elsewhere, one for each position of the tape.
    pub fn with_values(ring: &'a R, tape: &'a Tape, values: Vec<R::Element>) -> Self {
        let mut jet = Self::empty(ring, tape);
        for (position, value) in values.into_iter().enumerate() {
            jet.push(position, value);
        }
        jet
    }

    fn empty(ring: &'a R, tape: &'a Tape) -> Self {
        let none = Series { plain: vec![], weighted: vec![] };
        Self { ring, tape, places: vec![none; tape.operations().len()] }
    }

    /// The coefficients of a formula, by its index.
    pub fn result(&self, formula: usize) -> &[R::Element] {
        &self.places[self.tape.results()[formula]].plain
    }

    /// The coefficients at a position of the tape.
    pub fn series(&self, position: usize) -> &[R::Element] {
        &self.places[position].plain
    }

    /// The zeroth coefficients at all positions.
    pub fn values(&self) -> impl Iterator<Item = &R::Element> {
        self.places.iter().map(|series| &series.plain[0])
    }

    /// Appends the next coefficient at every position, given those of the inputs.
    pub fn extend(&mut self, inputs: &[R::Element]) -> Result<(), SeriesError> {
        for position in 0..self.places.len() {
            let value = self.coefficient(position, inputs).ok_or(SeriesError { position })?;
            self.push(position, value);
        }
        Ok(())
    }

    /// Removes the last coefficients.
    pub fn shorten(&mut self) {
        for series in &mut self.places {
            series.plain.pop();
            series.weighted.pop();
        }
    }

    /// Derivatives of the last coefficients at all positions with respect to that of one input, from the first order on, where the dependence is
    /// linear.
    pub fn gains(&self, input: usize) -> Result<Vec<R::Element>, SeriesError> {
        let values = self.values().cloned().collect();
        let mut jet = Self::with_values(self.ring, self.tape, values);
        let one = self.ring.rational(&1.into()).ok_or(SeriesError { position: 0 })?;
        let seed = |n: usize| if n == input { one.clone() } else { self.ring.zero() };
        jet.extend(&(0..self.tape.inputs()).map(seed).collect::<Vec<_>>())?;
        Ok(jet.places.into_iter().map(|mut series| series.plain.swap_remove(1)).collect())
    }

    /// Adds to the last coefficient of an input, and updates the coefficient at every position.
    pub fn amend(&mut self, gains: &[R::Element], change: &R::Element) {
        if self.ring.is_zero(change) {
            return;
        }
        for (position, gain) in gains.iter().enumerate().filter(|(_, gain)| !self.ring.is_zero(gain)) {
            let last = self.places[position].plain.pop().expect("a jet has its zeroth coefficients");
            self.places[position].weighted.pop();
            let amended = self.ring.add(&last, &self.ring.multiply(gain, change));
            self.push(position, amended);
        }
    }

    fn push(&mut self, position: usize, value: R::Element) {
        let series = &mut self.places[position];
        if self.tape.is_weighted(position) {
            let order = i64::try_from(series.plain.len()).unwrap_or(i64::MAX);
            series.weighted.push(self.ring.times_integer(&value, order));
        }
        series.plain.push(value);
    }

    fn value(&self, position: usize, inputs: &[R::Element]) -> Option<R::Element> {
        match self.tape.operations()[position] {
            Operation::Input(number) => inputs.get(number).cloned(),
            Operation::Number(ref value) => self.ring.rational(value),
            Operation::Pi => self.ring.pi(),
            ref other => Value::new(other, plain, |exponent| exponent)?.evaluate(self),
        }
    }

    /// The next coefficient at a position, from those of the operands.
    fn coefficient(&self, position: usize, inputs: &[R::Element]) -> Option<R::Element> {
        if self.tape.is_constant(position) {
            return Some(self.ring.zero());
        }
        let operation = &self.tape.operations()[position];
        if let Operation::Input(number) = *operation {
            return inputs.get(number).cloned();
        }
        let rows = |operand: usize| Weighted {
            plain: plain(operand),
            weighted: SeriesRow { position: operand, weighted: true },
        };
        let degree = |operand: usize| if self.tape.is_constant(operand) { 0 } else { usize::MAX };
        let instruction = Instruction::new(operation, position, rows, |_| None, degree, |exponent| exponent)?;
        instruction.evaluate(self, self.places[position].plain.len()).map(|(_, value)| value)
    }
}

/// The coefficients at one position, plain or weighted.
#[derive(Clone, Copy, Debug)]
struct SeriesRow {
    position: usize,
    weighted: bool,
}

fn plain(position: usize) -> SeriesRow {
    SeriesRow { position, weighted: false }
}

impl<R: Ring> Evaluator<SeriesRow, &Rational> for Jet<'_, R> {
    type Ring = R;

    fn ring(&self) -> &R {
        self.ring
    }

    fn row(&self, SeriesRow { position, weighted }: SeriesRow) -> &[R::Element] {
        let series = &self.places[position];
        if weighted { &series.weighted } else { &series.plain }
    }

    fn exponent(&self, exponent: &&Rational) -> Option<R::Element> {
        self.ring.rational(exponent)
    }

    fn power(&self, base: &R::Element, exponent: &&Rational) -> Option<R::Element> {
        self.ring.power(base, exponent)
    }

    fn begins_beyond(&self, exponent: &&Rational, n: usize) -> bool {
        let begins = exponent.to_natural();
        begins.is_some_and(|begins| u64::try_from(n).is_ok_and(|n| n < begins))
    }

    /// An integer power of a series without constant term begins at the order of that power; other powers have no series there.
    fn over_base(&self, value: &R::Element, base: &R::Element, begins_later: bool) -> Option<R::Element> {
        if self.ring.is_zero(base) {
            return begins_later.then(|| self.ring.zero());
        }
        self.ring.divide(value, base)
    }
}
