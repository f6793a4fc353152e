//! What a plan expects, beside fits of simulated recordings.

use libration::pendulum::Amplitude;
use libration::quantity::Quantity;
use libration::watch::Watch;
use libration_lab::fit::DampingKind;
use libration_lab::fit::plan::PlannedRecording;
use libration_lab::fit::trace::{DampingModel, TraceOptions, fit_traces};
use libration_lab::measurement::Trace;

use crate::random::Random;
use crate::synthetic_trace::Synthetic;

/// ω0 of a fitted recording, and its uncertainty for independent errors.
fn fitted(trace: Trace) -> (f64, f64) {
    let model = DampingModel::only(DampingKind::Linear);
    let fit = fit_traces(&[trace], model, &TraceOptions::default(), &Watch::none()).unwrap();
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
        let found = uncertainty / omega0;
        // The scatter of so many rows is itself uncertain by some percent.
        assert!((expected / found - 1.0).abs() < 0.1, "{synthetic:?}: {expected} is not {found}");
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
