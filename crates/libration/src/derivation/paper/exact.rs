//! Black and Vel, (1) to (14): the equation of motion, its first integral, the exact period, and the published
//! approximations to it.

use super::compare::{ROUNDING, decimal, first_difference, series_in};
use super::exact_motion::{GRAVITY, LENGTH, instants};
use super::finding::Finding;
use super::power_series::PowerSeries;
use super::printed::Printed;
use super::quadrature::to_amplitude;
use super::statement::{Document, Statement};
use crate::algebra::{Rational, Ring};
use crate::expression::Expression;
use crate::pendulum::{Amplitude, Pendulum, period_ratio_near_top};
use crate::period_formulas::{frequency_in_amplitude, period_in_amplitude};
use crate::quantity::Angle;

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
        "(4)",
        "Bernoulli's period, exact to theta0^2.",
        &["T = T0*(1 + theta0^2/16)"],
        agrees_to_second,
    ),
    statement(
        "text: sin(theta) replaced by F(theta0)*theta with F = (sin(theta0)/theta0)^a",
        "Matching the first correction of the period fixes the exponent a, and (5) follows.",
        &["F = (sin(theta0)/theta0)^(3/4)", "T = T0*(theta0/sin(theta0))^(3/8)"],
        exponent_of_molina,
    ),
    statement(
        "(5)",
        "Molina's period, whose first correction is that of the exact one.",
        &["T = T0*(theta0/sin(theta0))^(3/8)"],
        agrees_to_second,
    ),
    statement("(6)", "Kidd and Fogg's period.", &["T = T0/sqrt(cos(theta0/2))"], agrees_to_second),
    statement(
        "(7)",
        "Butikov's period, for amplitudes near 180 degrees.",
        &["T = (2*T0/pi)*ln(8/(pi - theta0))"],
        asymptotic_at_the_top,
    ),
    statement(
        "(8)",
        "The equation of motion in terms of omega0.",
        &["theta'' + omega0^2*sin(theta) = 0"],
        equation_of_motion,
    ),
    statement("(9)", "The frequency of small swings.", &["omega0^2 = g/l"], equation_of_motion),
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
    statement(
        "(13)",
        "The exact period: a factor times the integral of this from 0 to theta0.",
        &["2*sqrt(2)/omega0", "1/sqrt(cos(theta) - cos(theta0))"],
        exact_period,
    ),
    statement(
        "text: (13) is the incomplete elliptic integral of the first kind",
        "The name of the integral in (13).",
        &["2*sqrt(2)/omega0", "1/sqrt(cos(theta) - cos(theta0))"],
        name_of_the_integral,
    ),
    statement(
        "text: (13) can be evaluated by the arithmetic-geometric mean",
        "T = T0/agm(1, cos(theta0/2)).",
        &["2*sqrt(2)/omega0", "1/sqrt(cos(theta) - cos(theta0))"],
        by_the_mean,
    ),
    statement(
        "(14)",
        "The power series of the period.",
        &["T = T0*(1 + theta0^2/16 + 11*theta0^4/3072 + 173*theta0^6/737280)"],
        agrees_to_sixth,
    ),
];

fn at_degrees(degrees: f64) -> Option<Angle> {
    Angle::from_degrees(degrees).ok()
}

fn equation_of_motion(printed: &Printed) -> Option<Finding> {
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
    Some(Finding::verified_if(largest < ROUNDING, "", evidence))
}

/// theta″ + (g/l)·theta = 0 in exact power series of the time, with g/l = 1 and phi = 0.
fn small_swing(printed: &Printed) -> Option<Finding> {
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
         values of g/l, t and phi by differences; the exact motion tends to it as theta0 -> 0",
        TERMS - 3,
        super::compare::POINTS
    );
    Some(Finding::verified_if(solves && frequency < 1e-6, "", evidence))
}

/// The same by central differences, where g/l and phi are not rational squares.
fn largest_residual_of_the_swing(angle: &Expression) -> Option<f64> {
    const STEP: f64 = 1e-4;
    let mut largest = 0.0_f64;
    for index in 0..super::compare::POINTS {
        let shift = f64::from(index);
        let (g, l, phi, t) = (1.0 + shift / 7.0, 1.0 + shift / 29.0, shift / 3.0, shift / 11.0);
        let at = |t: f64| decimal(angle, &[("theta0", 1.0), ("g", g), ("l", l), ("phi", phi), ("t", t)]);
        let second_difference = (at(t + STEP)? - 2.0 * at(t)? + at(t - STEP)?) / (STEP * STEP);
        largest = largest.max((second_difference + g / l * at(t)?).abs() * l / g);
    }
    Some(largest)
}

fn small_angle_period(printed: &Printed) -> Option<Finding> {
    let period = decimal(printed.formula(0)?, &[("l", LENGTH), ("g", GRAVITY)])?;
    let pendulum = Pendulum::new(LENGTH, GRAVITY).ok()?;
    let limit = pendulum.period(&Amplitude::new(Angle::from_radians(1e-9).ok()?).ok()?);
    let deviation = (period / limit - 1.0).abs();
    let evidence = format!(
        "the exact period from 1e-9 rad differs from it by {deviation:.1e} (l = {LENGTH} m, g = {GRAVITY} m/s^2)"
    );
    Some(Finding::verified_if(deviation < 1e-15, "", evidence))
}

/// T/T0 as a series in the amplitude against the exact one.
pub(super) fn agreement(formula: &Expression, through: usize) -> Option<Finding> {
    const TERMS: usize = 16;
    let printed = series_in("theta0", TERMS, formula, &[("T0", 1)])?;
    let exact = exact_series(TERMS);
    let Some((power, difference)) = first_difference(&printed, &exact) else {
        return Some(Finding::verified(format!("equals the exact series to theta0^{}", printed.len() - 1)));
    };
    let term = |n: usize| format!("{}*theta0^{n}", exact[n]);
    let evidence = format!(
        "expanded exactly it agrees with the series of the period below theta0^{power}; its error begins with \
         {difference}*theta0^{power}"
    );
    Some(Finding::verified_if(power > through, format!("the term is {}", term(power)), evidence))
}

/// T/T0 = 1 + 0·θ0 + θ0²/16 + ….
fn exact_series(terms: usize) -> Vec<Rational> {
    let even = period_in_amplitude(terms / 2).into_iter();
    even.flat_map(|coefficient| [coefficient, Rational::from(0)]).take(terms).collect()
}

/// T0/T = 1 + 0·θ0 − θ0²/16 + ….
pub(super) fn frequency_series(terms: usize) -> Vec<Rational> {
    let even = frequency_in_amplitude(terms / 2).into_iter();
    even.flat_map(|coefficient| [coefficient, Rational::from(0)]).take(terms).collect()
}

fn agrees_to_second(printed: &Printed) -> Option<Finding> {
    agreement(printed.formula(0)?, 2)
}

fn agrees_to_sixth(printed: &Printed) -> Option<Finding> {
    agreement(printed.formula(0)?, 6)
}

/// T = T0/√F: the exponent p of θ0/sin θ0 in the period must make p·(1/6) the exact 1/16.
fn exponent_of_molina(printed: &Printed) -> Option<Finding> {
    let force = series_in("theta0", 8, printed.formula(0)?, &[])?;
    let from_force = PowerSeries::rational(8).power(&force, &Rational::new(-1, 2)?)?;
    let period = series_in("theta0", 8, printed.formula(1)?, &[("T0", 1)])?;
    let one_power = super::printed::Printed::read(&["theta0/sin(theta0)"])?;
    let slope = series_in("theta0", 8, one_power.formula(0)?, &[])?.get(2)?.clone();
    let exponent = exact_series(4).get(2)?.checked_div(&slope)?;
    let twice = exponent.clone() + exponent.clone();
    let follows = from_force.iter().zip(&period).all(|(a, b)| a == b);
    let matches = period.get(2) == exact_series(4).get(2);
    let correct = format!("a = {twice}, T = T0*(theta0/sin(theta0))^({exponent})");
    let evidence = format!(
        "theta0/sin(theta0) = 1 + {slope}*theta0^2 + ..., so the exact 1/16 needs the power (1/16)/({slope}) = \
         {exponent} in the period and a = {twice} in F; 1/sqrt(F) and (5) agree to theta0^{}",
        from_force.len() - 1
    );
    Some(Finding::verified_if(follows && matches, correct, evidence))
}

/// formula/exact − 1 over δ², which must tend to −(1/16 − 1/(48·ln(8/δ))), where the next term of K is.
fn asymptotic_at_the_top(printed: &Printed) -> Option<Finding> {
    let complements = [1e-1, 1e-2, 1e-3];
    let mut shown = Vec::new();
    let mut vanishes = true;
    for complement in complements {
        let theta0 = std::f64::consts::PI - complement;
        // What the subtraction π − θ0 gives back.
        let complement = std::f64::consts::PI - theta0;
        let formula = decimal(printed.formula(0)?, &[("T0", 1.0), ("theta0", theta0)])?;
        let error = formula / period_ratio_near_top(complement) - 1.0;
        let expected = -(1.0 / 16.0 - 1.0 / (48.0 * libm::log(8.0 / complement))) * complement * complement;
        vanishes &= (error - expected).abs() < complement.powi(4) + ROUNDING;
        shown.push(format!("{error:.3e} at {complement:.0e} rad below pi"));
    }
    let evidence = format!(
        "the error vanishes as -delta^2*(1/16 - 1/(48*ln(8/delta))), delta = pi - theta0: {}; at small amplitudes \
         it is {:.1} %",
        shown.join(", "),
        100.0 * (decimal(printed.formula(0)?, &[("T0", 1.0), ("theta0", 0.0)])? - 1.0)
    );
    Some(Finding::verified_if(vanishes, "", evidence).restricted("near theta0 = pi"))
}

/// d/dt along any motion is θ′ times the equation of motion: in exact series of the time.
fn energy_is_conserved(printed: &Printed) -> Option<Finding> {
    let ring = PowerSeries::rational(10);
    let angle = arbitrary_motion();
    let (velocity, acceleration) = (derivative(&angle), derivative(&derivative(&angle)));
    let of = |name: &str| match name {
        "theta" => Some(angle.clone()),
        "theta'" => Some(velocity.clone()),
        "omega0" => ring.rational(&Rational::from(3)),
        _ => None,
    };
    let energy = super::evaluate::value(&ring, printed.formula(0)?, &of)?;
    let motion = Printed::read(&["acceleration + 9*sin(theta)"])?;
    let force = super::evaluate::value(&ring, motion.formula(0)?, &|name| {
        (name == "acceleration").then(|| acceleration.clone()).or_else(|| of(name))
    })?;
    let power = ring.multiply(&force, &velocity);
    let same = derivative(&energy).iter().zip(&power).all(|(a, b)| a == b);
    let evidence = "along theta(t) = t/2 + t^2/3 - t^3/5 + t^4/7 its derivative equals theta'*(theta'' + \
                    omega0^2*sin(theta)) to t^6 in exact series (omega0 = 3), which vanishes by (8)";
    Some(Finding::verified_if(same, "", evidence))
}

/// θ = t/2 + t²/3 − t³/5 + t⁴/7, which solves no particular equation, to t⁹.
fn arbitrary_motion() -> Vec<Rational> {
    let chosen =
        [(0, 1), (1, 2), (1, 3), (-1, 5), (1, 7)].into_iter().filter_map(|(n, d)| Rational::new(n, d));
    chosen.chain(std::iter::repeat_n(Rational::from(0), 5)).collect()
}

fn derivative(series: &[Rational]) -> Vec<Rational> {
    let factors = (1..).map(Rational::from);
    series.iter().skip(1).zip(factors).map(|(coefficient, n)| coefficient.clone() * n).collect()
}

fn velocity_at_an_angle(printed: &Printed) -> Option<Finding> {
    let amplitude = at_degrees(120.0)?;
    let mut largest = 0.0_f64;
    for instant in instants(&amplitude, 48)? {
        // The root of the smallest positive number where rounding has made the argument negative.
        let speed = decimal(printed.formula(0)?, &instant.values(amplitude.radians()))?;
        let square = if speed.is_nan() { 0.0 } else { speed * speed };
        largest = largest.max((square - instant.velocity * instant.velocity).abs() * LENGTH / GRAVITY);
    }
    let evidence = format!(
        "at 48 instants of the exact motion from 120 degrees the squares of both sides differ by at most \
         {largest:.1e} of omega0^2"
    );
    Some(Finding::verified_if(largest < ROUNDING, "", evidence))
}

/// The period of (13).
fn period_by_quadrature(printed: &Printed, amplitude: f64) -> Option<f64> {
    let integrand = |theta: f64| decimal(printed.formula(1)?, &[("theta", theta), ("theta0", amplitude)]);
    let factor = decimal(printed.formula(0)?, &[("omega0", (GRAVITY / LENGTH).sqrt())])?;
    Some(factor * to_amplitude(amplitude, &integrand)?)
}

const AMPLITUDES: [f64; 4] = [30.0, 60.0, 90.0, 120.0];

/// The largest |quadrature/expected − 1| over some amplitudes.
fn largest_deviation(printed: &Printed, expected: impl Fn(&Amplitude) -> f64) -> Option<f64> {
    let mut largest = 0.0_f64;
    for degrees in AMPLITUDES {
        let amplitude = Amplitude::new(at_degrees(degrees)?).ok()?;
        let period = period_by_quadrature(printed, amplitude.radians())?;
        largest = largest.max((period / expected(&amplitude) - 1.0).abs());
    }
    Some(largest)
}

fn exact_period(printed: &Printed) -> Option<Finding> {
    let omega0 = (GRAVITY / LENGTH).sqrt();
    let largest = largest_deviation(printed, |amplitude| 4.0 * amplitude.modulus().first() / omega0)?;
    let evidence = format!(
        "its quadrature differs from 4*K(sin(theta0/2))/omega0 by at most {largest:.1e} at 30, 60, 90 and 120 degrees"
    );
    Some(Finding::verified_if(largest < 1e-12, "", evidence))
}

fn name_of_the_integral(printed: &Printed) -> Option<Finding> {
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
    Some(if complete { Finding::wrong(correct, evidence) } else { Finding::verified(evidence) })
}

fn by_the_mean(printed: &Printed) -> Option<Finding> {
    let omega0 = (GRAVITY / LENGTH).sqrt();
    let by_mean = |amplitude: &Amplitude| {
        let (mut a, mut b) = (1.0, libm::cos(amplitude.radians() / 2.0));
        for _ in 0..6 {
            (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
        }
        std::f64::consts::TAU / (omega0 * a)
    };
    let largest = largest_deviation(printed, by_mean)?;
    let evidence = format!(
        "six steps of the mean from 1 and cos(theta0/2) differ from the quadrature of (13) by at most {largest:.1e}; \
         what the mean computes is the complete integral"
    );
    Some(Finding::verified_if(largest < 1e-12, "", evidence))
}
