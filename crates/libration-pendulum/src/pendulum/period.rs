//! The period ratio T/T0 of the libration with amplitude θ0, on both sides of π/2.
//!
//! Let s be the smaller of θ0 and its complement π − θ0, G(s) the period ratio of amplitude s, and q(s) its nome. Then T/T0 = G(s) if s = θ0,
//! and T/T0 = G(s)·ln(1/q(s))/π if s = π − θ0 (the complementary nome, DLMF 22.2.1). G − 1 and ln(64 q/s²) are approximated by polynomials in u
//! = s² on 0 ≤ s ≤ π/2; their singularities lie at u = π². Leading terms are carried in two words, so that the sum is rounded once.
//!
//! # Error budget
//! Errors in units in the last place of T/T0; in brackets the largest measured on 20 000 inputs on each side.
//!
//! | what | error | why |
//! |---|---|---|
//! | s and u = s² | 0 | s = θ0 is given; π − θ0 comes from three words of π, relatively right to 2⁻¹⁰⁵; the rounding error of s² is its second word |
//! | u/16 | 0 | a power of two |
//! | u²·P(u), at most 0.026 | 0.04 [0.038 with all of G − 1] | three roundings, of u², of P and of their product, each half a unit of that term |
//! | the table of P | 0.01 | 1.2e-17 of G − 1 ≤ 0.18 |
//! | ln(1/q) | 0.02 [0.016] | leading terms in two words; roundings of ln's tail and of the terms behind u/24 only |
//! | products with G and 1/π | 0.001 | in two words |
//! | T/T0 in two words, in sum | 0.07 [0.038] | a test holds it to 0.06 |
//! | the one rounding to `f64` | 0.5 | |
//!
//! The result is therefore right to 0.56 ulp [0.53], which the ledger enforces.
//!
//! # Method
//! The excess T/T0 − 1 is within 0.9 ulp. The second word of u enters through the slope of the polynomials, because s has two words on one side
//! of π/2, whether the amplitude or its complement is given.

use libration_kernels::dispatch::{Kernel, dispatch};
use libration_kernels::double_double::{DoubleDouble, fast_two_sum, two_prod};
use libration_kernels::elementary::{Logarithm, polynomial, split_logarithm, two_word};
use libration_kernels::fused::FusedMultiplyAdd;

/// (G − 1 − u/16)/u² in u on [0, (π/2)²]: relative error of (G − 1)/u 1.2e-17.
pub(super) const EXCESS: [f64; 14] = [
    0.0035807291666666665,
    0.0002346462673611112,
    1.735611567420198e-05,
    1.3867625066360802e-06,
    1.162356162883729e-07,
    1.005479557786626e-08,
    8.893135595139966e-10,
    8.003887047840748e-11,
    7.217654223995578e-12,
    7.24105817730189e-13,
    3.399510240509964e-14,
    1.564505102732741e-14,
    -1.5456139454022743e-15,
    2.790143506563408e-16,
];

/// ln(64 q/u)/u in u on [0, (π/2)²]: relative error 1.8e-17. The first coefficient is 1/24, kept in two words.
const LOG_NOME_LEADING: DoubleDouble = DoubleDouble::new(0.041666666666666664, 2.3129646346357427e-18);
pub(super) const LOG_NOME: [f64; 13] = [
    0.0015842013888888891,
    9.205866953259369e-05,
    6.332422691189751e-06,
    4.763999678026195e-07,
    3.78915092024055e-08,
    3.130637728363911e-09,
    2.6609625082148375e-10,
    2.2903130211431643e-11,
    2.1695311026011136e-12,
    1.1112906662731272e-13,
    4.1131764120516333e-14,
    -3.7681221225144356e-15,
    7.131126719577057e-16,
];

/// 8√(q/u) in u on [0, (π/2)²], after its leading 1: relative error 6.9e-18.
const ROOT_NOME: [f64; 13] = [
    0.020833333333333336,
    0.0010091145833330262,
    6.403847346924794e-05,
    4.618613536457407e-06,
    3.5837397352789074e-07,
    2.9148080929061388e-08,
    2.4515347997654513e-09,
    2.0949414790217114e-10,
    1.9723398212818716e-11,
    1.0126027839574675e-12,
    3.704978116585595e-13,
    -3.3819973105834204e-14,
    6.4124089438781394e-15,
];

/// ln 2 with a first word short enough that its product with an integer below 2¹² is exact.
const LN_2_SHORT: DoubleDouble = DoubleDouble::new(0.6931471805582987, 1.6465949582897082e-12);
pub(super) const FRAC_1_PI: DoubleDouble = DoubleDouble::new(0.3183098861837907, -1.9678676675182486e-17);

/// π − θ for π/2 ≤ θ ≤ π, relatively accurate to the last `f64` below π: the first difference is exact.
#[inline(always)]
fn complement_of(amplitude: f64) -> DoubleDouble {
    let sum = fast_two_sum(DoubleDouble::PI.hi - amplitude, DoubleDouble::PI.lo);
    DoubleDouble::new(sum.hi, sum.lo + DoubleDouble::PI_TAIL.lo)
}

/// G(s) − 1 for u = s². The words are not normalised: the second is below 0.4 % of the first.
#[inline(always)]
#[doc(hidden)]
pub fn excess_below(u: DoubleDouble) -> DoubleDouble {
    excess_with(u, polynomial(u.hi, &EXCESS))
}

/// [`excess_below`] for a given value of its polynomial.
#[inline(always)]
pub(super) fn excess_with(u: DoubleDouble, polynomial: f64) -> DoubleDouble {
    let sum = fast_two_sum(0.0625 * u.hi, (u.hi * u.hi) * polynomial);
    DoubleDouble::new(sum.hi, slope(u.hi, 0.0625, &EXCESS).fma(u.lo, sum.lo))
}

/// The slope of leading·u + u²·Σ tailᵢuⁱ, by which the second word of u is multiplied, to half a per cent.
#[inline(always)]
fn slope<const N: usize>(u: f64, leading: f64, tail: &[f64; N]) -> f64 {
    u.fma(u.fma(u.fma(4.0 * tail[2], 3.0 * tail[1]), 2.0 * tail[0]), leading)
}

/// ln(1/q) of the amplitude s, u = s². The words are not normalised: the second is below 1 % of the first.
#[inline(always)]
#[doc(hidden)]
pub fn log_inverse_nome(s: DoubleDouble, u: DoubleDouble) -> DoubleDouble {
    log_inverse_nome_with(&split_logarithm(s), u, polynomial(u.hi, &LOG_NOME))
}

/// [`log_inverse_nome`] from ln s and the value of the polynomial.
#[inline(always)]
pub(super) fn log_inverse_nome_with(log: &Logarithm, u: DoubleDouble, polynomial: f64) -> DoubleDouble {
    let powers = 2.0f64.fma(-log.exponent, 6.0);
    let first = two_prod(u.hi, LOG_NOME_LEADING.hi);
    let first_lo =
        u.hi.fma(LOG_NOME_LEADING.lo, u.lo.fma(slope(u.hi, LOG_NOME_LEADING.hi, &LOG_NOME), first.lo));
    let rest = (u.hi * u.hi).fma(polynomial, first_lo);
    let sum = fast_two_sum(powers * LN_2_SHORT.hi, -2.0 * log.leading);
    let difference = fast_two_sum(sum.hi, -first.hi);
    let lo = powers.fma(LN_2_SHORT.lo, sum.lo + difference.lo) - 2.0f64.fma(log.tail, rest);
    DoubleDouble::new(difference.hi, lo)
}

/// √q of the amplitude s, u = s².
#[inline(always)]
pub(super) fn root_of_nome(s: DoubleDouble, u: f64) -> DoubleDouble {
    let eighth = s.scaled(0.125);
    fast_two_sum(eighth.hi, eighth.hi.fma(u * polynomial(u, &ROOT_NOME), eighth.lo))
}

/// T/T0 above π/2 from the excess and the log of the nome of the complement.
#[inline(always)]
#[doc(hidden)]
pub fn ratio_above(excess: DoubleDouble, log: DoubleDouble) -> DoubleDouble {
    let gauss = fast_two_sum(1.0, excess.hi);
    let product = two_prod(gauss.hi, log.hi);
    let gauss_lo = gauss.lo + excess.lo;
    let product_lo = gauss.hi.fma(log.lo, gauss_lo.fma(log.hi + log.lo, product.lo));
    let ratio = two_prod(product.hi, FRAC_1_PI.hi);
    let ratio_lo = product.hi.fma(FRAC_1_PI.lo, product_lo.fma(FRAC_1_PI.hi, ratio.lo));
    DoubleDouble::new(ratio.hi, ratio_lo)
}

/// The smaller of the amplitude and its complement, with its square.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Nearer {
    pub s: DoubleDouble,
    pub u: DoubleDouble,
}

impl Nearer {
    #[inline(always)]
    pub(super) fn new(above: bool, amplitude: DoubleDouble, complement: DoubleDouble) -> Self {
        let s = DoubleDouble::new(
            if above { complement.hi } else { amplitude.hi },
            if above { complement.lo } else { amplitude.lo },
        );
        let u = s.hi * s.hi;
        Self { s, u: DoubleDouble::new(u, (2.0 * s.hi).fma(s.lo, s.hi.fma(s.hi, -u))) }
    }
}

/// A quantity of the period as a function of one number.
#[doc(hidden)]
pub trait PeriodFunction: Copy {
    /// The nearer side for an argument; an arbitrary one outside the domain.
    fn nearer(argument: f64) -> Nearer;
    /// The value, from the period of the nearer side; NaN outside the domain.
    fn value(argument: f64, excess_below: DoubleDouble, ratio_above: DoubleDouble) -> f64;
}

#[inline(always)]
pub(super) fn amplitude_above(amplitude: f64) -> bool {
    amplitude.abs() > std::f64::consts::FRAC_PI_2
}

#[inline(always)]
#[doc(hidden)]
pub fn nearer_of_amplitude(amplitude: f64) -> Nearer {
    let size = amplitude.abs();
    Nearer::new(amplitude_above(size), DoubleDouble::from(size), complement_of(size))
}

#[inline(always)]
pub(super) fn within_pi(amplitude: f64) -> bool {
    amplitude.abs() <= DoubleDouble::PI.hi
}

/// A function of the amplitude: T/T0 or the excess, depending on the rounding.
#[derive(Clone, Copy)]
pub(super) struct OfAmplitude<R>(pub(super) R);

/// Rounding of the two forms of the period to one result.
pub(super) trait Rounding: Copy {
    /// Rounds the result, given T/T0 − 1 below π/2 and T/T0 above.
    fn round(above: bool, excess_below: DoubleDouble, ratio_above: DoubleDouble) -> f64;
}

/// T/T0.
#[derive(Clone, Copy)]
pub(super) struct Ratio;

impl Rounding for Ratio {
    #[inline(always)]
    fn round(above: bool, excess_below: DoubleDouble, ratio_above: DoubleDouble) -> f64 {
        let below = fast_two_sum(1.0, excess_below.hi);
        if above { ratio_above.to_f64() } else { below.hi + (below.lo + excess_below.lo) }
    }
}

/// T/T0 − 1.
#[derive(Clone, Copy)]
pub(super) struct Excess;

impl Rounding for Excess {
    #[inline(always)]
    fn round(above: bool, excess_below: DoubleDouble, ratio_above: DoubleDouble) -> f64 {
        let from_above = (ratio_above.hi - 1.0) + ratio_above.lo;
        if above { from_above } else { excess_below.to_f64() }
    }
}

impl<R: Rounding> PeriodFunction for OfAmplitude<R> {
    #[inline(always)]
    fn nearer(amplitude: f64) -> Nearer {
        nearer_of_amplitude(amplitude)
    }
    #[inline(always)]
    fn value(amplitude: f64, excess_below: DoubleDouble, ratio_above: DoubleDouble) -> f64 {
        let value = R::round(amplitude_above(amplitude), excess_below, ratio_above);
        if within_pi(amplitude) { value } else { f64::NAN }
    }
}

/// T/T0 of the amplitude π − δ.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct RatioNearTop;

impl PeriodFunction for RatioNearTop {
    #[inline(always)]
    fn nearer(complement: f64) -> Nearer {
        let above = complement < std::f64::consts::FRAC_PI_2;
        Nearer::new(above, complement_of(complement), DoubleDouble::from(complement))
    }
    #[inline(always)]
    fn value(complement: f64, excess_below: DoubleDouble, ratio_above: DoubleDouble) -> f64 {
        let inside = (f64::MIN_POSITIVE..=DoubleDouble::PI.hi).contains(&complement);
        let ratio = Ratio::round(complement < std::f64::consts::FRAC_PI_2, excess_below, ratio_above);
        if inside { ratio } else { f64::NAN }
    }
}

/// A function at one argument.
pub(super) struct One<P>(pub(super) P, pub(super) f64);

impl<P: PeriodFunction> Kernel for One<P> {
    type Output = f64;
    #[inline(always)]
    fn run(self) -> f64 {
        let Nearer { s, u } = P::nearer(self.1);
        let excess = excess_below(u);
        P::value(self.1, excess, ratio_above(excess, log_inverse_nome(s, u)))
    }
}

/// The period ratio T/T0 of the libration with this amplitude in radians; even in the amplitude.
///
/// # Domain
/// |θ0| up to the largest `f64` below π, where the ratio is 24.64…; NaN above.
/// # Accuracy
/// 0.56 ulp (ledger in `tests/suite/promises.rs`).
/// # Examples
/// ```
/// # extern crate libration_pendulum as libration;
/// use libration::pendulum::period_ratio;
/// assert_eq!(period_ratio(std::f64::consts::FRAC_PI_2), 1.1803405990160963);
/// ```
#[must_use]
pub fn period_ratio(amplitude: f64) -> f64 {
    dispatch(One(OfAmplitude(Ratio), amplitude))
}

/// T/T0 − 1 for an amplitude in radians, with full relative accuracy however small it is.
///
/// # Domain
/// As [`period_ratio`].
/// # Accuracy
/// 0.9 ulp down to θ0 = 1e-150, below which the result θ0²/16 leaves the range of `f64`
/// (ledger in `tests/suite/promises.rs`).
#[must_use]
pub fn period_excess(amplitude: f64) -> f64 {
    dispatch(One(OfAmplitude(Excess), amplitude))
}

/// T/T0 of the amplitude π − δ, for a complement δ in radians.
///
/// # Domain
/// 2.3e-308 ≤ δ ≤ π; NaN outside.
/// # Accuracy
/// 0.56 ulp (ledger in `tests/suite/promises.rs`).
#[must_use]
pub fn period_ratio_near_top(complement: f64) -> f64 {
    dispatch(One(RatioNearTop, complement))
}

/// T/T0 and T/T0 − 1 from the amplitude and its complement in two words each.
pub(super) fn ratio_and_excess(amplitude: DoubleDouble, complement: DoubleDouble) -> (f64, f64) {
    if complement.hi < f64::MIN_POSITIVE {
        let ratio = ratio_at_the_top(complement.hi);
        return (ratio, ratio - 1.0);
    }
    dispatch(OfWords { amplitude, complement })
}

struct OfWords {
    amplitude: DoubleDouble,
    complement: DoubleDouble,
}

impl Kernel for OfWords {
    type Output = (f64, f64);
    #[inline(always)]
    fn run(self) -> (f64, f64) {
        let above = amplitude_above(self.amplitude.hi);
        let Nearer { s, u } = Nearer::new(above, self.amplitude, self.complement);
        let below = excess_below(u);
        let ratio = ratio_above(below, log_inverse_nome(s, u));
        (Ratio::round(above, below, ratio), Excess::round(above, below, ratio))
    }
}

/// T/T0 for subnormal complements, where G(s) = 1 and only the logarithm matters.
#[cold]
fn ratio_at_the_top(complement: f64) -> f64 {
    if complement == 0.0 {
        return f64::INFINITY;
    }
    let log = DoubleDouble::LN_2 * 3.0 - two_word::ln(DoubleDouble::from(complement));
    (log * DoubleDouble::FRAC_2_PI).to_f64()
}
