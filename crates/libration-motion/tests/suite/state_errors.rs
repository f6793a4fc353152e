//! The errors that are stated of states and events, beside those that they have.

use crate::endings::{KNOWN, Known, TOLERANCES};
use libration::pendulum::Pendulum;
use libration::quantity::Angle;
use libration::taylor::{
    Effort, Event, Moment, Occurrence, Start, StateErrors, System, integrate_both_ways, integrate_from,
};
use libration_testing::golden::{Row, Table};
use libration_testing::sweep;
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

/// The states and errors at the ends of all steps until the last that is determined.
fn determined(
    system: &System,
    start: &Moment,
    last: f64,
    tolerance: f64,
) -> (Vec<(Moment, Vec<f64>)>, StateErrors) {
    let effort = Effort::to_tolerance(tolerance);
    let mut errors = StateErrors::new(system, start, &effort);
    let mut found = vec![];
    integrate_from(system, &Start::State(start.clone()), &[last], &effort, |accepted| {
        errors.follow(accepted);
        let time = accepted.step().end();
        let moment = Moment { time, state: accepted.step().state_at(time) };
        found.extend(errors.at(&moment).map(|error| (moment, error)));
        ControlFlow::Continue(())
    })
    .unwrap();
    (found, errors)
}

/// Terms that cancel, constants that are no doubles, forces that jump and bend; forward and backward.
#[test]
fn errors_of_motions_in_closed_form_hold() {
    for Known { equation, start, state } in KNOWN {
        let system = System::new(&equation.parse().unwrap()).unwrap();
        let start = system.start(start).unwrap();
        for tolerance in TOLERANCES {
            let (found, errors) = determined(&system, &start, 50.0, tolerance);
            let until = errors.determined_until();
            assert!(until.is_none() || equation == "x'' = x", "{equation}: {until:?}");
            for (Moment { time, state: found }, stated) in found {
                for ((found, truth), stated) in found.iter().zip(state(time)).zip(stated) {
                    // What the closed form itself rounds.
                    let off = (found - truth).abs() - 1e-15 * found.abs().max(1.0);
                    assert!(off <= stated, "{equation} {time} {tolerance:e}: {off:e} {stated:e}");
                }
            }
        }
    }
}

/// From next to the top, where the error is soon as large as the angle: as far as it is stated, it holds.
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
            let (found, errors) = determined(&system, &start, 200.0, tolerance);
            let until = errors.determined_until().unwrap_or(200.0);
            assert!(tolerance > 1e-12 || until >= least, "{amplitude} {tolerance:e}: {until}");
            for (Moment { time, state }, stated) in found {
                let there = exact.state_at(time);
                for (found, truth, stated) in
                    [(state[0], there.angle, stated[0]), (state[1], there.velocity, stated[1])]
                {
                    let off = (found - truth).abs();
                    assert!(off <= stated, "{amplitude} {time} {tolerance:e}: {off:e} {stated:e}");
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
        let effort = Effort::to_tolerance(tolerance);
        let mut errors = StateErrors::new(&system, &start, &effort);
        let mut found: Vec<(Occurrence, Moment)> = vec![];
        integrate_from(&system, &Start::State(start.clone()), &[100.0], &effort, |accepted| {
            errors.follow(accepted);
            for event in accepted.events() {
                found.push((event.clone(), errors.of_event(accepted, event).unwrap()));
            }
            ControlFlow::Continue(())
        })
        .unwrap();
        assert!(found.len() > 30);
        for (Occurrence { event, time, state, contact }, error) in found {
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

/// A motion that is the same before and after its start has the same errors there, and the start has none.
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

/// The effect of half a unit in the last place of the start on a motion that grows as the exponential of the time.
#[test]
fn the_effect_of_the_start_is_told() {
    let system = System::new(&"x' = x".parse().unwrap()).unwrap();
    let start = system.start(&[("x", 1.0)]).unwrap();
    let (_, errors) = determined(&system, &start, 20.0, 1e-12);
    let effect = errors.effect_of_start();
    let expected = 0.5 * f64::EPSILON * libm::exp(20.0);
    assert!((effect.state[0] - expected).abs() < 1e-3 * expected && effect.time == 20.0, "{effect:?}");
}
