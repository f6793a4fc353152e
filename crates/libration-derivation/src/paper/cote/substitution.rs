//! Côté, (13) to (22): the substitution sin(θ/2) = sin(θ0/2) sin ψ and the complete elliptic integral.

use super::{statement, text_after};
use crate::paper::compare::{ROUNDING, decimal, identity};
use crate::paper::exact_motion::{GRAVITY, LENGTH};
use crate::paper::finding::{StatementFinding, StatementVerdict};
use crate::paper::printed::Printed;
use crate::paper::quadrature::{quarter, to_amplitude};
use crate::paper::statement::PrintedStatement;
use libration::elliptic::Modulus;
use libration::expression::Expression;
use libration::pendulum::{Amplitude, Pendulum};
use libration::quantity::Angle;
use std::f64::consts::FRAC_PI_2;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(13)",
        "The substitution; theta from 0 to theta0 is psi from 0 to pi/2.",
        &["sin(theta/2) = sin(theta0/2)*sin(psi)"],
        the_substitution,
    ),
    statement(
        "(14)",
        "Its differential.",
        &["cos(theta/2)/2*dtheta = sin(theta0/2)*cos(psi)*dpsi"],
        differential,
    ),
    statement(
        "(15)",
        "The cosine of the double angle.",
        &["cos(2*theta) = 1 - 2*sin(theta)^2", "cos(theta) = 1 - 2*sin(theta/2)^2"],
        double_angle,
    ),
    statement(
        "(16)",
        "The difference of the cosines by half angles.",
        &[
            "cos(theta) - cos(theta0) = 1 - 2*sin(theta/2)^2 - (1 - 2*sin(theta0/2)^2) = 2*(sin(theta0/2)^2 - sin(theta/2)^2)",
        ],
        by_half_angles,
    ),
    statement(
        "(17)",
        "The same with psi.",
        &["2*(sin(theta0/2)^2 - sin(theta/2)^2) = 2*(sin(theta0/2)^2 - sin(theta0/2)^2*sin(psi)^2) = \
             2*sin(theta0/2)^2*(1 - sin(psi)^2) = 2*sin(theta0/2)^2*cos(psi)^2"],
        substituted_sides,
    ),
    statement(
        "(18)",
        "(14) solved for the differential of theta.",
        &["dtheta = 2*sin(theta0/2)*cos(psi)*dpsi/cos(theta/2)"],
        differential,
    ),
    statement(
        "(19)",
        "The integral of the first over theta is that of the others over psi.",
        &[
            "1/sqrt(cos(theta) - cos(theta0))",
            "2*sin(theta0/2)*cos(psi)/(cos(theta/2)*sqrt(2)*sin(theta0/2)*cos(psi))",
            "sqrt(2)/cos(theta/2)",
        ],
        integral_over_psi,
    ),
    statement(
        "(20)",
        "The cosine of theta/2 in psi.",
        &["cos(theta/2) = sqrt(1 - sin(theta/2)^2) = sqrt(1 - sin(theta0/2)^2*sin(psi)^2)"],
        substituted_sides,
    ),
    statement(
        "(21)",
        "The period: a factor times the integral of this over psi from 0 to pi/2.",
        &["4*sqrt(l/g)", "1/sqrt(1 - sin(theta0/2)^2*sin(psi)^2)"],
        period,
    ),
    statement(
        "(22)",
        "The complete elliptic integral of the first kind of m, written k(m), for m from 0 to this, inclusive.",
        &["1/sqrt(1 - m*sin(psi)^2)", "m = 1"],
        complete_integral,
    ),
    text_after(
        "(22)",
        "text: 0 <= m <= 1",
        "The values of m for which the integral exists.",
        &["m = 1"],
        largest_parameter,
    )
    .paraphrased(),
];

/// θ as a function of ψ.
fn theta_of(theta0: f64, psi: f64) -> f64 {
    2.0 * libm::asin(libm::sin(theta0 / 2.0) * libm::sin(psi))
}

fn points() -> impl Iterator<Item = (f64, f64)> {
    let amplitudes = [0.3, 1.0, 2.0, 3.0];
    amplitudes.into_iter().flat_map(|theta0| (1..10).map(move |i| (theta0, f64::from(i) * FRAC_PI_2 / 10.0)))
}

fn the_substitution(printed: &Printed) -> Option<StatementFinding> {
    let residual = printed.residual(0)?;
    let mut largest = 0.0_f64;
    let mut increasing = true;
    for theta0 in [0.3, 1.0, 2.0, 3.0] {
        for (theta, psi) in [(0.0, 0.0), (theta0, FRAC_PI_2)] {
            largest =
                largest.max(decimal(&residual, &[("theta", theta), ("theta0", theta0), ("psi", psi)])?.abs());
        }
        let samples: Vec<f64> = (0..20).map(|i| theta_of(theta0, f64::from(i) * FRAC_PI_2 / 20.0)).collect();
        increasing &= samples.is_sorted();
    }
    let evidence = format!(
        "definition; consistent: psi = 0 and pi/2 belong to theta = 0 and theta0 within {largest:.1e}, and theta grows with psi \
         between them"
    );
    Some(StatementFinding::verified_if(largest < ROUNDING && increasing, "", evidence))
}

/// Compares both sides with dψ = 2 and dθ = 2·dθ/dψ by central differences.
fn differential(printed: &Printed) -> Option<StatementFinding> {
    const STEP: f64 = 1e-5;
    let residual = printed.residual(0)?;
    let mut largest = 0.0_f64;
    for (theta0, psi) in points() {
        let twice_slope = (theta_of(theta0, psi + STEP) - theta_of(theta0, psi - STEP)) / STEP;
        let values = [
            ("theta", theta_of(theta0, psi)),
            ("theta0", theta0),
            ("psi", psi),
            ("dtheta", twice_slope),
            ("dpsi", 2.0),
        ];
        largest = largest.max(decimal(&residual, &values)?.abs());
    }
    let evidence = format!(
        "at 36 points (theta0, psi) the sides differ by at most {largest:.1e}, d(theta)/d(psi) by central differences"
    );
    Some(StatementFinding::verified_if(largest < 1e-7, "", evidence))
}

fn double_angle(printed: &Printed) -> Option<StatementFinding> {
    let first = identity(&printed.residual(0)?, &[("theta", -3.0, 3.0)], "both forms")?;
    let second = identity(&printed.residual(1)?, &[("theta", -3.0, 3.0)], "both forms")?;
    Some(if first.verdict == StatementVerdict::Verified { second } else { first })
}

fn by_half_angles(printed: &Printed) -> Option<StatementFinding> {
    let values = |theta0: f64, psi: f64| [("theta", theta_of(theta0, psi)), ("theta0", theta0), ("psi", psi)];
    chain(printed, &values)
}

fn substituted_sides(printed: &Printed) -> Option<StatementFinding> {
    by_half_angles(printed)
}

/// All sides of an equation compared with the first.
fn chain(
    printed: &Printed,
    values: &dyn Fn(f64, f64) -> [(&'static str, f64); 3],
) -> Option<StatementFinding> {
    let sides = printed.sides(0)?;
    let mut largest = 0.0_f64;
    for (theta0, psi) in points() {
        let at = values(theta0, psi);
        let first = decimal(sides.first()?, &at)?;
        for side in sides {
            largest = largest.max((decimal(side, &at)? - first).abs());
        }
    }
    let evidence = format!(
        "at 36 points (theta0, psi), theta from (13), the {} sides differ by at most {largest:.1e}",
        sides.len()
    );
    Some(StatementFinding::verified_if(largest < ROUNDING, "", evidence))
}

fn integral_over_psi(printed: &Printed) -> Option<StatementFinding> {
    let mut largest = 0.0_f64;
    for theta0 in [0.3, 1.0, 2.0] {
        let integrand = |theta: f64| decimal(printed.formula(0)?, &[("theta", theta), ("theta0", theta0)]);
        let over_theta = to_amplitude(theta0, &integrand)?;
        for form in 1..3 {
            let over_psi = quarter(&|psi| over_psi(printed.formula(form)?, theta0, psi))?;
            largest = largest.max((over_psi / over_theta - 1.0).abs());
        }
    }
    let evidence = format!("the three quadratures agree within {largest:.1e} at theta0 = 0.3, 1 and 2 rad");
    Some(StatementFinding::verified_if(largest < 1e-11, "", evidence))
}

fn over_psi(integrand: &Expression, theta0: f64, psi: f64) -> Option<f64> {
    decimal(integrand, &[("theta", theta_of(theta0, psi)), ("theta0", theta0), ("psi", psi)])
}

fn period(printed: &Printed) -> Option<StatementFinding> {
    let pendulum = Pendulum::new(LENGTH, GRAVITY).ok()?;
    let factor = decimal(printed.formula(0)?, &[("g", GRAVITY), ("l", LENGTH)])?;
    let mut largest = 0.0_f64;
    for theta0 in [0.3, 1.0, 2.0] {
        let integral = quarter(&|psi| over_psi(printed.formula(1)?, theta0, psi))?;
        let exact = pendulum.period(&Amplitude::new(Angle::from_radians(theta0).ok()?).ok()?);
        largest = largest.max((factor * integral / exact - 1.0).abs());
    }
    let evidence = format!(
        "quadrature and exact period differ by at most {largest:.1e} at theta0 = 0.3, 1 and 2 rad; the reference to \
         equation (13) made on the way is to the substitution, as it should be"
    );
    Some(StatementFinding::verified_if(largest < 1e-13, "", evidence))
}

fn complete_integral(printed: &Printed) -> Option<StatementFinding> {
    let mut largest = 0.0_f64;
    for m in [0.0, 0.1, 0.5, 0.8] {
        let stands = quarter(&|psi| decimal(printed.formula(0)?, &[("m", m), ("psi", psi)]))?;
        largest = largest.max((stands / Modulus::from_parameter(m).ok()?.first() - 1.0).abs());
    }
    let at_end = Modulus::from_parameter(decimal(printed.formula(1)?, &[])?).ok()?.first();
    let evidence = format!(
        "its quadrature is K within {largest:.1e} for m = 0, 0.1, 0.5 and 0.8; at the end m = {} it is {at_end}; the usual \
         letter is K, as k is the modulus sqrt(m)",
        printed.number(1)?
    );
    if largest > 1e-12 {
        return Some(StatementFinding::wrong("K(m), the integral of 1/sqrt(1 - m*sin(psi)^2)", evidence));
    }
    Some(if at_end.is_finite() {
        StatementFinding::verified(evidence)
    } else {
        StatementFinding::typo("K(m), 0 <= m < 1", evidence)
    })
}

fn largest_parameter(printed: &Printed) -> Option<StatementFinding> {
    let m = decimal(printed.formula(0)?, &[])?;
    let integral = |m: f64| Some(Modulus::from_parameter(m).ok()?.first());
    let before = [0.01, 0.0001, 0.000001]
        .map(|c| Some(format!("K(1 - {c}) = {:.4}", Modulus::from_complementary_parameter(c).ok()?.first())));
    let evidence = format!(
        "{}: it grows as ln(4/sqrt(1 - m)), and K({m}) = {}",
        before.into_iter().collect::<Option<Vec<_>>>()?.join(", "),
        integral(m)?
    );
    let finding = StatementFinding::verified_if(integral(m)?.is_finite(), "0 <= m < 1", evidence);
    Some(if integral(m)?.is_finite() { finding } else { finding.restricted("at m = 1") })
}
