use libration::expression::Equation;
use libration::progress::Quiet;
use libration::taylor::{Effort, Moment, System, integrate, with_tangents};

fn end(equation: &Equation, state: &[f64], time: f64) -> Vec<f64> {
    let system = System::new(equation).unwrap();
    let start = Moment { time: 0.0, state: state.to_vec() };
    integrate(&system, &start, &[time], &Effort::to_tolerance(1e-15), &Quiet).unwrap().end.state
}

/// Two coordinates that are coupled through velocities and the time.
const COUPLED: &str = "x'' = -sin(x) - y'*x'/(2 + cos(y)) + cos(t); y'' = x*y - y^3 - y'/5 + x'^2";

#[test]
fn deviations_are_the_limit_of_differences_of_motions() {
    let equation: Equation = COUPLED.parse().unwrap();
    let (state, time, step) = ([0.4, -0.3, 0.2, 0.1], 3.0, 1e-5);
    for (column, coordinate) in [0, 1, 4, 5].into_iter().zip(0..4) {
        let shifted = |by: f64| {
            let mut state = state;
            state[coordinate] += by;
            end(&equation, &state, time)
        };
        let mut start = vec![0.4, -0.3, 0.0, 0.0, 0.2, 0.1, 0.0, 0.0];
        start[column + 2] = 1.0;
        let tangent = end(&with_tangents(&equation, 1), &start, time);
        let difference = shifted(step).into_iter().zip(shifted(-step)).map(|(a, b)| (a - b) / (2.0 * step));
        for (computed, expected) in [2, 3, 6, 7].map(|n| tangent[n]).into_iter().zip(difference) {
            // The third derivative times step²/6, and rounding errors over the step.
            assert!((computed - expected).abs() < 1e-8, "{computed} {expected}");
        }
    }
}

#[test]
fn without_deviations_nothing_is_added() {
    let equation: Equation = COUPLED.parse().unwrap();
    assert_eq!(with_tangents(&equation, 0).accelerations(), equation.accelerations());
    assert_eq!(with_tangents(&equation, 3).variables().len(), 8);
}
