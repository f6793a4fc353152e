//! The errors of a motion as a list of numbers, from which a run is continued.

use super::matrix::Matrix;
use super::pieces::Middle;
use super::roundings_of_steps::RoundedStep;
use super::spread::Spread;
use super::state_errors::StateErrors;
use crate::taylor::{Effort, Moment, System};

impl StateErrors {
    /// All values that are passed from step to step; for a motion that is no longer determined, the values of the last determined state.
    #[must_use]
    pub fn to_numbers(&self) -> Vec<f64> {
        let mut numbers = vec![self.reached];
        if self.is_lost {
            numbers.extend(&self.spreads[0].flow.entries);
            return numbers;
        }
        numbers.push(self.steps);
        numbers.extend(&self.scales);
        push_spread(&mut numbers, &self.spreads[1]);
        if let Some(middle) = self.pieces.as_ref().and_then(|pieces| pieces.last.as_ref()) {
            push_spread(&mut numbers, &middle.spread);
            let RoundedStep { middle: moment, errors, unseen, length, rates, signs } = &middle.step;
            numbers.extend([moment.time, *length]);
            let lists = [&moment.state, errors, unseen, rates, &middle.added, &middle.ways];
            lists.into_iter().chain(&middle.rates).for_each(|list| numbers.extend(list));
            [signs, &middle.signs].into_iter().for_each(|list| numbers.extend(list));
        }
        numbers
    }

    /// The errors of a motion from this start that is continued; `None` if the numbers do not belong to such a motion.
    #[must_use]
    pub fn resumed(system: &System, start: &Moment, effort: &Effort, numbers: &[f64]) -> Option<Self> {
        let mut errors = Self::new(system, start, effort);
        let mut kept = Kept { numbers, size: system.layout().numbers() };
        errors.reached = kept.one()?;
        if kept.numbers.len() == kept.size * kept.size {
            errors.is_lost = true;
            errors.spreads[0].flow = kept.matrix()?;
            return Some(errors);
        }
        errors.steps = kept.one()?;
        errors.scales = kept.list(kept.size)?;
        errors.spreads[1] = kept.spread()?;
        errors.keep_bounds();
        if !kept.numbers.is_empty() {
            let middle = kept.middle(system)?;
            errors.pieces.as_mut()?.last = Some(middle);
        }
        kept.numbers.is_empty().then_some(errors)
    }
}

fn push_spread(numbers: &mut Vec<f64>, spread: &Spread) {
    numbers.extend(spread.units.iter().map(|unit| f64::from(*unit)));
    numbers.extend(&spread.squares.entries);
    numbers.extend(&spread.flow.entries);
}

/// The numbers that have not been read yet.
struct Kept<'a> {
    numbers: &'a [f64],
    /// Number of state components.
    size: usize,
}

impl Kept<'_> {
    fn one(&mut self) -> Option<f64> {
        let (first, rest) = self.numbers.split_first()?;
        self.numbers = rest;
        Some(*first)
    }

    fn list(&mut self, count: usize) -> Option<Vec<f64>> {
        let (first, rest) = self.numbers.split_at_checked(count)?;
        self.numbers = rest;
        Some(first.to_vec())
    }

    fn matrix(&mut self) -> Option<Matrix> {
        let size = self.size;
        Some(Matrix { size, entries: self.list(size * size)? })
    }

    fn spread(&mut self) -> Option<Spread> {
        #[expect(clippy::cast_possible_truncation, reason = "the limits are far inside the range of i32")]
        let unit = |unit: f64| unit.clamp(-1e6, 1e6) as i32;
        let units = self.list(self.size)?.into_iter().map(unit).collect();
        let mut spread = Spread::none(self.size);
        (spread.units, spread.squares, spread.flow) = (units, self.matrix()?, self.matrix()?);
        Some(spread)
    }

    fn middle(&mut self, system: &System) -> Option<Middle> {
        let (size, moduli) = (self.size, system.moduli());
        let spread = self.spread()?;
        let (time, length) = (self.one()?, self.one()?);
        let mut list = || self.list(size);
        let [state, errors, unseen, rates] = [list()?, list()?, list()?, list()?];
        let [added, ways, first, last] = [list()?, list()?, list()?, list()?];
        let (own_signs, signs) = (self.list(moduli)?, self.list(moduli)?);
        let step =
            RoundedStep { middle: Moment { time, state }, errors, unseen, length, rates, signs: own_signs };
        let stuck = Middle::stuck(system, &signs);
        Some(Middle { step, spread, added, stuck, signs, rates: [first, last], ways })
    }
}
