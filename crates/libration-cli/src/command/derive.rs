//! `libration derive`: worked derivations, every formula checked.

use crate::arguments::{self, PendulumOptions};
use crate::failure::Failure;
use crate::output::file;
use libration::derivation::{self, Derivation, DerivationError, Swing};
use libration::pendulum::Amplitude;
use libration::quantity::Angle;
use std::io::Write;
use std::path::PathBuf;

/// A worked derivation, step by step, each formula checked by computing it
///
/// Below each formula stands how it was checked: exactly with fractions, or in 77 digits at several amplitudes.
/// With --amplitude each step also shows its numbers for that pendulum.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration derive --road elliptic > period.md
  libration derive --road elliptic --amplitude 40deg --length 1m --format html --output period.html
  libration derive --road formulas --format latex --output formulas.tex")]
pub(crate) struct Derive {
    /// Which way to the period
    #[arg(long, value_enum)]
    road: Road,
    /// Show the numbers of a pendulum of this amplitude, such as 40deg
    #[arg(long, value_parser = arguments::angle)]
    amplitude: Option<Angle>,
    #[command(flatten)]
    pendulum: PendulumOptions,
    /// How the derivation is written
    #[arg(long, value_enum, default_value = "markdown")]
    format: Format,
    /// Write to this file instead of the screen
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Road {
    /// The exact period: energy, elliptic integral, series, mean
    Elliptic,
    /// Where the published formulas for the period come from
    Formulas,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// Markdown with formulas in LaTeX
    Markdown,
    /// A document for pdflatex
    Latex,
    /// A page that stands alone, formulas in MathML
    Html,
}

impl Derive {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let text = self.format.write(&self.derivation()?);
        match &self.output {
            Some(path) => file::write(path, text.as_bytes()),
            None => Ok(out.write_all(text.as_bytes())?),
        }
    }

    fn derivation(&self) -> Result<Derivation, Failure> {
        let swing = self.swing()?;
        let derivation = match self.road {
            Road::Elliptic => derivation::elliptic(swing.as_ref()),
            Road::Formulas => derivation::formulas(swing.as_ref()),
        };
        derivation.map_err(|error| match error {
            DerivationError::Amplitude { .. } => Failure::no_answer("--amplitude", error),
            error => Failure::no_answer("derivation", error),
        })
    }

    /// The reader's swing, if there is one.
    fn swing(&self) -> Result<Option<Swing>, Failure> {
        let Some(angle) = self.amplitude else {
            return if self.pendulum.is_default() { Ok(None) } else { Err(amplitude_missing()) };
        };
        let amplitude = Amplitude::new(angle).map_err(|error| Failure::no_answer("--amplitude", error))?;
        Ok(Some(Swing { pendulum: self.pendulum.pendulum()?, amplitude }))
    }
}

fn amplitude_missing() -> Failure {
    Failure::Usage(
        "--length and --gravity show their numbers at an amplitude: add --amplitude 40deg".to_owned(),
    )
}

impl Format {
    fn write(self, derivation: &Derivation) -> String {
        match self {
            Self::Markdown => derivation::to_markdown(derivation),
            Self::Latex => derivation::to_latex(derivation),
            Self::Html => derivation::to_html(derivation),
        }
    }
}
