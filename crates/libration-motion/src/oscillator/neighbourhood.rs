//! The force at rest next to a position where it vanishes, if its derivatives there do not decide its direction.

use super::constant::{Approximation, Constant, PRECISION};
use super::force::{Curve, simplest_about};
use libration_numbers::algebra::{BigFloat, Rational, Rationals, Ring};
use libration_numbers::{
    expression::{Expression, Symbol},
    internals::expression::Side,
};

/// The direction of a force next to a position where it vanishes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tendency {
    /// Towards the position, on both sides.
    Back,
    /// Away from the position, on both sides.
    Away,
    /// In the same direction on both sides.
    OneWay,
    /// No direction: the force vanishes on both sides.
    None,
}

/// The defect of the derivative of a force that has no power series.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Roughness {
    /// No real values on one side.
    #[error("it has no value {0} this position")]
    Edge(&'static str),
    /// Values that do not tend to zero.
    #[error("it jumps")]
    Jump,
    /// Two slopes.
    #[error("it has a kink, its slope being {below} below and {above} above")]
    Kink {
        /// The slope on the side of smaller values.
        below: String,
        /// The slope on the side of larger values.
        above: String,
    },
    /// No finite slope.
    #[error("its slope is infinite")]
    Steep,
    /// A finite slope, and so ω0², but no power series.
    #[error("it has a derivative, omega0^2 being {omega0_squared}, but not all derivatives")]
    Slope {
        /// −∂F/∂x.
        omega0_squared: String,
    },
    /// Another lack of smoothness.
    #[error("it is not smooth")]
    Other,
}

/// The side of a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Towards {
    Below,
    Above,
}

/// The force at rest about a position where it vanishes.
pub(super) struct Neighbourhood<'a> {
    curve: Curve<'a>,
    at_rest: &'a Expression,
    x: &'a Symbol,
    at: &'a Constant,
}

/// Distances, as powers of two, at which the direction of a force is evaluated: small, unless a force
/// of a high power is too weak there to be distinguished from the rounding of [`PRECISION`] bits.
const TRIED: [usize; 3] = [40, 20, 8];
/// Binary exponent below which a force may be rounding.
const NOISE: isize = -460;
/// Distances at which slopes are measured, as powers of two. From the first to the last a power of the
/// distance like √h changes by 2²⁰ and more, and an analytic function by 2⁻¹⁰⁰ of itself.
const NEAR: [usize; 3] = [100, 120, 140];

impl<'a> Neighbourhood<'a> {
    pub(super) fn new(at_rest: &'a Expression, x: &'a Symbol, at: &'a Constant) -> Option<Self> {
        Some(Self { curve: Curve::new(at_rest, x)?, at_rest, x, at })
    }

    /// The direction of the force; `None` if it is unknown.
    pub(super) fn tendency(&self) -> Option<Tendency> {
        let signs = TRIED.iter().filter_map(|&n| {
            Some((self.sign(Towards::Below, n)?, self.sign(Towards::Above, n)?))
                .filter(|pair| *pair != (0, 0))
        });
        match signs.into_iter().next() {
            Some((1, -1)) => Some(Tendency::Back),
            Some((-1, 1)) => Some(Tendency::Away),
            Some((below, above)) => (below == above).then_some(Tendency::OneWay),
            None => self.at_rest.vanishes().then_some(Tendency::None),
        }
    }

    /// The sign of the force; zero if it cannot be distinguished from zero.
    fn sign(&self, side: Towards, n: usize) -> Option<i8> {
        let sign = |positive: bool| if positive { 1 } else { -1 };
        match self.value(side, n)? {
            Constant::Exact(value) if value.is_zero() => Some(0),
            Constant::Exact(value) => Some(sign(!value.is_negative())),
            value => {
                let is_known = !without_noise(value.digits()).is_zero();
                Some(if is_known { sign(value.is_positive()) } else { 0 })
            }
        }
    }

    /// The force at the distance 2⁻ⁿ.
    fn value(&self, side: Towards, n: usize) -> Option<Constant> {
        match (self.at, step(side, n)) {
            (Constant::Exact(point), step) => self.curve.constant_at(&Rationals.add(point, &step)),
            (point, step) => {
                let near = point.digits() + BigFloat::from_rational(&step, PRECISION);
                self.curve.precisely_at(&near).map(|value| Constant::Approximate(Approximation(value)))
            }
        }
    }

    /// The defect of the derivative.
    pub(super) fn roughness(&self) -> Roughness {
        match (self.slope(Towards::Below), self.slope(Towards::Above)) {
            (OneSided::NoValue, OneSided::NoValue) => Roughness::Edge("on either side of"),
            (OneSided::NoValue, _) => Roughness::Edge("below"),
            (_, OneSided::NoValue) => Roughness::Edge("above"),
            (OneSided::Jump, _) | (_, OneSided::Jump) => Roughness::Jump,
            (OneSided::Slope(below), OneSided::Slope(above)) if agree(&below, &above) => {
                Roughness::Slope { omega0_squared: short(&-above) }
            }
            (OneSided::Slope(below), OneSided::Slope(above)) => {
                Roughness::Kink { below: short(&below), above: short(&above) }
            }
            (OneSided::Infinite, _) | (_, OneSided::Infinite) => Roughness::Steep,
            _ => Roughness::Other,
        }
    }

    fn slope(&self, side: Towards) -> OneSided {
        let values: Option<Vec<BigFloat>> =
            NEAR.iter().map(|&n| self.value(side, n).map(|value| without_noise(value.digits()))).collect();
        let Some(values) = values else { return OneSided::NoValue };
        // A function that tends to zero like any power of the distance above 1/1000 decreases by at least 2 %.
        if size(&values[2]) > 0.99 * size(&values[0]) && size(&values[0]) > 0.0 {
            return OneSided::Jump;
        }
        let quotients: Vec<BigFloat> = values
            .into_iter()
            .zip(NEAR)
            .map(|(value, n)| value / BigFloat::from_rational(&step(side, n), PRECISION))
            .collect();
        let [far, middle, near] = [0, 1, 2].map(|index| size(&quotients[index]));
        if agree(&quotients[1], &quotients[2]) {
            return OneSided::Slope(quotients[2].clone());
        }
        // Quotients that fall in equal proportions, as powers of the distance do, and not towards a slope: with a slope of a twentieth of the last
        // quotient the proportions differ by as much.
        if near < 1e-3 * far && near * far <= 1.05 * middle * middle {
            return OneSided::Slope(BigFloat::from_integer(0, PRECISION));
        }
        if near > 1.2 * far { OneSided::Infinite } else { OneSided::Unclear }
    }

    /// Returns `true` if the force has no other singularity than absolute values and signs, so that integration passes the position.
    pub(super) fn is_analytic_on_both_sides(&self) -> bool {
        let (symbols, state) = ([self.x.clone()], [self.at.to_f64()]);
        [-1, 1].into_iter().all(|sign| {
            let seen = Side { symbols: &symbols, state: &state, sign }.seen(self.at_rest);
            Curve::new(&seen, self.x).is_some_and(|curve| curve.is_smooth_at(&self.at.digits()))
        })
    }
}

/// The force on one side.
enum OneSided {
    NoValue,
    Jump,
    Infinite,
    Slope(BigFloat),
    Unclear,
}

fn size(number: &BigFloat) -> f64 {
    number.to_f64().abs()
}

/// The number, or zero if it may be rounding.
fn without_noise(number: BigFloat) -> BigFloat {
    let is_known = number.exponent().is_some_and(|size| size > NOISE);
    if is_known { number } else { BigFloat::from_integer(0, PRECISION) }
}

/// ±2⁻ⁿ.
fn step(side: Towards, n: usize) -> Rational {
    let distance = Rational::from(1).divided_by_power_of_two(n);
    if side == Towards::Below { -distance } else { distance }
}

/// Returns `true` if two numbers agree to nine digits.
fn agree(a: &BigFloat, b: &BigFloat) -> bool {
    size(&(a.clone() - b.clone())) <= 1e-9 * size(a).max(size(b))
}

/// A slope as a fraction of few digits, or with twelve digits.
fn short(slope: &BigFloat) -> String {
    let simplest = simplest_about(slope, 60);
    if simplest.bits() <= 24 { Expression::Number(simplest).to_string() } else { simplest.to_decimal(12) }
}
