//! Black and Vel, (32) to (51): three harmonics in powers of ε, the gauge, and the results in the amplitude.

use super::compare::{first_difference, polynomial, series_in};
use super::cosines::{cosines, projection, second_derivative};
use super::finding::Finding;
use super::lindstedt::{Expansion, numbers};
use super::power_series::PowerSeries;
use super::printed::Printed;
use super::statement::{Document, Statement};
use super::truncated::{against_series, equation_with_sine, written};
use crate::algebra::{Polynomial, Polynomials, Rational, Rationals, Ring};
use crate::expression::Expression;
use crate::series::truncated::{powers, powers_of_inverse};

const fn statement(
    label: &'static str,
    claim: &'static str,
    printed: &'static [&'static str],
    check: super::statement::Check,
) -> Statement {
    Statement { document: Document::BlackVel, label, claim, printed, check }
}

pub(super) const STATEMENTS: &[Statement] = &[
    statement("(32)", "A third harmonic is added.", &["theta = a1*c1 + a3*c3 + a5*c5"], three_harmonics),
    statement(
        "(33)",
        "The fundamental in odd powers of epsilon.",
        &["a1 = epsilon*A1 + epsilon^3*A3 + epsilon^5*A5"],
        form_of_the_fundamental,
    ),
    statement(
        "(34)",
        "The third harmonic in odd powers of epsilon.",
        &["a3 = epsilon*B1 + epsilon^3*B3 + epsilon^5*B5"],
        form_of_the_third,
    ),
    statement(
        "(35)",
        "The fifth harmonic in odd powers of epsilon.",
        &["a5 = epsilon*C1 + epsilon^3*C3 + epsilon^5*C5"],
        form_of_the_fifth,
    ),
    statement(
        "(36)",
        "The frequency in even powers of epsilon.",
        &["Delta = 1 + epsilon^2*d2 + epsilon^4*d4"],
        form_of_the_frequency,
    ),
    statement(
        "(37)",
        "The equation of motion with the sine to its third term.",
        &["theta'' + omega0^2*(theta - theta^3/6 + theta^5/120) = 0"],
        equation_to_fifth,
    ),
    statement(
        "text: the freedom left is a choice for one of the coefficients",
        "How many constants the nine equations leave free.",
        &["free = 1", "theta'' + omega0^2*(theta - theta^3/6 + theta^5/120)"],
        free_constants,
    ),
    statement(
        "(38)",
        "The solution in the gauge A1 = 1, A3 = A5 = 0.",
        &[
            "A1 = 1",
            "A3 = A5 = 0",
            "B1 = C1 = C3 = 0",
            "B3 = -1/192",
            "B5 = -1/4096",
            "C5 = 1/20480",
            "d2 = -1/16",
            "d4 = 1/1024",
        ],
        solution_in_a_gauge,
    ),
    statement(
        "(39)",
        "The amplitude in this gauge.",
        &["theta0 = epsilon - epsilon^3/192 - epsilon^5/5120"],
        amplitude_in_the_gauge,
    ),
    statement("(40)", "The amplitude is epsilon less a function F.", &["theta0 = epsilon - F"], split_off),
    statement("(41)", "This function.", &["F = z^3/192 + z^5/5120"], what_is_split_off),
    statement("(42)", "Solved for the epsilon that stands alone.", &["epsilon = theta0 + F"], turned_round),
    statement(
        "(43)",
        "The first approximation: F taken at theta0.",
        &["epsilon = theta0 + theta0^3/192 + theta0^5/5120"],
        first_iteration,
    ),
    statement(
        "(44)",
        "The second: F taken at the first.",
        &["epsilon = theta0 + F1^3/192 + F1^5/5120", "F1 = theta0 + theta0^3/192 + theta0^5/5120"],
        second_iteration,
    ),
    statement(
        "(45)",
        "Epsilon in the amplitude, in the gauge A1 = 1, A3 = A5 = 0.",
        &["A1 = 1", "A3 = A5 = 0", "epsilon = theta0 + theta0^3/192 + 17*theta0^5/61440"],
        parameter_in_amplitude,
    ),
    statement(
        "(46)",
        "The solution in another gauge.",
        &[
            "A1 = -A3 = 1",
            "A5 = 0",
            "B1 = C1 = C3 = 0",
            "B3 = -1/192",
            "B5 = 63/4096",
            "C5 = 1/20480",
            "d2 = -1/16",
            "d4 = 129/1024",
        ],
        solution_in_the_other_gauge,
    ),
    statement(
        "(47)",
        "Epsilon in the amplitude in this gauge.",
        &["A1 = -A3 = 1", "A5 = 0", "epsilon = theta0 + 193*theta0^3/192 + 185297*theta0^5/61440"],
        parameter_in_amplitude,
    ),
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
    statement(
        "text: there is a gauge with epsilon = theta0",
        "Its constants can be found by demanding it.",
        &["epsilon = theta0"],
        amplitude_as_parameter,
    ),
];

/// The coefficients of ε⁰, ε¹, … as one polynomial.
fn in_epsilon(coefficients: &[Polynomial]) -> Polynomial {
    let epsilon = Polynomial::variable("epsilon");
    let terms = (0..).zip(coefficients).map(|(n, coefficient)| epsilon.pow(n) * coefficient.clone());
    terms.fold(Polynomial::zero(), |sum, term| sum + term)
}

fn three_harmonics(printed: &Printed) -> Option<Finding> {
    let theta = polynomial(printed.formula(0)?, &cosines())?;
    let expansion = Expansion::odd_gauge(7)?;
    let first_order_of = |k: u32| expansion.harmonic(k).iter().position(|coefficient| !coefficient.is_zero());
    let names = [1, 3, 5].map(|k| projection(&theta, k).to_string());
    let evidence = format!(
        "definition; consistent: with any A1, A3, A5 the harmonics 3, 5 and 7 begin at epsilon^{}, epsilon^{} and \
         epsilon^{}, so that the seventh is not needed at the fifth order",
        first_order_of(3)?,
        first_order_of(5)?,
        first_order_of(7)?
    );
    Some(Finding::verified_if(names == ["a1", "a3", "a5"], "", evidence))
}

/// A printed form whose constants take their computed values against the solution with any odd gauge.
pub(super) fn form(
    printed: &Printed,
    computed: &[Polynomial],
    expansion: &Expansion,
    order: usize,
) -> Option<Finding> {
    let stands = polynomial(printed.formula(0)?, &[])?;
    let names = stands.variables().into_iter().filter(|name| name.to_string() != "epsilon");
    let known = names
        .map(|name| Some((name.clone(), expansion.named(&name.to_string())?)))
        .collect::<Option<Vec<_>>>()?;
    let inserted = known.iter().fold(stands, |sum, (name, value)| {
        if *value == Polynomial::variable(name.clone()) { sum } else { sum.substitute(name, value) }
    });
    let expected = in_epsilon(computed.get(..=order)?);
    let values = known.iter().map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>().join(", ");
    let evidence =
        format!("definition; consistent: the solution to epsilon^{order} has this form with {values}");
    Some(Finding::verified_if(inserted == expected, expected.to_string(), evidence))
}

fn form_of_the_fundamental(printed: &Printed) -> Option<Finding> {
    let expansion = Expansion::odd_gauge(5)?;
    form(printed, &expansion.harmonic(1), &expansion, 5)
}

fn form_of_the_third(printed: &Printed) -> Option<Finding> {
    let expansion = Expansion::odd_gauge(5)?;
    form(printed, &expansion.harmonic(3), &expansion, 5)
}

fn form_of_the_fifth(printed: &Printed) -> Option<Finding> {
    let expansion = Expansion::odd_gauge(5)?;
    form(printed, &expansion.harmonic(5), &expansion, 5)
}

fn form_of_the_frequency(printed: &Printed) -> Option<Finding> {
    let expansion = Expansion::odd_gauge(5)?;
    form(printed, &expansion.frequency()?, &expansion, 4)
}

fn equation_to_fifth(printed: &Printed) -> Option<Finding> {
    equation_with_sine(printed, 5)
}

/// The motion and the frequency of (32) to (36), every constant open, at each order in ε.
fn open_motion() -> (Vec<Polynomial>, Vec<Polynomial>) {
    let name = |letter: &str, order: u32| Polynomial::variable(format!("{letter}{order}").as_str());
    let at = |order: u32| {
        let harmonics = ["A", "B", "C"].iter().zip(cosines());
        harmonics.fold(Polynomial::zero(), |sum, (letter, (_, cosine))| sum + name(letter, order) * cosine)
    };
    let zero = Polynomial::zero;
    let motion = vec![zero(), at(1), zero(), at(3), zero(), at(5)];
    let one = Polynomial::constant(Rational::from(1));
    (motion, vec![one, zero(), name("d", 2), zero(), name("d", 4), zero()])
}

/// The nine equations: orders 1, 3, 5 of the equation of motion on the harmonics 1, 3, 5.
fn nine_equations(equation: &Expression) -> Option<Vec<Polynomial>> {
    let (motion, frequency) = open_motion();
    let at = orders_of(equation, &motion, &frequency, Clock::Time)?;
    Some([1, 3, 5].into_iter().flat_map(|n| [1, 3, 5].map(|k| projection(&at[n], k))).collect())
}

/// With respect to what the dots of an equation differentiate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Clock {
    /// The time t, in units of 1/ω0.
    Time,
    /// The phase Ωt.
    Phase,
}

/// An equation of motion at each order in ε, the motion and Ω/ω0 being given so and ω0 = 1.
pub(super) fn orders_of(
    equation: &Expression,
    motion: &[Polynomial],
    frequency: &[Polynomial],
    clock: Clock,
) -> Option<Vec<Polynomial>> {
    let ring = PowerSeries { coefficients: Polynomials, terms: motion.len() };
    let inertia: Vec<Polynomial> = motion.iter().map(second_derivative).collect();
    let frequency = frequency.to_vec();
    let acceleration = match clock {
        Clock::Time => ring.multiply(&ring.multiply(&frequency, &frequency), &inertia),
        Clock::Phase => inertia,
    };
    super::evaluate::value(&ring, equation, &|name| match name {
        "theta" => Some(motion.to_vec()),
        "theta''" => Some(acceleration.clone()),
        "omega0" => ring.rational(&Rational::from(1)),
        "Delta" => Some(frequency.clone()),
        _ => None,
    })
}

fn free_constants(printed: &Printed) -> Option<Finding> {
    let equations = nine_equations(printed.formula(1)?)?;
    let trivial = equations.iter().filter(|equation| equation.is_zero()).count();
    let (motion, frequency) = open_motion();
    let unknowns = motion.iter().chain(&frequency).flat_map(Polynomial::variables);
    let unknowns: std::collections::BTreeSet<String> =
        unknowns.map(|name| name.to_string()).filter(|name| name != "c").collect();
    let general = Expansion::odd_gauge(5)?;
    let solution = |equation: &Polynomial| {
        equation.variables().into_iter().fold(equation.clone(), |sum, name| {
            let value =
                general.named(&name.to_string()).unwrap_or_else(|| Polynomial::variable(name.clone()));
            if value == Polynomial::variable(name.clone()) { sum } else { sum.substitute(&name, &value) }
        })
    };
    let solved = equations.iter().all(|equation| solution(equation).is_zero());
    let free = unknowns
        .iter()
        .filter(|name| general.named(name) == Some(Polynomial::variable(name.as_str())))
        .count();
    let constants =
        ["d2", "B3", "d4", "B5", "C5"].map(|name| Some(format!("{name} = {}", general.named(name)?)));
    let constants = constants.into_iter().collect::<Option<Vec<_>>>()?.join(", ");
    let evidence = format!(
        "{} unknowns, {} equations, of which {trivial} (cos(Omega*t) at epsilon^1) is 0 = 0; B1 = C1 = C3 = 0, {constants} \
         satisfies all of them{} with A1, A3, A5 open",
        unknowns.len(),
        equations.len(),
        if solved { ", exactly," } else { " (not)" }
    );
    let right = printed.number(0)? == Rational::from(i64::try_from(free).ok()?) && solved;
    let correct =
        format!("{free} constants are free, A1, A3 and A5: the choice is of all {free} (as is then done)");
    Some(Finding::verified_if(right, correct, evidence))
}

/// The gauge that the assignments of A1, A2, … name, the other constants zero, to an order.
pub(super) fn gauge_of(assignments: &[(String, Rational)], order: u32) -> Vec<Rational> {
    let value = |n: u32| {
        let known = assignments.iter().find(|(name, _)| *name == format!("A{n}"));
        known.map_or(Rational::from(0), |(_, value)| value.clone())
    };
    (1..=order).map(value).collect()
}

/// Printed constants against those of the gauge named among them.
pub(super) fn constants(printed: &Printed, order: u32) -> Option<Finding> {
    let assignments = printed.assignments()?;
    let gauge = gauge_of(&assignments, order);
    let expansion = Expansion::of_numbers(&gauge)?;
    let mut wrong = Vec::new();
    let mut shown = Vec::new();
    for (name, value) in assignments.iter().filter(|(name, _)| !name.starts_with('A')) {
        let computed = expansion.named(name)?.to_constant()?;
        shown.push(format!("{name} = {computed}"));
        if computed != *value {
            wrong.push(format!("{name} = {computed}"));
        }
    }
    let gauge = gauge.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    let evidence =
        format!("the orders solved in turn with A1, A2, ... = {gauge}, exactly: {}", shown.join(", "));
    Some(Finding::verified_if(wrong.is_empty(), wrong.join(", "), evidence))
}

fn solution_in_a_gauge(printed: &Printed) -> Option<Finding> {
    constants(printed, 5)
}

fn solution_in_the_other_gauge(printed: &Printed) -> Option<Finding> {
    let mut finding = constants(printed, 5)?;
    let one = Rational::from(1);
    let zero = Rational::from(0);
    let other = Expansion::of_numbers(&[one.clone(), zero.clone(), one, zero.clone(), zero])?;
    let value = |name: &str| other.named(name)?.to_constant();
    finding.evidence += &format!(
        "; so A1 = 1 and A3 = -1 are meant: A3 = +1 would give B5 = {}, d4 = {}",
        value("B5")?,
        value("d4")?
    );
    Some(finding)
}

/// θ0 in ε for A1 = 1 and no other constant, to an order.
pub(super) fn amplitude_of_fundamental(order: usize) -> Option<Vec<Rational>> {
    let mut gauge = vec![Rational::from(0); order];
    *gauge.first_mut()? = Rational::from(1);
    numbers(&Expansion::of_numbers(&gauge)?.amplitude())
}

fn amplitude_in_the_gauge(printed: &Printed) -> Option<Finding> {
    let stands = series_in("epsilon", 6, printed.formula(0)?, &[])?;
    against_series(
        &stands,
        &amplitude_of_fundamental(5)?,
        5,
        "epsilon",
        "the sum of the harmonics at Omega*t = 0",
    )
}

/// F = ε − θ0(ε).
fn split(order: usize) -> Option<Polynomial> {
    let amplitude: Vec<Polynomial> =
        amplitude_of_fundamental(order)?.into_iter().map(Polynomial::constant).collect();
    Some(Polynomial::variable("epsilon") - in_epsilon(&amplitude))
}

fn split_off(printed: &Printed) -> Option<Finding> {
    let stands = polynomial(printed.formula(0)?, &[("F", split(5)?)])?;
    let right = stands == Polynomial::variable("epsilon") - split(5)?;
    Some(Finding::verified_if(
        right,
        "",
        format!("definition; F = {}, from the computed amplitude", split(5)?),
    ))
}

fn what_is_split_off(printed: &Printed) -> Option<Finding> {
    let stands = polynomial(printed.formula(0)?, &[("z", Polynomial::variable("epsilon"))])?;
    let computed = split(5)?;
    let evidence = format!("epsilon less the computed amplitude, exactly: {computed}");
    Some(Finding::verified_if(stands == computed, format!("F(epsilon) = {computed}"), evidence))
}

fn turned_round(printed: &Printed) -> Option<Finding> {
    let theta0 = Polynomial::variable("epsilon") - split(5)?;
    let stands = polynomial(printed.formula(0)?, &[("F", split(5)?), ("theta0", theta0)])?;
    let right = stands == Polynomial::variable("epsilon");
    Some(Finding::verified_if(
        right,
        "",
        "with F(epsilon) and theta0(epsilon) as computed both sides are epsilon, exactly",
    ))
}

/// The inverse of y = x + ….
pub(super) fn inverse(series: &[Rational]) -> Option<Vec<Rational>> {
    powers_of_inverse(&Rationals, series).map(|powers| powers.first())
}

fn first_iteration(printed: &Printed) -> Option<Finding> {
    let stands = series_in("theta0", 8, printed.formula(0)?, &[])?;
    iteration(&stands, 3)
}

fn second_iteration(printed: &Printed) -> Option<Finding> {
    let ring = PowerSeries::rational(8);
    let first = series_in("theta0", 8, printed.formula(1)?, &[])?;
    let stands = super::evaluate::value(&ring, printed.formula(0)?, &|name| match name {
        "theta0" => ring.variable(),
        "F1" => Some(first.clone()),
        _ => None,
    })?;
    iteration(&stands, 5)
}

fn iteration(stands: &[Rational], through: usize) -> Option<Finding> {
    let mut amplitude = amplitude_of_fundamental(5)?;
    amplitude.resize(8, Rational::from(0));
    let exact = inverse(&amplitude)?;
    let (power, _) = first_difference(stands, &exact)?;
    let evidence = format!(
        "against the exact inverse of (39) it is right below theta0^{power}, where it has {} instead of {}",
        stands[power], exact[power]
    );
    Some(
        Finding::verified_if(power > through, written(&exact[..=through], "theta0"), evidence)
            .restricted(format!("to theta0^{through}")),
    )
}

/// ε in θ0 in the gauge that stands first.
pub(super) fn parameter_in_amplitude_to(printed: &Printed, order: u32) -> Option<Finding> {
    let assignments: Vec<(String, Rational)> = printed.gauge();
    let expansion = Expansion::of_numbers(&gauge_of(&assignments, order))?;
    let exact = inverse(&numbers(&expansion.amplitude())?)?;
    let stands = series_in("theta0", exact.len(), printed.last()?, &[])?;
    against_series(
        &stands,
        &exact,
        usize::try_from(order).ok()?,
        "theta0",
        "the amplitude in this gauge reverted",
    )
}

fn parameter_in_amplitude(printed: &Printed) -> Option<Finding> {
    parameter_in_amplitude_to(printed, 5)
}

/// A quantity as printed in θ0 against the same in ε: with θ0(ε) inserted they must agree whatever the gauge.
fn in_every_gauge(stands: &[Rational], computed: &[Polynomial], amplitude: &[Polynomial]) -> bool {
    let stands: Vec<Polynomial> = stands.iter().cloned().map(Polynomial::constant).collect();
    let inserted = powers(&Polynomials, amplitude).map(|powers| powers.composed(&Polynomials, &stands));
    inserted.is_some_and(|inserted| inserted.iter().zip(computed).all(|(a, b)| a == b))
}

fn fundamental(printed: &Printed) -> Option<Finding> {
    harmonic_in_amplitude(printed, 1)
}

fn third_harmonic(printed: &Printed) -> Option<Finding> {
    harmonic_in_amplitude(printed, 3)
}

fn fifth_harmonic(printed: &Printed) -> Option<Finding> {
    harmonic_in_amplitude(printed, 5)
}

fn harmonic_in_amplitude(printed: &Printed, k: u32) -> Option<Finding> {
    let expansion = Expansion::odd_gauge(5)?;
    let stands = series_in("theta0", 6, printed.formula(0)?, &[])?;
    let right = in_every_gauge(&stands, &expansion.harmonic(k), &expansion.amplitude());
    let exact = compose_with_inverse(k)?;
    let evidence = format!(
        "with theta0(epsilon) inserted it equals the harmonic to epsilon^5 for every A1, A3, A5, exactly; in the \
         gauge A1 = 1 the series is {}",
        written(&exact, "theta0")
    );
    Some(Finding::verified_if(right, written(&exact[..6], "theta0"), evidence))
}

/// The k-th harmonic in θ0 to the seventh power.
fn compose_with_inverse(k: u32) -> Option<Vec<Rational>> {
    let mut gauge = vec![Rational::from(0); 7];
    *gauge.first_mut()? = Rational::from(1);
    let expansion = Expansion::of_numbers(&gauge)?;
    let inverse = powers_of_inverse(&Rationals, &numbers(&expansion.amplitude())?)?;
    Some(inverse.composed(&Rationals, &numbers(&expansion.harmonic(k))?))
}

pub(super) fn period(printed: &Printed) -> Option<Finding> {
    const TERMS: usize = 7;
    let ring = PowerSeries::rational(TERMS);
    let ratio = series_in("theta0", TERMS, printed.formula(0)?, &[("T0", 1)])?;
    let frequency = ring.divide(&ring.rational(&Rational::from(1))?, &ratio)?;
    let expansion = Expansion::odd_gauge(7)?;
    let right = in_every_gauge(&frequency, &expansion.frequency()?, expansion.amplitude().get(..TERMS)?);
    let exact = super::exact::agreement(printed.formula(0)?, 6)?;
    let next = crate::period_formulas::frequency_in_amplitude(4).pop()?;
    let evidence = format!(
        "with theta0(epsilon) inserted Omega/omega0 agrees to epsilon^6 for every A1, A3, A5, exactly; {}; the next \
         term of Omega/omega0 is {next}*theta0^8",
        exact.evidence
    );
    let correct = written(&super::exact::frequency_series(TERMS), "theta0");
    let both = right && exact.verdict == super::Verdict::Verified;
    Some(Finding::verified_if(both, format!("T = T0/({correct})"), evidence))
}

/// θ0(ε) = ε demands A1 = 1 and Aₙ = −(Bₙ + Cₙ), which are known from the orders below.
fn amplitude_as_parameter(printed: &Printed) -> Option<Finding> {
    let demanded = series_in("epsilon", 6, printed.left(0)?, &[])?;
    let mut gauge = demanded.get(1..)?.to_vec();
    for order in 1..gauge.len() {
        let amplitude = numbers(&Expansion::of_numbers(&gauge)?.amplitude())?;
        let excess = amplitude[order + 1].clone() - demanded[order + 1].clone();
        gauge[order] = gauge[order].clone() - excess;
    }
    let expansion = Expansion::of_numbers(&gauge)?;
    let exists = numbers(&expansion.amplitude())?.iter().zip(&demanded).all(|(a, b)| a == b);
    let value = |name: &str| expansion.named(name)?.to_constant();
    let evidence = format!(
        "demanding it order by order gives A1 = {}, A3 = {}, A5 = {}, then B5 = {}, d4 = {}, exactly",
        gauge[0],
        gauge[2],
        gauge[4],
        value("B5")?,
        value("d4")?
    );
    Some(Finding::verified_if(exists, "", evidence))
}
