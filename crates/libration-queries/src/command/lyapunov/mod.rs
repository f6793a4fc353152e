//! `libration lyapunov`: the largest Lyapunov exponent, with its convergence and a verdict.

mod write;

use crate::arguments::{InitialOptions, SystemOptions, count, not_negative, positive};
use crate::output::{FormOptions, announce};
use crate::query_error::QueryError;
use crate::{figure, interrupt, parallel};
use libration::chaos::{
    Doubt, LyapunovError, LyapunovExponent, LyapunovVerdict, Schedule, lyapunov_exponent,
};
use libration::progress::{Stage, Status};
use libration::systems::Model;
use libration::taylor::{Cause, Effort, IntegrationError, Moment};
use std::io::Write;
use std::path::PathBuf;
use std::sync::Mutex;

pub(crate) use write::answers;

/// More intervals than this are never requested.
const MOST_INTERVALS: usize = 100_000_000;

/// The largest Lyapunov exponent: the rate at which neighbouring motions diverge, and whether the motion is chaotic
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration lyapunov driven_pendulum --set A=1.5,c=1/2 --initial theta=0.2 \\
    --intervals 300
  libration lyapunov roessler --initial x=1,y=1 --intervals 50
  libration lyapunov double_pendulum --intervals 30 \\
    --initial theta1=120deg,theta2=120deg
  libration lyapunov \"x'' = -x - 2 x y; y'' = -y - x^2 + y^2\" \\
    --initial \"y=-0.15,x'=0.5555\" --intervals 100 --figure convergence.svg

`chaotic` requires evidence: deviations that grow by e^100, in every part of the
run, from the motion and from two neighbouring ones, and no passage so close to a
separatrix that all digits are lost. `regular` follows from a theorem, or was
observed over the time measured. Otherwise the verdict is `undecided` and the
reason states what is missing. Ctrl-C stops early and keeps the estimate so far.")
)]
pub(crate) struct Lyapunov {
    #[command(flatten)]
    system: SystemOptions,
    #[command(flatten)]
    initial: InitialOptions,
    /// Number of intervals to measure, each about one period of the motion
    #[arg(long, value_name = "N", default_value = "1000", value_parser = count::<MOST_INTERVALS>, conflicts_with = "time")]
    intervals: usize,
    /// Duration of the measurement in seconds, instead of a number of intervals
    #[arg(long, value_name = "T", value_parser = positive)]
    time: Option<f64>,
    /// Time before the measurement, in seconds [default: 100 intervals]
    #[arg(long, value_name = "T", value_parser = not_negative)]
    transient: Option<f64>,
    /// The relative error allowed in each step
    #[arg(long, default_value = "1e-13", value_parser = positive)]
    tolerance: f64,
    /// Draw the convergence of the exponent to FILE.svg, .pdf, .png or .json instead of listing it
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
}

/// The exponent with the query.
pub(crate) struct LyapunovResult<'a> {
    pub(crate) model: &'a Model,
    pub(crate) initial: Vec<f64>,
    pub(crate) schedule: Schedule,
    pub(crate) exponent: LyapunovExponent,
}

impl Lyapunov {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let model = self.system.model()?;
        let initial = self.initial.read(&model)?.state;
        let start = Moment { time: 0.0, state: initial.clone() };
        let effort = Effort::to_tolerance(self.tolerance);
        let schedule = self.schedule(&model, &start, &effort).map_err(failure)?;
        interrupt::listen()?;
        let exponent = measured(&model, &start, &schedule, &effort).map_err(failure)?;
        let answer = LyapunovResult { model: &model, initial, schedule, exponent };
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::lyapunov::convergence(&model, &answer.initial, &answer.exponent))
        })?;
        answer.write(out, self.form.form(), drawn.is_empty())?;
        announce(out, self.form.form(), &drawn)?;
        out.flush()?;
        match answer.exponent.verdict {
            LyapunovVerdict::Undecided(Doubt::Stopped(Cause::Interrupted)) => {
                Err(QueryError::cancelled("interrupted: the estimate up to then is written"))
            }
            LyapunovVerdict::Undecided(Doubt::Stopped(cause)) => {
                Err(QueryError::no_result("lyapunov", format!("{cause}: the estimate up to then is written")))
            }
            _ => Ok(()),
        }
    }

    fn schedule(&self, model: &Model, start: &Moment, effort: &Effort) -> Result<Schedule, LyapunovError> {
        let natural = Schedule::natural(model.equation(), start, self.intervals, effort)?;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "positive, and cut at the most"
        )]
        let in_time = |time: f64| (time / natural.interval).ceil().min(1e8) as usize;
        Ok(Schedule {
            transient: self.transient.unwrap_or(natural.transient),
            intervals: self.time.map_or(natural.intervals, in_time),
            ..natural
        })
    }
}

fn measured(
    model: &Model,
    start: &Moment,
    schedule: &Schedule,
    effort: &Effort,
) -> Result<LyapunovExponent, LyapunovError> {
    let latest = Mutex::new(None);
    let how_far = || {
        let latest: Option<Status> = latest.lock().ok().and_then(|latest| *latest);
        let beside = latest.is_some_and(|latest| latest.stage != Stage::Motion { number: 0 });
        let which = if beside { " of a neighbouring motion" } else { "" };
        format!("{} of {} intervals{which}", latest.map_or(0, |latest| latest.done), schedule.intervals)
    };
    let progress = |status: Status| {
        if let Ok(mut latest) = latest.lock() {
            *latest = Some(status);
        }
        parallel::update(&how_far)
    };
    parallel::with_progress(how_far, || {
        lyapunov_exponent(model.equation(), start, schedule, effort, &progress)
    })
}

fn failure(error: LyapunovError) -> QueryError {
    match &error {
        LyapunovError::Nothing(Cause::Interrupted)
        | LyapunovError::Integration(IntegrationError::Stopped { cause: Cause::Interrupted, .. }) => {
            QueryError::cancelled("interrupted before the first measurement")
        }
        _ => QueryError::no_result("lyapunov", error),
    }
}
