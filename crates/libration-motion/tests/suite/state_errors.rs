//! The errors that are stated of states and events, beside those that they have.

use libration::taylor::{Effort, Moment, Start, StateErrors, System, integrate_from};
use libration_testing::golden::{Row, Table};
use libration_testing::sweep;
use std::ops::ControlFlow;

/// Of one sample: by how much each number is off, and by how much it may be.
type Compared = Vec<[f64; 2]>;

struct Run<'a> {
    name: &'a str,
    rows: Vec<Row<'a>>,
}

impl Run<'_> {
    fn numbers(row: Row<'_>, column: &str) -> Vec<f64> {
        row.text(column).split(' ').map(|number| number.parse().unwrap()).collect()
    }

    /// The samples as far as they are determined, and when that ends.
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
                    let off = moment.state.iter().zip(&truth).map(|(found, truth)| (found - truth).abs());
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

/// Chaotic and regular motions, some to their last digit: no sample is off by more than is stated, and that is not far too much.
#[test]
fn sweep_every_sample_is_inside_its_error() {
    let table = Table::read("state_errors.csv");
    let mut medians = vec![];
    for run in sweep::part(runs(&table), 6) {
        let (compared, until) = run.compared();
        assert!(!compared.is_empty(), "{}: determined until {until:?}", run.name);
        let mut ratios = vec![];
        for (place, sample) in compared.iter().enumerate() {
            for [off, stated] in sample {
                assert!(off <= stated, "{} sample {place}: {off:e} {stated:e}", run.name);
                ratios.extend((*off > 0.0).then(|| stated / off));
            }
        }
        let largest = ratios.iter().copied().fold(0.0, f64::max);
        let median = median(ratios);
        eprintln!("{}: {} samples, until {until:?}, median {median:.0}, largest {largest:.0}", run.name, compared.len());
        medians.push(median);
    }
    let all = median(medians);
    eprintln!("median of all {all:.0}");
    assert!(all < 1000.0, "{all}");
}

#[test]
fn zz_timing() {
    for (equation, start, last) in [
        ("theta'' = -sin(theta)", vec![2.0, 0.0], 20000.0),
        ("theta1'' = (-3*sin(theta1) - sin(theta1 - 2*theta2) - 2*sin(theta1 - theta2)*(theta2'^2 + theta1'^2*cos(theta1 - theta2)))/(3 - cos(2*theta1 - 2*theta2)); theta2'' = 2*sin(theta1 - theta2)*(2*theta1'^2 + 2*cos(theta1) + theta2'^2*cos(theta1 - theta2))/(3 - cos(2*theta1 - 2*theta2))", vec![0.5, 0.25, 0.0, 0.0], 5000.0),
        ("x'' = -x - 2*x*y; y'' = -y - x^2 + y^2", vec![0.0, 0.1, 0.375, 0.0], 10000.0),
        ("x'' = y - 2*x - x^3; y'' = x - 2*y + z - y^3; z'' = y - 2*z - z^3", vec![0.5, -0.25, 0.25, 0.0, 0.0, 0.0], 5000.0),
        ("x' = 10*(y - x); y' = x*(14 - z) - y; z' = x*y - 8/3*z", vec![1.0, 1.0, 1.0], 2000.0),
        ("x'' = -x - max(x, 0)*10", vec![1.0, 0.0], 5000.0),
        ("x'' = -x - sign(x')*0.0001 + cos(0.3*t)", vec![1.0, 0.0], 5000.0),
    ] {
        let system = System::new(&equation.parse().unwrap()).unwrap();
        let start = Moment { time: 0.0, state: start };
        let effort = Effort::to_tolerance(1e-12);
        let mut times = [vec![], vec![]];
        let mut steps = 0;
        let mut until = None;
        for _ in 0..7 {
            let clock = std::time::Instant::now();
            let solution = integrate_from(&system, &Start::State(start.clone()), &[last], &effort, |_| ControlFlow::Continue(())).unwrap();
            times[0].push(clock.elapsed().as_secs_f64());
            let clock = std::time::Instant::now();
            let mut errors = StateErrors::new(&system, &start, &effort);
            let _ = integrate_from(&system, &Start::State(start.clone()), &[last], &effort, |accepted| {
                errors.follow(accepted);
                ControlFlow::Continue(())
            });
            times[1].push(clock.elapsed().as_secs_f64());
            steps = solution.steps;
            until = errors.determined_until();
        }
        let [a, b] = times.map(median);
        eprintln!("{:.30}: {steps} steps, {:.2} us, with errors {:.2} us: {:.2} ({until:?})", equation, a / steps as f64 * 1e6, b / steps as f64 * 1e6, b / a);
    }
}
