//! `libration stability`: edges of stability and curves of singular points over two parameters.

mod fields;
mod write;

use crate::arguments::{InitialOptions, ParameterSpan, SystemOptions, count, two_parameter_spans};
use crate::figure::stability::Chart;
use crate::output::{FormOptions, announce};
use crate::query_error::{QueryError, argument, option};
use crate::{figure, interrupt, parallel};
use libration::continuation::{BranchError, ChartOptions, StabilityChart};
use libration::progress::Status;
use libration::systems::Model;
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

pub(crate) use fields::answers;

/// Largest number of drive periods in a response.
const MOST_PERIODS: usize = 100;
/// Largest number of lines across each parameter.
const MOST_LINES: usize = 100;
/// Largest depth of secondary branches.
const MOST_GENERATIONS: usize = 6;

/// Stability over two parameters: stability boundaries of an equilibrium, curves of folds, symmetry breakings and period doublings, cusps
///
/// An equilibrium, such as the hanging or the upright pendulum whose pivot moves, has its stability boundaries where a Floquet multiplier leaves the unit
/// circle. Driven motions are followed on some lines of the map, and their singular points from there in both parameters.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration stability vertically_driven_pendulum --set c=0.1 \\
    --map omega=1.5:2.5,a=0:0.2
  libration stability kapitza --set c=0.1 --map omega=5:20,a=0.01:0.6 \\
    --initial theta=180deg --figure upright.svg
  libration stability driven_pendulum --set c=0.1 --map omega=0.7:1,A=0.05:0.4

Where a curve leaves the map its last point is on the edge, so that a map whose
range begins at a value gives the result there to all digits.
Ctrl-C stops early and keeps what is done.")
)]
pub(crate) struct StabilityQuestion {
    #[command(flatten)]
    system: SystemOptions,
    /// Two parameters and their ranges, such as omega=1:3,a=0:0.5
    #[arg(long, value_name = "X=A:B,Y=C:D", value_parser = two_parameter_spans)]
    map: [ParameterSpan; 2],
    #[command(flatten)]
    initial: InitialOptions,
    /// Number of periods of the drive in one period of the response
    #[arg(long, value_name = "N", default_value = "1", value_parser = count::<MOST_PERIODS>)]
    drive_periods: usize,
    /// Maximum depth of secondary branches (symmetry breaking, period doubling)
    #[arg(long, value_name = "N", default_value = "1", value_parser = at_most::<MOST_GENERATIONS>)]
    generations: usize,
    /// Number of lines in each direction on which driven motions are followed; 0 for the equilibrium alone
    #[arg(long, value_name = "N", default_value = "3", value_parser = at_most::<MOST_LINES>)]
    lines: usize,
    /// Draw the map to FILE.svg, .pdf, .png or .json instead of listing the curves
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
}

/// The result to write.
pub(crate) struct StabilityResult {
    model: Model,
    parameters: [String; 2],
    ranges: [[f64; 2]; 2],
    chart: StabilityChart,
}

impl StabilityQuestion {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let answer = self.computed()?;
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::stability::stability(&answer.map()))
        })?;
        answer.write(out, self.form.form(), drawn.is_empty())?;
        announce(out, self.form.form(), &drawn)?;
        out.flush()?;
        match answer.chart.interrupted {
            true => Err(QueryError::cancelled("interrupted: the curves up to then are written")),
            false => Ok(()),
        }
    }

    fn computed(&self) -> Result<StabilityResult, QueryError> {
        let [first, second] = &self.map;
        let model = self.system.model_with_open(&[&first.name, &second.name], &option("map"))?;
        let whole = |number: usize| u32::try_from(number).unwrap_or(1);
        let options = ChartOptions {
            start: self.initial.guess(&model)?,
            drive_periods: whole(self.drive_periods),
            generations: self.generations,
            lines: whole(self.lines),
            ..ChartOptions::default()
        };
        interrupt::listen()?;
        let points = AtomicUsize::new(0);
        let how_far = || format!("{} points of the curve", points.load(Ordering::Relaxed));
        let progress = |status: Status| {
            points.store(status.done, Ordering::Relaxed);
            parallel::update(&how_far)
        };
        let (names, ranges) = ([&first.name[..], &second.name], [first.range, second.range]);
        let chart = parallel::with_progress(how_far, || {
            StabilityChart::over(model.equation(), names, ranges, &options, &progress)
        });
        let parameters = names.map(str::to_owned);
        Ok(StabilityResult { chart: chart.map_err(failure)?, model, parameters, ranges })
    }
}

impl StabilityResult {
    /// The content of the picture.
    fn map(&self) -> Chart<'_> {
        Chart { model: &self.model, parameters: &self.parameters, ranges: self.ranges, chart: &self.chart }
    }
}

fn failure(error: BranchError) -> QueryError {
    match error {
        BranchError::Range { .. } => QueryError::usage(option("map"), error),
        BranchError::NotDriven => QueryError::no_result(argument("SYSTEM|EQUATION"), error),
        _ => QueryError::no_result("stability", error),
    }
}

fn at_most<const MOST: usize>(text: &str) -> Result<usize, String> {
    let number = text.trim().parse().ok().filter(|number| *number <= MOST);
    number.ok_or_else(|| format!("give a whole number from 0 to {MOST}"))
}
