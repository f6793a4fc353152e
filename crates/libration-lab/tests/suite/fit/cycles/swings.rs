//! Turning points and turns over the top of known motions.

use std::f64::consts::TAU;

use libration_lab::fit::cycles::CyclesError;
use libration_lab::internals::fit::cycles::swings::{Stretch, swings, without_spikes};
use libration_lab::measurement::{Observable, Trace};

fn wave(rows: u32, value: impl Fn(f64) -> f64) -> Trace {
    let times: Vec<f64> = (0..rows).map(|row| 0.05 * f64::from(row)).collect();
    let values = times.iter().map(|&t| value(t)).collect();
    Trace::new("wave", Observable::Angle, times, values, None).unwrap()
}

#[test]
fn each_row_is_the_middle_one_of_itself_and_its_neighbours() {
    assert_eq!(without_spikes(&[0.0, 1.0, 9.0, 3.0, 4.0, 4.5]), [0.0, 1.0, 3.0, 4.0, 4.0, 4.5]);
    assert_eq!(without_spikes(&[0.0, 1.0, -9.0, 3.0, 4.0]), [0.0, 0.0, 1.0, 3.0, 4.0]);
    assert_eq!(without_spikes(&[5.0, 1.0, 7.0]), [5.0, 5.0, 7.0]);
}

#[test]
fn turns_alternate_and_spikes_make_none() {
    let mut values: Vec<f64> = wave(200, |t| 0.7 + libm::cos(3.0 * t)).values().to_vec();
    values[50] = 9.0;
    let times = (0..200).map(|row| 0.05 * f64::from(row)).collect();
    let trace = Trace::new("spike", Observable::Angle, times, values, None).unwrap();
    let swings = swings(&trace).unwrap();
    assert_eq!((swings.stretches.len(), swings.rotations), (1, 0));
    // 10 s hold 9.55 half periods of π/3: the first turn is the start, the last one at 9π/3.
    assert_eq!(swings.stretches[0].turns.len(), 10);
    assert!((swings.stretches[0].centre - 0.7).abs() < 0.01);
}

#[test]
fn centres_on_both_sides_of_a_rotation_are_a_turn_apart() {
    let swing = |t: f64| libm::cos(3.0 * t);
    let whole_swings = 2.0 * TAU;
    let trace =
        wave(
            500,
            |t| {
                if t < whole_swings { swing(t) } else { (1.0 + 3.0 * (t - whole_swings)).min(TAU - 1.0) }
            },
        );
    let trace = {
        let values: Vec<f64> = trace.values().to_vec();
        let times: Vec<f64> = (0..900).map(|row| 0.05 * f64::from(row)).collect();
        let extended = |row: usize| match values.get(row) {
            Some(&value) => value,
            None => TAU - swing(times[row] - times[499]),
        };
        let values = (0..900).map(extended).collect();
        Trace::new("over the top", Observable::Angle, times, values, None).unwrap()
    };
    let swings = swings(&trace).unwrap();
    let centres: Vec<f64> = swings.stretches.iter().map(|stretch| stretch.centre).collect();
    assert!(centres.len() >= 2 && centres[0].abs() < 0.05, "{centres:?}");
    assert!((centres[centres.len() - 1] - TAU).abs() < 0.05, "{centres:?}");
}

#[test]
fn a_gap_whose_edges_look_like_turns_parts_two_stretches() {
    // From a little above the centre, falling, to a little above it, rising: the lowest row is on the side of the highest ones.
    let phase = |row: u32| f64::from(row) * 0.1;
    let rows: Vec<u32> = (0..400).filter(|&row| !(140..174).contains(&row)).collect();
    let times: Vec<f64> = rows.iter().map(|&row| phase(row)).collect();
    let values: Vec<f64> = times.iter().map(|&t| libm::cos(t)).collect();
    let trace = Trace::new("gap", Observable::Angle, times, values, None).unwrap();
    let swings = swings(&trace).unwrap();
    assert_eq!(swings.stretches.len(), 2, "{:?}", swings.stretches);
    let sides = |stretch: &Stretch| {
        let above = |row: &usize| trace.values()[*row] > stretch.centre;
        stretch.turns.iter().map(above).collect::<Vec<bool>>()
    };
    assert!(swings.stretches.iter().all(|stretch| sides(stretch).windows(2).all(|pair| pair[0] != pair[1])));
}

#[test]
fn what_does_not_swing_is_refused() {
    let refused = |trace: Trace| swings(&trace).unwrap_err();
    assert_eq!(refused(wave(100, |_| 1.5)), CyclesError::NothingSwings(1.5));
    assert_eq!(refused(wave(5, libm::sin)), CyclesError::TooFewRows(5));
    assert_eq!(refused(wave(100, |t| t)), CyclesError::TooShort { turning_points: 0 });
}
