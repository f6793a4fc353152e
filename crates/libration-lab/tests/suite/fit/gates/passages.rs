//! Times at which a gate becomes blocked and free → passages of the bob.

use libration_lab::fit::gates::{GateSignals, GatesError};
use libration_lab::internals::fit::gates::passages::passages;

#[test]
fn edges_are_told_from_a_gate_off_the_centre() {
    let edges: Vec<f64> = (0..10).flat_map(|k| [f64::from(k), f64::from(k) + 0.05]).collect();
    let pairs = passages(&edges, None, None).unwrap();
    assert!(pairs.edges && pairs.passages.len() == 10 && pairs.unpaired == 0);
    assert!((pairs.passages[3].time - 3.025).abs() < 1e-12);
    let off_centre: Vec<f64> = (0..10).flat_map(|k| [f64::from(k), f64::from(k) + 0.3]).collect();
    let signals = passages(&off_centre, None, None).unwrap();
    assert!(!signals.edges && signals.passages.len() == 20);
}

#[test]
fn edges_without_their_other_one_are_counted() {
    let times = [0.0, 0.05, 1.0, 2.0, 2.05, 3.05, 4.0, 4.01, 4.05];
    let states = [true, false, true, true, false, false, true, true, false];
    let signals = passages(&times, Some(&states), None).unwrap();
    assert_eq!((signals.passages.len(), signals.unpaired), (3, 3));
    // An edge that is seen twice counts from the first time.
    assert!((signals.passages[2].time - 4.025).abs() < 1e-12);
}

#[test]
fn times_out_of_order_are_put_in_order() {
    let signals = passages(&[2.0, 0.0, 1.0, 3.0], None, Some(GateSignals::Passages)).unwrap();
    assert_eq!(signals.passages.iter().map(|p| p.time).collect::<Vec<_>>(), [0.0, 1.0, 2.0, 3.0]);
    assert!(matches!(passages(&[f64::NAN], None, None), Err(GatesError::NotFinite(_))));
}
