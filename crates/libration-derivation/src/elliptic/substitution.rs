//! The substitution that makes the limits of the integral fixed numbers.

use super::super::check::{CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{
    DecimalUnit, Formula, Name, Statement, call, cos, derivative, integral, letter, number, sin, sqrt,
};
use super::super::trials::Trials;
use super::super::words::{
    complete_integral as k_of, omega_0, period, period_ratio, sin_half_amplitude, theta_0,
};
use super::energy::speed;
use libration::algebra::Function;

fn theta() -> Formula {
    letter("θ")
}

fn psi() -> Formula {
    letter("ψ")
}

fn modulus() -> Formula {
    letter("k")
}

/// √(1 − k² sin² ψ).
fn root() -> Formula {
    sqrt(number(1) - modulus().squared() * sin(psi()).squared())
}

pub(super) fn half_angles(trials: &mut Trials) -> Result<DerivationStep, DerivationError> {
    let definition = trials.define(&Name::new("k"), sin_half_amplitude())?;
    let squares = modulus().squared() - sin(theta() / 2).squared();
    let difference = Statement::equal(cos(theta()) - cos(theta_0()), number(2) * squares);
    Ok(DerivationStep::new("half-angles", "Half angles")
        .say("Every cosine is one minus twice the square of the sine of half its angle. With", [])
        .show(definition)
        .show_all(trials.numbers(&[(modulus(), 11, DecimalUnit::One)])?)
        .say("which is called the modulus, the difference under the root becomes", [])
        .show(trials.compare(difference)?))
}

pub(super) fn new_variable(trials: &mut Trials) -> Result<DerivationStep, DerivationError> {
    trials.define(&Name::new("ψ"), call(Function::Asin, sin(theta() / 2) / modulus()))?;
    let substitution = Statement::equal(sin(theta() / 2), modulus() * sin(psi()));
    let under_root = Statement::equal(
        cos(theta()) - cos(theta_0()),
        number(2) * modulus().squared() * (number(1) - sin(psi()).squared()),
    )
    .and_equal(number(2) * modulus().squared() * cos(psi()).squared());
    let arc = number(2) * call(Function::Asin, modulus() * sin(psi()));
    let slope = number(2) * modulus() * cos(psi()) / root();
    let cancelled = Statement::equal(number(1) / speed() * (slope.clone()), number(1) / root());
    Ok(DerivationStep::new("new-variable", "A new variable")
        .say(
            "While {} rises from zero to {}, the sine of its half rises from zero to {}. So there is an angle {} between \
             zero and a right angle with",
            [theta(), theta_0(), modulus(), psi()],
        )
        .show(CheckedEquation::definition(substitution))
        .say("In it the difference under the root is a square,", [])
        .show(trials.compare(under_root)?)
        .say("and the angle, and how it changes with {}, are", [psi()])
        .show(trials.compare(Statement::equal(theta(), arc.clone()))?)
        .show(trials.compare(Statement::equal(derivative(arc, "ψ"), slope))?)
        .say("In the product of the two, what became infinite cancels:", [])
        .show(trials.compare(cancelled)?))
}

pub(super) fn complete_integral(trials: &mut Trials) -> Result<DerivationStep, DerivationError> {
    let parameter = letter("m");
    let integrand = number(1) / sqrt(number(1) - parameter.clone() * sin(psi()).squared());
    let definition = trials.define_function("K", &["m"], integral("ψ", 0, Formula::Pi / 2, integrand));
    let square = trials.define(&Name::new("m"), modulus().squared())?;
    let over_angle = integral("θ", 0, theta_0(), number(1) / speed());
    let same = Statement::equal(over_angle, k_of(parameter.clone()));
    let whole = Statement::equal(period(), number(4) / omega_0() * k_of(parameter.clone()));
    let ratio = Statement::equal(period_ratio(), number(2) / Formula::Pi * k_of(parameter.clone()));
    Ok(DerivationStep::new("elliptic-integral", "The complete elliptic integral")
        .say(
            "The limits have become zero and a right angle for every amplitude, which now enters in one place \
             only. The integral has a name, the complete elliptic integral of the first kind of the parameter {}:",
            [parameter.clone()],
        )
        .show(definition)
        .show(square)
        .show(trials.compare(same)?)
        .say("So the period, and its ratio to that of small swings, are", [])
        .show(trials.compare_with_library(whole)?)
        .show(trials.compare_with_library(ratio)?)
        .show_all(trials.numbers(&[
            (parameter.clone(), 11, DecimalUnit::One),
            (k_of(parameter.clone()), 11, DecimalUnit::One),
            (number(4) / omega_0() * k_of(parameter.clone()), 11, DecimalUnit::Second),
        ])?)
        .remark(
            "It is complete because its upper limit is the right angle; with another upper limit it is called \
             incomplete. The parameter stays below one: at {} = 1, the amplitude of a body balanced upright, the integral is \
             infinite, and so is the period.",
            [parameter],
        ))
}
