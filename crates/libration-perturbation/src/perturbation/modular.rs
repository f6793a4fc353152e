//! A model's series in exact fractions, put together from its series modulo primes.
//!
//! # Method
//! Fractions of hundreds of digits are not added. The expansion runs modulo eight primes at once, and its fractions are reconstructed order by
//! order (`algebra/reconstruction.rs`).

use super::gauge::Gauge;
use super::model::{Model, Motion};
use super::series_set::SeriesSet;

use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Stage;
use libration_numbers::{
    algebra::{Rational, Ring},
    internals::algebra::{
        Images, Place, PrimeField, PrimeFields, Residues, SampledHarmonics, Stopped, Symmetry,
        primes_with_roots, reconstruct,
    },
};

/// More primes than any order that is allowed needs.
const MOST_PRIMES: usize = 8000;

/// The exact series, from their values modulo as many primes as are needed.
pub fn exact_series(model: &Model<Rational>, watch: &Watch<'_>) -> Result<SeriesSet<Rational>, Unsolved> {
    let mut images = ModelImages { model, symmetry: symmetry(model), watch, done: 0, bad: 0, shape: None };
    let points = SampledHarmonics::period(model.highest_harmonic());
    // Only half of all primes have such a root.
    let squares: Vec<&Rational> = model.irrational_roots().collect();
    let has_roots =
        |&prime: &u32| squares.iter().all(|square| root(&PrimeField::new(prime), square).is_some());
    let primes = primes_with_roots(points.trailing_zeros()).take(MOST_PRIMES).filter(has_roots);
    let numbers = match reconstruct(&mut images, primes) {
        Ok(numbers) => numbers.ok_or(Unsolved::NoPrimes)?,
        Err(Stopped { error: NoImage::NoPrimes, .. }) => return Err(Unsolved::NoPrimes),
        Err(Stopped { error: NoImage::Interrupted, certain }) => {
            let confirmed = images.shape.zip(certain).and_then(|(shape, (numbers, complete))| {
                let set = shape.with_numbers(numbers.into_iter())?.without_last(model.order - complete);
                (complete > 0).then_some(set)
            });
            return Err(Unsolved::Interrupted(confirmed.map(Box::new)));
        }
    };
    let set = images.shape.and_then(|shape| shape.with_numbers(numbers.into_iter()));
    set.ok_or(Unsolved::NoPrimes)
}

/// The reason why there are no exact series.
#[derive(Clone, Debug)]
pub enum Unsolved {
    /// Cancelled when these series were certain.
    Interrupted(Option<Box<SeriesSet<Rational>>>),
    /// The computation failed modulo every prime that was tried.
    NoPrimes,
}

/// The symmetry of a model: x is unchanged by a phase shift of half a turn with the opposite sign of ε, unless an even Aₙ breaks this.
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

/// Number of successive groups of primes without an image after which the reason is not the primes.
const MOST_BAD_GROUPS: usize = 8;

/// The reason why there is no image.
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
    /// The set modulo the first primes, for the lengths of its lists.
    shape: Option<SeriesSet<Residues>>,
}

impl Images for ModelImages<'_> {
    type Error = NoImage;

    fn image(&mut self, fields: &PrimeFields) -> Result<Option<Vec<Residues>>, NoImage> {
        self.watch.begin(Stage::Prime { done: self.done }, Some(self.model.order));
        let degree = self.model.highest_harmonic();
        let set = SampledHarmonics::new(fields.clone(), degree, self.symmetry).and_then(|ring| {
            self.model.series(
                &ring,
                |number| fields.rational(number),
                |square| fields.in_each(|field| root(field, square)),
                self.watch,
            )
        });
        if self.watch.is_stopped() {
            return Err(NoImage::Interrupted);
        }
        let Some(set) = set else {
            self.bad += 1;
            return if self.bad > MOST_BAD_GROUPS { Err(NoImage::NoPrimes) } else { Ok(None) };
        };
        (self.bad, self.done) = (0, self.done + fields.primes().len());
        let numbers = set.numbers();
        self.shape.get_or_insert(set);
        Ok(Some(numbers))
    }

    fn places(&self) -> Vec<Place> {
        self.shape.as_ref().map_or_else(Vec::new, |shape| shape.places(self.model.order))
    }

    fn go_on(&mut self, primes: usize) -> Result<(), NoImage> {
        self.watch.begin(Stage::Fractions { primes }, None);
        self.watch.go_on().map_err(|_| NoImage::Interrupted)
    }
}

/// The root itself if it is a fraction, otherwise one of the two in the field.
fn root(field: &PrimeField, square: &Rational) -> Option<u32> {
    match square.square_root() {
        Some(root) => field.fraction(&root),
        None => field.square_root(field.fraction(square)?),
    }
}
