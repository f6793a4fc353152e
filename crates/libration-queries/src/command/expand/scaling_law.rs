//! The scaling law of a force in proportion to one power of the displacement.

use super::subject::{About, Subject, of_subject};
use super::{Expand, Format};
use crate::arguments::Asked;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
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
    latex: bool,
    answer: &ScalingLawResult,
) -> Result<(), QueryError> {
    match form {
        Form::Json => json::document(out, of_law().record(answer))?,
        Form::Csv => of_harmonic().write_csv(out, &answer.harmonics)?,
        Form::Table if latex => write_latex(out, answer)?,
        Form::Table => write_listing(out, answer)?,
    }
    Ok(())
}

fn write_listing(out: &mut dyn Write, answer: &ScalingLawResult) -> io::Result<()> {
    let law = &answer.law;
    answer.subject.write(out)?;
    let (variable, centre) = (&answer.subject.variable, law.force().centre());
    let words = format!(
        "about {variable} = {centre}: no small oscillations to expand about, as motions of all amplitudes A are alike",
    );
    write_text(out, "", &words)?;
    writeln!(out)?;
    let (root, power) = (root_of_strength(law), power_of_amplitude(&law.amplitude_exponent()));
    let opposite = power_of_amplitude(&-law.amplitude_exponent());
    writeln!(out, "Ω = C{root}{power}")?;
    let divisor = if root.is_empty() { "C".to_owned() } else { format!("(C{root})") };
    writeln!(out, "T = 2π/{divisor}{opposite}")?;
    writeln!(out, "C = {}", answer.constant_in_words())?;
    writeln!(
        out,
        "  = {:.15}, error below {:.0e}",
        law.frequency_factor(),
        law.frequency_factor_uncertainty()
    )?;
    writeln!(out, "2π/C = {:.15}", law.period_factor())?;
    writeln!(out, "\nharmonics at every amplitude:")?;
    for HarmonicRatio { k, ratio, uncertainty } in &answer.harmonics {
        writeln!(out, "a{}/A = {ratio:.15}, error below {uncertainty:.0e}", subscript(*k))?;
    }
    if let Some((amplitude, frequency)) = answer.at {
        let period = std::f64::consts::TAU / frequency;
        writeln!(out, "\nat A = {}: Ω = {frequency:.14}, T = {period:.14}", short(amplitude, 12))?;
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

fn power_of_amplitude(exponent: &Rational) -> String {
    match exponent.to_string().as_str() {
        "1" => "·A".to_owned(),
        text => format!("·A^({text})"),
    }
}

fn write_latex(out: &mut dyn Write, answer: &ScalingLawResult) -> io::Result<()> {
    let law = &answer.law;
    let root = match law.force().strength() {
        one if *one == Expression::from(1) => String::new(),
        strength => format!(r"\sqrt{{{}}}\,", strength.to_latex()),
    };
    let power = match law.amplitude_exponent() {
        one if one == Rational::from(1) => "A".to_owned(),
        exponent => format!("A^{{{}}}", in_latex(&exponent)),
    };
    writeln!(out, "\\[ {} \\]", answer.subject.equation_latex)?;
    writeln!(out, "\\begin{{align*}}")?;
    writeln!(out, "  \\Omega &= C\\,{root}{power} \\\\")?;
    writeln!(out, "  C &= {} = {:.15}", answer.constant_in_latex(), law.frequency_factor())?;
    let harmonics = answer.harmonics.iter();
    for HarmonicRatio { k, ratio, .. } in harmonics {
        writeln!(out, "  \\\\ \\frac{{a_{{{k}}}}}{{A}} &= {ratio:.15}")?;
    }
    writeln!(out, "\\end{{align*}}")
}

impl Expand {
    pub(super) fn answer_scaling_law(
        &self,
        out: &mut dyn Write,
        answer: ScalingLawResult,
    ) -> Result<(), QueryError> {
        let latex = match self.formats.format() {
            None => false,
            Some(Format::Latex) => true,
            Some(_) => {
                let reason = "a scaling law is written as text, latex, JSON or CSV";
                return Err(QueryError::usage(option("format"), reason));
            }
        };
        let answer = match &self.evaluate {
            None => answer,
            Some(text) => answer.at(text)?,
        };
        write(out, self.form.form(), latex, &answer)?;
        Ok(out.flush()?)
    }
}
