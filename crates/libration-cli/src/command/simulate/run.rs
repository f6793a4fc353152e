//! The integration, whose samples are written as they come.

use super::events::{Happening, Watched};
use super::report::{Summary, of_form};
use super::resume::Earlier;
use super::watch::Watch;
use crate::arguments::{Initial, Times};
use crate::failure::Failure;
use crate::figure;
use crate::figure::simulation::Trace;
use crate::interrupt;
use crate::output::Form;
use libration::systems::Model;
use libration::taylor::{
    Cause, Contact, Effort, IntegrationError, Moment, Occurrence, Solution, System, integrate,
};
use std::io::Write;
use std::path::Path;

/// A motion to be integrated, with what is asked about it.
pub(super) struct Motion<'a> {
    pub(super) model: &'a Model,
    pub(super) initial: Initial,
    pub(super) times: &'a Times,
    pub(super) effort: Effort,
    pub(super) watched: Watched,
    pub(super) earlier: Option<Earlier>,
}

/// What an integration has brought, the earlier answer included.
struct Followed {
    ending: Ending,
    steps: usize,
    events: Vec<Happening>,
}

/// How an integration ended.
#[derive(Clone, Debug)]
pub(super) enum Ending {
    Complete,
    /// Ctrl-C was pressed.
    Interrupted(f64),
    /// The motion ends or cannot be followed: why.
    Stopped(String),
}

impl Motion<'_> {
    /// Writes the answer as far as the integration comes, and draws the picture; says what it drew.
    pub(super) fn write(
        &self,
        form: Form,
        figure: Option<&Path>,
        out: &mut dyn Write,
    ) -> Result<(Ending, Vec<String>), Failure> {
        interrupt::listen()?;
        let system = self.system()?;
        let mut report = of_form(form, figure.is_none());
        report.begin(self, out)?;
        let energy = self.model.energy();
        let balance = energy.as_ref().ok().map(|energy| energy.balance(&self.beginning()));
        let trace = figure.map(|_| Trace::new(self.model, self.times.last()));
        let mut watch = Watch::new(self, &mut *report, out, balance, trace);
        let Followed { ending, steps, events } = self.follow(&system, &mut watch)?;
        let drift = energy.as_ref().map(|_| watch.drift()).map_err(ToString::to_string);
        watch.end(&Summary { steps, events, drift, ending: ending.clone() })?;
        let drawn = match (figure, watch.trace) {
            (Some(path), Some(trace)) => vec![figure::file::write(path, &trace.picture(self.model))?],
            _ => vec![],
        };
        Ok((ending, drawn))
    }

    /// The system with its events, when the times can be reached.
    fn system(&self) -> Result<System, Failure> {
        check_order(self.times)?;
        let system = self.model.system().map_err(|error| Failure::usage("--set", error))?;
        system.with_events(&self.watched.events()).map_err(|error| Failure::usage("--events", error))
    }

    /// Takes what was computed earlier and integrates the rest.
    fn follow(&self, system: &System, watch: &mut Watch) -> Result<Followed, Failure> {
        for moment in self.earlier_samples() {
            watch.earlier(moment)?;
        }
        let start = self.start();
        let last = self.times_left().next().map(|_| self.times.last());
        watch.start(&start)?;
        let outcome = integrate(system, &start, last.as_slice(), &self.effort, |step| watch.follow(step));
        if let Some(failure) = watch.failure.take() {
            return Err(failure.into());
        }
        let (ending, solution) = ended(outcome)?;
        watch.mark(&self.watched, &solution.events);
        Ok(self.followed(ending, &solution))
    }

    fn followed(&self, ending: Ending, solution: &Solution) -> Followed {
        // What happens where the motion is gone on from was seen when it came there.
        let seen = |event: &Occurrence| self.earlier.is_some() && event.contact == Contact::Start;
        let new = solution.events.iter().filter(|event| !seen(event));
        let new = new.map(|event| self.watched.happening(event));
        let earlier = self.earlier.as_ref();
        let (steps, events) = earlier.map_or((0, vec![]), |earlier| (earlier.steps, earlier.events.clone()));
        Followed { ending, steps: steps + solution.steps, events: events.into_iter().chain(new).collect() }
    }

    /// The state at t = 0.
    fn beginning(&self) -> Moment {
        Moment { time: 0.0, state: self.initial.state.clone() }
    }

    fn earlier_samples(&self) -> impl Iterator<Item = &Moment> {
        self.earlier.iter().flat_map(|earlier| &earlier.samples)
    }

    /// Where the integration begins: at t = 0, or where it was left.
    fn start(&self) -> Moment {
        self.earlier_samples().last().cloned().unwrap_or_else(|| self.beginning())
    }

    /// The times that are still to be reached.
    pub(super) fn times_left(&self) -> Box<dyn Iterator<Item = f64> + '_> {
        let times = self.times.iter();
        let Some(last) = self.earlier_samples().last().map(|moment| moment.time) else { return times };
        let backward = self.times.last() < 0.0;
        Box::new(times.skip_while(move |&time| if backward { time >= last } else { time <= last }))
    }
}

/// Times lead away from 0 in one direction.
fn check_order(times: &Times) -> Result<(), Failure> {
    let backward = times.last() < 0.0;
    let mut before = 0.0;
    // A range goes on as it begins.
    let decisive: Vec<f64> = match times {
        Times::List(times) => times.clone(),
        Times::Range(_) => times.iter().take(2).chain([times.last()]).collect(),
    };
    for after in decisive {
        if if backward { after > before } else { after < before } {
            return Err(Failure::usage("--times", IntegrationError::TimesNotInOrder { before, after }));
        }
        before = after;
    }
    Ok(())
}

/// How it ended, with what was computed.
fn ended(outcome: Result<Solution, IntegrationError>) -> Result<(Ending, Solution), Failure> {
    match outcome {
        Ok(solution) => Ok((Ending::Complete, solution)),
        Err(IntegrationError::Stopped { cause: Cause::Interrupted, solution }) => {
            Ok((Ending::Interrupted(solution.end.time), *solution))
        }
        Err(IntegrationError::Stopped { cause, solution }) => {
            let reason = format!("{cause} at t = {:?} s: the motion is known until there", solution.end.time);
            Ok((Ending::Stopped(reason), *solution))
        }
        Err(error) => Err(Failure::usage("--initial", error)),
    }
}

impl Ending {
    /// What is left to be said when the answer is written.
    pub(super) fn into_result(self, output: Option<&Path>) -> Result<(), Failure> {
        match self {
            Self::Complete => Ok(()),
            Self::Interrupted(time) => {
                let file = output.map_or("FILE".into(), Path::to_string_lossy);
                Err(Failure::Interrupted(format!(
                    "interrupted at t = {time:?} s: what was computed is written; go on with --resume {file}"
                )))
            }
            Self::Stopped(reason) => Err(Failure::NoAnswer(reason)),
        }
    }
}
