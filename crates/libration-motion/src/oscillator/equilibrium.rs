//! Equilibria of an oscillator, and the proof that motions return to them.
//!
//! Newton's method is that of `roots`. The search before it and the recognition of fractions after it differ from those of `normal_modes`: here
//! all zeros of one force are computed to 512 bits, there one zero of several forces near a guess in double precision.

use super::constant::{Approximation, Constant, PRECISION};
use super::error::{FrequencySource, OscillatorError, RejectedEquilibrium, RejectionReason};
use super::force::{Curve, Force, RECOGNISED_BITS, simplest_about};
use super::neighbourhood::{Neighbourhood, Roughness};
use super::roots::{LARGEST_DEGREE, Scan, zeros};
use super::sides::Sides;
use libration_numbers::algebra::{BigFloat, Floats, Rational};
use libration_numbers::expression::Expression;
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::expression::Tape;
use libration_numbers::internals::roots::{correction, newton};
use libration_numbers::roots::polynomial_sign_changes;

/// Largest distance of a zero from its approximation, relative to the zero or to one: a
/// double zero is computed to half the digits, 1e-8, with a margin of a factor of a hundred.
const FOUND_WITHIN: f64 = 1e-6;

/// Size in bits of the longest fractions tried as zeros.
const LONGEST_FRACTION: usize = 128;

/// An equilibrium.
#[derive(Clone, Debug)]
pub(super) struct Equilibrium {
    pub(super) at: Constant,
    pub(super) omega0_squared: Constant,
    /// The forces on either side, if one power series holds above the equilibrium and another below.
    pub(super) sides: Option<Sides>,
}

/// Approximate positions at which the force at rest vanishes.
pub(super) struct Candidates {
    /// The positions in order of their distance from zero; of two at equal distance the positive one is first.
    pub(super) near: Vec<f64>,
    /// The error that is returned if none of the candidates is a zero.
    pub(super) none: OscillatorError,
}

/// The sign changes of the force at rest, to double precision.
pub(super) fn candidates(force: &Force) -> Candidates {
    let at_rest = force.at_rest();
    let polynomial = at_rest
        .polynomial_coefficients(&force.x)
        .filter(|coefficient| coefficient.len() <= LARGEST_DEGREE + 1);
    let everywhere = polynomial.and_then(|coefficients| polynomial_sign_changes(&scaled(&coefficients)));
    let (mut near, none) = match (everywhere, Curve::new(&at_rest, &force.x)) {
        (Some(zeros), _) => (zeros, OscillatorError::NoEquilibrium),
        (None, Some(curve)) => {
            let Scan { zeros, has_values } = zeros(|x| curve.at(x));
            (zeros, if has_values { OscillatorError::NotFound } else { OscillatorError::NoValues })
        }
        (None, None) => (vec![], OscillatorError::NoValues),
    };
    near.put_in_order(|a, b| a.abs().total_cmp(&b.abs()).then(b.total_cmp(a)));
    near.dedup();
    Candidates { near, none }
}

/// The coefficients divided by the last one, rounded.
fn scaled(coefficients: &[Rational]) -> Vec<f64> {
    let last = coefficients.last();
    let over_last = |c: &Rational| last.and_then(|last| c.checked_div(last)).map_or(0.0, |c| c.to_f64());
    coefficients.iter().map(over_last).collect()
}

/// The zero of the force next to a candidate.
pub(super) fn refined(force: &Force, near: f64) -> Option<Constant> {
    zero_or_fraction(force, near, FOUND_WITHIN)
}

/// The zero of the force next to a number, exact if it is a fraction.
fn zero_or_fraction(force: &Force, near: f64, within: f64) -> Option<Constant> {
    let fraction = |number: &BigFloat, bits| {
        let simplest = simplest_about(number, bits);
        let fits = simplest.bits() <= LONGEST_FRACTION && vanishes_at(force, &simplest);
        fits.then_some(Constant::Exact(simplest))
    };
    // Newton's method does not converge to all digits of a multiple zero, which may be a fraction of few digits.
    if let Some(simple) = fraction(&BigFloat::from_f64(near, PRECISION)?, 30) {
        return Some(simple);
    }
    let digits = zero_next_to(force, near, within)?;
    Some(fraction(&digits, RECOGNISED_BITS).unwrap_or(Constant::Approximate(Approximation(digits))))
}

/// Returns `true` if the force at rest is proved to vanish at a position.
pub(super) fn vanishes_at(force: &Force, position: &Rational) -> bool {
    let at_rest = force.at_rest();
    let Some(curve) = Curve::new(&at_rest, &force.x) else { return false };
    // The exact evaluation, which takes longer, is made only if the digits vanish.
    let digits = curve.precisely_at(&BigFloat::from_rational(position, PRECISION));
    let value = digits.filter(is_tiny).and_then(|_| curve.constant_at(position));
    value.is_some_and(|value| value.exact().is_some_and(Rational::is_zero))
}

/// Returns `true` if a number of [`PRECISION`] bits may be a rounding error of zero.
fn is_tiny(number: &BigFloat) -> bool {
    let quarter = isize::try_from(PRECISION / 4).unwrap_or(isize::MAX);
    number.exponent().is_none_or(|size| size < -quarter)
}

/// The zero next to a given constant, at most 5 % away.
pub(super) fn given(force: &Force, position: &Expression) -> Option<Constant> {
    const WITHIN: f64 = 0.05;
    if let Some(exact) = position.to_rational().filter(|exact| vanishes_at(force, exact)) {
        return Some(Constant::Exact(exact));
    }
    let near = Curve::new(position, &force.x)?.at(0.0);
    let is_near = |zero: &Constant| near == 0.0 || (zero.to_f64() - near).abs() <= WITHIN * near.abs();
    zero_or_fraction(force, near, WITHIN).filter(is_near)
}

/// The zero of the force to [`PRECISION`] bits, by Newton's method from a number next to it.
fn zero_next_to(force: &Force, near: f64, within: f64) -> Option<BigFloat> {
    const MOST_STEPS: usize = 30;
    let ring = Floats { precision: PRECISION };
    let tape = Tape::new(&[&force.at_rest()], std::slice::from_ref(&force.x)).ok()?;
    let start = [BigFloat::from_f64(near, PRECISION)?];
    let step = |at: &[BigFloat]| correction(&ring, |x| x.to_f64().abs(), &tape, at);
    let zero = newton(&ring, &start, MOST_STEPS, step, |step, at| is_last(&step[0], &at[0])).ok()?;
    zero.into_iter().next().filter(|x| (x.to_f64() - near).abs() <= within * near.abs().max(1.0))
}

/// Returns `true` if the next step of Newton's method would be below the last bits.
fn is_last(step: &BigFloat, x: &BigFloat) -> bool {
    let bits = isize::try_from(x.precision() * 9 / 10).unwrap_or(isize::MAX);
    step.exponent().is_none_or(|size| size < x.exponent().unwrap_or(0).max(0) - bits)
}

/// The equilibrium at a position where the force vanishes, if it is stable and no energy is lost there.
pub(super) fn assessed(force: &Force, at: Constant) -> Result<Equilibrium, RejectedEquilibrium> {
    let smooth = omega0_squared_at(force, &at).and_then(|omega0_squared| {
        refuse_losses(force, &at)?;
        Ok(omega0_squared)
    });
    match (smooth, two_sided(force, &at)) {
        (Ok(omega0_squared), _) => Ok(Equilibrium { at, omega0_squared, sides: None }),
        (Err(RejectionReason::NotAnalytic { .. }), Some((sides, omega0_squared))) => {
            Ok(Equilibrium { at, omega0_squared, sides: Some(sides) })
        }
        (Err(reason), _) => {
            let reason = circular_arcs(force, &at).unwrap_or(reason);
            Err(RejectedEquilibrium { at: at.to_string(), reason })
        }
    }
}

/// The force −k·sign(x) − ω²·x as a reason for rejection.
fn circular_arcs(force: &Force, at: &Constant) -> Option<RejectionReason> {
    let sides = Sides::about(force, at.exact()?)?;
    let lines = [&sides.above, &sides.below].map(|side| side.polynomial_coefficients(&force.x));
    let [Some(above), Some(below)] = lines else { return None };
    let [jump, slope] = above.as_slice() else { return None };
    let drives_back = jump.is_negative() && slope.is_negative() && above == below;
    let text = |number: &Rational| Expression::Number(number.magnitude()).to_string();
    drives_back.then(|| RejectionReason::CircularArcs { jump: text(jump), omega_squared: text(slope) })
}

/// The force on both sides of a position towards which it points, and ω0².
fn two_sided(force: &Force, at: &Constant) -> Option<(Sides, Constant)> {
    let (sides, slope) = Sides::new(force, at)?;
    (slope.is_negative()).then(|| (sides, Constant::Exact(-slope)))
}

/// ω0², if the restoring force is proportional to small displacements.
fn omega0_squared_at(force: &Force, at: &Constant) -> Result<Constant, RejectionReason> {
    let (at_rest, digits) = (force.at_rest(), at.digits());
    let about = Neighbourhood::new(&at_rest, &force.x, at);
    let frequency = |passed: bool| match (passed, returns(force, at)) {
        (false, _) => FrequencySource::Nothing,
        (true, true) => FrequencySource::Orbits,
        (true, false) => FrequencySource::Motion,
    };
    let rough = || RejectionReason::NotAnalytic {
        roughness: about.as_ref().map_or(Roughness::Other, Neighbourhood::roughness),
        force: about.as_ref().and_then(Neighbourhood::tendency),
        frequency: frequency(about.as_ref().is_some_and(Neighbourhood::is_analytic_on_both_sides)),
    };
    if Curve::new(&at_rest, &force.x).is_some_and(|curve| !curve.is_smooth_at(&digits)) {
        return Err(rough());
    }
    let omega0_squared = value_at(force, &force.stiffness(), at).ok_or_else(rough)?;
    if omega0_squared.is_positive() {
        return Ok(omega0_squared);
    }
    if omega0_squared.exact().is_some_and(Rational::is_zero) {
        let force = about.as_ref().and_then(Neighbourhood::tendency);
        return Err(RejectionReason::NoLinearPart { force, frequency: frequency(true) });
    }
    Err(RejectionReason::NotRestoring { omega0_squared: omega0_squared.to_string() })
}

/// Returns `true` if motions about a position are proved to retrace their paths, possibly mirrored.
fn returns(force: &Force, at: &Constant) -> bool {
    force.is_reversible() || at.exact().is_some_and(|centre| force.is_mirrored_about(centre))
}

/// Rejects forces that add or remove energy.
fn refuse_losses(force: &Force, at: &Constant) -> Result<(), RejectionReason> {
    if returns(force, at) {
        return Ok(());
    }
    let damping = value_at(force, &force.damping(), at).filter(|value| value.to_f64() != 0.0);
    Err(damping.map_or(RejectionReason::Irreversible, |damping| RejectionReason::Damped {
        damping: damping.to_string(),
    }))
}

/// The value of a formula at a constant; a value whose digits all vanish is zero.
fn value_at(force: &Force, formula: &Expression, at: &Constant) -> Option<Constant> {
    let curve = Curve::new(formula, &force.x)?;
    match at {
        Constant::Exact(exact) => curve.constant_at(exact),
        Constant::Approximate(Approximation(digits)) => {
            let value = curve.precisely_at(digits)?;
            let zero = is_tiny(&value).then(|| Rational::from(0));
            let exact = formula.to_rational().or(zero).map(Constant::Exact);
            Some(exact.unwrap_or(Constant::Approximate(Approximation(value))))
        }
    }
}
