//! Warnings and advice about swings: each with data that cause it, and with data that just do not.

mod advice;
mod contradiction;
mod not_separated;
mod warnings;

use std::cell::Cell;
use std::ops::ControlFlow;

use libration::progress::Quiet;
use libration::quantity::Quantity;
use libration_lab::fit::Apparatus;
use libration_lab::fit::swings::{Advice, SwingsError, SwingsFit, SwingsOptions, Warning, fit_swings};
use libration_lab::fit::trace::{TraceFitError, TraceOptions};
use libration_lab::measurement::{Observable, Trace};

use crate::random::Random;
use crate::synthetic_trace::Synthetic;

/// 60° falling to 52° in seven periods, 25 rows a second, seen to 3 mrad.
const SWING: Synthetic = Synthetic { step: 0.04, rows: 350, noise: 0.003, ..Synthetic::USUAL };

fn trace(swing: &Synthetic) -> Trace {
    swing.trace(&mut Random::seeded(1))
}

/// The trace with other times and values, row by row.
fn changed(trace: &Trace, change: impl Fn(usize, f64, f64) -> (f64, f64)) -> Trace {
    let rows = trace.times().iter().zip(trace.values()).enumerate();
    let (times, values) = rows.map(|(row, (time, value))| change(row, *time, *value)).unzip();
    Trace::new(trace.name(), trace.observable(), times, values, None).unwrap()
}

fn linear() -> SwingsOptions<'static> {
    SwingsOptions { damping: Some("linear".parse().unwrap()), ..SwingsOptions::default() }
}

fn with_free_scale() -> SwingsOptions<'static> {
    SwingsOptions { trace: TraceOptions { free_scale: true, ..TraceOptions::default() }, ..linear() }
}

/// Options with a length: l = g/ω0² is 1.09 m for 9.81 m/s² and 3 rad/s.
fn of_length(length: f64, uncertainty: Option<f64>) -> SwingsOptions<'static> {
    let apparatus = Apparatus::of_length(Quantity { value: length, uncertainty });
    SwingsOptions { apparatus: Some(apparatus), ..linear() }
}

/// The result, whose texts name no option of a command.
fn analysis(traces: &[Trace], options: &SwingsOptions<'_>) -> SwingsFit {
    let fit = fit_swings(traces, options, &Quiet).unwrap();
    let words = fit.warnings.iter().map(ToString::to_string);
    for text in words.chain(fit.advice.iter().map(ToString::to_string)) {
        assert!(!text.contains("--"), "{text}");
    }
    fit
}

fn warnings(swing: &Synthetic, options: &SwingsOptions<'_>) -> Vec<Warning> {
    analysis(&[trace(swing)], options).warnings
}

fn advice(swing: &Synthetic, options: &SwingsOptions<'_>) -> Vec<Advice> {
    analysis(&[trace(swing)], options).advice
}

/// The warning of this name.
fn named<'a>(warnings: &'a [Warning], name: &str) -> Option<&'a Warning> {
    warnings.iter().find(|warning| warning.name() == name)
}

#[test]
fn a_good_measurement_is_not_doubted_and_wants_nothing_but_a_length() {
    let fit = analysis(&[trace(&SWING)], &linear());
    assert_eq!(fit.warnings, []);
    assert_eq!(fit.advice, [Advice::GiveLength]);
    assert_eq!(fit.advice[0].name(), "give_length");
}

/// Observable as angular velocities, from 3·2 sin 30° rad/s on.
#[test]
fn angular_velocities_are_judged_alike() {
    let observable = Synthetic { observable: Observable::AngularVelocity, ..SWING };
    assert_eq!(warnings(&observable, &linear()), []);
}

#[test]
fn swings_stop_at_any_question() {
    let traces = [trace(&SWING)];
    let stopped_at = |n: usize| {
        let questions = Cell::new(0);
        let ask = |_| {
            questions.set(questions.get() + 1);
            if questions.get() == n { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        (fit_swings(&traces, &linear(), &ask), questions.get())
    };
    let (whole, questions) = stopped_at(usize::MAX);
    assert!(whole.is_ok() && questions > 3);
    // The last one is before the cycles.
    for n in [1, 2, questions / 2, questions - 1, questions] {
        let (outcome, asked) = stopped_at(n);
        let is_interrupted = matches!(outcome, Err(SwingsError::Motion(TraceFitError::Interrupted)));
        assert!(is_interrupted && asked == n, "question {n} of {questions}: {asked}");
    }
}
