//! Finite sums of harmonics of a phase τ as coefficients of power series.

use super::{Function, Rational, Ring};

/// The coefficients of cos kτ and sin kτ; that of sin 0τ is zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HarmonicPair<N> {
    pub cosine: N,
    pub sine: N,
}

/// A ring of finite sums of harmonics Σ aₖ cos kτ + bₖ sin kτ with coefficients in a field.
pub trait PhaseRing: Ring {
    /// Ring of the coefficients.
    type Numbers: Ring;

    fn numbers(&self) -> &Self::Numbers;

    /// The k-th harmonic of a sum.
    fn harmonic(&self, a: &Self::Element, k: usize) -> HarmonicPair<Number<Self>>;

    /// Several harmonics of a sum.
    fn harmonics(&self, a: &Self::Element, wanted: &[usize]) -> Vec<HarmonicPair<Number<Self>>> {
        wanted.iter().map(|&k| self.harmonic(a, k)).collect()
    }

    /// The sum of these harmonics, each given with its k.
    fn sum_of_harmonics(&self, terms: &[(usize, HarmonicPair<Number<Self>>)]) -> Self::Element;

    /// a·c with a number c.
    fn times_number(&self, a: &Self::Element, factor: &Number<Self>) -> Self::Element;
}

/// A coefficient of a harmonic.
pub type Number<R> = <<R as PhaseRing>::Numbers as Ring>::Element;

/// Sums of harmonics held as lists of their coefficients.
#[derive(Clone, Debug)]
pub struct HarmonicSums<F> {
    pub numbers: F,
}

/// aₖ and bₖ for k = 0, 1, …; either list may be shorter than the other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HarmonicSum<N> {
    cosines: Vec<N>,
    sines: Vec<N>,
}

impl<N> HarmonicSum<N> {
    /// The highest harmonic that may be present.
    pub fn highest(&self) -> usize {
        self.cosines.len().max(self.sines.len()).saturating_sub(1)
    }
}

impl<F: Ring> HarmonicSums<F> {
    fn constant(value: F::Element) -> HarmonicSum<F::Element> {
        HarmonicSum { cosines: vec![value], sines: vec![] }
    }

    /// The constant value of a sum; `None` if the sum has harmonics.
    fn as_constant(&self, a: &HarmonicSum<F::Element>) -> Option<F::Element> {
        let zero = |numbers: &[F::Element]| numbers.iter().all(|number| self.numbers.is_zero(number));
        let constant = zero(a.cosines.get(1..).unwrap_or(&[])) && zero(&a.sines);
        constant.then(|| a.cosines.first().cloned().unwrap_or_else(|| self.numbers.zero()))
    }

    fn map(
        a: &HarmonicSum<F::Element>,
        f: impl Fn(&F::Element) -> Option<F::Element>,
    ) -> Option<HarmonicSum<F::Element>> {
        let list = |numbers: &[F::Element]| numbers.iter().map(&f).collect::<Option<Vec<_>>>();
        Some(HarmonicSum { cosines: list(&a.cosines)?, sines: list(&a.sines)? })
    }

    fn zip(
        &self,
        a: &HarmonicSum<F::Element>,
        b: &HarmonicSum<F::Element>,
        f: impl Fn(&F::Element, &F::Element) -> F::Element,
    ) -> HarmonicSum<F::Element> {
        let zero = self.numbers.zero();
        let list = |a: &[F::Element], b: &[F::Element]| {
            (0..a.len().max(b.len()))
                .map(|k| f(a.get(k).unwrap_or(&zero), b.get(k).unwrap_or(&zero)))
                .collect()
        };
        HarmonicSum { cosines: list(&a.cosines, &b.cosines), sines: list(&a.sines, &b.sines) }
    }

    /// Adds the products of two lists of coefficients: the product of k and l is added at |k ± l| with the given signs.
    fn add_products(
        &self,
        sums: &mut Vec<F::Element>,
        (a, b): (&[F::Element], &[F::Element]),
        (of_difference, of_sum): (Placing, Placing),
    ) {
        for (k, x) in a.iter().enumerate().filter(|(_, x)| !self.numbers.is_zero(x)) {
            for (l, y) in b.iter().enumerate().filter(|(_, y)| !self.numbers.is_zero(y)) {
                let product = self.numbers.multiply(x, y);
                self.add_to(sums, k + l, &product, of_sum == Placing::Minus);
                let swapped = of_difference == Placing::Odd && k < l;
                let minus = of_difference == Placing::Minus || swapped;
                self.add_to(sums, k.abs_diff(l), &product, minus);
            }
        }
    }

    fn add_to(&self, sums: &mut Vec<F::Element>, k: usize, value: &F::Element, minus: bool) {
        if sums.len() <= k {
            sums.resize(k + 1, self.numbers.zero());
        }
        sums[k] =
            if minus { self.numbers.subtract(&sums[k], value) } else { self.numbers.add(&sums[k], value) };
    }
}

/// The sign with which a product of harmonics k and l is added at |k − l| or at k + l.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Placing {
    Plus,
    Minus,
    /// The sign of k − l.
    Odd,
}

impl<F: Ring> Ring for HarmonicSums<F> {
    type Element = HarmonicSum<F::Element>;

    fn zero(&self) -> Self::Element {
        HarmonicSum { cosines: vec![], sines: vec![] }
    }

    fn is_zero(&self, a: &Self::Element) -> bool {
        a.cosines.iter().chain(&a.sines).all(|number| self.numbers.is_zero(number))
    }

    fn rational(&self, value: &Rational) -> Option<Self::Element> {
        self.numbers.rational(value).map(Self::constant)
    }

    fn add(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        self.zip(a, b, |x, y| self.numbers.add(x, y))
    }

    fn subtract(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        self.zip(a, b, |x, y| self.numbers.subtract(x, y))
    }

    fn negate(&self, a: &Self::Element) -> Self::Element {
        self.times_integer(a, -1)
    }

    /// 2 cos k cos l = cos(k−l) + cos(k+l), 2 sin k sin l = cos(k−l) − cos(k+l), 2 sin k cos l = sin(k−l) + sin(k+l).
    fn multiply(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        let (mut cosines, mut sines) = (vec![], vec![]);
        self.add_products(&mut cosines, (&a.cosines, &b.cosines), (Placing::Plus, Placing::Plus));
        self.add_products(&mut cosines, (&a.sines, &b.sines), (Placing::Plus, Placing::Minus));
        self.add_products(&mut sines, (&a.sines, &b.cosines), (Placing::Odd, Placing::Plus));
        self.add_products(&mut sines, (&b.sines, &a.cosines), (Placing::Odd, Placing::Plus));
        Self::map(&HarmonicSum { cosines, sines }, |number| self.numbers.over_integer(number, 2))
            .expect("two divides every number of a field that is not of characteristic two")
    }

    fn times_integer(&self, a: &Self::Element, factor: i64) -> Self::Element {
        Self::map(a, |number| Some(self.numbers.times_integer(number, factor))).unwrap_or_else(|| self.zero())
    }

    fn divide(&self, a: &Self::Element, divisor: &Self::Element) -> Option<Self::Element> {
        let divisor = self.as_constant(divisor)?;
        Self::map(a, |number| self.numbers.divide(number, &divisor))
    }

    fn over_integer(&self, a: &Self::Element, divisor: u64) -> Option<Self::Element> {
        Self::map(a, |number| self.numbers.over_integer(number, divisor))
    }

    fn value(&self, function: Function, at: &Self::Element) -> Option<Self::Element> {
        self.numbers.value(function, &self.as_constant(at)?).map(Self::constant)
    }

    fn power(&self, a: &Self::Element, exponent: &Rational) -> Option<Self::Element> {
        self.numbers.power(&self.as_constant(a)?, exponent).map(Self::constant)
    }

    fn pi(&self) -> Option<Self::Element> {
        self.numbers.pi().map(Self::constant)
    }
}

impl<F: Ring> PhaseRing for HarmonicSums<F> {
    type Numbers = F;

    fn numbers(&self) -> &F {
        &self.numbers
    }

    fn harmonic(&self, a: &Self::Element, k: usize) -> HarmonicPair<F::Element> {
        let at = |list: &[F::Element]| list.get(k).cloned().unwrap_or_else(|| self.numbers.zero());
        HarmonicPair { cosine: at(&a.cosines), sine: if k == 0 { self.numbers.zero() } else { at(&a.sines) } }
    }

    fn sum_of_harmonics(&self, terms: &[(usize, HarmonicPair<F::Element>)]) -> Self::Element {
        let mut sum = self.zero();
        for (k, HarmonicPair { cosine, sine }) in terms {
            self.add_to(&mut sum.cosines, *k, cosine, false);
            self.add_to(&mut sum.sines, *k, sine, false);
        }
        sum
    }

    fn times_number(&self, a: &Self::Element, factor: &F::Element) -> Self::Element {
        Self::map(a, |number| Some(self.numbers.multiply(number, factor))).unwrap_or_else(|| self.zero())
    }
}
