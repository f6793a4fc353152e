//! (32) to (37): three harmonics in powers of ε, and the freedom that remains in their equations.

use super::{statement, text_after};
use crate::paper::compare::polynomial;
use crate::paper::cosines::{cosines, projection};
use crate::paper::finding::StatementFinding;
use crate::paper::lindstedt::Expansion;
use crate::paper::orders::{Clock, form, orders_of};
use crate::paper::printed::Printed;
use crate::paper::sine::equation_with_sine;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Polynomial, Rational};
use libration::expression::Expression;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
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
    text_after(
        "(37)",
        "text: the freedom left is a choice for one of the coefficients",
        "How many constants the nine equations leave free.",
        &["free = 1", "theta'' + omega0^2*(theta - theta^3/6 + theta^5/120)"],
        free_constants,
    )
    .paraphrased(),
];

fn three_harmonics(printed: &Printed) -> Option<StatementFinding> {
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
    Some(StatementFinding::verified_if(names == ["a1", "a3", "a5"], "", evidence))
}

fn form_of_the_fundamental(printed: &Printed) -> Option<StatementFinding> {
    let expansion = Expansion::odd_gauge(5)?;
    form(printed.formula(0)?, &[], &expansion.harmonic(1), &expansion)
}

fn form_of_the_third(printed: &Printed) -> Option<StatementFinding> {
    let expansion = Expansion::odd_gauge(5)?;
    form(printed.formula(0)?, &[], &expansion.harmonic(3), &expansion)
}

fn form_of_the_fifth(printed: &Printed) -> Option<StatementFinding> {
    let expansion = Expansion::odd_gauge(5)?;
    form(printed.formula(0)?, &[], &expansion.harmonic(5), &expansion)
}

fn form_of_the_frequency(printed: &Printed) -> Option<StatementFinding> {
    let expansion = Expansion::odd_gauge(5)?;
    form(printed.formula(0)?, &[], &expansion.frequency()?, &expansion)
}

fn equation_to_fifth(printed: &Printed) -> Option<StatementFinding> {
    equation_with_sine(printed, 5)
}

/// The motion and the frequency of (32) to (36) with all constants undetermined, at each order in ε.
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

/// The nine equations: orders 1, 3, 5 of the equation of motion projected on harmonics 1, 3, 5.
fn nine_equations(equation: &Expression) -> Option<Vec<Polynomial>> {
    let (motion, frequency) = open_motion();
    let at = orders_of(equation, &motion, &frequency, Clock::Time)?;
    Some([1, 3, 5].into_iter().flat_map(|n| [1, 3, 5].map(|k| projection(&at[n], k))).collect())
}

fn free_constants(printed: &Printed) -> Option<StatementFinding> {
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
    Some(StatementFinding::verified_if(right, correct, evidence))
}
