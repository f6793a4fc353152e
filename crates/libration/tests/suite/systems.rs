//! The named systems in time, against the forty digits of `damped.csv`.

use crate::golden::{Row, Table};
use crate::ulp::Truth;
use libration::expression::Expression;
use libration::systems::Model;
use libration::taylor::{Cause, Effort, IntegrationError, Moment, integrate};
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

/// The state at the time of a row at tolerance 1e-15, and the drift of the energy where it is conserved.
fn end(row: Row) -> (Vec<f64>, Option<f64>) {
    let (model, start) = (model(row), start(row));
    let energy = model.energy().ok();
    let mut balance = energy.as_ref().map(|energy| energy.balance(&start));
    let effort = Effort::to_tolerance(1e-15);
    let solution = integrate(&model.system().unwrap(), &start, &[row.input("time")], &effort, |step| {
        if let Some(balance) = &mut balance {
            balance.record(&Moment { time: step.end(), state: step.state_at(step.end()) });
        }
        ControlFlow::Continue(())
    });
    let solution = match solution {
        // Held fast by dry friction.
        Err(IntegrationError::Stopped { cause: Cause::NoWayOn, solution }) => *solution,
        other => other.unwrap(),
    };
    (solution.end.state, balance.map(|balance| balance.drift()))
}

/// Roundings have the size of the numbers, grow as the motion's sensitivity says, and go into the motion all the time:
/// the largest size and sensitivity until now say how much. A drive adds the rounding of its phase ωt.
///
/// Run with --nocapture for the error of each.
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

#[test]
fn energies_are_the_same_in_all_states_of_a_motion() {
    let mut conservative = 0;
    for row in Table::read("damped.csv").rows().filter(|row| row.text("kind") == "sample") {
        let Ok(energy) = model(row).energy() else { continue };
        let state = truths(row).iter().map(|truth| truth.hi).collect();
        let drift = energy.drift(&start(row), &Moment { time: row.input("time"), state });
        // Rounded states have rounded energies; the stiffest spring counts twentyfold.
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
    let solution = integrate(&model.system().unwrap(), &start, &times, &Effort::to_tolerance(1e-15), |_| {
        ControlFlow::Continue(())
    });
    let [angle, velocity] = solution.unwrap().end.state.try_into().unwrap();
    let turns = (angle / TAU).round();
    // The time of fifty periods is rounded to 3e-14, the angle to its own ulp.
    assert!(error(&[angle - turns * TAU, velocity], &truths(row)) < 1e-13, "{angle} {velocity}");
}
