//! The largest Lyapunov exponent: closed forms, an independent computation, and the requirement that an integrable system is never `Chaotic`.

use super::integrable::{Case, cases};
use libration::chaos::{
    Doubt, LyapunovError, LyapunovExponent, LyapunovVerdict, Regularity, Schedule, Theorem, lyapunov_exponent,
};
use libration::progress::{Progress, Quiet, Status};
use libration::taylor::{Cause, Effort, Moment};
use libration_testing::golden::Table;
use std::ops::ControlFlow;

fn attempt(
    equation: &str,
    start: &[f64],
    intervals: usize,
    watch: &dyn Progress,
) -> Result<LyapunovExponent, LyapunovError> {
    attempt_to(1e-13, equation, start, intervals, watch)
}

fn attempt_to(
    tolerance: f64,
    equation: &str,
    start: &[f64],
    intervals: usize,
    watch: &dyn Progress,
) -> Result<LyapunovExponent, LyapunovError> {
    let equation = equation.parse().unwrap();
    let start = Moment { time: 0.0, state: start.to_vec() };
    let effort = Effort::to_tolerance(tolerance);
    let schedule = Schedule::natural(&equation, &start, intervals, &effort)?;
    lyapunov_exponent(&equation, &start, &schedule, &effort, watch)
}

fn measure(equation: &str, start: &[f64], intervals: usize) -> LyapunovExponent {
    attempt(equation, start, intervals, &Quiet).unwrap()
}

/// The number of regular motions, and that of motions that are undecided or escape over a barrier; none may be chaotic.
fn census(cases: &[Case], intervals: usize, tolerance: f64) -> [usize; 2] {
    let mut counts = [0; 2];
    for Case { equation, start } in cases {
        let exponent = attempt_to(tolerance, equation, start, intervals, &Quiet);
        match exponent.map(|exponent| exponent.verdict) {
            Ok(LyapunovVerdict::Regular(_)) => counts[0] += 1,
            Ok(LyapunovVerdict::Undecided(_)) | Err(LyapunovError::Integration(_)) => counts[1] += 1,
            Err(error) => panic!("{equation} from {start:?}: {error}"),
            Ok(LyapunovVerdict::Chaotic) => panic!("{equation} from {start:?} is integrable"),
        }
    }
    counts
}

#[test]
fn no_integrable_motion_is_called_chaotic() {
    let cases = cases();
    assert!(cases.len() >= 200, "{}", cases.len());
    let [regular, undecided] = census(&cases, 200, 1e-13);
    // Motions next to a separatrix stay undecided.
    assert!(regular > 2 * undecided, "{regular} regular, {undecided} undecided");
}

#[test]
#[ignore = "minutes: ten times as long as the census above, and at several tolerances"]
fn no_integrable_motion_is_called_chaotic_in_the_long_run_or_at_any_tolerance() {
    for (intervals, tolerance) in [(2500, 1e-13), (1000, 1e-6), (1000, 1e-9), (1000, 1e-11), (1000, 1e-16)] {
        let [regular, undecided] = census(&cases(), intervals, tolerance);
        assert!(
            regular > undecided,
            "{intervals} at {tolerance:e}: {regular} regular, {undecided} undecided"
        );
    }
}

/// The first of neighbouring motions with a verdict: where chaos is weak, one in four is without growth for a tenth of its time.
fn decided(equation: &str, start: &[f64]) -> LyapunovExponent {
    const NEIGHBOURS: u32 = 8;
    let mut motions = (0..NEIGHBOURS).map(|neighbour| {
        let mut start = start.to_vec();
        start[1] += 1e-13 * f64::from(neighbour);
        measure(equation, &start, 2000)
    });
    let undecided =
        |exponent: &LyapunovExponent| exponent.verdict == LyapunovVerdict::Undecided(Doubt::Unsteady);
    motions.find(|exponent| !undecided(exponent)).expect("eight in a row are one in 65 000")
}

#[test]
fn chaotic_motions_have_the_exponents_of_the_table() {
    for row in Table::read("lyapunov.csv").rows() {
        let start: Vec<f64> = row.text("start").split(' ').map(|number| number.parse().unwrap()).collect();
        let growth = decided(row.text("equation"), &start);
        assert_eq!(growth.verdict, LyapunovVerdict::Chaotic, "{}", row.text("equation"));
        let bound = 4.0 * (growth.uncertainty + row.input("error"));
        let error = growth.exponent - row.input("exponent");
        assert!(
            error.abs() < bound,
            "{}: {} ± {}",
            row.text("equation"),
            growth.exponent,
            growth.uncertainty
        );
        assert!(growth.uncertainty < 0.2 * growth.exponent, "{} ± {}", growth.exponent, growth.uncertainty);
    }
}

#[test]
fn the_double_pendulum_released_from_120_degrees_is_chaotic() {
    let equation = "a'' = (-2 sin(a) - sin(a-b) (b'^2 + a'^2 cos(a-b)) + cos(a-b) sin(b))/(2 - cos(a-b)^2); \
                    b'' = (sin(a-b)*(2 a'^2 + b'^2 cos(a-b)) + 2 sin(a) cos(a-b) - 2 sin(b))/(2 - cos(a-b)^2)";
    let angle = 120_f64.to_radians();
    assert_eq!(measure(equation, &[angle, angle, 0.0, 0.0], 120).verdict, LyapunovVerdict::Chaotic);
    assert!(matches!(measure(equation, &[0.1, 0.1, 0.0, 0.0], 100).verdict, LyapunovVerdict::Regular(_)));
}

#[test]
fn a_damped_linear_oscillator_has_minus_half_its_damping() {
    for equation in ["x'' + 0.2 x' + x = cos(1.7 t)", "x'' + 0.2 x' + 9 x = 0"] {
        let growth = measure(equation, &[1.0, 0.0], 400);
        assert!(
            (growth.exponent + 0.1).abs() < 3.0 * growth.uncertainty + 1e-6,
            "{equation}: {}",
            growth.exponent
        );
        assert!(growth.uncertainty < 2e-3 && matches!(growth.verdict, LyapunovVerdict::Regular(_)));
    }
}

#[test]
fn in_its_regular_windows_the_driven_pendulum_is_regular() {
    // Locked to the drive: the area in the phase plane shrinks as e^(−t/2), half of it in each direction.
    for amplitude in ["0.9", "1.35", "1.47"] {
        let growth =
            measure(&format!("theta'' + theta'/2 + sin(theta) = {amplitude} cos(2t/3)"), &[0.2, 0.0], 300);
        assert!(matches!(growth.verdict, LyapunovVerdict::Regular(_)), "{amplitude}: {:?}", growth.verdict);
        assert!(growth.exponent > -0.2501 && growth.exponent < -0.01, "{amplitude}: {}", growth.exponent);
    }
}

#[test]
fn theorems_decide_where_they_hold() {
    // At the unstable equilibrium deviations grow as eᵗ for ever, but the motion is not chaotic.
    let growth = measure("x'' = x - x^3", &[0.0, 0.0], 400);
    assert!((growth.exponent - 1.0).abs() < 1e-12);
    assert_eq!(growth.verdict, LyapunovVerdict::Regular(Regularity::Theorem(Theorem::Plane)));
    let parametric = measure("x'' = -(1 + cos(2 t)/2)*x", &[1.0, 0.0], 50);
    assert!(parametric.exponent > 0.1, "{}", parametric.exponent);
    assert_eq!(parametric.verdict, LyapunovVerdict::Regular(Regularity::Theorem(Theorem::Linear)));
}

#[test]
fn an_unstable_motion_inside_chaos_or_not_is_not_called_chaotic() {
    let wells = "x'' = x - x^3 + (y - x)/10; y'' = y - y^3 + (x - y)/10";
    // Both at rest at the maximum; both together, a periodic motion with unstable neighbours.
    let rest = measure(wells, &[0.0, 0.0, 0.0, 0.0], 100).verdict;
    assert_eq!(rest, LyapunovVerdict::Regular(Regularity::AtRest));
    let together = measure(wells, &[0.1, 0.1, 0.0, 0.0], 300);
    assert!(together.exponent > 0.3, "{}", together.exponent);
    assert!(
        matches!(together.verdict, LyapunovVerdict::Undecided(Doubt::Neighbours { .. })),
        "{:?}",
        together.verdict
    );
}

#[test]
fn units_do_not_matter() {
    let usual = measure("x'' + 0.05 x' + x^3 = 7.5 cos(t)", &[3.0, 4.0], 500);
    // Lengths in thousandths, times in units a thousand times as long.
    let scaled = measure("x'' + 50 x' + x^3 = 7.5e9 cos(1000 t)", &[3e3, 4e6], 500);
    assert_eq!(scaled.verdict, usual.verdict);
    let difference = scaled.exponent / 1e3 - usual.exponent;
    assert!(difference.abs() < 4.0 * (usual.uncertainty + scaled.uncertainty / 1e3), "{difference}");
}

#[test]
fn an_interruption_keeps_the_estimate() {
    let stop = |progress: Status| {
        if progress.done >= 50 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let growth = attempt("theta'' + theta'/2 + sin(theta) = 1.5 cos(2t/3)", &[0.2, 0.0], 400, &stop).unwrap();
    assert_eq!(growth.verdict, LyapunovVerdict::Undecided(Doubt::Stopped(Cause::Interrupted)));
    let (time, last) = *growth.convergence.last().unwrap();
    assert!((time / (1.5 * std::f64::consts::PI) - 50.0).abs() < 1e-9 && last == growth.exponent);
}
