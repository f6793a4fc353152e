//! The modes as text, JSON and CSV.

use super::ModesResult;
use super::fields::{self, NumberedMode, exact_frequency};
use crate::output::number::{exact, rounded, short, to_its_error};
use crate::output::table::{paragraph, sheet};
use crate::output::{csv, json};
use libration::algebra::{Complex, Surd};
use libration::normal_modes::{Behaviour, Mode, Resonance};
use std::f64::consts::TAU;
use std::io::{self, Write};

/// Width at which lines are broken, in columns.
const COLUMNS: usize = 120;

pub(super) fn json(out: &mut dyn Write, answer: &ModesResult) -> io::Result<()> {
    let (of_mode, of_shift) = (fields::of_mode(), fields::of_shift());
    let modes = answer.numbered().map(|mode| of_shift.added_to(of_mode.record(&mode), &mode));
    json::document_with_list(out, fields::of_equilibrium().record(answer), "modes", modes)
}

pub(super) fn csv(out: &mut dyn Write, answer: &ModesResult) -> io::Result<()> {
    let (of_mode, of_shift) = (fields::of_mode(), fields::of_shift());
    let parts = answer.modes.variables.iter().map(|name| format!("shape_{name}")).collect();
    csv::line(out, &[of_mode.csv_names(), parts, of_shift.csv_names()].concat())?;
    for mode in answer.numbered() {
        let parts = mode.mode.shape.iter().map(|part| exact(part.re)).collect();
        csv::line(out, &[of_mode.csv_cells(&mode), parts, of_shift.csv_cells(&mode)].concat())?;
    }
    Ok(())
}

pub(super) fn sheets(out: &mut dyn Write, answer: &ModesResult) -> io::Result<()> {
    let equations = answer.model.equation().to_string();
    let mut head = fields::of_equilibrium().lines(answer);
    head.extend(equations.split("; ").map(|equation| ("equation", equation.to_owned())));
    head.push(("equilibrium", equilibrium(answer)));
    sheet(out, &head)?;
    for NumberedMode { number, mode } in answer.numbered() {
        writeln!(out, "\n{}", paragraph(&format!("mode {number}: "), &summary(mode), COLUMNS))?;
        for (name, text) in lines(answer, mode) {
            writeln!(out, "{}", paragraph(&format!("  {name:<11}"), &text, COLUMNS))?;
        }
    }
    Ok(())
}

fn equilibrium(answer: &ModesResult) -> String {
    let names = answer.modes.variables.iter();
    let values: Vec<String> = match &answer.modes.exact_equilibrium {
        Some(exact) => names.zip(exact).map(|(name, value)| format!("{name} = {value}")).collect(),
        None => names
            .zip(&answer.modes.equilibrium)
            .map(|(name, x)| format!("{name} = {}", rounded(*x, 15)))
            .collect(),
    };
    values.join(", ")
}

fn summary(mode: &Mode) -> String {
    let Complex { re, im } = mode.exponent;
    /// Error of a rate, relative to the exponent.
    const ERROR: f64 = 4.0 * f64::EPSILON;
    let rate = to_its_error(re.abs(), ERROR * mode.exponent.abs(), 15);
    let frequency = rounded(im, 15);
    match mode.behaviour {
        Behaviour::Oscillating => {
            match exact_frequency(mode).filter(|text| text.contains(|c: char| !c.is_ascii_digit())) {
                Some(text) => format!("ω = {text} = {frequency}"),
                None => format!("ω = {frequency}"),
            }
        }
        Behaviour::Free => "free, without a linear restoring force".to_owned(),
        Behaviour::Unstable if im > 0.0 => {
            format!("UNSTABLE, growing like exp({rate} t) at the frequency {frequency}")
        }
        Behaviour::Unstable => format!("UNSTABLE, growing like exp({rate} t)"),
        _ if im > 0.0 => format!("damped, decaying like exp(-{rate} t) at the frequency {frequency}"),
        _ => format!("damped without oscillation, decaying like exp(-{rate} t)"),
    }
}

fn lines(answer: &ModesResult, mode: &Mode) -> Vec<(&'static str, String)> {
    let mut lines = vec![];
    if mode.exponent.im > 0.0 {
        lines.push(("period", rounded(TAU / mode.exponent.im, 15)));
    }
    if mode.shape.len() > 1 {
        lines.push(("shape", shape(&answer.modes.variables, mode)));
    }
    if mode.multiplicity > 1 {
        lines.push((
            "",
            format!("{} modes have this frequency: any combination of them is a mode too", mode.multiplicity),
        ));
    }
    if mode.with_powers_of_time > 0 {
        lines.push(("", with_powers_of_time(mode)));
    }
    if mode.behaviour == Behaviour::Oscillating {
        lines.push(("amplitude", shift(&answer.modes.variables, mode)));
    }
    lines.extend(
        mode.resonances
            .iter()
            .filter(|resonance| mode.multiplicity == 1 || resonance.multiple > 1)
            .map(|resonance| ("resonance", resonance_text(resonance))),
    );
    lines
}

fn with_powers_of_time(mode: &Mode) -> String {
    let consequence = match mode.behaviour {
        Behaviour::Damped => "decay in the end",
        _ => "grow without limit in the linear equations",
    };
    let number = mode.with_powers_of_time;
    format!("motions with this exponent that contain a factor t: {number}; they {consequence}")
}

fn shape(names: &[String], mode: &Mode) -> String {
    let digits = mode.shape.iter().map(in_digits).collect::<Vec<_>>().join(" : ");
    let names = names.join(" : ");
    let Some(surds) = &mode.exact_shape else { return format!("{names} = {digits}") };
    let exact = surds.iter().map(ToString::to_string).collect::<Vec<_>>().join(" : ");
    let plain = surds.iter().all(|surd| surd.to_rational().is_some());
    if plain { format!("{names} = {exact}") } else { format!("{names} = {exact} = {digits}") }
}

fn in_digits(part: &Complex) -> String {
    /// Rounding error of parts whose largest is 1.
    const ROUNDING: f64 = 1e-12;
    let text = |x: f64| if x.abs() < ROUNDING { "0".to_owned() } else { short(x, 13) };
    match (text(part.re), text(part.im.abs())) {
        (re, im) if im == "0" => re,
        (re, im) if re == "0" => format!("{}{im}i", if part.im < 0.0 { "-" } else { "" }),
        (re, im) => format!("{re} {} {im}i", if part.im < 0.0 { "-" } else { "+" }),
    }
}

/// Ω by the amplitude a of the leading coordinate.
fn shift(names: &[String], mode: &Mode) -> String {
    let leading = &names[mode.leading()];
    match &mode.shift {
        Ok(shift) => {
            let coefficient = short(shift.coefficient, 13);
            let law = match &shift.relative {
                _ if shift.coefficient == 0.0 => "Ω = ω, without a term in a²".to_owned(),
                Some(surd) => format!("Ω = ω(1 {} a²) = ω + κa² with κ = {coefficient}", signed(surd)),
                None => format!("Ω = ω + κa² with κ = {coefficient}"),
            };
            format!("{law}, where a is the amplitude of {leading}")
        }
        Err(reason) => format!("frequency shift not known: {reason}"),
    }
}

/// The number with its sign, as a term of a sum.
fn signed(surd: &Surd) -> String {
    match surd.to_rational() {
        Some(value) if value.is_negative() => format!("- {}", value.magnitude()),
        Some(value) => format!("+ {value}"),
        None => format!("+ ({surd})"),
    }
}

fn resonance_text(resonance: &Resonance) -> String {
    let Resonance { other, multiple, other_is_faster, detuning, exact } = *resonance;
    let ratio = if other_is_faster { format!("1:{multiple}") } else { format!("{multiple}:1") };
    let nearness = if exact {
        "exactly".to_owned()
    } else {
        format!("to {}", rounded(100.0 * detuning.abs(), 2) + " %")
    };
    let consequence = match (exact, other_is_faster) {
        (true, _) => "the two exchange energy at any amplitude if the forces couple them",
        (false, true) => "the frequency shift above holds only while it is smaller than the detuning",
        (false, false) => "small swings of this mode may drive the other",
    };
    format!("{ratio} with mode {}, {nearness}: {consequence}", other + 1)
}
