//! (38), (46) and the gauge ε = θ0: the solution for chosen values of the free constants.

use super::{statement, text_after};
use crate::paper::compare::series_in;
use crate::paper::finding::StatementFinding;
use crate::paper::lindstedt::{Expansion, numbers};
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::Rational;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
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
    text_after(
        "(51)",
        "text: there is a gauge with epsilon = theta0",
        "Its constants can be found by demanding it.",
        &["epsilon = theta0"],
        amplitude_as_parameter,
    ),
];

/// The gauge stated by the assignments of A1, A2, …, with zero for the other constants, up to an order.
pub(super) fn gauge_of(assignments: &[(String, Rational)], order: u32) -> Vec<Rational> {
    let value = |n: u32| {
        let assignment = assignments.iter().find(|(name, _)| *name == format!("A{n}"));
        assignment.map_or(Rational::from(0), |(_, value)| value.clone())
    };
    (1..=order).map(value).collect()
}

/// Printed constants compared with those of the gauge that they state.
pub(super) fn constants(printed: &Printed, order: u32) -> Option<StatementFinding> {
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
    Some(StatementFinding::verified_if(wrong.is_empty(), wrong.join(", "), evidence))
}

fn solution_in_a_gauge(printed: &Printed) -> Option<StatementFinding> {
    constants(printed, 5)
}

fn solution_in_the_other_gauge(printed: &Printed) -> Option<StatementFinding> {
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

/// θ0(ε) = ε requires A1 = 1 and Aₙ = −(Bₙ + Cₙ), which are known from lower orders.
fn amplitude_as_parameter(printed: &Printed) -> Option<StatementFinding> {
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
    Some(StatementFinding::verified_if(exists, "", evidence))
}
