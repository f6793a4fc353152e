//! Fitted swings that go on after their last row, compared with the true motion.

use libration::progress::Quiet;

use libration::decay::{DecayEnding, DecayError};
use libration::taylor::{Direction, Effort, Event, Moment, System, integrate};
use libration_lab::fit::Uncertain;
use libration_lab::fit::trace::{ContinuationError, FittedTurningPoint, TraceFit, TraceOptions, fit_traces};

use crate::random::Random;
use crate::synthetic_trace::Synthetic;

/// 20 s, 60° falling to 50°, seen to 3 mrad.
const SWING: Synthetic = Synthetic { step: 0.04, rows: 500, noise: 0.003, ..Synthetic::USUAL };

fn fitted(swing: &Synthetic, model: &str, seed: u64) -> TraceFit {
    let trace = swing.trace(&mut Random::seeded(seed));
    let go_on = &Quiet;
    fit_traces(&[trace], model.parse().unwrap(), &TraceOptions::default(), go_on).unwrap()
}

/// Times and angles at which the true motion turns, by integration of the equation of motion.
fn truth(swing: &Synthetic, until: f64) -> Vec<[f64; 2]> {
    let Synthetic { omega0, linear, quadratic, .. } = *swing;
    let equation = format!(
        "theta'' = -{:e}*sin(theta) - {linear:e}*theta' - {quadratic:e}*theta'*abs(theta')",
        omega0 * omega0
    );
    let turn = Event { formula: "theta'".parse().unwrap(), direction: Direction::Any, ends_at: None };
    let system = System::new(&equation.parse().unwrap()).unwrap().with_events(&[turn]).unwrap();
    let start = Moment { time: 0.0, state: vec![swing.amplitude, swing.velocity] };
    let effort = Effort::to_tolerance(1e-12);
    let motion = integrate(&system, &start, &[until], &effort, &Quiet).unwrap();
    motion.events.iter().map(|event| [event.time, event.state[0].abs()]).collect()
}

/// Errors of time and amplitude over their uncertainties, at the turning point next to a time.
fn pulls(points: &[FittedTurningPoint], truth: &[[f64; 2]], time: f64) -> [f64; 2] {
    let distance = |point: &FittedTurningPoint| (point.time.value - time).abs();
    let point = points.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
    assert!(distance(point) < 1.2, "{point:?}");
    let apart = |turn: &[f64; 2]| (turn[0] - point.time.value).abs();
    let true_one = truth.iter().min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap();
    let pull = |computed: Uncertain, truth: f64| (computed.value - truth) / computed.uncertainty;
    [pull(point.time, true_one[0]), pull(point.amplitude, true_one[1])]
}

/// The root mean square of 20 pulls is between 0.61 and 1.41 in 99 of 100 cases.
#[test]
fn a_continued_swing_meets_the_true_one_within_its_uncertainty() {
    let quadratic = Synthetic { linear: 0.0, quadratic: 0.03, ..SWING };
    for (swing, model) in [(SWING, "linear"), (quadratic, "quadratic")] {
        let truth = truth(&swing, 101.0);
        let continued = |seed| fitted(&swing, model, seed).turning_points(0, 100.0).unwrap();
        let continuations: Vec<Vec<FittedTurningPoint>> = (1..=20).map(continued).collect();
        for time in [10.0, 40.0, 99.0] {
            let all: Vec<[f64; 2]> = continuations.iter().map(|points| pulls(points, &truth, time)).collect();
            for of in 0..2 {
                let mean = all.iter().map(|pulls| pulls[of] * pulls[of]).sum::<f64>() / 20.0;
                assert!((0.61..1.41).contains(&mean.sqrt()), "{model} {time} {of}: {all:?}");
            }
        }
        // What is not known of the damping makes the amplitude the less certain the further it is followed.
        let relative = |index: usize| continuations[0][index].amplitude.relative();
        let [early, late] = [10, continuations[0].len() - 1].map(relative);
        assert!(late > 3.0 * early, "{early} {late}");
    }
}

/// The first turning point is one of those that were measured.
#[test]
fn a_continuation_begins_within_the_trace() {
    let fit = fitted(&SWING, "linear", 1);
    let continued = fit.decay(0).unwrap();
    // The release is the first one.
    let first = truth(&SWING, 3.0)[1];
    assert!((continued.start - first[0]).abs() < 0.01, "{} {first:?}", continued.start);
    assert!((continued.decay.start().radians() - first[1]).abs() < 0.003);
    let points = fit.turning_points(0, 10.0).unwrap();
    assert!((points[0].time.value - continued.start).abs() < 1e-12);
    assert_eq!(continued.decay.damping(), &fit.decay_damping().unwrap());
}

/// Dry friction takes 2d/ω0² = 0.0111 rad in a half swing, and holds below d/ω0² = 0.0056.
#[test]
fn a_swing_with_dry_friction_is_followed_to_its_end() {
    let dry = Synthetic { dry: 0.05, linear: 0.0, amplitude: 0.3, rows: 350, noise: 0.001, ..SWING };
    let fit = fitted(&dry, "dry", 1);
    let decay = fit.decay(0).unwrap().decay;
    let mut swings = decay.swings();
    let turns = swings.by_ref().count();
    assert!(matches!(swings.ending(), Some(DecayEnding::Sticks | DecayEnding::StopsOnTheWay { .. })));
    // From 0.2889 on, with the start.
    assert!((25..=27).contains(&turns), "{turns}");
    let points = fit.turning_points(0, 1000.0).unwrap();
    assert!(points.len() + 1 >= turns && points.len() <= turns, "{} {turns}", points.len());
}

#[test]
fn what_cannot_be_continued_is_said() {
    let fit = fitted(&SWING, "linear", 1);
    assert_eq!(fit.decay(1).unwrap_err(), ContinuationError::NoTrace { trace: 1, traces: 1 });
    let undamped = fitted(&Synthetic { linear: 0.0, ..SWING }, "undamped", 1);
    assert_eq!(undamped.decay(0).unwrap_err(), ContinuationError::Decay(DecayError::NoDamping));
    let growing = fitted(&Synthetic { linear: -0.02, ..SWING }, "linear", 1);
    assert!(matches!(growing.decay_damping(), Err(DecayError::Coefficient { .. })));
}
