//! (18) to (24): two harmonics in the equation truncated after θ³.

use super::{statement, text_after};
use crate::paper::amplitudes::at_degrees;
use crate::paper::compare::{decimal, polynomial, same_polynomial};
use crate::paper::cosines::{cosine, cosines, projection, second_derivative};
use crate::paper::exact_motion::{frequency_ratio, harmonics};
use crate::paper::finding::StatementFinding;
use crate::paper::printed::Printed;
use crate::paper::sine::{equation_with_sine, sine};
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Polynomial, Rational, Variable};
use libration::pendulum::Pendulum;
use std::f64::consts::TAU;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(18)",
        "Two harmonics to begin with (cn is cos(n*Omega*t)).",
        &["theta = a1*c1 + a3*c3"],
        two_harmonics,
    ),
    statement("(19)", "The sine to its second term.", &["theta - theta^3/6"], sine_to_third),
    statement(
        "(20)",
        "The equation of motion with this sine.",
        &["theta'' + omega0^2*(theta - theta^3/6) = 0"],
        truncated_equation,
    ),
    statement(
        "(21)",
        "(18) in (20), divided by omega0^2, with Delta = Omega/omega0.",
        &["0 = Delta^2*(-a1*c1 - 9*a3*c3) + a1*c1 + a3*c3 - (a1*c1 + a3*c3)^3/6"],
        inserted,
    ),
    text_after(
        "(21)",
        "text: the Fourier integrals with respect to Omega*t have the factor Omega/pi",
        "The factor of the integral over a period of Omega*t, times a cosine of it.",
        &["Omega/pi"],
        factor_of_the_integrals,
    ),
    statement(
        "(22)",
        "(21) times cos(Omega*t), integrated over a period.",
        &["0 = -8 + a1^2 + a1*a3 + 2*a3^2 + 8*Delta^2"],
        on_the_fundamental,
    ),
    statement(
        "(23)",
        "(21) times cos(3*Omega*t), integrated over a period.",
        &["0 = a1^3 + 6*a1^2*a3 + 3*a3*(-8 + a3^2 + 72*Delta^2)"],
        on_the_third,
    ),
    statement("(24)", "The amplitude is the motion at t = 0.", &["theta0 = a1 + a3"], amplitude_of_two),
];

/// The factor times the integral over a period of Ωt must be the coefficient of the series.
fn factor_of_the_integrals(printed: &Printed) -> Option<StatementFinding> {
    const PHASES: u32 = 256;
    let amplitude = at_degrees(150.0)?;
    let (coefficients, frequency) = (harmonics(&amplitude)?, frequency_ratio(&amplitude)?);
    let motion = Pendulum::from_angular_frequency(1.0).ok()?.released_from(amplitude).ok()?;
    let phase = |index: u32| TAU * f64::from(index) / f64::from(PHASES);
    let at = |index: u32| motion.state_at(phase(index) / frequency).angle * libm::cos(phase(index));
    let integral = (0..PHASES).map(at).sum::<f64>() * TAU / f64::from(PHASES);
    let stands = decimal(printed.formula(0)?, &[("Omega", frequency)])? * integral;
    let a1 = coefficients.first()?;
    let evidence = format!(
        "at 150 degrees, where Omega = {frequency:.5}*omega0, the factor times the integral of theta*cos(Omega*t) is {stands:.5} \
         with omega0 = 1, and a1 is {a1:.5}"
    );
    if (stands / a1 - 1.0).abs() < 1e-9 {
        return Some(StatementFinding::verified(evidence));
    }
    Some(StatementFinding::typo(
        "1/pi with respect to Omega*t; Omega/pi is the factor with respect to t",
        evidence,
    ))
}

/// The motion (18).
pub(super) fn motion() -> Polynomial {
    Polynomial::variable("a1") * cosine(1) + Polynomial::variable("a3") * cosine(3)
}

/// Δ²θ″ + θ − θ³/3! for this motion.
pub(super) fn equation_of(motion: &Polynomial) -> Option<Polynomial> {
    let inertia = Polynomial::variable("Delta").pow(2) * second_derivative(motion);
    Some(inertia + motion.clone() - motion.pow(3).scaled(&Rational::new(1, 6)?))
}

/// The equation projected on the n-th harmonic, scaled so that the first coefficient is that of the printed equation.
pub(super) fn condition(n: u32) -> Option<Polynomial> {
    Some(projection(&equation_of(&motion())?, n))
}

fn two_harmonics(printed: &Printed) -> Option<StatementFinding> {
    let theta = polynomial(printed.formula(0)?, &cosines())?;
    let shares = [30.0, 90.0].map(|degrees| {
        let harmonics = harmonics(&at_degrees(degrees)?)?;
        Some(harmonics.get(2)?.abs() / harmonics.first()?)
    });
    let evidence = format!(
        "definition; consistent: (22), (23) and (24) are three equations for a1, a3 and Delta; the first harmonic \
         left out, a5, is {:.1e} of a1 at 30 degrees and {:.1e} at 90 degrees",
        shares[0]?, shares[1]?
    );
    Some(StatementFinding::verified_if(theta == motion(), "theta = a1*c1 + a3*c3", evidence))
}

fn sine_to_third(printed: &Printed) -> Option<StatementFinding> {
    sine(printed.formula(0)?, 3)
}

fn truncated_equation(printed: &Printed) -> Option<StatementFinding> {
    equation_with_sine(printed, 3)
}

fn inserted(printed: &Printed) -> Option<StatementFinding> {
    let stands = -polynomial(&printed.residual(0)?, &cosines())?;
    let how = "theta of (18) put into (20) as a polynomial in cos(Omega*t), exactly";
    Some(same_polynomial(&stands, &equation_of(&motion())?, how))
}

fn on_the_fundamental(printed: &Printed) -> Option<StatementFinding> {
    projected(printed, 1)
}

fn on_the_third(printed: &Printed) -> Option<StatementFinding> {
    projected(printed, 3)
}

fn projected(printed: &Printed, n: u32) -> Option<StatementFinding> {
    let (stands, computed) = (-polynomial(&printed.residual(0)?, &[])?, condition(n)?);
    let multiple = if n == 1 { String::new() } else { format!("{n}*") };
    let how = format!("the projection of (21) on cos({multiple}Omega*t)");
    if let Some(factor) = computed.divide_exactly(&stands).filter(|factor| factor.terms().count() == 1) {
        return Some(StatementFinding::verified(format!("{how} is ({factor}) times it, exactly")));
    }
    let correct = computed.divide_exactly(&common_factor(&computed))?;
    Some(StatementFinding::wrong(format!("0 = {correct}"), format!("{how} is {computed}")))
}

/// The largest monomial that divides every term.
fn common_factor(sum: &Polynomial) -> Polynomial {
    let smallest =
        |name: &Variable| sum.terms().map(|(monomial, _)| monomial.exponent(name)).min().unwrap_or(0);
    let powers =
        sum.variables().into_iter().map(|name| Polynomial::variable(name.clone()).pow(smallest(&name)));
    powers.fold(Polynomial::constant(Rational::from(1)), |product, power| product * power)
}

fn amplitude_of_two(printed: &Printed) -> Option<StatementFinding> {
    let at_start = motion().substitute(&"c".into(), &Polynomial::constant(Rational::from(1)));
    Some(same_polynomial(&polynomial(printed.formula(0)?, &[])?, &at_start, "(18) at t = 0, exactly"))
}
