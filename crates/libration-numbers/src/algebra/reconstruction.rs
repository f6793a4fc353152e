//! Fractions from their residues modulo many primes.
//!
//! # Method
//! The same code runs modulo eight primes of 30 bits at once, one in each lane of a vector unit (`prime_fields.rs`); products are added in words
//! of 64 bits and reduced once. A sum of harmonics is represented by its values at roots of unity, so that products are pointwise
//! (`sampled_harmonics.rs`). Only the part of the circle that is not repeated by the symmetry of the motion is sampled.
//!
//! Numbers are recovered from their residues in mixed radix, eight at once (`mixed_radix.rs`), order by order. The common denominator of an
//! order is expected to grow as in the orders before (`expected_denominators.rs`). Multiplied by that denominator, the numbers are small
//! integers, whose last digits vanish; five of these digits belong to primes that did not contribute to the result. Euclid's algorithm gives the
//! few factors that were not expected.
//!
//! The number of primes therefore depends only on the bits of the numerators over the common denominator of their order. For the pendulum to
//! order 101 these are 559 of 735 bits, whereas a single fraction needs 1284. The cost is about N³ operations per prime, with about N/3 primes
//! for series in the amplitude. Coefficients of low orders need few primes, so that a cancelled expansion keeps those that are already certain.

use std::collections::BTreeMap;

use super::expected_denominators::{Common, DenominatorGrowth};
use super::mixed_radix::MixedRadix;
use super::{LANES, PrimeFields, Rational, Residues};

/// A computation that can be done modulo any prime except a few bad ones.
pub trait Images {
    /// Reason why the computation may end without a result.
    type Error;

    /// The results as residues of `fields`; `None` if one of the primes is bad.
    fn image(&mut self, fields: &PrimeFields) -> Result<Option<Vec<Residues>>, Self::Error>;

    /// Order and family of each number; called after the first image.
    fn places(&self) -> Vec<Place>;

    /// Receives the number of primes while fractions are reconstructed; an error ends the reconstruction.
    fn go_on(&mut self, _primes: usize) -> Result<(), Self::Error> {
        Ok(())
    }
}

/// Order and family of a number. Numbers of one order and family have similar denominators, which grow from order to order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    pub order: usize,
    pub family: usize,
}

/// A computation that ended early.
#[derive(Debug)]
pub struct Stopped<E> {
    pub error: E,
    /// The numbers of the lowest orders, with zeros for the higher ones, and the highest of these orders; `None` if no order was certain.
    pub certain: Option<(Vec<Rational>, usize)>,
}

/// Reconstructs the numbers from their images: primes are added until the fractions agree with primes that did not contribute to them.
///
/// This is not a proof: a wrong result would have to agree with five additional primes of 30 bits.
pub fn reconstruct<I: Images>(
    images: &mut I,
    mut primes: impl Iterator<Item = u32>,
) -> Result<Option<Vec<Rational>>, Stopped<I::Error>> {
    let mut fractions: Option<Fractions> = None;
    while let Some(fields) = next_fields(&mut primes) {
        let image = match images.image(&fields) {
            Ok(Some(image)) => image,
            Ok(None) => continue,
            Err(error) => {
                return Err(Stopped { error, certain: fractions.and_then(Fractions::of_low_orders) });
            }
        };
        let numbers = fractions.get_or_insert_with(|| Fractions::new(&images.places()));
        numbers.push(&fields, &image);
        match numbers.advance(images) {
            Ok(true) => return Ok(fractions.map(|solved| solved.numbers)),
            Ok(false) => {}
            Err(error) => {
                return Err(Stopped { error, certain: fractions.and_then(Fractions::of_low_orders) });
            }
        }
    }
    Ok(None)
}

fn next_fields(primes: &mut impl Iterator<Item = u32>) -> Option<PrimeFields> {
    let mut next = [0; LANES];
    for prime in &mut next {
        *prime = primes.next()?;
    }
    Some(PrimeFields::new(next))
}

/// The images so far, and the fractions that they determine, order by order.
#[derive(Debug)]
struct Fractions {
    radix: MixedRadix,
    /// The residues of each number; `None` as long as all are zero.
    residues: Vec<Option<Vec<Residues>>>,
    steps: Vec<(Place, Vec<usize>)>,
    /// Number of completed steps.
    done: usize,
    numbers: Vec<Rational>,
    /// The growth of the denominators in each family.
    denominators: BTreeMap<usize, DenominatorGrowth>,
}

impl Fractions {
    fn new(positions: &[Place]) -> Self {
        let mut steps: BTreeMap<Place, Vec<usize>> = BTreeMap::new();
        for (at, &position) in positions.iter().enumerate() {
            steps.entry(position).or_default().push(at);
        }
        Self {
            radix: MixedRadix::default(),
            residues: vec![None; positions.len()],
            steps: steps.into_iter().collect(),
            done: 0,
            numbers: vec![Rational::from(0); positions.len()],
            denominators: BTreeMap::new(),
        }
    }

    fn push(&mut self, fields: &PrimeFields, image: &[Residues]) {
        let groups = self.radix.len() / LANES;
        for (list, residue) in self.residues.iter_mut().zip(image) {
            if list.is_some() || *residue != [0; LANES] {
                list.get_or_insert_with(|| vec![[0; LANES]; groups]).push(*residue);
            }
        }
        fields.primes().into_iter().for_each(|prime| self.radix.push(prime));
    }

    /// Continues as far as the primes suffice; returns `true` when all numbers are reconstructed.
    fn advance<I: Images>(&mut self, images: &mut I) -> Result<bool, I::Error> {
        while self.done < self.steps.len() {
            images.go_on(self.radix.len())?;
            if self.solve_next().is_none() {
                return Ok(false);
            }
            self.done += 1;
        }
        Ok(true)
    }

    /// Reconstructs the numbers of the next step; `None` if they need more primes.
    fn solve_next(&mut self) -> Option<()> {
        let (position, wanted) = &self.steps[self.done];
        let present: Vec<usize> = wanted.iter().copied().filter(|&at| self.residues[at].is_some()).collect();
        if present.is_empty() {
            return Some(());
        }
        let growth = self.denominators.entry(position.family).or_default();
        let mut common = Common::new(&self.radix, growth.expected());
        for some in present.chunks(LANES) {
            let some: Vec<(usize, &[Residues])> =
                some.iter().filter_map(|&at| Some((at, self.residues[at].as_deref()?))).collect();
            let lists: Vec<&[Residues]> = some.iter().map(|&(_, list)| list).collect();
            for ((at, _), fraction) in some.iter().zip(common.fractions(&lists)?) {
                self.numbers[*at] = fraction;
            }
        }
        growth.push(common.least());
        Some(())
    }

    /// The numbers that are certain, and the highest order that is complete.
    fn of_low_orders(self) -> Option<(Vec<Rational>, usize)> {
        let complete = match self.steps.get(self.done) {
            Some((position, _)) => position.order.checked_sub(1)?,
            None => self.steps.last()?.0.order,
        };
        let mut numbers = self.numbers;
        for (position, at) in
            self.steps.iter().flat_map(|(position, all)| all.iter().map(move |&at| (position, at)))
        {
            if position.order > complete {
                numbers[at] = Rational::from(0);
            }
        }
        Some((numbers, complete))
    }
}
