//! The largest Lyapunov exponent: closed forms, an independent computation, and never `chaotic` where a system is integrable.

use super::integrable::{Case, cases};
use crate::golden::Table;
use libration::chaos::{LyapunovExponent, Regularity, Schedule, Theorem, Verdict, lyapunov_exponent};
use libration::taylor::{Effort, Moment};
use std::ops::ControlFlow;

fn measure(equation: &str, start: &[f64], intervals: usize) -> LyapunovExponent {
    let equation = equation.parse().unwrap();
    let start = Moment { time: 0.0, state: start.to_vec() };
    let effort = Effort::to_tolerance(1e-13);
    let schedule = Schedule::natural(&equation, &start, intervals, &effort).unwrap();
    lyapunov_exponent(&equation, &start, &schedule, &effort, |_| ControlFlow::Continue(())).unwrap()
}

/// How many motions are regular, chaotic and undecided.
fn census(cases: &[Case], intervals: usize) -> [usize; 3] {
    let mut counts = [0; 3];
    for Case { equation, start } in cases {
        let verdict = measure(equation, start, intervals).verdict;
        let place = match verdict {
            Verdict::Regular(_) => 0,
            Verdict::Chaotic => 1,
            Verdict::Undecided(_) => 2,
        };
        counts[place] += 1;
        if std::env::var("SHOW").is_ok() && place > 0 {
            println!("{equation} {start:?}: {} {}", verdict, verdict.reason());
        }
        assert!(verdict != Verdict::Chaotic, "{equation} from {start:?}");
    }
    counts
}

#[test]
fn no_integrable_motion_is_called_chaotic() {
    let cases = cases();
    assert!(cases.len() >= 200, "{}", cases.len());
    let counts = census(&cases, 400);
    println!("{counts:?}");
    assert!(counts[0] > 3 * counts[2], "{counts:?}");
}
