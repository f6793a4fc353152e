//! A slow flow to read, and in LaTeX.

use super::{SlowFlowResult, leading_cycles};
use crate::output::formulas;
use crate::output::number::short;
use crate::output::series::{Style, superscript, wrapped};
use crate::output::table::write_text;
use libration::algebra::PiSum;
use libration::expression::Expression;
use libration::perturbation::{Gauge, PhaseTerm, SlowFlow, SlowSeries};
use std::io::{self, Write};

/// Lines are broken here.
const COLUMN: usize = 110;

pub(super) fn write(out: &mut dyn Write, answer: &SlowFlowResult) -> io::Result<()> {
    let flow = &answer.flow;
    answer.subject.write(out)?;
    let variable = &answer.subject.variable;
    let (equilibrium, square) = (&flow.equilibrium, &flow.omega0_squared);
    write_text(out, "", &format!("about {variable} = {equilibrium}, where ω0² = {square}"))?;
    write_text(out, "", &meaning(answer))?;
    writeln!(out)?;
    let [amplitude, phase] = letters(answer, Style::Text);
    let names = PolynomialNotation { parameter: &flow.parameter, amplitude: &amplitude, style: Style::Text };
    for (name, series) in [(&amplitude, &flow.amplitude_rate), (&phase, &flow.phase_rate)] {
        writeln!(out, "{}", wrapped(&format!("{name}′ = "), &names.series(series), COLUMN))?;
    }
    writeln!(out, "\n{}:", motion_title(answer))?;
    for (name, series) in of_motion(flow, &phase, Style::Text) {
        writeln!(out, "{}", wrapped(&format!("{name}: "), &names.series(series), COLUMN))?;
    }
    write_cycles(out, flow, &amplitude)?;
    writeln!(out)?;
    write_text(out, "", "all coefficients are exact")?;
    leading_cycles::write(out, answer)
}

/// The symbols of amplitude and phase in a notation.
fn letters(answer: &SlowFlowResult, style: Style) -> [String; 2] {
    answer.letters().map(|letter| match style {
        Style::Latex => formulas::latex(&letter),
        _ => letter.replace("psi", "ψ"),
    })
}

/// The limit cycles, with decimal coefficients.
fn write_cycles(out: &mut dyn Write, flow: &SlowFlow, amplitude: &str) -> io::Result<()> {
    for cycle in flow.limit_cycles() {
        let side = if cycle.exponent.get(1).is_some_and(|rate| *rate < 0.0) { ">" } else { "<" };
        writeln!(out, "\nlimit cycle, in digits, attracting for {} {side} 0:", flow.parameter)?;
        let lines = [(amplitude, &cycle.amplitude), ("Ω", &cycle.frequency), ("exponent", &cycle.exponent)];
        for (name, series) in lines {
            writeln!(out, "{}", wrapped(&format!("{name} = "), &in_digits(series, &flow.parameter), COLUMN))?;
        }
    }
    Ok(())
}

fn in_digits(series: &[f64], parameter: &str) -> String {
    const DIGITS: usize = 10;
    // What rounding leaves of a coefficient that is zero.
    const ROUNDING: f64 = 1e-12;
    let mut text = String::new();
    for (n, value) in series.iter().enumerate().filter(|(_, value)| value.abs() > ROUNDING) {
        let sign = match (text.is_empty(), *value < 0.0) {
            (true, false) => "",
            (true, true) => "-",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        let power = if n == 0 { String::new() } else { format!(" {parameter}{}", power(n)) };
        text.push_str(&format!("{sign}{}{power}", short(value.abs(), DIGITS)));
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

fn meaning(answer: &SlowFlowResult) -> String {
    let SlowFlow { parameter, order, parameter_order, gauge, .. } = &answer.flow;
    let [amplitude, phase] = letters(answer, Style::Text);
    let gauge = match gauge {
        Gauge::XMax => format!("{amplitude} is the displacement where the motion turns, at {phase} = 0"),
        _ => format!("{amplitude} is the coefficient of cos {phase}, and there is no sin {phase}"),
    };
    format!("slow flow to {amplitude}{} and {parameter}{}: {gauge}", power(*order), power(*parameter_order))
}

fn power(number: usize) -> String {
    if number == 1 { String::new() } else { superscript(number) }
}

fn motion_title(answer: &SlowFlowResult) -> String {
    let (variable, flow) = (&answer.subject.variable, &answer.flow);
    let [amplitude, phase] = letters(answer, Style::Text);
    let offset = if flow.equilibrium.is_zero() { String::new() } else { format!(" - {}", flow.equilibrium) };
    let whole = format!("{variable}({amplitude}, {phase}){offset} is the sum of");
    if flow.half_swing {
        format!("for 0 ≤ {phase} ≤ π {whole}, and the opposite at {phase} + π")
    } else {
        whole
    }
}

/// The functions of the phase in the motion, each with its factor.
fn of_motion<'a>(flow: &'a SlowFlow, phase: &str, style: Style) -> Vec<(String, &'a SlowSeries)> {
    let present = |series: &SlowSeries| series.iter().flatten().any(|value| !value.is_zero());
    let each = |term: &'_ PhaseTerm, name: &str| function_name(term, name, phase, style);
    let both = flow
        .motion
        .iter()
        .flat_map(|term| [(each(term, "cos"), &term.cos), (each(term, "sin"), &term.sin)].into_iter());
    both.filter(|(_, series)| present(series)).collect()
}

/// `ψ² cos 3ψ`, and `1` for the mean.
fn function_name(term: &PhaseTerm, function: &str, psi: &str, style: Style) -> String {
    let powers = match (term.power, style) {
        (0, _) => String::new(),
        (1, _) => format!("{psi} "),
        (p, Style::Latex) => format!("{psi}^{{{p}}} "),
        (p, _) => format!("{psi}{} ", superscript(p)),
    };
    let function = if style == Style::Text { function.to_owned() } else { format!(r"\{function}") };
    match term.k {
        0 if powers.is_empty() => "1".to_owned(),
        0 => powers.trim_end().to_owned(),
        1 => format!("{powers}{function} {psi}"),
        k => format!("{powers}{function} {k}{psi}"),
    }
}

/// The notation of the terms of polynomials.
struct PolynomialNotation<'a> {
    parameter: &'a str,
    amplitude: &'a str,
    style: Style,
}

impl PolynomialNotation<'_> {
    fn series(&self, series: &SlowSeries) -> String {
        let mut text = String::new();
        for (j, list) in series.iter().enumerate() {
            for (n, value) in list.iter().enumerate().filter(|(_, value)| !value.is_zero()) {
                let term = self.term(value, [j, n]);
                text.push_str(&match (text.is_empty(), term.strip_prefix('-')) {
                    (true, _) => term,
                    (false, Some(size)) => format!(" - {size}"),
                    (false, None) => format!(" + {term}"),
                });
            }
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    fn term(&self, value: &PiSum, [j, n]: [usize; 2]) -> String {
        let powers = [(self.parameter, j), (self.amplitude, n)].map(|(name, power)| self.power(name, power));
        let powers: Vec<String> = powers.into_iter().filter(|text| !text.is_empty()).collect();
        let powers = powers.join(" ");
        let factor = self.coefficient(value);
        match (factor.as_str(), powers.is_empty()) {
            (_, true) => factor,
            ("1", false) => powers,
            ("-1", false) => format!("-{powers}"),
            (_, false) => format!("{factor} {powers}"),
        }
    }

    fn power(&self, name: &str, power: usize) -> String {
        match (power, self.style) {
            (0, _) => String::new(),
            (1, _) => name.to_owned(),
            (_, Style::Latex) => format!("{name}^{{{power}}}"),
            _ => format!("{name}{}", superscript(power)),
        }
    }

    fn coefficient(&self, value: &PiSum) -> String {
        let text = value.to_string();
        let [whole, inside] = match self.style {
            Style::Text | Style::Sentence | Style::MathMl => [in_letters(&text), in_letters(&text)],
            Style::Latex => {
                let size = text.strip_prefix('-').filter(|_| value.terms().len() == 1);
                let latex = size
                    .unwrap_or(&text)
                    .parse()
                    .map_or_else(|_| text.clone(), |expression: Expression| expression.to_latex());
                let sign = if size.is_some() { "-" } else { "" };
                [format!("{sign}{latex}"), latex]
            }
        };
        if value.terms().len() > 1 { format!("({inside})") } else { whole }
    }
}

/// Replaces pi by π, and removes the sign of multiplication in denominators: 4/(3π).
pub fn in_letters(text: &str) -> String {
    let mut parts = text.split("/(");
    let first = parts.next().unwrap_or_default().to_owned();
    let whole = parts.fold(first, |text, part| format!("{text}/({}", part.replacen("*pi", "π", 1)));
    whole.replace("pi", "π")
}

/// The polynomials as display equations.
pub(super) fn write_latex(out: &mut dyn Write, answer: &SlowFlowResult) -> io::Result<()> {
    let flow = &answer.flow;
    let parameter = formulas::latex(&flow.parameter);
    let [amplitude, phase] = letters(answer, Style::Latex);
    let names = PolynomialNotation { parameter: &parameter, amplitude: &amplitude, style: Style::Latex };
    writeln!(out, "\\[ {} \\]", answer.subject.equation_latex)?;
    writeln!(out, "\\begin{{align*}}")?;
    writeln!(out, "  \\dot {amplitude} &= {} \\\\", names.series(&flow.amplitude_rate))?;
    writeln!(out, "  \\dot {phase} &= {}", names.series(&flow.phase_rate))?;
    writeln!(out, "\\end{{align*}}")?;
    let variable = formulas::latex(&answer.subject.variable);
    let offset = if flow.equilibrium.is_zero() { String::new() } else { format!(" - {}", flow.equilibrium) };
    let terms = of_motion(flow, &phase, Style::Latex);
    let terms: Vec<String> = terms
        .into_iter()
        .map(|(name, series)| {
            let name = if name == "1" { String::new() } else { format!(r"\,{name}") };
            format!(r"\left({}\right){name}", names.series(series))
        })
        .collect();
    writeln!(out, "\\begin{{align*}}")?;
    let range = if flow.half_swing { format!(r",\quad 0 \le {phase} \le \pi") } else { String::new() };
    writeln!(out, "  {variable}{offset} &= {}{range}", terms.join(" \\\\\n  &\\quad + "))?;
    writeln!(out, "\\end{{align*}}")
}
