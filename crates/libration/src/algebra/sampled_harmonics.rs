//! Sums of harmonics modulo a prime, held as their values at roots of unity: products are pointwise.

use super::{Function, HarmonicPair, PhaseRing, PrimeField, Rational, Ring};

/// What is known of all the sums of a ring, so that fewer points determine them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Symmetry {
    /// There are no sines.
    pub(crate) even_in_phase: bool,
    /// The harmonics of one sum are all odd or all even.
    pub(crate) half_wave: bool,
}

/// Sums of harmonics up to a degree, as values at zʲ = e^{ijτ₁} of a primitive M-th root z of unity, M > 2·degree.
/// The empty list of values is zero.
#[derive(Clone, Debug)]
pub(crate) struct SampledHarmonics {
    field: PrimeField,
    symmetry: Symmetry,
    /// cos(jτ₁) and sin(jτ₁) for j < M.
    cosines: Vec<u64>,
    sines: Vec<u64>,
    /// How many of the M points each sampled point stands for.
    multiplicities: Vec<u64>,
    /// 2/M.
    norm: u64,
}

impl SampledHarmonics {
    /// M for sums up to `degree`.
    pub(crate) fn period(degree: usize) -> usize {
        (2 * degree + 1).next_power_of_two().max(8)
    }

    /// `None` when the prime has no root of unity of order [`Self::period`].
    pub(crate) fn new(field: PrimeField, degree: usize, symmetry: Symmetry) -> Option<Self> {
        let period = Self::period(degree);
        let order = u64::try_from(period).ok()?;
        let root = field.root_of_unity(order)?;
        let powers: Vec<u64> = std::iter::successors(Some(field.unit()), |&z| Some(field.product(z, root)))
            .take(period)
            .collect();
        let conjugate = |j: usize| powers[(period - j) % period];
        let half = field.inverse(field.integer(2))?;
        // powers[M/4] is the imaginary unit.
        let half_over_i = field.product(half, conjugate(period / 4));
        let combine = |sign: u64, factor: u64| -> Vec<u64> {
            let sum = |j: usize| field.sum(powers[j], field.product(sign, conjugate(j)));
            (0..period).map(|j| field.product(factor, sum(j))).collect()
        };
        let cosines = combine(field.unit(), half);
        let sines = combine(field.negate(&field.unit()), half_over_i);
        let multiplicities =
            multiplicities(period, symmetry).iter().map(|&count| field.integer(count)).collect();
        let norm = field.divide(&field.integer(2), &field.integer(order))?;
        Some(Self { field, symmetry, cosines, sines, multiplicities, norm })
    }

    pub(crate) fn points(&self) -> usize {
        self.multiplicities.len()
    }

    fn map(&self, a: &[u64], f: impl Fn(u64) -> u64) -> Vec<u64> {
        a.iter().map(|&value| f(value)).collect()
    }

    fn zip(a: &[u64], b: &[u64], f: impl Fn(u64, u64) -> u64) -> Vec<u64> {
        a.iter().zip(b).map(|(&a, &b)| f(a, b)).collect()
    }

    fn constant(&self, value: u64) -> Vec<u64> {
        if value == 0 { vec![] } else { vec![value; self.points()] }
    }

    fn as_constant(a: &[u64]) -> Option<u64> {
        let first = a.first().copied().unwrap_or(0);
        a.iter().all(|&value| value == first).then_some(first)
    }

    /// The entries of a table at k·j for j = 0, 1, ….
    fn every<'a>(&self, table: &'a [u64], k: usize) -> impl Iterator<Item = u64> + 'a {
        let mask = table.len() - 1;
        (0..self.points()).map(move |j| table[(k * j) & mask])
    }
}

/// Of M points on the circle each sampled one stands for its mirror images too.
fn multiplicities(period: usize, symmetry: Symmetry) -> Vec<u64> {
    let with_ends = |last: usize, inner: u64| {
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
    type Element = Vec<u64>;

    fn zero(&self) -> Vec<u64> {
        vec![]
    }

    fn is_zero(&self, a: &Vec<u64>) -> bool {
        a.iter().all(|&value| value == 0)
    }

    fn rational(&self, value: &Rational) -> Option<Vec<u64>> {
        self.field.rational(value).map(|value| self.constant(value))
    }

    fn add(&self, a: &Vec<u64>, b: &Vec<u64>) -> Vec<u64> {
        match (a.is_empty(), b.is_empty()) {
            (true, _) => b.clone(),
            (_, true) => a.clone(),
            _ => Self::zip(a, b, |a, b| self.field.sum(a, b)),
        }
    }

    fn subtract(&self, a: &Vec<u64>, b: &Vec<u64>) -> Vec<u64> {
        match (a.is_empty(), b.is_empty()) {
            (true, _) => self.negate(b),
            (_, true) => a.clone(),
            _ => Self::zip(a, b, |a, b| self.field.difference(a, b)),
        }
    }

    fn negate(&self, a: &Vec<u64>) -> Vec<u64> {
        self.map(a, |value| self.field.difference(0, value))
    }

    fn multiply(&self, a: &Vec<u64>, b: &Vec<u64>) -> Vec<u64> {
        if a.is_empty() || b.is_empty() { vec![] } else { Self::zip(a, b, |a, b| self.field.product(a, b)) }
    }

    fn times_integer(&self, a: &Vec<u64>, factor: i64) -> Vec<u64> {
        self.times_number(a, &self.field.times_integer(&self.field.unit(), factor))
    }

    fn divide(&self, a: &Vec<u64>, divisor: &Vec<u64>) -> Option<Vec<u64>> {
        Some(self.times_number(a, &self.field.inverse(Self::as_constant(divisor)?)?))
    }

    fn over_integer(&self, a: &Vec<u64>, divisor: u64) -> Option<Vec<u64>> {
        Some(self.times_number(a, &self.field.over_integer(&self.field.unit(), divisor)?))
    }

    fn value(&self, _: Function, _: &Vec<u64>) -> Option<Vec<u64>> {
        None
    }

    fn power(&self, _: &Vec<u64>, _: &Rational) -> Option<Vec<u64>> {
        None
    }

    fn pi(&self) -> Option<Vec<u64>> {
        None
    }

    fn convolution(&self, a: &[Vec<u64>], b: &[Vec<u64>]) -> Vec<u64> {
        let mut sums: Vec<u128> = vec![];
        for (a, b) in a.iter().zip(b.iter().rev()).filter(|(a, b)| !a.is_empty() && !b.is_empty()) {
            sums.resize(self.points(), 0);
            for ((sum, &a), &b) in sums.iter_mut().zip(a).zip(b) {
                *sum = self.field.accumulated(*sum, a, b);
            }
        }
        sums.into_iter().map(|sum| self.field.settled(sum)).collect()
    }
}

impl PhaseRing for SampledHarmonics {
    type Numbers = PrimeField;

    fn numbers(&self) -> &PrimeField {
        &self.field
    }

    fn harmonic(&self, a: &Vec<u64>, k: usize) -> HarmonicPair<u64> {
        if a.is_empty() {
            return HarmonicPair { cosine: 0, sine: 0 };
        }
        let against = |table: &[u64]| {
            let weights = self.every(table, k).zip(&self.multiplicities);
            let weighted = a.iter().zip(weights).map(|(&a, (c, &m))| (self.field.product(a, m), c));
            self.field.product(self.norm, self.field.inner_product(weighted))
        };
        let cosine = against(&self.cosines);
        // The mean is half of what the formula for the other harmonics gives.
        let cosine = if k > 0 { Some(cosine) } else { self.field.over_integer(&cosine, 2) };
        let sine = if self.symmetry.even_in_phase || k == 0 { 0 } else { against(&self.sines) };
        HarmonicPair { cosine: cosine.expect("two is not zero"), sine }
    }

    fn sum_of_harmonics(&self, terms: &[(usize, HarmonicPair<u64>)]) -> Vec<u64> {
        let mut sums: Vec<u128> = vec![];
        for (table, k, factor) in
            terms.iter().flat_map(|(k, h)| [(&self.cosines, k, h.cosine), (&self.sines, k, h.sine)])
        {
            if factor != 0 {
                sums.resize(self.points(), 0);
                for (sum, value) in sums.iter_mut().zip(self.every(table, *k)) {
                    *sum = self.field.accumulated(*sum, value, factor);
                }
            }
        }
        sums.into_iter().map(|sum| self.field.settled(sum)).collect()
    }

    fn times_number(&self, a: &Vec<u64>, factor: &u64) -> Vec<u64> {
        if *factor == 0 { vec![] } else { self.map(a, |value| self.field.product(value, *factor)) }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Rationals;
    use super::super::harmonics::HarmonicSums;
    use super::super::primes_with_roots;
    use super::*;

    /// Coefficients that obey the symmetry, different for each seed.
    fn terms(symmetry: Symmetry, seed: i64) -> Vec<(usize, HarmonicPair<i64>)> {
        let allowed = (0..6_usize).filter(|k| {
            !symmetry.half_wave || (seed.unsigned_abs().is_multiple_of(2)) == k.is_multiple_of(2)
        });
        let sine = |k: i64| if symmetry.even_in_phase || k == 0 { 0 } else { seed - 2 * k };
        allowed.map(|k| (k, HarmonicPair { cosine: seed + 3 * k as i64, sine: sine(k as i64) })).collect()
    }

    #[test]
    fn values_at_points_and_lists_of_coefficients_have_the_same_products() {
        let exact = HarmonicSums { numbers: Rationals };
        for (even_in_phase, half_wave) in [(false, false), (false, true), (true, false), (true, true)] {
            let symmetry = Symmetry { even_in_phase, half_wave };
            let field = PrimeField::new(primes_with_roots(12).next().unwrap());
            let sampled = SampledHarmonics::new(field.clone(), 10, symmetry).unwrap();
            let in_lists = |seed| {
                let rational = |n| Rational::from(n);
                let list: Vec<_> = terms(symmetry, seed)
                    .into_iter()
                    .map(|(k, h)| (k, HarmonicPair { cosine: rational(h.cosine), sine: rational(h.sine) }))
                    .collect();
                exact.sum_of_harmonics(&list)
            };
            let at_points = |seed| {
                let residue = |n| field.times_integer(&field.unit(), n);
                let list: Vec<_> = terms(symmetry, seed)
                    .into_iter()
                    .map(|(k, h)| (k, HarmonicPair { cosine: residue(h.cosine), sine: residue(h.sine) }))
                    .collect();
                sampled.sum_of_harmonics(&list)
            };
            let product = exact.multiply(&in_lists(4), &in_lists(7));
            let sampled_product = sampled.multiply(&at_points(4), &at_points(7));
            for k in (0..=10).filter(|k| !half_wave || k % 2 == 1) {
                let (truth, found) = (exact.harmonic(&product, k), sampled.harmonic(&sampled_product, k));
                assert_eq!(field.rational(&truth.cosine), Some(found.cosine), "{symmetry:?} cos {k}");
                assert_eq!(field.rational(&truth.sine), Some(found.sine), "{symmetry:?} sin {k}");
            }
        }
    }
}
