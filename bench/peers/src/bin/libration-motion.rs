//! The part of libration in `bench/peers/motion`: integrates the requested motions.

#[path = "../requests.rs"]
mod requests;

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use libration::progress::Quiet;
use libration::taylor::{Effort, IntegrationError, Moment, Solution, System, Trajectory, integrate_many};
use requests::{Answer, Failure, Request, serve, timed};

fn main() -> Result<(), Failure> {
    let mut systems = HashMap::new();
    serve(|request| answer(&mut systems, request))
}

/// Systems compiled to machine code, by name and tolerance.
type Systems = HashMap<(String, u64), System>;

fn answer(systems: &mut Systems, request: &Request) -> Result<Answer, Failure> {
    let mut answer = Answer::default();
    let key = (request.case.clone(), request.tolerance.to_bits());
    let system = match systems.entry(key) {
        Entry::Occupied(known) => known.into_mut(),
        Entry::Vacant(vacant) => vacant.insert(timed(&mut answer.set_up, || prepared(request))??),
    };
    let solutions = timed(&mut answer.seconds, || motions(system, request, &request.starts))??;
    answer.steps = solutions.iter().map(|solution| solution.steps).sum();
    answer.states = solutions.into_iter().map(|solution| solution.end.state).collect();
    Ok(answer)
}

/// A system after enough steps that it is compiled to machine code.
fn prepared(request: &Request) -> Result<System, Failure> {
    const STEPS: usize = 20_000;
    let system = system(&request.case)?;
    let first = &request.starts[..request.starts.len().min(8)];
    let mut steps = 0;
    while steps < STEPS {
        steps += motions(&system, request, first)?.iter().map(|solution| solution.steps).sum::<usize>();
    }
    Ok(system)
}

/// Several motions are integrated in lanes.
fn motions(
    system: &System,
    request: &Request,
    starts: &[Vec<f64>],
) -> Result<Vec<Solution>, IntegrationError> {
    let effort = Effort::to_tolerance(request.tolerance);
    let times = [request.end];
    let start = |state: &Vec<f64>| Moment { time: 0.0, state: state.clone() };
    let trajectory = |state| Trajectory { start: start(state), parameters: vec![], times: &times };
    let trajectories: Vec<Trajectory<'_>> = starts.iter().map(trajectory).collect();
    match &trajectories[..] {
        [one] => Ok(vec![one.integrate(system, &effort, &Quiet)?]),
        many => integrate_many(system, many, &effort, &Quiet).into_iter().collect(),
    }
}

fn system(case: &str) -> Result<System, Failure> {
    let equations = match case {
        "pendulum" => "theta'' + sin(theta) = 0",
        "driven" => "theta'' + theta'/2 + sin(theta) = 1.2 cos(2 t/3)",
        "double" => DOUBLE,
        _ => return Err(format!("{case}: ask for pendulum, driven or double").into()),
    };
    Ok(System::new(&equations.parse()?)?)
}

/// Two equal massless rods and two equal bobs, g = l = 1; a'' is written out in the equation of b'' too, as for the other tools.
const DOUBLE: &str = "a'' = -((sin(a-b) b'^2 + 2 sin(a) + cos(a-b) (sin(a-b) a'^2 - sin(b)))/(1 + sin(a-b)^2)); \
    b'' = sin(a-b) a'^2 - sin(b) + cos(a-b) ((sin(a-b) b'^2 + 2 sin(a) + cos(a-b) (sin(a-b) a'^2 - sin(b)))/(1 + sin(a-b)^2))";
