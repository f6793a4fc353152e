//! (48) to (51): the harmonics and the period as series in the amplitude, in every gauge.

use super::statement;
use crate::paper::compare::{series_in, written};
use crate::paper::finding::{StatementFinding, StatementVerdict};
use crate::paper::lindstedt::{Expansion, numbers};
use crate::paper::period_series::{agreement, frequency_series, ratio_series};
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Polynomial, Polynomials, Rational, Rationals, Ring};
use libration::series::PowerSeries;
use libration::series::{powers, powers_of_inverse};

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(48)",
        "The fundamental in the amplitude, the same in both gauges.",
        &["a1 = theta0 + theta0^3/192 + 17*theta0^5/61440"],
        fundamental,
    ),
    statement("(49)", "The third harmonic.", &["a3 = -theta0^3/192 - theta0^5/3072"], third_harmonic),
    statement("(50)", "The fifth harmonic.", &["a5 = theta0^5/20480"], fifth_harmonic),
    statement(
        "(51)",
        "The period with three corrections, the same in both gauges.",
        &["T = T0/(1 - theta0^2/16 + theta0^4/3072 - 23*theta0^6/737280)"],
        period,
    ),
];

/// A printed series in θ0 compared with the series in ε: with θ0(ε) inserted they must agree in every gauge.
fn in_every_gauge(stands: &[Rational], computed: &[Polynomial], amplitude: &[Polynomial]) -> Option<bool> {
    let stands: Vec<Polynomial> = stands.iter().cloned().map(Polynomial::constant).collect();
    let inserted = powers(&Polynomials, amplitude)?.composed(&Polynomials, &stands);
    Some(inserted.iter().zip(computed).all(|(a, b)| a == b))
}

fn fundamental(printed: &Printed) -> Option<StatementFinding> {
    harmonic_in_amplitude(printed, 1)
}

fn third_harmonic(printed: &Printed) -> Option<StatementFinding> {
    harmonic_in_amplitude(printed, 3)
}

fn fifth_harmonic(printed: &Printed) -> Option<StatementFinding> {
    harmonic_in_amplitude(printed, 5)
}

fn harmonic_in_amplitude(printed: &Printed, k: u32) -> Option<StatementFinding> {
    let expansion = Expansion::odd_gauge(5)?;
    let stands = series_in("theta0", 6, printed.formula(0)?, &[])?;
    let right = in_every_gauge(&stands, &expansion.harmonic(k), &expansion.amplitude())?;
    let exact = compose_with_inverse(k)?;
    let evidence = format!(
        "with theta0(epsilon) inserted it equals the harmonic to epsilon^5 for every A1, A3, A5, exactly; in the \
         gauge A1 = 1 the series is {}",
        written(&exact, "theta0")
    );
    Some(StatementFinding::verified_if(right, written(&exact[..6], "theta0"), evidence))
}

/// The k-th harmonic as a series in θ0 up to the seventh power.
fn compose_with_inverse(k: u32) -> Option<Vec<Rational>> {
    let mut gauge = vec![Rational::from(0); 7];
    *gauge.first_mut()? = Rational::from(1);
    let expansion = Expansion::of_numbers(&gauge)?;
    let inverse = powers_of_inverse(&Rationals, &numbers(&expansion.amplitude())?)?;
    Some(inverse.composed(&Rationals, &numbers(&expansion.harmonic(k))?))
}

pub(super) fn period(printed: &Printed) -> Option<StatementFinding> {
    const TERMS: usize = 7;
    let ring = PowerSeries::rational(TERMS);
    let ratio = ratio_series(printed.formula(0)?, TERMS)?;
    let frequency = ring.divide(&ring.rational(&Rational::from(1))?, &ratio)?;
    let expansion = Expansion::odd_gauge(7)?;
    let right = in_every_gauge(&frequency, &expansion.frequency()?, expansion.amplitude().get(..TERMS)?)?;
    let exact = agreement(printed.formula(0)?, 6)?;
    let next = libration::period_formulas::frequency_in_amplitude(4).pop()?;
    let evidence = format!(
        "with theta0(epsilon) inserted Omega/omega0 agrees to epsilon^6 for every A1, A3, A5, exactly; {}; the next \
         term of Omega/omega0 is {next}*theta0^8",
        exact.evidence
    );
    let correct = written(&frequency_series(TERMS), "theta0");
    let both = right && exact.verdict == StatementVerdict::Verified;
    Some(StatementFinding::verified_if(both, format!("T = T0/({correct})"), evidence))
}
