//! The series in numbers, to read.

use super::super::listing::{self, Symbols, letter_of};
use super::{NOT_REACHED, Numbers, Quotient, fields};
use crate::call::in_words;
use crate::output::number::{at_most, rounded, short, to_its_error};
use crate::output::series::{subscript, superscript};
use crate::output::table::{Table, sheet, write_text};
use libration::algebra::Rational;
use libration::comparison::{CycleDistance, Method, Radius, SeriesQuantity};
use libration::perturbation::{Certainty, PartialSum, SeriesEvaluation};
use std::io::{self, Write};

pub(super) fn write(out: &mut dyn Write, numbers: &Numbers<'_>) -> io::Result<()> {
    listing::write_head(out, numbers.answer)?;
    write_text(out, "", &subject(numbers))?;
    writeln!(out)?;
    write_steps(out, numbers)?;
    writeln!(out)?;
    sheet(out, &summary(numbers))?;
    match numbers.pade.as_deref() {
        None | Some([]) => Ok(()),
        Some(pade) => {
            writeln!(out)?;
            write_pade(out, numbers, pade)
        }
    }
}

fn symbol(numbers: &Numbers<'_>) -> String {
    let answer = &numbers.answer;
    if answer.expansion.variable.is_strength() { Symbols::new(answer).variable } else { answer.symbol("A") }
}

fn name(quantity: SeriesQuantity, letter: &str) -> String {
    match quantity {
        SeriesQuantity::Period => "T/T0".to_owned(),
        SeriesQuantity::Frequency => "Ω/ω0".to_owned(),
        SeriesQuantity::Cosine(k) => format!("{letter}{}", subscript(k)),
    }
}

/// The quantity of the table, and the amplitude.
fn subject(numbers: &Numbers<'_>) -> String {
    let symbol = symbol(numbers);
    let position = if numbers.answer.expansion.variable.is_strength() {
        format!("at {symbol} = {}", short(numbers.amplitude, 12))
    } else {
        format!("at the amplitude {symbol} = {}", in_units(numbers, numbers.amplitude, 10))
    };
    let unit = &numbers.answer.expansion.unit_squared;
    let units = match numbers.relation.quantity() {
        SeriesQuantity::Cosine(_) if *unit != Rational::from(1) => format!(", in units of √({unit})"),
        _ => String::new(),
    };
    format!(
        "{} by powers of {symbol}{units}, {position}",
        name(numbers.relation.quantity(), letter_of(&numbers.answer.expansion))
    )
}

/// An amplitude in radians, with degrees if it is an angle.
fn in_units(numbers: &Numbers<'_>, amplitude: f64, digits: usize) -> String {
    if numbers.answer.is_angle && !numbers.answer.expansion.variable.is_strength() {
        let degrees = amplitude.to_degrees();
        return format!("{} rad = {}°", short(amplitude, digits), short(degrees, digits));
    }
    short(amplitude, digits)
}

fn write_steps(out: &mut dyn Write, numbers: &Numbers<'_>) -> io::Result<()> {
    let evaluation = &numbers.evaluation;
    let bound = match evaluation.steps().first().map(|step| step.remainder.certainty) {
        Some(Certainty::Proven) => "below (proven)",
        _ => "about (estimate)",
    };
    let fields = fields::of_term();
    let mut table = Table::new(fields.columns_for(bound));
    numbers.terms().iter().try_for_each(|term| table.row(out, fields.cells(term)))?;
    table.finish(out)
}

fn summary(numbers: &Numbers<'_>) -> Vec<(&'static str, String)> {
    let mut lines = vec![("exact value", exact(numbers))];
    lines.extend(numbers.other_family().map(|told| ("but", told)));
    if let Some(distance) = numbers.orbit_distance() {
        lines.push(("distance", orbit_distance(distance)));
    }
    lines.extend(numbers.without_orbit().map(|told| ("warning", told)));
    lines.push(("convergence", convergence(numbers)));
    if let Some(smallest) = numbers.evaluation.smallest_term() {
        lines.push(("smallest term", after(numbers, smallest)));
    }
    lines.push(("terms needed", needed(&numbers.evaluation, numbers.needed())));
    lines
}

fn exact(numbers: &Numbers<'_>) -> String {
    match &numbers.exact {
        Some(Ok(exact)) => {
            let method = match exact.method {
                Method::Elliptic => "by elliptic integrals",
                Method::Integration => "by integrating the equation of motion",
            };
            let value = to_its_error(exact.value, exact.uncertainty, 16);
            format!("{value}, error below {}, {method}", at_most(exact.uncertainty))
        }
        Some(Err(reason)) => format!("none: {reason}"),
        None => NOT_REACHED.to_owned(),
    }
}

fn orbit_distance(distance_to_orbit: &CycleDistance) -> String {
    let distance = match distance_to_orbit.distance > distance_to_orbit.uncertainty {
        true => short(distance_to_orbit.distance, 3),
        false => format!("below {}", at_most(distance_to_orbit.uncertainty)),
    };
    format!(
        "{distance}, of the displacement from that of the orbit to which Newton's method converges from the series"
    )
}

fn convergence(numbers: &Numbers<'_>) -> String {
    let symbol = symbol(numbers);
    let Some(radius) = numbers.radius else { return NOT_REACHED.to_owned() };
    match radius {
        None => in_words("too few terms to estimate a radius: give a larger <--order>"),
        Some(Radius::Known(radius)) => {
            let inside = numbers.amplitude.abs() < radius;
            let verdict = if inside { "this amplitude is inside" } else { "this amplitude is BEYOND it" };
            format!("for {symbol} below {} (proven); {verdict}", in_units(numbers, radius, 10))
        }
        Some(Radius::Estimated(radii)) if radii.at_most.is_infinite() => {
            format!(
                "for {symbol} below {} at least, perhaps everywhere (estimated)",
                short(radii.at_least, 3)
            )
        }
        Some(Radius::Estimated(radii)) => {
            let (low, high) = (short(radii.at_least, 4), short(radii.at_most, 4));
            let verdict = match numbers.amplitude.abs() {
                inside if inside < radii.at_least => "this amplitude is inside",
                beyond if beyond > radii.at_most => "this amplitude is BEYOND it",
                _ => "this amplitude is too close to tell",
            };
            let radius = in_units(numbers, radii.radius, 4);
            format!("for {symbol} below about {radius} (estimated, between {low} and {high}); {verdict}")
        }
    }
}

/// The power at which the series is at its best when its terms grow.
fn after(numbers: &Numbers<'_>, smallest: &PartialSum) -> String {
    let error = match numbers.error(smallest.sum) {
        Some(error) => format!("; the error there is {}", rounded(error, 2)),
        None => String::new(),
    };
    format!("{}{}: beyond it the terms grow{error}", symbol(numbers), superscript(smallest.power))
}

fn needed(evaluation: &SeriesEvaluation, counts: impl Iterator<Item = (f64, Option<usize>)>) -> String {
    let terms = evaluation.steps().len().saturating_sub(1);
    let mut counted = vec![];
    for (tolerance, count) in counts {
        let Some(count) = count else {
            counted.push(format!("more than {terms} for {tolerance:.0e}"));
            break;
        };
        counted.push(format!("{count} for {tolerance:.0e}"));
    }
    format!("beyond the first: {}", counted.join(", "))
}

fn write_pade(out: &mut dyn Write, numbers: &Numbers<'_>, pade: &[Quotient]) -> io::Result<()> {
    let last = pade.last().map_or(0, |last| last.degree);
    let mut approximants = numbers.approximants(pade);
    approximants.retain(|approximant| {
        approximant.quotient.degree.is_power_of_two() || approximant.quotient.degree == last
    });
    fields::of_approximant().write_table(out, &approximants)
}
