//! Theta functions of the smaller of the two nomes, from which every Jacobi function is a quotient.
//!
//! For q ≤ e^−π four terms reach double precision. With X = 2 cos 2z the series factor as θ₁ = 2q^¼ sin z·p₁, θ₂ = 2q^¼ cos z·p₂, θ₃ = p₃, θ₄ =
//! p₄, each p a cubic in Y = qX (DLMF 20.2). For moduli above 1/√2, Jacobi's imaginary transformation (DLMF 20.7(viii)) turns sin, cos into
//! sinh, cosh and q into the complementary nome, with the same polynomials p. A shift by a quarter period exchanges p₁ with p₂ and p₃ with p₄,
//! so one evaluation, within an eighth of a turn of the nearest quarter, suffices.
//!
//! # Method
//! The phase clock converts time to turns with a frequency in two words and fused multiply-adds; whole turns are split off exactly before any
//! rounding. Even after a million periods no digits are lost beyond the rounding of the time as an `f64`: angle and velocity are within 2.2 ulp
//! and the complement within 2.5, plus 2⁻⁵¹ of the time. From 2⁹⁷ periods on an eighth of a period is undetermined; states and Jacobi functions
//! are then NaN, except am and the unwrapped angle of a rotation. Batches of varying amplitude have the period in one word and end at 2⁴⁹
//! periods.

use super::first_of_point;
use crate::double_double::{DoubleDouble, fast_two_sum, two_prod, two_sum};
use crate::elementary::{sin_cos_of_turns, sinh_cosh};
use crate::fused::FusedMultiplyAdd;

/// The series for one nome q ≤ e^−π, each without its leading 1.
#[derive(Clone, Copy, Debug)]
pub struct ThetaSeries {
    q: f64,
    sine: [f64; 4],
    cosine: [f64; 4],
    third: [f64; 4],
}

/// The values at z = 0, accurate to the second word.
#[derive(Clone, Copy, Debug)]
pub struct ThetaZero {
    /// θ₂(0)/2q^¼.
    pub second: DoubleDouble,
    /// θ₃(0).
    pub third: DoubleDouble,
    /// θ₄(0).
    pub fourth: DoubleDouble,
}

impl ThetaZero {
    /// The values for a nome q up to slightly above e^−π.
    pub fn in_two_words(q: DoubleDouble) -> Self {
        let one = DoubleDouble::ONE;
        let (mut second, mut third, mut fourth) = (one, one, one);
        // q^n² and q^n(n+1), by their ratios q^(2n−1) and q^2n; the seventh terms are below 1e-60.
        let (mut square, mut pronic) = (one, one);
        let (mut square_ratio, mut pronic_ratio) = (q, q.square());
        for n in 1..=6 {
            square = square * square_ratio;
            pronic = pronic * pronic_ratio;
            square_ratio = square_ratio * q.square();
            pronic_ratio = pronic_ratio * q.square();
            second = second + pronic;
            third = third + square.scaled(2.0);
            fourth = fourth + square.scaled(if n % 2 == 0 { 2.0 } else { -2.0 });
        }
        Self { second, third, fourth }
    }
}

impl ThetaZero {
    /// The values for a nome q up to slightly above e^−π, with errors of 2⁻⁶⁰.
    #[inline(always)]
    pub fn from_nome(q: DoubleDouble) -> Self {
        let q2 = q.hi * q.hi;
        let q4 = q2 * q2;
        let (even, odd) = (2.0 * q4, 2.0 * (q4 * q4 * q.hi));
        let twice = q.scaled(2.0);
        let with = |sign: f64| {
            let sum = fast_two_sum(1.0, sign * twice.hi);
            fast_two_sum(sum.hi, sum.lo + (sign * (twice.lo + odd) + even))
        };
        let second = fast_two_sum(1.0, q2 + q4 * (q2 + q4 * q4));
        Self { second, third: with(1.0), fourth: with(-1.0) }
    }
}

/// θ₁/2q^¼, θ₂/2q^¼, θ₃, θ₄ at a point counted from the nearest even quarter, in two words with errors of 2⁻⁵².
#[derive(Clone, Copy, Debug)]
pub struct ThetaValues {
    pub first: DoubleDouble,
    pub second: DoubleDouble,
    pub third: DoubleDouble,
    pub fourth: DoubleDouble,
}

impl ThetaSeries {
    #[inline(always)]
    pub fn new(q: f64) -> Self {
        let q2 = q * q;
        let q4 = q2 * q2;
        let (q5, q6, q8) = (q4 * q, q4 * q2, q4 * q4);
        let (q9, q10, q12) = (q8 * q, q8 * q2, q8 * q4);
        let constant = -(q2 + (q6 - q12));
        let linear = q - (q5 + 2.0 * (q10 * q));
        let square = q4 - q10;
        Self {
            q,
            sine: [constant, -linear, square, -q9],
            cosine: [constant, linear, square, q9],
            third: [-2.0 * q4, 1.0 - 3.0 * q8, q2, q6],
        }
    }

    /// θ₂(0)/2q^¼.
    #[inline(always)]
    pub fn second_at_zero(&self) -> DoubleDouble {
        let q2 = self.q * self.q;
        let q4 = q2 * q2;
        fast_two_sum(1.0, q2 + q4 * (q2 + q4 * q4))
    }

    /// θ₄(0); the next term is below 1e-21.
    #[inline(always)]
    pub fn fourth_at_zero(&self) -> DoubleDouble {
        let q4 = (self.q * self.q) * (self.q * self.q);
        fast_two_sum(1.0, 2.0 * q4 - 2.0 * (self.q + q4 * q4 * self.q))
    }

    /// The values from the sine and cosine of z, or their hyperbolic counterparts.
    #[inline(always)]
    pub fn at<S: Side>(&self, sine: DoubleDouble, cosine: DoubleDouble) -> ThetaValues {
        self.at_square(sine, cosine, S::SQUARE)
    }

    /// The same values for a side known only at run time, given by its `SQUARE`.
    #[inline(always)]
    pub fn at_square(&self, sine: DoubleDouble, cosine: DoubleDouble, square: f64) -> ThetaValues {
        let x = square.fma(sine.hi * sine.hi, 2.0);
        // For k′ below 1e-300 the nome is zero, and the square of the hyperbolic sine may overflow.
        let y = self.q * if x > f64::MAX { f64::MAX } else { x };
        let [even, slope, square, cube] = self.third;
        let even = (y * y).fma(square, even);
        let odd = y * (y * y).fma(cube, slope);
        ThetaValues {
            first: raised(sine, cubic(&self.sine, y)),
            second: raised(cosine, cubic(&self.cosine, y)),
            third: fast_two_sum(1.0, even + odd),
            fourth: fast_two_sum(1.0, even - odd),
        }
    }
}

/// x·(1 + change) for a change below 0.3.
#[inline(always)]
fn raised(x: DoubleDouble, change: f64) -> DoubleDouble {
    fast_two_sum(x.hi, x.hi.fma(change, x.lo))
}

/// factor·above/below, rounded once.
#[inline(always)]
pub fn quotient(factor: DoubleDouble, above: DoubleDouble, below: DoubleDouble) -> f64 {
    ratio(scaled_by(factor, above), below)
}

/// numerator/below, rounded once.
#[inline(always)]
pub(crate) fn ratio(numerator: DoubleDouble, below: DoubleDouble) -> f64 {
    let inverse = 1.0 / below.hi;
    let quotient = numerator.hi * inverse;
    let residual = (-quotient).fma(below.hi, numerator.hi) + (-quotient).fma(below.lo, numerator.lo);
    residual.fma(inverse, quotient)
}

/// factor·x with words that are not normalised.
#[inline(always)]
pub fn scaled_by(factor: DoubleDouble, x: DoubleDouble) -> DoubleDouble {
    let product = two_prod(factor.hi, x.hi);
    DoubleDouble::new(product.hi, factor.hi.fma(x.lo, factor.lo.fma(x.hi, product.lo)))
}

/// The expansion by the smaller nome, chosen at compile time.
pub trait Side: Copy {
    /// X = 2 + SQUARE·sine².
    const SQUARE: f64;
    /// The sine and cosine, or their hyperbolic counterparts, of z = rest·scale: |rest| ≤ 1/8 turn.
    fn sine_cosine(rest: DoubleDouble, scale: DoubleDouble) -> (DoubleDouble, DoubleDouble);
    /// θ₂ and θ₄, the numerator of the quotient that belongs to θ₁/θ₃ first.
    fn beside(values: &ThetaValues) -> (DoubleDouble, DoubleDouble);

    /// The theta values for the rest of a phase; θ₁ is divided by i where z is imaginary.
    #[inline(always)]
    fn values(series: &ThetaSeries, rest: DoubleDouble, scale: DoubleDouble) -> ThetaValues {
        let (sine, cosine) = Self::sine_cosine(rest, scale);
        series.at::<Self>(sine, cosine)
    }
}

/// Sines and cosines: k ≤ k′.
#[derive(Clone, Copy, Debug)]
pub struct CircularSide;

/// Hyperbolic sines and cosines: k > k′.
#[derive(Clone, Copy, Debug)]
pub struct HyperbolicSide;

impl Side for CircularSide {
    const SQUARE: f64 = -4.0;
    #[inline(always)]
    fn sine_cosine(rest: DoubleDouble, _: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
        sin_cos_of_turns(rest)
    }
    #[inline(always)]
    fn beside(values: &ThetaValues) -> (DoubleDouble, DoubleDouble) {
        (values.second, values.fourth)
    }
}

impl Side for HyperbolicSide {
    const SQUARE: f64 = 4.0;
    #[inline(always)]
    fn sine_cosine(rest: DoubleDouble, scale: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
        sinh_cosh(rest * scale)
    }
    #[inline(always)]
    fn beside(values: &ThetaValues) -> (DoubleDouble, DoubleDouble) {
        (values.fourth, values.second)
    }
}

#[inline(always)]
fn cubic(c: &[f64; 4], y: f64) -> f64 {
    y.fma(y.fma(y.fma(c[3], c[2]), c[1]), c[0])
}

/// A point of a periodic motion: whole turns, the nearest quarter (−2 … 2) and the rest, |rest| ≤ 1/8 turn, or NaN if the rest is not known.
#[derive(Clone, Copy, Debug)]
pub struct Phase {
    pub turns: f64,
    pub quarter: f64,
    pub rest: DoubleDouble,
}

/// The uniform advance of a phase: turns = frequency·t + quarter/4 + offset.
#[derive(Clone, Copy, Debug)]
pub struct PhaseClock {
    /// Turns per unit of the argument.
    pub frequency: DoubleDouble,
    /// The nearest quarter for argument zero, −2 … 2.
    pub quarter: f64,
    /// Turns from the nearest quarter at argument zero, relatively accurate: a start next to the turning point must keep its small velocity.
    pub offset: DoubleDouble,
}

impl PhaseClock {
    /// The clock whose orbit, of quarter period K, has these sn, cn and dn at argument zero. Past the middle of a quarter the distance to its
    /// end, v = K − u, is computed, with sn v = cn u/dn u, cn v = k′ sn u/dn u and dn v = k′/dn u (DLMF 22.4.3).
    pub fn through(
        [sn, cn, dn]: [DoubleDouble; 3],
        complementary: DoubleDouble,
        first: DoubleDouble,
        frequency: DoubleDouble,
    ) -> Self {
        let (sn_size, cn_size) = (sn.abs(), cn.abs());
        let from_end = cn_size / dn;
        let ends = from_end.hi < sn_size.hi;
        let distance = if ends {
            let dn = complementary / dn;
            first_of_point(from_end, sn_size * dn, dn)
        } else {
            first_of_point(sn_size, cn_size, dn)
        };
        // The nearest quarter, and whether the point is past it.
        let (quarter, past) = match (ends, cn.hi < 0.0) {
            (true, falling) => (1.0, falling),
            (false, false) => (0.0, true),
            (false, true) => (2.0, false),
        };
        let sign = if sn.hi < 0.0 { -1.0 } else { 1.0 };
        let offset = (distance / first).scaled(if past { 0.25 * sign } else { -0.25 * sign });
        Self { frequency, quarter: sign * quarter, offset }
    }

    /// The phase of argument zero, in turns.
    pub fn start(&self) -> DoubleDouble {
        self.offset + 0.25 * self.quarter
    }
}

/// 2⁹⁷: from here on the error of the frequency, 2⁻¹⁰⁰ in two words, amounts to an eighth of a turn or more.
const MOST_TURNS: f64 = 1.5845632502852868e29;

impl PhaseClock {
    /// The phase at t, whose fraction has an error of 2⁻¹⁰⁰ of the turns passed; unknown from [`MOST_TURNS`] on.
    #[inline(always)]
    pub fn phase(&self, t: f64) -> Phase {
        let product = two_prod(t, self.frequency.hi);
        let sum = two_sum(product.hi, self.offset.hi);
        let lo = t.fma(self.frequency.lo, product.lo) + (sum.lo + self.offset.lo);
        // The number of turns is NaN if the time is not finite; for a finite time it may overflow to infinity.
        Phase::from_turns(DoubleDouble::new(0.0f64.fma(t, sum.hi), lo), MOST_TURNS).advanced(self.quarter)
    }
}

impl Phase {
    /// The parts of a number of turns, whose words need not be normalised and may have overflowed. From `most` turns on the fraction is not
    /// known, and the rest is NaN.
    #[inline(always)]
    pub fn from_turns(turns: DoubleDouble, most: f64) -> Self {
        let whole = turns.hi.round_ties_even();
        // Beyond 2⁵³ turns the second word may contain whole turns too.
        let fraction = two_sum(turns.hi - whole, turns.lo);
        let more = fraction.hi.round_ties_even();
        let fraction_hi = fraction.hi - more;
        let quarter = (4.0 * fraction_hi).round_ties_even();
        let is_determined = whole.abs() < most;
        let rest = fast_two_sum(
            if is_determined { (-0.25f64).fma(quarter, fraction_hi) } else { f64::NAN },
            if is_determined { fraction.lo } else { 0.0 },
        );
        Self {
            turns: if is_determined { whole + more } else { turns.hi },
            quarter: if is_determined { quarter } else { 0.0 },
            rest,
        }
    }

    /// The phase advanced by `quarters` quarters, −2 … 2.
    #[inline(always)]
    fn advanced(self, quarters: f64) -> Self {
        let quarter = self.quarter + quarters;
        let over = if quarter > 2.0 { 1.0 } else { 0.0 };
        let under = if quarter < -2.0 { 1.0 } else { 0.0 };
        let turn = over - under;
        Self { turns: self.turns + turn, quarter: (-4.0f64).fma(turn, quarter), rest: self.rest }
    }

    /// Returns `true` if the nearest quarter is odd.
    #[inline(always)]
    pub fn is_odd(&self) -> bool {
        self.quarter.abs() > 0.5 && self.quarter.abs() < 1.5
    }

    /// The sign that sn has at the nearest odd quarter, and its slope at the nearest even one.
    #[inline(always)]
    pub fn sign(&self) -> f64 {
        // Quarters 0 and 1 are positive; −2, −1 and 2 are negative.
        if self.quarter > -0.5 && self.quarter < 1.5 { 1.0 } else { -1.0 }
    }
}
