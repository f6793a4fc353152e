//! Côté, (1) to (12): conservation of energy, the speed, the period as an integral.

use super::{statement, text_after};
use crate::paper::amplitudes::at_degrees;
use crate::paper::compare::{ROUNDING, decimal, identity, series_in};
use crate::paper::exact_motion::{GRAVITY, Instant, LENGTH, instants};
use crate::paper::finding::StatementFinding;
use crate::paper::printed::Printed;
use crate::paper::quadrature::to_amplitude;
use crate::paper::statement::PrintedStatement;
use libration::algebra::Rational;
use libration::expression::{Expression, Symbol};
use libration::pendulum::{Amplitude, Pendulum};
use libration::quantity::Angle;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(1)",
        "The energy is the kinetic and the potential energy, and does not change.",
        &["E = T + U"],
        energy_of_the_motion,
    ),
    text_after(
        "(1)",
        "text: the pendulum has two degrees of freedom",
        "The number of coordinates that determine the position of the pendulum.",
        &["freedom = 2"],
        degrees_of_freedom,
    )
    .paraphrased(),
    statement("(2)", "The potential energy.", &["U = m*g*l*(1 - cos(theta))"], potential_energy),
    statement("(3)", "The energy at the release.", &["E = m*g*l*(1 - cos(theta0))"], energy_of_the_motion),
    statement(
        "(4)",
        "The energy at any time.",
        &["m*g*l*(1 - cos(theta0)) = m*v^2/2 + m*g*l*(1 - cos(theta))"],
        holds_in_motion,
    ),
    text_after(
        "(4)",
        "text: the result is independent of the mass",
        "The mass drops out of (4).",
        &["m*g*l*(1 - cos(theta0)) = m*v^2/2 + m*g*l*(1 - cos(theta))"],
        without_mass,
    ),
    statement("(5)", "The speed at an angle.", &["v^2 = 2*g*l*(cos(theta) - cos(theta0))"], holds_in_motion),
    statement("(6)", "The speed is that along the arc.", &["v = l*theta'"], speed_along_the_arc),
    statement(
        "(7)",
        "The angular velocity at an angle.",
        &["theta' = sqrt(2*g/l)*sqrt(cos(theta) - cos(theta0))"],
        rising_quarter,
    ),
    statement(
        "(8)",
        "The time that a small angle takes: dt over d(theta).",
        &["sqrt(l/(2*g))/sqrt(cos(theta) - cos(theta0))", "sqrt(2*g/l)*sqrt(cos(theta) - cos(theta0))"],
        separated,
    ),
    statement(
        "(9)",
        "A factor times the integral of this from 0 to theta0 is a quarter of the period.",
        &["sqrt(l/(2*g))", "1/sqrt(cos(theta) - cos(theta0))"],
        quarter_of_the_period,
    ),
    statement(
        "(10)",
        "A factor times the integral of this from 0 to theta0 is the period.",
        &["sqrt(8*l/g)", "1/sqrt(cos(theta) - cos(theta0))"],
        whole_period,
    ),
    statement("(11)", "The period begins with that of small swings.", &["T = 2*pi*sqrt(l/g)"], leading_term),
    statement(
        "(12)",
        "The binomial series.",
        &["(1 + x)^n = 1 + n*x + n*(n - 1)/2*x^2 + n*(n - 1)*(n - 2)/6*x^3"],
        binomial_series,
    ),
];

const MASS: f64 = 1.7;

fn amplitude() -> Option<Angle> {
    Angle::from_degrees(120.0).ok()
}

/// The values of the symbols at an instant, for a given mass.
fn values(instant: &Instant, amplitude: f64, mass: f64) -> Vec<(&'static str, f64)> {
    let speed = LENGTH * instant.velocity.abs();
    let kinetic = mass * speed * speed / 2.0;
    let potential = mass * GRAVITY * LENGTH * (1.0 - libm::cos(instant.angle));
    let more = [("m", mass), ("v", speed), ("T", kinetic), ("U", potential)];
    instant.values(amplitude).into_iter().chain(more).collect()
}

fn evidence(largest: f64, what: &str) -> String {
    format!(
        "{what}: at 48 instants of the exact motion from 120 degrees the sides differ by at most {largest:.1e} of m*g*l"
    )
}

/// The formula must give the same energy at all times, that of the release.
fn energy_of_the_motion(printed: &Printed) -> Option<StatementFinding> {
    let theta0 = amplitude()?;
    let scale = MASS * GRAVITY * LENGTH;
    let release = scale * (1.0 - libm::cos(theta0.radians()));
    let mut largest = 0.0_f64;
    for instant in instants(&theta0, 48)? {
        let all = values(&instant, theta0.radians(), MASS);
        let of = |name: &str| all.iter().find(|(symbol, _)| *symbol == name).map(|(_, value)| *value);
        let stands = decimal(printed.formula(0)?, &all)?;
        largest =
            largest.max((stands - of("T")? - of("U")?).abs() / scale).max((stands - release).abs() / scale);
    }
    let what = "the energy m*v^2/2 + m*g*l*(1 - cos(theta)) of the motion (T is the kinetic energy here, the period from (9) on)";
    Some(StatementFinding::verified_if(largest < ROUNDING, "", evidence(largest, what)))
}

/// Two coordinates in the plane of the swing minus one for the rod, whose length depends on the position everywhere on the circle.
fn degrees_of_freedom(printed: &Printed) -> Option<StatementFinding> {
    let claimed = decimal(printed.formula(0)?, &[])?;
    let slope = |instant: &Instant| {
        let (x, y) = (LENGTH * libm::sin(instant.angle), -LENGTH * libm::cos(instant.angle));
        libm::hypot(2.0 * x, 2.0 * y)
    };
    let least = instants(&amplitude()?, 48)?.iter().map(slope).fold(f64::INFINITY, f64::min);
    let constraints = if least > 0.0 { 1.0 } else { 0.0 };
    let evidence = format!(
        "two coordinates x and y in the plane of the swing, less the constraint x^2 + y^2 = l^2, whose gradient is nowhere zero \
         (at least {:.3}*l at 48 instants): theta alone says where the pendulum is",
        least / LENGTH
    );
    Some(StatementFinding::verified_if(
        (claimed - (2.0 - constraints)).abs() < 0.5,
        "one degree of freedom: theta",
        evidence,
    ))
}

/// −dU/dθ must be the torque −m·g·l·sin θ, exactly.
fn potential_energy(printed: &Printed) -> Option<StatementFinding> {
    let potential = series_in("theta", 12, printed.formula(0)?, &[("m", 2), ("g", 3), ("l", 5)])?;
    let torque = Printed::read(&["30*sin(theta)"])?;
    let torque = series_in("theta", 11, torque.formula(0)?, &[])?;
    let slope = (1..).map(Rational::from).zip(potential.iter().skip(1)).map(|(n, c)| c.clone() * n);
    let right = slope.eq(torque) && potential.first().is_some_and(Rational::is_zero);
    let evidence =
        "it vanishes at the bottom and its derivative is the torque m*g*l*sin(theta) to theta^10, exactly";
    Some(StatementFinding::verified_if(right, "U = m*g*l*(1 - cos(theta))", evidence))
}

/// The largest difference of the sides over the motion, for a given mass.
fn largest_difference(printed: &Printed, mass: f64) -> Option<f64> {
    let theta0 = amplitude()?;
    let residual = printed.residual(0)?;
    let difference =
        |instant: &Instant| Some(decimal(&residual, &values(instant, theta0.radians(), mass))?.abs());
    let differences = instants(&theta0, 48)?.iter().map(difference).collect::<Option<Vec<_>>>()?;
    Some(differences.into_iter().fold(0.0, f64::max) / (GRAVITY * LENGTH))
}

fn holds_in_motion(printed: &Printed) -> Option<StatementFinding> {
    let largest = largest_difference(printed, MASS)?;
    Some(StatementFinding::verified_if(
        largest < ROUNDING,
        "",
        evidence(largest, "every quarter of the swing"),
    ))
}

fn without_mass(printed: &Printed) -> Option<StatementFinding> {
    let masses = [0.1, 1.0, 10.0];
    let differences = masses.map(|mass| largest_difference(printed, mass).map(|largest| largest / mass));
    let largest = differences.into_iter().collect::<Option<Vec<_>>>()?.into_iter().fold(0.0, f64::max);
    let what = "the same speeds with m = 0.1, 1 and 10 kg";
    Some(StatementFinding::verified_if(largest < ROUNDING, "", evidence(largest, what)))
}

fn speed_along_the_arc(printed: &Printed) -> Option<StatementFinding> {
    let cartesian = Printed::read(&["(l*cos(theta)*theta')^2 + (l*sin(theta)*theta')^2"])?;
    let square = Expression::Power(
        Box::new(printed.formula(0)?.clone()),
        Box::new(Expression::Number(Rational::from(2))),
    );
    let residual = Expression::Subtract(Box::new(square), Box::new(cartesian.formula(0)?.clone()));
    let ranges = [("l", 0.5, 2.0), ("theta", -3.0, 3.0), ("theta'", -2.0, 2.0)];
    identity(&residual, &ranges, "its square is that of the velocity of (l*sin(theta), -l*cos(theta))")
}

fn rising_quarter(printed: &Printed) -> Option<StatementFinding> {
    let theta0 = amplitude()?;
    let (mut squares, mut rising) = (0.0_f64, true);
    for instant in instants(&theta0, 48)? {
        // At the turning points, rounding errors may make the difference of the cosines negative.
        let turns = (instant.velocity.abs() < 1e-6).then_some(0.0);
        let stands = decimal(printed.formula(0)?, &instant.values(theta0.radians())).or(turns)?;
        squares =
            squares.max((stands * stands - instant.velocity * instant.velocity).abs() * LENGTH / GRAVITY);
        rising &= instant.velocity <= 1e-9 || (stands - instant.velocity).abs() < 1e-7;
    }
    let evidence = format!(
        "at 48 instants of the exact motion from 120 degrees the squares of both sides differ by at most {squares:.1e}*g/l; \
         the sign is that of the quarters in which theta grows: after the release theta' is negative, for the same time"
    );
    Some(StatementFinding::verified_if(squares < ROUNDING && rising, "", evidence))
}

fn separated(printed: &Printed) -> Option<StatementFinding> {
    let both =
        Expression::Multiply(Box::new(printed.formula(0)?.clone()), Box::new(printed.formula(1)?.clone()));
    let residual = Expression::Subtract(Box::new(both), Box::new(Expression::Number(Rational::from(1))));
    let ranges = [("g", 1.0, 10.0), ("l", 0.5, 2.0), ("theta", 0.0, 1.0), ("theta0", 1.2, 3.0)];
    identity(&residual, &ranges, "it is one over the angular velocity of (7)")
}

fn quarter_of_the_period(printed: &Printed) -> Option<StatementFinding> {
    integral(printed, 4.0)
}

fn whole_period(printed: &Printed) -> Option<StatementFinding> {
    integral(printed, 1.0)
}

/// The quadrature compared with the exact period divided by a number.
fn integral(printed: &Printed, share: f64) -> Option<StatementFinding> {
    let pendulum = Pendulum::new(LENGTH, GRAVITY).ok()?;
    let factor = decimal(printed.formula(0)?, &[("g", GRAVITY), ("l", LENGTH)])?;
    let mut largest = 0.0_f64;
    for degrees in [30.0, 60.0, 90.0, 120.0] {
        let amplitude = Amplitude::new(at_degrees(degrees)?).ok()?;
        let theta0 = amplitude.radians();
        let integrand = |theta: f64| decimal(printed.formula(1)?, &[("theta", theta), ("theta0", theta0)]);
        let stands = factor * to_amplitude(theta0, &integrand)?;
        largest = largest.max((stands * share / pendulum.period(&amplitude) - 1.0).abs());
    }
    let evidence = format!(
        "quadrature and exact period differ by at most {largest:.1e} at 30, 60, 90 and 120 degrees; the integrand is \
         infinite at theta0, the integral is not"
    );
    Some(StatementFinding::verified_if(largest < 1e-12, "", evidence))
}

fn leading_term(printed: &Printed) -> Option<StatementFinding> {
    let pendulum = Pendulum::new(LENGTH, GRAVITY).ok()?;
    let stands = decimal(printed.formula(0)?, &[("g", GRAVITY), ("l", LENGTH)])?;
    let excess = |theta0: f64| {
        Some(pendulum.period(&Amplitude::new(Angle::from_radians(theta0).ok()?).ok()?) / stands - 1.0)
    };
    let evidence = format!(
        "the exact period exceeds it by {:.3e} at 0.1 rad, {:.3e} at 0.01 rad and {:.1e} at 1e-9 rad, as theta0^2/16",
        excess(0.1)?,
        excess(0.01)?,
        excess(1e-9)?
    );
    Some(StatementFinding::verified_if(excess(1e-9)?.abs() < 1e-15, "", evidence))
}

fn binomial_series(printed: &Printed) -> Option<StatementFinding> {
    let exponents = [(-1, 2), (1, 3), (-2, 1), (5, 2)];
    let mut right = true;
    for (numerator, denominator) in exponents {
        let n = Expression::Number(Rational::new(numerator, denominator)?);
        let side = |side: &Expression| series_in("x", 4, &side.substitute(&Symbol::plain("n"), &n), &[]);
        right &= side(printed.left(0)?)? == side(printed.formula(0)?)?;
    }
    let evidence =
        "the first four terms are exact for n = -1/2, 1/3, -2 and 5/2; the series converges for |x| < 1";
    Some(StatementFinding::verified_if(right, "", evidence).restricted("for |x| < 1"))
}
