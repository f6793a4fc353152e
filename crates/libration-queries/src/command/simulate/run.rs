//! The integration, whose samples are written as they are computed.

use super::csv::Csv;
use super::ending::{Ending, EventEnding};
use super::events::Watched;
use super::json::Json;
use super::motion::SimulatedMotion;
use super::report::{AnswerWriter, Summary};
use super::resume::{Keeper, State};
use super::sheet::Sheet;
use super::watch::Watch;
use crate::arguments::{Times, Tolerances};
use crate::figure;
use crate::figure::section::StateAxis;
use crate::figure::simulation::Trace;
use crate::interrupt;
use crate::output::{Form, number};
use crate::query_error::{Parameter, QueryError, option};
use libration::systems::{Energy, EnergyBalance, Model};
use libration::taylor::{
    Cause, IntegrationError, Moment, Sensitivities, Solution, Start, System, ending_error, integrate_from,
};
use std::io::Write;
use std::path::Path;

/// A picture of the motion.
#[derive(Debug)]
pub(super) struct MotionPicture<'a> {
    /// The file, if one is named.
    pub(super) path: Option<&'a Path>,
    pub(super) layout: &'a figure::Layout,
    /// Axes of the picture, if it does not show the coordinates against time.
    pub(super) axes: Option<[StateAxis; 2]>,
    /// `true` if the bodies move next to the curves.
    pub(super) animate: bool,
}

/// The outcome of the run.
pub(super) struct RunOutcome {
    pub(super) ending: Ending,
    /// State needed to continue.
    pub(super) state: State,
    /// A sentence for each picture.
    pub(super) drawn: Vec<String>,
}

impl SimulatedMotion<'_> {
    /// Writes the result as the integration proceeds, and draws the picture.
    pub(super) fn write(
        &self,
        form: Form,
        figure: Option<MotionPicture<'_>>,
        out: &mut dyn Write,
        keeper: Option<Keeper>,
    ) -> Result<RunOutcome, QueryError> {
        interrupt::listen()?;
        self.check_times(figure.as_ref().is_some_and(|figure| figure.animate))?;
        let system = self.system()?;
        let mut report = report(form, figure.as_ref().is_none_or(|figure| figure.path.is_none()));
        if self.goes_both_ways() {
            return self.write_both_ways(&system, figure, &mut *report, out);
        }
        let energy = self.model.energy();
        let balance = energy.as_ref().ok().map(|energy| self.balance(energy));
        let trace = figure.as_ref().map(|_| Trace::new(self.model, self.observables, self.times.last()));
        let errors = self.state_errors(&system);
        let mut watch = Watch::new(self, &mut *report, out, balance, errors, trace, keeper);
        watch.begin()?;
        let (ending, steps) = self.follow(&system, &mut watch)?;
        let drift = energy.as_ref().map(|_| watch.drift()).map_err(ToString::to_string);
        let state = watch.state().clone();
        let precision = watch.precision();
        watch.end(&Summary {
            steps,
            drift,
            precision,
            ending: ending.clone(),
            state: Some(state.clone()),
        })?;
        let drawn = self.drawn(figure, watch.trace)?;
        Ok(RunOutcome { ending, state, drawn })
    }

    /// Draws the picture, if there is one; a sentence for it.
    pub(super) fn drawn(
        &self,
        figure: Option<MotionPicture<'_>>,
        trace: Option<Trace<'_>>,
    ) -> Result<Vec<String>, QueryError> {
        let Some((figure, trace)) = figure.zip(trace) else { return Ok(vec![]) };
        let start = &self.initial.state;
        figure::file::drawn(figure.path, figure.layout, || {
            Ok(match &figure.axes {
                Some(axes) => trace.plane(self.model, start, axes),
                None if figure.animate => trace.animated(self.model, start),
                None => trace.picture(self.model, start),
            })
        })
    }

    /// Refuses times that cannot be reached, or that are incompatible with other options.
    pub(super) fn check_times(&self, is_animated: bool) -> Result<(), QueryError> {
        if self.goes_both_ways() { self.check_both_ways(is_animated) } else { check_order(self.times) }
    }

    fn system(&self) -> Result<System, QueryError> {
        system_of(self.model, self.sensitivities, self.tolerances, self.watched, &option("set"))
    }

    /// The ending by the event of `--until`: its state, or that it was not reached.
    pub(super) fn until(&self, system: &System, solution: &Solution) -> Result<Ending, QueryError> {
        let Some(name) = self.watched.until() else { return Ok(Ending::Complete) };
        let last = self.times.last();
        if (solution.end.time - last).abs() <= 0.0 {
            return Ok(Ending::NotReached(format!(
                "`{name}` does not occur before t = {last:?} s: give later <--times>, or another event"
            )));
        }
        let end = solution.end.clone();
        let error = match self.no_errors {
            Some("--no-errors") => Moment { time: f64::NAN, state: vec![f64::NAN; end.state.len()] },
            _ => ending_error(system, &self.beginning(), last, &self.effort(), &end)
                .map_err(QueryError::failed)?,
        };
        let (end, error) = (self.motion_state(&end), self.motion_state(&error));
        Ok(Ending::Event(EventEnding { name, end, error }))
    }

    /// The account of the energy, initial or continued.
    fn balance<'e>(&self, energy: &'e Energy) -> EnergyBalance<'e> {
        let account = self.mark().and_then(|mark| mark.energy.as_ref());
        account.map_or_else(
            || energy.balance(&self.motion_state(&self.beginning())),
            |account| energy.balance_from(account),
        )
    }

    /// Takes the earlier rows and integrates the rest; returns the ending and the number of steps.
    fn follow(&self, system: &System, watch: &mut Watch) -> Result<(Ending, usize), QueryError> {
        if let Some(earlier) = &self.earlier {
            earlier.each(|row| watch.earlier(row))?;
        }
        let start = match self.mark() {
            Some(mark) => Start::Checkpoint(mark.checkpoint.clone()),
            None => {
                watch.start(&self.beginning())?;
                Start::State(self.beginning())
            }
        };
        let last = [self.times.last()];
        let outcome = integrate_from(system, &start, &last, &self.effort(), |step| watch.follow(step));
        if let Some(failure) = watch.failure.take() {
            return Err(failure);
        }
        let (ending, solution) = ended(outcome, self)?;
        let ending = match ending {
            Ending::Complete => self.until(system, &solution)?,
            other => other,
        };
        Ok((ending, solution.steps))
    }
}

/// A system with its derivatives and events; `giver` is the option that gives its parameters.
pub(super) fn system_of(
    model: &Model,
    sensitivities: Option<&Sensitivities>,
    tolerances: &Tolerances,
    watched: &Watched,
    giver: &Parameter,
) -> Result<System, QueryError> {
    // Names of coordinates are those of the motion alone.
    let plain = tolerances.put_on(model.system().map_err(|error| QueryError::usage(giver, error))?)?;
    let system = match sensitivities {
        Some(sensitivities) => {
            let system =
                System::new(sensitivities.equation()).map_err(|error| QueryError::usage(giver, error))?;
            tolerances.put_on(system)?
        }
        None => plain,
    };
    system.with_events(&watched.events()).map_err(|error| QueryError::usage(option("events"), error))
}

/// The report in this form; a table lists the samples only if requested.
fn report(form: Form, listed: bool) -> Box<dyn AnswerWriter> {
    match form {
        Form::Json => Box::new(Json::new()),
        Form::Csv => Box::new(Csv::new()),
        Form::Table => Box::new(Sheet::new(listed)),
    }
}

/// Times lead away from 0 in one direction.
fn check_order(times: &Times) -> Result<(), QueryError> {
    let backward = times.last() < 0.0;
    let mut before = 0.0;
    // A range goes on as it begins.
    let decisive: Vec<f64> = match times {
        Times::List(times) => times.clone(),
        Times::Range(_) => times.iter().take(2).chain([times.last()]).collect(),
    };
    for after in decisive {
        if if backward { after > before } else { after < before } {
            return Err(QueryError::usage(
                option("times"),
                IntegrationError::TimesNotInOrder { before, after },
            ));
        }
        before = after;
    }
    Ok(())
}

/// The ending, with the solution that was computed.
pub(super) fn ended(
    outcome: Result<Solution, IntegrationError>,
    motion: &SimulatedMotion,
) -> Result<(Ending, Solution), QueryError> {
    match outcome {
        Ok(solution) => Ok((Ending::Complete, solution)),
        Err(IntegrationError::Stopped { cause: Cause::Interrupted, solution }) => {
            Ok((Ending::Interrupted(solution.end.time), *solution))
        }
        Err(IntegrationError::Stopped { cause, solution }) => {
            let Moment { time, state } = &motion.motion_state(&solution.end);
            let pairs = motion.model.state_names().into_iter().zip(state);
            let components: Vec<String> =
                pairs.map(|(name, value)| format!("{name} = {}", number::short(*value, 6))).collect();
            let state_text = components.join(", ");
            let reason = format!(
                "{cause} at t = {} s, {state_text}: the motion is known up to there",
                cause.time(*time)
            );
            Ok((Ending::Stopped(reason), *solution))
        }
        Err(error) => Err(QueryError::usage(option("initial"), error)),
    }
}
