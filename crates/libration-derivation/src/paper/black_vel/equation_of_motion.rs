//! (1) to (3) and (8) to (12): the equation of motion, small swings, and the first integral.

use super::statement;
use crate::paper::amplitudes::at_degrees;
use crate::paper::compare::{POINTS, ROUNDING, decimal, series_in};
use crate::paper::evaluate::value;
use crate::paper::exact_motion::{GRAVITY, LENGTH, instants};
use crate::paper::finding::StatementFinding;
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Rational, Ring};
use libration::expression::Expression;
use libration::pendulum::{Amplitude, Pendulum};
use libration::quantity::Angle;
use libration::series::PowerSeries;
use std::f64::consts::TAU;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(1)",
        "The equation of motion of a point mass on a massless rod.",
        &["theta'' + (g/l)*sin(theta) = 0"],
        equation_of_motion,
    ),
    statement(
        "(2)",
        "Small swings are harmonic, with any phase.",
        &["theta = theta0*cos(sqrt(g/l)*t + phi)"],
        small_swing,
    ),
    statement("(3)", "The period of small swings.", &["T0 = 2*pi*sqrt(l/g)"], small_angle_period),
    statement(
        "(8)",
        "The equation of motion in terms of omega0.",
        &["theta'' + omega0^2*sin(theta) = 0"],
        equation_of_motion,
    ),
    statement("(9)", "The frequency of small swings.", &["omega0^2 = g/l"], frequency_of_small_swings),
    statement(
        "(10)",
        "The equation of motion times the velocity.",
        &["theta''*theta' + omega0^2*sin(theta)*theta' = 0"],
        equation_of_motion,
    ),
    statement(
        "(11)",
        "The energy does not change: d/dt of this is 0.",
        &["theta'^2/2 - omega0^2*cos(theta)"],
        energy_is_conserved,
    ),
    statement(
        "(12)",
        "The velocity at an angle, of either sign.",
        &["theta' = sqrt(2)*omega0*sqrt(cos(theta) - cos(theta0))"],
        velocity_at_an_angle,
    ),
];

fn equation_of_motion(printed: &Printed) -> Option<StatementFinding> {
    let amplitude = at_degrees(120.0)?;
    let residual = printed.residual(0)?;
    let values = instants(&amplitude, 48)?.into_iter().map(|instant| {
        let scale = (GRAVITY / LENGTH) * f64::max(1.0, instant.velocity.abs());
        Some(decimal(&residual, &instant.values(amplitude.radians()))?.abs() / scale)
    });
    let largest = values.collect::<Option<Vec<_>>>()?.into_iter().fold(0.0, f64::max);
    let evidence = format!(
        "at 48 instants of the exact motion from 120 degrees (l = {LENGTH} m, g = {GRAVITY} m/s^2) the sides \
         differ by at most {largest:.1e} of omega0^2"
    );
    Some(StatementFinding::verified_if(largest < ROUNDING, "", evidence))
}

/// theta″ + (g/l)·theta = 0 in exact power series in time, with g/l = 1 and phi = 0.
fn small_swing(printed: &Printed) -> Option<StatementFinding> {
    const TERMS: usize = 12;
    let values = [("theta0", 3), ("g", 5), ("l", 5), ("phi", 0)];
    let angle = series_in("t", TERMS, printed.formula(0)?, &values)?;
    let whole = |n: usize| i64::try_from(n).ok().map(Rational::from);
    let acceleration = |n: usize| Some(angle.get(n + 2)?.clone() * whole((n + 1) * (n + 2))?);
    let residuals =
        (0..TERMS - 2).map(|n| Some(acceleration(n)? + angle[n].clone())).collect::<Option<Vec<_>>>()?;
    let solves = residuals.iter().all(Rational::is_zero);
    let frequency = largest_residual_of_the_swing(printed.formula(0)?)?;
    let evidence = format!(
        "theta'' + (g/l)*theta vanishes to t^{} in exact series at g/l = 1, and to {frequency:.1e} at {} other \
         values of g/l, t and phi by differences",
        TERMS - 3,
        POINTS
    );
    Some(StatementFinding::verified_if(solves && frequency < 1e-6, "", evidence))
}

/// The largest residual of theta″ + (g/l)·theta = 0 by central differences, for g/l and phi that are not rational squares.
fn largest_residual_of_the_swing(angle: &Expression) -> Option<f64> {
    const STEP: f64 = 1e-4;
    let mut largest = 0.0_f64;
    for index in 0..POINTS {
        let shift = f64::from(index);
        let (g, l, phi, t) = (1.0 + shift / 7.0, 1.0 + shift / 29.0, shift / 3.0, shift / 11.0);
        let at = |t: f64| decimal(angle, &[("theta0", 1.0), ("g", g), ("l", l), ("phi", phi), ("t", t)]);
        let second_difference = (at(t + STEP)? - 2.0 * at(t)? + at(t - STEP)?) / (STEP * STEP);
        largest = largest.max((second_difference + g / l * at(t)?).abs() * l / g);
    }
    Some(largest)
}

fn small_angle_period(printed: &Printed) -> Option<StatementFinding> {
    let period = decimal(printed.formula(0)?, &[("l", LENGTH), ("g", GRAVITY)])?;
    let pendulum = Pendulum::new(LENGTH, GRAVITY).ok()?;
    let limit = pendulum.period(&Amplitude::new(Angle::from_radians(1e-9).ok()?).ok()?);
    let deviation = (period / limit - 1.0).abs();
    let evidence = format!(
        "the exact period from 1e-9 rad differs from it by {deviation:.1e} (l = {LENGTH} m, g = {GRAVITY} m/s^2)"
    );
    Some(StatementFinding::verified_if(deviation < 1e-15, "", evidence))
}

/// 2π divided by the period of the smallest swings of three pendulums.
fn frequency_of_small_swings(printed: &Printed) -> Option<StatementFinding> {
    let mut largest = 0.0_f64;
    let tiny = Amplitude::new(Angle::from_radians(1e-9).ok()?).ok()?;
    for (l, g) in [(LENGTH, GRAVITY), (2.0, 1.62), (0.1, 24.8)] {
        let omega0 = TAU / Pendulum::new(l, g).ok()?.period(&tiny);
        let residual = decimal(&printed.residual(0)?, &[("omega0", omega0), ("l", l), ("g", g)])?;
        largest = largest.max((residual / (omega0 * omega0)).abs());
    }
    let evidence = format!(
        "with omega0 = 2*pi/T for the exact periods T from 1e-9 rad of three pendulums the sides differ by at most \
         {largest:.1e} of omega0^2"
    );
    Some(StatementFinding::verified_if(largest < ROUNDING, "", evidence))
}

/// d/dt along any motion is θ′ times the equation of motion: in exact series in time.
fn energy_is_conserved(printed: &Printed) -> Option<StatementFinding> {
    let ring = PowerSeries::rational(10);
    let angle = arbitrary_motion();
    let (velocity, acceleration) = (derivative(&angle), derivative(&derivative(&angle)));
    let of = |name: &str| match name {
        "theta" => Some(angle.clone()),
        "theta'" => Some(velocity.clone()),
        "omega0" => ring.rational(&Rational::from(3)),
        _ => None,
    };
    let energy = value(&ring, printed.formula(0)?, &of)?;
    let motion = Printed::read(&["acceleration + 9*sin(theta)"])?;
    let force = value(&ring, motion.formula(0)?, &|name| {
        (name == "acceleration").then(|| acceleration.clone()).or_else(|| of(name))
    })?;
    let power = ring.multiply(&force, &velocity);
    let same = derivative(&energy).iter().zip(&power).all(|(a, b)| a == b);
    let evidence = "along theta(t) = t/2 + t^2/3 - t^3/5 + t^4/7 its derivative equals theta'*(theta'' + \
                    omega0^2*sin(theta)) to t^6 in exact series (omega0 = 3), which vanishes by (8)";
    Some(StatementFinding::verified_if(same, "", evidence))
}

/// θ = t/2 + t²/3 − t³/5 + t⁴/7 to t⁹, a motion that solves no particular equation.
fn arbitrary_motion() -> Vec<Rational> {
    let chosen =
        [(0, 1), (1, 2), (1, 3), (-1, 5), (1, 7)].into_iter().filter_map(|(n, d)| Rational::new(n, d));
    chosen.chain(std::iter::repeat_n(Rational::from(0), 5)).collect()
}

fn derivative(series: &[Rational]) -> Vec<Rational> {
    let factors = (1..).map(Rational::from);
    series.iter().skip(1).zip(factors).map(|(coefficient, n)| coefficient.clone() * n).collect()
}

fn velocity_at_an_angle(printed: &Printed) -> Option<StatementFinding> {
    let amplitude = at_degrees(120.0)?;
    let mut largest = 0.0_f64;
    for instant in instants(&amplitude, 48)? {
        // At the turning points, rounding errors may make the difference of the cosines negative.
        let turns = (instant.velocity.abs() < 1e-6).then_some(0.0);
        let speed = decimal(printed.formula(0)?, &instant.values(amplitude.radians())).or(turns)?;
        largest = largest.max((speed * speed - instant.velocity * instant.velocity).abs() * LENGTH / GRAVITY);
    }
    let evidence = format!(
        "at 48 instants of the exact motion from 120 degrees the squares of both sides differ by at most \
         {largest:.1e} of omega0^2"
    );
    Some(StatementFinding::verified_if(largest < ROUNDING, "", evidence))
}
