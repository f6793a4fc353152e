//! `libration figure trajectories`: motions of a system from several starts, or with several values of a parameter.

use super::PictureOptions;
use crate::arguments::{
    self, ParameterRange, SeveralInitialOptions, SystemOptions, parameter_range, place_in_state,
    places_in_state,
};
use crate::failure::Failure;
use crate::figure::chart::Picture;
use crate::figure::parameters::{Angles, of_model, of_start, said};
use crate::figure::section::StateAxis;
use crate::figure::trajectories::{Sampled, against_time, in_plane, spectra};
use crate::interrupt;
use crate::output::number::count;
use libration::systems::Model;
use libration::taylor::{Cause, Effort, IntegrationError, Moment, System, integrate_watched};
use std::f64::consts::TAU;

/// Motions of any system in one picture: against time, in the plane of two state variables, or their spectra
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration figure trajectories pendulum --initial theta=30deg \\
    --initial theta=150deg --until 20s --output swings.svg
  libration figure trajectories damped_pendulum --over c=0.05,0.2,2 \\
    --initial theta=170deg --until 40s --output damping.svg
  libration figure trajectories \"x'' = x - x^3\" --initial \"x=1,x'=0.2\" \\
    --initial \"x=1,x'=0.9\" --until 30s --axes \"x,x'\" --output plane.svg
  libration figure trajectories double_pendulum --initial theta1=10deg \\
    --initial theta1=120deg --until 300s --spectrum theta1 \\
    --output spectrum.svg

Motions begin at t = 0. A spectrum has a line for each frequency of the motion,
as high as its amplitude; a motion of seven or more periods separates them.")]
pub(super) struct Trajectories {
    #[command(flatten)]
    system: SystemOptions,
    /// Length of the rods of a named pendulum, such as 1m or 57cm [default: what `libration systems` says]
    #[arg(long, value_parser = arguments::length)]
    length: Option<f64>,
    /// Acceleration of free fall of a named pendulum, such as 9.81m/s^2
    #[arg(long, value_parser = arguments::gravity)]
    gravity: Option<f64>,
    #[command(flatten)]
    initial: SeveralInitialOptions,
    /// A parameter and its values, with a motion for each, such as c=0.05,0.2,2 or A=1:1.2:0.1
    #[arg(long, value_name = "NAME=VALUES", value_parser = parameter_range)]
    over: Option<ParameterRange>,
    /// The first time that is drawn, in seconds or with a unit
    #[arg(long, value_name = "TIME", default_value = "0", value_parser = arguments::finite_time)]
    from: f64,
    /// The last time that is drawn
    #[arg(long, value_name = "TIME", default_value = "60", value_parser = arguments::finite_time)]
    until: f64,
    /// The state variable that is drawn against time [default: the first coordinate]
    #[arg(long, value_name = "NAME", conflicts_with_all = ["axes", "spectrum"])]
    show: Option<String>,
    /// Draw one state variable against another, such as theta,theta'
    #[arg(long, value_name = "NAME,NAME", conflicts_with = "spectrum")]
    axes: Option<String>,
    /// Draw the spectrum of a state variable, such as theta
    #[arg(long, value_name = "NAME")]
    spectrum: Option<String>,
    #[command(flatten)]
    pub(super) options: PictureOptions,
}

/// More curves than a picture can keep apart.
const MOST_MOTIONS: usize = 12;
/// Points of a curve.
const POINTS: usize = 6000;
/// Values of a spectrum for each step of the integration. A step is at most the e²-th part of the distance ρ to a singularity of the
/// motion, and the amplitudes at the frequency ω of an analytic motion fall like e^(−ωρ): at the highest frequency of four values
/// to a step, 4π/step, to e^(−93).
const VALUES_IN_STEP: usize = 4;
const FEWEST_VALUES: usize = 4096;
/// Motions of more steps are too long for a spectrum, as they would take gigabytes.
const MOST_STEPS: usize = 200_000;

/// The relative error of a step, far below what a picture shows.
const TOLERANCE: f64 = 1e-12;

/// A motion to be integrated.
struct Run {
    model: Model,
    system: System,
    start: Moment,
    label: String,
}

impl Trajectories {
    pub(super) fn picture(&self) -> Result<Picture, Failure> {
        if !(0.0 <= self.from && self.from < self.until) {
            let reason = format!(
                "{} s to {} s: give times from 0 on, the last after the first",
                self.from, self.until
            );
            return Err(Failure::usage("--until", reason));
        }
        let runs = self.runs()?;
        let model = &runs[0].model;
        let axis = |place| StateAxis::new(model, place);
        let one = |argument, name: &Option<String>| {
            name.as_deref().map(|name| place_in_state(model, argument, name).map(axis)).transpose()
        };
        let axes = self.axes.as_deref().map(|names| places_in_state(model, "--axes", names)).transpose()?;
        let (of_spectrum, show) = (one("--spectrum", &self.spectrum)?, one("--show", &self.show)?);
        interrupt::listen()?;
        let motions = self.motions(&runs)?;
        let picture = match (axes, &of_spectrum) {
            (Some(axes), _) => in_plane(model, &motions, &axes.map(axis)),
            (_, Some(of)) => {
                bounded(&motions, of)?;
                spectra(model, &motions, of).map_err(|error| Failure::no_answer("--spectrum", error))?
            }
            _ => against_time(model, &motions, &show.unwrap_or_else(|| axis(0))),
        };
        Ok(picture.with_parameters(common(&runs.iter().map(Run::made_with).collect::<Vec<_>>())))
    }

    /// Every start with every value of the parameter.
    fn runs(&self) -> Result<Vec<Run>, Failure> {
        let values = self.over.as_ref().map_or(vec![None], |over| {
            over.values.iter().map(|value| Some((over.name.as_str(), *value))).collect()
        });
        let mut runs = vec![];
        for value in values.into_iter().take(MOST_MOTIONS + 1) {
            let model = self.system.model_over(self.length, self.gravity, value)?;
            let system = model.system().map_err(|error| Failure::usage("--set", error))?;
            let label = value.map_or_else(String::new, |(name, value)| said(name, value, ""));
            for initial in self.initial.read(&model)? {
                let start = Moment { time: 0.0, state: initial.state };
                runs.push(Run { model: model.clone(), system: system.clone(), start, label: label.clone() });
            }
        }
        if runs.len() > MOST_MOTIONS {
            let reason =
                format!("a picture keeps at most {MOST_MOTIONS} motions apart: give fewer starts and values");
            return Err(Failure::usage("figure trajectories", reason));
        }
        label_starts(&mut runs);
        Ok(runs)
    }

    /// The motions that are done before somebody presses Ctrl-C.
    fn motions(&self, runs: &[Run]) -> Result<Vec<Sampled>, Failure> {
        let mut motions = vec![];
        for run in runs {
            match self.sampled(run) {
                Ok(motion) => motions.push(motion),
                Err(IntegrationError::Stopped { cause: Cause::Interrupted, .. }) if !motions.is_empty() => {
                    break;
                }
                Err(IntegrationError::Stopped { cause: Cause::Interrupted, .. }) => {
                    return Err(Failure::Interrupted("interrupted before a motion was done".to_owned()));
                }
                Err(error) => return Err(Failure::no_answer("figure trajectories", error)),
            }
        }
        Ok(motions)
    }

    fn sampled(&self, run: &Run) -> Result<Sampled, IntegrationError> {
        let (system, start, effort) = (&run.system, &run.start, Effort::to_tolerance(TOLERANCE));
        let number = match self.spectrum {
            Some(_) => (VALUES_IN_STEP * self.steps(run, &effort)?).max(FEWEST_VALUES),
            None => POINTS,
        };
        let time = |place: usize| self.from + (self.until - self.from) * (count(place) / count(number - 1));
        let mut sampled = Sampled { label: run.label.clone(), times: vec![], states: vec![] };
        integrate_watched(system, start, &[self.until], &effort, |step| {
            while sampled.times.len() < number && time(sampled.times.len()) <= step.end() {
                let now = time(sampled.times.len());
                sampled.times.push(now);
                sampled.states.push(step.state_at(now));
            }
            interrupt::go_on()
        })?;
        Ok(sampled)
    }

    /// How many steps there are in what is drawn.
    fn steps(&self, run: &Run, effort: &Effort) -> Result<usize, IntegrationError> {
        let mut steps = 0;
        let effort = Effort { most_steps: MOST_STEPS, ..*effort };
        integrate_watched(&run.system, &run.start, &[self.until], &effort, |step| {
            steps += usize::from(step.end() > self.from);
            interrupt::go_on()
        })?;
        Ok(steps)
    }
}

impl Run {
    /// What it is made with: its parameters and its start.
    fn made_with(&self) -> Vec<String> {
        [of_model(&self.model), self.numbers_of_start()].concat()
    }

    fn numbers_of_start(&self) -> Vec<String> {
        of_start(&self.model, &self.start.state, Angles::Degrees)
    }
}

/// An angle that turns over again and again grows without bound, and then all frequencies are in it.
fn bounded(motions: &[Sampled], of: &StateAxis) -> Result<(), Failure> {
    let moved = |motion: &Sampled| {
        let (first, last) = (motion.states.first()?[of.place], motion.states.last()?[of.place]);
        Some((last - first).abs())
    };
    if of.is_angle && motions.iter().filter_map(moved).any(|moved| moved > 2.0 * TAU) {
        let name = of.name();
        let reason =
            format!("{name} turns over and grows without bound: draw the spectrum of its velocity, {name}′");
        return Err(Failure::no_answer("--spectrum", reason));
    }
    Ok(())
}

/// Adds to each label the numbers of its start that are not those of all.
fn label_starts(runs: &mut [Run]) {
    let starts: Vec<Vec<String>> = runs.iter().map(Run::numbers_of_start).collect();
    let shared = common(&starts);
    for (run, start) in runs.iter_mut().zip(starts) {
        let own = start.into_iter().filter(|number| !shared.contains(number));
        let parameter = Some(run.label.clone()).filter(|label| !label.is_empty());
        run.label = parameter.into_iter().chain(own).collect::<Vec<_>>().join(", ");
    }
    if runs.len() > 1 {
        runs.iter_mut().filter(|run| run.label.is_empty()).for_each(|run| run.label = "from rest".to_owned());
    }
}

/// The items that all lists have.
fn common(lists: &[Vec<String>]) -> Vec<String> {
    let Some((first, others)) = lists.split_first() else { return vec![] };
    first.iter().filter(|item| others.iter().all(|list| list.contains(item))).cloned().collect()
}

#[cfg(test)]
mod tests {
    use super::common;

    #[test]
    fn what_all_have_is_said_once() {
        let lists = [["a", "b", "c"], ["c", "b", "d"]].map(|list| list.map(str::to_owned).to_vec());
        assert_eq!(common(&lists), ["b", "c"]);
        assert_eq!(common(&lists[..1]), ["a", "b", "c"]);
        assert!(common(&[]).is_empty());
    }
}
