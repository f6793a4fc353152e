//! Expected results of a plan, compared with fits of simulated recordings and with each other.

use libration::pendulum::Amplitude;
use libration::progress::Quiet;
use libration::quantity::Quantity;
use libration_lab::fit::DampingKind;
use libration_lab::fit::plan::{PlanError, PlannedRecording, plan};
use libration_lab::fit::trace::{DampingModel, TraceOptions, fit_traces};
use libration_lab::internals::fit::plan::FEWEST_SWINGS;
use libration_lab::measurement::Trace;

use crate::random::Random;
use crate::synthetic_trace::Synthetic;

/// ω0 of a fitted recording, and its uncertainty for independent errors.
fn fitted(trace: Trace) -> (f64, f64) {
    let model = DampingModel::only(DampingKind::Linear);
    let fit = fit_traces(&[trace], model, &TraceOptions::default(), &Quiet).unwrap();
    (fit.parameters[0].estimate.value, fit.parameters[0].formal_uncertainty)
}

fn planned(synthetic: &Synthetic, swings: usize) -> (PlannedRecording, Amplitude, Synthetic) {
    let gravity = synthetic.omega0 * synthetic.omega0;
    let recording = PlannedRecording {
        length: Quantity { value: 1.0, uncertainty: None },
        gravity,
        angle_noise: synthetic.noise,
        rate: 1.0 / synthetic.step,
        linear_damping: synthetic.linear,
        angle_scale: 0.01,
        clock: 0.0,
    };
    let amplitude =
        Amplitude::new(libration::quantity::Angle::from_radians(synthetic.amplitude).unwrap()).unwrap();
    let rows = recording.rate * recording.duration(&amplitude, swings);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
    let rows = rows as u32;
    (recording, amplitude, Synthetic { rows, ..*synthetic })
}

const CASES: [(f64, f64, usize); 5] =
    [(0.1, 0.0, 10), (0.35, 0.0, 30), (0.35, 0.05, 20), (1.0, 0.02, 15), (1.5, 0.01, 8)];

#[test]
fn the_noise_counts_as_in_fits() {
    let mut random = Random::seeded(7);
    for (amplitude, linear, swings) in CASES {
        let synthetic = Synthetic { amplitude, linear, noise: 0.004, ..Synthetic::USUAL };
        let (recording, amplitude, synthetic) = planned(&synthetic, swings);
        let (omega0, uncertainty) = fitted(synthetic.trace(&mut random));
        let expected = recording.expected(&amplitude, swings).noise / 2.0;
        let computed = uncertainty / omega0;
        // The scatter of this number of rows is itself uncertain by some percent.
        assert!((expected / computed - 1.0).abs() < 0.1, "{synthetic:?}: {expected} is not {computed}");
    }
}

#[test]
fn a_wrong_scale_of_the_angles_counts_as_in_fits() {
    let mut random = Random::seeded(11);
    for (amplitude, linear, swings) in CASES {
        let synthetic = Synthetic { amplitude, linear, noise: 1e-7, ..Synthetic::USUAL };
        let (recording, amplitude, synthetic) = planned(&synthetic, swings);
        let right = synthetic.trace(&mut random);
        let larger = right.values().iter().map(|value| 1.0001 * value).collect();
        let scaled = Trace::new("scaled", right.observable(), right.times().to_vec(), larger, None).unwrap();
        let shift = (fitted(scaled).0 / fitted(right).0 - 1.0) / 1e-4;
        let expected = recording.expected(&amplitude, swings).angle_scale / 2.0 / recording.angle_scale;
        assert!((expected / shift.abs() - 1.0).abs() < 0.1, "{synthetic:?}: {expected} is not {shift}");
    }
}

fn amplitude(degrees: f64) -> Amplitude {
    Amplitude::new(format!("{degrees}deg").parse().unwrap()).unwrap()
}

const RECORDING: PlannedRecording = PlannedRecording {
    length: Quantity { value: 0.8, uncertainty: Some(1e-4) },
    gravity: 9.81,
    angle_noise: 0.004,
    rate: 50.0,
    linear_damping: 0.0,
    angle_scale: 0.0,
    clock: 0.0,
};

/// u(Ω)² = 24σ²/(A²NT²); the amplitude enters only with an eighth of its square.
#[test]
fn small_undamped_swings_reach_the_bound_of_rife_and_boorstyn() {
    for (swings, degrees) in [(5, 1.0), (40, 0.5)] {
        let amplitude = amplitude(degrees);
        let duration = RECORDING.duration(&amplitude, swings);
        let rows = RECORDING.rate * duration;
        let phase = RECORDING.angular_frequency() * duration;
        let expected = 24.0_f64.sqrt() * RECORDING.angle_noise / (amplitude.radians() * rows.sqrt() * phase);
        let noise = RECORDING.expected(&amplitude, swings).noise / 2.0;
        assert!((noise / expected - 1.0).abs() < 2e-3, "{noise} is not {expected}");
    }
}

#[test]
fn a_scale_of_undamped_swings_changes_the_frequency_by_the_condition() {
    for degrees in [5.0, 30.0, 120.0] {
        let amplitude = amplitude(degrees);
        let recording = PlannedRecording { angle_scale: 0.01, ..RECORDING };
        let scale = recording.expected(&amplitude, 20).angle_scale;
        assert!((scale / (2.0 * 0.01 * amplitude.condition()) - 1.0).abs() < 1e-6, "{degrees}: {scale}");
    }
}

#[test]
fn the_plan_keeps_what_is_wanted_and_one_swing_less_does_not() {
    let recording = PlannedRecording { angle_scale: 0.005, clock: 1e-5, ..RECORDING };
    let amplitudes = [5.0, 10.0, 20.0, 40.0, 80.0].map(amplitude);
    let plan = plan(&recording, 5e-4, &amplitudes).unwrap();
    assert_eq!(plan.length_needed, None);
    let mut swings = vec![];
    for (choice, amplitude) in plan.choices.iter().zip(&amplitudes) {
        let Some(fewest) = choice.swings else { continue };
        assert!(choice.expected.total() <= 5e-4 * (1.0 + 1e-12));
        assert!(recording.expected(amplitude, fewest - 1).total() > 5e-4);
        swings.push(fewest);
    }
    assert!(swings.len() >= 2 && plan.best().unwrap().swings == swings.iter().min().copied());
    // At the largest a wrong scale of the angles is too much.
    assert_eq!(plan.choices[4].swings, None);
}

#[test]
fn of_equal_numbers_of_swings_the_smallest_amplitude_is_best() {
    let recording = PlannedRecording { angle_noise: 1e-6, ..RECORDING };
    let plan = plan(&recording, 1e-3, &[20.0, 10.0, 15.0].map(amplitude)).unwrap();
    assert!(plan.choices.iter().all(|choice| choice.swings == Some(FEWEST_SWINGS)));
    assert_eq!(plan.best, Some(1));
}

#[test]
fn what_leaves_no_room_is_said() {
    let badly_known =
        PlannedRecording { length: Quantity { value: 1.0, uncertainty: Some(0.01) }, ..RECORDING };
    let planned = plan(&badly_known, 1e-3, &[amplitude(20.0)]).unwrap();
    assert_eq!(planned.length_needed, Some(1e-3 / 2.0_f64.sqrt()));
    assert!(planned.advice()[0].contains("measure the length to 0.71 mm"), "{:?}", planned.advice());
    let clock = PlannedRecording { clock: 1e-3, ..RECORDING };
    assert!(matches!(plan(&clock, 1e-3, &[amplitude(20.0)]), Err(PlanError::Clock { .. })));
    let noisy = PlannedRecording {
        angle_noise: 3.0,
        length: Quantity { value: 1.0, uncertainty: None },
        ..RECORDING
    };
    let hopeless = plan(&noisy, 1e-6, &[amplitude(1.0)]).unwrap();
    assert!(hopeless.best().is_none() && hopeless.advice()[0].contains("no recording of up to 10000"));
}

#[test]
fn numbers_that_cannot_be_are_refused() {
    let at = [amplitude(20.0)];
    for wrong in [
        PlannedRecording { angle_noise: 0.0, ..RECORDING },
        PlannedRecording { angle_noise: f64::NAN, ..RECORDING },
        PlannedRecording { gravity: -1.0, ..RECORDING },
        PlannedRecording { linear_damping: -0.1, ..RECORDING },
        PlannedRecording { clock: f64::INFINITY, ..RECORDING },
        PlannedRecording { length: Quantity { value: 1.0, uncertainty: Some(-1.0) }, ..RECORDING },
    ] {
        assert!(matches!(plan(&wrong, 1e-3, &at), Err(PlanError::Number { .. })), "{wrong:?}");
    }
    for target in [0.0, 1.0, -1.0, f64::NAN] {
        assert!(matches!(plan(&RECORDING, target, &at), Err(PlanError::Number { .. })));
    }
    assert_eq!(plan(&RECORDING, 1e-3, &[]), Err(PlanError::NoAmplitude));
    let is_too_slow = |rows_in_a_period: f64| {
        let small_swings = 2.0 * std::f64::consts::PI * (RECORDING.length.value / RECORDING.gravity).sqrt();
        let slow = PlannedRecording { rate: rows_in_a_period / small_swings, ..RECORDING };
        matches!(plan(&slow, 1e-3, &at), Err(PlanError::FewRows { .. }))
    };
    assert!(is_too_slow(5.9) && !is_too_slow(6.1));
}

#[test]
fn swings_that_have_died_down_tell_no_more() {
    let damped = PlannedRecording { linear_damping: 1.0, ..RECORDING };
    let [some, more] = [40, 10_000].map(|swings| damped.expected(&amplitude(20.0), swings).noise);
    assert!(some.is_finite() && more.is_finite() && more > 0.8 * some, "{some} {more}");
}
