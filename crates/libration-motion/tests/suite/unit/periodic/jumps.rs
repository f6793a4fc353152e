//! Derivatives of motions whose forces jump, against differences of neighbouring motions and exact properties of flows.

use crate::typed::equation;
use libration::internals::periodic::{Flow, Variations};
use libration::taylor::{IntegrationError, NoDerivative};
use libration_testing::random::Random;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::ops::ControlFlow;

const TOLERANCE: f64 = 1e-16;

fn flow(text: &str, parameters: &[&str]) -> Flow {
    Flow::new(&equation(text), parameters, 100_000).unwrap()
}

fn variations(
    flow: &Flow,
    state: &[f64],
    parameters: &[f64],
    times: [f64; 2],
) -> Result<Variations, IntegrationError> {
    flow.variations(state, parameters, times, TOLERANCE, || ControlFlow::Continue(()))
}

fn end(flow: &Flow, state: &[f64], parameters: &[f64], times: [f64; 2]) -> Vec<f64> {
    flow.motion(state, parameters, times, TOLERANCE, |_| ControlFlow::Continue(())).unwrap().end.state
}

/// The central difference of the ends of two motions, one of whose inputs is displaced.
fn difference(flow: &Flow, inputs: [&[f64]; 2], displaced: [usize; 2], times: [f64; 2]) -> Vec<f64> {
    const ASIDE: f64 = 1e-6;
    let moved = |distance: f64| {
        let mut inputs = inputs.map(<[f64]>::to_vec);
        inputs[displaced[0]][displaced[1]] += distance;
        end(flow, &inputs[0], &inputs[1], times)
    };
    moved(ASIDE).iter().zip(moved(-ASIDE)).map(|(a, b)| (a - b) / (2.0 * ASIDE)).collect()
}

fn assert_near(computed: impl Iterator<Item = f64>, other: &[f64], what: &str) {
    // The third derivative of the flow, of the order of 10 to 1000, times 1e-12/6; the rounding of the ends, 1e-15, over 1e-6.
    const ALLOWED: f64 = 1e-7;
    for (number, (computed, other)) in computed.zip(other).enumerate() {
        let error = (computed - other).abs();
        assert!(error <= ALLOWED * (1.0 + other.abs()), "{what}, {number}: {computed} is not {other}");
    }
}

/// All derivatives of a motion are the differences of its neighbours.
fn assert_derivatives(flow: &Flow, state: &[f64], parameters: &[f64], times: [f64; 2], what: &str) {
    let computed = variations(flow, state, parameters, times).unwrap();
    let own_end = end(flow, state, parameters, times);
    assert_near(computed.end.iter().copied(), &own_end, &format!("{what}: end"));
    for start in 0..state.len() {
        let other = difference(flow, [state, parameters], [0, start], times);
        let column = computed.by_start.iter().map(|row| row[start]);
        assert_near(column, &other, &format!("{what}: by component {start}"));
    }
    for (number, column) in computed.by_parameters.iter().enumerate() {
        let other = difference(flow, [state, parameters], [1, number], times);
        assert_near(column.iter().copied(), &other, &format!("{what}: by parameter {number}"));
    }
}

#[test]
fn piecewise_linear_oscillators_have_the_derivatives_of_their_flow() {
    let mut random = Random::seeded(20);
    for number in 0..12 {
        let dry = if number % 2 == 0 { "- b*sign(x')" } else { "+ b*sign(x')/3" };
        let text = format!("x'' = -c*x' - x - a*sign(x) {dry} + cos(w*t)");
        let flow = flow(&text, &["a", "b", "c", "w"]);
        let [a, b, c, w] = std::array::from_fn(|_| random.between(0.0, 1.0));
        let parameters = [a, 0.5 * b, 0.3 * c, 0.5 + w];
        let state = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        assert_derivatives(&flow, &state, &parameters, [0.0, 7.3], &format!("{text} at {parameters:?}"));
    }
}

#[test]
fn surfaces_may_depend_on_everything() {
    let cases = [
        ("x'' = -x + 0.3*sign(cos(w*t))", vec![0.3, 0.1]),
        ("x'' = -x - 0.1*x' + 0.5*sign(x - w*sin(t) + 0.2*x')", vec![0.4, 0.2]),
        ("x'' = -x*(2 + sign(x' - w*x)) - 0.1*x'", vec![0.7, 0.3]),
        ("x' = 1 + 0.5*sign(y); y' = 2 - sin(x) + w*sign(x)", vec![-0.9, -0.7]),
        (
            "x'' = -x - 0.2*sign(x' - y')/2 + cos(w*t); y'' = -2*y + 0.4*sign(x' - y' + x)",
            vec![0.3, 0.2, 0.5, 0.1],
        ),
        ("x'' = -x + abs(x - 0.2) + 0.3*sign(x + abs(x')) - 0.1*w*x'", vec![-0.9, 0.7]),
    ];
    for (text, state) in cases {
        assert_derivatives(&flow(text, &["w"]), &state, &[1.3], [0.2, 6.1], text);
    }
}

/// Friction holds the velocity at zero, the second time at the end of the motion.
#[test]
fn deviations_of_a_velocity_end_where_it_sticks() {
    for text in [
        "x'' = -0.1*x' - x - b*sign(x') + 0.3*cos(0.3*t)",
        "x'' = -x - b*sign(x') + 0.3*cos(0.3*t); y'' = -y - b*sign(x')*(1 + y) - 0.3*x",
    ] {
        let flow = flow(text, &["b"]);
        let state = if flow.layout.numbers() == 2 { vec![0.5, 0.2] } else { vec![0.5, 0.1, 0.2, 0.3] };
        let mut slid = 0;
        for to in [3.0, 5.0, 9.0, 13.7, 16.0, 21.0] {
            assert_derivatives(&flow, &state, &[0.1], [0.0, to], &format!("{text} to {to}"));
            let computed = variations(&flow, &state, &[0.1], [0.0, to]).unwrap();
            let velocity = flow.layout.driven(0);
            if computed.end[velocity] == 0.0 {
                slid += 1;
                assert!(computed.by_start[velocity].iter().all(|x| *x == 0.0), "{text} to {to}");
            }
        }
        assert!((1..6).contains(&slid), "{text}: {slid} of the ends are at rest");
    }
}

/// The flow of equations without the time maps the rate at the start to the rate at the end, also from one jump to another, 1e-13 being a
/// hundred roundings of rates up to 4.
#[test]
fn the_rate_of_an_autonomous_motion_is_carried_along() {
    let text = "x'' = -0.2*x' - x + 0.5*sign(x')";
    let flow = flow(text, &[]);
    let maximum = 3.193_411_592_178_863;
    let period = 6.314_838_833_996_553;
    let states = [vec![maximum, 0.0], vec![1.0, 0.3], vec![-2.0, 0.0]];
    for (state, to) in states.iter().flat_map(|state| [1.0, 4.0, 0.5 * period, period].map(|to| (state, to)))
    {
        let computed = variations(&flow, state, &[], [0.0, to]).unwrap();
        for (row, rate) in computed.by_start.iter().zip(&computed.rates[1]) {
            let carried: f64 = row.iter().zip(&computed.rates[0]).map(|(a, b)| a * b).sum();
            assert!((carried - rate).abs() < 1e-13, "{state:?} to {to}: {carried} is not {rate}");
        }
    }
}

/// Consecutive pieces have the derivative of the whole, also if they meet at a jump or in a sliding motion.
#[test]
fn derivatives_of_pieces_multiply_to_that_of_the_whole() {
    // The force of the first changes at x = 0, which its motion cos t passes at π/2 and 3π/2.
    let cases = [
        ("x'' = -x + 0.3*sign(cos(t))*x'", vec![1.0, 0.2], FRAC_PI_2),
        ("x'' = -x - 0.4*sign(x)*x'", vec![0.0, 0.6], 3.0),
        ("x'' = -0.1*x' - x - 0.1*sign(x') + 0.3*cos(0.3*t)", vec![0.5, 0.2], 9.0),
    ];
    for (text, state, middle) in cases {
        let flow = flow(text, &[]);
        let whole = variations(&flow, &state, &[], [0.0, TAU]).unwrap();
        let first = variations(&flow, &state, &[], [0.0, middle.min(TAU - 0.5)]).unwrap();
        let second = variations(&flow, &first.end, &[], [middle.min(TAU - 0.5), TAU]).unwrap();
        for i in 0..2 {
            for j in 0..2 {
                let product: f64 = (0..2).map(|k| second.by_start[i][k] * first.by_start[k][j]).sum();
                let error = (product - whole.by_start[i][j]).abs();
                assert!(error < 1e-12, "{text}: {product} is not {}", whole.by_start[i][j]);
            }
        }
    }
}

#[test]
fn a_motion_that_touches_a_jump_has_no_derivative() {
    // Below x = 1 the motion is sin t.
    let flow = flow("x'' = -x - (1 + sign(x - 1))/4", &[]);
    let outcome = variations(&flow, &[0.0, 1.0], &[], [0.0, 3.0]);
    let Err(IntegrationError::NoDerivative { cause, time }) = outcome else { panic!("{outcome:?}") };
    assert_eq!(cause, NoDerivative::Grazing);
    assert!((time - FRAC_PI_2).abs() < 1e-6, "{time}");
    for speed in [0.999, 1.001] {
        variations(&flow, &[0.0, speed], &[], [0.0, 3.0]).unwrap();
    }
}

#[test]
fn jumps_at_one_time_have_a_derivative_if_their_order_does_not_matter() {
    let apart = flow("x'' = -x - sign(x)/4; y'' = -y - sign(y)/4", &[]);
    let alone = flow("x'' = -x - sign(x)/4", &[]);
    let both = variations(&apart, &[0.7, 0.7, 0.2, 0.2], &[], [0.0, 7.0]).unwrap();
    let one = variations(&alone, &[0.7, 0.2], &[], [0.0, 7.0]).unwrap();
    assert!((both.by_start[3][3] - one.by_start[1][1]).abs() < 1e-13);
    assert_eq!(both.by_start[3][2], 0.0);

    let together = flow("x' = 1 + 0.5*sign(y); y' = 1 + 0.3*sign(x)", &[]);
    let outcome = variations(&together, &[-0.5, -0.7], &[], [0.0, 2.0]);
    let Err(IntegrationError::NoDerivative { cause: NoDerivative::Together, time }) = outcome else {
        panic!("{outcome:?}")
    };
    assert!((time - 1.0).abs() < 1e-14, "{time}");
}
