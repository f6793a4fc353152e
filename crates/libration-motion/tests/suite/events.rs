//! Events during a motion, sticking by friction, and many motions side by side.

use libration::pendulum::Pendulum;
use libration::progress::Quiet;
use libration::quantity::Angle;
use libration::taylor::{
    Cause, Contact, Direction, Effort, Event, IntegrationError, Moment, Solution, System, Trajectory,
    ending_error, integrate, integrate_many, integrate_many_stepwise,
};
use libration_testing::random::Random;
use std::f64::consts::PI;
use std::ops::ControlFlow;

fn watched(equation: &str, events: &[(&str, Direction, bool)]) -> System {
    let event = |&(formula, direction, terminal): &(&str, Direction, bool)| Event {
        formula: formula.parse().unwrap(),
        direction,
        ends_at: terminal.then_some(1),
    };
    let events: Vec<Event> = events.iter().map(event).collect();
    System::new(&equation.parse().unwrap()).unwrap().with_events(&events).unwrap()
}

fn run(system: &System, state: &[f64], times: &[f64], tolerance: f64) -> Solution {
    let start = Moment { time: 0.0, state: state.to_vec() };
    integrate(system, &start, times, &Effort::to_tolerance(tolerance), &Quiet).unwrap()
}

/// Thresholds at 0.999 and 0.999999 of the amplitude, starting at any point of the orbit, for random
/// amplitudes, tolerances and durations: every crossing of the exact motion is found once and at its time.
fn crossings_next_to_the_amplitude(cases: u32) -> usize {
    let mut random = Random::seeded(11);
    let unit = Pendulum::from_angular_frequency(1.0).unwrap();
    let mut crossings = 0;
    for case in 0..cases {
        let amplitude = random.between(0.05, 3.0);
        let part = if case % 2 == 0 { 0.999 } else { 0.999999 };
        let threshold = part * amplitude;
        let exact = unit.released_from(Angle::from_radians(amplitude).unwrap()).unwrap();
        let period = exact.period();
        // The time at which the pendulum, released at zero, passes the threshold downward.
        let passes = time_at_angle(|t| exact.state_at(t).angle, threshold, 0.25 * period);
        let phase = random.between(0.0, 1.0) * period;
        let begin = exact.state_at(phase);
        let duration = random.between(1.0, 6.0) * period;
        let system = watched(
            &format!("theta'' = -sin(theta) + 0*{case}"),
            &[(&format!("theta - {threshold:?}"), Direction::Any, false)],
        );
        let tolerance = if case % 3 == 0 { 1e-9 } else { 1e-13 };
        let events = run(&system, &[begin.angle, begin.velocity], &[duration], tolerance).events;
        let wanted: Vec<f64> = (0..8)
            .map(f64::from)
            .flat_map(|turn| [turn * period - passes, turn * period + passes])
            .map(|time| time - phase)
            .filter(|&time| time > 0.0 && time < duration)
            .collect();
        assert_eq!(events.len(), wanted.len(), "{case}: {amplitude} from {phase}: {events:?} {wanted:?}");
        for (event, wanted) in events.iter().zip(&wanted) {
            // Next to the amplitude a small error of the angle corresponds to a larger one of the time.
            let bound = 1e4 * tolerance / (1.0 - part).sqrt() + 1e-11 / (1.0 - part).sqrt();
            assert!((event.time - wanted).abs() < bound, "{case}: {} not {wanted}", event.time);
        }
        crossings += wanted.len();
    }
    crossings
}

/// Formulas of cos t. At a pole or boundary of a formula the motion continues,
/// in as few steps as without it; a pole is not a zero, a jump is one.
#[test]
fn formulas_that_end_on_the_way_do_not_end_the_motion() {
    let all = |places: &[f64]| {
        let about =
            |x: &f64| [0.0, 2.0, 4.0].map(|turns| [turns * PI - libm::acos(*x), turns * PI + libm::acos(*x)]);
        let mut times: Vec<f64> = places.iter().flat_map(about).flatten().collect();
        times.retain(|time| 0.0 < *time && *time < 10.0);
        times.sort_by(f64::total_cmp);
        times
    };
    let at = |x: f64| all(&[x]);
    let both_sides = |x: f64| all(&[x, -x]);
    let root = 13f64.sqrt();
    let cubic = all(&[0.25, (root - 1.0) / 8.0, (-root - 1.0) / 8.0]);
    let cases = [
        ("1/x - 16/9", at(9.0 / 16.0), 1e-12),
        ("1/(x - 1/2) - 1000000", at(0.500001), 1e-12),
        ("1/x", vec![], 0.0),
        ("1/x^2 - 3", both_sides(3f64.sqrt().recip()), 1e-12),
        ("1/(1 - cos(x)) - 3", both_sides(libm::acos(2.0 / 3.0)), 1e-12),
        ("tan(2*x)", at(0.0), 1e-12),
        ("ln(x) + 1", at(libm::exp(-1.0)), 1e-12),
        ("sqrt(x) - 1/2", at(0.25), 1e-12),
        ("x^(-1/3) - 2", at(0.125), 1e-12),
        ("1/(x*(x^2 - 1/4)) + 64/3", cubic, 1e-12),
        ("atan(1/x)", at(0.0), 1e-10),
    ];
    for (formula, exact, bound) in cases {
        let solution =
            run(&watched("x'' = -x", &[(formula, Direction::Any, false)]), &[1.0, 0.0], &[10.0], 1e-14);
        let computed: Vec<f64> = solution.events.iter().map(|event| event.time).collect();
        assert_eq!(computed.len(), exact.len(), "{formula}: {computed:?}, {exact:?}");
        assert!(
            computed.iter().zip(&exact).all(|(a, b)| (a - b).abs() <= bound),
            "{formula}: {computed:?}, {exact:?}"
        );
        assert!((solution.end.state[0] - libm::cos(10.0)).abs() < 1e-14 && solution.steps < 10, "{formula}");
    }
}

/// Some of hundreds of poles come so near the times at which a formula is looked at that its values there are all rounding error. Late times
/// are rounded to more than the shortest parts of a step.
#[test]
fn no_pole_of_many_is_a_zero() {
    // cos t passes zero 191 times before 600, and 32 times before 100.
    for (formula, start, length, zeros) in [
        ("1/x", 0.0, 800.0, 0),
        ("1/x", 1e6, 100.0, 0),
        ("1/(x - 1/2)", 0.0, -800.0, 0),
        ("x/(x - 1/2)", 1e6, -100.0, 32),
        ("tan(2*x)", 0.0, 600.0, 191),
        ("tan(2*x)", 1e6, 100.0, 32),
    ] {
        let system = watched("x'' = -x", &[(formula, Direction::Any, false)]);
        let begin = Moment { time: start, state: vec![1.0, 0.0] };
        let effort = Effort::to_tolerance(1e-12);
        let events = integrate(&system, &begin, &[start + length], &effort, &Quiet).unwrap().events;
        assert_eq!(events.len(), zeros, "{formula} from {start} by {length}");
        for (n, event) in (0..).zip(&events) {
            let exact = (f64::from(n) + 0.5) * PI;
            assert!(((event.time - start).abs() - exact).abs() < 1e-9, "{formula} from {start}: {event:?}");
        }
    }
}

#[test]
fn crossings_next_to_the_amplitude_are_neither_missed_nor_doubled() {
    assert!(crossings_next_to_the_amplitude(1000) > 5000);
}

#[test]
#[ignore = "takes minutes"]
fn crossings_in_a_hundred_thousand_cases() {
    assert!(crossings_next_to_the_amplitude(100_000) > 500_000);
}

/// The time at which a motion, in an interval in which it falls, is at an angle.
fn time_at_angle(angle: impl Fn(f64) -> f64, wanted: f64, end: f64) -> f64 {
    let (mut before, mut behind) = (0.0, end);
    for _ in 0..100 {
        let middle = 0.5 * (before + behind);
        if angle(middle) > wanted { before = middle } else { behind = middle }
    }
    0.5 * (before + behind)
}

#[test]
fn turning_points_have_their_times() {
    let system = watched("theta'' = -sin(theta)", &[("theta'", Direction::Any, false)]);
    let exact = Pendulum::from_angular_frequency(1.0).unwrap();
    let period = exact.released_from(Angle::from_radians(2.0).unwrap()).unwrap().period();
    let events = run(&system, &[2.0, 0.0], &[20.25 * period], 1e-15).events;
    assert_eq!(events.len(), 41);
    assert_eq!(events[0].contact, Contact::Start);
    for (n, event) in (1..).zip(&events[1..]) {
        let wanted = 0.5 * f64::from(n) * period;
        assert!((event.time - wanted).abs() < 1e-12, "{n}: {} not {wanted}", event.time);
        let contact = if n % 2 == 1 { Contact::Rising } else { Contact::Falling };
        assert_eq!(event.contact, contact);
        assert!((event.state[0].abs() - 2.0).abs() < 1e-13 && event.state[1].abs() < 1e-13);
    }
}

#[test]
fn directions_are_told_apart() {
    let count = |direction| {
        let system = watched("x'' = -x", &[("x", direction, false)]);
        run(&system, &[1.0, 0.0], &[10.0 * PI], 1e-12).events.len()
    };
    assert_eq!([Direction::Any, Direction::Rising, Direction::Falling].map(count), [10, 5, 5]);
}

#[test]
fn an_event_may_end_the_motion() {
    let system = watched("x'' = -x", &[("x'", Direction::Any, false), ("x - 1/2", Direction::Falling, true)]);
    let times: Vec<f64> = (0..100).map(|n| 0.1 * f64::from(n)).collect();
    let solution = run(&system, &[1.0, 0.0], &times, 1e-15);
    assert!((solution.end.time - PI / 3.0).abs() < 1e-15, "{}", solution.end.time);
    assert_eq!(solution.samples.len(), 11);
    assert_eq!(solution.events.iter().map(|event| event.event).collect::<Vec<_>>(), [0, 1]);
    assert!((solution.end.state[0] - 0.5).abs() < 1e-15);
}

#[test]
fn touching_is_told_from_crossing() {
    let contacts = |equation: &str, formula: &str, state: &[f64], end: f64| {
        let system = watched(equation, &[(formula, Direction::Any, false)]);
        run(&system, state, &[end], 1e-12)
            .events
            .into_iter()
            .map(|event| (event.time, event.contact))
            .collect::<Vec<_>>()
    };
    // x = (t − 1)² touches zero, x = (t − 1)³ crosses it flatly.
    let touched = contacts("x'' = 2", "x", &[1.0, -2.0], 3.0);
    assert!(matches!(touched[..], [(time, Contact::Grazing)] if (time - 1.0).abs() < 1e-5), "{touched:?}");
    let flat = contacts("x'' = 6 (t - 1)", "x", &[-1.0, 3.0], 3.0);
    assert!(matches!(flat[..], [(time, Contact::Rising)] if (time - 1.0).abs() < 1e-3), "{flat:?}");
    // cos t reaches −1 and 1 at arbitrary positions in the steps.
    let both = contacts("x'' = -x", "x - 1", &[0.0, 1.0], 20.0);
    assert_eq!(both.len(), 3, "{both:?}");
    for (n, (time, contact)) in (0..).zip(&both) {
        assert!(
            (time - (0.5 + 2.0 * f64::from(n)) * PI).abs() < 1e-5 && *contact == Contact::Grazing,
            "{both:?}"
        );
    }
    // The end of a sampled interval is not the end of a contact.
    let split = contacts("x'' = -x", "x - 1", &[0.0, 1.0], 0.5 * PI);
    assert!(split.len() <= 1, "{split:?}");
    assert_eq!(contacts("x'' = -x", "x", &[0.0, 0.0], 5.0), []);
}

#[test]
fn formulas_of_time_and_jumps_are_events_too() {
    let system = watched(
        "x'' = 0",
        &[("sin(2 t)", Direction::Rising, false), ("sign(x) - 1/2", Direction::Any, false)],
    );
    let events = run(&system, &[-1.0, 0.5], &[10.0], 1e-14).events;
    let times: Vec<f64> = events.iter().map(|event| event.time).collect();
    let wanted = [2.0, PI, 2.0 * PI, 3.0 * PI];
    assert_eq!(times.len(), wanted.len(), "{events:?}");
    assert!(times.iter().zip(wanted).all(|(time, wanted)| (time - wanted).abs() < 1e-14), "{times:?}");
}

#[test]
fn dry_friction_stops_the_motion() {
    // x'' = −x − c·sign(x′): half swings about ±c, which end where |x| ≤ c.
    let system = watched("x'' = -x - 0.3 sign(x')", &[("x'", Direction::Any, false)]);
    let times: Vec<f64> = (0..=40).map(|n| 0.5 * f64::from(n)).collect();
    let solution = run(&system, &[2.0, 0.0], &times, 1e-15);
    let turning: Vec<f64> = solution.events.iter().map(|event| event.state[0]).collect();
    let wanted = [2.0, -1.4, 0.8, -0.2];
    assert_eq!(turning.len(), wanted.len(), "{turning:?}");
    assert!(turning.iter().zip(wanted).all(|(x, wanted)| (x - wanted).abs() < 1e-14), "{turning:?}");
    assert!((solution.events[3].time - 3.0 * PI).abs() < 1e-14);
    let end = &solution.end;
    assert!((end.state[0] + 0.2).abs() < 1e-14 && end.state[1] == 0.0 && end.time == 20.0, "{end:?}");
}

#[test]
fn a_driven_block_sticks_and_slips() {
    // x'' = F sin t − c·sign(x′), F > c: at rest until F sin t = c.
    let (force, friction) = (1.0, 0.6);
    let system = System::new(&"x'' = sin(t) - 0.6 sign(x')".parse().unwrap()).unwrap();
    let released = libm::asin(friction / force);
    let times = [0.5, released, released + 0.5];
    let solution = run(&system, &[0.0, 0.0], &times, 1e-15);
    assert_eq!(solution.samples[0].state, [0.0, 0.0]);
    let t = released + 0.5;
    let velocity = libm::cos(released) - libm::cos(t) - friction * 0.5;
    assert!((solution.samples[2].state[1] - velocity).abs() < 1e-14, "{:?}", solution.samples);
    // The same in other units of time; in fast ones only the series of the force at rest overflow.
    for rate in [1e-10, 1e10, 1e13] {
        let square = rate * rate;
        let fast = format!("x'' = {square:e}*sin({rate:e}*t) - {:e}*sign(x')", friction * square);
        let end = run(&System::new(&fast.parse().unwrap()).unwrap(), &[0.0, 0.0], &[t / rate], 1e-17).end;
        assert!((end.state[1] / rate - velocity).abs() < 1e-13, "{rate:e}: {end:?}");
    }
    // If friction exceeds the force the body never moves.
    let held = System::new(&"x'' = sin(t) - 1.2 sign(x')".parse().unwrap()).unwrap();
    assert_eq!(run(&held, &[0.3, 0.0], &[1000.0], 1e-12).end.state, [0.3, 0.0]);
}

#[test]
fn a_block_that_came_to_rest_goes_on_when_the_force_has_grown() {
    // x'' = t/10 − sign(x′) from x′ = 1: at rest when 1 − t + t²/20 = 0, until t = 10.
    let system = System::new(&"x'' = t/10 - sign(x')".parse().unwrap()).unwrap();
    let stop = 10.0 - 80.0_f64.sqrt();
    let rest = stop - stop * stop / 2.0 + stop * stop * stop / 60.0;
    let times = [stop + 1.0, 10.0, 12.0];
    let solution = run(&system, &[0.0, 1.0], &times, 1e-15);
    for (sample, [x, v]) in
        solution.samples.iter().zip([[rest, 0.0], [rest, 0.0], [rest + 8.0 / 60.0, 4.0 / 20.0]])
    {
        assert!((sample.state[0] - x).abs() < 1e-14 && (sample.state[1] - v).abs() < 1e-14, "{sample:?}");
    }
    // A body at rest does not move, to the last bit.
    assert_eq!(solution.samples[0].state, solution.samples[1].state);
}

fn orbits(count: u32) -> Vec<Moment> {
    (0..count)
        .map(|n| Moment { time: 0.1 * f64::from(n), state: vec![0.17 * f64::from(n) - 2.0, 0.3] })
        .collect()
}

#[test]
fn many_motions_side_by_side_are_bit_for_bit_those_alone() {
    let equations = [
        ("theta'' = -sin(theta) - c theta' + a cos(2 t/3)", 37),
        ("theta'' = -sin(theta) - c sign(theta') - theta' abs(theta') + a cos(t)", 19),
        ("x'' = -x/(1 + x^2)^1.5 - c x' + a tanh(y); y'' = -exp(y/7) + ln(2 + x^2) - c y", 11),
        ("x'' = 2 x^3 - c x' + a", 9),
    ];
    for (equation, count) in equations {
        let equation = equation.parse().unwrap();
        let event = Event::zero_of(libration::expression::Expression::Symbol(
            libration::expression::Symbol::plain(equation_variable(&equation)).with_primes(1),
        ));
        let system = System::with_parameters(&equation, &["a", "c"]).unwrap().with_events(&[event]).unwrap();
        let times: Vec<f64> = (0..30).map(|n| 5.0 + 1.3 * f64::from(n)).collect();
        let starts = orbits(count);
        let trajectories: Vec<Trajectory<'_>> = (0_u8..)
            .zip(&starts)
            .map(|(n, start)| {
                let mut state = start.state[..1].to_vec();
                state.resize(system.coordinates(), 0.4);
                state.push(start.state[1]);
                state.resize(2 * system.coordinates(), -0.1);
                Trajectory {
                    start: Moment { time: start.time, state },
                    parameters: vec![0.04 * f64::from(n), 0.5 / (1.0 + f64::from(n))],
                    times: &times[..10 + usize::from(n) % 20],
                }
            })
            .collect();
        let effort = Effort { most_steps: 3000, ..Effort::to_tolerance(1e-11) };
        let together = integrate_many(&system, &trajectories, &effort, &Quiet);
        for (trajectory, together) in trajectories.iter().zip(together) {
            let alone = trajectory.integrate(&system, &effort, &Quiet);
            assert_eq!(together, alone);
        }
    }
}

fn equation_variable(equation: &libration::expression::Equation) -> &str {
    &equation.variables()[0]
}

#[test]
fn interrupting_many_motions_keeps_what_is_done() {
    let system = System::new(&"x'' = -x".parse().unwrap()).unwrap();
    let times = [1.0, 100.0];
    let trajectories: Vec<Trajectory<'_>> =
        orbits(20).into_iter().map(|start| Trajectory { start, parameters: vec![], times: &times }).collect();
    let trajectories: Vec<Trajectory<'_>> = trajectories
        .into_iter()
        .map(|mut trajectory| {
            trajectory.start.time = 0.0;
            trajectory
        })
        .collect();
    let mut steps = 0;
    let outcomes = integrate_many_stepwise(&system, &trajectories, &Effort::to_tolerance(1e-9), |_, _| {
        steps += 1;
        if steps > 50 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert_eq!(outcomes.len(), 20);
    let begun = outcomes.iter().filter(|outcome| {
        let Err(IntegrationError::Stopped { cause: Cause::Interrupted, solution }) = outcome else {
            panic!("{outcome:?}")
        };
        solution.steps > 0
    });
    // The number of motions side by side.
    assert_eq!(begun.count(), 16);
}

#[test]
fn units_of_time_do_not_matter() {
    for unit in [1e-15, 1e-9, 1e9, 1e15] {
        let system = System::new(&format!("x'' = -sin(x)/({unit:e})^2").parse().unwrap()).unwrap();
        let got = run(&system, &[2.0, 0.0], &[10.0 * unit], 1e-15).end.state;
        let exact = Pendulum::from_angular_frequency(1.0).unwrap();
        let wanted = exact.released_from(Angle::from_radians(2.0).unwrap()).unwrap().state_at(10.0);
        let errors = [got[0] - wanted.angle, got[1] * unit - wanted.velocity];
        assert!(errors.iter().all(|error| error.abs() < 1e-13), "{unit:e}: {errors:?}");
    }
}

#[test]
fn velocities_that_are_almost_zero_do_not_matter() {
    for velocity in [1e-17, -1e-60, 1e-300] {
        let system = System::new(&"x'' = -x + 0.01 (1 - x^2) x'".parse().unwrap()).unwrap();
        let got = run(&system, &[2.0, velocity], &[30.0], 1e-15).end.state;
        let wanted = run(&system, &[2.0, 0.0], &[30.0], 1e-15).end.state;
        assert!(
            got.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 2e-14),
            "{velocity:e}: {got:?} {wanted:?}"
        );
    }
}

/// x = 5 cos t passes x = 2 twice; most of the formulas underflow on both sides of a peak.
#[test]
fn formulas_that_are_felt_in_a_small_part_of_a_step_have_their_zeros() {
    let half_width = (libm::log(2.0) / 20_000.0).sqrt();
    let high = libm::acos(libm::pow(0.5, 1.0 / 400.0));
    let passages = |width: f64| {
        let down = [2.0 + width, 2.0 - width].map(|x: f64| libm::acos(x / 5.0));
        let up = [2.0 - width, 2.0 + width].map(|x: f64| 2.0 * PI - libm::acos(x / 5.0));
        [down, up].concat()
    };
    let cases = [
        ("exp(-20000*(x - 2)^2) - 1/2", passages(half_width)),
        ("cosh(400*(x - 2)) - 2", passages(libm::acosh(2.0) / 400.0)),
        ("1/(1 + 1000000*(x - 2)^2) - 1/2", passages(1e-3)),
        ("(x/5)^400 - 1/2", vec![high, PI - high, PI + high]),
        ("exp(-20000*(t - 3)^2) - 1/2", vec![3.0 - half_width, 3.0 + half_width]),
        ("exp(x) - 10^(-30)", vec![]),
    ];
    for (formula, expected) in cases {
        let event = Event { formula: formula.parse().unwrap(), direction: Direction::Any, ends_at: None };
        let system = System::new(&"x'' = -x".parse().unwrap()).unwrap().with_events(&[event]).unwrap();
        let start = Moment { time: 0.0, state: vec![5.0, 0.0] };
        let solution = integrate(&system, &start, &[6.2], &Effort::to_tolerance(1e-15), &Quiet);
        let times: Vec<f64> = solution.unwrap().events.iter().map(|event| event.time).collect();
        assert_eq!(times.len(), expected.len(), "{formula}: {times:?}");
        for (computed, expected) in times.iter().zip(&expected) {
            assert!((computed - expected).abs() < 1e-10, "{formula}: {computed} beside {expected}");
        }
    }
}

/// The n-th passage of the bottom, rising or falling, and the accuracy of its time and state.
#[test]
fn a_motion_ends_at_the_event_that_is_counted() {
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    let quarter = pendulum.released_from(Angle::from_radians(2.5).unwrap()).unwrap().period() / 4.0;
    for (direction, count, quarters) in [
        (Direction::Any, 1, 1.0),
        (Direction::Any, 6, 11.0),
        (Direction::Rising, 1, 3.0),
        (Direction::Falling, 3, 9.0),
    ] {
        let bottom = Event { formula: "theta".parse().unwrap(), direction, ends_at: Some(count) };
        let system = System::new(&"theta'' + sin(theta) = 0".parse().unwrap()).unwrap();
        let system = system.with_events(&[bottom]).unwrap();
        let start = system.start(&[("theta", 2.5)]).unwrap();
        for tolerance in [1e-4, 1e-6, 1e-9, 1e-12, 1e-15] {
            let effort = Effort::to_tolerance(tolerance);
            let solution = integrate(&system, &start, &[100.0], &effort, &Quiet).unwrap();
            let error = ending_error(&system, &start, 100.0, &effort, &solution.end).unwrap();
            let apart = (solution.end.time - quarters * quarter).abs();
            assert!(apart <= error.time, "{direction:?} {count} {tolerance}: {apart:e} {:e}", error.time);
            assert!(error.time < 1e4 * tolerance.max(1e-15), "{direction:?} {count} {tolerance}: {error:?}");
            let speed = 2.0 * libm::sin(1.25);
            assert!((solution.end.state[1].abs() - speed).abs() <= error.state[1], "{tolerance}: {error:?}");
            assert_eq!(u64::try_from(solution.events.len()), Ok(count));
        }
    }
}

/// A formula that is zero at the start, but for its rounding error or half a unit in the last place of the start, does not cross zero there,
/// whichever sign rounding gives it; a later return to zero is a crossing.
#[test]
fn roundings_at_the_start_are_no_crossings() {
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    for degrees in 1..180 {
        let angle = f64::from(degrees).to_radians();
        let exact = pendulum.released_from(Angle::from_radians(angle).unwrap()).unwrap();
        for neighbour in [angle.next_down(), angle, angle.next_up()] {
            for formula in [format!("theta - pi*{degrees}/180"), format!("pi*{degrees}/180 - theta")] {
                let system = watched("theta'' = -sin(theta)", &[(&formula, Direction::Any, false)]);
                let events = run(&system, &[neighbour, 0.0], &[0.75 * exact.period()], 1e-12).events;
                let contacts: Vec<Contact> = events.iter().map(|event| event.contact).collect();
                assert_eq!(contacts, [Contact::Start], "{formula}: {events:?}");
            }
        }
    }
    for (start, direction) in [(1.0, Direction::Falling), (-1.0, Direction::Rising)] {
        for wrong in [direction, Direction::Any] {
            for formula in ["x*sqrt(3) - sqrt(3)*1", "x*sqrt(3) + sqrt(3)*1", "sqrt(3) - x*sqrt(3)"] {
                let system = watched("x'' = -x", &[(formula, wrong, false)]);
                let events = run(&system, &[start, 0.0], &[1.0], 1e-12).events;
                assert!(events.iter().all(|event| event.contact == Contact::Start), "{formula}: {events:?}");
            }
        }
    }
}

/// A formula that begins next to a zero, but beyond its rounding error, crosses it; so does one that leaves zero and returns.
#[test]
fn crossings_soon_after_the_start_are_found() {
    for before in [1e-3, 1e-6, 1e-9, 1e-12, 1e-14] {
        let system = watched("x' = 1", &[("x - 1", Direction::Any, false)]);
        let events = run(&system, &[1.0 - before], &[1.0], 1e-12).events;
        assert_eq!(events.len(), 1, "{before}: {events:?}");
        assert!(events[0].contact == Contact::Rising && (events[0].time - before).abs() < 1e-15);
    }
    let system = watched("x'' = -x", &[("x - sqrt(2)/2", Direction::Any, false)]);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let events = run(&system, &[half, half], &[3.0], 1e-12).events;
    let contacts: Vec<Contact> = events.iter().map(|event| event.contact).collect();
    assert_eq!(contacts, [Contact::Start, Contact::Falling]);
    assert!((events[1].time - std::f64::consts::FRAC_PI_2).abs() < 1e-12, "{events:?}");
    let until = watched("x'' = -x", &[("x - sqrt(2)/2", Direction::Falling, true)]);
    let ended = run(&until, &[half, half], &[30.0], 1e-12);
    assert!((ended.end.time - std::f64::consts::FRAC_PI_2).abs() < 1e-12, "{ended:?}");
}
