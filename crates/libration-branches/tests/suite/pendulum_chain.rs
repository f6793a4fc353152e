//! Pendulums in a row with springs between them.

use libm::{cos, sin, sqrt};
use libration::expression::Expression;
use libration::normal_modes::NormalModes;
use libration::progress::Quiet;
use libration::systems::Model;
use libration::taylor::{Effort, Moment, Solution, integrate};
use std::f64::consts::PI;

fn chain(values: &[(&str, &str)]) -> Model {
    let values: Vec<(&str, Expression)> =
        values.iter().map(|(name, value)| (*name, value.parse().unwrap())).collect();
    Model::by_key("pendulum_chain", &values, &[]).unwrap()
}

fn solve(model: &Model, start: &[(&str, f64)], time: f64) -> Solution {
    let start = model.start(start).unwrap();
    integrate(&model.system().unwrap(), &start, &[time], &Effort::to_tolerance(1e-15), &Quiet).unwrap()
}

/// ω² = ω0² + 4κ·sin²(πk/2n), and pendulum i moves as cos(πk(i − 1/2)/n).
#[test]
fn its_modes_are_those_of_a_chain_with_free_ends() {
    for n in [1_u32, 2, 3, 4, 5] {
        let model = chain(&[("n", &n.to_string()), ("omega0", "1.5"), ("kappa", "0.4")]);
        let modes = NormalModes::new(model.equation()).unwrap().modes;
        assert_eq!(modes.len(), n as usize);
        for (k, mode) in (0..n).zip(&modes) {
            let phase = PI * f64::from(k) / f64::from(n);
            let squared = 2.25 + 1.6 * sin(0.5 * phase) * sin(0.5 * phase);
            assert!((mode.frequency() - sqrt(squared)).abs() < 1e-13, "{n} {k}: {}", mode.frequency());
            let exact: Vec<f64> = (0..n).map(|i| cos(phase * (f64::from(i) + 0.5))).collect();
            let scale = mode.shape[0].re / exact[0];
            for (computed, exact) in mode.shape.iter().zip(&exact) {
                assert!((computed.re - scale * exact).abs() < 1e-11, "{n} {k}: {:?}", mode.shape);
            }
        }
    }
}

/// An oscillation of a billionth of a radian in the shape of a mode of forty pendulums.
#[test]
fn a_small_mode_swings_with_its_frequency() {
    let (n, k, time) = (40, 7.0, 30.0);
    let model = chain(&[("n", "40"), ("kappa", "2")]);
    let shape: Vec<f64> = (0..n).map(|i| 1e-9 * cos(PI * k * (f64::from(i) + 0.5) / f64::from(n))).collect();
    let names: Vec<String> = (1..=n).map(|i| format!("theta{i}")).collect();
    let start: Vec<(&str, f64)> = names.iter().map(String::as_str).zip(shape.iter().copied()).collect();
    let quarter = sin(0.5 * PI * k / f64::from(n));
    let swung = cos(sqrt(1.0 + 8.0 * quarter * quarter) * time);
    let end = solve(&model, &start, time).end.state;
    assert!(end.iter().zip(&shape).all(|(angle, shape)| (angle - shape * swung).abs() < 1e-22), "{end:?}");
}

#[test]
fn two_of_it_are_the_coupled_pendulums() {
    let pair = Model::by_key("coupled_pendulums", &[], &[]).unwrap();
    let start = [("theta1", 2.0), ("theta2'", 0.5)];
    let [two, pair] = [&chain(&[("n", "2")]), &pair].map(|model| solve(model, &start, 20.0).end.state);
    assert!(two.iter().zip(&pair).all(|(a, b)| (a - b).abs() < 1e-12), "{two:?} {pair:?}");
}

/// At equal angles the springs exert no force: each pendulum moves alone.
#[test]
fn pendulums_side_by_side_swing_as_one() {
    let model = chain(&[("n", "5"), ("kappa", "3")]);
    let names = ["theta1", "theta2", "theta3", "theta4", "theta5"];
    let together = solve(&model, &names.map(|name| (name, 3.0)), 15.0).end.state;
    let alone = solve(&Model::by_key("pendulum", &[], &[]).unwrap(), &[("theta", 3.0)], 15.0).end.state;
    assert!(together[..5].iter().all(|angle| (angle - alone[0]).abs() < 1e-12), "{together:?} {alone:?}");
}

#[test]
fn its_energy_is_the_sum_over_pendulums_and_springs() {
    let (kappa, n) = (0.7, 6);
    let model = chain(&[("n", "6"), ("kappa", "0.7")]);
    let energy = |Moment { state, .. }: &Moment| {
        let (angles, speeds) = state.split_at(n);
        let swing = |(angle, speed): (&f64, &f64)| 0.5 * speed * speed + 1.0 - cos(*angle);
        let spring = |pair: &[f64]| 0.5 * kappa * (pair[1] - pair[0]) * (pair[1] - pair[0]);
        angles.iter().zip(speeds).map(swing).sum::<f64>() + angles.windows(2).map(spring).sum::<f64>()
    };
    let start = [("theta1", 2.5), ("theta4'", -1.0)];
    let before = energy(&model.start(&start).unwrap());
    let after = energy(&solve(&model, &start, 50.0).end);
    assert!((after / before - 1.0).abs() < 1e-13, "{before} {after}");
}
