//! Motions that are integrated together are the same as single ones, bit for bit, whatever times are requested.

use libration::progress::Quiet;
use libration::systems::Model;
use libration::taylor::{
    Cause, Effort, Ensemble, IntegrationError, Moment, System, Trajectory, integrate_many,
};
use std::cell::Cell;
use std::ops::ControlFlow;

/// Smooth equations, and equations with a drive, with kinks, with sticking by dry friction, and with two coordinates.
const SYSTEMS: [(&str, &[f64]); 5] = [
    ("x'' = -sin(x)", &[3.0, 0.0]),
    ("x'' = -sin(x) - x'/2 + 1.2*cos(2*t/3)", &[0.1, 0.0]),
    ("x'' = -x - abs(x)/3 - 0.1*x'*abs(x')", &[1.0, 0.0]),
    ("x'' = -x - 0.3*sign(x') + cos(t/3)/2", &[2.0, 0.0]),
    ("x'' = -x - 2*x*y; y'' = -y - x^2 + y^2", &[0.0, 0.3, 0.3, 0.0]),
];

/// More starts than lanes, all different.
fn starts(first: &[f64], count: u32) -> Vec<Moment> {
    let beside = |n: u32| first.iter().map(|value| value + 1e-3 * f64::from(n)).collect();
    (0..count).map(|n| Moment { time: 0.0, state: beside(n) }).collect()
}

/// The states of all motions at each of these times, each motion integrated towards a much later time.
fn alone(system: &System, starts: &[Moment], times: &[f64], effort: &Effort) -> Vec<Vec<f64>> {
    let times: Vec<f64> = times.iter().copied().chain([1e3]).collect();
    let trajectories: Vec<_> = starts
        .iter()
        .map(|start| Trajectory { start: start.clone(), parameters: vec![], times: &times })
        .collect();
    let solutions: Vec<_> =
        integrate_many(system, &trajectories, effort, &Quiet).into_iter().map(Result::unwrap).collect();
    let at =
        |index: usize| solutions.iter().flat_map(|solution| solution.samples[index].state.clone()).collect();
    (0..times.len() - 1).map(at).collect()
}

#[test]
fn each_motion_is_the_one_that_is_followed_alone() {
    for (equation, first) in SYSTEMS {
        let system = System::new(&equation.parse().unwrap()).unwrap();
        for (tolerance, step) in [(1e-8, 1.0 / 30.0), (1e-14, 2.5)] {
            let (effort, starts) = (Effort::to_tolerance(tolerance), starts(first, 37));
            let times: Vec<f64> = (0..40).map(|n| step * f64::from(n)).collect();
            let mut ensemble = Ensemble::new(system.clone(), &starts, &effort).unwrap();
            for (time, expected) in times.iter().zip(alone(&system, &starts, &times, &effort)) {
                assert_eq!(ensemble.states_at(*time, &Quiet).unwrap(), expected, "{equation} at {time}");
            }
            assert_eq!((ensemble.len(), ensemble.ended().count()), (37, 0));
        }
    }
}

#[test]
fn what_was_stopped_goes_on_where_it_was() {
    let system = Model::by_key("double_pendulum", &[], &[]).unwrap().system().unwrap();
    let (effort, starts) = (Effort::to_tolerance(1e-8), starts(&[2.0, 2.0, 0.0, 0.0], 100));
    let mut whole = Ensemble::new(system.clone(), &starts, &effort).unwrap();
    let mut sliced = whole.clone();
    let mut slices = 0;
    let states = loop {
        slices += 1;
        let asked = Cell::new(0);
        let ask = |_| {
            asked.set(asked.get() + 1);
            if asked.get() > 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        if let Ok(states) = sliced.states_at(3.0, &ask) {
            break states;
        }
    };
    assert!(slices > 10, "{slices}");
    assert_eq!(states, whole.states_at(3.0, &Quiet).unwrap());
    assert!(
        whole.states_at(0.0, &Quiet).unwrap().iter().all(|number| number.is_nan()),
        "steps behind are not kept"
    );
}

#[test]
fn motions_that_end_are_told_and_do_not_hold_up_the_others() {
    // x = 1/(1/x(0) − t) diverges at t = 1/x(0).
    let system = System::new(&"x' = x^2".parse().unwrap()).unwrap();
    let starts: Vec<Moment> = [1.0, 0.1, 0.0].map(|x| Moment { time: 0.0, state: vec![x] }).into();
    let mut ensemble = Ensemble::new(system, &starts, &Effort::to_tolerance(1e-12)).unwrap();
    let states = ensemble.states_at(2.0, &Quiet).unwrap();
    assert!(states[0].is_nan() && (states[1] - 0.125).abs() < 1e-12 && states[2] == 0.0, "{states:?}");
    let ended: Vec<_> = ensemble.ended().collect();
    assert!(
        matches!(ended[..], [(0, Cause::StepUnderflow | Cause::Singularity | Cause::OutOfRange)]),
        "{ended:?}"
    );
    assert!(ensemble.states_at(1e300, &Quiet).unwrap().iter().all(|number| number.is_nan()));
}

#[test]
fn what_cannot_be_is_refused() {
    let system = |text: &str| System::new(&text.parse().unwrap()).unwrap();
    let start = |state: &[f64]| vec![Moment { time: 0.0, state: state.to_vec() }];
    let made = |state: &[f64], tolerance| {
        Ensemble::new(system("x'' = -x"), &start(state), &Effort::to_tolerance(tolerance)).err()
    };
    assert_eq!(made(&[1.0], 1e-8), Some(IntegrationError::StateLength { got: 1, wanted: 2 }));
    assert_eq!(made(&[1.0, 0.0], 0.0), Some(IntegrationError::Tolerance { relative: 0.0, absolute: 0.0 }));
    assert!(made(&[1.0, 0.0], 1e-8).is_none());
}
