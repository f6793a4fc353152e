//! The advice.

use libration_lab::fit::DampingKind;
use libration_lab::fit::swings::{Advice, EndOfTrace, SwingsOptions};
use libration_lab::fit::trace::TraceFit;
use libration_lab::measurement::Observable;

use super::{SWING, advice, analysis, changed, linear, of_length, trace, with_free_scale};
use crate::random::Random;
use crate::synthetic_trace::Synthetic;

fn has(advice: &[Advice], name: &str) -> bool {
    advice.iter().any(|one| one.name() == name)
}

/// T0 is known to about 2e-4, so that a length known to about 4e-4 contributes half of the variance of gravity.
#[test]
fn the_length_is_to_be_given_with_an_uncertainty_and_to_be_measured_better_where_it_decides() {
    assert_eq!(advice(&SWING, &linear())[0], Advice::GiveLength);
    assert_eq!(advice(&SWING, &of_length(1.09, None))[0], Advice::GiveLengthUncertainty);
    let rough = advice(&SWING, &of_length(1.09, Some(0.0109)));
    let Advice::MeasureLengthBetter { relative_uncertainty, share } = rough[0] else { panic!("{rough:?}") };
    assert!((0.49..=1.0).contains(&share), "{share}");
    assert!((relative_uncertainty - 0.01).abs() < 1e-12);
    assert!(rough[0].to_string().contains("The length is known to 1.0 %"), "{}", rough[0]);
    assert_eq!(advice(&SWING, &of_length(1.09, Some(1e-6))), []);
}

/// Relative uncertainties of the length at which it has just more, and just less, than half of the variance of gravity.
#[test]
fn half_of_the_variance_decides() {
    let relative_of_period =
        { 2.0 * analysis(&[trace(&SWING)], &linear()).fit.small_angle_period().relative() };
    // u(l)/l = 0.7·u(g)/g where u(l)/l is 0.7/√0.51 of the rest, if the period has all of it.
    let at_the_edge = 0.7 / 0.51_f64.sqrt() * relative_of_period;
    let told = |part: f64| has(&advice(&SWING, &of_length(1.09, Some(1.09 * part))), "measure_length_better");
    assert!(told(1.2 * at_the_edge) && !told(0.8 * at_the_edge));
}

#[test]
fn a_scale_is_to_be_checked_where_beta_is_in_doubt() {
    let quiet = Synthetic { noise: 3e-4, ..SWING };
    let scaled = |swing: &Synthetic, scale: f64, options| {
        analysis(&[changed(&trace(swing), |_, time, value| (time, scale * value))], &options).advice
    };
    let told = scaled(&quiet, 1.1, linear());
    assert!(told.contains(&Advice::CheckScale { observable: Observable::Angle }), "{told:?}");
    assert!(!has(&scaled(&quiet, 1.0, linear()), "check_scale"));
    assert!(!has(&scaled(&quiet, 1.1, with_free_scale()), "check_scale"));
    let gyroscope = Synthetic { observable: Observable::AngularVelocity, noise: 1e-3, ..SWING };
    let told = scaled(&gyroscope, 1.1, linear());
    assert!(told.contains(&Advice::CheckScale { observable: Observable::AngularVelocity }), "{told:?}");
}

/// From 0.3 rad 1 % of the angles is 2(R − 1)·1 % of T0, 1e-4, twenty of its uncertainties, and β is known to several per cent; from 60° β tells the scale.
#[test]
fn a_scale_that_neither_is_stated_nor_tested_is_to_be_stated() {
    let small = Synthetic { amplitude: 0.3, noise: 3e-4, ..SWING };
    let told = advice(&small, &linear());
    let Some(Advice::StateScale { slope, of_beta }) = told.iter().find(|one| one.name() == "state_scale")
    else {
        panic!("{told:?}")
    };
    assert!((0.008..0.012).contains(slope) && (0.02..0.4).contains(of_beta), "{slope} {of_beta}");
    let stated = SwingsOptions { angle_scale: Some(0.01), ..linear() };
    assert!(!has(&advice(&small, &stated), "state_scale"));
    assert!(!has(&advice(&Synthetic { noise: 3e-4, ..SWING }, &linear()), "state_scale"));
    // Where noise hides what a scale does.
    assert!(!has(&advice(&Synthetic { noise: 0.03, ..small }, &linear()), "state_scale"));
}

#[test]
fn damping_that_is_left_open_wants_a_longer_recording() {
    let short = Synthetic { rows: 125, ..SWING };
    let told = advice(&short, &SwingsOptions::default());
    let Some(Advice::RecordLonger { amplitudes: [largest, smallest] }) =
        told.iter().find(|one| one.name() == "record_longer")
    else {
        panic!("{told:?}")
    };
    assert!((0.95..1.06).contains(largest) && (0.9..*largest).contains(smallest));
    assert!(!has(&advice(&short, &linear()), "record_longer"));
}

#[test]
fn residuals_with_a_pattern_are_to_be_looked_at() {
    let told = |size: f64| {
        let ripple = |_: usize, time: f64, angle: f64| (time, size.mul_add(libm::sin(1.1 * time), angle));
        has(&analysis(&[changed(&trace(&SWING), ripple)], &linear()).advice, "look_at_residuals")
    };
    assert!(told(0.01) && !told(0.0002));
}

/// Two rows that were held are outliers like any others; three are an end.
#[test]
fn outliers_at_an_end_are_to_be_left_out_and_others_to_be_corrected() {
    let held = |rows: usize| {
        let swing = trace(&SWING);
        let last = swing.len() - rows;
        let value = |row: usize, time: f64, angle: f64| (time, if row >= last { angle + 0.3 } else { angle });
        (swing.times()[last - 1], analysis(&[changed(&swing, value)], &linear()).advice)
    };
    let (time, told) = held(3);
    let end = EndOfTrace::After { trace: "synthetic".to_owned(), time };
    let text = Advice::LeaveOutEnds { ends: vec![end] };
    assert!(told.contains(&text), "{told:?}");
    assert!(text.to_string().contains("of synthetic after 13.85 s"), "{text}");
    let (_, told) = held(2);
    assert!(told.contains(&Advice::CorrectOutliers), "{told:?}");
    let (_, told) = held(0);
    assert!(!has(&told, "correct_outliers") && !has(&told, "leave_out_ends"));
}

#[test]
fn rows_at_the_beginning_are_an_end_too() {
    let held = |row: usize, time: f64, angle: f64| (time, if row < 4 { angle + 0.3 } else { angle });
    let swing = trace(&SWING);
    let told = analysis(&[changed(&swing, held)], &linear()).advice;
    let end = EndOfTrace::Before { trace: "synthetic".to_owned(), time: swing.times()[4] };
    assert!(told.contains(&Advice::LeaveOutEnds { ends: vec![end] }), "{told:?}");
}

/// At 3 rad/s a hundredth of a second is three hundredths of a radian, and a thousandth of a second as much as the noise.
#[test]
fn rounded_times_are_to_be_written_with_more_digits() {
    let told = |step: f64| {
        let rounded = |_: usize, time: f64, angle: f64| (step * libm::round(time / step), angle);
        // Rows that no step of the rounding divides.
        let swing = Synthetic { step: 0.0371, ..SWING };
        analysis(&[changed(&trace(&swing), rounded)], &linear()).advice
    };
    let coarse = told(0.01);
    let Some(Advice::WriteMoreDigitsOfTimes { resolution, part }) =
        coarse.iter().find(|one| one.name() == "write_more_digits_of_times")
    else {
        panic!("{coarse:?}")
    };
    assert!((resolution - 0.01).abs() < 1e-12 && (0.5..=1.0).contains(part), "{part}");
    assert!(!has(&told(0.001), "write_more_digits_of_times"));
}

#[test]
fn a_zero_off_by_more_than_a_hundredth_is_told() {
    let told = |offset: f64| has(&advice(&Synthetic { offset, ..SWING }, &linear()), "set_zero");
    assert!(told(0.011) && told(-0.011) && !told(0.009));
    // Of a motion that is not that of the pendulum it says nothing, and a gyroscope has no plumb line.
    let noisy = Synthetic { offset: 0.1, noise: 0.1, ..SWING };
    assert!(!has(&advice(&noisy, &linear()), "set_zero"));
    let gyroscope = Synthetic { observable: Observable::AngularVelocity, offset: 0.1, ..SWING };
    assert!(!has(&advice(&gyroscope, &linear()), "set_zero"));
}

#[test]
fn fewer_than_fifteen_rows_in_a_period_are_few() {
    let told = |rows_per_period: f64| {
        let step = SWING.t0() / rows_per_period;
        has(&advice(&Synthetic { step, rows: 130, ..SWING }, &linear()), "sample_faster")
    };
    assert!(told(14.5) && !told(15.5));
}

/// A rival model with one additional kind of damping, whose coefficient is zero, contradicts nothing; and a decay to a quarter needs no longer
/// record.
#[test]
fn a_rival_that_adds_nothing_is_none_and_a_long_decay_is_long_enough() {
    for seed in 1..4 {
        let swing = Synthetic { rows: 800, linear: 0.1, ..SWING };
        let fit = analysis(&[swing.trace(&mut Random::seeded(seed))], &SwingsOptions::default());
        let preferred = fit.fit.damping;
        for rival in fit.rivals() {
            let of = |fits: &[TraceFit]| fits.iter().find(|fit| fit.damping == rival).cloned().unwrap();
            let rival = of(&fit.comparison.as_ref().unwrap().fits);
            let contains = preferred.iter().all(|term| rival.damping_coefficient(term).is_some());
            let mut added = rival.damping.iter().filter(|term| fit.fit.damping_coefficient(*term).is_none());
            let is_zero = |term: DampingKind| {
                rival.damping_coefficient(term).unwrap().estimate.deviation_from(0.0) <= 2.0
            };
            assert!(!contains || !added.all(is_zero), "{seed}: {:?}", rival.damping);
        }
    }
    let far = Advice::RecordLonger { amplitudes: [0.7, 0.01] }.to_string();
    assert!(!far.contains("record for longer"), "{far}");
    let near = Advice::RecordLonger { amplitudes: [0.7, 0.3] }.to_string();
    assert!(near.contains("record for longer"), "{near}");
}
