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
use crate::figure::{Smallest, file};
use crate::interrupt;
use crate::output::{FormOptions, announce};
use std::io::Write;
use std::path::PathBuf;

/// Draw a picture: errors of the formulas, motions, the phase portrait, harmonics, perturbation series
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration figure errors --output errors.svg
  libration figure errors --formulas bernoulli,carvalhaes_suppes \\
    --from 60deg --output errors.png
  libration figure motion --amplitudes 30deg,90deg,179deg --output motion.svg
  libration figure phase --output phase.svg
  libration figure spectrum --amplitudes 60deg,150deg --output spectrum.png
  libration figure series pendulum --output series.svg
  libration figure series duffing --amplitudes 0.5,0.9,1.1 --order 41 \\
    --output terms.png")]
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
    /// The file to write, FILE.svg or FILE.png
    #[arg(long, short, value_name = "FILE", value_parser = file::drawable)]
    output: PathBuf,
    /// Width of the picture; a PNG has 2.4 pixels for each unit [default: 1200, or what its labels need]
    #[arg(long, value_parser = side)]
    width: Option<f64>,
    /// Height of the picture [default: 700, or what its labels need]
    #[arg(long, value_parser = side)]
    height: Option<f64>,
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
        let picture = options.sized(picture)?;
        let drawn = file::write(&options.output, &picture)?;
        report::write(out, options.form.form(), name, &options.output, &picture)?;
        announce(out, options.form.form(), &[drawn])?;
        interrupt::ended_early("the curves")
    }
}

impl PictureOptions {
    /// The picture in the size asked for, if that holds it.
    fn sized(&self, picture: Picture) -> Result<Picture, Failure> {
        let smallest = Smallest::of(&picture);
        Ok(Picture {
            width: chosen("--width", self.width, picture.width, smallest.width)?,
            height: chosen("--height", self.height, picture.height, smallest.height)?,
            ..picture
        })
    }
}

fn chosen(name: &str, asked: Option<f64>, usual: f64, smallest: f64) -> Result<f64, Failure> {
    match asked {
        Some(side) if side < smallest => {
            let reason =
                format!("{side} does not hold this picture with its labels: give at least {smallest}");
            Err(Failure::no_answer(name, reason))
        }
        Some(side) => Ok(side),
        None => Ok(usual.max(smallest)),
    }
}

/// Larger pictures take gigabytes as a PNG.
const LARGEST_SIDE: f64 = 4000.0;

/// A side of a picture, up to a poster's.
fn side(text: &str) -> Result<f64, String> {
    let side = arguments::positive(text).ok().filter(|side| *side <= LARGEST_SIDE);
    side.ok_or_else(|| format!("give a number above 0, at most {LARGEST_SIDE}"))
}
