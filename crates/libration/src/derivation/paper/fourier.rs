//! Black and Vel, (15) to (17): the motion as a Fourier series, and what the text says of its coefficients.

use super::compare::{ROUNDING, decimal, series_in};
use super::exact_motion::{frequency_ratio, harmonics};
use super::finding::Finding;
use super::printed::Printed;
use super::roots::{amplitude_where_zero, in_degrees};
use super::statement::{Document, Statement};
use crate::algebra::Rational;
use crate::pendulum::{Motion, Pendulum};
use crate::quantity::Angle;
use std::f64::consts::{PI, TAU};

const fn statement(
    label: &'static str,
    claim: &'static str,
    printed: &'static [&'static str],
    check: super::statement::Check,
) -> Statement {
    Statement { document: Document::BlackVel, label, claim, printed, check }
}

pub(super) const STATEMENTS: &[Statement] = &[
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
    statement(
        "text: the even harmonics vanish by anti-symmetry about the position theta = pi/2",
        "The position about which the motion is antisymmetric.",
        &["theta = pi/2"],
        centre_of_antisymmetry,
    ),
    statement("(17)", "The coefficients sum to the amplitude.", &["theta0 = sum"], sum_of_coefficients),
    statement(
        "text: a1 is at most a bit greater than pi",
        "An upper bound of a1 over all amplitudes up to pi.",
        &["a1 = pi"],
        largest_fundamental,
    ),
    statement(
        "text: a3 is much smaller than 1 for 0 < theta0 <= pi",
        "A bound of |a3| over all amplitudes.",
        &["a3 = 1/10"],
        largest_third,
    ),
    statement(
        "text: a1*a3 stays much less than 1, so a1^3 is much greater than a1^4*a3",
        "A bound of |a1*a3| over all amplitudes.",
        &["a1*a3 = 1"],
        product_of_both,
    ),
    statement(
        "text: a1 >> Delta - 1 >> a3",
        "The corrections decrease: |a3| is much smaller than |Delta - 1|, say by a factor of 5.",
        &["a3/(Delta - 1) = 1/5"],
        order_of_corrections,
    ),
];

fn angle(degrees: f64) -> Option<Angle> {
    Angle::from_degrees(degrees).ok()
}

/// The amplitude closest to the top that the library takes for granted.
fn top() -> Option<Angle> {
    Angle::from_complement(1e-300).ok()
}

fn released_from(amplitude: &Angle) -> Option<Motion> {
    Pendulum::from_angular_frequency(1.0).ok()?.released_from(*amplitude).ok()
}

fn released_swing(printed: &Printed) -> Option<Finding> {
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
    Some(Finding::verified_if(start && solves, "", evidence))
}

/// The series against the motion, which is computed from theta functions without any Fourier series.
fn fourier_series(printed: &Printed) -> Option<Finding> {
    let amplitude = angle(150.0)?;
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
    Some(Finding::verified_if(largest < 1e-12, "", evidence))
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

fn centre_of_antisymmetry(printed: &Printed) -> Option<Finding> {
    let claimed = decimal(printed.formula(0)?, &[])?;
    let motion = released_from(&angle(60.0)?)?;
    let half = motion.period() / 2.0;
    // Antisymmetric about a position: half a period later the pendulum is as far on its other side.
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
    Some(Finding::verified_if(claimed.abs() <= farthest, correct, evidence))
}

fn sum_of_coefficients(printed: &Printed) -> Option<Finding> {
    let mut largest = 0.0_f64;
    for degrees in [30.0, 90.0, 150.0, 179.0] {
        let amplitude = angle(degrees)?;
        let sum: f64 = harmonics(&amplitude)?.iter().sum();
        let stands = decimal(printed.formula(0)?, &[("sum", sum)])?;
        largest = largest.max((stands - amplitude.radians()).abs());
    }
    let evidence = format!(
        "the closed coefficients sum to theta0 within {largest:.1e} rad at 30, 90, 150 and 179 degrees"
    );
    Some(Finding::verified_if(largest < 50.0 * ROUNDING, "", evidence))
}

/// a1, a3, a5 next to the top, where they tend to 4, −4/3, 4/5.
fn limits() -> Option<[f64; 3]> {
    harmonics(&top()?)?.get(..3)?.try_into().ok()
}

fn largest_fundamental(printed: &Printed) -> Option<Finding> {
    let bound = decimal(printed.formula(0)?, &[])?;
    let [a1, a3, a5] = limits()?;
    let passed = amplitude_where_zero(0.1, PI - 1e-9, &|amplitude| Some(harmonics(amplitude)?[0] - bound));
    let evidence = format!(
        "the coefficients tend to 4*(-1)^n/(2n+1): at 1e-300 rad below pi they are {a1:.5}, {a3:.5}, {a5:.5}; a1 \
         passes {bound:.4} at {}",
        passed.map_or("no amplitude".to_owned(), in_degrees)
    );
    let correct = "a1 < 4, which it tends to as theta0 -> pi";
    // A bit: a tenth.
    Some(Finding::verified_if(a1 <= 1.1 * bound, correct, evidence))
}

fn largest_third(printed: &Printed) -> Option<Finding> {
    let bound = decimal(printed.formula(0)?, &[])?;
    let [_, a3, _] = limits()?;
    let reached = |bound: f64| {
        amplitude_where_zero(0.1, PI - 1e-9, &|amplitude| Some(harmonics(amplitude)?[1].abs() - bound))
    };
    let limit = reached(bound);
    let evidence = format!(
        "|a3| reaches {bound} at {} and 1 at {}; it tends to 4/3: {a3:.5} at 1e-300 rad below pi",
        limit.map_or("no amplitude".to_owned(), in_degrees),
        reached(1.0).map_or("no amplitude".to_owned(), in_degrees)
    );
    let correct =
        limit.map_or(String::new(), |limit| format!("|a3| < {bound} for theta0 below {}", in_degrees(limit)));
    let finding = Finding::verified_if(a3.abs() <= bound, correct, evidence);
    Some(finding.holding_for(vec![(0.0, limit.unwrap_or(PI))]))
}

fn product_of_both(printed: &Printed) -> Option<Finding> {
    let bound = decimal(printed.formula(0)?, &[])?;
    let product = |amplitude: &Angle| {
        let harmonics = harmonics(amplitude)?;
        Some((harmonics[0] * harmonics[1]).abs())
    };
    let reached =
        |bound: f64| amplitude_where_zero(0.1, PI - 1e-9, &|amplitude| Some(product(amplitude)? - bound));
    let limit = reached(bound);
    let evidence = format!(
        "|a1*a3| is {:.4} at 90 degrees, reaches 0.1 at {} and {bound} at {}, and tends to 16/3: {:.4} at 1e-300 rad \
         below pi",
        product(&angle(90.0)?)?,
        reached(0.1).map_or("no amplitude".to_owned(), in_degrees),
        limit.map_or("no amplitude".to_owned(), in_degrees),
        product(&top()?)?
    );
    let correct = limit
        .map_or(String::new(), |limit| format!("|a1*a3| < {bound} for theta0 below {}", in_degrees(limit)));
    Some(
        Finding::verified_if(limit.is_none(), correct, evidence)
            .holding_for(vec![(0.0, limit.unwrap_or(PI))]),
    )
}

fn order_of_corrections(printed: &Printed) -> Option<Finding> {
    let bound = decimal(printed.formula(0)?, &[])?;
    let ratio =
        |amplitude: &Angle| Some(harmonics(amplitude)?[1].abs() / (1.0 - frequency_ratio(amplitude)?));
    let reached =
        |bound: f64| amplitude_where_zero(0.1, PI - 1e-9, &|amplitude| Some(ratio(amplitude)? - bound));
    let limit = reached(bound);
    let evidence = format!(
        "|a3|/|Delta - 1| is {:.3} at 90 degrees and {:.3} at 179 degrees; it reaches {bound} at {} and 1 at {}, and \
         tends to 4/3",
        ratio(&angle(90.0)?)?,
        ratio(&angle(179.0)?)?,
        limit.map_or("no amplitude".to_owned(), in_degrees),
        reached(1.0).map_or("no amplitude".to_owned(), in_degrees)
    );
    let correct = limit.map_or(String::new(), |limit| {
        format!("|a3| < {bound}*|Delta - 1| for theta0 below {}", in_degrees(limit))
    });
    Some(
        Finding::verified_if(limit.is_none(), correct, evidence)
            .holding_for(vec![(0.0, limit.unwrap_or(PI))]),
    )
}
