//! All equally spaced times that round to the given ones.

use libration_lab::internals::measurement::faults::even_times::{EvenTimes, centroid};

/// Times rounded to a step that is not commensurate with the interval, and to one that is.
#[test]
fn the_interval_lies_within_its_uncertainty_which_is_wide_where_frames_fall_in_step() {
    let through = |interval: f64, rows: u32| {
        let rounded: Vec<f64> =
            (0..rows).map(|row| (interval * f64::from(row) / 0.1).round() * 0.1).collect();
        let places: Vec<usize> = (0..rounded.len()).collect();
        EvenTimes::through(&rounded, &places, &vec![0.05; rounded.len()]).unwrap()
    };
    for interval in [0.0331, 0.0317, 0.041, 1.0 / 30.0, 0.025] {
        let even = through(interval, 900);
        assert!((even.interval - interval).abs() < 2.0 * even.interval_uncertainty, "{interval}: {even:?}");
    }
    // In step each time may be moved by a sixth of a step: over 900 rows by 0.0167 s either way at most.
    let (in_step, out_of_step) = (through(1.0 / 30.0, 900), through(0.0331, 900));
    assert!((3e-6..2e-5).contains(&in_step.interval_uncertainty), "{in_step:?}");
    assert!(out_of_step.interval_uncertainty < 0.2 * in_step.interval_uncertainty, "{out_of_step:?}");
}

#[test]
fn rows_that_are_missing_leave_no_even_times() {
    let rounded = |row: u32| (f64::from(row) / 30.0 / 0.1).round() * 0.1;
    // One row would be taken for a slower clock: 0.03 s are less than the steps leave open.
    let times: Vec<f64> = (0..300).filter(|row| !(200..203).contains(row)).map(rounded).collect();
    let places: Vec<usize> = (0..times.len()).collect();
    assert_eq!(EvenTimes::through(&times, &places, &vec![0.05; times.len()]), None);
}

#[test]
fn the_centroid_of_a_triangle_is_the_mean_of_its_corners() {
    let (middle, deviation) = centroid(&[(1.0, 1.0), (4.0, 1.0), (1.0, 7.0)]).unwrap();
    assert!((middle.0 - 2.0).abs() < 1e-15 && (middle.1 - 3.0).abs() < 1e-15);
    // The variance of a triangle's height h is h²/18.
    assert!((deviation * deviation - 2.0).abs() < 1e-14);
    assert_eq!(centroid(&[(0.0, 0.0), (1.0, 1.0)]), None);
}
