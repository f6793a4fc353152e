//! A slow flow with symbolic parameters to read.

use super::{FlowValues, SymbolicFlowResult, why_left_out};
use crate::call::in_words;
use crate::output::number::{short, to_its_error};
use crate::output::series::wrapped;
use crate::output::table::write_text;
use libration::expression::{Expression, Symbol};
use libration::perturbation::{JudgedState, StateLeftOut, SteadySolution};
use std::io::{self, Write};

/// Lines are broken here.
const COLUMN: usize = 80;

pub(super) fn write(out: &mut dyn Write, answer: &SymbolicFlowResult) -> io::Result<()> {
    let flow = &answer.flow;
    let letter = |meaning: &str| {
        flow.letters.iter().find(|(name, _)| *name == meaning).map_or("", |(_, letter)| letter.as_str())
    };
    let (amplitude, phase) = (letter("amplitude"), letter("phase"));
    answer.subject.write(out)?;
    write_text(out, "", &setting(answer))?;
    if let Some(note) = &flow.order_note {
        write_text(out, "", note)?;
    }
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

fn setting(answer: &SymbolicFlowResult) -> String {
    let flow = &answer.flow;
    let small: Vec<String> =
        answer.small.iter().map(|(name, order)| format!("{name} of order {order}")).collect();
    let small = if small.is_empty() { "small amplitude".to_owned() } else { small.join(", ") };
    let natural = flow.letters.iter().find(|(name, _)| *name == "natural_frequency_value");
    let natural =
        natural.map_or(String::new(), |(_, square)| format!("; {} = {square}", flow.natural_frequency));
    let drive = flow.drive.iter().zip(&flow.drive_frequency).map(|(frequency, formula)| {
        let symbols = formula.parse::<Expression>().map(|formula| formula.symbols()).unwrap_or_default();
        let is_open = frequency.starts_with(|first: char| first.is_alphabetic())
            && symbols.iter().all(|symbol| symbol.name != *frequency);
        if is_exact(frequency, formula) {
            return format!("; sigma = 0 for the frequency of the drive, {frequency}");
        }
        let name = if is_open { "" } else { "frequency of the drive, which gives sigma: " };
        format!("; {name}{frequency} = {formula}")
    });
    let about = match flow.equilibrium.as_str() {
        "0" => String::new(),
        equilibrium => format!(" about {} = {equilibrium}", answer.subject.variable),
    };
    format!("slow flow{about} to order {}: {small}{natural}{}", flow.order, drive.collect::<String>())
}

/// Returns `true` if a frequency of the drive is its formula without detuning.
fn is_exact(frequency: &str, formula: &str) -> bool {
    let [Ok(frequency), Ok(formula)] = [frequency, formula].map(str::parse::<Expression>) else {
        return false;
    };
    let tuned = formula.substitute(&Symbol::plain("sigma"), &Expression::Number(0.into()));
    Expression::Subtract(Box::new(frequency), Box::new(tuned)).vanishes()
}

fn line(out: &mut dyn Write, name: &str, formula: &str) -> io::Result<()> {
    writeln!(out, "{}", wrapped(name, formula, COLUMN))
}

fn write_steady(out: &mut dyn Write, answer: &SymbolicFlowResult) -> io::Result<()> {
    let steady = &answer.flow.steady_state;
    let drive = steady
        .drive_amplitude
        .as_ref()
        .filter(|text| text.contains(|letter: char| !letter.is_alphanumeric()));
    let critical = drive.map_or("critical drive = ".to_owned(), |drive| format!("critical drive {drive} = "));
    let formulas = [
        ("limit cycle, A = ", &steady.cycle_amplitude),
        ("limit cycle, frequency = ", &steady.cycle_frequency),
        ("relation, zero: ", &steady.relation),
        ("backbone, sigma = ", &steady.backbone),
        ("peak amplitude = ", &steady.peak_amplitude),
        ("peak at sigma = ", &steady.peak_detuning),
        ("folds, zero: ", &steady.folds),
        (&critical, &steady.critical_drive),
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

/// Maximum number of digits.
const DIGITS: usize = 10;

fn write_values(out: &mut dyn Write, answer: &SymbolicFlowResult, values: &FlowValues) -> io::Result<()> {
    let Some(states) = &values.states else { return Ok(()) };
    let at = match values.drive_frequency {
        Some(drive) => {
            format!(" at W = {}, sigma = {}", short(drive, DIGITS), short(values.detuning, DIGITS))
        }
        None => String::new(),
    };
    writeln!(out, "\nin numbers{at}:")?;
    let is_driven = answer.flow.resonance.is_some();
    match (states.found.is_empty(), states.left_out.is_empty()) {
        (true, true) => writeln!(out, "no steady state")?,
        (true, false) => writeln!(out, "no steady state within reach of the series")?,
        _ => states.found.iter().try_for_each(|state| write_state(out, state, is_driven))?,
    }
    write_notes(out, &states.found)?;
    states.left_out.iter().try_for_each(|omission| write_left_out(out, omission, answer))?;
    if states.left_out.is_empty() {
        return Ok(());
    }
    write_text(
        out,
        "",
        &in_words("<libration orbit> with <--initial> finds periodic motions without a series"),
    )
}

fn write_state(out: &mut dyn Write, judged: &JudgedState, is_driven: bool) -> io::Result<()> {
    let stability = match judged.is_stable {
        Some(true) => "stable",
        Some(false) => "unstable",
        None => "stability undetermined",
    };
    writeln!(out, "{}, {stability}", state_text(&judged.state, judged.errors, is_driven))
}

fn state_text(state: &SteadySolution, errors: Option<[f64; 2]>, is_driven: bool) -> String {
    const FEW: usize = 2;
    let written = |value: f64, error: Option<f64>| match error {
        Some(error) => to_its_error(value, error, DIGITS),
        None => short(value, FEW),
    };
    let amplitude = written(state.amplitude, errors.map(|error| error[0]));
    let phase = written(state.phase, errors.map(|error| error[1]));
    if is_driven { format!("A = {amplitude}, phi = {phase}") } else { format!("A = {amplitude}") }
}

fn write_notes(out: &mut dyn Write, states: &[JudgedState]) -> io::Result<()> {
    let is_known = |state: &JudgedState| state.errors.is_some();
    if states.iter().any(is_known) {
        write_text(out, "", "errors are estimated by the next order, and digits beyond them left out")?;
    }
    if !states.iter().all(is_known) {
        let note = "numbers of two digits have an error that is not known: no next order has this state";
        write_text(out, "", note)?;
    }
    if states.iter().any(|state| state.is_stable.is_none()) {
        let note = "stability is undetermined where two orders disagree, where only one of several has the state, and where the \
                    trace is zero";
        write_text(out, "", note)?;
    }
    Ok(())
}

fn write_left_out(out: &mut dyn Write, left: &StateLeftOut, answer: &SymbolicFlowResult) -> io::Result<()> {
    let position = state_text(&left.state, None, answer.flow.resonance.is_some());
    write_text(out, "", &format!("left out: {position} (order {}): {}", left.order, why_left_out(left)))
}
