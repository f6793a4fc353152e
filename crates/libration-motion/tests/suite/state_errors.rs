//! The stated errors of states and events, compared with the actual errors.

use crate::endings::{KNOWN, Known, TOLERANCES};
use libration::pendulum::Pendulum;
use libration::quantity::Angle;
use libration::systems::{Model, Observables};
use libration::taylor::{
    Contact, Effort, Event, Moment, MomentErrors, Occurrence, SampledErrors, Sensitivities, Start,
    StateErrors, System, integrate_both_ways, integrate_from,
};
use libration_testing::golden::{Row, Table};
use libration_testing::random::Random;
use libration_testing::sweep;
use std::f64::consts::PI;
use std::ops::ControlFlow;

/// The errors of one sample: the actual and the stated one of each component.
type Compared = Vec<[f64; 2]>;

struct Run<'a> {
    name: &'a str,
    rows: Vec<Row<'a>>,
}

impl Run<'_> {
    fn numbers(row: Row<'_>, column: &str) -> Vec<f64> {
        row.text(column).split(' ').map(|number| number.parse().unwrap()).collect()
    }

    /// The samples as long as they are determined, and the time until which they are.
    fn compared(&self) -> (Vec<Compared>, Option<f64>) {
        let first = self.rows[0];
        let system = System::new(&first.text("equations").parse().unwrap()).unwrap();
        let effort = Effort::to_tolerance(first.input("tolerance"));
        let start = Moment { time: 0.0, state: Self::numbers(first, "start") };
        let times: Vec<f64> = self.rows.iter().map(|row| row.input("time")).collect();
        let mut errors = StateErrors::new(&system, &start, &effort);
        let mut rows = self.rows.iter().peekable();
        let mut compared = vec![];
        integrate_from(&system, &Start::State(start), &times, &effort, |accepted| {
            errors.follow(accepted);
            while let Some(row) = rows.next_if(|row| row.input("time") <= accepted.step().end()) {
                let time = row.input("time");
                let moment = Moment { time, state: accepted.step().state_at(time) };
                if let Some(stated) = errors.at(&moment) {
                    let truth = Self::numbers(*row, "state");
                    let off =
                        moment.state.iter().zip(&truth).map(|(computed, truth)| (computed - truth).abs());
                    compared.push(off.zip(stated).map(|(off, stated)| [off, stated]).collect());
                }
            }
            ControlFlow::Continue(())
        })
        .unwrap();
        (compared, errors.determined_until())
    }
}

fn runs(table: &Table) -> Vec<Run<'_>> {
    let mut runs: Vec<Run<'_>> = vec![];
    for row in table.rows() {
        match runs.last_mut().filter(|run| run.name == row.text("run")) {
            Some(run) => run.rows.push(row),
            None => runs.push(Run { name: row.text("run"), rows: vec![row] }),
        }
    }
    runs
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// Chaotic and regular motions, some to their last digit: no sample is off by more than its stated error, which is not far too large.
#[test]
fn sweep_every_sample_is_inside_its_error() {
    let table = Table::read("state_errors.csv");
    let mut medians = vec![];
    for run in sweep::part(runs(&table), 6) {
        let (compared, until) = run.compared();
        assert!(!compared.is_empty(), "{}: determined until {until:?}", run.name);
        let mut ratios = vec![];
        for (index, sample) in compared.iter().enumerate() {
            for [off, stated] in sample {
                assert!(off <= stated, "{} sample {index}: {off:e} {stated:e}", run.name);
                ratios.extend((*off > 0.0).then(|| stated / off));
            }
        }
        let largest = ratios.iter().copied().fold(0.0, f64::max);
        let median = median(ratios);
        eprintln!(
            "{}: {} samples, until {until:?}, median {median:.0}, largest {largest:.0}",
            run.name,
            compared.len()
        );
        medians.push(median);
    }
    let all = median(medians);
    eprintln!("median of all {all:.0}");
    assert!(all < 1000.0, "{all}");
}

/// The states and errors at the ends of all steps until the last determined one.
fn determined(
    system: &System,
    start: &Moment,
    last: f64,
    tolerance: f64,
) -> (Vec<(Moment, Vec<f64>)>, StateErrors) {
    let effort = Effort::to_tolerance(tolerance);
    let mut errors = StateErrors::new(system, start, &effort);
    let mut moments = vec![];
    integrate_from(system, &Start::State(start.clone()), &[last], &effort, |accepted| {
        errors.follow(accepted);
        let time = accepted.step().end();
        let moment = Moment { time, state: accepted.step().state_at(time) };
        moments.extend(errors.at(&moment).map(|error| (moment, error)));
        ControlFlow::Continue(())
    })
    .unwrap();
    (moments, errors)
}

/// Terms that cancel, constants that are not doubles, forces that jump and bend; forward and backward.
#[test]
fn errors_of_motions_in_closed_form_hold() {
    for Known { equation, start, state } in KNOWN {
        let system = System::new(&equation.parse().unwrap()).unwrap();
        let start = system.start(start).unwrap();
        for tolerance in TOLERANCES {
            let (moments, errors) = determined(&system, &start, 50.0, tolerance);
            let until = errors.determined_until();
            assert!(until.is_none() || equation == "x'' = x", "{equation}: {until:?}");
            for (Moment { time, state: components }, stated) in moments {
                for ((computed, truth), stated) in components.iter().zip(state(time)).zip(stated) {
                    // The rounding errors of the closed form itself.
                    let off = (computed - truth).abs() - 1e-15 * computed.abs().max(1.0);
                    assert!(off <= stated, "{equation} {time} {tolerance:e}: {off:e} {stated:e}");
                }
            }
        }
    }
}

/// Starts next to the top, from which the error is soon as large as the angle: as long as an error is stated, it holds.
#[test]
fn pendulums_from_next_to_the_top_are_determined_as_far_as_is_said() {
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    let system = System::new(&"theta'' = -sin(theta)".parse().unwrap()).unwrap();
    for (amplitude, least) in
        [(3.0, 200.0), (3.1, 100.0), (3.1415, 40.0), (179.999999_f64.to_radians(), 40.0)]
    {
        let exact = pendulum.released_from(Angle::from_radians(amplitude).unwrap()).unwrap();
        for tolerance in [1e-9, 1e-12, 1e-16] {
            let start = system.start(&[("theta", amplitude)]).unwrap();
            let (moments, errors) = determined(&system, &start, 200.0, tolerance);
            let until = errors.determined_until().unwrap_or(200.0);
            assert!(tolerance > 1e-12 || until >= least, "{amplitude} {tolerance:e}: {until}");
            for (Moment { time, state }, stated) in moments {
                let there = exact.state_at(time);
                for (computed, truth, stated) in
                    [(state[0], there.angle, stated[0]), (state[1], there.velocity, stated[1])]
                {
                    let off = (computed - truth).abs();
                    assert!(off <= stated, "{amplitude} {time} {tolerance:e}: {off:e} {stated:e}");
                }
            }
        }
    }
}

/// Zeros of high orders that are crossed or touched, on the way and at a turning point: a step of Newton's method is a fraction of the distance.
#[test]
fn errors_of_events_at_multiple_zeros_hold() {
    let equation = "x'' = -x".parse().unwrap();
    // x where the formula is zero, the time from x = 1 to there, and powers.
    let roots: [(&str, f64, f64, &[&str]); 4] = [
        ("x", 0.0, 0.5 * PI, &["", "^2", "^3", "^4", "^5", "^6", "^7", "^8", "^5*exp(t)", "^4*(2 + x')"]),
        ("(x - 1/2)", 0.5, PI / 3.0, &["^2", "^3", "^4", "^5", "^6"]),
        ("(x + 1)", -1.0, PI, &["", "^2", "^3", "^4"]),
        ("abs(x)", 0.0, 0.5 * PI, &["", "^2", "^3", "^5"]),
    ];
    for (root, position, angle, powers) in roots {
        for (power, tolerance) in
            powers.iter().flat_map(|power| TOLERANCES.map(|tolerance| (power, tolerance)))
        {
            let formula = format!("{root}{power}");
            let system = System::new(&equation).unwrap();
            let system = system.with_events(&[Event::zero_of(formula.parse().unwrap())]).unwrap();
            let events = events_with_errors(&system, vec![1.0, 0.0], 25.0, tolerance);
            assert!(events.len() >= 4, "{formula} {tolerance:e}: {}", events.len());
            for (Occurrence { time, state, .. }, error) in events {
                let zeros =
                    [angle, -angle].map(|zero| zero + 2.0 * PI * ((time - zero) / (2.0 * PI)).round());
                let zero = zeros.into_iter().min_by(|a, b| (time - a).abs().total_cmp(&(time - b).abs()));
                let exact = [zero.unwrap(), position, -libm::sin(zero.unwrap())];
                let computed = [time, state[0], state[1]];
                let errors = [error.time, error.state[0], error.state[1]];
                assert!(error.time < 0.5, "{formula} {tolerance:e} {time}: {errors:?}");
                for ((value, exact), error) in computed.into_iter().zip(exact).zip(errors) {
                    let off = (value - exact).abs();
                    assert!(off <= error, "{formula} {tolerance:e} {time}: {value} {exact} {error:e}");
                }
            }
        }
    }
}

/// Passages of the bottom, turning points and touches.
#[test]
fn errors_of_events_hold() {
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    let formulas = ["theta", "theta'", "theta - 2.5"].map(|text| Event::zero_of(text.parse().unwrap()));
    let system = System::new(&"theta'' = -sin(theta)".parse().unwrap()).unwrap();
    let system = system.with_events(&formulas).unwrap();
    let quarter = pendulum.released_from(Angle::from_radians(2.5).unwrap()).unwrap().period() / 4.0;
    let start = system.start(&[("theta", 2.5)]).unwrap();
    for tolerance in TOLERANCES {
        let events = events_with_errors(&system, start.state.clone(), 100.0, tolerance);
        assert!(events.len() > 30);
        for (Occurrence { event, time, state, contact }, error) in events {
            let number = (time / quarter).round();
            let off = (time - number * quarter).abs();
            assert!(off <= error.time, "{event} {contact:?} {time} {tolerance:e}: {off:e} {:e}", error.time);
            let touched = event == 2;
            assert!(
                touched || error.time < 1e6 * tolerance.max(1e-16),
                "{event} {time} {tolerance:e}: {error:?}"
            );
            let velocity = if event == 0 { 2.0 * libm::sin(1.25) } else { 0.0 };
            assert!(
                (state[1].abs() - velocity).abs() <= error.state[1],
                "{event} {time}: {state:?} {error:?}"
            );
            let angle = if event == 0 { 0.0 } else { 2.5 };
            assert!((state[0].abs() - angle).abs() <= error.state[0], "{event} {time}: {state:?} {error:?}");
        }
    }
}

/// Formulas of x = cos(t + φ) with kinks and jumps, at which steps end: each contact is found once, with its kind, and inside its errors.
#[test]
fn events_at_kinks_are_found_once() {
    // The formula, and its contacts where x falls and rises, in the order of the motion, through certain values.
    type Contacts = [Option<(f64, Contact)>; 2];
    let both = |value: f64, contacts: [Contact; 2]| contacts.map(|contact| Some((value, contact)));
    let (touches, passes) = ([Contact::Grazing; 2], [Contact::Falling, Contact::Rising]);
    let formulas: [(&str, Contacts); 16] = [
        ("abs(x)", both(0.0, touches)),
        ("abs(x - 0.3)*(x + 2)^2", both(0.3, touches)),
        ("max(x, 0.5) - 0.5", [Some((0.5, Contact::Falling)), None]),
        ("min(x, 0.1) - 0.1", [None, Some((0.1, Contact::Rising))]),
        ("x*abs(x)", both(0.0, passes)),
        ("abs(x)*x^2", both(0.0, touches)),
        ("sign(x + 0.2)", both(-0.2, passes)),
        ("sign(x) + x", both(0.0, passes)),
        ("abs(x)/(1 + x^2)", both(0.0, touches)),
        ("x/(1 + abs(x))", both(0.0, passes)),
        ("abs(x)/x", both(0.0, passes)),
        ("1/(0.1 + abs(x)) - 10", both(0.0, touches)),
        ("abs(x - 0.3)*exp(x)", both(0.3, touches)),
        ("sqrt(x^2)", both(0.0, touches)),
        ("log(1 + abs(x + 0.1))", both(-0.1, touches)),
        ("x*(x + 0.3) - abs(x*(x + 0.3))", [Some((-0.3, Contact::Rising)), Some((0.0, Contact::Rising))]),
    ];
    let mut random = Random::seeded(53);
    for (formula, contacts) in formulas {
        let system = System::new(&"x'' = -x".parse().unwrap()).unwrap();
        let system = system.with_events(&[Event::zero_of(formula.parse().unwrap())]).unwrap();
        for tolerance in TOLERANCES {
            let phase = random.between(0.0, 6.0);
            let sign = if random.between(-1.0, 1.0) < 0.0 { -1.0 } else { 1.0 };
            let state = vec![libm::cos(phase), -libm::sin(phase)];
            let end = sign * random.between(10.0, 40.0);
            let events = events_with_errors(&system, state, end, tolerance);
            let mut wanted: Vec<(f64, (f64, Contact))> = vec![];
            for (at, side) in
                contacts.into_iter().zip([sign, -sign]).filter_map(|(at, side)| Some((at?, side)))
            {
                let times =
                    (-10..10).map(|turn| 2.0 * PI * f64::from(turn) - phase + side * libm::acos(at.0));
                let passed = times.filter(|time| time * sign > 0.0 && time.abs() < end.abs());
                wanted.extend(passed.map(|time| (time, at)));
            }
            wanted.sort_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
            assert_eq!(events.len(), wanted.len(), "{formula} {phase} to {end}: {events:?} {wanted:?}");
            for ((event, error), (time, (zero, contact))) in events.iter().zip(wanted) {
                let off = (event.time - time).abs();
                assert!(
                    off <= error.time,
                    "{formula} {phase} {tolerance:e}: {event:?} {time} {error:?} {:?}",
                    events.iter().map(|f| f.0.time).collect::<Vec<_>>()
                );
                assert!(error.time < 1e6 * tolerance.max(1e-16), "{formula} {phase}: {event:?} {error:?}");
                let off = (event.state[0] - zero).abs();
                assert!(off <= error.state[0], "{formula} {phase}: {event:?} {error:?}");
                assert_eq!(event.contact, contact, "{formula} {phase} to {end}: {event:?}");
            }
        }
    }
}

/// Steep formulas and roots with kinks, of x = cos t, whose series hold in parts of a step or not at all.
#[test]
fn steep_formulas_with_kinks_have_all_their_zeros() {
    let around = |value: f64| [libm::acos(value), libm::acos(-value)];
    let (inner, outer) = (0.7 - libm::acosh(2.0) / 400.0, 0.7 + libm::acosh(2.0) / 400.0);
    let steep = libm::log(1e5) / 300.0;
    for (formula, quarters) in [
        ("cosh(400*(abs(x) - 0.7)) - 2", [around(outer), around(inner)].concat()),
        ("exp(-300*abs(x)) - 1e-5", around(steep).to_vec()),
        ("1/abs(x) - 2", around(0.5).to_vec()),
        ("1/x^2 - 1/abs(x) - 2", around(0.5).to_vec()),
        // The formula becomes zero and stays so.
        ("sqrt(max(x, 0))", vec![PI / 2.0]),
    ] {
        let system = System::new(&"x'' = -x".parse().unwrap()).unwrap();
        let system = system.with_events(&[Event::zero_of(formula.parse().unwrap())]).unwrap();
        for tolerance in TOLERANCES {
            let events = events_with_errors(&system, vec![1.0, 0.0], PI, tolerance);
            let mut wanted = quarters.clone();
            wanted.sort_by(f64::total_cmp);
            assert_eq!(events.len(), wanted.len(), "{formula} {tolerance:e}: {events:?}");
            for ((event, error), time) in events.iter().zip(wanted) {
                assert!((event.time - time).abs() <= error.time, "{formula}: {event:?} {time} {error:?}");
                assert!(error.time < 1e6 * tolerance.max(1e-16), "{formula}: {event:?} {error:?}");
            }
        }
    }
}

/// A zero at the very end of a motion, or within the tolerance behind it, is an event, once.
#[test]
fn zeros_at_the_end_of_a_motion_are_found() {
    let mut random = Random::seeded(54);
    for formula in ["x", "abs(x)", "x*abs(x)", "max(x, 0)", "x + x^2"] {
        let system = System::new(&"x'' = -x".parse().unwrap()).unwrap();
        let system = system.with_events(&[Event::zero_of(formula.parse().unwrap())]).unwrap();
        for case in 0..20 {
            let phase = random.between(0.1, 1.5);
            let state = vec![libm::sin(phase), -libm::cos(phase)];
            for (end, sooner) in
                [(phase, false), (phase.next_up(), false), (phase.next_down(), false), (phase - 1e-6, true)]
            {
                let events = events_with_errors(&system, state.clone(), end, 1e-13);
                assert_eq!(events.len(), usize::from(!sooner), "{formula} {case} {phase}: {events:?}");
                for (event, error) in events {
                    assert!(
                        (event.time - phase).abs() <= error.time + 2e-16,
                        "{formula}: {event:?} {error:?}"
                    );
                    let returns =
                        formula == "abs(x)" && end > event.time && event.contact == Contact::Grazing;
                    assert!(
                        event.contact == Contact::Falling || returns,
                        "{formula} {phase} {end}: {event:?}"
                    );
                }
            }
        }
    }
}

/// Errors whose squares are below the range of numbers, and states that are below that of numbers with all digits.
#[test]
fn errors_of_small_states_hold() {
    type State = fn(f64) -> [f64; 2];
    // x = ε e^(−t), y = δ cos t in one system; a state that is lost in underflow and grows again.
    let motions: [(&str, [f64; 2], State, f64); 5] = [
        ("x' = -x; y' = -y", [1.0, 1e-150], |t| [libm::exp(-t), 1e-150 * libm::exp(-t)], f64::INFINITY),
        ("x'' = -x", [1e-320, 0.0], |t| [1e-320 * libm::cos(t), -1e-320 * libm::sin(t)], f64::INFINITY),
        ("x'' = -x", [1e-250, 0.0], |t| [1e-250 * libm::cos(t), -1e-250 * libm::sin(t)], f64::INFINITY),
        (
            "x' = -x; y' = sin(t)*y",
            [1e-140, 1e-310],
            |t| [1e-140 * libm::exp(-t), 1e-310 * libm::exp(1.0 - libm::cos(t))],
            f64::INFINITY,
        ),
        (
            "x' = -x*cos(t/1000); y' = -y",
            [1.0, libm::exp(20.0)],
            |t| [libm::exp(-1000.0 * libm::sin(t / 1000.0)), libm::exp(20.0 - t)],
            1000.0,
        ),
    ];
    for (equation, state, exact, until) in motions {
        let system = System::new(&equation.parse().unwrap()).unwrap();
        let start = Moment { time: 0.0, state: state.to_vec() };
        for tolerance in TOLERANCES {
            let (moments, errors) = determined(&system, &start, 3140.0, tolerance);
            let lost = errors.determined_until().unwrap_or(f64::INFINITY);
            assert!(lost <= until, "{equation} {tolerance:e}: {lost}");
            assert!(lost > 0.5 * until.min(1400.0), "{equation} {tolerance:e}: {lost}");
            for (Moment { time, state: components }, stated) in moments {
                for (number, ((computed, truth), stated)) in
                    components.iter().zip(exact(time)).zip(stated).enumerate()
                {
                    // The rounding errors of the closed form itself.
                    let off = (computed - truth).abs() - 4e-16 * (1.0 + time) * truth.abs() - 5e-324;
                    assert!(off <= stated, "{equation} {time} {tolerance:e}: {off:e} {stated:e}");
                    let least = f64::MIN_POSITIVE.max(truth.abs());
                    assert!(
                        stated <= 1e6 * (1.0 + time) * tolerance.max(1e-16) * least
                            || number > 0 && time > 300.0,
                        "{equation} {time} {tolerance:e}: {computed:e} {stated:e}"
                    );
                }
            }
        }
    }
}

/// The events of a motion from the time zero, with their errors.
fn events_with_errors(
    system: &System,
    state: Vec<f64>,
    end: f64,
    tolerance: f64,
) -> Vec<(Occurrence, MomentErrors)> {
    let (start, effort) = (Moment { time: 0.0, state }, Effort::to_tolerance(tolerance));
    let mut errors = StateErrors::new(system, &start, &effort);
    let mut events = vec![];
    integrate_from(system, &Start::State(start), &[end], &effort, |accepted| {
        errors.follow(accepted);
        for event in accepted.events() {
            events.push((event.clone(), errors.of_event(accepted, event).unwrap()));
        }
        ControlFlow::Continue(())
    })
    .unwrap();
    events
}

/// A motion that is symmetric in time has the same errors before and after its start, and the start has none.
/// The polynomial of a step does not tell two zeros from a contact if the formula stays within the tolerance between them.
#[test]
fn zeros_that_count_as_one_contact_are_inside_its_error() {
    let events = |equation: &str, formula: &str, start: &[f64]| {
        let system = System::new(&equation.parse().unwrap()).unwrap();
        let system = system.with_events(&[Event::zero_of(formula.parse().unwrap())]).unwrap();
        events_with_errors(&system, start.to_vec(), 2.0, 1e-12)
    };
    for apart in ["0.0000000002", "0.00000001", "0.000001"] {
        let contacts = events("x' = 1", &format!("(x - 1)*(x - 1 - {apart})"), &[0.0]);
        let [(event, errors)] = contacts.as_slice() else { panic!("{contacts:?}") };
        let second = 1.0 + apart.parse::<f64>().unwrap();
        for zero in [1.0, second] {
            assert!((event.time - zero).abs() <= errors.time && (event.time - zero).abs() <= errors.state[0]);
        }
        assert!(errors.time < second - 1.0, "{apart}: {}", errors.time);
    }
    let contacts = events("x'' = -pi^2*x", "x - 1", &[1.0, 0.0]);
    assert!(contacts.last().unwrap().1.time < 1e-13, "{contacts:?}");
}

/// The mass turns at π, and friction stops it at 2π; its velocity is known to be zero from there on, but not the time.
#[test]
fn the_time_at_which_friction_stops_a_motion_is_inside_its_error() {
    let system = System::new(&"x'' = -x - 0.3*sign(x')".parse().unwrap()).unwrap();
    let system = system.with_events(&[Event::zero_of("x'".parse().unwrap())]).unwrap();
    for tolerance in [1e-9, 1e-12, 1e-16] {
        let contacts = events_with_errors(&system, vec![1.0, 0.0], 9.0, tolerance);
        let [_, turn, stop] = contacts.as_slice() else { panic!("{contacts:?}") };
        for ((event, errors), time) in [(turn, PI), (stop, 2.0 * PI)] {
            let off = (event.time - time).abs();
            assert!(off <= errors.time, "{tolerance:e}: {off:e} {:e}", errors.time);
        }
        assert!(stop.1.time < 1e3 * tolerance.max(1e-16), "{:e}", stop.1.time);
    }
}

#[test]
fn errors_are_the_same_backward() {
    let system = System::new(&"x'' = -sin(x) - max(x, 0)".parse().unwrap()).unwrap();
    let (start, effort) = (system.start(&[("x", 1.0)]).unwrap(), Effort::to_tolerance(1e-12));
    let new = || StateErrors::new(&system, &start, &effort);
    let mut sides = [new(), new()];
    assert_eq!(sides[0].at(&start), Some(vec![0.0, 0.0]));
    let mut last = [start.clone(), start.clone()];
    integrate_both_ways(&system, &start, &[-20.0, 20.0], &effort, |accepted| {
        let end = accepted.step().end();
        let side = usize::from(end > 0.0);
        sides[side].follow(accepted);
        last[side] = Moment { time: end, state: accepted.step().state_at(end) };
        ControlFlow::Continue(())
    })
    .unwrap();
    let [before, after] = [0, 1].map(|side| sides[side].at(&last[side]).unwrap());
    for (before, after) in before.iter().zip(after) {
        assert!((before - after).abs() < 1e-6 * after && after > 1e-16, "{before:e} {after:e}");
    }
}

/// The effect of half a unit in the last place of the start on a motion that grows exponentially.
#[test]
fn the_effect_of_the_start_is_told() {
    let system = System::new(&"x' = x".parse().unwrap()).unwrap();
    let start = system.start(&[("x", 1.0)]).unwrap();
    let (_, errors) = determined(&system, &start, 20.0, 1e-12);
    let effect = errors.effect_of_start();
    let expected = 0.5 * f64::EPSILON * libm::exp(20.0);
    assert!((effect.state[0] - expected).abs() < 1e-3 * expected && effect.time == 20.0, "{effect:?}");
}

/// The formulas of a system, with names for their values.
fn observables(model: &Model, formulas: &[&str]) -> Observables {
    let names: Vec<String> = (0..formulas.len()).map(|number| format!("f{number}")).collect();
    let parsed = names.iter().zip(formulas).map(|(name, text)| (name.as_str(), text.parse().unwrap()));
    Observables::new(model, &parsed.collect::<Vec<_>>()).unwrap()
}

/// The moments and errors of samples and events, as long as they are determined.
type Rows = Vec<(Moment, MomentErrors)>;

/// The samples of a motion at some times with the errors of state and formulas, and the events.
fn rows(system: &System, start: &Moment, times: &[f64], tolerance: f64, formulas: &Observables) -> [Rows; 2] {
    let effort = Effort::to_tolerance(tolerance);
    let mut errors = SampledErrors::new(system, start, &effort, times, Some(formulas.gradients()));
    let motion = integrate_both_ways(system, start, times, &effort, |accepted| {
        errors.follow(accepted);
        ControlFlow::Continue(())
    });
    let motion = motion.unwrap();
    let samples = motion.samples.iter().map(|sample| (sample.clone(), errors.of_sample(sample.time)));
    let events = motion
        .events
        .iter()
        .map(|event| (Moment { time: event.time, state: event.state.clone() }, errors.of_event(event)));
    let determined = |(moment, errors): (Moment, Option<&MomentErrors>)| Some((moment, errors?.clone()));
    [samples.filter_map(determined).collect(), events.filter_map(determined).collect()]
}

/// The errors of the formulas of all runs of the table hold, including extrema
/// and steep formulas; the exact value is the formula of the state to 25 digits.
#[test]
fn sweep_formulas_of_every_sample_are_inside_their_errors() {
    let table = Table::read("state_errors.csv");
    let mut medians = vec![];
    for run in sweep::part(runs(&table), 6) {
        let first = run.rows[0];
        let model = Model::typed(first.text("equations"), &[], &[]).unwrap();
        let names = model.state_names();
        let (u, w) = (&names[0], names.last().unwrap());
        let texts = [
            format!("{u}*{w}"),
            format!("sin(30*{u})"),
            format!("({u})^2 + ({w})^2"),
            format!("1/(1 + ({u})^2)"),
            format!("abs({u} - {w})"),
            format!("max({w}, 0)*t"),
        ];
        let formulas = observables(&model, &texts.each_ref().map(String::as_str));
        let start = Moment { time: 0.0, state: Run::numbers(first, "start") };
        let times: Vec<f64> = run.rows.iter().map(|row| row.input("time")).collect();
        let [samples, _] =
            rows(&model.system().unwrap(), &start, &times, first.input("tolerance"), &formulas);
        let mut ratios = vec![];
        for ((sample, errors), row) in samples.iter().zip(&run.rows) {
            let truth = Moment { time: sample.time, state: Run::numbers(*row, "state") };
            let values = formulas.values_at(sample).into_iter().zip(formulas.values_at(&truth));
            // The exact state is rounded to doubles, and so are its formulas.
            let rounded = 30.0 * f64::EPSILON * truth.state.iter().map(|x| x * x).fold(1.0, f64::max);
            for ((formula, (value, truth)), stated) in texts.iter().zip(values).zip(&errors.formulas) {
                let off = (value - truth).abs();
                assert!(
                    off <= stated + rounded,
                    "{} {} {formula}: {off:e} {stated:e}",
                    run.name,
                    sample.time
                );
                ratios.extend((off > rounded).then(|| stated / off));
            }
        }
        medians.extend((!ratios.is_empty()).then(|| median(ratios)));
    }
    let all = median(medians);
    assert!(all < 1000.0, "{all}");
}

/// The equations, the state at the start, and each conserved quantity with its value.
type Conserved<'a> = (&'a str, Vec<f64>, Vec<(&'a str, f64)>);

/// Conserved quantities are known far better than the state, as errors along the motion do not change them: the energy of a double pendulum at a
/// chaotic amplitude, energy and angular momentum of Kepler's ellipse of eccentricity 1/2, and the energy in the potential of Hénon and Heiles.
#[test]
fn conserved_quantities_are_better_known_than_the_state() {
    const HENON: &str = "x'' = -x - 2*x*y; y'' = -y - x^2 + y^2";
    const KEPLER: &str = "x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2)";
    const DOUBLE: &str = "theta1'' = (-3*sin(theta1) - sin(theta1 - 2*theta2) - 2*sin(theta1 - theta2)*(theta2'^2 + theta1'^2*cos(theta1 - theta2)))/(3 - cos(2*theta1 - 2*theta2)); theta2'' = 2*sin(theta1 - theta2)*(2*theta1'^2 + 2*cos(theta1) + theta2'^2*cos(theta1 - theta2))/(3 - cos(2*theta1 - 2*theta2))";
    let cases: [Conserved; 3] = [
        (
            DOUBLE,
            vec![2.0, 2.0, 0.0, 0.0],
            // The energy at rest at 2 rad: −3·cos 2.
            vec![(
                "theta1'^2 + theta2'^2/2 + theta1'*theta2'*cos(theta1 - theta2) - 2*cos(theta1) - cos(theta2)",
                -3.0 * libm::cos(2.0),
            )],
        ),
        (
            KEPLER,
            // From the pericentre of an ellipse with semi-axis 1, with speed √3.
            vec![0.5, 0.0, 0.0, libm::sqrt(3.0)],
            vec![("(x'^2 + y'^2)/2 - 1/sqrt(x^2 + y^2)", -0.5), ("x*y' - y*x'", libm::sqrt(3.0) / 2.0)],
        ),
        (
            HENON,
            vec![0.0, 0.25, 0.5, 0.0],
            vec![("(x'^2 + y'^2 + x^2 + y^2)/2 + x^2*y - y^3/3", 0.125 + 0.03125 - 0.015625 / 3.0)],
        ),
    ];
    for (equations, state, conserved) in cases {
        let model = Model::typed(equations, &[], &[]).unwrap();
        let formulas = observables(&model, &conserved.iter().map(|(text, _)| *text).collect::<Vec<_>>());
        let times: Vec<f64> = (1..=300).map(|n| f64::from(n) / 3.0).collect();
        let start = Moment { time: 0.0, state };
        let [samples, _] = rows(&model.system().unwrap(), &start, &times, 1e-12, &formulas);
        assert!(samples.len() > 100, "{equations}");
        for (sample, errors) in &samples {
            let state = errors.state.iter().copied().fold(0.0, f64::max);
            let values = formulas.values_at(sample).into_iter().zip(&errors.formulas).zip(&conserved);
            for ((value, stated), (text, truth)) in values {
                let off = (value - truth).abs() - 4.0 * f64::EPSILON;
                assert!(off <= *stated, "{text} {}: {off:e} {stated:e}", sample.time);
                // Some hundred rounding errors in each of a thousand steps are 1e-11;
                // the second-order term is the square of the error of the state.
                let most = 1e-11 + 1e-3 * state + 100.0 * state * state;
                assert!(*stated < most, "{text} {}: {stated:e} where the state has {state:e}", sample.time);
            }
        }
    }
}

/// At the passages of the bottom and at turning points of a pendulum: the energy, the height, and the other quantity that vanishes at the event.
#[test]
fn formulas_at_events_are_inside_their_errors() {
    let formulas = ["theta", "theta'"].map(|text| Event::zero_of(text.parse().unwrap()));
    let model = Model::typed("theta'' = -sin(theta)", &[], &[]).unwrap();
    let system = model.system().unwrap().with_events(&formulas).unwrap();
    let texts = ["theta'^2/2 - cos(theta)", "theta*theta'", "1 - cos(theta)", "t", "max(theta, 0)"];
    let observed = observables(&model, &texts);
    let quarter = Pendulum::from_angular_frequency(1.0).unwrap();
    let quarter = quarter.released_from(Angle::from_radians(2.5).unwrap()).unwrap().period() / 4.0;
    let start = system.start(&[("theta", 2.5)]).unwrap();
    for tolerance in TOLERANCES {
        let [_, events] = rows(&system, &start, &[-50.0, 100.0], tolerance, &observed);
        assert!(events.len() > 40, "{}", events.len());
        for (event, errors) in events {
            let number = (event.time / quarter).round();
            let is_bottom = number.rem_euclid(2.0) == 1.0;
            let angle = if is_bottom { 0.0 } else { 2.5 * libm::cos(std::f64::consts::FRAC_PI_2 * number) };
            let truth = [-libm::cos(2.5), 0.0, 1.0 - libm::cos(angle), number * quarter, angle.max(0.0)];
            let values = observed.values_at(&event).into_iter().zip(truth).zip(&errors.formulas);
            for (text, ((value, truth), stated)) in texts.iter().zip(values) {
                let off = (value - truth).abs() - f64::EPSILON * (1.0 + truth.abs());
                assert!(off <= *stated, "{text} {} {tolerance:e}: {off:e} {stated:e}", event.time);
            }
        }
    }
}

/// A column whose function has no value next to the state, and one that jumps within the error of the state.
#[test]
fn formulas_at_the_end_of_their_domain_state_no_small_error() {
    let model = Model::typed("x'' = -x", &[], &[]).unwrap();
    let observed = observables(&model, &["sqrt(x)", "sign(x - 1/2)", "log(x + 1)"]);
    let start = Moment { time: 0.0, state: vec![1.0, 0.0] };
    // The state is −1 + 1e-17, −1/2 and 1/2 at these times, to the last digit.
    let times = [PI / 3.0, 2.0, PI];
    let [samples, _] = rows(&model.system().unwrap(), &start, &times, 1e-12, &observed);
    let errors: Vec<&Vec<f64>> = samples.iter().map(|(_, errors)| &errors.formulas).collect();
    assert!(errors[0][1] >= 1.0 && errors[0][0] < 1e-12, "{errors:?}");
    assert!(errors[1][0].is_nan() && errors[1][1] <= 0.0, "{errors:?}");
    assert!(errors[2][2].is_nan() || errors[2][2] > 0.1, "{errors:?}");
}

/// The derivatives of motions in closed form: a linear oscillator by its stiffness, damping and start.
#[test]
fn errors_of_derivatives_in_closed_form_hold() {
    let by = Sensitivities::new(&"x'' = -k*x".parse().unwrap(), &[("k", "4".parse().unwrap())], &["k", "x"]);
    let by = by.unwrap();
    let system = System::new(by.equation()).unwrap();
    for tolerance in TOLERANCES {
        let (moments, errors) = determined(&system, &by.start(&[1.0, 0.0]), 100.0, tolerance);
        assert!(errors.determined_until().is_none());
        for (Moment { time: t, state }, stated) in moments {
            let (sin, cos) = (libm::sin(2.0 * t), libm::cos(2.0 * t));
            let truth = [-t * sin / 4.0, -sin / 4.0 - t * cos / 2.0, cos, -2.0 * sin];
            let derivatives =
                by.derivatives_in(&state).into_iter().zip(by.derivatives_in(&stated)).zip(truth);
            for (number, ((computed, stated), truth)) in derivatives.enumerate() {
                // The rounding errors of the closed form.
                let off = (computed - truth).abs() - 4.0 * f64::EPSILON * (1.0 + t);
                assert!(off <= stated, "{number} {t} {tolerance:e}: {off:e} {stated:e}");
                assert!(stated < 1e6 * tolerance.max(1e-16) * (1.0 + t * t), "{t} {tolerance:e}: {stated:e}");
            }
        }
    }
}

/// The derivative by the second stiffness is zero until that spring acts, at π/2; then it is that of −sin(√b·u)/√b, with u = t − π/2.
#[test]
fn derivatives_that_begin_at_a_kink_are_determined() {
    let equation = "x'' = -max(x, 0) - b*min(x, 0)".parse().unwrap();
    let by = Sensitivities::new(&equation, &[("b", "2".parse().unwrap())], &["b"]).unwrap();
    let (moments, errors) =
        determined(&System::new(by.equation()).unwrap(), &by.start(&[1.0, 0.0]), 2.0, 1e-12);
    assert!(errors.determined_until().is_none());
    let (end, stated) = moments.last().unwrap();
    let (root, u) = (2.0_f64.sqrt(), end.time - PI / 2.0);
    let truth = libm::sin(root * u) / (4.0 * root) - u * libm::cos(root * u) / 4.0;
    let off = (by.derivatives_in(&end.state)[0] - truth).abs();
    assert!(off <= by.derivatives_in(stated)[0] + 1e-16, "{off:e} {stated:?}");
}

/// The pendulum from rest at θ0, by θ0: after whole periods the derivative of the angle is one, and that
/// of the velocity −T′(θ0)·sin θ0 for each period, with T′ from the complete integrals of both kinds.
#[test]
fn errors_of_derivatives_of_the_pendulum_hold() {
    let by = Sensitivities::new(&"theta'' = -sin(theta)".parse().unwrap(), &[], &["theta"]).unwrap();
    let system = System::new(by.equation()).unwrap();
    for amplitude in [0.5, 2.0, 3.0] {
        let k = libm::sin(amplitude / 2.0);
        let [first, second] = complete_integrals(k);
        // dT/dθ0 = 4·K′(k)·cos(θ0/2)/2 and K′(k) = (E/(1 − k²) − K)/k.
        let slope = 2.0 * libm::cos(amplitude / 2.0) * (second / (1.0 - k * k) - first) / k;
        let mut compared = 0;
        for tolerance in TOLERANCES {
            for periods in [1.0, 2.0, 5.0] {
                let time = 4.0 * first * periods;
                let (moments, errors) = determined(&system, &by.start(&[amplitude, 0.0]), time, tolerance);
                if errors.determined_until().is_some() {
                    continue;
                }
                let (end, stated) = moments.last().unwrap();
                let truth = [1.0, -(slope * periods) * -libm::sin(amplitude)];
                let derivatives =
                    by.derivatives_in(&end.state).into_iter().zip(by.derivatives_in(stated)).zip(truth);
                for ((computed, stated), truth) in derivatives {
                    // The time is a double: the effect of half an ulp, with second derivatives below 10·slope.
                    let rounded = f64::EPSILON * (10.0 * slope * time * periods + truth.abs());
                    let off = (computed - truth).abs() - rounded;
                    assert!(off <= stated, "{amplitude} {periods} {tolerance:e}: {off:e} {stated:e}");
                    compared += 1;
                }
            }
        }
        assert!(compared > 10, "{amplitude}: {compared}");
    }
}

/// K and E by the arithmetic-geometric mean.
fn complete_integrals(k: f64) -> [f64; 2] {
    let (mut a, mut g, mut c, mut power, mut sum) = (1.0, libm::sqrt(1.0 - k * k), k, 0.5, 0.0);
    while c.abs() > 1e-17 {
        sum += power * c * c;
        (a, g, c) = (0.5 * (a + g), libm::sqrt(a * g), 0.5 * (a - g));
        power *= 2.0;
    }
    let first = std::f64::consts::FRAC_PI_2 / a;
    [first, first * (1.0 - sum)]
}

/// The state of a typed motion at a time with its errors; `None` if it is no longer determined.
fn ended(equation: &str, start: &[(&str, f64)], time: f64) -> (Vec<f64>, Option<Vec<f64>>) {
    let system = System::new(&equation.parse().unwrap()).unwrap();
    let (start, effort) = (system.start(start).unwrap(), Effort::to_tolerance(1e-12));
    let mut errors = StateErrors::new(&system, &start, &effort);
    let end = integrate_from(&system, &Start::State(start), &[time], &effort, |accepted| {
        errors.follow(accepted);
        ControlFlow::Continue(())
    });
    let end = end.unwrap().end;
    let stated = errors.at(&end);
    (end.state, stated)
}

/// The equilibria and final velocities are zeros of the forces.
#[test]
fn motions_with_kinks_are_determined_where_they_come_to_rest() {
    for (equation, time, component, exact) in [
        ("x'' = -x - 0.5*max(x + 0.5, 0) - 0.2*x'", 1000.0, 0, -1.0 / 6.0),
        ("x'' = -1 - 64*min(x, 0) - 4*x'", 40.0, 0, -1.0 / 64.0),
        ("x' = -x - 1 - 0.1*abs(x)", 100.0, 0, -10.0 / 9.0),
        ("x'' = -x - 1 - 0.1*max(x - 9, 0) - 0.2*x'", 1000.0, 0, -1.0),
        ("x'' = -1 - 0.1*x'*abs(x')", 1000.0, 1, -libm::sqrt(10.0)),
    ] {
        let (state, errors) = ended(equation, &[("x", 1.0)], time);
        let error = errors.unwrap_or_else(|| panic!("{equation}: not determined"))[component];
        assert!((state[component] - exact).abs() <= error, "{equation}: {state:?} ± {error:e}");
        assert!(error < 1e-11, "{equation}: {error:e}");
    }
}

/// A motion that begins at a jump, by an equation of the second order and by two of the first order.
#[test]
fn friction_on_a_released_body_is_determined_in_both_forms() {
    let (second, errors) = ended("x'' = -x - 0.3*sign(x')", &[("x", 3.0)], 8.0);
    let (first, others) = ended("x' = v; v' = -x - 0.3*sign(v)", &[("x", 3.0)], 8.0);
    let (errors, others) = (errors.unwrap(), others.unwrap());
    for number in 0..2 {
        let off = (first[number] - second[number]).abs();
        assert!(off <= errors[number] + others[number], "{first:?} ± {others:?}, {second:?} ± {errors:?}");
        assert!(others[number] < 1e-12, "{others:?}");
    }
}

/// Forces that jump at the same surface, once as a zero of a nonlinear formula and once as one of a linear formula, have the same motion within
/// their errors, which are small unless the nonlinear formula vanishes with its slope and is not a power.
#[test]
fn jumps_at_curved_arguments_are_where_these_vanish() {
    const FLAT: [&str; 2] = ["sign(x - sin(x))", "sign(sinh(x) - x)"];
    let pairs = [
        ("sign(x^3)", "sign(x)"),
        ("sign(-2*x*abs(x))", "sign(-x)"),
        ("sign(sin(x)^3/4)", "sign(sin(x))"),
        ("(max(sign(x), 0) - 1/2)*2", "sign(x)"),
        ("x/sqrt(x^2)", "sign(x)"),
        (FLAT[0], "sign(x)"),
        (FLAT[1], "sign(x)"),
        ("sign(x*(x + 0.3))", "sign(x)*sign(x + 0.3)"),
        ("sign(x^3 - 0.125)", "sign(x - 0.5)"),
        ("sign(exp(2*x) - 0.5)", "sign(x + log(2)/2)"),
        ("sign((x + 2)^7 - 128)", "sign(x)"),
        ("sign(x + 1/2 - 1/(x + 7/2))", "sign(x + 2 - sqrt(13)/2)"),
    ];
    for (curved, linear) in pairs {
        for tolerance in TOLERANCES {
            let [curved_end, linear_end] = [curved, linear].map(|jump| {
                let system = System::new(&format!("x'' = -x - 0.3*{jump}").parse().unwrap()).unwrap();
                let start = system.start(&[("x", 2.0), ("x'", 0.3)]).unwrap();
                let effort = Effort::to_tolerance(tolerance);
                let mut errors = StateErrors::new(&system, &start, &effort);
                let end = integrate_from(&system, &Start::State(start), &[15.0], &effort, |accepted| {
                    errors.follow(accepted);
                    ControlFlow::Continue(())
                });
                let end = end.unwrap().end;
                let errors = errors.at(&end).unwrap();
                (end.state, errors)
            });
            for number in 0..2 {
                let off = (curved_end.0[number] - linear_end.0[number]).abs();
                let allowed = curved_end.1[number] + linear_end.1[number];
                assert!(off <= allowed, "{curved} {tolerance:e}: {off:e} {allowed:e}");
                let largest = if FLAT.contains(&curved) { 1e-3 } else { 1e4 * tolerance.max(1e-16) };
                assert!(allowed < largest, "{curved} {tolerance:e}: {allowed:e}");
            }
        }
    }
}
