//! Power series of fractions over a common denominator, so that one greatest common divisor is computed per series and not per coefficient.

use dashu_base::{Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};

use super::{Rational, product};

/// Σ nᵢxⁱ/d.
#[derive(Clone, Debug)]
pub(super) struct OverCommon {
    numerators: Vec<IBig>,
    denominator: UBig,
}

impl OverCommon {
    /// The series over its least common denominator.
    pub(super) fn new(series: &[Rational]) -> Self {
        let denominator = series.iter().fold(UBig::ONE, |common, one| lcm(common, one.parts().1));
        let numerator = |fraction: &Rational| {
            let (numerator, divisor) = fraction.parts();
            numerator * IBig::from(&denominator / divisor)
        };
        Self { numerators: series.iter().map(numerator).collect(), denominator }
    }

    pub(super) fn into_fractions(self) -> Vec<Rational> {
        let Self { numerators, denominator } = self;
        numerators.into_iter().map(|sum| Rational::from_parts(sum, denominator.clone())).collect()
    }

    /// The first coefficients of the product.
    pub(super) fn product(&self, other: &Self, length: usize) -> Self {
        let first = |series: &Self| series.numerators.len().min(length);
        let mut numerators = product(&self.numerators[..first(self)], &other.numerators[..first(other)]);
        numerators.resize(length, IBig::ZERO);
        Self { numerators, denominator: &self.denominator * &other.denominator }
    }

    /// The series after cancelling the factors that the denominator shares with all numerators.
    fn reduced(self) -> Self {
        let Self { numerators, denominator } = self;
        // The last coefficients have the largest denominators and therefore show first which factors cancel.
        let excess =
            numerators.iter().rev().filter(|n| !n.is_zero()).try_fold(denominator.clone(), |excess, n| {
                if excess.is_one() { Err(()) } else { Ok(excess.gcd(n.unsigned_abs())) }
            });
        match excess {
            Ok(excess) if !excess.is_one() => {
                let divisor = IBig::from(excess.clone());
                let numerators = numerators.into_iter().map(|n| n / &divisor).collect();
                Self { numerators, denominator: denominator / excess }
            }
            _ => Self { numerators, denominator },
        }
    }

    /// Σ factorⱼ·seriesⱼ up to a number of coefficients.
    fn combination(factors: &[Rational], series: &[Self], length: usize) -> Self {
        let under = |(factor, series): (&Rational, &Self)| factor.parts().1 * &series.denominator;
        let denominators: Vec<UBig> = factors.iter().zip(series).map(under).collect();
        let denominator = denominators.iter().fold(UBig::ONE, lcm);
        let mut numerators = vec![IBig::ZERO; length];
        for ((factor, series), divisor) in factors.iter().zip(series).zip(&denominators) {
            let multiplier = factor.parts().0 * IBig::from(&denominator / divisor);
            for (sum, numerator) in numerators.iter_mut().zip(&series.numerators) {
                if !numerator.is_zero() {
                    *sum += numerator * &multiplier;
                }
            }
        }
        Self { numerators, denominator }.reduced()
    }

    /// self + xᵏ·other.
    fn plus_shifted(self, other: &Self, k: usize) -> Self {
        let denominator = lcm(self.denominator.clone(), &other.denominator);
        let (multiplier, others) =
            (IBig::from(&denominator / &self.denominator), IBig::from(&denominator / &other.denominator));
        let mut numerators: Vec<IBig> = self.numerators.into_iter().map(|n| n * &multiplier).collect();
        for (sum, numerator) in numerators.iter_mut().skip(k).zip(&other.numerators) {
            *sum += numerator * &others;
        }
        Self { numerators, denominator }.reduced()
    }

    /// The series without its first coefficients.
    fn skip(&self, coefficients: usize) -> Self {
        let numerators = self.numerators.iter().skip(coefficients).cloned().collect();
        Self { numerators, denominator: self.denominator.clone() }
    }
}

fn lcm(common: UBig, denominator: &UBig) -> UBig {
    if (&common % denominator).is_zero() {
        common
    } else {
        let gcd = (&common).gcd(denominator);
        common / gcd * denominator
    }
}

/// The first coefficients of outer(inner(x)), the inner series without constant term, checking `go_on` at each step; `None` when cancelled.
///
/// Reference: M. S. Paterson, L. J. Stockmeyer, SIAM J. Comput. 2, 60 (1973), doi:10.1137/0202007.
pub fn composition(
    outer: &[Rational],
    inner: &[Rational],
    length: usize,
    go_on: &dyn Fn() -> bool,
) -> Option<Vec<Rational>> {
    let outer = &outer[..outer.len().min(length)];
    let step = outer.len().isqrt().max(1);
    let inner = OverCommon::new(&inner[..inner.len().min(length)]);
    let mut powers = vec![OverCommon { numerators: vec![IBig::ONE], denominator: UBig::ONE }];
    for _ in 0..step {
        go_on().then_some(())?;
        powers.push(powers[powers.len() - 1].product(&inner, length).reduced());
    }
    let giant = powers.pop()?.skip(step);
    let mut sum: Option<OverCommon> = None;
    for (i, factors) in outer.chunks(step).enumerate().rev() {
        go_on().then_some(())?;
        // The factor of the i-th power of the giant step needs i·step coefficients less.
        let left = length - i * step;
        let block = OverCommon::combination(factors, &powers, left);
        sum = Some(match sum {
            None => block,
            Some(higher) => block.plus_shifted(&higher.product(&giant, left - step), step),
        });
    }
    Some(sum.map_or_else(|| vec![Rational::from(0); length], OverCommon::into_fractions))
}
