//! `libration simulate`: the motion of any system in time.

mod events;
mod report;
mod resume;
mod run;
mod sheet;
mod watch;

use crate::arguments::{self, InitialOptions, SystemOptions, Times};
use crate::failure::Failure;
use crate::figure;
use crate::output::file::NewFile;
use crate::output::{Form, FormOptions, announce};
use events::Watched;
use libration::taylor::Effort;
use resume::Earlier;
use run::Motion;
use std::io::Write;
use std::path::PathBuf;

/// The motion of any system in time: damped, driven, coupled, or given by its equations
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration simulate pendulum --initial theta=60deg --times 0:10:0.5
  libration simulate damped_pendulum --set c=0.1,n=2 \\
    --initial \"theta=60deg,theta'=0\" --times 0:100:0.1 --csv
  libration simulate double_pendulum --times 0:20:0.1 \\
    --initial theta1=120deg,theta2=120deg --figure double.svg
  libration simulate \"x'' = y - x; y'' = x - y\" --initial x=1 \\
    --times 0,1,10 --json
  libration simulate pendulum --initial theta=179deg --times 0:50:1 \\
    --events \"turning,theta'-1\" --json
  libration simulate driven_pendulum --set A=1.2,c=1/2 \\
    --initial theta=0.1 --times 0:100:0.1 --output long.csv
  libration simulate driven_pendulum --set A=1.2,c=1/2 \\
    --times 0:200:0.1 --resume long.csv --output long.csv

Integration starts at t = 0. In the shell, put quotes round whatever has a prime
in it: --initial \"theta=60deg,theta'=0.1\".
Ctrl-C ends a run early: what was computed is written as a complete answer, from
which --resume goes on.")]
pub(crate) struct Simulate {
    #[command(flatten)]
    system: SystemOptions,
    #[command(flatten)]
    initial: InitialOptions,
    /// Times START:STOP:STEP or t1,t2,…, in seconds or with a unit, in order; before 0 the motion runs backward
    #[arg(long, value_parser = arguments::times)]
    times: Times,
    /// The relative error allowed in each step
    #[arg(long, default_value = "1e-12", value_parser = tolerance)]
    tolerance: f64,
    /// Find turning points (turning), passages through rest (crossing), or zeros of a formula, such as theta-0.5
    #[arg(long, value_name = "turning|crossing|EXPR", value_delimiter = ',')]
    events: Vec<String>,
    /// Draw the coordinates against time to FILE.svg or FILE.png instead of listing the samples
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    /// Write the answer to a file, whole or not at all; the endings .json and .csv choose the form
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Go on from the last sample of an earlier answer, JSON or CSV; the new answer begins with the earlier one
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    #[command(flatten)]
    form: FormOptions,
}

impl Simulate {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let model = self.system.model()?;
        let earlier = self.resume.as_deref().map(|path| Earlier::read(path, &model)).transpose()?;
        let initial = match &earlier {
            Some(earlier) if self.initial.is_given() => earlier.begun_from(self.initial.read(&model)?)?,
            Some(earlier) => earlier.initial(),
            None => self.initial.read(&model)?,
        };
        let motion = Motion {
            model: &model,
            initial,
            times: &self.times,
            effort: Effort::to_tolerance(self.tolerance),
            watched: Watched::read(&self.events, &model)?,
            earlier,
        };
        let form = self.form.form_of_file(self.output.as_deref());
        let (ending, written) = match &self.output {
            None => motion.write(form, self.figure.as_deref(), out)?,
            Some(path) => {
                let mut file = NewFile::create(path)?;
                let (ending, drawn) = motion.write(form, self.figure.as_deref(), &mut file)?;
                file.finish()?;
                let answer = format!("{} written: motion of the {}", path.display(), model.title());
                (ending, [vec![answer], drawn].concat())
            }
        };
        let on_screen = if self.output.is_some() { Form::Table } else { form };
        announce(out, on_screen, &written)?;
        out.flush()?;
        ending.into_result(self.output.as_deref())
    }
}

fn tolerance(text: &str) -> Result<f64, String> {
    let [least, greatest] = Effort::TOLERANCES;
    let number = text.trim().parse().ok().filter(|number| (least..=greatest).contains(number));
    number.ok_or_else(|| format!("give a number from {least:e} to {greatest}, such as 1e-12"))
}
