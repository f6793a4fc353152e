//! Our side of `bench/peers/motion`: integrates the motions that it is asked for.

#[path = "../requests.rs"]
mod requests;

use libration::taylor::{Effort, IntegrationError, Moment, Solution, System, Trajectory, integrate_many};
use requests::{Answer, Failure, Request, serve, timed};

fn main() -> Result<(), Failure> {
    serve(answer)
}

fn answer(request: &Request) -> Result<Answer, Failure> {
    let mut answer = Answer::default();
    let system = timed(&mut answer.set_up, || system(&request.case))??;
    let solutions = timed(&mut answer.seconds, || motions(&system, request))??;
    answer.steps = solutions.iter().map(|solution| solution.steps).sum();
    answer.states = solutions.into_iter().map(|solution| solution.end.state).collect();
    Ok(answer)
}

/// Many motions go side by side.
fn motions(system: &System, request: &Request) -> Result<Vec<Solution>, IntegrationError> {
    let effort = Effort::to_tolerance(request.tolerance);
    let times = [request.end];
    let start = |state: &Vec<f64>| Moment { time: 0.0, state: state.clone() };
    let trajectory = |state| Trajectory { start: start(state), parameters: vec![], times: &times };
    let trajectories: Vec<Trajectory<'_>> = request.starts.iter().map(trajectory).collect();
    match &trajectories[..] {
        [one] => Ok(vec![one.integrate(system, &effort)?]),
        many => integrate_many(system, many, &effort).into_iter().collect(),
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

/// Two equal rods without mass and two equal bobs, g = l = 1; a'' stands in the place of b'' too.
const DOUBLE: &str = "a'' = -(sin(a-b) b'^2 + 2 sin(a) + cos(a-b) (sin(a-b) a'^2 - sin(b)))/(1 + sin(a-b)^2); \
    b'' = sin(a-b) a'^2 - sin(b) + cos(a-b) (sin(a-b) b'^2 + 2 sin(a) + cos(a-b) (sin(a-b) a'^2 - sin(b)))/(1 + sin(a-b)^2)";
