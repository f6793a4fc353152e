//! Named systems with conserved energy: stars, planets and chains, compared with the thirty digits of `conservative.csv`.

use libration::expression::Expression;
use libration::progress::Quiet;
use libration::systems::Model;
use libration::taylor::{Effort, Moment, integrate, integrate_stepwise};
use libration_testing::condition::{Growth, error};
use libration_testing::golden::Table;
use libration_testing::ulp::from_hex;
use std::f64::consts::PI;
use std::ops::ControlFlow;

fn model(key: &str, set: &str) -> Model {
    let set = set.split(',').filter_map(|item| item.split_once('='));
    let values: Vec<(&str, Expression)> = set.map(|(name, value)| (name, value.parse().unwrap())).collect();
    Model::by_key(key, &values, &[]).unwrap()
}

/// Rounding errors have the size of the numbers, and grow by the sensitivity of the motion. Those
/// of N numbers are independent and add up to √N times as much. The energy does not change.
#[test]
fn every_motion_is_met_as_well_as_its_condition_allows() {
    let mut growth = Growth::default();
    for row in Table::read("conservative.csv").rows() {
        let model = model(row.text("system"), row.text("set"));
        let start: Vec<f64> = row.text("start_hex").split(' ').map(from_hex).collect();
        let start = Moment { time: 0.0, state: start };
        let energy = model.energy().unwrap();
        let mut balance = energy.balance(&start);
        let times = [row.input("time")];
        let effort = Effort::to_tolerance(1e-15);
        let end = integrate_stepwise(&model.system().unwrap(), &start, &times, &effort, |step| {
            balance.record(&Moment { time: step.end(), state: step.state_at(step.end()) });
            ControlFlow::Continue(())
        });
        let case = format!("{} {} {:?}", row.text("system"), row.text("set"), &start.state[..2]);
        let error = error(&end.unwrap().end.state, row);
        let numbers = f64::from(u32::try_from(start.state.len()).unwrap()).sqrt();
        let allowed = numbers * growth.until(&case, row);
        assert!(error <= allowed, "{case} at {}: {error:e}", times[0]);
        assert!(balance.drift() < 2e-14, "{case} at {}: {}", times[0], balance.drift());
    }
}

/// Fermi, Pasta and Ulam's chain, to a tolerance of 1e-15, at the times of `chains.csv` up to `end`, each with the error there and the allowed
/// error: as above, and four more rounding errors of the phase for each period of the lowest mode, so that the error grows like the time.
fn errors_of_chain(set: &str, end: f64) -> Vec<[f64; 3]> {
    let table = Table::read("chains.csv");
    let rows = || table.rows().filter(|row| row.text("set") == set && row.input("time") <= end);
    let start: Vec<f64> = rows().next().unwrap().text("start_hex").split(' ').map(from_hex).collect();
    let times: Vec<f64> = rows().map(|row| row.input("time")).collect();
    let system = model("fermi_pasta_ulam", set).system().unwrap();
    let numbers = f64::from(u32::try_from(start.len()).unwrap()).sqrt();
    let effort = Effort::to_tolerance(1e-15);
    let motion = integrate(&system, &Moment { time: 0.0, state: start }, &times, &effort, &Quiet).unwrap();
    let mut growth = Growth::default();
    let errors = motion.samples.iter().zip(rows()).map(|(sample, row)| {
        let periods = sample.time / 66.0;
        let allowed =
            numbers * growth.until(set, row) + 4.0 * f64::EPSILON * (1.0 + row.input("size")) * periods;
        assert!(row.input("uncertainty") < 0.01 * allowed);
        [sample.time, error(&sample.state, row), allowed]
    });
    errors.collect()
}

fn chains_are_where_they_should_be(end: f64) {
    for set in ["alpha=0.25,beta=0", "alpha=0,beta=8"] {
        for [time, error, allowed] in errors_of_chain(set, end) {
            assert!(error <= allowed, "{set} at {time}: {error:e}, allowed {allowed:e}");
        }
    }
}

/// A hundred periods of the lowest mode.
#[test]
fn chains_are_where_another_integrator_finds_them_in_more_digits() {
    chains_are_where_they_should_be(7000.0);
}

/// `cargo test --release -p libration --test suite ten_thousand_periods -- --ignored`
#[test]
#[ignore = "two minutes in a release build"]
fn chains_are_where_they_should_be_after_ten_thousand_periods() {
    chains_are_where_they_should_be(f64::INFINITY);
}

/// The energy of Fermi, Pasta and Ulam's chain as an explicit sum.
fn energy_of_chain(state: &[f64], alpha: f64, beta: f64) -> f64 {
    let (places, velocities) = state.split_at(state.len() / 2);
    let ends = [&[0.0], places, &[0.0]].concat();
    let spring = |d: f64| d * d * (0.5 + d * (alpha / 3.0 + d * beta / 4.0));
    let springs = ends.windows(2).map(|pair| spring(pair[1] - pair[0])).sum::<f64>();
    springs + velocities.iter().map(|v| 0.5 * v * v).sum::<f64>()
}

/// The largest relative change of the energy at a hundred times, for a motion that begins in the lowest mode.
fn drift_of_chain(alpha: &str, beta: &str, end: f64) -> f64 {
    let model = model("fermi_pasta_ulam", &format!("alpha={alpha},beta={beta}"));
    let mode = (1..=32).map(|i| libm::sin(PI * f64::from(i) / 33.0)).chain([0.0; 32]);
    let start = Moment { time: 0.0, state: mode.collect() };
    let times: Vec<f64> = (1..=100).map(|part| end * f64::from(part) / 100.0).collect();
    let motion =
        integrate(&model.system().unwrap(), &start, &times, &Effort::to_tolerance(1e-15), &Quiet).unwrap();
    let [alpha, beta] = [alpha, beta].map(|text| text.parse().unwrap());
    let energy = energy_of_chain(&start.state, alpha, beta);
    let changes =
        motion.samples.iter().map(|sample| energy_of_chain(&sample.state, alpha, beta) / energy - 1.0);
    changes.fold(0.0, |largest, change| f64::max(largest, change.abs()))
}

/// Twenty periods of the lowest mode, 66 each; the ignored test takes ten thousand.
#[test]
fn a_chain_keeps_its_energy() {
    for (alpha, beta) in [("0.25", "0"), ("0", "8")] {
        let drift = drift_of_chain(alpha, beta, 1320.0);
        assert!(drift < 1e-14, "alpha = {alpha}, beta = {beta}: {drift:e}");
    }
}

/// `cargo test --release -p libration --test suite ten_thousand_periods -- --ignored`
#[test]
#[ignore = "three minutes in a release build"]
fn a_chain_keeps_its_energy_for_ten_thousand_periods() {
    for (alpha, beta) in [("0.25", "0"), ("0", "8")] {
        let drift = drift_of_chain(alpha, beta, 6.6e5);
        assert!(drift < 1e-12, "alpha = {alpha}, beta = {beta}: {drift:e}");
    }
}
