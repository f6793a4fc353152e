//! K and E rounded once, by polynomials of the nearer parameter.
//!
//! Let p = min(m, 1 − m) ≤ ½ and c² = 1 − p. K(√p), ln(16q/p) and E(√p) are power series in p with radius one. On the other side K(c) =
//! K(√p)·ln(1/q)/π (DLMF 22.2.1), and by Legendre's relation (DLMF 19.7.1) E(c) = 1 + ¼p(A·ln(16/p) − B) with series A and B in p, whose first
//! coefficients are those of DLMF 19.12.1 and 19.12.2. Leading terms are carried in two words, so that the sum is rounded once.
//!
//! # Error budget
//! Errors in units in the last place of the result, at their largest; a test limits the sum to 0.06.
//!
//! | what | error | why |
//! |---|---|---|
//! | p | 0 | given, or in two words |
//! | K(√p): p³·P(p), at most 0.02 of the sum | 0.03 | three roundings, each half a unit of that term |
//! | ln(1/q): p³·P(p), at most 0.008 of it | 0.02 | the same, and those of the tail of ln |
//! | E(√p): p²·P(p), at most 0.018 of the sum | 0.03 | the same |
//! | E(c): ¼p³·P(p)·ln(16/p) and ¼p³·P(p), each at most 0.02 | 0.05 | the same, twice |
//! | tables | 0.01 | 2e-16 of those terms |
//! | the one rounding to `f64` | 0.5 | |
//!
//! # Method
//! The polynomials and logarithms take about fifty operations. Where other functions need the integrals in two words, these come from
//! `complete.rs`.

use super::incomplete::{First, Second};
use super::nearer::Nearer;
use crate::dispatch::{Kernel, dispatch};
use crate::double_double::{DoubleDouble, fast_two_sum, two_prod};
use crate::elementary::{polynomial, split_logarithm};
use crate::fused::FusedMultiplyAdd;
use std::marker::PhantomData;

/// (2K/π − 1 − p/4 − 9p²/64)/p³ in p on [0, ½]: relative error 1.5e-16.
const QUARTER: [f64; 20] = [
    0.09765624999999999,
    0.07476806640626599,
    0.06056213378482227,
    0.05088901564305157,
    0.04387876904524989,
    0.03856617897670197,
    0.03438066968477777,
    0.0313388981668368,
    0.024926040289714527,
    0.05474664480244171,
    -0.16317983211506049,
    0.958238940809081,
    -3.590169812519498,
    10.75605815165084,
    -24.37790513079951,
    41.66217144049439,
    -51.77468614542687,
    44.45183102265583,
    -23.62561304344527,
    5.958370597869313,
];
/// (ln(16 q/p) − p/2 − 13p²/64)/p³ in p on [0, ½]: relative error 3.9e-16.
const LOG_NOME: [f64; 19] = [
    0.1197916666666667,
    0.0824279785155719,
    0.061730957043951734,
    0.048774082253526294,
    0.03998598911423552,
    0.033675915230687345,
    0.028990757642594088,
    0.024790389745877522,
    0.027574141083626633,
    -0.018976715690448002,
    0.2399676201904284,
    -0.9426517037286655,
    3.171662563651804,
    -7.846765386582578,
    14.597888977857346,
    -19.571916796107395,
    18.056775523666403,
    -10.262033966712726,
    2.771197744528364,
];
/// (2E/π − 1 + p/4)/p² in p on [0, ½]: relative error 5.9e-17.
const SECOND: [f64; 19] = [
    -0.046875,
    -0.01953124999999834,
    -0.010681152344146627,
    -0.006729125939025899,
    -0.00462627598006312,
    -0.0033752351119548537,
    -0.0025721606165821785,
    -0.002007544440542363,
    -0.0017959756594654217,
    -0.00012461729324492182,
    -0.008086380698715076,
    0.0291480119920843,
    -0.10005475472478473,
    0.24679697729164898,
    -0.46083646249184484,
    0.6189952550075005,
    -0.5733467898807755,
    0.32721273672953405,
    -0.08916467764317648,
];
/// (A − 1 − 3p/8)/p² in p on [0, ½]: relative error 1.4e-16.
const WITH_LOGARITHM: [f64; 20] = [
    0.23437499999999997,
    0.1708984375000325,
    0.1345825195226279,
    0.11103057951875298,
    0.09450812091475069,
    0.08227443193612255,
    0.07280769583392324,
    0.06595555459018082,
    0.05243355030547925,
    0.11271643719354607,
    -0.3307179143485876,
    1.9495644919983481,
    -7.300343653006185,
    21.8750546517475,
    -49.57815696679512,
    84.73442835787446,
    -105.30624018516053,
    90.41858087613356,
    -48.060419643695354,
    12.122803547533746,
];
/// (B − 1 − 13p/16)/p² in p on [0, ½]: relative error 2.0e-16.
const WITHOUT_LOGARITHM: [f64; 20] = [
    0.5624999999999999,
    0.4276529947917557,
    0.34457397458575517,
    0.2884231592187731,
    0.24797340001624318,
    0.21746416253503748,
    0.19352146622319477,
    0.17613114121249743,
    0.1400814288922512,
    0.30595098475814714,
    -0.9081995777319624,
    5.3385598231270315,
    -19.9987890444081,
    59.91833250496349,
    -135.80085621549495,
    232.0889479221852,
    -288.4264338832439,
    247.63708312398086,
    -131.61910087178464,
    33.19574603939686,
];

/// ln 2 with a first word short enough that its product with an integer below 2¹² is exact.
const LN_2_SHORT: DoubleDouble = DoubleDouble::new(0.6931471805582987, 1.6465949582897082e-12);
/// The exponent of the power of two by which a raised parameter is scaled.
const RAISED: f64 = 1200.0;

/// A complete integral rounded once.
pub(super) trait Rounded {
    /// The value of the integral, given whether m is above one half, p, and ln(16/p); `#[inline(always)]`.
    fn value(above: bool, p: DoubleDouble, log: DoubleDouble) -> f64;
}

impl Rounded for First {
    #[inline(always)]
    fn value(above: bool, p: DoubleDouble, log: DoubleDouble) -> f64 {
        let quarter = quarter(p);
        let far = product(quarter, log_inverse_nome(p, log).scaled(0.5)).to_f64();
        let far = if log.hi < f64::INFINITY { far } else { f64::INFINITY };
        let near = product(quarter, DoubleDouble::FRAC_PI_2).to_f64();
        if above { far } else { near }
    }
}

impl Rounded for Second {
    #[inline(always)]
    fn value(above: bool, p: DoubleDouble, log: DoubleDouble) -> f64 {
        let far = second_far(p, log);
        let far = if p.hi == 0.0 { 1.0 } else { far };
        let near = product(second_near(p), DoubleDouble::FRAC_PI_2).to_f64();
        if above { far } else { near }
    }
}

/// K.
pub fn first(nearer: &Nearer) -> f64 {
    dispatch(One(PhantomData::<First>, nearer))
}

/// E.
pub fn second(nearer: &Nearer) -> f64 {
    dispatch(One(PhantomData::<Second>, nearer))
}

/// A function of one modulus.
struct One<'a, F>(PhantomData<F>, &'a Nearer);

impl<F: Rounded> Kernel for One<'_, F> {
    type Output = f64;
    #[inline(always)]
    fn run(self) -> f64 {
        let nearer = self.1;
        let log = log_of_inverse(nearer.smaller, nearer.raised);
        F::value(nearer.above, nearer.plain_smaller(), log)
    }
}

/// 2K(√p)/π.
#[inline(always)]
fn quarter(p: DoubleDouble) -> DoubleDouble {
    let square = two_prod(p.hi, p.hi);
    let second = two_prod(square.hi, 0.140625);
    let leading = fast_two_sum(1.0, 0.25 * p.hi);
    let sum = fast_two_sum(leading.hi, second.hi);
    let slope = slope(p.hi, [0.25, 0.28125, 3.0 * QUARTER[0], 4.0 * QUARTER[1], 6.0 * QUARTER[2]]);
    let rest = (square.hi * p.hi).fma(polynomial(p.hi, &QUARTER), second.lo);
    let rest = slope.fma(p.lo, square.lo.fma(0.140625, rest));
    DoubleDouble::new(sum.hi, sum.lo + (leading.lo + rest))
}

/// The slope of a series, by which the second word of p is multiplied, to some per cent: the last term stands for the remaining ones.
#[inline(always)]
fn slope<const N: usize>(p: f64, coefficients: [f64; N]) -> f64 {
    polynomial(p, &coefficients)
}

/// 2E(√p)/π.
#[inline(always)]
fn second_near(p: DoubleDouble) -> DoubleDouble {
    let leading = fast_two_sum(1.0, -0.25 * p.hi);
    let slope = slope(p.hi, [-0.25, 2.0 * SECOND[0], 3.0 * SECOND[1], 5.0 * SECOND[2]]);
    let rest = (p.hi * p.hi).fma(polynomial(p.hi, &SECOND), slope * p.lo);
    DoubleDouble::new(leading.hi, leading.lo + rest)
}

/// ln(16/p) for a raised or plain p; infinite for p = 0.
#[inline(always)]
pub(super) fn log_of_inverse(smaller: DoubleDouble, raised: bool) -> DoubleDouble {
    let log = split_logarithm(smaller);
    let powers = if raised { RAISED + 4.0 } else { 4.0 } - log.exponent;
    let sum = fast_two_sum(powers * LN_2_SHORT.hi, -log.leading);
    let hi = if smaller.hi > 0.0 { sum.hi } else { f64::INFINITY };
    DoubleDouble::new(hi, powers.fma(LN_2_SHORT.lo, sum.lo - log.tail))
}

/// ln(1/q), given ln(16/p).
#[inline(always)]
fn log_inverse_nome(p: DoubleDouble, log: DoubleDouble) -> DoubleDouble {
    let square = two_prod(p.hi, p.hi);
    let second = two_prod(square.hi, 0.203125);
    let difference = fast_two_sum(log.hi, -0.5 * p.hi);
    let sum = fast_two_sum(difference.hi, -second.hi);
    let slope = slope(p.hi, [0.5, 0.40625, 3.0 * LOG_NOME[0], 4.0 * LOG_NOME[1], 6.0 * LOG_NOME[2]]);
    let rest = (square.hi * p.hi).fma(polynomial(p.hi, &LOG_NOME), second.lo);
    let rest = slope.fma(p.lo, square.lo.fma(0.203125, rest));
    DoubleDouble::new(sum.hi, sum.lo + (difference.lo + (log.lo - rest)))
}

/// 1 + ¼p(A·ln(16/p) − B), given the logarithm.
#[inline(always)]
fn second_far(p: DoubleDouble, log: DoubleDouble) -> f64 {
    let with = product(log, one_plus(p, 0.375, polynomial(p.hi, &WITH_LOGARITHM)));
    let without = one_plus(p, 0.8125, polynomial(p.hi, &WITHOUT_LOGARITHM));
    let difference = fast_two_sum(with.hi, -without.hi);
    let difference = DoubleDouble::new(difference.hi, difference.lo + (with.lo - without.lo));
    let term = product(p.scaled(0.25), difference);
    let sum = fast_two_sum(1.0, term.hi);
    // The logarithm is computed from p in two words; in the other terms the second word of p is below 2⁻⁵⁶ of the sum.
    sum.hi + (sum.lo + term.lo)
}

/// 1 + slope·p + p²·tail.
#[inline(always)]
fn one_plus(p: DoubleDouble, slope: f64, tail: f64) -> DoubleDouble {
    let first = two_prod(slope, p.hi);
    let sum = fast_two_sum(1.0, first.hi);
    let rest = (p.hi * p.hi).fma(tail, slope.fma(p.lo, first.lo));
    DoubleDouble::new(sum.hi, sum.lo + rest)
}

/// The product of two numbers whose second words may overlap the first words by some bits.
#[inline(always)]
fn product(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    let product = two_prod(a.hi, b.hi);
    DoubleDouble::new(product.hi, a.hi.fma(b.lo, a.lo.fma(b.hi + b.lo, product.lo)))
}
