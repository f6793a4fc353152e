//! The scaling law of a force in proportion to one power of the displacement.

use super::subject::{About, Subject, of_subject};
use super::{Expand, Format};
use crate::arguments::Asked;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::formulas::{self, Heading, NamedFormula};
use crate::output::number::short;
use crate::output::series::subscript;
use crate::output::table::write_text;
use crate::output::{Form, json};
use crate::query_error::{QueryError, option};
use libration::algebra::Rational;
use libration::comparison::{HarmonicRatio, ScalingLaw};
use libration::expression::Expression;
use libration::oscillator::PurePower;
use libration::quantity::Displacement;
use std::io::{self, Write};

/// Harmonics that are given: a₁, a₃, …, a₁₁.
const HARMONICS: usize = 6;

/// A scaling law with the words for it.
pub(super) struct ScalingLawResult {
    subject: Subject,
    law: ScalingLaw,
    harmonics: Vec<HarmonicRatio>,
    /// The amplitude that was requested, with the frequency there.
    at: Option<(f64, f64)>,
}

impl About for ScalingLawResult {
    fn subject(&self) -> &Subject {
        &self.subject
    }
}

impl ScalingLawResult {
    /// `None` for other forces.
    pub(super) fn of(asked: Asked) -> Option<Self> {
        let Asked { equation, about, key, title, values, read_as } = asked;
        let law = ScalingLaw::new(PurePower::of(&equation, about.as_ref())?);
        let subject = Subject::new(&equation, (key, title), values, read_as);
        Some(Self { subject, harmonics: law.harmonics(HARMONICS), law, at: None })
    }

    /// The law with the frequency at an amplitude.
    pub(super) fn at(self, text: &str) -> Result<Self, QueryError> {
        let refusal = |reason: String| QueryError::usage(option("evaluate"), reason);
        let amplitude =
            Displacement::from_number_text(text).map_err(|error| refusal(error.to_string()))?.to_f64();
        if !(amplitude > 0.0 && amplitude.is_finite()) {
            return Err(refusal(format!("the amplitude is {amplitude:?}: give a finite number above zero")));
        }
        let Some(frequency) = self.law.frequency_at(amplitude) else {
            let strength = self.law.force().strength();
            return Err(refusal(format!(
                "the force is {strength} times a power: give values to its symbols with <--set>"
            )));
        };
        Ok(Self { at: Some((amplitude, frequency)), ..self })
    }

    /// The symbols of amplitude, phase and C, numbered where the equation has their names.
    fn symbols(&self) -> [String; 3] {
        let strength = self.law.force().strength();
        let taken: Vec<String> = strength.symbols().into_iter().map(|symbol| symbol.name).collect();
        ["A", "psi", "C"].map(|name| self.subject.free(name, &taken))
    }

    /// Frequency, period and displacement, with C in digits.
    fn formulas(&self) -> Vec<NamedFormula> {
        let law = &self.law;
        let [amplitude, phase, _] = self.symbols();
        let (times, over) = match law.force().strength() {
            one if *one == Expression::from(1) => (String::new(), String::new()),
            strength => (format!("*sqrt({strength})"), format!("/sqrt({strength})")),
        };
        let power = |exponent: Rational| format!("{amplitude}^({exponent})");
        let exponent = law.amplitude_exponent();
        let waves = self.harmonics.iter().map(|HarmonicRatio { k, ratio, .. }| {
            let wave = if *k == 1 { phase.clone() } else { format!("{k}*{phase}") };
            format!("{ratio:?}*cos({wave})")
        });
        let waves: Vec<String> = waves.collect();
        let frequency = format!("{:?}{times}*{}", law.frequency_factor(), power(exponent.clone()));
        let period = format!("{:?}{over}*{}", law.period_factor(), power(-exponent));
        NamedFormula::without_latex([
            ("angular_frequency", "the angular frequency at an amplitude", frequency),
            ("period", "the period", period),
            (
                "displacement",
                "the displacement at an amplitude and a phase",
                format!("{amplitude}*({})", formulas::sum(&waves)),
            ),
        ])
    }

    /// C as a formula.
    fn constant(&self) -> String {
        let radicand = self.law.radicand();
        let times =
            if radicand.numerator() == "1" { String::new() } else { format!("{}*", radicand.numerator()) };
        let over = if radicand.is_integer() { String::new() } else { format!("/{}", radicand.denominator()) };
        let [above, below] = self.law.gamma_arguments();
        format!("sqrt({times}pi{over})*Gamma({above})/Gamma({below})")
    }

    /// The same to read.
    fn constant_in_words(&self) -> String {
        let text = self.constant().replace("*pi", "π").replace("pi", "π").replace("Gamma", "Γ");
        text.replace("sqrt(π)", "√π").replace("sqrt", "√").replace('*', "·")
    }

    fn constant_in_latex(&self) -> String {
        let root = match self.law.radicand() {
            one if one == Rational::from(1) => r"\sqrt{\pi}".to_owned(),
            radicand => format!(r"\sqrt{{{}\,\pi}}", in_latex(&radicand)),
        };
        let [above, below] = self.law.gamma_arguments().map(|argument| in_latex(&argument));
        format!(r"{root}\,\frac{{\Gamma\left({above}\right)}}{{\Gamma\left({below}\right)}}")
    }
}

fn in_latex(number: &Rational) -> String {
    if number.is_integer() {
        return number.to_string();
    }
    let sign = if number.is_negative() { "-" } else { "" };
    let size = number.magnitude();
    format!(r"{sign}\tfrac{{{}}}{{{}}}", size.numerator(), size.denominator())
}

pub(super) fn answers() -> Answers {
    let (json, csv) = (of_law().described(""), of_harmonic().described_in_csv());
    Answers { command: "expand", option: "pure_cubic", json, csv }
}

fn of_law() -> Fields<ScalingLawResult> {
    type Of = Field<ScalingLawResult>;
    of_subject().and([
        Of::value("equilibrium", "", "equilibrium, from which amplitudes are measured", |result| {
            result.law.force().centre().to_string().into()
        }),
        Of::value("strength", "", "k of the force k·sign(x)·|x|^p, a formula of the symbols", |result| {
            result.law.force().strength().to_string().into()
        }),
        Of::value("exponent", "1", "p of that force", |result| {
            result.law.force().exponent().to_string().into()
        }),
        Of::value(
            "angular_frequency_constant",
            "",
            "C of the frequency Ω = C·√k·A^((p-1)/2) at the amplitude A, as a formula",
            |result| result.constant().into(),
        ),
        Of::value("angular_frequency_factor", "1", "C", |result| json::number(result.law.frequency_factor())),
        Of::value("angular_frequency_factor_uncertainty", "1", "uncertainty of C", |result| {
            json::number(result.law.frequency_factor_uncertainty())
        }),
        Of::value("period_factor", "1", "2π/C of the period 2π/C·A^((1-p)/2)/√k", |result| {
            json::number(result.law.period_factor())
        }),
        Of::value("period_factor_uncertainty", "1", "uncertainty of this factor", |result| {
            json::number(result.law.period_factor_uncertainty())
        }),
        Of::value(
            "amplitude_exponent",
            "1",
            "(p-1)/2, the power of the amplitude in the frequency",
            |result| result.law.amplitude_exponent().to_string().into(),
        ),
        Of::nested("harmonics[].", &of_harmonic(), |result| of_harmonic().records(&result.harmonics)),
        Of::value("amplitude", "", "amplitude that --evaluate gives, or null", |result| {
            result.at.map_or(serde_json::Value::Null, |(amplitude, _)| json::number(amplitude))
        }),
        Of::value("angular_frequency_rad_per_s", "rad/s", "frequency at that amplitude, or null", |result| {
            result.at.map_or(serde_json::Value::Null, |(_, frequency)| json::number(frequency))
        }),
    ])
}

fn of_harmonic() -> Fields<HarmonicRatio> {
    type Of = Field<HarmonicRatio>;
    Fields::from([
        Of::value("k", "1", "number of the harmonic; even ones vanish", |ratio| ratio.k.into()),
        Of::value("ratio", "1", "coefficient of cos kΩt over the amplitude", |ratio| {
            json::number(ratio.ratio)
        }),
        Of::value("uncertainty", "1", "uncertainty of the ratio", |ratio| json::number(ratio.uncertainty)),
    ])
}

pub(super) fn write(
    out: &mut dyn Write,
    form: Form,
    format: Option<Format>,
    answer: &ScalingLawResult,
) -> Result<(), QueryError> {
    match (format, form) {
        (Some(Format::Latex), _) => write_latex(out, answer)?,
        (Some(format), _) => {
            let heading = Heading { module: "scaling_law", equations: &answer.subject.equation, latex: &[] };
            formulas::write(out, format, &heading, &answer.formulas())?;
        }
        (None, Form::Json) => json::document(out, of_law().record(answer))?,
        (None, Form::Csv) => of_harmonic().write_csv(out, &answer.harmonics)?,
        (None, Form::Table) => write_listing(out, answer)?,
    }
    Ok(())
}

fn write_listing(out: &mut dyn Write, answer: &ScalingLawResult) -> io::Result<()> {
    let law = &answer.law;
    answer.subject.write(out)?;
    let (variable, centre) = (&answer.subject.variable, law.force().centre());
    let [amplitude, _, constant] = &answer.symbols();
    let words = format!(
        "about {variable} = {centre}: no small oscillations to expand about, as motions of all amplitudes {amplitude} are alike",
    );
    write_text(out, "", &words)?;
    writeln!(out)?;
    let power = |exponent: Rational| power_of_amplitude(amplitude, &exponent);
    let root = root_of_strength(law);
    writeln!(out, "Ω = {constant}{root}{}", power(law.amplitude_exponent()))?;
    let divisor = if root.is_empty() { constant.clone() } else { format!("({constant}{root})") };
    writeln!(out, "T = 2π/{divisor}{}", power(-law.amplitude_exponent()))?;
    writeln!(out, "{constant} = {}", answer.constant_in_words())?;
    writeln!(
        out,
        "  = {:.15}, error below {:.0e}",
        law.frequency_factor(),
        law.frequency_factor_uncertainty()
    )?;
    writeln!(out, "2π/{constant} = {:.15}", law.period_factor())?;
    writeln!(out, "\nharmonics at every amplitude:")?;
    for HarmonicRatio { k, ratio, uncertainty } in &answer.harmonics {
        writeln!(out, "a{}/{amplitude} = {ratio:.15}, error below {uncertainty:.0e}", subscript(*k))?;
    }
    if let Some((at, frequency)) = answer.at {
        let period = std::f64::consts::TAU / frequency;
        writeln!(out, "\nat {amplitude} = {}: Ω = {frequency:.14}, T = {period:.14}", short(at, 12))?;
    }
    Ok(())
}

/// `·√k`, or an empty text for k = 1.
fn root_of_strength(law: &ScalingLaw) -> String {
    let strength = law.force().strength();
    match strength {
        one if *one == Expression::from(1) => String::new(),
        other => match other.to_string() {
            text if text.chars().all(char::is_alphanumeric) => format!("·√{text}"),
            text => format!("·√({text})"),
        },
    }
}

fn power_of_amplitude(amplitude: &str, exponent: &Rational) -> String {
    match exponent.to_string().as_str() {
        "1" => format!("·{amplitude}"),
        text => format!("·{amplitude}^({text})"),
    }
}

fn write_latex(out: &mut dyn Write, answer: &ScalingLawResult) -> io::Result<()> {
    let law = &answer.law;
    let root = match law.force().strength() {
        one if *one == Expression::from(1) => String::new(),
        strength => format!(r"\sqrt{{{}}}\,", strength.to_latex()),
    };
    let [amplitude, _, constant] = &answer.symbols().map(|name| formulas::latex(&name));
    let power = match law.amplitude_exponent() {
        one if one == Rational::from(1) => amplitude.clone(),
        exponent => format!("{amplitude}^{{{}}}", in_latex(&exponent)),
    };
    writeln!(out, "\\[ {} \\]", answer.subject.equation_latex)?;
    writeln!(out, "\\begin{{align*}}")?;
    writeln!(out, "  \\Omega &= {constant}\\,{root}{power} \\\\")?;
    writeln!(out, "  {constant} &= {} = {:.15}", answer.constant_in_latex(), law.frequency_factor())?;
    let harmonics = answer.harmonics.iter();
    for HarmonicRatio { k, ratio, .. } in harmonics {
        writeln!(out, "  \\\\ \\frac{{a_{{{k}}}}}{{{amplitude}}} &= {ratio:.15}")?;
    }
    writeln!(out, "\\end{{align*}}")
}

impl Expand {
    pub(super) fn answer_scaling_law(
        &self,
        out: &mut dyn Write,
        answer: ScalingLawResult,
    ) -> Result<(), QueryError> {
        let answer = match &self.evaluate {
            None => answer,
            Some(text) => answer.at(text)?,
        };
        write(out, self.form.form(), self.formats.format(), &answer)?;
        Ok(out.flush()?)
    }
}
