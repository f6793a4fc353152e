//! Continued integrations are the same as uninterrupted ones, bit for bit.

use libration::systems::Model;
use libration::taylor::{
    Checkpoint, Effort, Event, IntegrationError, Moment, Solution, Start, System, integrate_from,
};
use std::ops::ControlFlow;

/// Equations with a start: smooth, driven, with kinks, with sticking by dry friction, next to a pole, with two coordinates.
const MOTIONS: [(&str, &[f64]); 6] = [
    ("x'' = -sin(x)", &[3.0, 0.0]),
    ("x'' = -sin(x) - x'/2 + 1.2*cos(2*t/3)", &[0.1, 0.0]),
    ("x'' = -x - abs(x)/3 - 0.1*x'*abs(x')", &[1.0, 0.0]),
    ("x'' = -x - 0.3*sign(x') + cos(t/3)/2", &[2.0, 0.0]),
    ("x'' = 1/x^2 - 1", &[0.1, 0.0]),
    ("x'' = -x - 2*x*y; y'' = -y - x^2 + y^2", &[0.0, 0.3, 0.3, 0.0]),
];

fn system(equation: &str) -> System {
    let events = ["x'", "x - 0.2"].map(|formula| Event::zero_of(formula.parse().unwrap()));
    System::new(&equation.parse().unwrap()).unwrap().with_events(&events).unwrap()
}

fn run(system: &System, start: &Start, times: &[f64], tolerance: f64) -> (Solution, Vec<Checkpoint>, usize) {
    let (mut checkpoints, mut steps) = (vec![], 0);
    let outcome = integrate_from(system, start, times, &Effort::to_tolerance(tolerance), |step| {
        checkpoints.extend(step.checkpoint());
        steps += 1;
        ControlFlow::Continue(())
    });
    (outcome.unwrap(), checkpoints, steps)
}

fn at(state: &[f64]) -> Start {
    Start::State(Moment { time: 0.0, state: state.to_vec() })
}

#[test]
fn from_every_step_the_motion_goes_on_as_it_did() {
    for (equation, start) in MOTIONS {
        let system = system(equation);
        for (tolerance, end) in [(1e-9, 20.0), (1e-15, -8.0)] {
            let times: Vec<f64> = (1..=40).map(|n| end * f64::from(n) / 40.0).collect();
            let (whole, checkpoints, steps) = run(&system, &at(start), &times, tolerance);
            assert!(checkpoints.len() > 1 && checkpoints.len() < steps, "{equation}: {}", checkpoints.len());
            for checkpoint in checkpoints {
                let time = checkpoint.time;
                let later = |other: f64| other.abs() > time.abs();
                let rest: Vec<f64> = times.iter().copied().filter(|&time| later(time)).collect();
                let (resumed, ..) = run(&system, &Start::Checkpoint(checkpoint), &rest, tolerance);
                let samples = &whole.samples[times.len() - rest.len()..];
                assert_eq!(resumed.samples, samples, "{equation} from {time}");
                assert_eq!(
                    (&resumed.end, resumed.steps),
                    (&whole.end, whole.steps),
                    "{equation} from {time}"
                );
                let events = &whole.events[whole.events.len() - resumed.events.len()..];
                assert_eq!(resumed.events, events, "{equation} from {time}");
                assert!(
                    resumed.events.len() >= whole.events.iter().filter(|event| later(event.time)).count(),
                    "{equation} from {time}"
                );
            }
        }
    }
}

#[test]
fn a_motion_to_a_nearer_goal_gives_checkpoints_of_the_farther_one() {
    for (equation, start) in MOTIONS {
        assert_same_from_nearer_goals(equation, start);
    }
}

fn assert_same_from_nearer_goals(equation: &str, start: &[f64]) {
    let system = system(equation);
    let (whole, ..) = run(&system, &at(start), &[20.0], 1e-12);
    for nearer in [0.01, 0.3, 4.0, 7.7, 19.99] {
        let (_, checkpoints, _) = run(&system, &at(start), &[nearer], 1e-12);
        let from = checkpoints.last().cloned().map_or(at(start), Start::Checkpoint);
        let (resumed, ..) = run(&system, &from, &[20.0], 1e-12);
        assert_eq!((resumed.end, resumed.steps), (whole.end.clone(), whole.steps), "{equation} at {nearer}");
    }
}

#[test]
fn steps_that_only_the_goal_ends_are_no_checkpoints() {
    // A polynomial reaches the goal in one step.
    let fall = System::new(&"x'' = -1".parse().unwrap()).unwrap();
    let (_, checkpoints, steps) = run(&fall, &at(&[1.0, 0.0]), &[3.0], 1e-12);
    assert_eq!((checkpoints.len(), steps), (0, 1));
}

#[test]
fn a_checkpoint_of_another_system_is_refused() {
    let (equation, start) = MOTIONS[1];
    let (_, mut checkpoints, _) = run(&system(equation), &at(start), &[5.0], 1e-9);
    let good = checkpoints.remove(0);
    let refused = |checkpoint: Checkpoint, equation: &str| {
        let start = Start::Checkpoint(checkpoint);
        let outcome = integrate_from(&system(equation), &start, &[9.0], &Effort::to_tolerance(1e-9), |_| {
            ControlFlow::Continue(())
        });
        assert_eq!(outcome, Err(IntegrationError::OtherCheckpoint));
    };
    refused(good.clone(), MOTIONS[2].0);
    refused(good.clone(), MOTIONS[5].0);
    refused(Checkpoint { unit: 0.0, ..good.clone() }, equation);
    refused(Checkpoint { time: f64::NAN, ..good.clone() }, equation);
    refused(Checkpoint { events: vec![], ..good }, equation);
}

#[test]
fn the_account_of_the_energy_goes_on_as_it_did() {
    let model = Model::typed("x'' = -x - x^3/(1 + x^2)", &[], &[]).unwrap();
    let energy = model.energy().unwrap();
    let moment = |time: f64| Moment { time, state: vec![libm::cos(time), -libm::sin(time)] };
    let mut whole = energy.balance(&moment(0.0));
    let moments: Vec<Moment> = (1..20).map(|n| moment(0.3 * f64::from(n))).collect();
    moments[..7].iter().for_each(|moment| whole.record(moment));
    let account = whole.account().clone();
    let mut rest = energy.balance_from(&account);
    for moment in &moments[7..] {
        whole.record(moment);
        rest.record(moment);
    }
    assert!(whole.drift() > 0.0);
    assert_eq!(rest.account(), whole.account());
    assert_eq!((rest.drift(), rest.drift_uncertainty()), (whole.drift(), whole.drift_uncertainty()));
}
