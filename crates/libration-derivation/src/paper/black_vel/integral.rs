//! (13): the exact period as an integral, and the statements about it in the text.

use super::{statement, text_after};
use crate::paper::amplitudes::at_degrees;
use crate::paper::compare::decimal;
use crate::paper::exact_motion::{GRAVITY, LENGTH};
use crate::paper::finding::StatementFinding;
use crate::paper::printed::Printed;
use crate::paper::quadrature::to_amplitude;
use crate::paper::statement::PrintedStatement;
use libration::pendulum::Amplitude;
use std::f64::consts::TAU;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(13)",
        "The exact period: a factor times the integral of this from 0 to theta0.",
        &["2*sqrt(2)/omega0", "1/sqrt(cos(theta) - cos(theta0))"],
        exact_period,
    ),
    text_after(
        "(13)",
        "text: (13) is the incomplete elliptic integral of the first kind",
        "The name of the integral in (13).",
        &["2*sqrt(2)/omega0", "1/sqrt(cos(theta) - cos(theta0))"],
        name_of_the_integral,
    ),
    text_after(
        "(13)",
        "text: (13) can be evaluated by the arithmetic-geometric mean",
        "T = T0/agm(1, cos(theta0/2)).",
        &["2*sqrt(2)/omega0", "1/sqrt(cos(theta) - cos(theta0))"],
        by_the_mean,
    ),
];

const AMPLITUDES: [f64; 4] = [30.0, 60.0, 90.0, 120.0];

/// The period of (13).
fn period_by_quadrature(printed: &Printed, amplitude: f64) -> Option<f64> {
    let integrand = |theta: f64| decimal(printed.formula(1)?, &[("theta", theta), ("theta0", amplitude)]);
    let factor = decimal(printed.formula(0)?, &[("omega0", (GRAVITY / LENGTH).sqrt())])?;
    Some(factor * to_amplitude(amplitude, &integrand)?)
}

/// The largest |quadrature/expected − 1| over several amplitudes.
fn largest_deviation(printed: &Printed, expected: impl Fn(&Amplitude) -> f64) -> Option<f64> {
    let mut largest = 0.0_f64;
    for degrees in AMPLITUDES {
        let amplitude = Amplitude::new(at_degrees(degrees)?).ok()?;
        let period = period_by_quadrature(printed, amplitude.radians())?;
        largest = largest.max((period / expected(&amplitude) - 1.0).abs());
    }
    Some(largest)
}

fn exact_period(printed: &Printed) -> Option<StatementFinding> {
    let omega0 = (GRAVITY / LENGTH).sqrt();
    let largest = largest_deviation(printed, |amplitude| 4.0 * amplitude.modulus().first() / omega0)?;
    let evidence = format!(
        "its quadrature differs from 4*K(sin(theta0/2))/omega0 by at most {largest:.1e} at 30, 60, 90 and 120 degrees"
    );
    Some(StatementFinding::verified_if(largest < 1e-12, "", evidence))
}

fn name_of_the_integral(printed: &Printed) -> Option<StatementFinding> {
    let omega0 = (GRAVITY / LENGTH).sqrt();
    let amplitude = Amplitude::new(at_degrees(60.0)?).ok()?;
    let quarter = period_by_quadrature(printed, amplitude.radians())? * omega0 / 4.0;
    let modulus = amplitude.modulus();
    let incomplete = modulus.incomplete_first(amplitude.radians() / 2.0);
    let complete = (quarter - modulus.first()).abs() < 1e-12;
    let evidence = format!(
        "at 60 degrees omega0*T/4 = {quarter:.12}: the complete K(k) is {:.12}, the incomplete F(theta0/2, k) is \
         {incomplete:.12}, with k = sin(theta0/2); (13) is F(pi/2, k) = K(k)",
        modulus.first()
    );
    let correct = "the complete elliptic integral of the first kind, K(sin(theta0/2))";
    Some(if complete {
        StatementFinding::wrong(correct, evidence)
    } else {
        StatementFinding::verified(evidence)
    })
}

fn by_the_mean(printed: &Printed) -> Option<StatementFinding> {
    let omega0 = (GRAVITY / LENGTH).sqrt();
    let by_mean = |amplitude: &Amplitude| {
        let (mut a, mut b) = (1.0, libm::cos(amplitude.radians() / 2.0));
        for _ in 0..6 {
            (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
        }
        TAU / (omega0 * a)
    };
    let largest = largest_deviation(printed, by_mean)?;
    let evidence = format!(
        "six steps of the mean from 1 and cos(theta0/2) differ from the quadrature of (13) by at most {largest:.1e}; \
         what the mean computes is the complete integral"
    );
    Some(StatementFinding::verified_if(largest < 1e-12, "", evidence))
}
