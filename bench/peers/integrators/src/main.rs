//! The Rust peers of `bench/peers/motion`, both with Dormand and Prince's method of order 8. `peer-integrators CRATE` serves the requests of
//! `../../src/requests.rs` with `ode_solvers` or `differential-equations`.

#[path = "../../src/requests.rs"]
mod requests;
mod systems;

use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE};
use ode_solvers::{Dop853, OutputType, SVector, System};
use requests::{Answer, Failure, Request, serve, timed};
use systems::{Double, Driven, DrivenWithClock, Pendulum, Rates};

/// A step limit that no integration reaches.
const MOST_STEPS: u32 = 100_000_000;

fn main() -> Result<(), Failure> {
    match std::env::args().nth(1).as_deref() {
        Some("ode_solvers") => serve(|request| match request.case.as_str() {
            "pendulum" => run(request, ode_solvers::<_, 2>(Pendulum)),
            "driven" => run(request, ode_solvers::<_, 3>(DrivenWithClock)),
            "double" => run(request, ode_solvers::<_, 4>(Double)),
            _ => Err(format!("no case {}", request.case).into()),
        }),
        Some("differential-equations") => serve(|request| match request.case.as_str() {
            "pendulum" => run(request, differential_equations::<_, 2>(Pendulum)),
            "driven" => run(request, differential_equations::<_, 2>(Driven)),
            "double" => run(request, differential_equations::<_, 4>(Double)),
            _ => Err(format!("no case {}", request.case).into()),
        }),
        _ => Err("name a crate: ode_solvers or differential-equations".into()),
    }
}

/// The steps and the last state of one integration.
type Outcome<const N: usize> = Result<(usize, [f64; N]), Failure>;

/// Integrates all motions of a request; a state with too few components is padded with zeros and printed without them.
fn run<const N: usize>(
    request: &Request,
    solve: impl Fn([f64; N], f64, f64) -> Outcome<N>,
) -> Result<Answer, Failure> {
    let mut answer = Answer::default();
    let filled = |start: &Vec<f64>| std::array::from_fn(|i| start.get(i).copied().unwrap_or(0.0));
    let motions =
        || request.starts.iter().map(|start| solve(filled(start), request.end, request.tolerance)).collect();
    let ends: Result<Vec<_>, _> = timed(&mut answer.seconds, motions)?;
    for ((steps, end), start) in ends?.iter().zip(&request.starts) {
        answer.steps += steps;
        answer.states.push(end[..start.len()].to_vec());
    }
    Ok(answer)
}

/// Keeps all steps: an output at the end alone would be interpolated.
fn ode_solvers<R: Rates<N> + Copy, const N: usize>(rates: R) -> impl Fn([f64; N], f64, f64) -> Outcome<N> {
    move |start, end, tolerance| {
        let (start, sparse) = (SVector::from(start), OutputType::Sparse);
        let mut method = Dop853::from_param(
            Of(rates),
            0.0,
            end,
            end,
            start,
            tolerance,
            tolerance,
            0.9,
            0.0,
            0.333,
            6.0,
            end,
            0.0,
            MOST_STEPS,
            1000,
            sparse,
        );
        let counts = method.integrate()?;
        let last = method.y_out().last().ok_or("there is no state")?;
        Ok((counts.accepted_steps as usize, (*last).into()))
    }
}

fn differential_equations<R: Rates<N> + Copy, const N: usize>(
    rates: R,
) -> impl Fn([f64; N], f64, f64) -> Outcome<N> {
    move |start, end, tolerance| {
        let method =
            ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(MOST_STEPS as usize);
        let system = Of(rates);
        let solution = IVP::ode(&system, 0.0, end, start)
            .method(method)
            .solve()
            .map_err(|error| format!("{error:?}"))?;
        let (_, last) = solution.last()?;
        Ok((solution.steps.accepted, *last))
    }
}

/// A system with the traits of both crates.
struct Of<R>(R);

impl<R: Rates<N>, const N: usize> System<f64, SVector<f64, N>> for Of<R> {
    fn system(&self, time: f64, state: &SVector<f64, N>, rates: &mut SVector<f64, N>) {
        *rates = SVector::from(self.0.at(time, &state.data.0[0]));
    }
}

impl<R: Rates<N>, const N: usize> ODE<f64, [f64; N]> for Of<R> {
    fn diff(&self, time: f64, state: &[f64; N], rates: &mut [f64; N]) {
        *rates = self.0.at(time, state);
    }
}
