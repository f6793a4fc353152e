//! Black and Vel, (15) to (31): two harmonics in the equation truncated after θ³.

use super::compare::{
    decimal, first_difference, inserted as inserted_into, polynomial, same_polynomial, series_in,
};
use super::cosines::{cosine, cosines, projection, second_derivative};
use super::exact_motion::harmonics;
use super::finding::Finding;
use super::lindstedt::{Expansion, numbers};
use super::power_series::PowerSeries;
use super::printed::Printed;
use super::statement::{Document, Statement};
use crate::algebra::{Polynomial, Rational, Rationals, Ring, Variable};
use crate::expression::Expression;
use crate::quantity::Angle;
use crate::series::truncated::powers_of_inverse;

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
        "(18)",
        "Two harmonics to begin with (cn is cos(n*Omega*t)).",
        &["theta = a1*c1 + a3*c3"],
        two_harmonics,
    ),
    statement("(19)", "The sine to its second term.", &["theta - theta^3/6"], sine_to_third),
    statement(
        "(20)",
        "The equation of motion with this sine.",
        &["theta'' + omega0^2*(theta - theta^3/6) = 0"],
        truncated_equation,
    ),
    statement(
        "(21)",
        "(18) in (20), divided by omega0^2, with Delta = Omega/omega0.",
        &["0 = Delta^2*(-a1*c1 - 9*a3*c3) + a1*c1 + a3*c3 - (a1*c1 + a3*c3)^3/6"],
        inserted,
    ),
    statement(
        "(22)",
        "(21) times cos(Omega*t), integrated over a period.",
        &["0 = -8 + a1^2 + a1*a3 + 2*a3^2 + 8*Delta^2"],
        on_the_fundamental,
    ),
    statement(
        "(23)",
        "(21) times cos(3*Omega*t), integrated over a period.",
        &["0 = a1^3 + 6*a1^2*a3 + 3*a3*(-8 + a3^2 + 72*Delta^2)"],
        on_the_third,
    ),
    statement("(24)", "The amplitude is the motion at t = 0.", &["theta0 = a1 + a3"], amplitude_of_two),
    statement(
        "(25)",
        "(22) solved for the square of the frequency.",
        &["Delta^2 = 1 - (a1^2 + a1*a3 + a3^2)/8"],
        solved_for_the_frequency,
    ),
    statement(
        "(26)",
        "Its root, where a3 is much smaller than a1.",
        &["Delta = 1 - a1^2/16"],
        root_of_the_square,
    ),
    statement(
        "(27)",
        "(26) in (23), solved for the a3 that stands alone.",
        &["a3 = (-a1^3 + 426*a1^2*a3 - 216*a1^4*a3 - 3*a3^3)/192"],
        solved_for_the_third,
    ),
    statement("(28)", "Its leading term.", &["a3 = -a1^3/192"], third_of_fundamental),
    statement("(29)", "The same in the amplitude.", &["a3 = -theta0^3/192"], third_of_amplitude),
    statement(
        "(30)",
        "The fundamental in the amplitude.",
        &["a1 = theta0 + theta0^3/192"],
        fundamental_of_amplitude,
    ),
    statement(
        "(31)",
        "The frequency in the amplitude.",
        &["Delta = 1 - theta0^2/16"],
        frequency_of_amplitude,
    ),
];

/// The motion (18).
fn motion() -> Polynomial {
    Polynomial::variable("a1") * cosine(1) + Polynomial::variable("a3") * cosine(3)
}

/// Δ²θ″ + θ − θ³/3! of this motion.
fn equation_of(motion: &Polynomial) -> Option<Polynomial> {
    let inertia = Polynomial::variable("Delta").pow(2) * second_derivative(motion);
    Some(inertia + motion.clone() - motion.pow(3).scaled(&Rational::new(1, 6)?))
}

/// The equation on the n-th harmonic, up to a factor: the first coefficient is that of the printed one.
fn condition(n: u32) -> Option<Polynomial> {
    Some(projection(&equation_of(&motion())?, n))
}

fn two_harmonics(printed: &Printed) -> Option<Finding> {
    let theta = polynomial(printed.formula(0)?, &cosines())?;
    let unknowns: Vec<String> = theta.variables().into_iter().map(|name| name.to_string()).collect();
    let shares = [30.0, 90.0].map(|degrees| {
        let harmonics = harmonics(&Angle::from_degrees(degrees).ok()?)?;
        Some(harmonics.get(2)?.abs() / harmonics.first()?)
    });
    let even = projection(&theta, 2).is_zero() && projection(&theta, 4).is_zero();
    let evidence = format!(
        "definition; consistent: (22), (23) and (24) are three equations for a1, a3 and Delta; the first harmonic \
         left out, a5, is {:.1e} of a1 at 30 degrees and {:.1e} at 90 degrees",
        shares[0]?, shares[1]?
    );
    Some(Finding::verified_if(
        even && theta == motion(),
        format!("theta = {}", motion()),
        format!("{evidence}; names {}", unknowns.join(", ")),
    ))
}

fn sine_to_third(printed: &Printed) -> Option<Finding> {
    sine(printed.formula(0)?, 3)
}

/// A truncated sine against the sine, exactly; an inertia beside it does not count.
pub(super) fn sine(formula: &Expression, through: usize) -> Option<Finding> {
    let terms = through + 8;
    let polynomial = series_in("theta", terms, formula, &[("theta''", 0)])?;
    let exact = Printed::read(&["sin(theta)"])?;
    let exact = series_in("theta", terms, exact.formula(0)?, &[])?;
    let (power, error) = first_difference(&polynomial, &exact)?;
    let correct = format!("the term is {}*theta^{power}", exact[power]);
    let evidence = format!(
        "agrees with the series of the sine below theta^{power}; its error begins with {error}*theta^{power}"
    );
    Some(Finding::verified_if(power > through, correct, evidence))
}

/// An equation of motion θ″ + ω0²·(…) whose bracket is the sine to a power.
pub(super) fn equation_with_sine(printed: &Printed, through: usize) -> Option<Finding> {
    let values = [("theta''", 0), ("omega0", 1)];
    let force = series_in("theta", through + 8, printed.left(0)?, &values)?;
    let exact = Printed::read(&["sin(theta)"])?;
    let exact = series_in("theta", through + 8, exact.formula(0)?, &[])?;
    let (power, error) = first_difference(&force, &exact)?;
    let inertia = polynomial(printed.left(0)?, &[("theta", Polynomial::zero())])?;
    let right = inertia == Polynomial::variable("theta''") && power > through;
    let evidence = format!(
        "(8) with the sine to theta^{through}; what is left out begins with {}*theta^{power}",
        -error
    );
    Some(Finding::verified_if(
        right,
        format!("the term of the force is {}*theta^{power}", exact[power]),
        evidence,
    ))
}

fn truncated_equation(printed: &Printed) -> Option<Finding> {
    equation_with_sine(printed, 3)
}

fn inserted(printed: &Printed) -> Option<Finding> {
    let stands = polynomial(printed.formula(0)?, &cosines())?;
    let how = "theta of (18) put into (20) as a polynomial in cos(Omega*t)";
    Some(same_polynomial(&stands, &equation_of(&motion())?, how))
}

fn on_the_fundamental(printed: &Printed) -> Option<Finding> {
    projected(printed, 1)
}

fn on_the_third(printed: &Printed) -> Option<Finding> {
    projected(printed, 3)
}

fn projected(printed: &Printed, n: u32) -> Option<Finding> {
    let (stands, computed) = (polynomial(printed.formula(0)?, &[])?, condition(n)?);
    let how = format!("the projection of (21) on cos({n}*Omega*t)");
    if let Some(factor) = computed.divide_exactly(&stands).filter(|factor| factor.terms().count() == 1) {
        return Some(Finding::verified(format!("{how} is ({factor}) times it, exactly")));
    }
    let correct = computed.divide_exactly(&common_factor(&computed))?;
    Some(Finding::wrong(format!("0 = {correct}"), format!("{how} is {computed}")))
}

/// The monomial that divides every term, with the coefficient of the lowest term.
fn common_factor(sum: &Polynomial) -> Polynomial {
    let smallest =
        |name: &Variable| sum.terms().map(|(monomial, _)| monomial.exponent(name)).min().unwrap_or(0);
    let powers =
        sum.variables().into_iter().map(|name| Polynomial::variable(name.clone()).pow(smallest(&name)));
    powers.fold(Polynomial::constant(Rational::from(1)), |product, power| product * power)
}

fn amplitude_of_two(printed: &Printed) -> Option<Finding> {
    let at_start = motion().substitute(&"c".into(), &Polynomial::constant(Rational::from(1)));
    Some(same_polynomial(&polynomial(printed.formula(0)?, &[])?, &at_start, "(18) at t = 0"))
}

/// Δ² from the projection on the fundamental, which is linear in it.
fn square_of_frequency() -> Option<Polynomial> {
    let condition = condition(1)?;
    let delta = Variable::from("Delta");
    (-condition.coefficient(&delta, 0)).divide_exactly(&condition.coefficient(&delta, 2))
}

fn solved_for_the_frequency(printed: &Printed) -> Option<Finding> {
    let (stands, computed) = (polynomial(printed.formula(0)?, &[])?, square_of_frequency()?);
    let difference = stands.clone() - computed.clone();
    if difference.is_zero() {
        return Some(Finding::verified("(22) solved for Delta^2, exactly"));
    }
    let left_over = condition(1)?.coefficient(&"Delta".into(), 0)
        + condition(1)?.coefficient(&"Delta".into(), 2) * stands;
    let order = order_of(&difference);
    let evidence = format!(
        "(22) solved for Delta^2 exactly; the printed form less the correct one is {difference}, and put into the \
         projection it leaves {left_over} instead of 0; the difference is of the order theta0^{order}, beyond what \
         is kept"
    );
    Some(Finding::wrong(format!("Delta^2 = {computed}"), evidence))
}

/// The lowest power of θ0 where a1 is of the first and a3 of the third.
fn order_of(sum: &Polynomial) -> u32 {
    let weight = |name: &Variable| name.index().unwrap_or(0);
    let orders = sum
        .terms()
        .map(|(monomial, _)| monomial.factors().iter().map(|(name, exponent)| weight(name) * exponent).sum());
    orders.min().unwrap_or(0)
}

fn root_of_the_square(printed: &Printed) -> Option<Finding> {
    const TERMS: usize = 6;
    let leading = square_of_frequency()?.substitute(&"a3".into(), &Polynomial::zero());
    let root =
        PowerSeries::rational(TERMS).power(&coefficients(&leading, "a1", TERMS)?, &Rational::new(1, 2)?)?;
    let stands = series_in("a1", TERMS, printed.formula(0)?, &[])?;
    let agrees_below = first_difference(&stands, &root).map_or(TERMS, |(power, _)| power);
    let evidence = format!(
        "the root of the correct Delta^2 at a3 = 0 is {} + ..., exactly; a3, of the order a1^3, enters at a1^4",
        written(&root[..4], "a1")
    );
    Some(Finding::verified_if(agrees_below > 2, format!("Delta = {}", written(&root[..3], "a1")), evidence))
}

/// The coefficients of a polynomial in one variable.
pub(super) fn coefficients(sum: &Polynomial, name: &str, terms: usize) -> Option<Vec<Rational>> {
    let variable = Variable::from(name);
    (0..u32::try_from(terms).ok()?).map(|power| sum.coefficient(&variable, power).to_constant()).collect()
}

/// A series as text, without its zeros.
pub(super) fn written(series: &[Rational], name: &str) -> String {
    let power = |n: usize| Polynomial::variable(name).pow(u32::try_from(n).unwrap_or(u32::MAX));
    let terms = series.iter().enumerate().filter(|(_, c)| !c.is_zero());
    terms.fold(Polynomial::zero(), |sum, (n, c)| sum + power(n).scaled(c)).to_string()
}

/// The second condition with this frequency, solved for the a3 that stands alone: the numerator and the divisor.
fn third_alone(frequency: &Polynomial) -> Option<(Polynomial, Rational)> {
    let scaled = condition(3)?.scaled(&Rational::from(-24)).substitute(&"Delta".into(), frequency);
    let alone =
        scaled.coefficient(&"a3".into(), 1).substitute(&"a1".into(), &Polynomial::zero()).to_constant()?;
    Some((Polynomial::variable("a3").scaled(&alone) - scaled, alone))
}

fn solved_for_the_third(printed: &Printed) -> Option<Finding> {
    let stands = polynomial(printed.formula(0)?, &[])?;
    let of_frequency = |text: &str| {
        let frequency = Printed::read(&[text])?;
        third_alone(&polynomial(frequency.formula(0)?, &[])?)
    };
    let (numerator, divisor) = of_frequency("1 - a1^2/16")?;
    let (slip, slip_divisor) = of_frequency("1 - a1^2")?;
    let inverse = Rational::from(1).checked_div(&divisor)?;
    if stands == numerator.scaled(&inverse) {
        return Some(Finding::verified("(26) put into (23) and solved for a3, exactly"));
    }
    let from_slip = stands == slip.scaled(&Rational::from(1).checked_div(&slip_divisor)?);
    let origin = if from_slip { ", which is exactly what is printed: the 1/16 was lost" } else { "" };
    let evidence = format!(
        "(26) put into (23), exactly, gives 192*a3 = {numerator}; with Delta = 1 - a1^2 instead it gives \
         {slip_divisor}*a3 = {slip}{origin}; the leading term and so (28) are not touched"
    );
    Some(Finding::wrong(format!("a3 = ({numerator})/{divisor}"), evidence))
}

/// a3 of a1 from both conditions, as a series, by iteration.
fn third_of_fundamental_series(terms: usize) -> Option<Vec<Rational>> {
    let delta = Variable::from("Delta");
    let condition = condition(3)?;
    let eliminated =
        condition.coefficient(&delta, 0) + condition.coefficient(&delta, 2) * square_of_frequency()?;
    let alone = eliminated
        .coefficient(&"a3".into(), 1)
        .substitute(&"a1".into(), &Polynomial::zero())
        .to_constant()?;
    let next = Polynomial::variable("a3") - eliminated.scaled(&Rational::from(1).checked_div(&alone)?);
    let mut third = Polynomial::zero();
    for _ in 0..terms {
        let better = next.substitute(&"a3".into(), &third);
        third = powers(&coefficients(&better, "a1", terms)?, "a1");
    }
    coefficients(&third, "a1", terms)
}

fn powers(series: &[Rational], name: &str) -> Polynomial {
    let power = |n: u32| Polynomial::variable(name).pow(n);
    (0..).zip(series).fold(Polynomial::zero(), |sum, (n, c)| sum + power(n).scaled(c))
}

/// a1, a3 and Δ of the truncated system as series in θ0.
fn solution_in_amplitude(terms: usize) -> Option<[Vec<Rational>; 3]> {
    let ring = PowerSeries::rational(terms);
    let third = third_of_fundamental_series(terms)?;
    let amplitude = ring.add(&ring.variable()?, &third);
    let inverse = powers_of_inverse(&Rationals, &amplitude)?;
    let (fundamental, third) = (inverse.first(), inverse.composed(&Rationals, &third));
    let squared = inserted_into(&ring, &square_of_frequency()?, |name| match name {
        "a1" => Some(fundamental.clone()),
        "a3" => Some(third.clone()),
        _ => None,
    })?;
    let frequency = ring.power(&squared, &Rational::new(1, 2)?)?;
    Some([fundamental, third, frequency])
}

fn third_of_fundamental(printed: &Printed) -> Option<Finding> {
    const TERMS: usize = 8;
    let stands = series_in("a1", TERMS, printed.formula(0)?, &[])?;
    let truncated = third_of_fundamental_series(TERMS)?;
    let mut finding = against_series(&stands, &truncated, 3, "a1", "(22) and (23) solved for a3")?;
    finding.evidence += &format!("; the whole sine gives {}", written(&whole_third()?, "a1"));
    Some(finding)
}

/// The exact a3 in a1 = ε to the seventh power.
fn whole_third() -> Option<Vec<Rational>> {
    let mut gauge = vec![Rational::from(0); 7];
    *gauge.first_mut()? = Rational::from(1);
    numbers(&Expansion::of_numbers(&gauge)?.harmonic(3))
}

/// A printed series that should agree with a computed one through a power.
pub(super) fn against_series(
    stands: &[Rational],
    computed: &[Rational],
    through: usize,
    name: &str,
    how: &str,
) -> Option<Finding> {
    let agrees_below = first_difference(stands, computed).map_or(stands.len(), |(power, _)| power);
    let correct = written(computed.get(..=through)?, name);
    let evidence = format!("{how}, exactly: {} + ...", written(computed, name));
    Some(Finding::verified_if(agrees_below > through, correct, evidence))
}

fn third_of_amplitude(printed: &Printed) -> Option<Finding> {
    let right_angle = Angle::from_degrees(90.0).ok()?;
    let approximate = decimal(printed.formula(0)?, &[("theta0", right_angle.radians())])?;
    let exact = *harmonics(&right_angle)?.get(1)?;
    let mut finding = in_amplitude(printed, 1, 3)?;
    finding.evidence += &format!(
        "; at 90 degrees {approximate:.6} against the exact {exact:.6}, {:.0} % low",
        100.0 * (1.0 - approximate / exact)
    );
    Some(finding)
}

fn fundamental_of_amplitude(printed: &Printed) -> Option<Finding> {
    in_amplitude(printed, 0, 3)
}

fn frequency_of_amplitude(printed: &Printed) -> Option<Finding> {
    in_amplitude(printed, 2, 2)
}

/// One of a1, a3, Δ against the solution of (22) to (24) in the amplitude.
fn in_amplitude(printed: &Printed, which: usize, through: usize) -> Option<Finding> {
    const TERMS: usize = 6;
    let stands = series_in("theta0", TERMS, printed.formula(0)?, &[])?;
    let computed = solution_in_amplitude(TERMS)?;
    let finding = against_series(
        &stands,
        computed.get(which)?,
        through,
        "theta0",
        "(22) to (24) solved in powers of theta0",
    )?;
    Some(finding)
}
