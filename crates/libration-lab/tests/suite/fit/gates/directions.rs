//! Passages to either side, with double triggers and gaps.

use libration_lab::internals::fit::gates::directions::sorted;
use libration_lab::internals::fit::gates::passages::Passage;

fn passages(times: &[f64]) -> Vec<Passage> {
    times.iter().map(|&time| Passage { time, blocked: None }).collect()
}

/// Passages alternately every 0.6 s and 0.4 s, without some of them and with additional ones.
fn times(without: &[usize], with: &[f64]) -> Vec<f64> {
    let regular = (0..20).flat_map(|k| [f64::from(k), f64::from(k) + 0.6]).enumerate();
    let mut times: Vec<f64> = regular
        .filter(|(k, _)| !without.contains(k))
        .map(|(_, time)| time)
        .chain(with.iter().copied())
        .collect();
    times.sort_by(f64::total_cmp);
    times
}

#[test]
fn a_gate_off_the_centre_has_two_sides() {
    let sorted = sorted(&passages(&times(&[], &[]))).unwrap();
    assert_eq!((sorted.placed.len(), sorted.spurious, sorted.missed), (40, 0, 0));
    assert!(sorted.placed.iter().all(|placed| placed.side == usize::from(placed.passage.time.fract() > 0.3)));
    assert_eq!(sorted.placed[39].turn, 19);
}

#[test]
fn double_triggers_and_missed_passages_are_counted() {
    let sorted = sorted(&passages(&times(&[5, 12, 13], &[3.02, 9.61, 10.3]))).unwrap();
    assert_eq!((sorted.placed.len(), sorted.spurious, sorted.missed), (37, 3, 3));
    assert_eq!(sorted.placed.last().unwrap().turn, 19);
}

/// Half periods that fall from 1.6 to 1 times those of small swings, as after a release at 140°.
#[test]
fn periods_that_fall_from_large_amplitudes_are_followed() {
    let half = |k: i32| 0.5 * (1.0 + 0.6 * libm::exp(-0.06 * f64::from(k)));
    let mut times = vec![0.0];
    (0..60).for_each(|k| times.push(times[times.len() - 1] + half(k)));
    let regular = sorted(&passages(&times)).unwrap();
    assert_eq!((regular.placed.len(), regular.spurious, regular.missed), (61, 0, 0));
    times.remove(9);
    times.insert(5, times[4] + 0.02);
    let sorted = sorted(&passages(&times)).unwrap();
    assert_eq!((sorted.placed.len(), sorted.spurious, sorted.missed), (60, 1, 1));
}

#[test]
fn a_double_trigger_at_the_beginning_is_no_side() {
    let sorted = sorted(&passages(&times(&[], &[0.02]))).unwrap();
    assert_eq!((sorted.placed.len(), sorted.spurious), (40, 1));
}
