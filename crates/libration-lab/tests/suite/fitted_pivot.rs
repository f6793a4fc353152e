//! Positions of a bob with noise, whose pivot is fitted: what the angles about it owe to its place enters every answer.

use std::f64::consts::TAU;
use std::fmt::Write;
use std::ops::ControlFlow;

use libration_lab::fit::cycles::{self, Cycles};
use libration_lab::fit::trace::{DampingTerm, DampingTerms, TraceFit, TraceOptions, fit_traces};
use libration_lab::measurement::{Choices, FittedPivot, Options, Recording, Seen, Trace, TraceError};

use crate::random::Random;
use crate::synthetic_trace::Synthetic;

const DEGREE: f64 = TAU / 360.0;

/// Swings of a metre about (0.3, 1.4), 30 times a second, seen to so many metres.
fn positions(amplitude: f64, noise: f64, seed: u64) -> Trace {
    let mut random = Random::seeded(seed);
    let swing = Synthetic { amplitude, linear: 0.02, step: 1.0 / 30.0, rows: 360, ..Synthetic::USUAL };
    let angles = swing.trace(&mut random);
    let mut text = String::from("t (s),x (m),y (m)\n");
    for (time, angle) in angles.times().iter().zip(angles.values()) {
        let x = 0.3 + libm::sin(*angle) + noise * random.normal();
        let y = 1.4 - libm::cos(*angle) + noise * random.normal();
        writeln!(text, "{time},{x},{y}").unwrap();
    }
    let recording = Recording::read(text.as_bytes(), &Options::default()).unwrap();
    recording.traces(&Choices::default()).unwrap().traces.remove(0)
}

fn fitted(trace: &Trace) -> TraceFit {
    let linear = DampingTerms::only(DampingTerm::Linear);
    let options = TraceOptions::default();
    fit_traces(std::slice::from_ref(trace), linear, &options, &mut || ControlFlow::Continue(())).unwrap()
}

fn cycles_of(trace: &Trace) -> Cycles {
    cycles::cycles(trace, &cycles::Options::default()).unwrap()
}

/// Root mean squares of errors over their stated uncertainties: T0 and offset of the fit of the trace, then of its cycles.
fn pulls(amplitude: f64, seeds: u64) -> [f64; 4] {
    let mut squares = [0.0; 4];
    for seed in 0..seeds {
        let trace = positions(amplitude, 5e-4, seed);
        let (fit, cycles) = (fitted(&trace), cycles_of(&trace));
        let (t0, t0_uncertainty) = fit.small_angle_period();
        let offset = fit.parameter("offset").unwrap();
        let truth = Synthetic::USUAL.t0();
        let errors = [
            (t0 - truth) / t0_uncertainty,
            offset.value / offset.uncertainty,
            (cycles.t0 - truth) / cycles.t0_uncertainty,
            cycles.offset / cycles.offset_uncertainty,
        ];
        for (square, error) in squares.iter_mut().zip(errors) {
            *square += error * error;
        }
    }
    #[expect(clippy::cast_precision_loss, reason = "a few dozen")]
    let seeds = seeds as f64;
    squares.map(|square: f64| (square / seeds).sqrt())
}

/// The root mean square of 30 pulls is between 0.68 and 1.33 in 99 of 100 cases.
#[test]
fn errors_about_a_fitted_pivot_are_as_large_as_their_uncertainties() {
    for degrees in [10.0, 60.0] {
        let pulls = pulls(degrees * DEGREE, 30);
        assert!(pulls.iter().all(|pull| (0.68..1.33).contains(pull)), "{degrees}: {pulls:?}");
    }
}

/// About the true pivot the same noise leaves far less open than about a fitted one.
#[test]
fn a_fitted_pivot_makes_the_offset_uncertain() {
    let about_fitted = positions(10.0 * DEGREE, 5e-4, 1);
    let pivot = about_fitted.fitted_pivot().unwrap();
    let columns = [about_fitted.times(), about_fitted.values()].map(<[f64]>::to_vec);
    let [times, values] = columns;
    let about_known = Trace::new("known", Seen::Angle, times, values, None).unwrap();
    let of = |trace: &Trace| fitted(trace).parameter("offset").unwrap().uncertainty;
    // A metre below it an error of the pivot is the angle's.
    let by_pivot = pivot.covariance[0][0].sqrt();
    let expected = libm::hypot(of(&about_known), by_pivot);
    assert!((of(&about_fitted) / expected - 1.0).abs() < 0.02, "{expected:e} {:e}", of(&about_fitted));
    assert!(of(&about_fitted) > 1.5 * of(&about_known));
}

/// Two parts of one recording have one pivot, whose error does not become less by taking it twice.
#[test]
fn parts_about_one_pivot_share_its_error() {
    let whole = positions(10.0 * DEGREE, 5e-4, 2);
    let parts = [0, 1].map(|part| whole.only(|row| row / 180 == part).unwrap());
    let linear = DampingTerms::only(DampingTerm::Linear);
    let go_on = &mut || ControlFlow::Continue(());
    let together = fit_traces(&parts, linear, &TraceOptions::default(), go_on).unwrap();
    let offsets: Vec<usize> =
        (0..together.parameters.len()).filter(|&place| together.parameters[place].name == "offset").collect();
    let by_pivot = whole.fitted_pivot().unwrap().covariance[0][0].sqrt();
    for &place in &offsets {
        assert!(together.parameters[place].uncertainty > by_pivot);
    }
    let correlation = together.correlations[offsets[0]][offsets[1]];
    assert!((0.5..1.0).contains(&correlation), "{correlation}");
}

#[test]
fn a_pivot_goes_with_the_rows_of_its_trace() {
    let trace = positions(10.0 * DEGREE, 5e-4, 3);
    let every_third = trace.only(|row| row % 3 == 1).unwrap();
    let [whole, part] = [&trace, &every_third].map(|trace| trace.fitted_pivot().unwrap());
    assert_eq!(part.derivatives.len(), every_third.len());
    assert_eq!((part.derivatives[5], part.place), (whole.derivatives[16], whole.place));
    assert_eq!(trace.clone().named("other").fitted_pivot(), Some(whole));
    let too_short = FittedPivot { derivatives: vec![], ..whole.clone() };
    assert_eq!(trace.clone().with_fitted_pivot(too_short), Err(TraceError::Lengths(vec![trace.len(), 0])));
}
