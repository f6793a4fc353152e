//! (B1) to (B4): why the harmonics contain only odd powers of ε.

use super::appendix_a::number;
use super::{statement, text_after};
use crate::paper::compare::{polynomial, same_polynomial};
use crate::paper::cosines::{cosine, cosines, projection, second_derivative};
use crate::paper::finding::{StatementFinding, StatementVerdict};
use crate::paper::lindstedt::Expansion;
use crate::paper::orders::{Clock, form, orders_of};
use crate::paper::printed::Printed;
use crate::paper::sine::sine;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Polynomial, Rational, Variable};

pub(super) const STATEMENTS: &[PrintedStatement] = &[
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
    text_after(
        "(B2)",
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
];

/// The Taylor coefficient by differentiation, compared with the series in ε, for a motion of the first two orders.
fn picking_an_order(printed: &Printed) -> Option<StatementFinding> {
    let epsilon = Variable::from("epsilon");
    let at = |n: u32| Polynomial::variable(format!("A{n}").as_str()) * cosine(1);
    let motion: Vec<Polynomial> =
        (0..6_u32).map(|n| if n == 1 || n == 2 { at(n) } else { Polynomial::zero() }).collect();
    let still = [vec![number(1)], vec![Polynomial::zero(); 5]].concat();
    let orders = orders_of(printed.formula(0)?, &motion, &still, Clock::Phase)?;
    let whole = (0..).zip(&motion).fold(Polynomial::zero(), |sum, (n, theta)| {
        sum + Polynomial::variable(epsilon.clone()).pow(n) * theta.clone()
    });
    let acceleration = second_derivative(&whole);
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
    let right = picked && sine.verdict == StatementVerdict::Verified;
    Some(StatementFinding::verified_if(right, sine.correct, evidence))
}

fn fundamental_with_even_powers(printed: &Printed) -> Option<StatementFinding> {
    let expansion = Expansion::every_gauge(5)?;
    form(printed.formula(0)?, &[], &expansion.harmonic(1), &expansion)
}

/// The equation at ε² with A2, B2, C2 undetermined and B1 = C1 = d1 = 0.
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

fn second_order(printed: &Printed) -> Option<StatementFinding> {
    let stands = polynomial(printed.formula(0)?, &cosines())?;
    let how =
        "the order epsilon^2 of the equation with A2, B2, C2 open, as a polynomial in cos(Omega*t), exactly";
    Some(same_polynomial(&stands, &at_second_order()?, how))
}

fn second_order_of_the_third(printed: &Printed) -> Option<StatementFinding> {
    let computed = projection(&at_second_order()?, 3);
    let how = "the projection of c2(0) on cos(3*Omega*t), exactly";
    Some(same_polynomial(&polynomial(printed.formula(0)?, &[])?, &computed, how))
}

fn even_orders(printed: &Printed) -> Option<StatementFinding> {
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
        "at epsilon^2 the factors on n = 1, 3, 5 are {}, {}, {}{}: for n = 1 the equation is 0 = 0 and A2 stays free (the appendix leaves \
         n = 1 out at first, its general statement does not); with \
         an A2 the equation for m = 4, n = 3 has other terms and B4 = {fourth}",
        computed(1, "A2")?,
        computed(3, "B2")?,
        computed(5, "C2")?,
        if agree { " as printed" } else { ", not as printed" }
    );
    let forced = !factor(1)?.is_zero() && agree;
    let correct = "for n = 1 the even A_m are a choice of gauge; for n >= 3 it holds for m = 2, and for m >= 4 where \
                   A2 = A4 = ... = 0";
    let finding = StatementFinding::verified_if(forced, correct, evidence);
    Some(if forced { finding } else { finding.restricted("for n = 1") })
}
