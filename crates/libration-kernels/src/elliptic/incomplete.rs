//! Legendre's incomplete integrals from Carlson's symmetric ones (DLMF 19.25.5, 19.25.10).
//!
//! # Method
//! φ is reduced by the nearest quarter turn, in two words and with π in three, since sine and cosine of the rest are then both relatively
//! accurate. Half turns are counted by the sign of the rest: next to an odd quarter turn the integrand is as large as 1/k′, and a rounded
//! quotient would put φ on the wrong side. F and E have an error of at most 0.56 ulp at any φ; from 1e18 on they equal their mean growth. Both
//! come from one duplication, E as a sum of positive terms.
//!
//! In a batch, a block of 64 elements continues until its last element needs no further step; elements that have converged stay unchanged.

use super::Modulus;
use super::carlson::{Closeness, Duplication};
use super::nearer::Nearer;
use crate::dispatch::{Kernel, dispatch};
use crate::double_double::{DoubleDouble, pick, two_prod, two_sum};
use crate::elementary::fine_sin_cos;
use std::marker::PhantomData;

/// The reduction φ = `half_turns`·π + rest, |rest| ≤ π/2, as the sine of the rest and its nonnegative cosine.
#[derive(Clone, Copy)]
pub(super) struct Reduced {
    pub(super) half_turns: DoubleDouble,
    pub(super) sine: DoubleDouble,
    pub(super) cosine: DoubleDouble,
}

/// Angle from which an integral equals its mean growth: the contribution of the rest, at most the value at π/2, is below a hundredth of an ulp.
pub(super) const LARGEST_REDUCED: f64 = 1e18;

/// π/2 minus its first two words.
const FRAC_PI_2_THIRD: f64 = 0.5 * DoubleDouble::PI_TAIL.lo;

impl Reduced {
    /// Reduces φ by the nearest quarter turn, so that sine and cosine of the rest are both relatively accurate. The sign of the rest, and not a
    /// rounded quotient, decides on which side of an odd quarter φ lies.
    #[inline(always)]
    pub(super) fn new(phi: f64) -> Self {
        let (first, rest) = nearest_quarter(DoubleDouble::from(phi));
        // The first quotient may be wrong in its last bit, which is many quarters if there are more than 2⁵³ of them.
        let (second, rest) = nearest_quarter(rest);
        let quarters = two_sum(first, second);
        let (sine, cosine) = fine_sin_cos(rest);
        let odd = (parity(first) - parity(second)).abs() > 0.5;
        let side = if rest.hi > 0.0 { 1.0 } else { -1.0 };
        Self {
            half_turns: pick(odd, quarters + side, quarters).scaled(0.5),
            sine: pick(odd, cosine.scaled(-side), sine),
            cosine: pick(odd, sine.scaled(side), cosine),
        }
    }
}

/// The nearest number of quarter turns, and the rest of the angle.
#[inline(always)]
fn nearest_quarter(angle: DoubleDouble) -> (f64, DoubleDouble) {
    let quarters = (angle.hi * std::f64::consts::FRAC_2_PI).round_ties_even();
    let rest = angle
        - two_prod(DoubleDouble::FRAC_PI_2.hi, quarters)
        - two_prod(DoubleDouble::FRAC_PI_2.lo, quarters)
        - FRAC_PI_2_THIRD * quarters;
    (quarters, rest)
}

/// One for an odd integer, zero for an even one.
#[inline(always)]
fn parity(integer: f64) -> f64 {
    (integer - 2.0 * (0.5 * integer).round_ties_even()).abs()
}

/// F at the point with this sine, this cosine ≥ 0 and this delta = dn, in two words.
pub fn first_of_point(sine: DoubleDouble, cosine: DoubleDouble, delta: DoubleDouble) -> DoubleDouble {
    dispatch(FirstOfPoint([sine, cosine, delta]))
}

struct FirstOfPoint([DoubleDouble; 3]);

impl Kernel for FirstOfPoint {
    type Output = DoubleDouble;
    #[inline(always)]
    fn run(self) -> DoubleDouble {
        let [sine, cosine, delta] = self.0;
        let roots = [cosine, delta, DoubleDouble::ONE];
        let mut duplication = Duplication::new(roots, roots.map(DoubleDouble::square));
        duplication.run::<false>(Closeness::TwoWords);
        sine * duplication.first_kind()
    }
}

/// An integral of an angle and a modulus.
pub(super) trait OfAngle {
    /// `true` if Carlson's `R_D` is needed in addition to `R_F`.
    const SECOND: bool;
    /// The integral to the reduced angle; `#[inline(always)]`.
    fn partial(nearer: &Nearer, reduced: &Reduced, duplication: &Duplication) -> DoubleDouble;
}

/// F(φ, k).
pub(super) struct First;

/// E(φ, k).
pub(super) struct Second;

impl OfAngle for First {
    const SECOND: bool = false;
    #[inline(always)]
    fn partial(_: &Nearer, reduced: &Reduced, duplication: &Duplication) -> DoubleDouble {
        reduced.sine * duplication.first_kind()
    }
}

impl OfAngle for Second {
    const SECOND: bool = true;
    /// k′²(s·`R_F` + k²s³·`R_D`/3) + k²·s·cos φ/Δ: a sum of positive terms.
    #[inline(always)]
    fn partial(nearer: &Nearer, reduced: &Reduced, duplication: &Duplication) -> DoubleDouble {
        let Reduced { sine, cosine, .. } = *reduced;
        let [parameter, complementary] = nearer.parameters();
        let square = sine.square();
        let integrals = duplication.first_kind() + parameter * square * duplication.third_of_second_kind();
        let delta = delta_square(nearer, reduced).sqrt();
        sine * (complementary * integrals + parameter * cosine.over(delta))
    }
}

/// 1 − k² sin²φ as cos²φ + k′² sin²φ; the cosine of an `f64` is never small enough for its square to underflow.
#[inline(always)]
fn delta_square(nearer: &Nearer, reduced: &Reduced) -> DoubleDouble {
    let [_, complementary] = nearer.parameters();
    reduced.cosine.square() + complementary * reduced.sine.square()
}

/// The duplication of a reduced angle, before its first step.
#[inline(always)]
pub(super) fn duplication(nearer: &Nearer, reduced: &Reduced) -> Duplication {
    let square = delta_square(nearer, reduced);
    let roots = [reduced.cosine, square.sqrt(), DoubleDouble::ONE];
    Duplication::new(roots, [reduced.cosine.square(), square, DoubleDouble::ONE])
}

/// The integral to φ, from its values over a quarter turn and over the reduced angle.
#[inline(always)]
pub(super) fn whole(half_turns: DoubleDouble, quarter: DoubleDouble, partial: DoubleDouble) -> f64 {
    // With zero half turns, 0·∞ would be NaN, and an infinite product has no second word.
    let turns = half_turns.scaled(2.0);
    let sum = (quarter * turns + partial).to_f64();
    let sum = if quarter.hi < f64::INFINITY { sum } else { turns.hi * f64::INFINITY };
    if half_turns.hi == 0.0 { partial.to_f64() } else { sum }
}

/// The integral for φ = 0, for |φ| above [`LARGEST_REDUCED`], and for a φ that is not finite, where it is NaN.
#[cold]
pub(super) fn of_extreme(phi: f64, quarter: DoubleDouble) -> f64 {
    if phi == 0.0 {
        return phi;
    }
    if phi.is_finite() { mean_growth(quarter, phi) } else { f64::NAN }
}

/// Returns `true` if [`of_extreme`] gives the integral.
#[inline(always)]
pub(super) fn is_extreme(phi: f64) -> bool {
    let within = phi.abs() > 0.0 && phi.abs() <= LARGEST_REDUCED;
    !within
}

/// quarter·2φ/π, which may overflow.
fn mean_growth(quarter: DoubleDouble, phi: f64) -> f64 {
    if !quarter.is_finite() {
        return f64::INFINITY.copysign(phi);
    }
    let (fraction, exponent) = libm::frexp(phi);
    libm::scalbn((quarter * DoubleDouble::FRAC_2_PI * fraction).to_f64(), exponent)
}

pub(super) fn first(modulus: &Modulus, phi: f64) -> f64 {
    if is_extreme(phi) {
        return of_extreme(phi, modulus.integrals.first);
    }
    dispatch(One(PhantomData::<First>, &modulus.nearer, modulus.integrals.first, phi))
}

pub(super) fn second(modulus: &Modulus, phi: f64) -> f64 {
    if is_extreme(phi) {
        return of_extreme(phi, modulus.integrals.second);
    }
    dispatch(One(PhantomData::<Second>, &modulus.nearer, modulus.integrals.second, phi))
}

/// Returns `true` if the integral to this angle needs no integral over a quarter turn.
pub(super) fn is_in_first_quarter(phi: f64) -> bool {
    phi.abs() <= std::f64::consts::FRAC_PI_2 && !is_extreme(phi)
}

/// An integral to an angle [in the first quarter](is_in_first_quarter), without further preparation of the modulus.
pub(super) fn in_first_quarter<F: OfAngle>(nearer: &Nearer, phi: f64) -> f64 {
    dispatch(One(PhantomData::<F>, nearer, DoubleDouble::ZERO, phi))
}

/// An integral at one angle, given its value over a quarter turn.
struct One<'a, F>(PhantomData<F>, &'a Nearer, DoubleDouble, f64);

impl<F: OfAngle> Kernel for One<'_, F> {
    type Output = f64;
    #[inline(always)]
    fn run(self) -> f64 {
        let Self(_, nearer, quarter, phi) = self;
        let reduced = Reduced::new(phi);
        let mut duplication = duplication(nearer, &reduced);
        if F::SECOND {
            duplication.run::<true>(Closeness::Rounding);
        } else {
            duplication.run::<false>(Closeness::Rounding);
        }
        whole(reduced.half_turns, quarter, F::partial(nearer, &reduced, &duplication))
    }
}
