//! Responses whose coordinates are of another order of magnitude than 1: those of the same equation in other units.

use libration::continuation::{Response, ResponseOptions, SpecialKind};
use libration::progress::Quiet;

/// Parameters of all special points, with their kinds.
fn special(
    equation: &str,
    parameter: &str,
    range: [f64; 2],
    start: Option<Vec<f64>>,
) -> Vec<(SpecialKind, f64)> {
    let options = ResponseOptions { start, ..ResponseOptions::default() };
    let response = Response::over(&equation.parse().unwrap(), parameter, range, &options, &Quiet).unwrap();
    let points = response.branches.iter().flat_map(|branch| &branch.special);
    points.map(|it| (it.kind, it.point.parameter)).collect()
}

/// Duffing's equation with hardening at amplitudes of 1, 1e-12 and 1e-10 s; a drive that grows.
#[test]
fn a_response_has_the_same_folds_in_all_units() {
    let usual = special("x'' = -0.1*x' - x - x^3 + 0.3*cos(w*t)", "w", [0.5, 2.0], None);
    assert!(usual.len() == 2 && usual.iter().all(|(kind, _)| *kind == SpecialKind::Fold), "{usual:?}");
    for (equation, range, unit) in [
        ("x'' = -0.1*x' - x - 1e24*x^3 + 3e-13*cos(w*t)", [0.5, 2.0], 1.0),
        ("x'' = -0.1*x' - x - 1e18*x^3 + 3e-10*cos(w*t)", [0.5, 2.0], 1.0),
        ("x'' = -1e5*x' - 1e12*x - 1e30*x^3 + 3e2*cos(w*t)", [5e5, 2e6], 1e6),
        ("x'' = -0.1*x' - x - 1e-24*x^3 + 3e11*cos(w*t)", [0.5, 2.0], 1.0),
    ] {
        let found = special(equation, "w", range, None);
        assert_eq!(found.len(), 2, "{equation}: {found:?}");
        for ((kind, own), (of_usual, other)) in found.iter().zip(&usual) {
            assert!(kind == of_usual && (own / (unit * other) - 1.0).abs() < 1e-12, "{equation}: {found:?}");
        }
    }
    let drives = special("x'' = -0.1*x' - x - 1e24*x^3 + A*1e-12*cos(1.5*t)", "A", [0.1, 1.0], None);
    let usual = special("x'' = -0.1*x' - x - x^3 + A*cos(1.5*t)", "A", [0.1, 1.0], None);
    assert_eq!(drives.len(), usual.len(), "{drives:?}");
    assert!(
        drives.iter().zip(&usual).all(|(own, other)| (own.1 / other.1 - 1.0).abs() < 1e-12),
        "{drives:?}"
    );
}

/// A drive without the symmetry of the force, which at amplitudes of 1 is far below the rounding of the force.
#[test]
fn a_small_drive_decides_the_symmetry() {
    let equation = "x'' = -0.1*x' - x - 1e24*x^3 + 3e-13*cos(w*t) + 2e-13*cos(2*w*t)";
    let options = ResponseOptions::default();
    let response = Response::over(&equation.parse().unwrap(), "w", [1.9, 2.0], &options, &Quiet).unwrap();
    let point = &response.branches[0].points[0];
    let [low, high] = point.ranges[0];
    assert!((low + high).abs() > 0.05 * high, "{point:?}");
}

#[test]
fn a_small_start_without_a_drive_is_in_its_own_units() {
    let equation = "x'' = (mu - 1e24*x^2)*x' - x".parse().unwrap();
    let options = ResponseOptions { start: Some(vec![1e-12, 0.0]), ..ResponseOptions::default() };
    let response = Response::over(&equation, "mu", [0.5, 2.0], &options, &Quiet).unwrap();
    let last = response.branches[0].points.last().unwrap();
    let usual = "x'' = (mu - x^2)*x' - x".parse().unwrap();
    let options = ResponseOptions { start: Some(vec![1.0, 0.0]), ..ResponseOptions::default() };
    let other = Response::over(&usual, "mu", [0.5, 2.0], &options, &Quiet).unwrap();
    let other = other.branches[0].points.last().unwrap();
    assert!((1e12 * last.ranges[0][1] / other.ranges[0][1] - 1.0).abs() < 1e-10, "{last:?} {other:?}");
}
