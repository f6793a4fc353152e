//! Swings whose times are rounded to three significant digits, as in a table on a screen: T0 is right within its uncertainty.

use crate::random::Random;
use libration::pendulum::Pendulum;
use libration::progress::Quiet;
use libration_lab::fit::Uncertain;
use libration_lab::fit::trace::{DampingModel, TraceFit, TraceOptions, fit_traces};
use libration_lab::measurement::{Choices, ReadOptions, Recording, Trace};
use std::f64::consts::TAU;

const OMEGA0: f64 = 4.2;

/// 55 s of a swing of 40° with noise of 0.2°, filmed at this rate, with the beginning this long before the first frame.
fn trace(rate: f64, begin: f64) -> Trace {
    let motion =
        Pendulum::from_angular_frequency(OMEGA0).unwrap().released_from("40deg".parse().unwrap()).unwrap();
    let mut random = Random::seeded(30);
    let mut row = |row: u32| {
        let time = begin + f64::from(row) / rate;
        let shown = format!("{time:.2e}").parse::<f64>().unwrap();
        format!("{shown},{:.5}\n", motion.state_at(time).angle + 0.0035 * random.normal())
    };
    let rows = (0..).take_while(|&row| f64::from(row) / rate < 55.2);
    let file = format!("t (s),theta (rad)\n{}", rows.map(&mut row).collect::<String>());
    let recording = Recording::read(file.as_bytes(), &ReadOptions::default()).unwrap();
    recording.traces(&Choices::default()).unwrap().traces.remove(0)
}

fn fitted(trace: Trace) -> TraceFit {
    let options = TraceOptions::default();
    fit_traces(&[trace], DampingModel::UNDAMPED, &options, &Quiet).unwrap()
}

#[test]
fn three_significant_digits_cost_no_row_and_no_truth() {
    for (rate, begin) in [(30.0, 0.0), (25.0, 0.0123)] {
        let trace = trace(rate, begin);
        assert_eq!(trace.len(), if rate > 29.0 { 1656 } else { 1380 });
        let Uncertain { value: period, uncertainty } = fitted(trace).small_angle_period();
        let error = (period - TAU / OMEGA0).abs();
        assert!(error < 2.0 * uncertainty, "{rate}: off by {error:e}, stated {uncertainty:e}");
        // The times leave the interval open by up to 2e-4 of it, of which the uncertainty is a third or less.
        assert!(uncertainty < 2e-4, "{rate}: {uncertainty:e}");
    }
}
