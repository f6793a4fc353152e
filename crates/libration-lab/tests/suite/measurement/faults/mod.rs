//! The faults of instruments in columns of times and values.

mod clipping;
mod even_times;
mod order;
mod outliers;
mod significant_digits;

use libration_lab::measurement::{Faults, unwrapped};

/// A pendulum-like swing of 1 rad, sampled evenly.
fn swing(rows: u32, interval: f64) -> (Vec<f64>, Vec<f64>) {
    let times: Vec<f64> = (0..rows).map(|row| interval * f64::from(row)).collect();
    let values = times.iter().map(|&time| 1.2 * libm::exp(-0.02 * time) * libm::cos(4.5 * time)).collect();
    (times, values)
}

/// Approximately normal noise: the sum of twelve uniform numbers of a linear congruential generator, with unit variance.
fn noise(seed: &mut u64) -> f64 {
    let mut even = || {
        *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        f64::from(u32::try_from(*seed >> 32).unwrap()) / f64::from(u32::MAX)
    };
    (0..12).map(|_| even()).sum::<f64>() - 6.0
}

fn rounded(values: &[f64], step: f64) -> Vec<f64> {
    values.iter().map(|value| (value / step).round() * step).collect()
}

fn truncated(values: &[f64], per_second: f64) -> Vec<f64> {
    values.iter().map(|value| (value * per_second + 1e-9).floor() / per_second).collect()
}

#[test]
fn a_clean_swing_has_no_faults() {
    for interval in [0.005, 1.0 / 60.0, 0.1] {
        let (times, values) = swing(600, interval);
        let faults = Faults::detect(&times, &values, None);
        assert!(faults.is_clean(), "{interval}: {:?}", faults.sentences(&[], "rad"));
        let (mut seed, mut noisy) = (7, values.clone());
        noisy.iter_mut().for_each(|value| *value += 0.003 * noise(&mut seed));
        assert!(Faults::detect(&times, &noisy, None).is_clean(), "{interval} with noise");
        let coarse_and_noisy = rounded(&noisy, 0.002);
        let faults = Faults::detect(&times, &coarse_and_noisy, None);
        assert!(faults.is_clean(), "{interval} with both: {:?}", faults.sentences(&[], "rad"));
        let coarse = rounded(&values, std::f64::consts::TAU / 4000.0);
        let faults = Faults::detect(&times, &coarse, None);
        assert!(faults.is_clean(), "{interval} by encoder: {:?}", faults.sentences(&[], "rad"));
    }
}

#[test]
fn slow_turning_points_next_to_upright_are_no_faults() {
    // A soliton-like motion: long rests, quick passages.
    let times: Vec<f64> = (0..500).map(|row| 0.02 * f64::from(row)).collect();
    let value = |time: &f64| 4.0 * libm::atan(libm::exp(6.0 * (time - 5.0)));
    let values: Vec<f64> = times.iter().map(value).collect();
    for values in [rounded(&values, 0.0016), values] {
        let faults = Faults::detect(&times, &values, None);
        assert!(faults.is_clean(), "{:?}", faults.sentences(&[], "rad"));
    }
}

#[test]
fn dropped_frames_are_counted() {
    let (times, values) = swing(300, 1.0 / 30.0);
    let is_there = |row: &usize| ![40, 41, 42, 100].contains(row);
    let rows: Vec<usize> = (0..300).filter(is_there).collect();
    let pick = |column: &[f64]| rows.iter().map(|&row| column[row]).collect::<Vec<f64>>();
    for per_second in [1e9, 1e3] {
        let faults = Faults::detect(&truncated(&pick(&times), per_second), &pick(&values), None);
        let clock = faults.clock.as_ref().unwrap();
        let gaps: Vec<(usize, usize)> = clock.gaps.iter().map(|gap| (gap.after, gap.missing)).collect();
        assert_eq!(gaps, [(39, 3), (96, 1)]);
        assert!(faults.outliers.is_empty());
    }
}

#[test]
fn truncated_times_are_recognised_and_the_grid_gives_the_frames_back() {
    for (frames_per_second, per_second) in [(12.0, 1000.0), (60.0, 1000.0), (60.0, 100.0), (200.0, 100.0)] {
        let (times, values) = swing(900, 1.0 / frames_per_second);
        let faults = Faults::detect(&truncated(&times, per_second), &values, None);
        let clock = faults.clock.as_ref().unwrap();
        let grid = clock.grid.as_ref().expect("a grid");
        assert!((clock.resolution.unwrap() * per_second - 1.0).abs() < 1e-9);
        // Truncated by half a step on average, by a quarter where the true times are at halves of it.
        let shift = -0.5 / per_second;
        for (even, time) in grid.times().iter().zip(&times) {
            assert!((even - time - shift).abs() < 0.26 / per_second, "{frames_per_second}: {even} {time}");
        }
        assert!(clock.gaps.is_empty(), "{:?}", clock.gaps);
        // The speed of A exp(−t/50) cos ωt is Aω/√2 times the mean of exp(−t/25) to the half.
        let duration = 900.0 / frames_per_second;
        let speed = 1.2 * 4.5 * ((1.0 - libm::exp(-duration / 25.0)) / (duration / 25.0) / 2.0).sqrt();
        // Errors that are halves of a step only have 0.87 times the spread of even ones.
        let ratio = faults.rounding_noise.unwrap() * 12_f64.sqrt() * per_second / speed;
        assert!((0.85..1.1).contains(&ratio), "{frames_per_second}: {ratio}");
    }
}

#[test]
fn an_uneven_clock_is_no_rounded_one() {
    let (mut seed, (times, values)) = (3, swing(400, 0.01));
    let uneven: Vec<f64> =
        times.iter().map(|time| time + 0.0015 * noise(&mut seed).clamp(-2.0, 2.0)).collect();
    let faults = Faults::detect(&uneven, &values, None);
    let clock = faults.clock.unwrap();
    assert!(clock.is_uneven() && clock.grid.is_none() && clock.gaps.is_empty());
}

#[test]
fn repeated_and_wrong_times_are_left_out_and_runs_are_told_apart() {
    let (mut times, values) = swing(100, 0.1);
    times[20] = times[19];
    times[50] = 300.0;
    times[70] = times[68] - 0.02;
    let faults = Faults::detect(&times, &values, None);
    assert_eq!(
        (faults.repeated.as_slice(), faults.out_of_order.as_slice()),
        ([20].as_slice(), [50, 70].as_slice())
    );
    let left_out = faults.left_out();
    let kept: Vec<f64> = (0..100).filter(|row| !left_out.contains(row)).map(|row| times[row]).collect();
    assert!(kept.is_sorted_by(|a, b| a < b) && kept.len() == 97);
    let twice = [times.clone(), times].concat();
    assert_eq!(Faults::detect(&twice, &[values.clone(), values].concat(), None).restarts, [100]);
}

#[test]
fn glitches_are_found_alone_and_in_pairs() {
    for interval in [0.01, 1.0 / 12.0] {
        let (times, mut values) = swing(700, interval);
        let mut seed = 11;
        values.iter_mut().for_each(|value| *value += 0.002 * noise(&mut seed));
        for (row, by) in [(30, 0.1), (200, -0.3), (400, 0.2), (401, 0.2), (650, 1.0)] {
            values[row] += by;
        }
        assert_eq!(Faults::detect(&times, &values, None).outliers, [30, 200, 400, 401, 650], "{interval}");
    }
}

#[test]
fn frames_shown_twice_and_clipped_tops_are_found() {
    let (times, mut values) = swing(500, 1.0 / 60.0);
    values[100] = values[99];
    values[303] = values[300];
    values[302] = values[300];
    values[301] = values[300];
    let faults = Faults::detect(&times, &values, None);
    let runs: Vec<(usize, usize)> = faults.stuck.iter().map(|run| (run.first, run.rows)).collect();
    assert_eq!(runs, [(99, 2), (300, 4)]);
    let clipped: Vec<f64> = values.iter().map(|value| value.clamp(-0.9, 0.9)).collect();
    let faults = Faults::detect(&times, &clipped, None);
    assert!(faults.clipped.len() > 8 && faults.clipped.iter().all(|run| run.value.abs() > 0.89));
}

#[test]
fn whole_turns_are_taken_out() {
    let turn = 4000.0;
    let counts: Vec<f64> = (0..200).map(|row| (900.0 * libm::sin(0.1 * f64::from(row))).round()).collect();
    let wrapped: Vec<f64> = counts.iter().map(|count| count.rem_euclid(turn)).collect();
    let times: Vec<f64> = (0..200).map(|row| 0.02 * f64::from(row)).collect();
    let faults = Faults::detect(&times, &wrapped, Some(turn));
    assert_eq!(faults.wraps.len(), 6);
    assert!(faults.outliers.is_empty());
    assert_eq!(unwrapped(&wrapped, turn), counts);
}

#[test]
fn sentences_name_lines_and_what_is_done() {
    let (mut times, mut values) = swing(100, 0.1);
    times[20] = times[19];
    values[60] += 2.0;
    let lines: Vec<u64> = (3..103).collect();
    let sentences = Faults::detect(&times, &values, None).sentences(&lines, "rad");
    assert!(sentences[0].contains("line 23") && sentences[0].contains("left out"), "{sentences:?}");
    assert!(
        sentences.iter().any(|told| told.contains("line 63") && told.contains("robust")),
        "{sentences:?}"
    );
}

#[test]
fn no_columns_are_too_strange() {
    let odd = [f64::NAN, f64::INFINITY, 0.0, -0.0, 1e300, -1e300, 5e-324];
    for length in 0..odd.len() {
        for times in odd.windows(length.max(1)) {
            let _ = Faults::detect(times, &odd[..times.len()], Some(1.0)).sentences(&[1], "");
            let _ = Faults::detect(&odd[..length], times, None).is_clean();
        }
    }
    assert!(Faults::detect(&[], &[], None).is_clean());
    assert!(Faults::detect(&[1.0; 50], &[1.0; 50], None).left_out().len() == 49);
}
