//! `libration figure`: the pictures.

mod errors;
mod motion;
mod phase;
mod releases;
mod report;
mod series;
mod spectrum;
pub(crate) mod trajectories;

use crate::figure::{Layout, file};
use crate::interrupt;
use crate::output::description::Answers;
use crate::output::{FormOptions, announce};
use crate::query_error::QueryError;
use std::io::Write;
use std::path::PathBuf;

/// Draw a picture: errors of the formulas, motions, the phase portrait, harmonics, perturbation series, spectra
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration figure errors --output errors.svg
  libration figure errors --formulas bernoulli,carvalhaes_suppes \\
    --from 60deg --output errors.png
  libration figure motion --amplitudes 30deg,90deg,179deg --output motion.svg
  libration figure phase --output phase.svg
  libration figure spectrum --amplitudes 60deg,150deg --output spectrum.png
  libration figure series pendulum --output series.svg
  libration figure series duffing --amplitudes 0.5,0.9,1.1 --order 41 \\
    --output terms.png
  libration figure trajectories damped_pendulum --over c=0.05,0.2,2 \\
    --initial theta=170deg --to 40s --output damping.svg")
)]
pub(crate) struct Figure {
    #[command(subcommand)]
    picture: FigureSubject,
}

#[derive(Debug, clap::Subcommand)]
enum FigureSubject {
    Errors(errors::ErrorsFigure),
    Motion(motion::MotionFigure),
    Phase(phase::Phase),
    Spectrum(spectrum::Spectrum),
    Series(series::Series),
    Trajectories(trajectories::Trajectories),
}

/// The options of every picture.
#[derive(Clone, Debug, clap::Args)]
struct PictureOptions {
    /// The file to write, FILE.svg, .pdf, .png or .json
    #[arg(id = "figure", long = "output", short = 'o', value_name = "FILE", value_parser = file::drawable)]
    output: PathBuf,
    #[command(flatten)]
    layout: Layout,
    #[command(flatten)]
    form: FormOptions,
}

impl Figure {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let (name, options, picture) = match &self.picture {
            FigureSubject::Errors(subject) => ("errors", &subject.options, subject.picture()?),
            FigureSubject::Motion(subject) => ("motion", &subject.options, subject.picture()?),
            FigureSubject::Phase(subject) => ("phase", &subject.options, subject.picture()?),
            FigureSubject::Spectrum(subject) => ("spectrum", &subject.options, subject.picture()?),
            FigureSubject::Series(subject) => ("series", &subject.options, subject.picture()?),
            FigureSubject::Trajectories(subject) => ("trajectories", &subject.options, subject.picture()?),
        };
        let drawn = file::finished(Some(&options.output), &options.layout, &picture)?;
        report::write(out, options.form.form(), name, &options.output, &picture)?;
        announce(out, options.form.form(), &drawn)?;
        interrupt::ended_early("the curves")
    }
}

pub(crate) fn answers() -> Vec<Answers> {
    report::answers()
}
