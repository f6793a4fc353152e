//! Sub- and superharmonic responses found from free oscillations, compared with shooting by SciPy's DOP853 at 2.3e-14 with the variational
//! equations, and with Fourier collocation and Taylor shooting in floats of 130 bits.

use libration::continuation::{
    Branch, BranchError, Ending, OrderFinding, Origin, Response, ResponseOptions, SpecialKind,
};
use libration::progress::Quiet;

fn sought(equation: &str, range: [f64; 2], orders: &[&str]) -> Result<Response, BranchError> {
    let orders = orders.iter().map(|order| order.parse().unwrap()).collect();
    let options = ResponseOptions { orders, generations: 0, ..ResponseOptions::default() };
    Response::over(&equation.parse().unwrap(), "w", range, &options, &Quiet)
}

fn folds(branch: &Branch) -> Vec<f64> {
    let folds = branch.special.iter().filter(|special| special.kind == SpecialKind::Fold);
    folds.map(|fold| fold.point.parameter).collect()
}

#[test]
fn an_isola_that_no_sweep_meets_is_found_and_followed_once_around() {
    let response = sought("x'' = -0.15*x' - x - x^3 + 5*cos(w*t)", [2.5, 6.0], &["1/3"]).unwrap();
    let [primary, isola, resonance] = &response.branches[..] else {
        panic!("{} branches", response.branches.len())
    };
    // The main resonance ends in a fold near the backbone, at the amplitude 5/(0.15 w) to first order.
    assert!(resonance.origin == Origin::Primary && resonance.points[0].is_stable());
    // The isola is not connected with the primary branch.
    assert!(primary.special.is_empty() && primary.points.iter().all(|point| point.is_stable()));
    assert_eq!((isola.origin, isola.ending), (Origin::FreeOscillation, Ending::Closed));
    assert_eq!((isola.space.drive_periods(), isola.points.first()), (3, isola.points.last()));
    for expected in [5.294354133015056, 3.648857400987054] {
        assert!(folds(isola).iter().any(|w| (w - expected).abs() < 1e-12), "{:?}", folds(isola));
    }
    assert_eq!(isola.special.len(), 2);
    assert_eq!((response.orders[0].branches, response.orders[0].finding), (1, OrderFinding::Found));
}

#[test]
fn the_subharmonic_answer_of_a_hard_oscillator_has_its_fold() {
    let response = sought("x'' = -0.05*x' - x - x^3 + 5*cos(w*t)", [9.0, 11.0], &["1/3"]).unwrap();
    let folds = folds(&response.branches[1]);
    assert!(folds.len() == 1 && (folds[0] - 10.02822141013707399662466).abs() < 1e-12, "{folds:?}");
}

#[test]
fn answers_that_are_followed_already_are_not_followed_again() {
    let response = sought("x'' = -0.1*x' - x - x^3/4 + 0.3*cos(w*t)", [0.8, 1.6], &["1"]).unwrap();
    assert_eq!((response.orders[0].branches, response.orders[0].finding), (0, OrderFinding::Found));
    assert!(response.branches.iter().all(|branch| branch.origin == Origin::Primary));
}

#[test]
fn an_order_without_answers_says_why() {
    let finding = |equation: &str, order: &str| {
        let response = sought(equation, [2.5, 6.0], &[order]).unwrap();
        assert!(response.branches.iter().all(|branch| branch.origin == Origin::Primary));
        response.orders[0].finding
    };
    // A symmetric oscillation has no even harmonic on which the drive could do work.
    assert_eq!(finding("x'' = -0.1*x' - x - x^3 + cos(w*t)", "1/2"), OrderFinding::NoWork);
    assert_eq!(finding("x'' = -0.1*x' - x + cos(w*t)", "1/3"), OrderFinding::NoOscillation);
    let weak = |c: &str| finding(&format!("x'' = -{c}*x' - x - x^3 + 0.1*cos(w*t)"), "1/3");
    let (OrderFinding::TooWeak(once), OrderFinding::TooWeak(half)) = (weak("0.2"), weak("0.4")) else {
        panic!("{:?}", weak("0.2"))
    };
    assert!(once < 1.0 && (once - 2.0 * half).abs() < 1e-9, "{once} {half}");
}

#[test]
fn orders_belong_to_one_driven_oscillator() {
    let pair = "x'' = -x - x' + y + cos(w*t); y'' = -2*y - y' + x";
    assert_eq!(sought(pair, [1.0, 2.0], &["1/3"]).unwrap_err(), BranchError::NotOneOscillator);
    assert_eq!(sought("x'' = w*(1 - x^2)*x' - x", [1.0, 2.0], &["1/3"]).unwrap_err(), BranchError::NotDriven);
}
