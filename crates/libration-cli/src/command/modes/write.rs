//! The modes as text, JSON and CSV.

use super::Answer;
use crate::output::csv;
use crate::output::json::{self, Record};
use crate::output::number::{exact, rounded, short};
use crate::output::table::{paragraph, sheet};
use libration::algebra::{Complex, Rational, Surd};
use libration::normal_modes::{Behaviour, Mode, Resonance};
use serde_json::Value;
use std::f64::consts::TAU;
use std::io::{self, Write};

/// Where lines are broken.
const COLUMNS: usize = 120;

pub(super) fn json(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let texts = |list: &[Rational]| list.iter().map(ToString::to_string).collect::<Vec<_>>();
    let values = answer.model.values().iter().map(|(name, value)| (name.clone(), value.to_string()));
    let head = Record::new()
        .with("system", answer.model.key())
        .with("equations", answer.model.equation().to_string().split("; ").collect::<Vec<_>>())
        .with("parameters", Value::from_iter(values))
        .with("coordinates", answer.modes.variables.clone())
        .with("equilibrium", answer.modes.equilibrium.clone())
        .with("exact_equilibrium", answer.modes.exact_equilibrium.as_deref().map(texts));
    json::document_with_list(out, head, "modes", answer.modes.modes.iter().map(record))
}

fn record(mode: &Mode) -> Record {
    let surds = |list: &Vec<Surd>| list.iter().map(ToString::to_string).collect::<Vec<_>>();
    let shift = mode.shift.as_ref();
    Record::new()
        .with("behaviour", word(mode.behaviour))
        .number("frequency", mode.exponent.im)
        .number("growth", mode.exponent.re)
        .with("frequency_squared", mode.frequency_squared.as_ref().map(ToString::to_string))
        .with("exact_frequency", exact_frequency(mode))
        .with("shape", mode.shape.iter().map(|part| part.re).collect::<Vec<_>>())
        .with("shape_imaginary", mode.shape.iter().map(|part| part.im).collect::<Vec<_>>())
        .with("exact_shape", mode.exact_shape.as_ref().map(surds))
        .with("multiplicity", mode.multiplicity)
        .with("resonances", mode.resonances.iter().map(|it| resonance(it).into()).collect::<Vec<Value>>())
        .with("shift", shift.map_or(Value::Null, |shift| json::number(shift.coefficient)))
        .with("exact_relative_shift", shift.ok().and_then(|it| it.relative.as_ref()).map(ToString::to_string))
        .with("no_shift", shift.err().map(ToString::to_string))
}

fn resonance(resonance: &Resonance) -> Record {
    Record::new()
        .with("with_mode", resonance.other + 1)
        .with("multiple", resonance.multiple)
        .with("other_is_faster", resonance.other_is_faster)
        .with("exact", resonance.exact)
        .number("detuning", resonance.detuning)
}

fn exact_frequency(mode: &Mode) -> Option<String> {
    let square = mode.frequency_squared.as_ref().filter(|_| mode.behaviour == Behaviour::Oscillating);
    square.map(Surd::square_root_text)
}

fn word(behaviour: Behaviour) -> &'static str {
    match behaviour {
        Behaviour::Oscillating => "oscillating",
        Behaviour::Free => "free",
        Behaviour::Unstable => "unstable",
        Behaviour::Damped => "damped",
    }
}

pub(super) fn csv(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let parts = answer.modes.variables.iter().map(|name| format!("shape_{name}"));
    let first = ["mode", "behaviour", "frequency", "growth", "exact_frequency"].map(str::to_owned);
    csv::line(out, &first.into_iter().chain(parts).chain(["shift".to_owned()]).collect::<Vec<_>>())?;
    for (number, mode) in (1..).zip(&answer.modes.modes) {
        let number: usize = number;
        let numbers = [mode.exponent.im, mode.exponent.re].map(exact);
        let parts = mode.shape.iter().map(|part| exact(part.re));
        let shift = mode.shift.as_ref().map_or_else(|_| String::new(), |shift| exact(shift.coefficient));
        let line = [number.to_string(), word(mode.behaviour).to_owned()].into_iter().chain(numbers);
        let line = line.chain([exact_frequency(mode).unwrap_or_default()]).chain(parts).chain([shift]);
        csv::line(out, &line.collect::<Vec<_>>())?;
    }
    Ok(())
}

pub(super) fn sheets(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let equations = answer.model.equation().to_string();
    let mut head = vec![("system", answer.model.title().to_owned())];
    head.extend(equations.split("; ").map(|equation| ("equation", equation.to_owned())));
    head.push(("equilibrium", equilibrium(answer)));
    sheet(out, &head)?;
    for (number, mode) in (1..).zip(&answer.modes.modes) {
        let number: usize = number;
        writeln!(out, "\n{}", paragraph(&format!("mode {number}: "), &summary(mode), COLUMNS))?;
        for (name, text) in lines(answer, mode) {
            writeln!(out, "{}", paragraph(&format!("  {name:<11}"), &text, COLUMNS))?;
        }
    }
    Ok(())
}

fn equilibrium(answer: &Answer) -> String {
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
    let (rate, frequency) = (rounded(re.abs(), 15), rounded(im, 15));
    match mode.behaviour {
        Behaviour::Oscillating => {
            match exact_frequency(mode).filter(|text| text.contains(|c: char| !c.is_ascii_digit())) {
                Some(text) => format!("ω = {text} = {frequency}"),
                None => format!("ω = {frequency}"),
            }
        }
        Behaviour::Free => "free, no force in proportion to the displacement drives it back".to_owned(),
        Behaviour::Unstable if im > 0.0 => {
            format!("UNSTABLE, growing like exp({rate} t) at the frequency {frequency}")
        }
        Behaviour::Unstable => format!("UNSTABLE, growing like exp({rate} t)"),
        _ if im > 0.0 => format!("damped, decaying like exp(-{rate} t) at the frequency {frequency}"),
        _ => format!("damped without oscillation, decaying like exp(-{rate} t)"),
    }
}

fn lines(answer: &Answer, mode: &Mode) -> Vec<(&'static str, String)> {
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
            format!("{} modes have this frequency: any mixture of them is one", mode.multiplicity),
        ));
    }
    if mode.behaviour == Behaviour::Oscillating {
        lines.push(("amplitude", shift(&answer.modes.variables, mode)));
    }
    lines.extend(
        mode.resonances
            .iter()
            .filter(|it| mode.multiplicity == 1 || it.multiple > 1)
            .map(|it| ("resonance", resonance_text(it))),
    );
    lines
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
    /// Of parts whose largest is 1.
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
        Err(reason) => format!("no change of the frequency is given: {reason}"),
    }
}

/// As it is added to something.
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
        (false, true) => {
            "the change above holds only for amplitudes so small that it is less than the detuning"
        }
        (false, false) => "small swings of this mode may feed the other",
    };
    format!("{ratio} with mode {}, {nearness}: {consequence}", other + 1)
}
