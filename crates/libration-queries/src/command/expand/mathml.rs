//! The expansion as formulas in MathML, one a line.

use super::answer::ExpandResult;
use super::listing::{HarmonicPart, letter_of, parts};
use crate::output::mathml::{display, element, name, number};
use crate::output::series::{Coefficient, Notation, Style};
use libration::perturbation::Precision;
use std::io::{self, Write};

pub(super) fn write<C: Coefficient>(out: &mut dyn Write, answer: &ExpandResult<C>) -> io::Result<()> {
    let expansion = &answer.expansion;
    writeln!(out, "{}", display(&element("mtext", &[&answer.subject.equation])))?;
    let variable = name(&answer.variable());
    let unit = unit(answer);
    let mut line = |left: String, unit: &str, series: &[C], variable: &str| {
        let notation = Notation { precision: expansion.precision, style: Style::MathMl };
        let series = notation.series(series, variable);
        let series = if unit.is_empty() { series } else { crate::output::mathml::bracketed(&series) };
        writeln!(out, "{}", display(&format!("{left}<mo>=</mo>{unit}{series}")))
    };
    line(ratio("Ω", "omega0"), "", &expansion.frequency_ratio, &variable)?;
    if let Some(frequency) = answer.frequency() {
        line(name("Omega"), "", frequency, &variable)?;
    }
    for HarmonicPart { letter, k, series } in parts(expansion) {
        line(name(&format!("{letter}{k}")), &unit, series, &variable)?;
    }
    line(name("x_max"), &unit, &expansion.x_max, &variable)?;
    line(name("x_min"), &unit, &expansion.x_min, &variable)?;
    for (symbol, of) in [("A", &expansion.of_amplitude), ("h", &expansion.of_half_swing)] {
        let Some(of) = of else { continue };
        let symbol = name(&answer.symbol(symbol));
        line(ratio("Ω", "omega0"), "", &of.frequency_ratio, &symbol)?;
        line(ratio("T", "T0"), "", &of.period_ratio, &symbol)?;
        line(variable.clone(), "", &of.epsilon, &symbol)?;
        for (k, series) in &of.harmonics {
            line(name(&format!("{}{k}", letter_of(expansion))), "", series, &symbol)?;
        }
    }
    Ok(())
}

fn ratio(above: &str, below: &str) -> String {
    element("mfrac", &[&element("mi", &[above]), &name(below)])
}

/// The root that is the unit of displacements, if it is not 1.
fn unit<C: Coefficient>(answer: &ExpandResult<C>) -> String {
    match answer.expansion.unit_squared.written(Precision::Exact).as_str() {
        "1" => String::new(),
        squared => element("msqrt", &[&number(squared)]),
    }
}
