use libration::taylor::{Effort, Moment, System, integrate_stepwise};
use std::ops::ControlFlow;

/// Fewer and more times than are evaluated together, including start and end.
#[test]
fn many_values_are_those_of_the_states() {
    let system = System::new(&"theta'' + theta'/10 + sin(theta) = 0".parse().unwrap()).unwrap();
    let start = Moment { time: 3.0, state: vec![2.0, 0.3] };
    for end in [20.0, -20.0] {
        integrate_stepwise(&system, &start, &[end], &Effort::to_tolerance(1e-15), |step| {
            for parts in [1_u32, 5, 63, 100] {
                let length = (step.end() - step.start()) / f64::from(parts);
                let inner = (0..parts).map(|part| step.start() + length * f64::from(part));
                let times: Vec<f64> = inner.chain([step.end()]).collect();
                for number in 0..2 {
                    let mut values = vec![f64::NAN; times.len()];
                    step.values_at(number, &times, &mut values);
                    for (time, value) in times.iter().zip(values) {
                        let error = (value - step.state_at(*time)[number]).abs();
                        assert!(error <= 4.0 * f64::EPSILON * (1.0 + value.abs()), "{time}: {error}");
                    }
                }
            }
            ControlFlow::Continue(())
        })
        .unwrap();
    }
}
