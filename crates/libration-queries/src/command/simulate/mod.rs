//! `libration simulate`: the motion of any system in time.

mod both_ways;
mod csv;
mod each;
mod ending;
mod events;
mod fields;
mod json;
mod motion;
mod precision;
mod report;
pub(crate) mod resume;
mod rows;
mod run;
mod sheet;
mod tally;
mod watch;

use crate::arguments::{self, InitialOptions, PendulumSystemOptions, Times, Tolerances};
use crate::figure;
use crate::figure::section::StateAxis;
use crate::output::description::Answers;
use crate::output::file::NewFile;
use crate::output::leftover::state_of;
use crate::output::{Form, FormOptions, announce};
use crate::query_error::{Parameter, QueryError, option};
use ending::Ending;
use events::{UntilOptions, Watched};
use libration::systems::Model;
use motion::SimulatedMotion;
use resume::{Earlier, Keeper, RunParameters};
use run::RunOutcome;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The fields of results about one motion, and about many.
pub(crate) fn answers() -> Vec<Answers> {
    vec![fields::answers(), each::answers()]
}

/// The motion of any system in time: damped, driven, coupled, or given by its equations
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration simulate pendulum --initial theta=60deg --times 0:10:0.5
  libration simulate damped_pendulum --set c=0.1,n=2 \\
    --initial \"theta=60deg,theta'=0\" --times 0:100:0.1 --csv
  libration simulate double_pendulum --times 0:20:0.1 \\
    --initial theta1=120deg,theta2=120deg --figure double.svg
  libration simulate double_pendulum --times 0:20:1 --animate \\
    --initial theta1=120deg,theta2=120deg --figure moving.svg
  libration simulate damped_pendulum --set c=0.1 --initial theta=170deg \\
    --times 0:60:1 --figure plane.svg --axes \"theta,theta'\"
  libration simulate \"x'' = y - x; y'' = x - y\" --initial x=1 \\
    --times 0,1,10 --json
  libration simulate \"x' = x - x^2\" --initial x=0.5 --times=-10:10:2
  libration simulate lorenz --initial x=1,y=1,z=1 --times 0:20:1 \\
    --figure lorenz.svg --axes x,z
  libration simulate \"x' = x - x*y; y' = x*y - y\" --initial x=2,y=1 \\
    --times 0:20:1 --events turning
  libration simulate pendulum --initial theta=179deg --times 0:50:5 \\
    --until \"theta = 0\" --direction rising --count 2
  libration simulate fermi_pasta_ulam --set n=8 --times 0:100:50 \\
    --initial \"x[i]=sin(pi*i/9)\" --csv
  libration simulate \"x[i]'' = x[i+1] - 2*x[i] + x[i-1], i = 1..5; \\
    x[0] = sin(t)/9\" --initial x1=0 --times 0:20:5 --csv
  libration simulate pendulum --initial theta=179deg --times 0:50:1 \\
    --events \"turning,theta'-1\" --json
  libration simulate \"x'' = -max(x, 0)^1.5\" --times 0:5:0.5 \\
    --initial \"x=-1,x'=1\" --columns \"energy = x'^2/2 + max(x, 0)^2.5/2.5\"
  libration simulate driven_pendulum --set A=1.2,c=1/2 \\
    --initial theta=0.1 --times 0:100:0.1 --output long.csv
  libration simulate driven_pendulum --set A=1.2,c=1/2 \\
    --times 0:200:0.1 --resume long.csv --output long.csv
  libration simulate pendulum --each examples/starts.csv --times 0:10:1

An equation with an index and a range stands for many. Members outside the range
are zero, or as defined: x[0] = sin(t), x[33] = x[1].

Integration starts at t = 0. In the shell, quote whatever contains a prime:
--initial \"theta=60deg,theta'=0.1\".
States and columns are shown to the digits that their errors leave, as far as
double precision determines the motion; --json and --csv have the errors, and all
digits.
Ctrl-C stops a run early: what was computed is written as complete output, and
--resume continues from there. The result equals that of a single run, byte for
byte. With long.csv comes long.csv.state, which records the system and where the
integration stands; --resume needs it, and also continues a killed run.")
)]
pub(crate) struct Simulate {
    #[command(flatten)]
    system: PendulumSystemOptions,
    #[command(flatten)]
    initial: InitialOptions,
    /// One motion for each line of a CSV file (- for standard input) whose first line names parameters and initial values, and may have a column `name`
    #[arg(long, value_name = "FILE")]
    each: Option<PathBuf>,
    /// Times START:STOP:STEP or t1,t2,…, in seconds or with a unit, leading away from 0, or ascending through it; negative ones run backward
    #[arg(long, value_parser = arguments::times)]
    times: Times,
    /// The relative error allowed in each step, for all coordinates or each by its name: 1e-12, "phi=1e-6", "1e-12, phi=1e-6"
    #[arg(long, default_value = "1e-12", value_parser = arguments::tolerances)]
    tolerance: Tolerances,
    /// Find turning points (turning), crossings of the equilibrium (crossing), or zeros of a formula, such as theta-0.5
    #[arg(long, value_name = "turning|crossing|EXPR")]
    events: Vec<String>,
    #[command(flatten)]
    until: UntilOptions,
    /// Formulas of the state, the time t and the parameters as further columns, such as "energy = x'^2/2 - cos(x), p = 2*x'"
    #[arg(long, value_name = "NAME=FORMULA,…")]
    columns: Option<String>,
    /// Derivatives of the motion with respect to parameters and initial values, as further columns, such as "c, theta": dtheta/dc, dtheta/dtheta(0)
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    sensitivity: Vec<String>,
    /// Do not estimate the errors of the states, which saves time
    #[arg(long)]
    no_errors: bool,
    /// Draw the coordinates and the formulas of --columns against time to FILE.svg, .pdf, .png or .json instead of listing the samples
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    /// Draw one state variable against another instead of the coordinates against time, such as theta,theta'
    #[arg(long, value_name = "NAME,NAME", requires = "figure")]
    axes: Option<String>,
    /// Animate the bodies next to the curves (an SVG animation, for browsers)
    #[arg(long, requires = "figure", conflicts_with = "axes")]
    animate: bool,
    #[command(flatten)]
    layout: figure::Layout,
    /// Write the output to a file, which is replaced only when complete, or to a stream; the extensions .json and .csv choose the
    /// format, - is standard output
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Continue an earlier run from its JSON output, or its CSV output with FILE.state; the new output includes the earlier one
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    #[command(flatten)]
    form: FormOptions,
}

impl Simulate {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        match &self.each {
            Some(path) => self.answer_each(path, out),
            None => self.answer_one(out),
        }
    }

    fn answer_one(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let model = self.system.model()?;
        let watched = Watched::read(&self.events, &self.until, &model)?;
        let observables = self.columns.as_deref();
        let observables =
            observables.map(|text| arguments::columns(&option("columns"), text, &model)).transpose()?;
        self.refuse_beside_sensitivities()?;
        let sensitivities = arguments::sensitivities(&self.sensitivity, &self.system.given()?, &model)?;
        let asked = self.initial.is_given().then(|| self.initial.read(&model)).transpose()?;
        let (initial, earlier) = match &self.resume {
            Some(path) => {
                let earlier = Earlier::find(path, &self.question(&model, &watched, vec![]), &self.times)?;
                (earlier.initial(asked)?, Some(earlier))
            }
            None => (asked.map_or_else(|| self.initial.read(&model), Ok)?, None),
        };
        let motion = SimulatedMotion {
            model: &model,
            question: self.question(&model, &watched, initial.state.clone()),
            initial,
            times: &self.times,
            tolerances: &self.tolerance,
            watched: &watched,
            observables: observables.as_ref(),
            sensitivities: sensitivities.as_ref(),
            earlier,
            no_errors: self.reason_for_no_errors(),
        };
        let form = self.form.form_of_file(self.output.as_deref());
        let axes =
            self.axes.as_deref().map(|names| arguments::places_in_state(&model, &option("axes"), names));
        let axes =
            axes.transpose()?.map(|components| components.map(|component| StateAxis::new(&model, component)));
        let path = self.figure.as_deref();
        let figure = figure::file::is_drawn(path).then_some(run::MotionPicture {
            path,
            layout: &self.layout,
            axes,
            animate: self.animate,
        });
        let (ending, written) = match &self.output {
            None => {
                let RunOutcome { ending, drawn, .. } = motion.write(form, figure, out, None)?;
                (ending, drawn)
            }
            Some(path) => {
                let (ending, drawn) = write_file(motion, form, figure, path)?;
                let answer =
                    format!("{} written: motion of {}", path.display(), figure::names::subject(&model));
                (ending, [vec![answer], drawn].concat())
            }
        };
        let on_screen = if self.output.is_some() { Form::Table } else { form };
        announce(out, on_screen, &written)?;
        out.flush()?;
        ending.into_result(self.output.as_deref().filter(|_| form != Form::Table))
    }

    /// Refuses options that are incompatible with sensitivities.
    fn refuse_beside_sensitivities(&self) -> Result<(), QueryError> {
        let refused = |about: Parameter, reason: &str| Err(QueryError::usage(about, reason));
        match () {
            () if self.sensitivity.is_empty() => Ok(()),
            () if self.resume.is_some() => refused(
                option("resume"),
                "states are kept without the derivatives of <--sensitivity>: give one of them",
            ),
            () if self.figure.is_some() => refused(
                option("figure"),
                "it does not draw the derivatives of <--sensitivity>: give one of them",
            ),
            () => Ok(()),
        }
    }

    /// The reason why errors are not estimated; `None` if they are.
    fn reason_for_no_errors(&self) -> Option<&'static str> {
        match () {
            () if self.each.is_some() => Some("--each"),
            () if self.figure.is_some() => Some("--figure"),
            () if self.no_errors => Some("--no-errors"),
            () => None,
        }
    }

    /// The question about a motion that begins in this state.
    fn question(&self, model: &Model, watched: &Watched, initial: Vec<f64>) -> RunParameters {
        RunParameters {
            system: model.key().map(str::to_owned),
            equations: model.equation().to_string(),
            state: model.state_names(),
            initial,
            tolerance: self.tolerance.usual,
            own_tolerances: self.tolerance.separate.clone(),
            events: watched.names(),
            errors: self.reason_for_no_errors().is_none(),
            columns: self
                .columns
                .iter()
                .chain(&self.sensitivity)
                .map(|column| column.trim().to_owned())
                .collect(),
        }
    }
}

/// Writes the output to its file, and with a CSV file the record for its continuation; then the ending, and the names of pictures.
fn write_file(
    motion: SimulatedMotion<'_>,
    form: Form,
    figure: Option<run::MotionPicture<'_>>,
    path: &Path,
) -> Result<(Ending, Vec<String>), QueryError> {
    let mut file = NewFile::create(path)?;
    let paths = file.places().filter(|_| form == Form::Csv);
    let keeper = paths.as_ref().map(|[_, unfinished]| Keeper::new(state_of(unfinished)));
    let RunOutcome { ending, state, drawn } = motion.write(form, figure, &mut file, keeper)?;
    // An unfinished file that was gone on from is left to be removed now.
    drop(motion);
    file.finish()?;
    if let Some([target, _]) = paths {
        state.write(&state_of(&target))?;
    }
    Ok((ending, drawn))
}
