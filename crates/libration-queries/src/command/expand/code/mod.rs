//! The expansion as functions of a programming language: frequency, period and displacement.
//!
//! # Method
//! Each coefficient is one line, so that no compiler meets brackets a hundred deep. Numbers are written with as many digits as restore their bits.
//! Names change where a language reserves them or, in Fortran, does not distinguish them. The tests compile and run the functions of all four
//! languages where there is a compiler.

mod names;

use super::answer::ExpandResult;
use super::listing::left_out;
use crate::output::formulas::program::{Function, Program};
use crate::output::language::Language;
use crate::output::series::Coefficient;
use libration::algebra::Rational;
use libration::perturbation::{ExpansionVariable, PhaseOrigin, Precision};
use names::Names;
use std::io::{self, Write};

/// Writes the functions below a comment that names the oscillator, the order and the range of validity.
pub(super) fn write<C: Coefficient>(
    out: &mut dyn Write,
    answer: &ExpandResult<C>,
    language: Language,
    validity: &str,
) -> io::Result<()> {
    let program = Program {
        language,
        module: "oscillator",
        comment: comment(answer, validity),
        functions: functions(answer, language),
    };
    out.write_all(program.to_string().as_bytes())
}

/// The series, in powers of one variable, from which functions are made.
struct CodeSeries<'a, C> {
    /// The argument in whose powers they are.
    argument: &'static str,
    frequency: &'a [C],
    /// The index of a harmonic, `true` for a sine, and its coefficients.
    harmonics: Vec<(usize, bool, &'a [C])>,
}

impl<'a, C: Coefficient> CodeSeries<'a, C> {
    /// The series in powers of the largest displacement or, for a limit cycle, of its parameter.
    fn new(answer: &'a ExpandResult<C>) -> Self {
        let expansion = &answer.expansion;
        let present = |series: &[C]| series.iter().any(|coefficient| !coefficient.is_zero());
        match &expansion.of_amplitude {
            Some(of) => Self {
                argument: "amplitude",
                frequency: &of.frequency_ratio,
                harmonics: {
                    let is_sine = expansion.phase_origin == PhaseOrigin::Passage;
                    of.harmonics.iter().map(|(k, series)| (*k, is_sine, series.as_slice())).collect()
                },
            },
            None => {
                let parts = expansion.harmonics.iter().flat_map(|harmonic| {
                    [(harmonic.k, false, &harmonic.cos), (harmonic.k, true, &harmonic.sin)]
                });
                let parts = parts.map(|(k, is_sine, series)| (k, is_sine, series.as_slice()));
                let harmonics = parts.filter(|(_, _, series)| present(series)).collect();
                Self { argument: "strength", frequency: &expansion.frequency_ratio, harmonics }
            }
        }
    }
}

fn comment<C: Coefficient>(answer: &ExpandResult<C>, validity: &str) -> Vec<String> {
    let expansion = &answer.expansion;
    let number = |value: &C| value.written(expansion.precision);
    let order = expansion.order;
    let subject = &answer.subject;
    let mut lines = vec![format!("{}: {}", subject.title, subject.equation)];
    lines.extend(subject.values().map(|values| format!("with {values}")));
    let (equilibrium, square) = (number(&expansion.equilibrium), number(&expansion.omega0_squared));
    lines.push(format!("about {} = {equilibrium}, where omega0^2 = {square}", subject.variable));
    lines.push(match &expansion.variable {
        ExpansionVariable::Epsilon(gauge) => format!(
            "Lindstedt-Poincare series of order {order} in the gauge {gauge}, by powers of the amplitude, the largest \
             displacement: the frequency to power {}, the harmonics to power {order}",
            order - 1
        ),
        ExpansionVariable::Parameter(name) => {
            format!("series of the limit cycle to order {order} by powers of the strength {name}")
        }
    });
    lines.extend(left_out(expansion).map(|words| format!("the displacement is not whole: {words}")));
    for (name, constant) in answer.letters.iter().flat_map(|letters| &letters.constants) {
        lines.push(format!("the argument {name} stands for {constant}"));
    }
    lines.push(validity.to_owned());
    lines
}

fn functions<C: Coefficient>(answer: &ExpandResult<C>, language: Language) -> Vec<Function> {
    let series = CodeSeries::new(answer);
    let letters = answer.letters.as_ref().map_or(vec![], |letters| {
        let constants = letters.constants.iter().map(|(name, _)| name.clone());
        letters.names.iter().cloned().chain(constants).collect()
    });
    let root_name = answer.letters.as_ref().and_then(|letters| letters.omega0_name.clone());
    let names = Names::new(language, &letters, root_name.as_deref());
    let writer = Writer { answer, language, names: &names, series: &series };
    vec![writer.frequency(), writer.period(), writer.displacement()]
}

struct Writer<'a, C> {
    answer: &'a ExpandResult<C>,
    language: Language,
    names: &'a Names,
    series: &'a CodeSeries<'a, C>,
}

impl<C: Coefficient> Writer<'_, C> {
    fn frequency(&self) -> Function {
        let mut function =
            Function::new("frequency", "the angular frequency", self.arguments(&[self.series.argument]));
        let root = self.root(&mut function);
        self.horner(&mut function, self.series.frequency);
        function.result = match self.answer.expansion.omega0_squared.written(Precision::Exact).as_str() {
            "1" => self.names.sum.clone(),
            _ => format!("{root}*{}", self.names.sum),
        };
        function
    }

    fn period(&self) -> Function {
        let arguments = self.arguments(&[self.series.argument]);
        let call = format!("frequency({})", arguments.join(", "));
        let mut function = Function::new("period", "the period", arguments);
        function.result = format!("{}/{call}", self.language.number(std::f64::consts::TAU));
        function
    }

    /// Released at rest at its largest displacement, passing the equilibrium, or with the phase in which the first harmonic is a cosine.
    fn displacement(&self) -> Function {
        let arguments = self.arguments(&[self.series.argument]);
        let call = format!("frequency({})", arguments.join(", "));
        let meaning = match self.answer.expansion.phase_origin {
            PhaseOrigin::Passage => "the displacement, where all harmonics are sines of the phase",
            PhaseOrigin::TurningPoint | PhaseOrigin::FirstHarmonic => {
                "the displacement, where the first harmonic is a cosine of the phase"
            }
        };
        let mut function =
            Function::new("displacement", meaning, self.arguments(&[self.series.argument, "time"]));
        if self.names.root.is_some() {
            self.root(&mut function);
        }
        let Names { phase, displacement, sum, .. } = self.names;
        function.define(phase, format!("{call}*{}", self.names.argument("time")));
        function.define(displacement, self.sum_of(&self.answer.expansion.equilibrium));
        let unit = self.unit();
        for (k, is_sine, harmonic) in &self.series.harmonics {
            self.horner(&mut function, harmonic);
            let wave = if *is_sine { "sin" } else { "cos" };
            let wave = match k {
                0 => String::new(),
                1 => format!("*{}", self.language.call(wave, phase)),
                k => {
                    let number = self.language.number(f64::from(u32::try_from(*k).unwrap_or(u32::MAX)));
                    format!("*{}", self.language.call(wave, &format!("{number}*{phase}")))
                }
            };
            function.define(displacement, format!("{displacement} + {unit}{sum}{wave}"));
        }
        function.result.clone_from(displacement);
        function
    }

    fn arguments(&self, first: &[&str]) -> Vec<String> {
        let first = first.iter().map(|name| self.names.argument(name));
        first.chain(self.names.letters.iter().map(|(_, name)| name.clone())).collect()
    }

    /// ω0, by a name where coefficients need it.
    fn root(&self, function: &mut Function) -> String {
        let root = self.language.call("sqrt", &self.sum_of(&self.answer.expansion.omega0_squared));
        match &self.names.root {
            None => root,
            Some((_, name)) => {
                function.define(name, root);
                name.clone()
            }
        }
    }

    /// The unit of amplitudes of limit cycles, if it is irrational.
    fn unit(&self) -> String {
        let unit = &self.answer.expansion.unit_squared;
        match unit.written(Precision::Exact).as_str() {
            "1" => String::new(),
            _ => format!("{}*", self.language.call("sqrt", &self.sum_of(unit))),
        }
    }

    /// A series by Horner's rule, one step a line.
    fn horner(&self, function: &mut Function, series: &[C]) {
        let (sum, variable) = (&self.names.sum, self.names.argument(self.series.argument));
        let present = series.iter().enumerate().rev().filter(|(_, coefficient)| !coefficient.is_zero());
        let mut above: Option<usize> = None;
        for (power, coefficient) in present {
            let value = self.sum_of(coefficient);
            function.define(
                sum,
                match above {
                    None => value,
                    Some(above) => format!("{value} + {}*{sum}", self.power(&variable, above - power)),
                },
            );
            above = Some(power);
        }
        match above {
            None => function.define(sum, self.language.number(0.0)),
            Some(0) => {}
            Some(lowest) => function.define(sum, format!("{}*{sum}", self.power(&variable, lowest))),
        }
    }

    /// Low powers as products.
    fn power(&self, variable: &str, power: usize) -> String {
        match i64::try_from(power) {
            Ok(power) if power > 3 => self.language.power(variable, &Rational::from(power)),
            _ => vec![variable; power].join("*"),
        }
    }

    /// A coefficient as a sum of products of letters.
    fn sum_of(&self, coefficient: &C) -> String {
        let mut text = String::new();
        for (factor, powers) in coefficient.in_terms() {
            text.push_str(match (factor < 0.0, text.is_empty()) {
                (true, true) => "-",
                (true, false) => " - ",
                (false, true) => "",
                (false, false) => " + ",
            });
            text.push_str(&self.product(factor.abs(), &powers));
        }
        if text.is_empty() { self.language.number(0.0) } else { text }
    }

    /// The product of a positive number, omitted if it is 1, and powers of symbols.
    fn product(&self, number: f64, powers: &[(String, Rational)]) -> String {
        let number =
            (powers.is_empty() || number > 1.0 || number < 1.0).then(|| self.language.number(number));
        let powers =
            powers.iter().map(|(letter, exponent)| self.language.power(&self.names.letter(letter), exponent));
        number.into_iter().chain(powers).collect::<Vec<_>>().join("*")
    }
}
