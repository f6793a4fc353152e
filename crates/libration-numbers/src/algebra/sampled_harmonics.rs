//! Sums of harmonics modulo primes, held as their values at roots of unity: products are pointwise.

use super::sampled_values::{Harmonic, Pointwise, Scaled, SumOfHarmonics, SumOfProducts};
use super::{Function, HarmonicPair, LANES, PhaseRing, PrimeFields, Rational, Residues, Ring};
use libration_kernels::dispatch::dispatch_slices;

/// Symmetries of all the sums of a ring, which reduce the number of points that determine them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symmetry {
    /// `true` if there are no sines.
    pub even_in_phase: bool,
    /// `true` if the harmonics of each sum are all odd or all even.
    pub half_wave: bool,
}

/// Sums of harmonics up to a degree, represented by their values at zʲ = e^{ijτ₁} for a primitive M-th root of unity z, M > 2·degree. The empty
/// list of values is zero.
#[derive(Clone, Debug)]
pub struct SampledHarmonics {
    fields: PrimeFields,
    symmetry: Symmetry,
    /// cos(jτ₁) and sin(jτ₁) for j < M.
    cosines: Vec<Residues>,
    sines: Vec<Residues>,
    /// 2/M times the number of points on the circle that each sampled point represents.
    weights: Vec<Residues>,
}

impl SampledHarmonics {
    /// The number M of points on the circle for sums up to `degree`.
    pub fn period(degree: usize) -> usize {
        (2 * degree + 1).next_power_of_two().max(8)
    }

    /// The ring; `None` if a prime has no root of unity of order [`Self::period`].
    pub fn new(fields: PrimeFields, degree: usize, symmetry: Symmetry) -> Option<Self> {
        let period = Self::period(degree);
        let order = u32::try_from(period).ok()?;
        let root = fields.in_each(|field| field.root_of_unity(order))?;
        let powers: Vec<Residues> =
            std::iter::successors(Some(fields.unit()), |z| Some(fields.multiply(z, &root)))
                .take(period)
                .collect();
        let conjugate = |j: usize| &powers[(period - j) % period];
        let half = fields.over_integer(&fields.unit(), 2)?;
        // powers[M/4] is the imaginary unit.
        let half_over_i = fields.multiply(&half, conjugate(period / 4));
        let cosine = |j: usize| fields.multiply(&half, &fields.add(&powers[j], conjugate(j)));
        let sine = |j: usize| fields.multiply(&half_over_i, &fields.subtract(&powers[j], conjugate(j)));
        let norm = fields.over_integer(&fields.integer(2), u64::from(order))?;
        let weight = |&count: &i64| fields.times_integer(&norm, count);
        Some(Self {
            symmetry,
            cosines: (0..period).map(cosine).collect(),
            sines: (0..period).map(sine).collect(),
            weights: multiplicities(period, symmetry).iter().map(weight).collect(),
            fields,
        })
    }

    pub fn points(&self) -> usize {
        self.weights.len()
    }

    fn constant(&self, value: Residues) -> Vec<Residues> {
        if self.fields.is_zero(&value) { vec![] } else { vec![value; self.points()] }
    }

    fn as_constant(a: &[Residues]) -> Option<Residues> {
        let first = a.first().copied().unwrap_or([0; LANES]);
        a.iter().all(|&value| value == first).then_some(first)
    }
}

/// The number of points on the circle, of M in all, that each sampled point represents: the point itself and its mirror images.
fn multiplicities(period: usize, symmetry: Symmetry) -> Vec<i64> {
    let with_ends = |last: usize, inner: i64| {
        (0..=last).map(|j| if j == 0 || j == last { inner / 2 } else { inner }).collect()
    };
    match (symmetry.even_in_phase, symmetry.half_wave) {
        (false, false) => vec![1; period],
        (false, true) => vec![2; period / 2],
        (true, false) => with_ends(period / 2, 2),
        (true, true) => with_ends(period / 4, 4),
    }
}

impl Ring for SampledHarmonics {
    type Element = Vec<Residues>;

    fn zero(&self) -> Vec<Residues> {
        vec![]
    }

    fn is_zero(&self, a: &Vec<Residues>) -> bool {
        a.iter().all(|value| self.fields.is_zero(value))
    }

    fn rational(&self, value: &Rational) -> Option<Vec<Residues>> {
        self.fields.rational(value).map(|value| self.constant(value))
    }

    fn add(&self, a: &Vec<Residues>, b: &Vec<Residues>) -> Vec<Residues> {
        match (a.is_empty(), b.is_empty()) {
            (true, _) => b.clone(),
            (_, true) => a.clone(),
            _ => a.iter().zip(b).map(|(a, b)| self.fields.add(a, b)).collect(),
        }
    }

    fn subtract(&self, a: &Vec<Residues>, b: &Vec<Residues>) -> Vec<Residues> {
        match (a.is_empty(), b.is_empty()) {
            (true, _) => self.negate(b),
            (_, true) => a.clone(),
            _ => a.iter().zip(b).map(|(a, b)| self.fields.subtract(a, b)).collect(),
        }
    }

    fn negate(&self, a: &Vec<Residues>) -> Vec<Residues> {
        a.iter().map(|value| self.fields.negate(value)).collect()
    }

    fn multiply(&self, a: &Vec<Residues>, b: &Vec<Residues>) -> Vec<Residues> {
        if a.is_empty() || b.is_empty() {
            return vec![];
        }
        dispatch_slices(Pointwise { lanes: self.fields.lanes(), a, b })
    }

    fn times_integer(&self, a: &Vec<Residues>, factor: i64) -> Vec<Residues> {
        self.times_number(a, &self.fields.times_integer(&self.fields.unit(), factor))
    }

    fn divide(&self, a: &Vec<Residues>, divisor: &Vec<Residues>) -> Option<Vec<Residues>> {
        Some(self.times_number(a, &self.fields.inverse(&Self::as_constant(divisor)?)?))
    }

    fn over_integer(&self, a: &Vec<Residues>, divisor: u64) -> Option<Vec<Residues>> {
        Some(self.times_number(a, &self.fields.over_integer(&self.fields.unit(), divisor)?))
    }

    fn value(&self, _: Function, _: &Vec<Residues>) -> Option<Vec<Residues>> {
        None
    }

    fn power(&self, _: &Vec<Residues>, _: &Rational) -> Option<Vec<Residues>> {
        None
    }

    fn pi(&self) -> Option<Vec<Residues>> {
        None
    }

    fn convolution(&self, a: &[Vec<Residues>], b: &[Vec<Residues>]) -> Vec<Residues> {
        let present = a.iter().zip(b.iter().rev()).filter(|(a, b)| !a.is_empty() && !b.is_empty());
        let pairs: Vec<(&[Residues], &[Residues])> =
            present.map(|(a, b)| (a.as_slice(), b.as_slice())).collect();
        if pairs.is_empty() {
            return vec![];
        }
        dispatch_slices(SumOfProducts { lanes: self.fields.lanes(), pairs: &pairs, points: self.points() })
    }
}

impl PhaseRing for SampledHarmonics {
    type Numbers = PrimeFields;

    fn numbers(&self) -> &PrimeFields {
        &self.fields
    }

    fn harmonic(&self, a: &Vec<Residues>, k: usize) -> HarmonicPair<Residues> {
        self.harmonics(a, &[k]).swap_remove(0)
    }

    fn harmonics(&self, a: &Vec<Residues>, wanted: &[usize]) -> Vec<HarmonicPair<Residues>> {
        let nothing = self.fields.zero();
        if a.is_empty() {
            return vec![HarmonicPair { cosine: nothing, sine: nothing }; wanted.len()];
        }
        let lanes = self.fields.lanes();
        let weighted = &dispatch_slices(Pointwise { lanes, a, b: &self.weights });
        let against = |table: &[Residues], k| dispatch_slices(Harmonic { lanes, weighted, table, k });
        let half = self.fields.over_integer(&self.fields.unit(), 2).expect("two is not zero");
        let pair = |&k: &usize| {
            let cosine = against(&self.cosines, k);
            // The formula for the other harmonics gives twice the mean.
            let cosine = if k > 0 { cosine } else { self.fields.multiply(&cosine, &half) };
            let sine = if self.symmetry.even_in_phase || k == 0 { nothing } else { against(&self.sines, k) };
            HarmonicPair { cosine, sine }
        };
        wanted.iter().map(pair).collect()
    }

    fn sum_of_harmonics(&self, terms: &[(usize, HarmonicPair<Residues>)]) -> Vec<Residues> {
        let both = |(k, h): &(usize, HarmonicPair<Residues>)| {
            [(self.cosines.as_slice(), *k, h.cosine), (self.sines.as_slice(), *k, h.sine)]
        };
        let terms: Vec<_> =
            terms.iter().flat_map(both).filter(|(.., factor)| !self.fields.is_zero(factor)).collect();
        if terms.is_empty() {
            return vec![];
        }
        dispatch_slices(SumOfHarmonics { lanes: self.fields.lanes(), terms: &terms, points: self.points() })
    }

    fn times_number(&self, a: &Vec<Residues>, factor: &Residues) -> Vec<Residues> {
        if self.fields.is_zero(factor) {
            return vec![];
        }
        dispatch_slices(Scaled { lanes: self.fields.lanes(), a, factor })
    }
}
