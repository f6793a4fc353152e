//! The expansion to read, and in LaTeX.

use super::answer::ExpandResult;
use super::answer::Letters;
use crate::output::formulas;
use crate::output::series::{Coefficient, Notation, Style, subscript, superscript, wrapped};
use crate::output::table::write_text;
use libration::expression::Expression;
use libration::perturbation::{
    AmplitudeSeries, Certificate, Expansion, ExpansionVariable, HarmonicSeries, PhaseOrigin, Precision,
};
use std::io::{self, Write};

/// Lines are broken here.
const COLUMN: usize = 110;

pub(super) fn write<C: Coefficient>(out: &mut dyn Write, answer: &ExpandResult<C>) -> io::Result<()> {
    let expansion = &answer.expansion;
    let notation = Notation { precision: expansion.precision, style: Style::Text };
    let symbols = Symbols::new(answer);
    write_head(out, answer)?;
    write_text(out, "", &meaning(expansion, &symbols))?;
    writeln!(out)?;
    for (name, text) in lines(answer, notation, &symbols) {
        writeln!(out, "{}", wrapped(&name, &text, COLUMN))?;
    }
    let amplitudes = [
        ("A", "of the largest displacement", &expansion.of_amplitude),
        ("h", "of half the swing", &expansion.of_half_swing),
    ];
    for (symbol, title, of) in
        amplitudes.into_iter().filter_map(|(s, title, of)| Some((answer.symbol(s), title, of.as_ref()?)))
    {
        writeln!(out, "\nas functions {title} {symbol}:")?;
        let names = (&symbols.variable[..], letter_of(expansion));
        for (name, text) in amplitude_lines(of, notation, &symbol, names) {
            writeln!(out, "{}", wrapped(&name, &text, COLUMN))?;
        }
    }
    writeln!(out)?;
    write_text(out, "", &checked(answer))
}

/// Writes the subject of the expansion and the equilibrium.
pub(super) fn write_head<C: Coefficient>(out: &mut dyn Write, answer: &ExpandResult<C>) -> io::Result<()> {
    answer.subject.write(out)?;
    write_text(out, "", &setting(answer))
}

/// The symbols of the variables.
pub(super) struct Symbols {
    pub(super) variable: String,
    latex: String,
}

impl Symbols {
    pub(super) fn new<C>(answer: &ExpandResult<C>) -> Self {
        let name = answer.variable();
        let variable = match &answer.expansion.variable {
            ExpansionVariable::Epsilon(_) => name.replace("epsilon", "ε"),
            ExpansionVariable::Parameter(_) if name == "mu" => "μ".to_owned(),
            ExpansionVariable::Parameter(_) => name.clone(),
        };
        let latex = name.parse::<Expression>().map_or(name, |symbol| symbol.to_latex());
        Self { variable, latex }
    }
}

/// A number for a sentence.
fn number<C: Coefficient>(value: &C, precision: Precision) -> String {
    let notation = Notation { precision, style: Style::Sentence };
    let (is_negative, text) = value.split(notation, false);
    if is_negative { format!("-{text}") } else { text }
}

fn setting<C: Coefficient>(answer: &ExpandResult<C>) -> String {
    let expansion = &answer.expansion;
    let number = |value| number(value, expansion.precision);
    let (equilibrium, square) = (number(&expansion.equilibrium), number(&expansion.omega0_squared));
    let root = answer.letters.as_ref().map_or(String::new(), root_in_words);
    format!("about {} = {equilibrium}, where ω0² = {square}{root}", answer.subject.variable)
}

/// A description of ω0 where its square has letters.
fn root_in_words<C>(letters: &Letters<C>) -> String {
    let constants: String =
        letters.explained().map(|(name, value)| format!(", with {name} = {value}")).collect();
    let omega0 = &letters.omega0;
    let root = match &letters.omega0_name {
        _ if omega0 == "1" => String::new(),
        None if letters.names.is_empty() => format!(", so that ω0 = {omega0}"),
        None => format!(", so that ω0 = {omega0} for positive symbols"),
        Some(name) => format!(", so that ω0 = {omega0}, which is called {name} in the coefficients"),
    };
    root + &constants
}

/// The meaning of the variable, and the order of the series.
fn meaning<C>(expansion: &Expansion<C>, symbols: &Symbols) -> String {
    let Symbols { variable, .. } = symbols;
    let power = |n: usize| if n == 1 { variable.clone() } else { format!("{variable}{}", superscript(n)) };
    let order = expansion.order;
    match &expansion.variable {
        ExpansionVariable::Epsilon(gauge) => {
            let gauge = gauge_in_words(gauge, (variable, letter_of(expansion)));
            let frequency =
                if order > 1 { format!("Ω to {}", power(order - 1)) } else { "Ω to order 0".to_owned() };
            let origin = match expansion.phase_origin {
                PhaseOrigin::Passage => ", counted from a passage upward through the equilibrium",
                PhaseOrigin::TurningPoint | PhaseOrigin::FirstHarmonic => "",
            };
            let left_out = left_out(expansion).map_or_else(String::new, |words| format!("; {words}"));
            format!("x to {}, {frequency}; {gauge}; τ = Ωt{origin}{left_out}", power(order))
        }
        ExpansionVariable::Parameter(_) => {
            format!("the limit cycle to {}; τ = Ωt, with the phase in which there is no sin τ", power(order))
        }
    }
}

/// A note on further harmonics in the same powers.
pub(super) fn left_out<C>(expansion: &Expansion<C>) -> Option<String> {
    let highest = expansion.harmonics.iter().map(|harmonic| harmonic.k).max();
    let above = highest.filter(|_| !expansion.has_all_harmonics)?;
    Some(format!("there are harmonics without end, those above {above} are left out"))
}

fn gauge_in_words(gauge: &libration::perturbation::Gauge, (epsilon, letter): (&str, &str)) -> String {
    use libration::perturbation::Gauge;
    let meaning = match gauge {
        Gauge::Fundamental if letter == "b" => format!("{epsilon} is the coefficient of sin τ"),
        Gauge::Fundamental => format!("{epsilon} is the coefficient of cos τ"),
        Gauge::XMax => format!("{epsilon} is the largest displacement"),
        Gauge::HalfSwing => format!("{epsilon} is half the distance between the turning points"),
        Gauge::Energy => format!("{epsilon} = √(2E)/ω0, E the energy above the equilibrium"),
        Gauge::Nome => format!("{epsilon} = 8√q, q the nome"),
        Gauge::Coefficients(_) => format!("{gauge} in {letter}₁ = A₁{epsilon} + A₂{epsilon}² + …"),
        _ => gauge.to_string(),
    };
    format!("gauge: {meaning}")
}

fn lines<C: Coefficient>(
    answer: &ExpandResult<C>,
    notation: Notation,
    symbols: &Symbols,
) -> Vec<(String, String)> {
    let (expansion, variable) = (&answer.expansion, &symbols.variable);
    let unit = unit(expansion);
    let mut lines = vec![("Ω/ω0 = ".to_owned(), notation.series(&expansion.frequency_ratio, variable))];
    if let Some(frequency) = answer.frequency() {
        lines.push(("Ω = ".to_owned(), notation.series(frequency, variable)));
    }
    for HarmonicPart { letter, k, series } in parts(expansion) {
        let name = format!("{letter}{}", subscript(k));
        lines.push((format!("{name} = {unit}"), bracketed(&unit, notation.series(series, variable))));
    }
    lines.push((format!("x_max = {unit}"), bracketed(&unit, notation.series(&expansion.x_max, variable))));
    if mirrored(expansion) {
        lines.push(("x_min = ".to_owned(), "-x_max".to_owned()));
    } else {
        lines
            .push((format!("x_min = {unit}"), bracketed(&unit, notation.series(&expansion.x_min, variable))));
    }
    lines
}

fn mirrored<C: Coefficient>(expansion: &Expansion<C>) -> bool {
    expansion.x_max.iter().zip(&expansion.x_min).all(|(max, min)| max.is_opposite_of(min))
}

/// The root that is the unit of displacements, if it is not 1.
fn unit<C: Coefficient>(expansion: &Expansion<C>) -> String {
    match expansion.unit_squared.written(Precision::Exact).as_str() {
        "1" => String::new(),
        squared => format!("√({squared})·"),
    }
}

fn bracketed(unit: &str, text: String) -> String {
    if unit.is_empty() || !text.contains(' ') { text } else { format!("({text})") }
}

/// The series of cos kτ, called a, or of sin kτ, called b.
pub(super) struct HarmonicPart<'a, C> {
    pub(super) letter: &'static str,
    pub(super) k: usize,
    pub(super) series: &'a [C],
}

/// The parts of harmonics that are present, and the first one in any case.
pub(super) fn parts<C: Coefficient>(expansion: &Expansion<C>) -> Vec<HarmonicPart<'_, C>> {
    let first = letter_of(expansion);
    let present = |part: &HarmonicPart<'_, C>| {
        (part.letter, part.k) == (first, 1) || part.series.iter().any(|coefficient| !coefficient.is_zero())
    };
    expansion.harmonics.iter().flat_map(both).filter(present).collect()
}

fn both<C>(harmonic: &HarmonicSeries<C>) -> [HarmonicPart<'_, C>; 2] {
    let part = |letter, series| HarmonicPart { letter, k: harmonic.k, series };
    [part("a", &harmonic.cos), part("b", &harmonic.sin)]
}

/// The letter of the coefficients of harmonics that depend on the amplitude.
pub(super) fn letter_of<C>(expansion: &Expansion<C>) -> &'static str {
    match expansion.phase_origin {
        PhaseOrigin::Passage => "b",
        PhaseOrigin::TurningPoint | PhaseOrigin::FirstHarmonic => "a",
    }
}

fn amplitude_lines<C: Coefficient>(
    of: &AmplitudeSeries<C>,
    notation: Notation,
    symbol: &str,
    (variable, letter): (&str, &str),
) -> Vec<(String, String)> {
    let mut lines = vec![
        ("Ω/ω0 = ".to_owned(), notation.series(&of.frequency_ratio, symbol)),
        ("T/T0 = ".to_owned(), notation.series(&of.period_ratio, symbol)),
        (format!("{variable} = "), notation.series(&of.epsilon, symbol)),
    ];
    for (k, series) in &of.harmonics {
        lines.push((format!("{letter}{} = ", subscript(*k)), notation.series(series, symbol)));
    }
    lines
}

fn checked<C>(answer: &ExpandResult<C>) -> String {
    let expansion = &answer.expansion;
    if answer.letters.is_some() {
        return checked_with_letters(expansion.certificate);
    }
    let precision = match expansion.precision {
        Precision::Exact => "all coefficients are exact".to_owned(),
        Precision::Digits(digits) => {
            format!(
                "not all numbers are fractions of moderate length, so the coefficients are given to {digits} digits"
            )
        }
    };
    let how = match expansion.certificate {
        Certificate::PlainRationals => "proven by a second computation in plain rational arithmetic",
        Certificate::Potential => {
            "the dependence of the frequency on the turning points is proven by the reversion of the potential, \
             the rest is confirmed modulo five further primes of 30 bits"
        }
        Certificate::FirstIntegral => {
            "the dependence of the period on the amplitude is proven by the first integral, \
             the rest is confirmed modulo five further primes of 30 bits"
        }
        Certificate::FreshPrimes => "confirmed modulo five further primes of 30 bits, not proven",
        Certificate::TwoPrecisions => "computed twice, with different numbers of digits",
        Certificate::Quadrature => "to 30 digits they are those that a quadrature gives",
        Certificate::Digits => "to 30 digits they are those of the same expansion in digits",
        Certificate::Substitution | Certificate::Unchecked => "not checked by a second method",
    };
    format!("{precision}; {how}")
}

fn checked_with_letters(certificate: Certificate) -> String {
    let substituted =
        "with fractions in place of the symbols all of them are those of the expansion with numbers";
    match certificate {
        Certificate::Unchecked => "all coefficients are exact; not checked by a second method".to_owned(),
        Certificate::Potential => format!(
            "all coefficients are exact; the dependence of the frequency on the turning points is proven by the symbolic reversion of the \
             potential, and {substituted}"
        ),
        Certificate::Quadrature => {
            "all coefficients are exact; to 30 digits they are those that a quadrature gives".to_owned()
        }
        Certificate::Digits => {
            "all coefficients are exact; to 30 digits they are those of the same expansion in digits"
                .to_owned()
        }
        _ => format!("all coefficients are exact; {substituted}"),
    }
}

/// The series as display equations.
pub(super) fn write_latex<C: Coefficient>(out: &mut dyn Write, answer: &ExpandResult<C>) -> io::Result<()> {
    let expansion = &answer.expansion;
    let notation = Notation { precision: expansion.precision, style: Style::Latex };
    let symbols = Symbols::new(answer);
    let unit = match expansion.unit_squared.written(Precision::Exact).as_str() {
        "1" => String::new(),
        squared => format!(r"\sqrt{{{squared}}}\,"),
    };
    let scaled = |series: &[C]| bracketed(&unit, notation.series(series, &symbols.latex));
    writeln!(out, "\\[ {} \\]", answer.subject.equation_latex)?;
    writeln!(out, "\\begin{{align*}}")?;
    writeln!(
        out,
        "  \\frac{{\\Omega}}{{\\omega_0}} &= {} \\\\",
        notation.series(&expansion.frequency_ratio, &symbols.latex)
    )?;
    if let Some(frequency) = answer.frequency() {
        writeln!(out, "  \\Omega &= {} \\\\", notation.series(frequency, &symbols.latex))?;
    }
    for HarmonicPart { letter, k, series } in parts(expansion) {
        writeln!(out, "  {letter}_{{{k}}} &= {unit}{} \\\\", scaled(series))?;
    }
    writeln!(out, "  x_{{\\max}} &= {unit}{} \\\\", scaled(&expansion.x_max))?;
    writeln!(out, "  x_{{\\min}} &= {unit}{}", scaled(&expansion.x_min))?;
    writeln!(out, "\\end{{align*}}")?;
    for (symbol, of) in [("A", &expansion.of_amplitude), ("h", &expansion.of_half_swing)] {
        let Some(of) = of else { continue };
        let (letter, symbol) = (letter_of(expansion), formulas::latex(&answer.symbol(symbol)));
        writeln!(out, "\\begin{{align*}}")?;
        let series = [
            (r"\frac{\Omega}{\omega_0}".to_owned(), &of.frequency_ratio),
            (r"\frac{T}{T_0}".to_owned(), &of.period_ratio),
            (symbols.latex.clone(), &of.epsilon),
        ];
        let harmonics = of.harmonics.iter().map(|(k, series)| (format!("{letter}_{{{k}}}"), series));
        let lines: Vec<String> = series
            .into_iter()
            .chain(harmonics)
            .map(|(name, series)| format!("  {name} &= {}", notation.series(series, &symbol)))
            .collect();
        writeln!(out, "{}", lines.join(" \\\\\n"))?;
        writeln!(out, "\\end{{align*}}")?;
    }
    Ok(())
}
