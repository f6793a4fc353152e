//! `libration figure trajectories`: motions of a system from several starts, or with several values of a parameter.

use super::PictureOptions;
use crate::arguments::{
    self, CoordinateName, ParameterRange, PendulumSystemOptions, SeveralInitialOptions, parameter_range,
    place_in_state, places_in_state,
};
use crate::figure::chart::Picture;
use crate::figure::parameters::{AngleUnit, of_model, of_start, said};
use crate::figure::section::StateAxis;
use crate::figure::trajectories::{Sampled, against_time, in_plane, spectra};
use crate::interrupt;
use crate::output::number::{count, short};
use crate::query_error::{Parameter, QueryError, option};
use libration::spectrum::{Spectrum, SpectrumError};
use libration::systems::Model;
use libration::taylor::{
    Cause, DenseSolution, Effort, IntegrationError, Moment, Step, System, integrate_stepwise,
};

/// Motions of any system in one picture: against time, in the plane of two state variables, or their spectra
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration figure trajectories pendulum --initial theta=30deg \\
    --initial theta=150deg --to 20s --output swings.svg
  libration figure trajectories damped_pendulum --over c=0.05,0.2,2 \\
    --initial theta=170deg --to 40s --output damping.svg
  libration figure trajectories \"x'' = x - x^3\" --initial \"x=1,x'=0.2\" \\
    --initial \"x=1,x'=0.9\" --to 30s --axes \"x,x'\" --output plane.svg
  libration figure trajectories double_pendulum --initial theta1=10deg \\
    --initial theta1=120deg --to 300s --spectrum theta1 \\
    --output spectrum.svg

Motions begin at t = 0. A spectrum has a line for each frequency of the motion,
as high as its amplitude; a motion of seven or more periods separates them.")
)]
pub(super) struct Trajectories {
    #[command(flatten)]
    system: PendulumSystemOptions,
    #[command(flatten)]
    initial: SeveralInitialOptions,
    /// A parameter and its values, with a motion for each, such as c=0.05,0.2,2 or A=1:1.2:0.1
    #[arg(long, value_name = "NAME=VALUES", value_parser = parameter_range)]
    over: Option<ParameterRange>,
    /// The first time that is drawn, in seconds or with a unit
    #[arg(long, value_name = "TIME", default_value = "0", value_parser = arguments::finite_time)]
    from: f64,
    /// The last time that is drawn
    #[arg(long, alias = "until", value_name = "TIME", default_value = "60", value_parser = arguments::finite_time)]
    to: f64,
    /// The state variable that the picture shows [default: the first coordinate]
    #[arg(long, alias = "show", value_name = "NAME", conflicts_with_all = ["axes", "spectrum"])]
    axis: Option<CoordinateName>,
    /// Draw one state variable against another, such as theta,theta'
    #[arg(long, value_name = "NAME,NAME", conflicts_with = "spectrum")]
    axes: Option<String>,
    /// Draw the spectrum of a state variable, such as theta
    #[arg(long, value_name = "NAME")]
    spectrum: Option<CoordinateName>,
    #[command(flatten)]
    pub(super) options: PictureOptions,
}

/// More curves than a picture can keep apart.
const MOST_MOTIONS: usize = 12;
/// Points of a curve.
const POINTS: usize = 6000;
/// Motions of more steps are too long for a spectrum, as they would take gigabytes.
const MOST_STEPS: usize = 200_000;

/// Relative error of a step, far below the resolution of a picture.
const EFFORT: Effort = Effort::to_tolerance(1e-12);

/// A motion to be integrated.
struct DrawnMotion {
    model: Model,
    system: System,
    start: Moment,
    label: String,
}

impl Trajectories {
    pub(super) fn picture(&self) -> Result<Picture, QueryError> {
        if !(0.0 <= self.from && self.from < self.to) {
            let reason =
                format!("{} s to {} s: give times from 0 on, the last after the first", self.from, self.to);
            return Err(QueryError::usage(option("to"), reason));
        }
        let runs = self.runs()?;
        let model = &runs[0].model;
        let axis = |index| StateAxis::new(model, index);
        let one = |argument: Parameter, name: &Option<CoordinateName>| {
            name.as_deref().map(|name| place_in_state(model, &argument, name).map(axis)).transpose()
        };
        let axes =
            self.axes.as_deref().map(|names| places_in_state(model, &option("axes"), names)).transpose()?;
        let (of_spectrum, show) =
            (one(option("spectrum"), &self.spectrum)?, one(option("axis"), &self.axis)?);
        interrupt::listen()?;
        let picture = match (axes, &of_spectrum) {
            (Some(axes), _) => in_plane(model, &self.sampled(&runs)?, &axes.map(axis)),
            (_, Some(shown)) => spectra(model, &self.spectra(&runs, shown)?, shown),
            _ => against_time(model, &self.sampled(&runs)?, &show.unwrap_or_else(|| axis(0))),
        };
        Ok(picture.with_parameters(common(&runs.iter().map(DrawnMotion::made_with).collect::<Vec<_>>())))
    }

    /// Every start with every value of the parameter.
    fn runs(&self) -> Result<Vec<DrawnMotion>, QueryError> {
        let values = self.over.as_ref().map_or(vec![None], |over| {
            over.values.iter().map(|value| Some((over.name.as_str(), *value))).collect()
        });
        let mut runs = vec![];
        for value in values.into_iter().take(MOST_MOTIONS + 1) {
            let model = self.system.model_over(value)?;
            let system = model.system().map_err(|error| QueryError::usage(option("set"), error))?;
            let label = value.map_or_else(String::new, |(name, value)| said(name, value, ""));
            for initial in self.initial.read(&model)? {
                let start = Moment { time: 0.0, state: initial.state };
                runs.push(DrawnMotion {
                    model: model.clone(),
                    system: system.clone(),
                    start,
                    label: label.clone(),
                });
            }
        }
        if runs.len() > MOST_MOTIONS {
            let reason = format!(
                "a picture distinguishes at most {MOST_MOTIONS} motions: give fewer starts and values"
            );
            return Err(QueryError::usage("figure trajectories", reason));
        }
        label_starts(&mut runs);
        Ok(runs)
    }

    /// The motions that are done before a cancellation.
    fn sampled(&self, runs: &[DrawnMotion]) -> Result<Vec<Sampled>, QueryError> {
        let time = |index: usize| self.from + (self.to - self.from) * (count(index) / count(POINTS - 1));
        done(runs, |run| {
            let mut sampled = Sampled { label: run.label.clone(), times: vec![], states: vec![] };
            run.integrate(self.to, &EFFORT, |step| {
                while sampled.times.len() < POINTS && time(sampled.times.len()) <= step.end() {
                    let now = time(sampled.times.len());
                    sampled.times.push(now);
                    sampled.states.push(step.state_at(now));
                }
            })?;
            Ok(sampled)
        })
    }

    /// The spectra of the motions that are done before a cancellation.
    fn spectra(
        &self,
        runs: &[DrawnMotion],
        shown: &StateAxis,
    ) -> Result<Vec<(String, Spectrum)>, QueryError> {
        done(runs, |run| {
            let mut motion = DenseSolution::default();
            run.integrate(self.to, &Effort { most_steps: MOST_STEPS, ..EFFORT }, |step| {
                if step.end() > self.from {
                    motion.push(step);
                }
            })?;
            let spectrum = Spectrum::of_motion(&motion, shown.component, [self.from, self.to]);
            Ok((run.label.clone(), spectrum.map_err(|error| no_spectrum(&error, run, shown))?))
        })
    }
}

/// The results of the runs that are done before a cancellation: at least one.
fn done<T>(
    runs: &[DrawnMotion],
    each: impl Fn(&DrawnMotion) -> Result<T, QueryError>,
) -> Result<Vec<T>, QueryError> {
    let mut done = vec![];
    for run in runs {
        match each(run) {
            Err(error) if error.is_cancelled() && !done.is_empty() => break,
            other => done.push(other?),
        }
    }
    Ok(done)
}

/// A coordinate that grows has a velocity that may not.
fn no_spectrum(error: &SpectrumError, run: &DrawnMotion, shown: &StateAxis) -> QueryError {
    let component = shown.component;
    let reason = match (error, run.system.layout().velocity(component)) {
        (SpectrumError::Trend { first, last }, Some(_)) => {
            let name = shown.name();
            format!(
                "{name} goes from {} to {} and swings little about that: draw the spectrum of {name}′",
                short(*first, 4),
                short(*last, 4)
            )
        }
        _ => error.to_string(),
    };
    QueryError::no_result(option("spectrum"), reason)
}

impl DrawnMotion {
    /// Integrates from the start to a time and shows each step.
    fn integrate(
        &self,
        until: f64,
        effort: &Effort,
        mut see: impl FnMut(&Step<'_>),
    ) -> Result<(), QueryError> {
        let integrated = integrate_stepwise(&self.system, &self.start, &[until], effort, |step| {
            see(step);
            interrupt::check()
        });
        match integrated {
            Ok(_) => Ok(()),
            Err(IntegrationError::Stopped { cause: Cause::Interrupted, .. }) => {
                Err(QueryError::cancelled("interrupted before a motion was done"))
            }
            Err(error) => Err(QueryError::no_result("figure trajectories", error)),
        }
    }

    /// The parameters and the start of the run.
    fn made_with(&self) -> Vec<String> {
        [of_model(&self.model), self.numbers_of_start()].concat()
    }

    fn numbers_of_start(&self) -> Vec<String> {
        of_start(&self.model, &self.start.state, AngleUnit::Degrees)
    }
}

/// Adds to each label the initial values that differ between the motions.
fn label_starts(runs: &mut [DrawnMotion]) {
    let starts: Vec<Vec<String>> = runs.iter().map(DrawnMotion::numbers_of_start).collect();
    let shared = common(&starts);
    for (run, start) in runs.iter_mut().zip(starts) {
        let values = start.into_iter().filter(|number| !shared.contains(number));
        let parameter = Some(run.label.clone()).filter(|label| !label.is_empty());
        run.label = parameter.into_iter().chain(values).collect::<Vec<_>>().join(", ");
    }
    if runs.len() > 1 {
        runs.iter_mut().filter(|run| run.label.is_empty()).for_each(|run| run.label = "from rest".to_owned());
    }
}

/// The items that all lists have.
pub fn common(lists: &[Vec<String>]) -> Vec<String> {
    let Some((first, others)) = lists.split_first() else { return vec![] };
    first.iter().filter(|item| others.iter().all(|list| list.contains(item))).cloned().collect()
}
