//! The same system in two forms has the same special points.

use crate::typed::equation;
use libration::continuation::{Response, ResponseOptions};
use libration::progress::Quiet;

/// The special points over a range, in the order of the parameter, and the number of branches.
fn special_points(text: &str, [from, to]: [f64; 2]) -> (Vec<(String, f64, f64)>, usize) {
    let options = ResponseOptions { generations: 1, ..ResponseOptions::default() };
    let response = Response::over(&equation(text), "w", [from, to], &options, &Quiet).unwrap();
    let special = response.branches.iter().flat_map(|branch| &branch.special);
    let mut special: Vec<_> =
        special.map(|special| (special.kind.to_string(), special.point.parameter, special.error)).collect();
    special.sort_by(|a, b| a.1.total_cmp(&b.1));
    (special, response.branches.len())
}

fn assert_same(a: &str, b: &str, range: [f64; 2]) {
    let [(first, branches), (second, others)] = [a, b].map(|text| special_points(text, range));
    assert_eq!(branches, others, "{a}, {b}");
    assert_eq!(first.len(), second.len(), "{a}: {first:?}; {b}: {second:?}");
    for ((kind, at, error), (other_kind, other, other_error)) in first.into_iter().zip(second) {
        assert_eq!(kind, other_kind, "{a}, {b} at {at}, {other}");
        assert!((at - other).abs() <= error + other_error, "{a}, {b}: {kind} at {at} and {other}");
    }
}

#[test]
fn a_pendulum_by_half_angles_has_the_same_folds() {
    let driven = |force: &str| format!("x'' = -x'/10 - {force} + 0.15*cos(w*t)");
    assert_same(&driven("sin(x)"), &driven("2*sin(x/2)*cos(x/2)"), [1.4, 0.3]);
}

/// The cycle of the Brusselator begins at b = 2, whichever equation comes first: next to it terms of y' are equal, and only rounding is left.
#[test]
fn the_order_of_equations_does_not_change_a_hopf_point() {
    for text in ["x' = 1 - (b+1)*x + x^2*y; y' = b*x - x^2*y", "y' = b*x - x^2*y; x' = 1 - (b+1)*x + x^2*y"] {
        let options = ResponseOptions { at: Some(2.15), ..ResponseOptions::default() };
        let response = Response::over(&equation(text), "b", [1.99, 2.2], &options, &Quiet).unwrap();
        let special = &response.branches[0].special;
        assert!(
            special.len() == 1 && (special[0].point.parameter - 2.0).abs() < 1e-13,
            "{text}: {special:?}"
        );
    }
}
