//! `libration figure`: the pictures.

mod errors;
mod motion;
mod phase;
mod releases;
mod report;
mod series;
mod spectrum;

use crate::arguments;
use crate::failure::Failure;
use crate::figure::chart::Picture;
use crate::figure::file;
use crate::output::FormOptions;
use std::io::Write;
use std::path::PathBuf;

/// Draw a picture: errors of the formulas, motions, the phase portrait, harmonics, perturbation series
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration figure errors --output errors.svg
  libration figure errors --formulas bernoulli,carvalhaes_suppes --from 60deg --output errors.png
  libration figure motion --amplitudes 30deg,90deg,179deg --output motion.svg
  libration figure phase --output phase.svg
  libration figure spectrum --amplitudes 60deg,150deg,179deg --output spectrum.png
  libration figure series pendulum --output series.svg
  libration figure series duffing --amplitudes 0.5,0.9,1.1 --order 41 --output terms.png")]
pub(crate) struct Figure {
    #[command(subcommand)]
    picture: Subject,
}

#[derive(Debug, clap::Subcommand)]
enum Subject {
    Errors(errors::Errors),
    Motion(motion::Motion),
    Phase(phase::Phase),
    Spectrum(spectrum::Spectrum),
    Series(series::Series),
}

/// The options of every picture.
#[derive(Clone, Debug, clap::Args)]
struct PictureOptions {
    /// The file to write; its ending, .svg or .png, says the format
    #[arg(long, short, value_name = "FILE", value_parser = file::drawable)]
    output: PathBuf,
    /// Width of the picture; a PNG has 2.4 pixels for each unit
    #[arg(long, default_value = "1200", value_parser = side)]
    width: f64,
    /// Height of the picture
    #[arg(long, default_value = "700", value_parser = side)]
    height: f64,
    #[command(flatten)]
    form: FormOptions,
}

impl Figure {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let (name, options, picture) = match &self.picture {
            Subject::Errors(subject) => ("errors", &subject.options, subject.picture()?),
            Subject::Motion(subject) => ("motion", &subject.options, subject.picture()?),
            Subject::Phase(subject) => ("phase", &subject.options, subject.picture()?),
            Subject::Spectrum(subject) => ("spectrum", &subject.options, subject.picture()?),
            Subject::Series(subject) => ("series", &subject.options, subject.picture()?),
        };
        let picture = Picture { width: options.width, height: options.height, ..picture };
        file::write(&options.output, &picture)?;
        Ok(report::write(out, options.form.form(), name, &options.output, &picture)?)
    }
}

/// A side between a stamp and a poster.
fn side(text: &str) -> Result<f64, String> {
    let side = arguments::positive(text).ok().filter(|side| (400.0..=4000.0).contains(side));
    side.ok_or_else(|| "give a number from 400 to 4000".to_owned())
}
