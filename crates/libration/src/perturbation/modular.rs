//! A model's series in exact fractions, put together from its series modulo primes.

use super::gauge::Gauge;
use super::model::{Model, Motion};
use super::series_set::SeriesSet;

use crate::algebra::{
    Images, PrimeField, Rational, Ring, SampledHarmonics, Stopped, Symmetry, primes_with_roots, reconstruct,
};
use crate::watch::{Stage, Watch};

/// Roots of unity of order 2²⁰ are in every field used, enough for half a million harmonics.
const LOG_ROOTS: u32 = 20;

/// More primes than any order that is allowed needs.
const MOST_PRIMES: usize = 4000;

/// The series modulo as many primes as it takes.
pub(crate) fn exact_series(
    model: &Model<Rational>,
    watch: &Watch<'_>,
) -> Result<SeriesSet<Rational>, Unsolved> {
    let mut images = ModelImages { model, symmetry: symmetry(model), watch, done: 0, bad: 0, shape: None };
    let numbers = match reconstruct(&mut images, primes_with_roots(LOG_ROOTS).take(MOST_PRIMES)) {
        Ok(numbers) => numbers.ok_or(Unsolved::NoPrimes)?,
        Err(Stopped { error: NoImage::NoPrimes, .. }) => return Err(Unsolved::NoPrimes),
        Err(Stopped { error: NoImage::Interrupted, residues }) => {
            let known = images.shape.and_then(|shape| {
                let (numbers, complete) = residues.of_low_orders(&shape.orders(model.order))?;
                let set = shape.with_numbers(numbers.into_iter())?.without_last(model.order - complete);
                (complete > 0).then_some(set)
            });
            return Err(Unsolved::Interrupted(known.map(Box::new)));
        }
    };
    let set = images.shape.and_then(|shape| shape.with_numbers(numbers.into_iter()));
    set.ok_or(Unsolved::NoPrimes)
}

/// Why there are no exact series.
#[derive(Clone, Debug)]
pub(crate) enum Unsolved {
    /// It was interrupted, when these were certain.
    Interrupted(Option<Box<SeriesSet<Rational>>>),
    /// The computation failed modulo every prime that was tried.
    NoPrimes,
}

/// With the phase shifted by half a turn and ε by its sign, x is the same unless an even Aₙ breaks the symmetry.
fn symmetry(model: &Model<Rational>) -> Symmetry {
    match &model.motion {
        Motion::Centre { gauge: Gauge::Coefficients(list), .. } => Symmetry {
            even_in_phase: !model.uses_velocity,
            half_wave: list.iter().skip(1).step_by(2).all(Rational::is_zero),
        },
        Motion::Centre { .. } => Symmetry { even_in_phase: !model.uses_velocity, half_wave: true },
        Motion::LimitCycle(selected) => Symmetry { even_in_phase: false, half_wave: selected.symmetric },
    }
}

/// After this many primes in a row without an image it is not the primes that are bad.
const MOST_BAD_PRIMES: usize = 64;

/// Why there is no image.
enum NoImage {
    Interrupted,
    NoPrimes,
}

struct ModelImages<'a> {
    model: &'a Model<Rational>,
    symmetry: Symmetry,
    watch: &'a Watch<'a>,
    done: usize,
    bad: usize,
    /// The set of the first prime, for the lengths of its lists.
    shape: Option<SeriesSet<u64>>,
}

impl Images for ModelImages<'_> {
    type Error = NoImage;

    fn image(&mut self, field: &PrimeField) -> Result<Option<Vec<u64>>, NoImage> {
        self.watch.begin(Stage::Prime { done: self.done }, Some(self.model.order));
        let degree = self.model.highest_harmonic();
        let set = SampledHarmonics::new(field.clone(), degree, self.symmetry).and_then(|ring| {
            self.model.series(
                &ring,
                |number| field.rational(number),
                |square| root(field, square),
                self.watch,
            )
        });
        if self.watch.is_stopped() {
            return Err(NoImage::Interrupted);
        }
        let Some(set) = set else {
            self.bad += 1;
            return if self.bad > MOST_BAD_PRIMES { Err(NoImage::NoPrimes) } else { Ok(None) };
        };
        (self.bad, self.done) = (0, self.done + 1);
        let numbers = set.numbers();
        self.shape.get_or_insert(set);
        Ok(Some(numbers))
    }

    fn go_on(&mut self, primes: usize) -> Result<(), NoImage> {
        self.watch.begin(Stage::Fractions { primes }, None);
        self.watch.go_on().map_err(|_| NoImage::Interrupted)
    }
}

/// The root itself where it is a fraction, else one of the two in the field.
fn root(field: &PrimeField, square: &Rational) -> Option<u64> {
    match square.square_root() {
        Some(root) => field.rational(&root),
        None => field.square_root(field.rational(square)?),
    }
}
