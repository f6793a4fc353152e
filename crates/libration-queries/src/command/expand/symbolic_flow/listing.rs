//! A slow flow with symbolic parameters to read.

use super::{Answer, Solution, Values};
use crate::output::number::{short, to_its_error};
use crate::output::series::wrapped;
use crate::output::table::write_text;
use std::io::{self, Write};

/// Lines are broken here.
const COLUMN: usize = 80;

pub(super) fn write(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let flow = &answer.flow;
    let letter = |meaning: &str| {
        flow.letters.iter().find(|(name, _)| *name == meaning).map_or("", |(_, letter)| letter.as_str())
    };
    let (amplitude, phase) = (letter("amplitude"), letter("phase"));
    answer.subject.write(out)?;
    write_text(out, "", &setting(answer))?;
    writeln!(out)?;
    line(out, &format!("d{amplitude}/dt = "), &flow.amplitude_rate)?;
    line(out, &format!("d{phase}/dt = "), &flow.phase_rate)?;
    line(out, &format!("{} = ", answer.subject.variable), &flow.displacement)?;
    if let Some(note) = flow.displacement_note {
        write_text(out, "", note)?;
    }
    writeln!(out, "\nsteady states:")?;
    write_steady(out, answer)?;
    answer.values.as_ref().map_or(Ok(()), |values| write_values(out, answer, values))
}

fn setting(answer: &Answer) -> String {
    let flow = &answer.flow;
    let small: Vec<String> =
        answer.small.iter().map(|(name, order)| format!("{name} of order {order}")).collect();
    let small = if small.is_empty() { "small amplitude".to_owned() } else { small.join(", ") };
    let natural = flow.letters.iter().find(|(name, _)| *name == "natural_frequency_value");
    let natural =
        natural.map_or(String::new(), |(_, square)| format!("; {} = {square}", flow.natural_frequency));
    let drive =
        flow.drive.iter().zip(&flow.drive_frequency).map(|(name, formula)| format!("; {name} = {formula}"));
    format!("slow flow to order {}: {small}{natural}{}", flow.order, drive.collect::<String>())
}

fn line(out: &mut dyn Write, name: &str, formula: &str) -> io::Result<()> {
    writeln!(out, "{}", wrapped(name, formula, COLUMN))
}

fn write_steady(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let steady = &answer.flow.steady_state;
    let formulas = [
        ("relation, zero: ", &steady.relation),
        ("backbone, sigma = ", &steady.backbone),
        ("peak amplitude = ", &steady.peak_amplitude),
        ("peak at sigma = ", &steady.peak_detuning),
        ("folds, zero: ", &steady.folds),
        ("critical drive = ", &steady.critical_drive),
        ("trace = ", &steady.trace),
        ("determinant = ", &steady.determinant),
    ];
    for (name, formula) in formulas {
        if let Some(formula) = formula {
            line(out, name, formula)?;
        }
    }
    steady.notes.iter().try_for_each(|note| write_text(out, "", note))
}

fn write_values(out: &mut dyn Write, answer: &Answer, values: &Values) -> io::Result<()> {
    const DIGITS: usize = 10;
    const FEW: usize = 2;
    let Some(solutions) = &values.solutions else { return Ok(()) };
    let at = match values.drive_frequency {
        Some(drive) => {
            format!(" at W = {}, sigma = {}", short(drive, DIGITS), short(values.detuning, DIGITS))
        }
        None => String::new(),
    };
    writeln!(out, "\nin numbers{at}:")?;
    if solutions.is_empty() {
        return writeln!(out, "no steady state");
    }
    let is_driven = answer.flow.resonance.is_some();
    for Solution { state, amplitude_error } in solutions {
        let written = |value: f64, error: Option<f64>| match error {
            Some(error) => to_its_error(value, error, DIGITS),
            None => short(value, FEW),
        };
        // An error of A is one of φ in units of A.
        let phase_error = amplitude_error.map(|error| error / state.amplitude);
        let phase =
            if is_driven { format!(", phi = {}", written(state.phase, phase_error)) } else { String::new() };
        let stability = if state.is_stable { "stable" } else { "unstable" };
        writeln!(out, "A = {}{phase}, {stability}", written(state.amplitude, *amplitude_error))?;
    }
    if solutions.iter().all(|it| it.amplitude_error.is_some()) {
        write_text(out, "", "errors are estimated by the next order, and digits beyond them left out")?;
    }
    Ok(())
}
