//! Quarter periods, nome and logarithm of the nome without an iteration: two Landen transformations in closed form, then power series in the
//! small remaining modulus.
//!
//! Let p = min(m, 1 − m) be the smaller parameter, c = √(1 − p) and r = √c. Two steps of the arithmetic–geometric mean of 1 and c lead to a =
//! ((1 + r)/2)² and the modulus 4ε², ε = (1 − r)/2(1 + r) = p/2(1 + c)(1 + r)² (DLMF 19.8(ii)). At p = ½ ε is 0.0432 and x = ε⁴ is 3.5e-6. K(√p)
//! = (π/2a)·S(x), q = ε·Q(x) and ln q have power series in x, whose eighth terms are below 2⁻¹⁰⁴. S is the series of K at the modulus 4ε² (DLMF
//! 19.5.1); the coefficients of Q are integers too (DLMF 19.5(i), OEIS A002103). The other quarter period is K(c) = K(√p)·ln(1/q)/π (DLMF
//! 22.2.1).

use super::nearer::Nearer;
use crate::double_double::{DoubleDouble, fast_two_sum, two_prod};
use crate::elementary::{FineLogarithm, fine_logarithm};
use crate::fused::FusedMultiplyAdd;

/// 2K/π of the modulus 4ε².
const QUARTER: [f64; 8] = [1.0, 4.0, 36.0, 400.0, 4900.0, 63504.0, 853776.0, 11778624.0];
/// π/2K of the modulus 4ε², the reciprocal of `QUARTER`.
const INVERSE_QUARTER: [f64; 8] = [1.0, -4.0, -20.0, -176.0, -1876.0, -22064.0, -275568.0, -3584064.0];
/// q/ε.
const NOME: [f64; 8] = [1.0, 2.0, 15.0, 150.0, 1707.0, 20910.0, 268616.0, 3567400.0];
/// √(q/ε).
const ROOT_OF_NOME: [f64; 8] = [1.0, 1.0, 7.0, 68.0, 761.0, 9218.0, 117451.0, 1549975.0];
/// ln(q/ε)/x.
const LOG_NOME: [f64; 7] =
    [2.0, 13.0, 122.66666666666667, 1350.5, 16182.4, 204573.33333333334, 2683410.285714286];
/// (1 − E/K)/x of the modulus 4ε².
const SECOND: [f64; 7] = [8.0, 16.0, 128.0, 1312.0, 15104.0, 186112.0, 2398208.0];

const FRAC_1_PI: DoubleDouble = DoubleDouble::new(0.3183098861837907, -1.9678676675182486e-17);

/// The quantities after two steps of the descent.
#[derive(Clone, Copy, Debug)]
pub struct Descent {
    /// (1 + r)², four times the mean.
    mean: DoubleDouble,
    /// ε, raised if the parameter is raised.
    epsilon: DoubleDouble,
    /// x = ε⁴.
    fourth: DoubleDouble,
}

impl Descent {
    #[inline(always)]
    pub fn new(nearer: &Nearer) -> Self {
        let mean = (DoubleDouble::ONE.plus_smaller(nearer.root.sqrt())).square();
        let divisor = (DoubleDouble::ONE.plus_smaller(nearer.root) * mean).scaled(2.0);
        let epsilon = nearer.smaller.over(divisor);
        let lowering = nearer.lowering();
        Self { mean, epsilon, fourth: epsilon.scaled(lowering).scaled(lowering).square().square() }
    }

    /// The descent with these values of (1 + r)², ε and x.
    #[inline(always)]
    pub(crate) fn from_parts(mean: DoubleDouble, epsilon: DoubleDouble, fourth: DoubleDouble) -> Self {
        Self { mean, epsilon, fourth }
    }

    /// (1 + r)², ε and x.
    #[inline(always)]
    pub(crate) fn parts(&self) -> [DoubleDouble; 3] {
        [self.mean, self.epsilon, self.fourth]
    }

    /// K(√p).
    #[inline(always)]
    pub fn near_quarter(&self) -> DoubleDouble {
        (series(self.fourth, &QUARTER) * DoubleDouble::PI.scaled(2.0)).over(self.mean)
    }

    /// 1/4K(√p), the turns per unit of the argument.
    #[inline(always)]
    pub fn near_frequency(&self) -> DoubleDouble {
        self.inverse_of_quarter() * FRAC_1_PI.scaled(0.125)
    }

    /// 1/4K(c), given ln(1/q); zero for q = 0.
    #[inline(always)]
    pub fn far_frequency(&self, log: DoubleDouble) -> DoubleDouble {
        self.inverse_of_quarter().scaled(0.125).over(log)
    }

    /// 2π/K(√p).
    #[inline(always)]
    fn inverse_of_quarter(&self) -> DoubleDouble {
        self.mean * series(self.fourth, &INVERSE_QUARTER)
    }

    /// K(c), given K(√p) and ln(1/q); infinite for q = 0.
    #[inline(always)]
    pub fn far_quarter(near: DoubleDouble, log: DoubleDouble) -> DoubleDouble {
        let product = near * FRAC_1_PI * log;
        // An infinite product has no second word: it would be NaN.
        if log.hi < f64::INFINITY { product } else { log }
    }

    /// ln(1/q), infinite for q = 0; relative error below 2⁻¹⁰⁰.
    #[inline(always)]
    pub fn log_inverse_nome(&self, raised: bool) -> DoubleDouble {
        self.log_from(&fine_logarithm(self.epsilon), raised)
    }

    /// ln(1/q) from ln ε, infinite for q = 0.
    #[inline(always)]
    pub(crate) fn log_from(&self, log: &FineLogarithm, raised: bool) -> DoubleDouble {
        let exponent = log.exponent - if raised { 1200.0 } else { 0.0 };
        // An integer times ln 2; the product with the first word of ln 2 is exact in two words.
        let powers = two_prod(-exponent, DoubleDouble::LN_2.hi);
        let powers = fast_two_sum(powers.hi, (-exponent).fma(DoubleDouble::LN_2.lo, powers.lo));
        let sum = powers - log.fraction - series(self.fourth, &LOG_NOME) * self.fourth;
        if self.epsilon.hi == 0.0 { DoubleDouble::from(f64::INFINITY) } else { sum }
    }

    /// q, raised if the parameter is raised; relative error below 2⁻⁶⁹.
    #[inline(always)]
    pub fn nome(&self) -> DoubleDouble {
        self.epsilon * short_series(self.fourth, &NOME)
    }

    /// √q, given the factor that undoes the raising of the parameter's root; relative error below 2⁻⁶⁹.
    #[inline(always)]
    pub fn root_of_nome(&self, lowering: f64) -> DoubleDouble {
        (self.epsilon.sqrt() * short_series(self.fourth, &ROOT_OF_NOME)).scaled(lowering)
    }

    /// √q as in `root_of_nome`, with a relative error below 2⁻¹⁰².
    pub fn precise_root_of_nome(&self, lowering: f64) -> DoubleDouble {
        (self.epsilon.sqrt() * series(self.fourth, &ROOT_OF_NOME)).scaled(lowering)
    }

    /// (1 − E(√p)/K(√p))/p − ½, at most 0.063 (DLMF 19.8.6): the squared differences of the means after the first. The second one is p/4(1 +
    /// c)², the others are those of the modulus 4ε².
    #[inline(always)]
    pub(crate) fn later_differences(&self, nearer: &Nearer) -> DoubleDouble {
        let inverse = DoubleDouble::ONE.over(DoubleDouble::ONE.plus_smaller(nearer.root));
        let lowering = nearer.lowering();
        let epsilon = self.epsilon.scaled(lowering).scaled(lowering);
        let second = nearer.plain_smaller() * inverse.square();
        let others = self.mean * inverse * epsilon.square() * epsilon * series(self.fourth, &SECOND);
        second.scaled(0.25).plus_smaller(others.scaled(0.125))
    }
}

/// Σ coefficientsᵢ·xⁱ for 0 ≤ x ≤ 3.5e-6; from the fourth power on, where the terms are below 2⁻⁵⁹ of the sum, in one word.
#[inline(always)]
fn series<const N: usize>(x: DoubleDouble, coefficients: &[f64; N]) -> DoubleDouble {
    let third = fast_two_sum(coefficients[3], x.hi * from_power(4, x.hi, coefficients));
    let second = DoubleDouble::from(coefficients[2]).plus_product(x, third);
    let first = DoubleDouble::from(coefficients[1]).plus_product(x, second);
    DoubleDouble::from(coefficients[0]).plus_product(x, first)
}

/// The same sum, in one word from the first power on, with an error of 2⁻⁷⁰ of the sum at x = 3.5e-6.
#[inline(always)]
fn short_series<const N: usize>(x: DoubleDouble, coefficients: &[f64; N]) -> DoubleDouble {
    fast_two_sum(coefficients[0], x.hi * from_power(1, x.hi, coefficients))
}

/// The terms from `power` on, divided by that power of x.
#[inline(always)]
fn from_power<const N: usize>(power: usize, x: f64, coefficients: &[f64; N]) -> f64 {
    let mut sum = 0.0;
    let mut i = N;
    while i > power {
        i -= 1;
        sum = x.fma(sum, coefficients[i]);
    }
    sum
}
