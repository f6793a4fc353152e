//! The steps from the equation of motion to a quarter of the period as an integral over the angle.

use super::super::check::{CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{
    DecimalUnit, Formula, Name, Statement, cos, derivative, integral, letter, number, sin, sqrt,
};
use super::super::trials::Trials;
use super::super::words::{omega_0, period, sin_half_amplitude, small_swing_period, theta_0};
use libration::algebra::Rational;

fn theta() -> Formula {
    letter("θ")
}

fn velocity() -> Formula {
    Name::new("θ").prime().into()
}

fn acceleration() -> Name {
    Name::new("θ").prime().prime()
}

/// θ′²/2 − ω0² cos θ.
fn energy() -> Formula {
    velocity().squared() / 2 - omega_0().squared() * cos(theta())
}

/// √(2(cos θ − cos θ0)).
pub(super) fn speed() -> Formula {
    sqrt(number(2) * (cos(theta()) - cos(theta_0())))
}

pub(super) fn equation_of_motion(trials: &mut Trials) -> Result<DerivationStep, DerivationError> {
    let (gravity, length) = (letter("g"), letter("ℓ"));
    let motion = Statement::equal(acceleration(), -(gravity.clone() / length.clone() * sin(theta())));
    let frequency = trials.define(&Name::new("ω").index(0), sqrt(gravity.clone() / length.clone()))?;
    let small = trials.define(&Name::new("T").index(0), number(2) * Formula::Pi / omega_0())?;
    let numbers = trials.numbers(&[
        (omega_0(), 11, DecimalUnit::RadianPerSecond),
        (small_swing_period(), 11, DecimalUnit::Second),
    ])?;
    Ok(DerivationStep::new("equation-of-motion", "The equation of motion")
        .say(
            "A small heavy body hangs from a pivot by a rod of length {}, without friction, and swings in a vertical \
             plane under the acceleration of free fall {}. Its angle from the downward vertical is {}, in radians; a prime \
             is a derivative with respect to the time {}. Of its weight only the part along the circle changes its \
             speed, and the mass drops out:",
            [length, gravity, theta(), letter("t")],
        )
        .show(CheckedEquation::premise(motion))
        .say_where(trials.wanted(), "The pendulum whose numbers follow each step has the amplitude, length and gravity", [])
        .show_all(trials.given())
        .say("Two abbreviations, the second of which is the period of very small swings, for which the sine is the angle:", [])
        .show(frequency)
        .show(small)
        .show_all(numbers))
}

pub(super) fn conservation(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let any_motion =
        trials.with(&acceleration(), Rational::new(1, 3).unwrap_or_else(|| Rational::from(0)).into())?;
    let bracket = Formula::from(acceleration()) + omega_0().squared() * sin(theta());
    let identity = Statement::equal(derivative(energy(), "t"), velocity() * bracket);
    let conserved = Statement::equal(energy(), -(omega_0().squared() * cos(theta_0())));
    let rising = Statement::equal(velocity(), omega_0() * speed());
    let fastest = number(2) * omega_0() * sin_half_amplitude();
    Ok(DerivationStep::new("energy", "The energy")
        .say("For any motion whatever,", [])
        .show(any_motion.compare(identity)?)
        .say(
            "and for a motion that obeys the equation of motion the right side is zero. So what is differentiated on the \
             left, the energy but for a constant factor, keeps the value it has at the turning point, where {} is the \
             amplitude {} and the body is at rest:",
            [theta(), theta_0()],
        )
        .show(trials.compare_with_library(conserved)?)
        .say("This gives the angular velocity at every angle. While the body rises from the bottom to the turning point it is", [])
        .show(trials.compare_with_library(rising)?)
        .remark(
            "On the way down the sign is the other one. The four quarters of a swing, down, up, down, up, take the same \
             time, so that one of them is enough.",
            [],
        )
        .say_where(trials.wanted(), "At the bottom, where {} is zero, the angular velocity is greatest:", [theta()])
        .show_all(trials.numbers(&[(fastest, 11, DecimalUnit::RadianPerSecond)])?))
}

pub(super) fn quarter_period(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let quarter = integral("θ", 0, theta_0(), number(1) / (omega_0() * speed()));
    Ok(DerivationStep::new("separation", "Separating the variables")
        .say(
            "A small step {} takes the time {}. The angle and the time now stand apart, and adding up the \
             steps from the bottom to the turning point gives a quarter of the period {}:",
            [letter("d") * theta(), letter("d") * theta() / velocity(), period()],
        )
        .show(trials.compare_with_library(Statement::equal(period() / 4, quarter))?)
        .remark(
            "At the upper end the integrand becomes infinite, because the body stops there, but only like one over the \
             square root of the distance from the turning point: the integral is finite. It is not an elementary function \
             of the amplitude.",
            [],
        ))
}
