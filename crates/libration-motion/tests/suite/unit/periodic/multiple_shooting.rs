use libration::expression::Equation;
use libration::internals::periodic::{Flow, Frame, Nodes, Piece};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

const PIECES: u32 = 16;

/// The orbit of an equation with the period 2π, computed by Newton's method from the starts of the pieces.
fn closed(equation: &str, start: impl Fn(f64) -> f64) -> Option<Vec<f64>> {
    let equation: Equation = equation.parse().unwrap();
    let flow = Flow::new(&equation, &[], 10_000).unwrap();
    let time = |number: u32| TAU * f64::from(number) / f64::from(PIECES);
    let states = (0..PIECES).map(|number| vec![start(time(number))]).collect();
    let piece = |number: usize, state: &[f64], _: &[f64]| {
        let number = u32::try_from(number).ok()?;
        let times = [time(number), time(number + 1)];
        let variations = flow.variations(state, &[], times, 1e-16, || ControlFlow::Continue(())).ok()?;
        Some(Piece { end: variations.end, by_start: variations.by_start, by_further: vec![] })
    };
    let frame = Frame { units: &[0.1], shift: &[0.0], conditions: &[] };
    let closed = Nodes { states, further: vec![] }.closed(frame, piece)?;
    Some(closed.states.into_iter().flatten().collect())
}

/// x′ = 10x + cos t has the orbit (sin t − 10·cos t)/101, about which deviations grow by e^(20π) = 2e27 in a period.
#[test]
fn an_orbit_is_found_from_node_to_node_however_fast_deviations_grow() {
    let exact = |t: f64| (libm::sin(t) - 10.0 * libm::cos(t)) / 101.0;
    for aside in [0.0, 1e-3, 1.0] {
        let states = closed("x' = 10*x + cos(t)", |t| exact(t) + aside * libm::cos(3.0 * t)).unwrap();
        for (number, x) in (0..PIECES).zip(&states) {
            let t = TAU * f64::from(number) / f64::from(PIECES);
            // The allowed error at a joint is 32·(1 + M)·ε·(1 + |x|/0.1)·0.1, and that of a node this divided by M − 1.
            assert!((x - exact(t)).abs() < 2e-15, "{number}: {x:?} from {aside}");
        }
    }
}

/// The orbit of another equation is not one of this equation: with the mean 1/1000 of the force the orbit is lower by a tenth of that.
#[test]
fn the_orbit_of_another_equation_moves_to_that_of_this_one() {
    let exact = |t: f64| (libm::sin(t) - 10.0 * libm::cos(t)) / 101.0;
    let states = closed("x' = 10*x + cos(t) + 1/1000", exact).unwrap();
    assert!((states[0] - exact(0.0) + 1e-4).abs() < 2e-15, "{:?}", states[0]);
    // x′ = 1 + cos t has no periodic orbit.
    assert_eq!(closed("x' = 1 + cos(t)", exact), None);
}

/// An end that changes by 1e-9 with the period misses the start by 0.1 and is closed by a period 1e8 times as long: no orbit next to this one.
#[test]
fn a_period_that_runs_away_is_not_followed() {
    let piece = |_: usize, state: &[f64], further: &[f64]| {
        assert!((0.0..2.0).contains(&further[0]), "{further:?}");
        let end = vec![state[0] + 0.1 + 1e-9 * (further[0] - 1.0)];
        Some(Piece { end, by_start: vec![vec![1.0]], by_further: vec![vec![1e-9]] })
    };
    let frame = Frame { units: &[1.0, 1.0], shift: &[0.0], conditions: &[vec![1.0, 0.0]] };
    assert!(Nodes { states: vec![vec![0.0]], further: vec![1.0] }.closed(frame, piece).is_none());
}
