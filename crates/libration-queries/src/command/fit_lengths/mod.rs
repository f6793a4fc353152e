//! `libration fit lengths`: measured periods against length, with an offset of the lengths.

mod fields;
mod input;
mod report;
mod write;

use crate::arguments::{CorrectionOptions, PlaceOptions};
use crate::document;
use crate::figure;
use crate::output::groups::{self, Groups};
use crate::output::normal_gravity::NormalGravity;
use crate::output::{FormOptions, announce};
use crate::query_error::{QueryError, option};
use fields::FitLengthsResult;
use input::{FitLengthsInput, LengthFile};
use libration::quantity::Quantity;
use libration_lab::fit::{self, BudgetInput, Contribution, LengthsFit, LengthsOptions, LengthsPendulum};
use std::io::Write;
use std::path::PathBuf;

pub(crate) use fields::answers;

/// Measured periods against length: gravity, and the offset common to all lengths
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration fit lengths examples/lengths_synthetic.csv
  libration fit lengths examples/lengths_synthetic.csv --amplitude 10deg \\
    --figure lengths.svg
  libration fit lengths examples/lengths_synthetic.csv \\
    --columns length,period,-,sigma_period --length-unit m
  libration fit lengths examples/class/groups.csv --clock 0.1%
  libration fit lengths examples/lengths_synthetic.csv --bob-radius 25mm --json
  libration fit lengths examples/lengths_synthetic.csv --latitude 48.1deg \\
    --elevation 520m --report lengths.html
  libration fit lengths examples/class/ten_swings.csv --role 4=ignore
  libration fit lengths examples/bar_synthetic.csv --figure bar.svg
  libration fit lengths examples/reversible_synthetic.csv --model reversible \\
    --edges 0.9935m±0.0001m

T² = 4π²R²(L + δ)/g is fitted by weighted least squares, where R = T/T0 at the
amplitude. A string measured without its bob gives an offset δ and leaves g
unbiased. The moment of inertia of a bob that is given is part of every law;
without it a radius of gyration is fitted. A bar has T²h = 4π²R²(k² + h²)/g at a distance h = |L + δ| from its
centre of mass, and a reversible pendulum 8π²/g = (T1² + T2²)/(h1 + h2) +
(T1² − T2²)/(h1 − h2) (Bessel), h1 + h2 being the distance of the edges.")
)]
pub(crate) struct FitLengths {
    #[command(flatten)]
    input: FitLengthsInput,
    /// The pendulum: simple, a bar turned about points at these distances from its centre of mass or positions on a scale along it, or
    /// reversible with two knife edges [default: a bar if the periods show it, else simple]
    #[arg(long, value_enum)]
    model: Option<Model>,
    /// Distance of the knife edges of a reversible pendulum [default: the sum of their distances from the centre of mass]
    #[arg(long, value_name = "LENGTH", value_parser = crate::arguments::length_with_uncertainty)]
    edges: Option<Quantity>,
    /// Relative uncertainty of the clock or frame rate, such as 0.1% if 29.97 frames/s may have been taken as 30
    #[arg(long, value_name = "PART", value_parser = crate::arguments::part)]
    clock: Option<f64>,
    /// Draw the data, the line and the residuals to FILE.svg, .pdf, .png or .json
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    /// Write a report with pictures to FILE.html, or to FILE.md or FILE.tex with the pictures next to it
    #[arg(long, value_name = "FILE", value_parser = document::name)]
    report: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
    #[command(flatten)]
    corrections: CorrectionOptions,
    #[command(flatten)]
    place: PlaceOptions,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Model {
    Simple,
    Bar,
    Reversible,
}

impl Model {
    fn pendulum(self) -> LengthsPendulum {
        match self {
            Self::Simple => LengthsPendulum::Simple,
            Self::Bar => LengthsPendulum::Bar,
            Self::Reversible => LengthsPendulum::Reversible,
        }
    }
}

impl FitLengths {
    /// Refuses options that the model does not use.
    fn check(&self) -> Result<(), QueryError> {
        let is_reversible = self.model == Some(Model::Reversible);
        if self.edges.is_some() && !is_reversible {
            return Err(QueryError::usage(option("edges"), "it belongs to <--model=reversible>"));
        }
        let of_string = self.corrections.of_string();
        if let Some(name) = of_string.filter(|_| !matches!(self.model, None | Some(Model::Simple))) {
            return Err(QueryError::usage(option(name), "a bar has no bob or string: leave it out"));
        }
        Ok(())
    }

    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let mut table = self.input.read()?;
        let corrections = self.corrections.corrections();
        let radius = corrections.bob.map(|bob| bob.radius_of_ball());
        let options = LengthsOptions {
            corrections,
            clock: self.clock,
            shared_timing: table.shared_timing.clone(),
            pendulum: self.model.map(Model::pendulum),
            edges: self.edges,
        };
        self.check()?;
        let fit = fit::fit_lengths(&table.measured.table, &options);
        let fit = fit.map_err(|error| {
            let refused = self.input.no_answer(&error);
            let mut pairs = table.measured.lengths.windows(2);
            if pairs.all(|pair| pair[0].total_cmp(&pair[1]).is_eq()) {
                refused.with_hint(ONE_LENGTH)
            } else {
                refused
            }
        })?;
        if fit.weighted_by_rounding {
            table.weight_by_rounding();
        }
        let mut written = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::lengths::fitted(&table.measured, fit.best(), radius))
        })?;
        let groups = groups_of(&table, &fit, &options);
        let normal = self.place.normal_gravity()?;
        let normal = normal.map(|normal| NormalGravity { measured: fit.gravity(), normal });
        let answer = FitLengthsResult { table: &table, fit: &fit, groups: groups.as_ref(), normal };
        if let Some(path) = &self.report {
            written.push(document::write(path, &report::document(&answer, &self.input.name(), radius))?);
        }
        answer.write(out, self.form.form())?;
        Ok(announce(out, self.form.form(), &written)?)
    }
}

/// The way to g with a single length.
const ONE_LENGTH: &str = "one length gives g by <libration fit periods> with <--length> and <--amplitude>";

/// Gravity of each group, if the rows have groups; they share everything except the fitted line.
fn groups_of(read: &LengthFile, fit: &LengthsFit, options: &LengthsOptions) -> Option<Groups> {
    let contributions = fit.combined.contributions.iter();
    let shared = contributions
        .filter(|contribution| !is_own(contribution))
        .map(|contribution| contribution.change() * contribution.change());
    let of_group = LengthsOptions { corrections: options.corrections, ..LengthsOptions::default() };
    let of_rows = |rows: &[usize]| {
        let fit = fit::fit_lengths(&read.measured.table.only(rows), &of_group)
            .map_err(|error| error.to_string())?;
        let slope = fit.combined.contributions.iter().find(|contribution| is_own(contribution));
        Ok((fit.best().g, slope.map_or(f64::INFINITY, |slope| slope.degrees_of_freedom)))
    };
    Groups::fitted(read.groups.as_ref()?, &groups::GRAVITY, shared.sum::<f64>().sqrt(), of_rows)
}

/// Returns `true` if a contribution comes from the rows themselves.
fn is_own(contribution: &Contribution) -> bool {
    matches!(contribution.input, BudgetInput::Slope)
}
