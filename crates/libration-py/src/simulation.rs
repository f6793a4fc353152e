//! Motions of any system in time, for `simulation.py`.

use std::ops::ControlFlow;

use libration::catalogue::is_like_a_key;
use libration::expression::Expression;
use libration::progress::{Progress, Stage, Status};
use libration::systems::Model;
use libration::taylor::{
    AcceptedStep, Cause, Contact, DenseSolution, Direction, Effort, Event, IntegrationError, Moment,
    MomentErrors, Occurrence, SampledErrors, Solution, Start, StateErrors, System, integrate_both_ways,
    integrate_from,
};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::errors::{SimulationError, refusal};
use crate::progress::CallProgress;
use crate::quantity::warn_of_whole_radians;

/// Arguments: equations or a key, values of parameters, names and values of the start,
/// events with their directions, the event that ends the motion, the tolerance.
#[derive(FromPyObject)]
pub(crate) struct SimulationArguments(
    String,
    Vec<(String, String)>,
    Vec<(String, String)>,
    Vec<(String, String)>,
    Option<(String, String)>,
    f64,
);

/// A motion as far as it was computed.
#[pyclass(frozen, name = "Simulation", module = "libration._native")]
pub(crate) struct NativeSimulation {
    model: Model,
    start: Vec<f64>,
    solution: Solution,
    /// The solutions before the start and after it.
    dense: [DenseSolution; 2],
    errors: Option<Errors>,
}

/// The errors of the samples and events of a motion; NaN where the motion is not determined.
struct Errors {
    samples: Vec<MomentErrors>,
    events: Vec<MomentErrors>,
    determined_until: Option<f64>,
}

/// The motion, and the exception or reason that stopped it before its end.
#[pyfunction]
pub(crate) fn simulate(
    py: Python<'_>,
    question: SimulationArguments,
    times: PyReadonlyArray1<'_, f64>,
    errors: bool,
    progress: Option<Py<PyAny>>,
) -> PyResult<(NativeSimulation, Option<PyErr>)> {
    let asked = Asked::new(&question)?;
    for (_, value) in question.2.iter().filter(|(name, _)| asked.model.is_angle(name)) {
        warn_of_whole_radians(py, value)?;
    }
    let times = times.as_slice()?;
    let progress = CallProgress::new(progress);
    let Followed { outcome, dense, errors, is_full } = py.detach(|| asked.followed(times, errors, &progress));
    let (solution, cause) = match outcome {
        Ok(solution) => (solution, None),
        Err(IntegrationError::Stopped { cause, solution }) => (*solution, Some(cause)),
        Err(error) => return Err(refusal::<SimulationError>(error)),
    };
    let end = solution.end.time;
    let errors = errors.map(|errors| Errors::new(&errors, &solution));
    let reason = match cause {
        Some(Cause::Interrupted) if is_full => Some(format!(
            "{} steps up to t = {end:?} take 1 GB, since the motion is kept for all times between: simulate shorter parts, or \
             use libration.questions.simulate, which keeps only the states at the times",
            solution.steps
        )),
        Some(Cause::Interrupted) | None => None,
        Some(cause) => Some(format!("{cause} at t = {}: the motion is known up to there", cause.time(end))),
    };
    let reason = reason.map(refusal::<SimulationError>);
    Ok((
        NativeSimulation { model: asked.model, start: asked.start.state, solution, dense, errors },
        progress.stopped_by().or(reason),
    ))
}

struct Asked {
    model: Model,
    system: System,
    start: Moment,
    effort: Effort,
}

impl Asked {
    fn new(
        SimulationArguments(system, values, initial, events, until, tolerance): &SimulationArguments,
    ) -> PyResult<Self> {
        let model = model(system, values)?;
        let borrowed: Vec<(&str, &str)> = initial.iter().map(|(name, value)| (&**name, &**value)).collect();
        let start = model.initial(&borrowed).map_err(refusal::<SimulationError>)?;
        let all = events.iter().map(|event| (event, None)).chain(until.iter().map(|event| (event, Some(1))));
        let events = all.map(|((text, way), ends_at)| {
            let formula = model.zero_of(text).map_err(refusal::<SimulationError>)?;
            Ok(Event { formula, direction: direction(way)?, ends_at })
        });
        let events = events.collect::<PyResult<Vec<_>>>()?;
        let system = model.system().map_err(refusal::<SimulationError>)?;
        let system = system.with_events(&events).map_err(refusal::<SimulationError>)?;
        let start = Moment { time: 0.0, state: start.state };
        Ok(Self { model, system, start, effort: Effort::to_tolerance(*tolerance) })
    }

    fn followed(&self, times: &[f64], with_errors: bool, progress: &CallProgress) -> Followed<'_> {
        /// Memory limit in bytes, which every computer for notebooks has.
        const MOST: usize = 1_000_000_000;
        /// Approximate number of coefficients in a step for each component of the state;
        /// the step itself and its memory management take as much as one component.
        const TERMS: usize = 30;
        let numbers = TERMS * (self.start.state.len() + 1);
        let (mut steps, mut is_full) = (0_usize, false);
        let mut dense = [DenseSolution::default(), DenseSolution::default()];
        let (first, last) = (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(0.0));
        let span = first.abs().max(last.abs());
        let Self { system, start, effort, .. } = self;
        let mut errors = (with_errors && start.state.len() <= StateErrors::MOST_COMPONENTS)
            .then(|| SampledErrors::new(system, start, effort, times, None));
        let watch = |accepted: &AcceptedStep<'_>| -> ControlFlow<()> {
            if let Some(errors) = &mut errors {
                errors.follow(accepted);
            }
            let step = accepted.step();
            steps += 1;
            if steps.saturating_mul(numbers * size_of::<f64>()) > MOST {
                is_full = true;
                return ControlFlow::Break(());
            }
            dense[usize::from(step.end() > step.start())].push(step);
            progress.update(status(step.end().abs(), span))
        };
        let outcome = match first < 0.0 && last > 0.0 {
            true => integrate_both_ways(system, start, times, effort, watch),
            false => integrate_from(system, &Start::State(start.clone()), times, effort, watch),
        };
        Followed { outcome, dense, errors, is_full }
    }
}

/// A motion with its steps, before the start and after it.
struct Followed<'a> {
    outcome: Result<Solution, IntegrationError>,
    dense: [DenseSolution; 2],
    errors: Option<SampledErrors<'a>>,
    /// `true` if the motion was ended because its steps exceed the memory limit.
    is_full: bool,
}

impl Errors {
    fn new(errors: &SampledErrors<'_>, solution: &Solution) -> Self {
        let numbers = solution.end.state.len();
        let or_unknown = |moment_errors: Option<&MomentErrors>| {
            let unknown =
                || MomentErrors { time: f64::NAN, state: vec![f64::NAN; numbers], formulas: vec![] };
            moment_errors.cloned().unwrap_or_else(unknown)
        };
        Self {
            samples: solution
                .samples
                .iter()
                .map(|sample| or_unknown(errors.of_sample(sample.time)))
                .collect(),
            events: solution.events.iter().map(|event| or_unknown(errors.of_event(event))).collect(),
            determined_until: errors.worse().and_then(StateErrors::determined_until),
        }
    }
}

/// Status in thousandths of the time.
fn status(time: f64, span: f64) -> Status {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most a thousand")]
    let done = (1000.0 * (time / span).clamp(0.0, 1.0)) as usize;
    Status { stage: Stage::Whole, done, of: Some(1000) }
}

fn model(system: &str, values: &[(String, String)]) -> PyResult<Model> {
    let values = values.iter().map(|(name, value)| {
        let value: Result<Expression, _> = value.parse();
        Ok((name.as_str(), value.map_err(|error| refusal::<SimulationError>(format!("{name}: {error}")))?))
    });
    let values = values.collect::<PyResult<Vec<_>>>()?;
    let model = match is_like_a_key(system) {
        true => Model::by_key(system.trim(), &values, &[]),
        false => Model::typed(system, &values, &[]),
    };
    let model = model.map_err(refusal::<SimulationError>)?;
    match model.open_parameters().first() {
        Some(name) => {
            let reason = format!("`{name}` has no value: give it one, such as set={{\"{name}\": 0.1}}");
            Err(refusal::<SimulationError>(reason))
        }
        None => Ok(model),
    }
}

fn direction(way: &str) -> PyResult<Direction> {
    match way {
        "any" => Ok(Direction::Any),
        "rising" => Ok(Direction::Rising),
        "falling" => Ok(Direction::Falling),
        other => Err(refusal::<SimulationError>(format!(
            "unknown direction `{other}`: give any, rising or falling"
        ))),
    }
}

/// Index of the event, time, state, contact.
type Happening<'py> = (usize, f64, Bound<'py, PyArray1<f64>>, &'static str);

/// The errors of states, of event times and of event states, and the last time at which the motion is determined.
type KnownErrors<'py> =
    (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>, Option<f64>);

/// Times and the state at each time.
type Samples<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>);

#[pymethods]
impl NativeSimulation {
    /// Title, equations, names, units, number of steps, and the last time.
    fn words(&self) -> (&'static str, String, Vec<String>, Vec<String>, usize, f64) {
        let (model, solution) = (&self.model, &self.solution);
        let equations = model.equation().to_string();
        (
            model.title(),
            equations,
            model.state_names(),
            model.state_units(),
            solution.steps,
            solution.end.time,
        )
    }

    /// Times and states, a row for each time.
    fn samples<'py>(&self, py: Python<'py>) -> PyResult<Samples<'py>> {
        let samples = &self.solution.samples;
        let times: Vec<f64> = samples.iter().map(|sample| sample.time).collect();
        let numbers: Vec<f64> = samples.iter().flat_map(|sample| sample.state.iter().copied()).collect();
        Ok((times.into_pyarray(py), self.rows(py, numbers, samples.len())?))
    }

    fn events<'py>(&self, py: Python<'py>) -> Vec<Happening<'py>> {
        let happening = |occurrence: &Occurrence| {
            (
                occurrence.event,
                occurrence.time,
                occurrence.state.clone().into_pyarray(py),
                contact(occurrence.contact),
            )
        };
        self.solution.events.iter().map(happening).collect()
    }

    /// The errors of samples and events, if they are estimated.
    fn errors<'py>(&self, py: Python<'py>) -> PyResult<Option<KnownErrors<'py>>> {
        let Some(Errors { samples, events, determined_until }) = &self.errors else { return Ok(None) };
        let states = |all: &[MomentErrors]| {
            let numbers = all.iter().flat_map(|moment| moment.state.iter().copied()).collect();
            self.rows(py, numbers, all.len())
        };
        let times: Vec<f64> = events.iter().map(|event| event.time).collect();
        Ok(Some((states(samples)?, times.into_pyarray(py), states(events)?, *determined_until)))
    }

    /// The states at any times between the ends, a row for each time.
    fn states_at<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let times = times.as_slice()?;
        let rows = py.detach(|| {
            times.iter().map(|time| self.state_at(*time).ok_or(*time)).collect::<Result<Vec<_>, _>>()
        });
        let states = rows.map_err(|time| {
            let [from, to] = self.ends();
            refusal::<SimulationError>(format!(
                "t = {time:?} is beyond the motion, which is known from {from:?} to {to:?}"
            ))
        })?;
        self.rows(py, states.concat(), times.len())
    }
}

impl NativeSimulation {
    fn rows<'py>(
        &self,
        py: Python<'py>,
        numbers: Vec<f64>,
        rows: usize,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        numbers.into_pyarray(py).reshape([rows, self.model.state_names().len()])
    }

    fn state_at(&self, time: f64) -> Option<Vec<f64>> {
        if time.abs() <= 0.0 {
            return Some(self.start.clone());
        }
        self.dense[usize::from(time > 0.0)].state_at(time)
    }

    fn ends(&self) -> [f64; 2] {
        let end = |side: &DenseSolution| side.span().map_or(0.0, |[_, end]| end);
        [end(&self.dense[0]), end(&self.dense[1])]
    }
}

fn contact(contact: Contact) -> &'static str {
    match contact {
        Contact::Rising => "rising",
        Contact::Falling => "falling",
        Contact::Grazing => "grazing",
        Contact::Start => "start",
    }
}
