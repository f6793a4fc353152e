//! Black and Vel, Fig. 1 and (52) to (54): the formulas compared, two better ones, and damping.

use super::Verdict;
use super::compare::{decimal, series_in};
use super::errors::{PLOTTED, error, exact_at, in_words, leaders};
use super::evaluate::value;
use super::exact::agreement;
use super::finding::Finding;
use super::power_series::PowerSeries;
use super::printed::Printed;
use super::roots::in_degrees;
use super::statement::{Document, Statement};
use crate::algebra::{Rational, Ring};
use crate::expression::{Expression, Symbol};
use crate::period_formulas::PeriodFormula;

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
        "Fig. 1",
        "The fractional errors of the corrections with one, two and three terms and of the formulas (4) to (7) and \
         (14) between 0 and 180 degrees.",
        &[],
        figure,
    ),
    statement(
        "(52)",
        "Carvalhaes and Suppes's period, from the arithmetic-geometric mean.",
        &["T = 4*T0/(1 + sqrt(cos(theta0/2)))^2"],
        second_mean,
    ),
    statement(
        "(53)",
        "Belendez and others' period; r is what stands under each root.",
        &["T = 64*T0/(16*(1 + sqrt(r))^2 - (1 - sqrt(r))^4)", "r = 1 + cos(theta0/2)"],
        belendez,
    ),
    statement(
        "(54)",
        "A pendulum with damping.",
        &["theta'' + c*theta'^n + omega0^2*sin(theta) = 0"],
        damping,
    ),
];

/// Every curve against its exact leading term, and who leads where.
fn figure(_: &Printed) -> Option<Finding> {
    const SMALL: f64 = 0.01;
    let mut farthest = 0.0_f64;
    for key in PLOTTED {
        let formula = PeriodFormula::by_key(key).ok()?;
        if let Some(leading) = formula.leading_error() {
            let term = leading.coefficient.to_f64() * libm::pow(SMALL, f64::from(leading.power));
            farthest = farthest.max((error(key, SMALL)? / term - 1.0).abs());
        }
    }
    let zeros = exact_at("black_vel_1")?.into_iter().map(in_degrees).collect::<Vec<_>>().join(", ");
    let evidence = format!(
        "recomputed: at 0.01 rad the errors are their exact leading terms to {farthest:.1e}; the curve of the 1-term \
         formula dips to 0 at {zeros}; the best of the plotted ones is {}",
        in_words(&leaders(&PLOTTED)?)
    );
    Some(Finding::verified_if(farthest < 1e-3, "", evidence))
}

/// 1/a₂ of the mean from 1 and cos(θ0/2), as a series.
fn second_mean_series(terms: usize) -> Option<Vec<Rational>> {
    let ring = PowerSeries::rational(terms);
    let cosine = Printed::read(&["cos(theta0/2)"])?;
    let one = ring.rational(&Rational::from(1))?;
    let (mut a, mut b) = (one.clone(), series_in("theta0", terms, cosine.formula(0)?, &[])?);
    for _ in 0..2 {
        let mean = ring.over_integer(&ring.add(&a, &b), 2)?;
        b = ring.power(&ring.multiply(&a, &b), &Rational::new(1, 2)?)?;
        a = mean;
    }
    ring.divide(&one, &a)
}

fn second_mean(printed: &Printed) -> Option<Finding> {
    const TERMS: usize = 14;
    let stands = series_in("theta0", TERMS, printed.formula(0)?, &[("T0", 1)])?;
    let same = stands == second_mean_series(TERMS)?;
    let agreement = agreement(printed.formula(0)?, 2)?;
    let evidence = format!(
        "equals T0/a2 of the mean from 1 and cos(theta0/2){}; {}",
        if same { " to theta0^13, exactly" } else { ": it does not" },
        agreement.evidence
    );
    Some(Finding::verified_if(same, "T = T0/a2 = 4*T0/(1 + sqrt(cos(theta0/2)))^2", evidence))
}

/// What may be meant under the roots.
const READINGS: [&str; 5] = [
    "1 + cos(theta0/2)",
    "1 + cos(theta0)/2",
    "(1 + cos(theta0))/2",
    "(1 + cos(theta0/2))/2",
    "cos(theta0/2)",
];

fn belendez(printed: &Printed) -> Option<Finding> {
    let formula = printed.formula(0)?;
    let inserted = |under: &Expression| formula.substitute(&Symbol::plain("r"), under);
    let stands = inserted(printed.formula(1)?);
    if let Some(found) = agreement(&stands, 2).filter(|found| found.verdict == Verdict::Verified) {
        return Some(found);
    }
    let mut tried = Vec::new();
    let mut meant = None;
    for reading in READINGS {
        let under = Printed::read(&[reading])?;
        let whole = inserted(under.formula(0)?);
        let at_rest = decimal(&whole, &[("theta0", 0.0), ("T0", 1.0)])?;
        let slope = series_in("theta0", 4, &whole, &[("T0", 1)]).and_then(|series| series.get(2).cloned());
        tried.push(match slope {
            Some(slope) => format!("r = {reading}: T/T0 = 1 + {slope}*theta0^2 + ..."),
            None => format!("r = {reading}: T(0)/T0 = {at_rest:.5}"),
        });
        let agrees = agreement(&whole, 2).filter(|found| found.verdict == Verdict::Verified);
        meant = meant.or_else(|| agrees.map(|found| (reading, found.evidence)));
    }
    let at_rest = decimal(&stands, &[("theta0", 0.0), ("T0", 1.0)])?;
    let evidence =
        format!("as it stands T(0)/T0 = {at_rest:.5}, which must be 1; readings tried: {}", tried.join("; "));
    Some(match meant {
        Some((reading, agreement)) => {
            Finding::typo(format!("r = {reading}"), format!("{evidence}; with r = {reading}: {agreement}"))
        }
        None => Finding::wrong("", evidence),
    })
}

/// θ′ times the equation is dE/dt = −c·θ′ⁿ⁺¹, which must not be positive for any θ′.
fn damping(printed: &Printed) -> Option<Finding> {
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
    let conserved = integral_of_square_damping(printed)?;
    let evidence = format!(
        "theta' times it gives dE/dt = -c*theta'^(n+1); of n = 1, 2, 3, 4 the term drives the backward swing for n = \
         {}; at n = 2 theta'^2*exp(2c*theta) + 2*exp(2c*theta)*(2c*sin(theta) - cos(theta))/(4c^2 + 1) {} (exact series \
         of a motion, c = 1/3, omega0 = 1): no damping at all",
        driving.join(", "),
        if conserved { "is conserved to t^7" } else { "is not conserved" }
    );
    let correct = "theta'' + c*theta'*|theta'|^(n-1) + omega0^2*sin(theta) = 0";
    let finding = Finding::verified_if(driving.is_empty(), correct, evidence);
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
        let known = series.iter().skip(1).zip(steps).map(|(a, n)| a.clone() * n);
        known.chain([Rational::from(0)]).collect::<Vec<_>>()
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
    // The last coefficient lacks its velocity.
    Some(along.iter().skip(1).take(TERMS - 2).all(Rational::is_zero))
}
