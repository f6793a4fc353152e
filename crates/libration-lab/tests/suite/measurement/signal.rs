//! Passages in continuous signals.

use crate::random::Random;
use libration_lab::measurement::{
    Choice, Choices, Column, MeasurementError, ReadOptions, Recording, SignalPassages,
};

const STEP: f64 = 0.01;

/// A level of 300 with a dip at each of these times, 40 ms to each side of its middle, with flanks of 10 ms, and noise.
fn dips(middles: &[f64], depth: f64, noise: f64, random: &mut Random) -> (Vec<f64>, Vec<f64>) {
    let times: Vec<f64> = (0..2000).map(|row| STEP * f64::from(row)).collect();
    let at = |time: f64| {
        let distance = middles.iter().map(|middle| (time - middle).abs()).fold(f64::INFINITY, f64::min);
        depth * ((0.045 - distance) / 0.01).clamp(0.0, 1.0)
    };
    let values = times.iter().map(|&time| 300.0 - at(time) + noise * random.normal()).collect();
    (times, values)
}

fn middles(signal: &SignalPassages) -> Vec<f64> {
    signal.passages.iter().map(|passage| f64::midpoint(passage.edges[0], passage.edges[1])).collect()
}

#[test]
fn dips_and_peaks_are_timed_at_half_of_their_height() {
    let mut random = Random::seeded(11);
    let truth: Vec<f64> = (0..18).map(|n| 0.5 + 1.0137 * f64::from(n)).collect();
    let (times, values) = dips(&truth, 200.0, 1.0, &mut random);
    let below = SignalPassages::in_signal(&times, &values).unwrap();
    let above =
        SignalPassages::in_signal(&times, &values.iter().map(|value| -value).collect::<Vec<_>>()).unwrap();
    assert!(below.are_dips && !above.are_dips && below.passages == above.passages);
    assert_eq!(below.passages.len(), truth.len());
    for (passage, middle) in below.passages.iter().zip(&truth) {
        // A flank of 10 ms between rows 10 ms apart is seen as one of up to 20 ms.
        for (edge, true_edge) in passage.edges.iter().zip([middle - 0.04, middle + 0.04]) {
            assert!((edge - true_edge).abs() < 0.003, "{edge} {true_edge}");
        }
    }
}

/// The noise allows a height of ten standard deviations, and not less.
#[test]
fn noise_is_no_passage() {
    let truth = [1.0, 3.0, 5.0, 7.0];
    for seed in 0..20 {
        let mut random = Random::seeded(seed);
        let (times, values) = dips(&truth, 0.0, 1.0, &mut random);
        assert_eq!(SignalPassages::in_signal(&times, &values), None);
        let (times, values) = dips(&truth, 7.0, 1.0, &mut random);
        assert_eq!(SignalPassages::in_signal(&times, &values), None);
        let (times, values) = dips(&truth, 14.0, 1.0, &mut random);
        assert_eq!(SignalPassages::in_signal(&times, &values).unwrap().passages.len(), 4);
    }
    // A last bit that changes now and then, at times in several rows.
    let rows: Vec<f64> = (0..2000).map(f64::from).collect();
    for seed in 0..20 {
        let mut random = Random::seeded(seed);
        let mut bit = || if random.between(0.0, 1.0) < 0.06 { 0.5 } else { 0.499 };
        let bits: Vec<f64> = rows.iter().map(|_| bit()).collect();
        assert_eq!(SignalPassages::in_signal(&rows, &bits), None, "{seed}");
    }
    let rows = &rows[..500];
    assert_eq!(SignalPassages::in_signal(rows, &[3.0; 500]), None);
    assert_eq!(SignalPassages::in_signal(rows, rows), None);
    assert_eq!(SignalPassages::in_signal(rows, &rows[1..]), None);
    for few in 0..6 {
        assert_eq!(SignalPassages::in_signal(&rows[..few], &rows[..few]), None);
    }
}

#[test]
fn cut_passages_gaps_and_wrong_rows_are_left_out() {
    let mut random = Random::seeded(3);
    // The first and the last one are cut by the ends of the record.
    let truth = [0.01, 2.0, 4.0, 6.0, 8.0, 19.98];
    let (mut times, mut values) = dips(&truth, 200.0, 1.0, &mut random);
    values[1234] = 10.0;
    let signal = SignalPassages::in_signal(&times, &values).unwrap();
    let distance = |(middle, truth): (&f64, &f64)| (middle - truth).abs();
    assert!(
        middles(&signal).iter().zip(&truth[1..5]).map(distance).fold(0.0, f64::max) < 0.003,
        "{signal:?}"
    );
    assert_eq!(signal.passages.len(), 4);
    // Rows are missing where the second one begins.
    let gap = 190..198;
    times.drain(gap.clone());
    values.drain(gap);
    let signal = SignalPassages::in_signal(&times, &values).unwrap();
    assert!(
        middles(&signal).iter().zip(&truth[2..5]).map(distance).fold(0.0, f64::max) < 0.003,
        "{signal:?}"
    );
    assert_eq!(signal.passages.len(), 3);
}

/// Peaks whose height falls with the swing keep their middles.
#[test]
fn falling_peaks_keep_their_times() {
    let (times, values): (Vec<f64>, Vec<f64>) = (0..2000)
        .map(|row| {
            let time = STEP * f64::from(row);
            let height = 0.9 * libm::exp(-0.04 * time);
            (time, 9.81 + height * libm::cos(std::f64::consts::TAU * time / 0.981))
        })
        .unzip();
    let signal = SignalPassages::in_signal(&times, &values).unwrap();
    let middles = middles(&signal);
    assert!(middles.len() > 15, "{middles:?}");
    for pair in middles.windows(2) {
        assert!((pair[1] - pair[0] - 0.981).abs() < 2e-3, "{pair:?}");
    }
}

#[test]
fn a_recording_of_samples_is_asked_for_its_signal() {
    let mut text = "t (s),a (V),b (V)\n".to_owned();
    let mut random = Random::seeded(7);
    let truth: Vec<f64> = (0..9).map(|n| 1.0 + 2.0 * f64::from(n)).collect();
    let (times, values) = dips(&truth, 200.0, 1.0, &mut random);
    for (time, value) in times.iter().zip(values) {
        text += &format!("{time:.2},{:.3},{value:.2}\n", random.normal());
    }
    let recording = Recording::read(text.as_bytes(), &ReadOptions::default()).unwrap();
    let error = recording.gate_times(&Choices::default()).unwrap_err();
    let MeasurementError::Undecided { choices, .. } = &error else { panic!("{error}") };
    let choices: Vec<_> = choices.iter().map(|choice| (choice.choice, choice.value.as_str())).collect();
    assert_eq!(choices, [(Choice::Signal, "3")], "{error}");
    let of = |column| Choices { signal: Some(Column::Number(column)), ..Choices::default() };
    let gates = recording.gate_times(&of(3)).unwrap();
    assert_eq!((gates.times.len(), gates.lines.len(), gates.incomplete), (18, 18, 0));
    assert!(gates.blocked.unwrap().chunks(2).all(|pair| pair == [true, false]));
    assert!(
        (gates.times[0] - 0.96).abs() < 0.003 && (97..107).contains(&gates.lines[0]),
        "{:?}",
        gates.lines
    );
    let later = recording.gate_times(&Choices { from: Some(4.0), to: Some(12.5), ..of(3) }).unwrap();
    assert_eq!(later.times.len(), 8);
    assert!(matches!(recording.gate_times(&of(2)), Err(MeasurementError::NoPassages { .. })));
}
