//! Forces that underflow in `f64` at the start of a step, but act inside it: walls, dents, pulses.
//!
//! The result is checked by the energy of the motion, which the integration does not use.

use libration::orbit::Orbit;
use libration::progress::Quiet;
use libration::taylor::{Effort, Moment, Solution, System, Trajectory, integrate, integrate_many};

fn solve(equation: &str, state: [f64; 2], times: &[f64], tolerance: f64) -> Solution {
    let system = System::new(&equation.parse().unwrap()).unwrap();
    let start = Moment { time: 0.0, state: state.to_vec() };
    integrate(&system, &start, times, &Effort::to_tolerance(tolerance), &Quiet).unwrap()
}

fn even_times(end: f64) -> Vec<f64> {
    (1..=100).map(|part| end * f64::from(part) / 100.0).collect()
}

const TOLERANCES: [f64; 3] = [1e-9, 1e-12, 1e-15];

/// Checks that the relative change of the energy is at most 1e5 tolerances.
fn keeps_its_energy(equation: &str, potential: impl Fn(f64) -> f64, start: f64, time: f64, scale: f64) {
    for tolerance in TOLERANCES {
        let samples = solve(equation, [start, 0.0], &even_times(time), tolerance).samples;
        for Moment { time, state } in samples {
            let energy = 0.5 * state[1] * state[1] + potential(state[0]);
            let change = (energy - potential(start)).abs() / scale;
            let allowed = 1e5 * tolerance.max(1e-16);
            assert!(change < allowed, "{equation} from {start} to {tolerance:e} at {time}: {change:e}");
        }
    }
}

/// Periods of x″ = 1 − eˣ, 2∫dx/√(2(E − eˣ + x)), by mpmath.
const WALL_PERIODS: [(f64, f64); 4] = [
    (1.0, 6.663_856_021_591_779),
    (5.0, 34.619_594_268_112_04),
    (10.0, 419.789_015_477_567_99),
    (20.0, 62_300.253_405_332_77),
];

#[test]
fn an_exponential_wall_throws_back_whatever_comes_from_however_far() {
    let potential = |x: f64| libm::exp(x) - x;
    for (start, period) in WALL_PERIODS {
        keeps_its_energy("x'' = 1 - exp(x)", potential, start, 2.3 * period, potential(start));
        let once = solve("x'' = 1 - exp(x)", [start, 0.0], &[period], 1e-15).end.state;
        // The end of the rise contains eˣ, so that rounding errors of the time matter.
        let allowed = 1e-9 * libm::exp(start) * period;
        assert!((once[0] - start).abs() < allowed && once[1].abs() < allowed, "{start}: {once:?}");
    }
}

/// Periods of oscillators with a steep force on one side or on both, 2∫dx/√(2(E − V)) by mpmath; those of the Morse
/// potential are 2π/√(−2E), and those of −sinh x are 4K(tanh²(x/2))/cosh(x/2).
const STEEP_PERIODS: [(&str, &[(f64, f64)]); 4] = [
    (
        "x'' = 1 - exp(x)",
        &[
            (5.0, 34.619_594_268_112_04),
            (7.5, 120.313_920_451_121_735),
            (7.7, 132.958_197_561_018_901),
            (7.8, 139.770_931_963_072_902),
            (7.9, 146.933_166_905_665_661),
            (8.0, 154.462_811_649_999_126),
            (10.0, 419.789_015_477_579_868),
            (16.0, 8_431.423_085_957_664_04),
        ],
    ),
    ("x'' = exp(-2*x) - exp(-x)", &[(-0.693_147, 7_393.315_238_774_164_38)]),
    ("x'' = -sinh(x)", &[(5.0, 2.096_895_928_725_085_6), (20.0, 0.003_883_745_047_498_675_51)]),
    (
        "x'' = -x - exp(x)",
        &[
            (5.0, 3.861_691_277_628_150_67),
            (10.0, 3.250_012_411_814_921_43),
            (25.0, 3.141_731_716_840_294_52),
        ],
    ),
];

#[test]
fn orbits_against_steep_walls_have_their_periods() {
    for (equation, periods) in STEEP_PERIODS {
        for &(start, period) in periods {
            let orbit = Orbit::released(&equation.parse().unwrap(), start, &Quiet).unwrap();
            let (error, uncertainty) = ((orbit.period() - period).abs(), orbit.period_uncertainty());
            assert!(error <= uncertainty, "{equation} from {start}: {error:e} > {uncertainty:e}");
            assert!(uncertainty <= 1e-11 * period, "{equation} from {start}: {uncertainty:e}");
        }
    }
}

/// On the other side the motion turns at −2e17, where an f64 is a multiple of 32, and the wall has a width of about one.
#[test]
fn a_wall_that_is_narrower_than_the_numbers_next_to_the_turning_point_is_refused() {
    assert!(Orbit::released(&"x'' = 1 - exp(x)".parse().unwrap(), 40.0, &Quiet).is_err());
}

/// The force at the start, 1 − 1e-105, changes no coefficient that can be seen, and at −600 and −700 its change is 1e-261 and 1e-304: the time
/// scale of the first terms is too large by up to 2¹⁴⁰. The momentum and time of flight are those of a constant force.
#[test]
fn a_start_in_free_flight_before_a_wall_has_a_step() {
    for start in [-30.0, -100.0, -241.2, -300.0, -600.0, -700.0, -745.0, -1e4] {
        let solution = solve("x'' = 1 - exp(x)", [start, -74.0], &[1.0, 100.0], 1e-16);
        let [x, v] = solution.samples[0].state[..] else { panic!() };
        assert!((x - (start - 73.5)).abs() < 1e-11 && (v + 73.0).abs() < 1e-13, "{start}: {x} {v}");
        let [x, v] = solution.samples[1].state[..] else { panic!() };
        assert!((x - (start - 2_400.0)).abs() < 1e-9 && (v - 26.0).abs() < 1e-12, "{start}: {x} {v}");
    }
}

/// At 6e15 the power x¹³ of the formula is 1e205, and overflows before any coefficient of the motion does; the motion is free.
#[test]
fn powers_far_away_do_not_stop_a_free_motion() {
    for start in [1e6, 1e9, 6e12, 6e15, 1e20] {
        let solution = solve("x'' = 12*x^(-13) - 12*x^(-7)", [start, 0.25], &[100.0 * start], 1e-16);
        let [x, v] = solution.end.state[..] else { panic!() };
        assert!((x / start - 26.0).abs() < 1e-14 && (v - 0.25).abs() < 1e-15, "{start:e}: {x} {v}");
    }
}

#[test]
fn two_exponential_walls_hold_a_motion_between_them() {
    let potential = |x: f64| 2.0 * libm::cosh(x);
    for (start, time) in [(2.0, 50.0), (10.0, 5.0), (20.0, 0.05), (40.0, 1e-5)] {
        keeps_its_energy("x'' = -exp(x) + exp(-x)", potential, start, time, potential(start));
    }
}

#[test]
fn a_wall_behind_a_spring_is_not_passed_through() {
    let potential = |x: f64| 0.005 * x * x + libm::exp(x) - x;
    for start in [-15.0, -150.0, -1500.0] {
        keeps_its_energy("x'' = -0.01*x - exp(x) + 1", potential, start, 100.0, potential(start));
    }
}

#[test]
fn high_powers_are_walls_too() {
    for start in [0.001, 1.0, 1.5] {
        let potential = |x: f64| libm::pow(x, 22.0) / 22.0;
        keeps_its_energy("x'' = -x^21", potential, start, 20.0, potential(start));
        let potential = |x: f64| 0.5 * x * x + libm::pow(x, 102.0) / 102.0;
        keeps_its_energy("x'' = -x - x^101", potential, start.min(1.1), 20.0, potential(start.min(1.1)));
    }
}

#[test]
fn a_dent_in_a_wide_well_is_not_stepped_over() {
    let potential = |x: f64| 5e-5 * x * x - 5.0 * libm::exp(-x * x);
    for start in [15.0, 150.0, -1500.0] {
        keeps_its_energy(
            "x'' = -1e-4*x - 10*x*exp(-x^2)",
            potential,
            start,
            400.0,
            potential(start).max(5.0),
        );
    }
    let potential = |x: f64| 0.5 * x * x - libm::pow(1.0 + x * x, -50.0);
    keeps_its_energy("x'' = -x - 100*x*(1 + x^2)^(-51)", potential, 10.0, 20.0, 50.0);
    let potential = |x: f64| 0.5 * x * x - libm::pow(libm::cosh(20.0 * x), -2.0);
    keeps_its_energy("x'' = -x - 40*tanh(20*x)/cosh(20*x)^2", potential, 5.0, 20.0, 12.5);
}

#[test]
fn a_pulse_in_the_time_gives_its_momentum() {
    // 1000√(π/k).
    for (sharpness, momentum) in [("1e2", 177.245_385_090_551_6), ("1e6", 1.772_453_850_905_516)] {
        let equation = format!("x'' = 1000*exp(-{sharpness}*(t - 20)^2)");
        for tolerance in TOLERANCES {
            let end = solve(&equation, [1.0, 0.0], &[50.0], tolerance).end.state[1];
            let error = (end / momentum - 1.0).abs();
            // The time at 20 is rounded to 2e-15, whose effect on the exponent is 1e6·2e-15·1e-3.
            assert!(error < 1e4 * tolerance.max(1e-15), "{equation} to {tolerance:e}: {error:e}");
        }
    }
}

#[test]
fn motions_against_walls_are_the_same_in_lanes() {
    let system = System::new(&"x'' = 1 - exp(x)".parse().unwrap()).unwrap();
    let times = even_times(60.0);
    let start = |start: f64| Moment { time: 0.0, state: vec![start, 0.0] };
    let starts = [0.1, 5.0, 1.0, 6.0, 10.0, 3.0, 20.0, 4.0, 5.5, 2.0];
    let trajectories: Vec<Trajectory<'_>> = starts
        .iter()
        .map(|&from| Trajectory { start: start(from), parameters: vec![], times: &times })
        .collect();
    let effort = Effort::to_tolerance(1e-12);
    let many = integrate_many(&system, &trajectories, &effort, &Quiet);
    for (trajectory, many) in trajectories.iter().zip(many) {
        let one = trajectory.integrate(&system, &effort, &Quiet).unwrap();
        assert_eq!(many.unwrap(), one);
    }
}
