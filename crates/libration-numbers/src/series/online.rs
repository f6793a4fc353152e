//! Recurrences that give each coefficient of a series from the earlier ones, solved with fast products.

use dashu_int::IBig;

use crate::algebra::product;

/// Number of coefficients below which sums of products are faster than Kronecker products: measured for the pendulum's series, whose
/// coefficients grow like factorials, so that products of small with large numbers are cheap.
pub(super) const BLOCK: usize = 1024;

/// Divisor of a coefficient: Σ yₙxⁿ/wₙ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// wₙ = 1.
    Ordinary,
    /// wₙ = (2n)!.
    EvenFactorial,
}

/// An equation y₀ = first, `yₙ = finish(n, Σ wₙ/(w_k w_{n−k})·factor_k·y_{n−k})` over 1 ≤ k ≤ n. The sums need earlier coefficients; the range is
/// therefore halved recursively, and one product carries the first half over to the second.
///
/// Reference: J. van der Hoeven, *Relax, but don't be too lazy*, J. Symbolic Comput. 34, 479 (2002), section 4.1.
#[expect(missing_debug_implementations, reason = "a function has none")]
pub struct Convolution<'a> {
    pub factor: &'a [IBig],
    pub weight: Weight,
    pub finish: &'a dyn Fn(usize, IBig) -> IBig,
    /// Length of a range up to which coefficients are computed one at a time.
    pub block: usize,
}

impl Convolution<'_> {
    /// The first `length` coefficients of the solution; coefficients beyond the end of the factor are zero.
    pub fn solve(&self, first: IBig, length: usize) -> Vec<IBig> {
        let mut answers = vec![IBig::ZERO; length];
        if length > 0 {
            self.fill(&mut answers, 0, length, &first);
        }
        answers
    }

    /// Fills `answers[l..r]`: on entry this range holds the sums over the coefficients below `l`, on return the coefficients.
    fn fill(&self, answers: &mut [IBig], l: usize, r: usize, first: &IBig) {
        if r - l <= self.block.max(1) {
            return self.fill_one_by_one(answers, l, r, first);
        }
        let middle = usize::midpoint(l, r);
        self.fill(answers, l, middle, first);
        self.carry(answers, l, middle, r);
        self.fill(answers, middle, r, first);
    }

    fn fill_one_by_one(&self, answers: &mut [IBig], l: usize, r: usize, first: &IBig) {
        for n in l..r {
            if n == 0 {
                answers[0] = first.clone();
                continue;
            }
            let sum = &answers[n] + self.recent_sum(&answers[l..n], n);
            answers[n] = (self.finish)(n, sum);
        }
    }

    /// The contribution of `recent`, the coefficients directly before the n-th, to the n-th sum.
    fn recent_sum(&self, recent: &[IBig], n: usize) -> IBig {
        let pairs = recent.iter().rev().zip(self.factor.iter().skip(1));
        match self.weight {
            Weight::Ordinary => pairs.map(|(y, coefficient)| y * coefficient).sum(),
            Weight::EvenFactorial => {
                let terms = pairs.zip(even_binomials(n));
                terms.map(|((y, coefficient), binomial)| y * (coefficient * binomial)).sum()
            }
        }
    }

    /// Adds the contribution of `answers[l..middle]` to the sums of `answers[middle..r]`.
    fn carry(&self, answers: &mut [IBig], l: usize, middle: usize, r: usize) {
        let reach = (r - l).min(self.factor.len());
        let (solved, sums) = answers.split_at_mut(middle);
        let left = self.weight.cleared(&solved[l..], l);
        let right = self.weight.cleared(&self.factor[..reach], 0);
        let divisor: IBig = (1..reach).map(|k| self.weight.step(k)).product();
        let mut multiplier = IBig::ONE;
        let products = product(&left, &right).into_iter().skip(middle - l);
        for (n, (sum, product)) in (middle..r).zip(sums.iter_mut().zip(products)) {
            multiplier *= self.weight.step(n);
            *sum += product * &multiplier / &divisor;
        }
    }
}

impl Weight {
    /// wₙ/wₙ₋₁.
    fn step(self, n: usize) -> IBig {
        match self {
            Self::Ordinary => IBig::ONE,
            Self::EvenFactorial => IBig::from((2 * n - 1) * 2 * n),
        }
    }

    /// The coefficients yⱼ from j = `offset` on, each divided by its weight and multiplied by the last one's weight.
    fn cleared(self, coefficients: &[IBig], offset: usize) -> Vec<IBig> {
        let mut factor = IBig::ONE;
        let mut scaled: Vec<IBig> = coefficients.to_vec();
        for (j, coefficient) in scaled.iter_mut().enumerate().rev() {
            *coefficient *= &factor;
            if j > 0 {
                factor *= self.step(offset + j);
            }
        }
        scaled
    }
}

/// The binomial coefficients (2n over 2k) for k = 1 … n.
fn even_binomials(n: usize) -> impl Iterator<Item = IBig> {
    let mut binomial = IBig::ONE;
    (1..=n).map(move |k| {
        let (over, under) = ((2 * n - 2 * k + 2) * (2 * n - 2 * k + 1), (2 * k - 1) * 2 * k);
        binomial = &binomial * over / under;
        binomial.clone()
    })
}
