//! The warnings.

use libration_lab::fit::BudgetWarning;
use libration_lab::fit::DampingKind;
use libration_lab::fit::cycles::{CyclesError, CyclesWarning};
use libration_lab::fit::swings::{SwingsOptions, Warning};
use libration_lab::measurement::Trace;

use super::{SWING, analysis, changed, linear, named, of_length, trace, warnings, with_free_scale};
use crate::synthetic_trace::Synthetic;

/// At 3° no error distinguishes an angle that is read too small from a small one.
#[test]
fn a_search_without_an_end_is_told() {
    let narrow = Synthetic { amplitude: 0.05, rows: 120, noise: 5e-4, ..SWING };
    assert!(warnings(&narrow, &with_free_scale()).contains(&Warning::NotConverged));
    assert!(!warnings(&narrow, &linear()).contains(&Warning::NotConverged));
}

#[test]
fn radians_called_degrees_are_told_first() {
    let quiet = Synthetic { noise: 3e-4, ..SWING };
    let called = changed(&trace(&quiet), |_, time, angle| (time, angle.to_radians()));
    let said = analysis(&[called], &linear()).warnings;
    let Warning::AnglesAreRadians { beta } = said[0] else { panic!("{said:?}") };
    // 3283 of small angles; R − 1 grows faster than the square.
    assert!((3283.0..4000.0).contains(&beta), "{beta}");
    assert!(named(&said, "beta_not_one").is_none(), "{said:?}");
    assert!(named(&warnings(&quiet, &linear()), "angles_are_radians").is_none());
}

#[test]
fn a_length_that_contradicts_gravity_is_told_and_one_without_an_uncertainty() {
    let said = |length: f64, uncertainty| warnings(&SWING, &of_length(length, uncertainty));
    let wrong = said(1.2, Some(0.001));
    let Some(Warning::Budget(BudgetWarning::GravityContradicted { likely_length, .. })) =
        named(&wrong, "gravity_contradicted")
    else {
        panic!("{wrong:?}")
    };
    assert!((likely_length - 1.0888).abs() < 0.002, "{likely_length}");
    assert_eq!(said(1.09, Some(0.001)), []);
    assert!(named(&said(1.09, None), "budget").is_some());
}

/// A swing of 0.65 rad as a root mean square.
#[test]
fn residuals_above_a_tenth_of_the_swing_are_a_poor_fit() {
    let part = |noise: f64| match named(&warnings(&Synthetic { noise, ..SWING }, &linear()), "poor_fit") {
        Some(Warning::PoorFit { part }) => Some(*part),
        _ => None,
    };
    let poor = part(0.08).unwrap();
    assert!((0.1..0.15).contains(&poor), "{poor}");
    assert_eq!(part(0.055), None);
}

#[test]
fn drag_that_pushes_is_told() {
    let growing = Synthetic { linear: -0.02, amplitude: 0.7, ..SWING };
    let said = warnings(&growing, &linear());
    assert!(matches!(named(&said, "feeds_energy"), Some(Warning::FeedsEnergy { .. })), "{said:?}");
    let Some(Warning::NegativeDamping { coefficients }) = named(&said, "negative_damping") else {
        panic!("{said:?}")
    };
    assert_eq!(coefficients[0].term, DampingKind::Linear);
    assert!((coefficients[0].estimate.value + 0.02).abs() < 4.0 * coefficients[0].estimate.uncertainty);
    let steady = warnings(&Synthetic { linear: 0.0, ..growing }, &linear());
    assert!(named(&steady, "feeds_energy").is_none() && named(&steady, "negative_damping").is_none());
}

/// A force that pushes at high speed and brakes at low speed is described by a negative coefficient alone.
#[test]
fn a_better_model_with_a_negative_coefficient_is_not_believed() {
    let slippery = Synthetic { dry: 0.05, linear: 0.0, quadratic: -0.03, noise: 0.006, ..SWING };
    let said = warnings(&slippery, &SwingsOptions::default());
    let Some(Warning::BetterModelNotBelieved { excess, negative, .. }) =
        named(&said, "better_model_not_believed")
    else {
        panic!("{said:?}")
    };
    assert!(*excess > 2.0 && negative.is_some(), "{excess}");
    let plain = warnings(&SWING, &SwingsOptions::default());
    assert!(named(&plain, "better_model_not_believed").is_none(), "{plain:?}");
}

#[test]
fn kinds_of_damping_that_a_short_swing_leaves_are_listed() {
    let short = Synthetic { rows: 125, ..SWING };
    let said = analysis(&[trace(&short)], &SwingsOptions::default());
    let Some(Warning::DampingNotSeparated { preferred, rivals }) =
        named(&said.warnings, "damping_not_separated")
    else {
        panic!("{:?}", said.warnings)
    };
    assert_eq!((*preferred, rivals.clone()), (said.fit.damping, said.rivals()));
    assert!(!rivals.is_empty());
    assert!(named(&warnings(&short, &linear()), "damping_not_separated").is_none());
}

#[test]
fn a_pattern_in_the_residuals_is_no_noise() {
    let with_ripple = |size: f64| {
        let ripple = |_: usize, time: f64, angle: f64| (time, size.mul_add(libm::sin(1.1 * time), angle));
        analysis(&[changed(&trace(&SWING), ripple)], &linear()).warnings
    };
    let Some(Warning::ResidualsNotNoise { rows, .. }) =
        named(&with_ripple(0.01), "residuals_not_noise").cloned()
    else {
        panic!("a ripple of three times the noise")
    };
    assert!(rows > 5.0, "{rows}");
    assert!(named(&with_ripple(0.0002), "residuals_not_noise").is_none());
}

/// The scatter is known to 4 %.
#[test]
fn stated_uncertainties_are_compared_with_the_scatter() {
    let stated = |ratio: f64| {
        let swing = trace(&SWING);
        let uncertainties = vec![SWING.noise / ratio; swing.len()];
        let columns = [swing.times(), swing.values()].map(<[f64]>::to_vec);
        let [times, values] = columns;
        let stated = Trace::new("stated", swing.observable(), times, values, Some(uncertainties)).unwrap();
        named(&analysis(&[stated], &linear()).warnings, "stated_uncertainties").map(ToString::to_string)
    };
    assert!(stated(1.65).unwrap().contains("too small"));
    assert!(stated(0.6).unwrap().contains("too large"));
    assert_eq!([1.35, 1.0, 0.75].map(stated), [None, None, None]);
}

#[test]
fn strong_damping_takes_the_place_of_what_beta_would_say() {
    let damped = |linear: f64, scale: f64| {
        let swing = trace(&Synthetic { linear, amplitude: 2.1, rows: 300, noise: 2e-4, ..SWING });
        analysis(&[changed(&swing, |_, time, angle| (time, scale * angle))], &super::linear()).warnings
    };
    let strong = damped(0.5, 1.1);
    let Some(Warning::StrongDamping { fall }) = named(&strong, "strong_damping") else {
        panic!("{strong:?}")
    };
    assert!((0.3..0.6).contains(fall), "{fall}");
    for name in ["beta_not_one", "periods_disagree"] {
        assert!(named(&strong, name).is_none(), "{strong:?}");
    }
    // What the damping does to the cycles is removed.
    assert!(named(&damped(0.5, 1.0), "strong_damping").is_none());
    // exp(−0.06·2.5/2) in a cycle of 2.5 s.
    assert!(named(&damped(0.06, 1.1), "strong_damping").is_none());
}

#[test]
fn a_beta_that_is_not_one_points_to_the_scale_where_that_can_be() {
    let scaled = |scale: f64, options| {
        let quiet = Synthetic { noise: 3e-4, ..SWING };
        analysis(&[changed(&trace(&quiet), |_, time, angle| (time, scale * angle))], &options).warnings
    };
    let Some(Warning::BetaNotOne { scale_error: Some(part), deviation, .. }) =
        named(&scaled(1.1, linear()), "beta_not_one").cloned()
    else {
        panic!("a tenth too large")
    };
    assert!((part + 0.09).abs() < 0.02 && deviation > 3.0, "{part} {deviation}");
    assert!(named(&scaled(1.1, linear()), "beta_not_one").unwrap().to_string().contains("too large"));
    assert!(named(&scaled(1.1, with_free_scale()), "beta_not_one").is_none());
    assert!(named(&scaled(1.0, linear()), "beta_not_one").is_none());
}

/// A clock that runs ever faster makes the period fall with the amplitude, at small amplitudes far more than the exact law does.
#[test]
fn no_scale_explains_a_period_that_changes_in_time() {
    let small = Synthetic { amplitude: 0.3, linear: 0.06, noise: 1e-4, ..SWING };
    let drifting = changed(&trace(&small), |_, time, angle| (time - 5e-4 * time * time, angle));
    let said = analysis(&[drifting], &linear()).warnings;
    let Some(doubt @ Warning::BetaNotOne { scale_error: None, .. }) = named(&said, "beta_not_one") else {
        panic!("{said:?}")
    };
    assert!(doubt.to_string().contains("A scale of the angles is not wrong by that much"));
}

/// A clock that stopped for a moment moves the phase of the whole motion, and only one cycle.
#[test]
fn a_motion_that_disagrees_with_its_cycles_is_told() {
    let stopped = |pause: f64| {
        let late = |row: usize, time: f64, angle: f64| (if row < 175 { time } else { time + pause }, angle);
        analysis(&[changed(&trace(&Synthetic { noise: 1e-3, ..SWING }), late)], &linear()).warnings
    };
    let said = stopped(0.02);
    let Some(Warning::PeriodsDisagree { by_cycles, by_motion, deviation }) = named(&said, "periods_disagree")
    else {
        panic!("{said:?}")
    };
    assert!((by_cycles / SWING.t0() - 1.0).abs() < 3e-4, "{by_cycles}");
    assert!((by_motion / SWING.t0() - 1.0).abs() > 1e-3 && *deviation > 3.0, "{by_motion} {deviation}");
    assert!(named(&stopped(0.0), "periods_disagree").is_none());
}

#[test]
fn two_pendulums_are_told_apart_beyond_a_hundredth() {
    let with = |omega0: f64| {
        let other = trace(&Synthetic { omega0, amplitude: 0.7, ..SWING }).named("other");
        analysis(&[trace(&SWING).named("one"), other], &linear()).warnings
    };
    let said = with(2.95);
    let Some(Warning::DifferentPendulums { shortest, longest }) = named(&said, "different_pendulums") else {
        panic!("{said:?}")
    };
    assert_eq!((shortest.0.as_str(), longest.0.as_str()), ("one", "other"));
    assert!((longest.1 / shortest.1 - 3.0 / 2.95).abs() < 2e-3);
    assert!(named(&with(2.98), "different_pendulums").is_none());
}

/// 9.80665/31.4² = 9.946 mm, and 10.2 mm at 31 rad/s.
#[test]
fn a_length_that_no_pendulum_has_is_told() {
    let said = |omega0: f64| {
        let faster = |_: usize, time: f64, angle: f64| (3.0 / omega0 * time, angle);
        analysis(&[changed(&trace(&SWING), faster)], &linear()).warnings
    };
    let Some(Warning::ImplausibleLength { length }) = named(&said(31.4), "implausible_length").cloned()
    else {
        panic!("below a centimetre")
    };
    assert!((length - 9.946e-3).abs() < 1e-5, "{length}");
    assert!(named(&said(31.0), "implausible_length").is_none());
    // 109 and 98 m.
    assert!(named(&said(0.3), "implausible_length").is_some());
    assert!(named(&said(0.3164), "implausible_length").is_none());
}

#[test]
fn rows_far_from_the_motion_are_counted() {
    let said = |beyond: f64| {
        let stray =
            |row: usize, time: f64, angle: f64| (time, if row == 200 { angle + beyond } else { angle });
        let warnings = analysis(&[changed(&trace(&SWING), stray)], &linear()).warnings;
        named(&warnings, "outliers").map(ToString::to_string)
    };
    assert!(said(0.05).unwrap().starts_with("1 row is an outlier"));
    assert_eq!(said(2.0 * SWING.noise), None);
}

#[test]
fn what_cycles_say_bears_the_name_of_the_trace_where_there_are_several() {
    let whole = trace(&SWING);
    let gap = whole.only(|row| !(150..200).contains(&row)).unwrap().named("gap");
    let short = trace(&Synthetic { step: 0.01, rows: 190, ..SWING }).named("short");
    let alone = analysis(std::slice::from_ref(&gap), &linear()).warnings;
    assert!(
        matches!(
            named(&alone, "cycles"),
            Some(Warning::Cycles { trace: None, warning: CyclesWarning::Incomplete { .. } })
        ),
        "{alone:?}"
    );
    let together = analysis(&[whole, gap, short], &linear()).warnings;
    let texts: Vec<String> = together.iter().map(ToString::to_string).collect();
    assert!(texts.iter().any(|text| text.starts_with("cycles of gap: left out as incomplete")), "{texts:?}");
    let none = together.iter().find(|warning| matches!(warning, Warning::NoCycles { .. })).unwrap();
    let Warning::NoCycles { trace: Some(name), error: CyclesError::TooShort { .. } } = none else {
        panic!("{none:?}")
    };
    assert_eq!((name.as_str(), none.name()), ("short", "cycles"));
}
