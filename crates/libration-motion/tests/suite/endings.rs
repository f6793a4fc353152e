//! The stated error of the end of a motion, compared with the actual error. The rounding errors of the closed forms are far smaller.

use libration::pendulum::{Motion, Pendulum};
use libration::progress::Quiet;
use libration::quantity::Angle;
use libration::taylor::{Effort, Event, Moment, System, ending_error, integrate};
use std::f64::consts::PI;

pub(crate) const TOLERANCES: [f64; 5] = [1e-6, 1e-9, 1e-12, 1e-15, 1e-16];

/// A component at the end, its exact value, and its stated error.
type Compared = [f64; 3];

/// The end of a motion at an event, and its stated error.
fn ended(equation: &str, start: &[(&str, f64)], ending: &Event, tolerance: f64) -> [Moment; 2] {
    const LAST: f64 = 1e7;
    let system = System::new(&equation.parse().unwrap()).unwrap();
    let system = system.with_events(std::slice::from_ref(ending)).unwrap();
    let (start, effort) = (system.start(start).unwrap(), Effort::to_tolerance(tolerance));
    let end = integrate(&system, &start, &[LAST], &effort, &Quiet).unwrap().end;
    let error = ending_error(&system, &start, LAST, &effort, &end).unwrap();
    [end, error]
}

fn first_zero_of(formula: &str) -> Event {
    Event { ends_at: Some(1), ..Event::zero_of(formula.parse().unwrap()) }
}

/// Comparisons for a pendulum at a given time, and at the last passage of the bottom before that time.
fn of_pendulum(amplitude: f64, exact: &Motion, last: f64, tolerance: f64) -> [Compared; 4] {
    const EQUATION: &str = "theta'' = -sin(theta)";
    let start = [("theta", amplitude)];
    let [end, error] = ended(EQUATION, &start, &first_zero_of(&format!("t - {last}")), tolerance);
    let there = exact.state_at(last);
    let swings = (2.0 * last / exact.period()).floor();
    let passages = (1..).zip(0..=1000).find(|(_, before)| f64::from(*before) >= swings).unwrap().0;
    let bottom = Event { ends_at: Some(passages), ..first_zero_of("theta") };
    let [at_bottom, error_there] = ended(EQUATION, &start, &bottom, tolerance);
    let when = exact.period() / 4.0 * (2.0 * swings + 1.0);
    let speed = 2.0 * libm::sin(0.5 * amplitude);
    [
        [end.state[0], there.angle, error.state[0]],
        [end.state[1], there.velocity, error.state[1]],
        [at_bottom.time, when, error_there.time],
        [at_bottom.state[1].abs(), speed, error_there.state[1]],
    ]
}

/// From next to the bottom to next to the top, where rounding errors grow a thousandfold in each swing.
#[test]
fn stated_errors_of_pendulums_hold_and_are_not_far_too_large() {
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    for amplitude in [0.5, 2.0, 2.9, 3.0, 3.1, 3.14] {
        let exact = pendulum.released_from(Angle::from_radians(amplitude).unwrap()).unwrap();
        for tolerance in TOLERANCES {
            let (mut largest, mut largest_stated) = (0.0, 0.0);
            for last in [10.0, 31.0, 100.0, 316.0] {
                for [computed, truth, stated] in of_pendulum(amplitude, &exact, last, tolerance) {
                    let off = (computed - truth).abs();
                    assert!(off <= stated, "{amplitude} {tolerance:e} {last}: {off:e} {stated:e}");
                    largest = f64::max(largest, off);
                    largest_stated = f64::max(largest_stated, stated);
                }
            }
            // Above the rounding errors the stated error comes from the second integration;
            // otherwise from a sum of bounds, which is at most 826 times too large.
            let most = if tolerance > 1e-10 { 1.6 } else { 1000.0 };
            assert!(
                largest_stated <= most * largest,
                "{amplitude} {tolerance:e}: {largest:e} {largest_stated:e}"
            );
        }
    }
}

/// A ball that is attracted to zero by the same force from both sides, starting at 1.
fn drawn_to_zero(time: f64) -> Vec<f64> {
    let half = 2.0 * libm::sqrt(2.0);
    let number = libm::round(time / half);
    let since = time - half * number;
    let side = if number % 2.0 == 0.0 { 1.0 } else { -1.0 };
    vec![side * (1.0 - 0.5 * since * since), -side * since]
}

/// A spring of stiffness 3/2 on one side and 1/2 on the other.
fn two_springs(time: f64) -> Vec<f64> {
    let (stiff, soft) = (libm::sqrt(1.5), libm::sqrt(0.5));
    let period = PI / stiff + PI / soft;
    let time = time - period * (time / period).floor();
    let quarter = 0.5 * PI / stiff;
    if time < quarter {
        return vec![libm::cos(stiff * time), -stiff * libm::sin(stiff * time)];
    }
    if time < quarter + PI / soft {
        let since = time - quarter;
        return vec![-stiff / soft * libm::sin(soft * since), -stiff * libm::cos(soft * since)];
    }
    let since = time - quarter - PI / soft;
    vec![libm::sin(stiff * since), stiff * libm::cos(stiff * since)]
}

pub(crate) struct Known {
    pub(crate) equation: &'static str,
    pub(crate) start: &'static [(&'static str, f64)],
    pub(crate) state: fn(f64) -> Vec<f64>,
}

/// Terms that cancel, constants that are not doubles, small motions far from zero, quotients, forces that jump and bend.
pub(crate) const KNOWN: [Known; 11] = [
    Known { equation: "x' = 0.1", start: &[("x", 1.0)], state: |t| vec![1.0 + t / 10.0] },
    Known { equation: "x' = -x", start: &[("x", 1.0)], state: |t| vec![libm::exp(-t)] },
    Known { equation: "x' = 1 - x^2", start: &[("x", 0.0)], state: |t| vec![libm::tanh(t)] },
    Known {
        equation: "x'' = -x*0.01",
        start: &[("x", 1.0)],
        state: |t| vec![libm::cos(0.1 * t), -0.1 * libm::sin(0.1 * t)],
    },
    Known {
        equation: "x'' = -x + cos(3*t)*8",
        start: &[("x", -1.0)],
        state: |t| vec![-libm::cos(3.0 * t), 3.0 * libm::sin(3.0 * t)],
    },
    Known {
        equation: "x'' = (1000000 + x) - (1000000 + 2*x)",
        start: &[("x", 1.0)],
        state: |t| vec![libm::cos(t), -libm::sin(t)],
    },
    Known {
        equation: "x'' = 1000 - x",
        start: &[("x", 1001.0)],
        state: |t| vec![1000.0 + libm::cos(t), -libm::sin(t)],
    },
    Known { equation: "x'' = -sign(x)", start: &[("x", 1.0)], state: drawn_to_zero },
    Known { equation: "x'' = -x - abs(x)/2", start: &[("x", 1.0)], state: two_springs },
    Known {
        equation: "x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2)",
        start: &[("x", 1.0), ("y'", 1.0)],
        state: |t| vec![libm::cos(t), libm::sin(t), -libm::sin(t), libm::cos(t)],
    },
    Known {
        equation: "x'' = x",
        start: &[("x", 1.0), ("x'", -1.0)],
        state: |t| vec![libm::exp(-t), -libm::exp(-t)],
    },
];

#[test]
fn stated_errors_of_other_motions_hold() {
    for Known { equation, start, state } in KNOWN {
        for last in [3.7, 37.3, 373.1] {
            for tolerance in TOLERANCES {
                let ending = first_zero_of(&format!("t - {last:?}"));
                let [end, error] = ended(equation, start, &ending, tolerance);
                for ((computed, truth), stated) in end.state.iter().zip(state(last)).zip(&error.state) {
                    let off = (computed - truth).abs();
                    assert!(off <= *stated, "{equation} {last} {tolerance:e}: {off:e} {stated:e}");
                }
            }
        }
    }
}

/// At a double zero of a formula its rate of change passes through zero.
#[test]
fn the_time_of_a_touch_is_right_to_what_is_stated() {
    let touch = Event { ends_at: Some(2), ..first_zero_of("x + 1") };
    for tolerance in TOLERANCES {
        let [end, error] = ended("x'' = -x", &[("x", 1.0)], &touch, tolerance);
        let off = (end.time - 3.0 * PI).abs();
        assert!(off <= error.time, "{tolerance:e}: {off:e} {error:?}");
        assert!(error.time < 1e4 * tolerance.max(1e-16), "{tolerance:e}: {error:?}");
    }
}

/// A step of Newton's method is a fraction of the distance to a multiple zero.
#[test]
fn multiple_zeros_are_within_their_errors() {
    for (root, time) in [("x", 0.5 * PI), ("(x - 1/2)", PI / 3.0), ("(x + sqrt(3)/2)", 5.0 / 6.0 * PI)] {
        for power in ["^2", "^3", "^4", "^5", "^6", "^7", "^9", "^3*(2 + x')", "^5*exp(t)"] {
            for tolerance in TOLERANCES {
                let ending = first_zero_of(&format!("{root}{power}"));
                let [end, error] = ended("x'' = -x", &[("x", 1.0)], &ending, tolerance);
                let off = (end.time - time).abs();
                assert!(
                    off <= error.time && error.time < 0.5,
                    "{root}{power} {tolerance:e}: {off:e} {error:?}"
                );
                let exact = [libm::cos(time), -libm::sin(time)];
                for ((value, exact), error) in end.state.iter().zip(exact).zip(&error.state) {
                    assert!(
                        (value - exact).abs() <= *error,
                        "{root}{power} {tolerance:e}: {value} {exact} {error}"
                    );
                }
            }
        }
    }
}

/// Motions some of whose neighbours end, as for sqrt(x) below zero, and motions with too many steps for the integration of each step's neighbour.
#[test]
fn where_roundings_are_not_followed_more_is_stated_of_the_rest() {
    for (equation, last) in [("x' = -sqrt(x); y'' = -y", 10.0), ("x'' = -x/4; y'' = -y", 4e5)] {
        let start = [("x", 1.0), ("y", 1.0)];
        let [end, error] = ended(equation, &start, &first_zero_of(&format!("t - {last:?}")), 1e-6);
        let velocity = end.state.len() - 1;
        let off = (end.state[velocity] + libm::sin(last)).abs();
        let stated = error.state[velocity];
        assert!(5.0 * off < stated && stated < 20.0 * off, "{equation}: {off:e} {stated:e}");
    }
}

/// One third of a second is not an `f64`, and nothing else is rounded.
#[test]
fn the_last_rounding_counts() {
    let [end, error] = ended("x' = 3", &[("x", 0.0)], &first_zero_of("x - 1"), 1e-15);
    let off = end.time.mul_add(3.0, -1.0).abs() / 3.0;
    assert!(0.0 < off && off <= error.time && error.time < 1e-15, "{off:e} {error:?}");
}

/// In 900 units of Lorenz's time rounding errors grow by e⁸¹⁵: the stated error is then as large as the attractor, and finite.
#[test]
fn what_is_stated_of_chaos_is_as_large_as_the_attractor() {
    const LORENZ: &str = "x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z";
    let start = [("x", 1.0), ("y", 1.0), ("z", 20.0)];
    let [end, error] = ended(LORENZ, &start, &first_zero_of("t - 900"), 1e-12);
    assert!(error.state.iter().all(|error| (1.0..1000.0).contains(error)), "{end:?} {error:?}");
}

/// One third of a million seconds is not an `f64`; each of 1319 jumps adds to the error.
#[test]
fn times_of_jumps_are_rounded() {
    for equation in ["x' = sign(3*t - 1000000)", "y' = 3; x' = sign(y - 1000000)"] {
        let [end, error] = ended(equation, &[], &first_zero_of("t - 666666"), 1e-12);
        let x = end.state.len() - 1;
        let off = (end.state[x] + 2.0 / 3.0).abs();
        assert!(1e-11 < off && off <= error.state[x] && error.state[x] < 1e-9, "{off:e} {error:?}");
    }
    let [end, error] = ended("x'' = -sign(x)", &[("x", 1.0)], &first_zero_of("t - 3731.3"), 1e-12);
    for ((computed, truth), stated) in end.state.iter().zip(drawn_to_zero(3731.3)).zip(&error.state) {
        assert!((computed - truth).abs() <= *stated, "{computed} {truth} {stated:e}");
    }
}

/// The argument of the sign is known to 1e-10 only, and so is the time of the jump.
#[test]
fn arguments_of_jumps_are_rounded() {
    let [end, error] =
        ended("x' = sign((1000000 + t) - (1000000 + 1/3))", &[], &first_zero_of("t - 2/3"), 1e-12);
    let off = end.state[0].abs();
    assert!(1e-13 < off && off <= error.state[0] && error.state[0] < 1e-8, "{off:e} {error:?}");
}

/// The formula of an event is known to 1e-10 only, and so is the time of the event.
#[test]
fn formulas_of_events_are_rounded() {
    let event = first_zero_of("(1000000 + t) - (1000000 + 1/3)");
    let [end, error] = ended("x' = 3", &[("x", 0.0)], &event, 1e-15);
    let off = (end.time - 1.0 / 3.0).abs();
    assert!(1e-13 < off && off <= error.time && error.time < 1e-8, "{off:e} {error:?}");
    assert!((end.state[0] - 1.0).abs() <= error.state[0], "{end:?} {error:?}");
}
