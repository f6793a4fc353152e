//! Jacobi's sn, cn, dn and the amplitude am as quotients of theta functions (DLMF 22.2).

use super::{
    CircularSide, Expansion, HyperbolicSide, Phase, PhaseClock, Side, ThetaSeries, ThetaValues, ThetaZero,
    quotient, scaled_by,
};
use crate::dispatch::{Kernel, dispatch};
use crate::double_double::DoubleDouble;
use crate::elementary::{atan_of_ratio, sinh_cosh, two_word};

/// Jacobi's functions at one argument.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
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

/// What a modulus needs for its Jacobi functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quotients {
    expansion: Expansion,
    clock: PhaseClock,
    /// z of the theta functions per turn of 4K.
    scale: DoubleDouble,
    root: DoubleDouble,
    series: ThetaSeries,
    /// Factors of sn, cn, dn and am next to an even quarter, then an odd one.
    factors: [Factors; 2],
    degenerate: bool,
}

#[derive(Clone, Copy, Debug)]
struct Factors {
    sn: DoubleDouble,
    cn: DoubleDouble,
    dn: DoubleDouble,
    tangent: DoubleDouble,
}

impl Quotients {
    pub(crate) fn new(
        modulus: DoubleDouble,
        complementary: DoubleDouble,
        first: DoubleDouble,
        complementary_first: DoubleDouble,
    ) -> Self {
        let expansion = Expansion::for_modulus(modulus, complementary);
        let ratio = match expansion {
            Expansion::Circular => complementary_first / first,
            Expansion::Hyperbolic => first / complementary_first,
        };
        let exponent = DoubleDouble::FRAC_PI_2 * ratio;
        let root = if exponent.hi < 745.2 { two_word::exp(-exponent) } else { DoubleDouble::ZERO };
        let series = ThetaSeries::new(root.square().to_f64());
        let scale = match expansion {
            Expansion::Circular => DoubleDouble::PI.scaled(2.0),
            Expansion::Hyperbolic => exponent.scaled(4.0),
        };
        let frequency = first.scaled(4.0).recip();
        let clock = PhaseClock { frequency, quarter: 0.0, offset: DoubleDouble::ZERO };
        let factors = factors(expansion, root, ThetaZero::in_two_words(root.square()));
        Self { expansion, clock, scale, root, series, factors, degenerate: complementary.hi == 0.0 }
    }

    pub(crate) fn root_of_nome(&self) -> DoubleDouble {
        self.root
    }

    pub(crate) fn turn_scale(&self) -> DoubleDouble {
        self.scale
    }

    pub(crate) fn at(&self, u: f64) -> Jacobi {
        if self.degenerate { hyperbolic_limit(u) } else { dispatch(At { quotients: self, u }) }
    }
}

/// The factors of the quotients in the notes beside [`Quotients::jacobi`].
fn factors(expansion: Expansion, root: DoubleDouble, zero: ThetaZero) -> [Factors; 2] {
    let ThetaZero { second, third, fourth } = zero;
    let words = match expansion {
        Expansion::Circular => {
            let same = [third / second, fourth / second, fourth / third];
            [(same, third / fourth), (same, fourth / third)]
        }
        Expansion::Hyperbolic => {
            let (sn, cn, dn) = (third / fourth, second / fourth, second / third);
            let small = root.scaled(4.0);
            [([sn, cn, dn], third / second), ([sn, small * cn, small * dn], small * dn)]
        }
    };
    words.map(|([sn, cn, dn], tangent)| Factors { sn, cn, dn, tangent })
}

struct At<'a> {
    quotients: &'a Quotients,
    u: f64,
}

impl Kernel for At<'_> {
    type Output = Jacobi;
    #[inline(always)]
    fn run(self) -> Jacobi {
        if !self.u.is_finite() {
            return Jacobi { sn: f64::NAN, cn: f64::NAN, dn: f64::NAN, am: f64::NAN };
        }
        self.quotients.jacobi(self.quotients.clock.phase(self.u))
    }
}

impl Quotients {
    /// The quotients at a phase counted in turns of 4K. With a, b, c, d for θ₁ … θ₄ at the nearest quarter:
    ///
    /// | expansion, quarter | sn | cn | dn | tan of am from the quarter |
    /// |---|---|---|---|---|
    /// | circular, even | a/d | b/d | c/d | a/b |
    /// | circular, odd | b/c | −a/c | d/c | a/b |
    /// | hyperbolic, even | a/b | d/b | c/b | a/d |
    /// | hyperbolic, odd | d/c | −a/c | b/c | a/d |
    #[inline(always)]
    fn jacobi(&self, phase: Phase) -> Jacobi {
        let odd = phase.is_odd();
        let sign = phase.sign();
        let Factors { sn, cn, dn, tangent } = self.factors[usize::from(odd)];
        let values = match self.expansion {
            Expansion::Circular => CircularSide::values(&self.series, phase.rest, self.scale),
            Expansion::Hyperbolic => HyperbolicSide::values(&self.series, phase.rest, self.scale),
        };
        let (beside, other) = match self.expansion {
            Expansion::Circular => CircularSide::beside(&values),
            Expansion::Hyperbolic => HyperbolicSide::beside(&values),
        };
        let ThetaValues { first, third, .. } = values;
        let (above, below) =
            if odd { ([beside, -first, other], third) } else { ([first, beside, third], other) };
        Jacobi {
            sn: (sign * quotient(sn, above[0], below)).clamp(-1.0, 1.0),
            cn: (sign * quotient(cn, above[1], below)).clamp(-1.0, 1.0),
            dn: quotient(dn, above[2], below).min(1.0),
            am: amplitude(&phase, scaled_by(tangent, first), beside),
        }
    }
}

/// am: the quarters gone and the angle from the nearest, given its tangent as a quotient.
#[inline(always)]
fn amplitude(phase: &Phase, above: DoubleDouble, below: DoubleDouble) -> f64 {
    let size = above.abs();
    let angle = if size.hi > below.hi {
        DoubleDouble::FRAC_PI_2 - atan_of_ratio(below, size)
    } else {
        atan_of_ratio(size, below)
    };
    let angle = if above.hi < 0.0 { -angle } else { angle };
    let quarters = phase.turns.mul_add(4.0, phase.quarter);
    (DoubleDouble::FRAC_PI_2 * quarters + angle).to_f64()
}

/// k = 1: sn = tanh, cn = dn = sech, am the Gudermannian (DLMF 22.5(ii)).
fn hyperbolic_limit(u: f64) -> Jacobi {
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

/// The same above: of p = e^−u they are (1 − p²)/(1 + p²), 2p/(1 + p²) and π/2 − 2 atan p.
fn far(u: f64) -> (f64, f64, f64) {
    let one = DoubleDouble::ONE;
    let power = if u < 745.2 { two_word::exp(DoubleDouble::from(-u)) } else { DoubleDouble::ZERO };
    let square = power.square();
    let angle = DoubleDouble::FRAC_PI_2 - atan_of_ratio(power, one).scaled(2.0);
    let sech = power.scaled(2.0) / (one + square);
    (((one - square) / (one + square)).to_f64(), sech.to_f64(), angle.to_f64())
}
