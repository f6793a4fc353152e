//! Isolated values far off the cubic through their neighbours.

use std::ops::Range;

use libration_lab::internals::measurement::faults::outliers::{LONGEST, outliers};

/// A swing with noise of a fifth of a degree and these rows 30° off.
fn off(rows: Range<usize>) -> Vec<usize> {
    let times: Vec<f64> = (0..300_u32).map(|row| 0.02 * f64::from(row)).collect();
    let noise = |time: f64| 0.2 * libm::sin(1e4 * time);
    let mut values: Vec<f64> = times.iter().map(|&time| 45.0 * libm::cos(3.0 * time) + noise(time)).collect();
    values[rows].iter_mut().for_each(|value| *value += 30.0);
    outliers(&times, &values)
}

#[test]
fn five_rows_side_by_side_are_outliers_and_six_are_not() {
    for length in 1..=LONGEST {
        assert_eq!(off(100..100 + length), (100..100 + length).collect::<Vec<_>>(), "{length}");
    }
    assert_eq!(off(100..106), []);
}
