//! The named systems in time, against the forty digits of `damped.csv`.

use crate::golden::{Row, Table};
use crate::ulp::Truth;
use libration::expression::Expression;
use libration::systems::Model;
use libration::taylor::{Effort, Moment, integrate};
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

/// What a row is about: system, values and start.
fn case(row: Row) -> [&str; 3] {
    [row.text("system"), row.text("set"), row.text("start")]
}

/// The largest error of a state, in units of 2⁻⁵³.
fn error(state: &[f64], truths: &[Truth]) -> f64 {
    let distance = |(got, truth): (&f64, &Truth)| ((got - truth.hi) - truth.lo).abs();
    let largest = state.iter().zip(truths).map(distance).fold(0.0, f64::max);
    largest * 2_f64.powi(53)
}

#[test]
fn errors() {
    let table = Table::read("damped.csv");
    let mut last = ["", "", ""];
    let mut worst = 0.0;
    for row in table.rows().filter(|row| row.text("kind") == "sample") {
        let model = model(row);
        let time = row.input("time");
        let solution =
            integrate(&model.system().unwrap(), &start(row), &[time], &Effort::to_tolerance(1e-15), |_| {
                ControlFlow::Continue(())
            });
        let Ok(solution) = solution else {
            eprintln!("{:?} {time}: {:?}", case(row), solution.map(|s| s.steps));
            continue;
        };
        let truths = truths(row);
        let size = truths.iter().map(|truth| truth.hi.abs()).fold(0.0, f64::max);
        let e = error(&solution.end.state, &truths);
        let sens = row.input("sensitivity");
        eprintln!(
            "{:?} {time}: error {e:.3} size {size:.3} sens {sens} steps {} ratio {:.3}",
            case(row),
            solution.steps,
            e / (size + sens)
        );
        last = case(row);
        worst = e;
    }
    let _ = (last, worst);
}
