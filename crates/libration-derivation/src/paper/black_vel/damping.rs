//! (54): the equation with damping.

use super::statement;
use crate::paper::compare::decimal;
use crate::paper::evaluate::value;
use crate::paper::finding::StatementFinding;
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Rational, Ring};
use libration::expression::{Expression, Symbol};
use libration::series::PowerSeries;

pub(super) const STATEMENTS: &[PrintedStatement] = &[statement(
    "(54)",
    "A pendulum with damping.",
    &["theta'' + c*theta'^n + omega0^2*sin(theta) = 0"],
    damping,
)];

/// θ′ times the equation is dE/dt = −c·θ′ⁿ⁺¹, which must not be positive for any θ′.
fn damping(printed: &Printed) -> Option<StatementFinding> {
    let mut driving = Vec::new();
    for n in 1..=4 {
        let exponent = Expression::Number(Rational::from(n));
        let equation = printed.left(0)?.substitute(&Symbol::plain("n"), &exponent);
        let power_loss = |velocity: f64| {
            let values =
                [("theta''", 0.0), ("theta", 0.0), ("theta'", velocity), ("c", 1.0), ("omega0", 1.0)];
            Some(velocity * decimal(&equation, &values)?)
        };
        if power_loss(-1.0)? < 0.0 || power_loss(1.0)? < 0.0 {
            driving.push(n.to_string());
        }
    }
    let conserved = match integral_of_square_damping(printed) {
        Some(true) => "is conserved to t^7",
        Some(false) => "is not conserved",
        None => "is not followed, as this has no series",
    };
    let evidence = format!(
        "theta' times it gives dE/dt = -c*theta'^(n+1); of n = 1, 2, 3, 4 the term drives the backward swing for n = \
         {}; at n = 2 theta'^2*exp(2c*theta) + 2*exp(2c*theta)*(2c*sin(theta) - cos(theta))/(4c^2 + 1) {} (exact series \
         of a motion, c = 1/3, omega0 = 1): no damping at all",
        driving.join(", "),
        conserved
    );
    let correct = "theta'' + c*theta'*|theta'|^(n-1) + omega0^2*sin(theta) = 0";
    let finding = StatementFinding::verified_if(driving.is_empty(), correct, evidence);
    Some(if driving.is_empty() { finding } else { finding.restricted("for even n") })
}

/// The first integral at n = 2 along an exact power-series solution.
fn integral_of_square_damping(printed: &Printed) -> Option<bool> {
    const TERMS: usize = 9;
    let ring = PowerSeries::rational(TERMS);
    let equation = printed.left(0)?.substitute(&Symbol::plain("n"), &Expression::Number(Rational::from(2)));
    let c = ring.rational(&Rational::new(1, 3)?)?;
    let start = ring.multiply(&ring.variable()?, &ring.rational(&Rational::new(3, 4)?)?);
    let slope = |series: &[Rational]| {
        let steps = (1..).map(Rational::from);
        let factors = series.iter().skip(1).zip(steps).map(|(a, n)| a.clone() * n);
        factors.chain([Rational::from(0)]).collect::<Vec<_>>()
    };
    let with = |angle: &Vec<Rational>, formula: &Expression, acceleration: Vec<Rational>| {
        value(&ring, formula, &|name| match name {
            "theta" => Some(angle.clone()),
            "theta'" => Some(slope(angle)),
            "theta''" => Some(acceleration.clone()),
            "c" => Some(c.clone()),
            "omega0" => ring.rational(&Rational::from(1)),
            _ => None,
        })
    };
    let mut angle = start.clone();
    for _ in 0..TERMS {
        let force = ring.negate(&with(&angle, &equation, ring.zero())?);
        let twice_integrated = (0..TERMS).map(|n| match n.checked_sub(2) {
            None => Some(Rational::from(0)),
            Some(before) => {
                let divisor = i64::try_from(n * (n - 1)).ok()?;
                force[before].checked_div(&Rational::from(divisor))
            }
        });
        angle = ring.add(&start, &twice_integrated.collect::<Option<Vec<_>>>()?);
    }
    let integral = Printed::read(&[
        "theta'^2*exp(2*c*theta) + 2*exp(2*c*theta)*(2*c*sin(theta) - cos(theta))/(4*c^2 + 1)",
    ])?;
    let along = with(&angle, integral.formula(0)?, ring.zero())?;
    // The last coefficient is incomplete, because the velocity has one coefficient less.
    Some(along.iter().skip(1).take(TERMS - 2).all(Rational::is_zero))
}
