//! (C1) to (C5): the third correction.

use super::appendix_a::number;
use super::gauges::constants;
use super::in_amplitude::period;
use super::iteration::parameter_in_amplitude_to;
use super::statement;
use crate::paper::cosines::projection;
use crate::paper::finding::StatementFinding;
use crate::paper::lindstedt::Expansion;
use crate::paper::orders::{Clock, form, orders_of};
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::Polynomial;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
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

/// The solution satisfies the equation with θ″ = d²θ/d(Ωt)², but not with θ″ = d²θ/dt².
fn equation_to_seventh(printed: &Printed) -> Option<StatementFinding> {
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
        return Some(StatementFinding::wrong("0 = Delta^2*theta'' + sin(theta) to theta^7", evidence));
    }
    Some(StatementFinding::typo("the dots must be derivatives with respect to Omega*t here", evidence))
}

fn solution_to_seventh(printed: &Printed) -> Option<StatementFinding> {
    constants(printed, 7)
}

fn parameter_to_seventh(printed: &Printed) -> Option<StatementFinding> {
    parameter_in_amplitude_to(printed, 7)
}

fn frequency_to_sixth(printed: &Printed) -> Option<StatementFinding> {
    let expansion = Expansion::odd_gauge(7)?;
    form(printed.formula(0)?, &[("omega0", number(1))], &expansion.frequency()?, &expansion)
}
