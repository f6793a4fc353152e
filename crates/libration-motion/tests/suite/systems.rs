//! Motions of the named systems, compared with the forty digits of `damped.csv`.

use libration::expression::Expression;
use libration::progress::Quiet;
use libration::systems::{Model, NamedSystem, PendulumParametersError};
use libration::taylor::{Contact, Effort, Event, Moment, integrate, integrate_stepwise};
use libration_testing::golden::{Row, Table};
use libration_testing::ulp::Truth;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

fn model(row: Row) -> Model {
    let set = row.text("set").split(',').filter(|item| !item.is_empty());
    let values: Vec<(&str, Expression)> = set
        .map(|item| item.split_once('=').unwrap())
        .map(|(name, value)| (name, value.parse().unwrap()))
        .collect();
    Model::by_key(row.text("system"), &values, &[]).unwrap()
}

fn start(row: Row) -> Moment {
    Moment { time: 0.0, state: row.text("start").split(' ').map(|text| text.parse().unwrap()).collect() }
}

fn truths(row: Row) -> Vec<Truth> {
    row.text("state").split(' ').map(Truth::from_decimal).collect()
}

/// The largest error of a state.
fn error(state: &[f64], truths: &[Truth]) -> f64 {
    let distance = |(got, truth): (&f64, &Truth)| ((got - truth.hi) - truth.lo).abs();
    state.iter().zip(truths).map(distance).fold(0.0, f64::max)
}

fn size(truths: &[Truth]) -> f64 {
    truths.iter().map(|truth| truth.hi.abs()).fold(0.0, f64::max)
}

fn name(row: Row) -> String {
    format!("{} {} from {}", row.text("system"), row.text("set"), row.text("start"))
}

/// The state at the time of a row at tolerance 1e-15, and the drift of the energy if it is conserved.
fn end(row: Row) -> (Vec<f64>, Option<f64>) {
    let (model, start) = (model(row), start(row));
    let energy = model.energy().ok();
    let mut balance = energy.as_ref().map(|energy| energy.balance(&start));
    let effort = Effort::to_tolerance(1e-15);
    let solution =
        integrate_stepwise(&model.system().unwrap(), &start, &[row.input("time")], &effort, |step| {
            if let Some(balance) = &mut balance {
                balance.record(&Moment { time: step.end(), state: step.state_at(step.end()) });
            }
            ControlFlow::Continue(())
        });
    (solution.unwrap().end.state, balance.map(|balance| balance.drift()))
}

/// The error bound: rounding errors have the size of the numbers, occur at all times, and grow by the sensitivity of the motion, so that the
/// largest size and sensitivity up to a time determine the bound. A drive adds the rounding error of its phase ωt.
///
/// Run with --nocapture to print the error of each motion.
#[test]
fn every_motion_is_met_as_well_as_its_condition_allows() {
    let table = Table::read("damped.csv");
    let (mut case, mut largest) = (String::new(), [0.0_f64; 2]);
    for row in table.rows().filter(|row| row.text("kind") == "sample") {
        let truths = truths(row);
        largest = if case == name(row) { largest } else { [0.0; 2] };
        case = name(row);
        largest = [largest[0].max(size(&truths)), largest[1].max(row.input("sensitivity"))];
        let (state, drift) = end(row);
        let phase = model(row).drive_frequency().unwrap_or(0.0) * row.input("time");
        let allowed = f64::EPSILON * ((1.0 + largest[0]) * (1.0 + largest[1]) + phase);
        let error = error(&state, &truths);
        eprintln!(
            "{case} at {}: error {error:.1e}, allowed {allowed:.1e}, energy drift {drift:?}",
            row.text("time")
        );
        assert!(error <= allowed, "{case} at {}: {state:?} is wrong by {error:e}", row.text("time"));
        assert!(drift.is_none_or(|drift| drift < 1e-14), "{case} at {}: energy {drift:?}", row.text("time"));
    }
}

/// The rows of one case and one kind.
fn rows<'a>(table: &'a Table, case: Row<'_>, kind: &str) -> Vec<Row<'a>> {
    let same = |row: &Row<'a>| name(*row) == name(case) && row.text("kind") == kind;
    table.rows().filter(same).collect()
}

/// The first turning point is found with all later ones, each as exactly as the motion and its acceleration allow, and none if there is none.
#[test]
fn turning_points_are_those_of_the_table() {
    let table = Table::read("damped.csv");
    let firsts = table.rows().filter(|row| row.text("kind") == "sample" && row.text("time") == "0.5");
    let mut compared = 0;
    for case in firsts {
        let turnings = rows(&table, case, "turning");
        let samples = rows(&table, case, "sample");
        let sensitivity = samples.iter().map(|row| row.input("sensitivity")).fold(1.0, f64::max);
        let system = model(case).system().unwrap();
        let system = system.with_events(&[Event::zero_of("theta'".parse().unwrap())]).unwrap();
        let end = samples.last().unwrap().input("time");
        let effort = Effort::to_tolerance(1e-15);
        let solution = integrate(&system, &start(case), &[end], &effort, &Quiet).unwrap();
        let events: Vec<_> = solution.events.iter().filter(|event| event.contact != Contact::Start).collect();
        assert_eq!(events.len(), turnings.len(), "{}: {:?}", name(case), solution.events);
        for (event, row) in events.iter().zip(&turnings) {
            let truths = truths(*row);
            let allowed = f64::EPSILON * (1.0 + size(&truths)) * (1.0 + sensitivity);
            let acceleration = libm::sin(truths[0].hi).abs();
            let late = error(&[event.time], &[row.truth("time")]);
            let off = error(&event.state, &truths);
            eprintln!("{} turns at {}: time off by {late:.1e}, state by {off:.1e}", name(case), event.time);
            // The time itself is rounded to an f64.
            assert!(
                late <= allowed / acceleration + f64::EPSILON * event.time,
                "{}: {event:?} {late:e}",
                name(case)
            );
            assert!(off <= allowed + f64::EPSILON * event.time, "{}: {event:?} {off:e}", name(case));
            compared += 1;
        }
    }
    assert!(compared > 40, "{compared}");
}

#[test]
fn energies_are_the_same_in_all_states_of_a_motion() {
    let mut conservative = 0;
    for row in Table::read("damped.csv").rows().filter(|row| row.text("kind") == "sample") {
        let Ok(energy) = model(row).energy() else { continue };
        let state = truths(row).iter().map(|truth| truth.hi).collect();
        let drift = energy.drift(&start(row), &Moment { time: row.input("time"), state });
        // Rounded states have rounded energies; the stiffest spring has twenty times the weight.
        assert!(drift < 2e-14, "{}: {drift}", name(row));
        conservative += 1;
    }
    assert!(conservative > 30);
}

#[test]
fn a_driven_pendulum_comes_to_its_attractor() {
    let table = Table::read("damped.csv");
    let row = table.rows().find(|row| row.text("kind") == "attractor").unwrap();
    let model = model(row);
    let period = TAU / model.drive_frequency().unwrap();
    let start = Moment { time: 0.0, state: vec![0.7, 0.3] };
    let times = [50.0 * period];
    let solution = integrate(&model.system().unwrap(), &start, &times, &Effort::to_tolerance(1e-15), &Quiet);
    let [angle, velocity] = solution.unwrap().end.state.try_into().unwrap();
    let turns = (angle / TAU).round();
    // The time of fifty periods is rounded to 3e-14, the angle to its ulp.
    assert!(error(&[angle - turns * TAU, velocity], &truths(row)) < 1e-13, "{angle} {velocity}");
}

#[test]
fn the_numbers_of_a_state_have_units_where_they_are_known() {
    let spring = Model::by_key("spring_pendulum", &[], &[]).unwrap();
    assert_eq!(spring.state_units(), ["m", "rad", "m/s", "rad/s"]);
    let typed = Model::typed("theta1'' = -sin(theta1) + x; x'' = -x; omega'' = 0", &[], &[]).unwrap();
    assert_eq!(typed.state_units(), ["rad", "", "", "rad/s", "", ""]);
    let angles: Vec<bool> = typed.coordinates().iter().map(|coordinate| coordinate.is_angle()).collect();
    assert_eq!(angles, [true, false, false]);
}

/// The drift and its uncertainty for a motion given as text, up to a time.
fn balanced(equations: &str, state: &[f64], time: f64) -> (f64, f64) {
    let model = Model::typed(equations, &[], &[]).unwrap();
    let start = Moment { time: 0.0, state: state.to_vec() };
    let energy = model.energy().unwrap();
    let mut balance = energy.balance(&start);
    let outcome =
        integrate_stepwise(&model.system().unwrap(), &start, &[time], &Effort::to_tolerance(1e-12), |step| {
            balance.record(&Moment { time: step.end(), state: step.state_at(step.end()) });
            ControlFlow::Continue(())
        });
    // A pole may end the motion.
    drop(outcome);
    (balance.drift(), balance.drift_uncertainty())
}

#[test]
fn the_work_of_forces_next_to_poles_is_known_as_well_as_it_can_be() {
    let towards_poles: [(&str, &[f64], f64); 6] = [
        ("x'' = 1/(2 - x)", &[1.9, 1.0], 0.06),
        ("x'' = 1/(3 - x)", &[2.9, 1.0], 0.06),
        ("x'' = tan(x)", &[1.0, 1.0], 0.3),
        ("x'' = 1/cos(x)", &[1.5, 1.0], 0.04),
        ("x'' = 1/(x - 2)^2", &[1.9, 1.0], 0.015),
        ("x'' = -1/x^2", &[1.0, 0.0], 1.0),
    ];
    for (equations, state, before) in towards_poles {
        let (drift, uncertainty) = balanced(equations, state, before);
        assert!(drift < 1e-11 && uncertainty < 1e-14, "{equations}: {drift:e} ± {uncertainty:e}");
        // The last steps are some 1e-15 from the pole, where positions of order one, rounded to 1e-16, leave a tenth of the force uncertain.
        let (drift, uncertainty) = balanced(equations, state, 10.0);
        assert!(drift < 0.1 && uncertainty < 0.1, "{equations}: {drift:e} ± {uncertainty:e}");
    }
    let (drift, uncertainty) = balanced("x'' = -x^3 - x/(1 + x^2)", &[1.0, 0.0], 30.0);
    assert!(drift < 1e-11 && uncertainty < 1e-13, "{drift:e} ± {uncertainty:e}");
}

#[test]
fn coordinates_have_the_units_of_their_names() {
    let model = Model::typed("theta1'' = -theta1 - r; r'' = -r - phi; phi'' = -phi", &[], &[]).unwrap();
    assert_eq!(model.state_names(), ["theta1", "r", "phi", "theta1'", "r'", "phi'"]);
    assert_eq!(model.state_units(), ["rad", "", "rad", "rad/s", "", "rad/s"]);
    assert_eq!(
        model.coordinates().iter().map(|coordinate| coordinate.is_angle()).collect::<Vec<_>>(),
        [true, false, true]
    );
    let spring = Model::by_key("spring_pendulum", &[], &[]).unwrap();
    assert_eq!(spring.state_units(), ["m", "rad", "m/s", "rad/s"]);
    assert_eq!(spring.system().unwrap().state_names(), spring.state_names());
}

#[test]
fn pendulums_have_the_frequency_of_their_length_and_gravity() {
    let values = |key: &str, length: Option<f64>, gravity: Option<f64>| {
        let values = NamedSystem::by_key(key).unwrap().values_of(length, gravity);
        values.map(|values| {
            values.iter().map(|(name, value)| (*name, value.to_f64().unwrap())).collect::<Vec<_>>()
        })
    };
    assert_eq!(values("pendulum", Some(4.0), Some(9.0)).unwrap(), [("omega0", 1.5)]);
    assert_eq!(values("damped_pendulum", Some(1.0), None).unwrap(), [("omega0", 9.80665_f64.sqrt())]);
    assert_eq!(values("pendulum", None, Some(9.0)).unwrap(), [("omega0", 3.0)]);
    let double = values("double_pendulum", Some(0.5), None).unwrap();
    assert_eq!(double, [("l1", 0.5), ("l2", 0.5), ("g", 9.80665)]);
    assert_eq!(values("double_pendulum", None, Some(3.7)).unwrap(), [("g", 3.7)]);
    for (key, length, gravity) in
        [("physical_pendulum", Some(1.0), None), ("physical_pendulum", Some(1.0), Some(9.8))]
    {
        let refused = values(key, length, gravity);
        assert!(
            matches!(refused, Err(PendulumParametersError::Without { what: "length", .. })),
            "{refused:?}"
        );
    }
    for impossible in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            values("pendulum", Some(impossible), None),
            Err(PendulumParametersError::NotAbove(_))
        ));
    }
}

#[test]
fn an_energy_that_had_no_value_once_has_no_drift() {
    let model = Model::by_key("pendulum", &[], &[]).unwrap();
    let energy = model.energy().unwrap();
    let moment = |state: [f64; 2]| Moment { time: 0.0, state: state.to_vec() };
    let mut balance = energy.balance(&moment([1.0, 0.0]));
    balance.record(&moment([f64::NAN, 0.0]));
    balance.record(&moment([0.5, 0.9]));
    assert!(balance.drift().is_nan());
}

/// Next to an equilibrium that is not an `f64` the kinetic energy is less
/// than the rounding errors of the energy, which therefore shows no change.
#[test]
fn the_energy_of_what_rests_does_not_drift() {
    let starts = [
        ("henon_heiles", [("x", libm::sqrt(0.75)), ("y", -0.5)]),
        ("henon_heiles", [("x", -libm::sqrt(0.75)), ("y", -0.5)]),
        ("double_pendulum", [("theta1", std::f64::consts::PI), ("theta2", 0.0)]),
    ];
    for (key, start) in starts {
        let model = Model::by_key(key, &[], &[]).unwrap();
        let start = model.start(&start).unwrap();
        let end = integrate(&model.system().unwrap(), &start, &[10.0], &Effort::to_tolerance(1e-12), &Quiet)
            .unwrap()
            .end;
        assert_eq!(model.energy().unwrap().drift(&start, &end), 0.0, "{key} {start:?}");
    }
}
