//! Jacobi's sn, cn, dn and the amplitude am as quotients of theta functions (DLMF 22.2).

use super::{Expansion, Phase, PhaseClock, ThetaSeries, ThetaValues, ThetaZero};
use crate::dispatch::{Kernel, dispatch};
use crate::double_double::{DoubleDouble, fast_two_sum};
use crate::elementary::{atan_of_ratio, sinh_cosh, two_word};

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
    sn: f64,
    cn: f64,
    dn: f64,
    tangent: f64,
}

impl Quotients {
    pub(crate) fn new(
        modulus: DoubleDouble,
        complementary: DoubleDouble,
        first: DoubleDouble,
        complementary_first: DoubleDouble,
    ) -> Self {
        let expansion = Expansion::of(modulus, complementary);
        let ratio = match expansion {
            Expansion::Circular => complementary_first / first,
            Expansion::Hyperbolic => first / complementary_first,
        };
        let exponent = DoubleDouble::FRAC_PI_2 * ratio;
        let root = if exponent.hi < 740.0 { two_word::exp(-exponent) } else { DoubleDouble::ZERO };
        let series = ThetaSeries::new(root.square().to_f64());
        let scale = match expansion {
            Expansion::Circular => DoubleDouble::PI.scaled(2.0),
            Expansion::Hyperbolic => exponent.scaled(4.0),
        };
        let frequency = first.scaled(4.0).recip();
        let clock = PhaseClock { frequency, offset: DoubleDouble::ZERO };
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

/// The factors of the quotients in the notes beside [`Quotients::jacobi`], each rounded once.
fn factors(expansion: Expansion, root: DoubleDouble, zero: ThetaZero<DoubleDouble>) -> [Factors; 2] {
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
    words.map(|([sn, cn, dn], tangent)| Factors {
        sn: sn.to_f64(),
        cn: cn.to_f64(),
        dn: dn.to_f64(),
        tangent: tangent.to_f64(),
    })
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
        let factors = self.factors[usize::from(odd)];
        let (values, [sn, cn, dn, below], tangent) = match self.expansion {
            Expansion::Circular => {
                let v = self.series.circular(phase.rest);
                let quotient = if odd {
                    [v.second, -v.first, v.fourth, v.third]
                } else {
                    [v.first, v.second, v.third, v.fourth]
                };
                (v, quotient, v.second)
            }
            Expansion::Hyperbolic => {
                let v = self.series.hyperbolic(phase.rest * self.scale);
                let quotient = if odd {
                    [v.fourth, -v.first, v.second, v.third]
                } else {
                    [v.first, v.fourth, v.third, v.second]
                };
                (v, quotient, v.fourth)
            }
        };
        let unit = |x: f64| x.clamp(-1.0, 1.0);
        Jacobi {
            sn: unit(sign * (factors.sn * sn / below)),
            cn: unit(sign * (factors.cn * cn / below)),
            dn: (factors.dn * dn / below).min(1.0),
            am: amplitude(&phase, &values, factors.tangent, tangent),
        }
    }
}

/// am: the quarters gone and the angle from the nearest.
#[inline(always)]
fn amplitude(phase: &Phase, values: &ThetaValues, factor: f64, below: f64) -> f64 {
    let above = (factor * values.first).abs();
    let angle = if above > below {
        DoubleDouble::FRAC_PI_2 - atan_of_ratio(below, above)
    } else {
        atan_of_ratio(above, below)
    };
    let angle = if values.first < 0.0 { -angle } else { angle };
    let quarters = phase.turns.mul_add(4.0, phase.quarter);
    let whole = DoubleDouble::FRAC_PI_2 * quarters;
    let sum = fast_two_sum(whole.hi, angle.hi);
    if quarters == 0.0 { angle.to_f64() } else { sum.hi + (sum.lo + (whole.lo + angle.lo)) }
}

/// k = 1: sn = tanh, cn = dn = sech, am the Gudermannian (DLMF 22.5(ii)).
fn hyperbolic_limit(u: f64) -> Jacobi {
    let size = u.abs();
    if !u.is_finite() {
        return Jacobi { sn: f64::NAN, cn: f64::NAN, dn: f64::NAN, am: f64::NAN };
    }
    let sign = if u < 0.0 { -1.0 } else { 1.0 };
    if size > 690.0 {
        let sech = 2.0 * libm::exp(-size);
        return Jacobi { sn: sign, cn: sech, dn: sech, am: sign * std::f64::consts::FRAC_PI_2 };
    }
    let (sinh, cosh) = sinh_cosh(DoubleDouble::from(size));
    let angle = if sinh > 1.0 {
        DoubleDouble::FRAC_PI_2 - atan_of_ratio(1.0, sinh)
    } else {
        atan_of_ratio(sinh, 1.0)
    };
    Jacobi {
        sn: (sign * (sinh / cosh)).clamp(-1.0, 1.0),
        cn: 1.0 / cosh,
        dn: 1.0 / cosh,
        am: sign * angle.to_f64(),
    }
}
