//! Black and Vel, appendices A, B and C: why some powers of ε are absent, and the third correction.

use super::compare::{polynomial, same_polynomial};
use super::cosines::{cosine, cosines, projection};
use super::fifth_order::{Clock, constants, form, orders_of, parameter_in_amplitude_to, period};
use super::finding::Finding;
use super::lindstedt::Expansion;
use super::printed::Printed;
use super::statement::{Document, Statement};
use super::truncated::sine;
use crate::algebra::{Polynomial, Rational, Variable};
use crate::expression::Expression;

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
        "(A1)",
        "Two harmonics in odd powers of epsilon.",
        &["theta = (epsilon*A1 + epsilon^3*A3)*c1 + (epsilon*B1 + epsilon^3*B3)*c3"],
        two_harmonics,
    ),
    statement(
        "(A2)",
        "The frequency in all powers of epsilon.",
        &["Omega = omega0*(1 + epsilon*d1 + epsilon^2*d2)"],
        frequency_with_odd_powers,
    ),
    statement(
        "(A3)",
        "What stands at epsilon^2, on cos(Omega*t): d1 must vanish.",
        &["-2*A1*d1*c1"],
        first_correction,
    ),
    statement(
        "text: d_n = 0 for every odd n",
        "Appendix A: the frequency has even powers of epsilon alone.",
        &["d3 = 0"],
        odd_corrections,
    ),
    statement(
        "(B1)",
        "The n-th derivative over n!, at epsilon = 0, picks what stands at epsilon^n.",
        &["theta'' + theta - theta^3/6 + theta^5/120"],
        picking_an_order,
    ),
    statement(
        "(B2)",
        "The fundamental in all powers of epsilon.",
        &["a1 = epsilon*A1 + epsilon^2*A2 + epsilon^3*A3 + epsilon^4*A4 + epsilon^5*A5"],
        fundamental_with_even_powers,
    ),
    statement(
        "text: c2(0) = (-16*B2*cos(3*Omega*t) - 48*C2*cos(5*Omega*t))/2",
        "What stands at epsilon^2 when B1 = C1 = 0.",
        &["(-16*B2*c3 - 48*C2*c5)/2"],
        second_order,
    ),
    statement(
        "(B3)",
        "Its projection on cos(3*Omega*t) is this, so B2 = 0.",
        &["-8*B2"],
        second_order_of_the_third,
    ),
    statement(
        "(B4)",
        "At even m the coefficient b of cos(n*Omega*t) obeys 0 = (this)*b and so vanishes, for every odd n.",
        &["1 - n^2"],
        even_orders,
    ),
    statement(
        "(C1)",
        "The equation of motion with the sine to its fourth term, with Delta = Omega/omega0.",
        &["0 = Delta^2*theta'' + theta - theta^3/6 + theta^5/120 - theta^7/5040"],
        equation_to_seventh,
    ),
    statement(
        "(C2)",
        "The solution to the seventh order in the gauge A1 = 1, A3 = A5 = A7 = 0 (D is the seventh harmonic).",
        &[
            "A1 = 1",
            "A3 = A5 = A7 = 0",
            "B1 = C1 = C3 = D1 = D3 = D5 = 0",
            "B3 = -1/192",
            "B5 = -1/4096",
            "B7 = -3/262144",
            "C5 = 1/20480",
            "C7 = 1/262144",
            "D7 = -1/1835008",
            "d2 = -1/16",
            "d4 = 1/1024",
            "d6 = -1/65536",
        ],
        solution_to_seventh,
    ),
    statement(
        "(C3)",
        "Epsilon in the amplitude to the seventh power.",
        &["A1 = 1", "epsilon = theta0 + theta0^3/192 + 17*theta0^5/61440 + 1487*theta0^7/82575360"],
        parameter_to_seventh,
    ),
    statement(
        "(C4)",
        "The frequency to epsilon^6.",
        &["Omega = omega0*(1 + epsilon^2*d2 + epsilon^4*d4 + epsilon^6*d6)"],
        frequency_to_sixth,
    ),
    statement(
        "(C5)",
        "The period, as (51).",
        &["T = T0/(1 - theta0^2/16 + theta0^4/3072 - 23*theta0^6/737280)"],
        period,
    ),
];

fn number(value: i64) -> Polynomial {
    Polynomial::constant(Rational::from(value))
}

fn two_harmonics(printed: &Printed) -> Option<Finding> {
    let expansion = Expansion::odd_gauge(3)?;
    let stands = polynomial(printed.formula(0)?, &cosines())?;
    let names: Vec<Variable> = stands.variables().into_iter().collect();
    let inserted = names.iter().fold(stands, |sum, name| match expansion.named(&name.to_string()) {
        Some(value) if value != Polynomial::variable(name.clone()) => sum.substitute(name, &value),
        _ => sum,
    });
    let epsilon = Polynomial::variable("epsilon");
    let expected = [1, 3].into_iter().fold(Polynomial::zero(), |sum, k| {
        let orders = (0..).zip(expansion.harmonic(k));
        orders.fold(sum, |sum, (n, coefficient)| sum + epsilon.pow(n) * coefficient * cosine(k))
    });
    let evidence = format!(
        "definition; consistent: the solution to epsilon^3 has this form with B1 = {}, B3 = {}",
        expansion.named("B1")?,
        expansion.named("B3")?
    );
    Some(Finding::verified_if(inserted == expected, expected.to_string(), evidence))
}

fn frequency_with_odd_powers(printed: &Printed) -> Option<Finding> {
    let printed_ratio = polynomial(printed.formula(0)?, &[("omega0", number(1))])?;
    let expansion = Expansion::every_gauge(3)?;
    let inserted = ["d1", "d2"].iter().try_fold(printed_ratio, |sum, name| {
        Some(sum.substitute(&Variable::from(*name), &expansion.named(name)?))
    })?;
    let epsilon = Polynomial::variable("epsilon");
    let computed =
        (0..).zip(expansion.frequency()?).fold(Polynomial::zero(), |sum, (n, d)| sum + epsilon.pow(n) * d);
    let evidence = format!(
        "definition; consistent: solved with every An open, d1 = {} and d2 = {}",
        expansion.named("d1")?,
        expansion.named("d2")?
    );
    Some(Finding::verified_if(inserted == computed, computed.to_string(), evidence))
}

/// (8) with (A1) and (A2) at ε².
fn first_correction(printed: &Printed) -> Option<Finding> {
    let motion = |k: u32, letter: &str, order: u32| {
        Polynomial::variable(format!("{letter}{order}").as_str()) * cosine(k)
    };
    let theta = [Polynomial::zero(), motion(1, "A", 1) + motion(3, "B", 1), Polynomial::zero()];
    let frequency = [number(1), Polynomial::variable("d1"), Polynomial::variable("d2")];
    let equation = Printed::read(&["theta'' + theta - theta^3/6"])?;
    let at_second = orders_of(equation.formula(0)?, &theta, &frequency, Clock::Time)?.get(2)?.clone();
    let computed = projection(&at_second, 1);
    let stands = projection(&polynomial(printed.formula(0)?, &cosines())?, 1);
    let how = format!(
        "(A1) and (A2) in (8) leave {at_second} at epsilon^2 (c is cos(Omega*t)), on cos(Omega*t) {computed}, so d1 = 0"
    );
    Some(same_polynomial(&stands, &computed, &how))
}

fn odd_corrections(printed: &Printed) -> Option<Finding> {
    let claimed = printed.number(0)?;
    let (every, odd) = (Expansion::every_gauge(5)?, Expansion::odd_gauge(6)?);
    let odd_vanish = ["d1", "d3", "d5"]
        .iter()
        .all(|name| odd.named(name).is_some_and(|d| d.to_constant() == Some(claimed.clone())));
    let evidence = format!(
        "with A2 = A4 = 0 it holds to d5, exactly; with every An open d1 = {}, d3 = {}, and B4 = {}: an A2 is the \
         change epsilon -> epsilon + (A2/A1)*epsilon^2 of the parameter, not of the motion",
        every.named("d1")?,
        every.named("d3")?,
        every.named("B4")?
    );
    let correct = "odd d_n can be removed by the gauge A2 = A4 = ... = 0, because theta0 -> -theta0 is the shift \
                   Omega*t -> Omega*t + pi; in other gauges they do not vanish";
    let finding = Finding::verified_if(odd_vanish, correct, evidence).with_correct(correct);
    Some(finding.restricted("in gauges with A2 = A4 = ... = 0"))
}

/// The Taylor coefficient by differentiation against the series in ε, for a motion of the first two orders.
fn picking_an_order(printed: &Printed) -> Option<Finding> {
    let epsilon = Variable::from("epsilon");
    let at = |n: u32| Polynomial::variable(format!("A{n}").as_str()) * cosine(1);
    let motion: Vec<Polynomial> =
        (0..6_u32).map(|n| if n == 1 || n == 2 { at(n) } else { Polynomial::zero() }).collect();
    let still = [vec![number(1)], vec![Polynomial::zero(); 5]].concat();
    let orders = orders_of(printed.formula(0)?, &motion, &still, Clock::Phase)?;
    let whole = (0..).zip(&motion).fold(Polynomial::zero(), |sum, (n, theta)| {
        sum + Polynomial::variable(epsilon.clone()).pow(n) * theta.clone()
    });
    let acceleration = super::cosines::second_derivative(&whole);
    let equation = polynomial(printed.formula(0)?, &[("theta", whole), ("theta''", acceleration)])?;
    let mut derivative = equation;
    let mut picked = true;
    for (n, at_order) in (1..).zip(orders.iter().skip(1)) {
        derivative = derivative.derivative(&epsilon).scaled(&Rational::new(1, n)?);
        picked &= derivative.coefficient(&epsilon, 0) == *at_order;
    }
    let sine = sine(printed.formula(0)?, 5)?;
    let evidence = format!(
        "for theta = (epsilon*A1 + epsilon^2*A2)*cos(Omega*t) it picks the orders 1 to 5 of the product expansion, \
         exactly; the sine to theta^5 is enough for them: {}",
        sine.evidence
    );
    let right = picked && sine.verdict == super::Verdict::Verified;
    Some(Finding::verified_if(right, sine.correct, evidence))
}

fn fundamental_with_even_powers(printed: &Printed) -> Option<Finding> {
    let expansion = Expansion::every_gauge(5)?;
    form(printed, &expansion.harmonic(1), &expansion, 5)
}

/// The equation at ε² with A2, B2, C2 open and B1 = C1 = d1 = 0.
fn at_second_order() -> Option<Polynomial> {
    let second = ["A2", "B2", "C2"]
        .iter()
        .zip(cosines())
        .fold(Polynomial::zero(), |sum, (name, (_, cosine))| sum + Polynomial::variable(*name) * cosine);
    let first = Polynomial::variable("A1") * cosine(1);
    let frequency = [number(1), Polynomial::zero(), Polynomial::variable("d2")];
    let equation = Printed::read(&["theta'' + theta - theta^3/6 + theta^5/120"])?;
    let orders =
        orders_of(equation.formula(0)?, &[Polynomial::zero(), first, second], &frequency, Clock::Time)?;
    orders.get(2).cloned()
}

fn second_order(printed: &Printed) -> Option<Finding> {
    let stands = polynomial(printed.formula(0)?, &cosines())?;
    let how =
        "the order epsilon^2 of the equation with A2, B2, C2 open, as a polynomial in cos(Omega*t), exactly";
    Some(same_polynomial(&stands, &at_second_order()?, how))
}

fn second_order_of_the_third(printed: &Printed) -> Option<Finding> {
    let computed = projection(&at_second_order()?, 3);
    let how = "the projection of c2(0) on cos(3*Omega*t), exactly";
    Some(same_polynomial(&polynomial(printed.formula(0)?, &[])?, &computed, how))
}

fn even_orders(printed: &Printed) -> Option<Finding> {
    let factor = |n: i64| polynomial(printed.formula(0)?, &[("n", number(n))])?.to_constant();
    let second = at_second_order()?;
    let computed =
        |n: u32, name: &str| projection(&second, n).coefficient(&Variable::from(name), 1).to_constant();
    let mut agree = true;
    for (n, name) in [(1, "A2"), (3, "B2"), (5, "C2")] {
        agree &= factor(i64::from(n)) == computed(n, name);
    }
    let fourth = Expansion::every_gauge(4)?.named("B4")?;
    let evidence = format!(
        "at epsilon^2 the factors on n = 1, 3, 5 are {}, {}, {}{}: for n = 1 the equation is 0 = 0 and A2 stays free; with \
         an A2 the equation for m = 4, n = 3 has other terms and B4 = {fourth}",
        computed(1, "A2")?,
        computed(3, "B2")?,
        computed(5, "C2")?,
        if agree { " as printed" } else { ", not as printed" }
    );
    let forced = factor(1).is_some_and(|at_one| !at_one.is_zero()) && agree;
    let correct = "for n = 1 the even A_m are a choice of gauge; for n >= 3 it holds for m = 2, and for m >= 4 where \
                   A2 = A4 = ... = 0";
    Some(Finding::verified_if(forced, correct, evidence))
}

/// With θ″ = d²θ/d(Ωt)² the solution satisfies it; with θ″ = d²θ/dt² it does not.
fn equation_to_seventh(printed: &Printed) -> Option<Finding> {
    let expansion = Expansion::odd_gauge(7)?;
    let frequency = expansion.frequency()?;
    let motion: Vec<Polynomial> = expansion.motion().iter().take(frequency.len()).cloned().collect();
    let in_phase = orders_of(printed.formula(0)?, &motion, &frequency, Clock::Phase)?;
    let in_time = orders_of(printed.formula(0)?, &motion, &frequency, Clock::Time)?;
    let solved = in_phase.iter().all(Polynomial::is_zero);
    let left = in_time.iter().position(|order| !order.is_zero());
    let leftover = left.map(|n| format!("{}*epsilon^{n}*cos(Omega*t)", projection(&in_time[n], 1)));
    let evidence = format!(
        "with the dots as d/d(Omega*t) the computed motion satisfies it to epsilon^{}, exactly{}; with the dots as d/dt \
         (omega0 = 1), as everywhere else in the document, {} is left",
        motion.len() - 1,
        if solved { "" } else { " (it does not)" },
        leftover.clone().unwrap_or_else(|| "nothing".to_owned())
    );
    if !solved {
        return Some(Finding::wrong("0 = Delta^2*theta'' + sin(theta) to theta^7", evidence));
    }
    Some(Finding::typo("the dots must be derivatives with respect to Omega*t here", evidence))
}

fn solution_to_seventh(printed: &Printed) -> Option<Finding> {
    constants(printed, 7)
}

fn parameter_to_seventh(printed: &Printed) -> Option<Finding> {
    parameter_in_amplitude_to(printed, 7)
}

fn frequency_to_sixth(printed: &Printed) -> Option<Finding> {
    let expansion = Expansion::odd_gauge(7)?;
    let ratio = polynomial(printed.formula(0)?, &[("omega0", number(1))])?;
    let inserted = ["d2", "d4", "d6"]
        .iter()
        .try_fold(ratio, |sum, name| Some(sum.substitute(&Variable::from(*name), &expansion.named(name)?)))?;
    let epsilon = Polynomial::variable("epsilon");
    let computed =
        (0..).zip(expansion.frequency()?).fold(Polynomial::zero(), |sum, (n, d)| sum + epsilon.pow(n) * d);
    let evidence = format!("definition; consistent: with any A1, A3, A5 d6 = {}", expansion.named("d6")?);
    Some(Finding::verified_if(inserted == computed, computed.to_string(), evidence))
}
