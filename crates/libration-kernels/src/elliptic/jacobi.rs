//! Jacobi's sn, cn, dn and the amplitude am as quotients of theta functions (DLMF 22.2).

use super::descent::Descent;
use super::nearer::Nearer;
use super::{
    CircularSide, HyperbolicSide, Phase, PhaseClock, Side, ThetaSeries, ThetaValues, ThetaZero, ratio,
    scaled_by,
};
use crate::dispatch::{Kernel, dispatch};
use crate::double_double::{DoubleDouble, fast_two_sum, magnitude, pick};
use crate::elementary::{atan_of_ratio, sinh_cosh, two_word};
use crate::fused::FusedMultiplyAdd;

/// Jacobi's functions at one argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobi {
    /// sn u = sin am u.
    pub sn: f64,
    /// cn u = cos am u.
    pub cn: f64,
    /// dn u = √(1 − m sn² u).
    pub dn: f64,
    /// am u, unwrapped: am(u + 2K) = am u + π.
    pub am: f64,
}

/// The quantities of a modulus that its Jacobi functions need.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quotients {
    clock: PhaseClock,
    /// z of the theta functions for one turn of 4K.
    scale: DoubleDouble,
    series: ThetaSeries,
    factors: Factors,
    degenerate: bool,
}

/// The factors of the quotients that do not depend on the point, from the values a₀ … d₀ of the four series at zero, without the common factors
/// that cancel in the quotients:
///
/// | expansion | third | beside | other | other of an odd quarter |
/// |---|---|---|---|---|
/// | circular | c₀ | b₀ | d₀ | d₀ |
/// | hyperbolic | c₀ | d₀ | b₀ | 4√q·b₀ |
#[derive(Clone, Copy, Debug)]
pub(crate) struct Factors {
    pub(crate) above: bool,
    pub(crate) third: DoubleDouble,
    pub(crate) beside: DoubleDouble,
    pub(crate) other: DoubleDouble,
    pub(crate) odd_other: DoubleDouble,
}

impl Factors {
    #[inline(always)]
    pub(crate) fn new(above: bool, nome: DoubleDouble, four_roots: DoubleDouble) -> Self {
        let ThetaZero { second, third, fourth } = ThetaZero::from_nome(nome);
        let (beside, other) = (pick(above, fourth, second), pick(above, second, fourth));
        let odd_other = pick(above, four_roots * second, fourth);
        Self { above, third, beside, other, odd_other }
    }
}

impl Quotients {
    #[inline(always)]
    pub(crate) fn new(nearer: &Nearer, descent: &Descent, log: DoubleDouble) -> Self {
        let nome = Self::nome(nearer, descent);
        let frequency = Self::frequency(nearer, descent, log);
        Self {
            clock: PhaseClock { frequency, quarter: 0.0, offset: DoubleDouble::ZERO },
            scale: pick(nearer.above, log.scaled(2.0), DoubleDouble::PI.scaled(2.0)),
            series: ThetaSeries::new(nome.to_f64()),
            factors: Factors::new(nearer.above, nome, Self::four_roots(nearer, descent)),
            degenerate: nearer.above && nearer.smaller.hi == 0.0,
        }
    }

    /// 1/4K.
    #[inline(always)]
    pub(crate) fn frequency(nearer: &Nearer, descent: &Descent, log: DoubleDouble) -> DoubleDouble {
        pick(nearer.above, descent.far_frequency(log), descent.near_frequency())
    }

    /// The smaller nome.
    #[inline(always)]
    pub(crate) fn nome(nearer: &Nearer, descent: &Descent) -> DoubleDouble {
        descent.nome().scaled(nearer.lowering()).scaled(nearer.lowering())
    }

    /// 4√q of the smaller nome: where this is subnormal, √q would have lost digits.
    #[inline(always)]
    pub(crate) fn four_roots(nearer: &Nearer, descent: &Descent) -> DoubleDouble {
        descent.root_of_nome(4.0 * nearer.lowering())
    }

    pub(crate) fn turn_scale(&self) -> DoubleDouble {
        self.scale
    }

    pub(crate) fn at(&self, u: f64) -> Jacobi {
        if self.degenerate { hyperbolic_limit(u) } else { dispatch(At { quotients: self, u }) }
    }
}

struct At<'a> {
    quotients: &'a Quotients,
    u: f64,
}

impl Kernel for At<'_> {
    type Output = Jacobi;
    #[inline(always)]
    fn run(self) -> Jacobi {
        let Quotients { clock, scale, series, factors, .. } = self.quotients;
        let phase = clock.phase(self.u);
        let values = if factors.above {
            HyperbolicSide::values(series, phase.rest, *scale)
        } else {
            CircularSide::values(series, phase.rest, *scale)
        };
        let (above, below) = factors.tangent(&phase, &values);
        let Copolar { sn, cn, dn } = factors.copolar(&phase, &values);
        Jacobi { sn, cn, dn, am: amplitude(&phase, above, below) }.or_small(self.u)
    }
}

/// 2⁻²⁷: for smaller |u|, sn u and am u are u, cn u and dn u are one, each within a fifth of an ulp.
const SMALL: f64 = 7.450580596923828e-9;

impl Jacobi {
    /// The same functions; next to zero their leading terms, with the sign of zero and every digit of a subnormal argument.
    #[inline(always)]
    pub(crate) fn or_small(self, u: f64) -> Self {
        let small = u.abs() < SMALL;
        let one = |value: f64| if small { 1.0 } else { value };
        let same = |value: f64| if small { u } else { value };
        Self { sn: same(self.sn), cn: one(self.cn), dn: one(self.dn), am: same(self.am) }
    }
}

/// sn, cn and dn.
pub(crate) struct Copolar {
    pub(crate) sn: f64,
    pub(crate) cn: f64,
    pub(crate) dn: f64,
}

impl Factors {
    /// θ₂ and θ₄, the numerator of the quotient that belongs to θ₁/θ₃ first.
    #[inline(always)]
    fn in_order(&self, values: &ThetaValues) -> (DoubleDouble, DoubleDouble) {
        (pick(self.above, values.fourth, values.second), pick(self.above, values.second, values.fourth))
    }

    /// The quotients at a phase in turns of 4K. With a, b, c, d for θ₁ … θ₄ at the nearest quarter:
    ///
    /// | expansion, quarter | sn | cn | dn | tan of am from the quarter |
    /// |---|---|---|---|---|
    /// | circular, even | a/d | b/d | c/d | a/b |
    /// | circular, odd | b/c | −a/c | d/c | a/b |
    /// | hyperbolic, even | a/b | d/b | c/b | a/d |
    /// | hyperbolic, odd | d/c | −a/c | b/c | a/d |
    #[inline(always)]
    pub(crate) fn copolar(&self, phase: &Phase, values: &ThetaValues) -> Copolar {
        let (odd, sign) = (phase.is_odd(), phase.sign());
        let (beside, other) = self.in_order(values);
        let ThetaValues { first, third, .. } = *values;
        let below = pick(odd, third, other);
        let factor = pick(odd, self.odd_other, self.other);
        let denominator = scaled_by(self.beside, below);
        let sn = ratio(scaled_by(self.third, pick(odd, beside, first)), denominator);
        let cn = ratio(scaled_by(factor, pick(odd, -first, beside)), denominator);
        let dn = ratio(scaled_by(factor, pick(odd, other, third)), scaled_by(self.third, below));
        Copolar { sn: sign * within_one(sn), cn: sign * within_one(cn), dn: within_one(dn) }
    }

    /// The tangent of am, counted from the nearest quarter, as a quotient.
    #[inline(always)]
    pub(crate) fn tangent(&self, phase: &Phase, values: &ThetaValues) -> (DoubleDouble, DoubleDouble) {
        let odd = phase.is_odd();
        let (beside, _) = self.in_order(values);
        let above = scaled_by(pick(odd, self.odd_other, self.third), values.first);
        let below = scaled_by(pick(odd, self.third, self.other), beside);
        (above, fast_two_sum(below.hi, below.lo))
    }
}

/// The value, limited to ±1, which rounding may have exceeded; NaN stays NaN.
#[inline(always)]
fn within_one(x: f64) -> f64 {
    if x.abs() > 1.0 { 1f64.copysign(x) } else { x }
}

/// am from the number of quarters and the angle from the nearest quarter, whose tangent is given as a quotient. If that angle is not known, the
/// quarters alone, which are then am to its last bit.
#[inline(always)]
pub(crate) fn amplitude(phase: &Phase, above: DoubleDouble, below: DoubleDouble) -> f64 {
    let size = magnitude(above);
    let steep = size.hi > below.hi;
    let acute = atan_of_ratio(pick(steep, below, size), pick(steep, size, below));
    let angle = pick(steep, DoubleDouble::FRAC_PI_2 - acute, acute);
    let signed = pick(above.hi < 0.0, -angle, angle);
    let signed = pick(phase.rest.hi.is_nan(), DoubleDouble::ZERO, signed);
    let quarters = phase.turns.fma(4.0, phase.quarter);
    (DoubleDouble::FRAC_PI_2 * quarters + signed).to_f64()
}

/// k = 1: sn = tanh, cn = dn = sech, am the Gudermannian (DLMF 22.5(ii)).
pub(crate) fn hyperbolic_limit(u: f64) -> Jacobi {
    let size = u.abs();
    if !u.is_finite() {
        return Jacobi { sn: f64::NAN, cn: f64::NAN, dn: f64::NAN, am: f64::NAN };
    }
    let (tanh, sech, gudermannian) = if size > 0.5 { far(size) } else { near(size) };
    let sign = 1f64.copysign(u);
    Jacobi { sn: sign * tanh, cn: sech, dn: sech, am: sign * gudermannian }
}

/// tanh, sech and the Gudermannian for 0 ≤ u ≤ ½.
fn near(u: f64) -> (f64, f64, f64) {
    let (sinh, cosh) = sinh_cosh(DoubleDouble::from(u));
    let angle = atan_of_ratio(sinh, DoubleDouble::ONE);
    ((sinh / cosh).to_f64(), cosh.recip().to_f64(), angle.to_f64())
}

/// The same functions for u > ½: with p = e^−u they are (1 − p²)/(1 + p²), 2p/(1 + p²) and π/2 − 2 atan p.
fn far(u: f64) -> (f64, f64, f64) {
    let one = DoubleDouble::ONE;
    let power = if u < 745.2 { two_word::exp(DoubleDouble::from(-u)) } else { DoubleDouble::ZERO };
    let square = power.square();
    let angle = DoubleDouble::FRAC_PI_2 - atan_of_ratio(power, one).scaled(2.0);
    let sech = power.scaled(2.0) / (one + square);
    (((one - square) / (one + square)).to_f64(), sech.to_f64(), angle.to_f64())
}
