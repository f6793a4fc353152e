//! (15) to (17): the motion as a Fourier series.

use super::{statement, text_after};
use crate::paper::amplitudes::at_degrees;
use crate::paper::compare::{ROUNDING, decimal, series_in};
use crate::paper::exact_motion::{frequency_ratio, harmonics};
use crate::paper::finding::StatementFinding;
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::Rational;
use libration::pendulum::{Motion, Pendulum};
use libration::quantity::Angle;
use std::f64::consts::TAU;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(15)",
        "The small swing released from rest.",
        &["theta = theta0*cos(omega0*t)"],
        released_swing,
    ),
    statement(
        "(16)",
        "The exact motion is a sum of this over n = 0, 1, 2, ..., odd cosines alone.",
        &["a*cos((2*n + 1)*Omega*t)"],
        fourier_series,
    ),
    text_after(
        "(16)",
        "text: the even harmonics vanish by anti-symmetry about the position theta = pi/2",
        "The position about which the motion is antisymmetric.",
        &["theta = pi/2"],
        centre_of_antisymmetry,
    ),
    statement("(17)", "The coefficients sum to the amplitude.", &["theta0 = sum"], sum_of_coefficients),
];

fn released_from(amplitude: &Angle) -> Option<Motion> {
    Pendulum::from_angular_frequency(1.0).ok()?.released_from(*amplitude).ok()
}

fn released_swing(printed: &Printed) -> Option<StatementFinding> {
    let series = series_in("t", 12, printed.formula(0)?, &[("theta0", 3), ("omega0", 2)])?;
    let start = series.first() == Some(&Rational::from(3)) && series.get(1).is_some_and(Rational::is_zero);
    let steps = (1..).map(Rational::from);
    let solves =
        series.iter().zip(series.iter().skip(2)).zip(steps.clone().zip(steps.skip(1))).all(
            |((angle, next), (a, b))| (next.clone() * a * b + angle.clone() * Rational::from(4)).is_zero(),
        );
    let largest = |theta0: f64| {
        let left = |index: u32| {
            let values = [("theta0", theta0), ("omega0", 1.0), ("t", f64::from(index) * 0.1)];
            let theta = decimal(printed.formula(0)?, &values)?;
            Some((libm::sin(theta) - theta).abs())
        };
        (0..64).map(left).collect::<Option<Vec<_>>>().map(|left| left.into_iter().fold(0.0, f64::max))
    };
    let evidence = format!(
        "theta(0) = theta0, theta'(0) = 0 and theta'' + omega0^2*theta = 0 to t^9, exactly; in (8) it leaves \
         {:.2e}*omega0^2 at theta0 = 0.1 and {:.2e}*omega0^2 at 0.2, as theta0^3/6",
        largest(0.1)?,
        largest(0.2)?
    );
    Some(StatementFinding::verified_if(start && solves, "", evidence))
}

/// The series compared with the motion, which is computed from theta functions without any Fourier series.
fn fourier_series(printed: &Printed) -> Option<StatementFinding> {
    let amplitude = at_degrees(150.0)?;
    let (coefficients, motion) = (harmonics(&amplitude)?, released_from(&amplitude)?);
    let frequency = frequency_ratio(&amplitude)?;
    let mut largest = 0.0_f64;
    for index in 0..40 {
        let t = motion.period() * f64::from(index) / 40.0;
        let mut sum = 0.0;
        for (a, n) in coefficients.iter().zip((0_u32..).map(f64::from)) {
            sum += decimal(printed.formula(0)?, &[("a", *a), ("n", n), ("Omega", frequency), ("t", t)])?;
        }
        largest = largest.max((sum - motion.state_at(t).angle).abs());
    }
    let evidence = format!(
        "with the closed coefficients the sum meets the motion from 150 degrees at 40 times to {largest:.1e} rad; \
         its own even cosines and all sines are below {:.1e} rad",
        largest_other_harmonic(&motion)
    );
    Some(StatementFinding::verified_if(largest < 1e-12, "", evidence))
}

/// The largest of the first even cosines and sines of a motion, by the trapezoidal rule.
fn largest_other_harmonic(motion: &Motion) -> f64 {
    const SAMPLES: u32 = 256;
    let sample = |index: u32| {
        let turn = f64::from(index) / f64::from(SAMPLES);
        (TAU * turn, motion.state_at(motion.period() * turn).angle)
    };
    let samples: Vec<(f64, f64)> = (0..SAMPLES).map(sample).collect();
    let coefficient = |weight: &dyn Fn(f64) -> f64| {
        let sum: f64 = samples.iter().map(|(phase, angle)| angle * weight(*phase)).sum();
        (2.0 * sum / f64::from(SAMPLES)).abs()
    };
    let evens = (0..6).map(|n| coefficient(&|phase| libm::cos(2.0 * f64::from(n) * phase)));
    let sines = (1..8).map(|n| coefficient(&|phase| libm::sin(f64::from(n) * phase)));
    evens.chain(sines).fold(0.0, f64::max)
}

fn centre_of_antisymmetry(printed: &Printed) -> Option<StatementFinding> {
    let claimed = decimal(printed.formula(0)?, &[])?;
    let motion = released_from(&at_degrees(60.0)?)?;
    let half = motion.period() / 2.0;
    // Antisymmetry about a position: half a period later the pendulum is equally far on the other side.
    let centre = |index: u32| {
        let t = motion.period() * f64::from(index) / 40.0;
        f64::midpoint(motion.state_at(t).angle, motion.state_at(t + half).angle)
    };
    let farthest = (0..40).map(centre).fold(0.0_f64, |farthest, centre| farthest.max(centre.abs()));
    let evidence = format!(
        "theta(Omega*t + pi) = -theta(Omega*t) to {farthest:.1e} rad for the motion from 60 degrees, which never \
         reaches pi/2 and whose even harmonics are below {:.1e} rad",
        largest_other_harmonic(&motion)
    );
    let correct = "antisymmetry about theta = 0: theta(Omega*t + pi) = -theta(Omega*t), that is about the phase \
                   Omega*t = pi/2, where theta = 0";
    Some(StatementFinding::verified_if(claimed.abs() <= farthest, correct, evidence))
}

fn sum_of_coefficients(printed: &Printed) -> Option<StatementFinding> {
    let mut largest = 0.0_f64;
    for degrees in [30.0, 90.0, 150.0, 179.0] {
        let amplitude = at_degrees(degrees)?;
        let sum: f64 = harmonics(&amplitude)?.iter().sum();
        let stands = decimal(printed.formula(0)?, &[("sum", sum)])?;
        largest = largest.max((stands - amplitude.radians()).abs());
    }
    let evidence = format!(
        "the closed coefficients sum to theta0 within {largest:.1e} rad at 30, 90, 150 and 179 degrees"
    );
    Some(StatementFinding::verified_if(largest < 50.0 * ROUNDING, "", evidence))
}
