//! Loops over values at points of a circle, modulo eight primes at once.

use super::prime_fields::{LANES, PRODUCTS, PrimeLanes, Residues, Sums, accumulated};
use libration_kernels::dispatch::Kernel;

/// aⱼ·bⱼ.
pub(super) struct Pointwise<'a> {
    pub(super) lanes: &'a PrimeLanes,
    pub(super) a: &'a [Residues],
    pub(super) b: &'a [Residues],
}

impl Kernel for Pointwise<'_> {
    type Output = Vec<Residues>;

    #[inline(always)]
    fn run(self) -> Vec<Residues> {
        let mut products = self.a.to_vec();
        for (a, b) in products.iter_mut().zip(self.b) {
            *a = self.lanes.product(a, b);
        }
        products
    }
}

/// aⱼ·c.
pub(super) struct Scaled<'a> {
    pub(super) lanes: &'a PrimeLanes,
    pub(super) a: &'a [Residues],
    pub(super) factor: &'a Residues,
}

impl Kernel for Scaled<'_> {
    type Output = Vec<Residues>;

    #[inline(always)]
    fn run(self) -> Vec<Residues> {
        let mut products = self.a.to_vec();
        for a in &mut products {
            *a = self.lanes.product(a, self.factor);
        }
        products
    }
}

/// Σ aⱼ·bⱼ over pairs of sums, taking four pairs at a time so that each result is loaded and stored once for four.
pub(super) struct SumOfProducts<'a> {
    pub(super) lanes: &'a PrimeLanes,
    pub(super) pairs: &'a [(&'a [Residues], &'a [Residues])],
    pub(super) points: usize,
}

impl Kernel for SumOfProducts<'_> {
    type Output = Vec<Residues>;

    #[inline(always)]
    fn run(self) -> Vec<Residues> {
        let mut sums: Vec<Sums> = vec![[0; LANES]; self.points];
        let mut fours = self.pairs.chunks_exact(4);
        for four in &mut fours {
            let &[(a0, b0), (a1, b1), (a2, b2), (a3, b3)] = four else { continue };
            let (left, right) =
                (a0.iter().zip(a1).zip(a2.iter().zip(a3)), b0.iter().zip(b1).zip(b2.iter().zip(b3)));
            for ((sum, ((a0, a1), (a2, a3))), ((b0, b1), (b2, b3))) in sums.iter_mut().zip(left).zip(right) {
                let first = accumulated(&accumulated(sum, a0, b0), a1, b1);
                *sum = self.lanes.folded(&accumulated(&accumulated(&first, a2, b2), a3, b3));
            }
        }
        for (a, b) in fours.remainder() {
            for ((sum, a), b) in sums.iter_mut().zip(*a).zip(*b) {
                *sum = accumulated(sum, a, b);
            }
        }
        sums.iter().map(|sum| self.lanes.settled(sum)).collect()
    }
}

/// The contribution of one harmonic to a weighted sum.
pub(super) struct Harmonic<'a> {
    pub(super) lanes: &'a PrimeLanes,
    pub(super) weighted: &'a [Residues],
    pub(super) table: &'a [Residues],
    pub(super) k: usize,
}

impl Kernel for Harmonic<'_> {
    type Output = Residues;

    #[inline(always)]
    fn run(self) -> Residues {
        let (mask, mut at) = (self.table.len() - 1, 0);
        let mut sums = [0; LANES];
        for values in self.weighted.chunks(PRODUCTS) {
            sums = self.lanes.folded(&sums);
            for value in values {
                sums = accumulated(&sums, value, &self.table[at & mask]);
                at += self.k;
            }
        }
        self.lanes.settled(&sums)
    }
}

/// A term: the table of the cosine or sine, the harmonic, and the coefficient.
pub(super) type Term<'a> = (&'a [Residues], usize, Residues);

/// The values of a sum of some harmonics.
pub(super) struct SumOfHarmonics<'a> {
    pub(super) lanes: &'a PrimeLanes,
    pub(super) terms: &'a [Term<'a>],
    pub(super) points: usize,
}

impl Kernel for SumOfHarmonics<'_> {
    type Output = Vec<Residues>;

    #[inline(always)]
    fn run(self) -> Vec<Residues> {
        let mut values = vec![[0; LANES]; self.points];
        for (j, value) in values.iter_mut().enumerate() {
            let mut sums = [0; LANES];
            for terms in self.terms.chunks(PRODUCTS) {
                sums = self.lanes.folded(&sums);
                for (table, k, factor) in terms {
                    sums = accumulated(&sums, &table[(k * j) & (table.len() - 1)], factor);
                }
            }
            *value = self.lanes.settled(&sums);
        }
        values
    }
}
