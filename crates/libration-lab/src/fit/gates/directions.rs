//! Which passages are to the one side and which to the other: those of one side are whole periods apart, wherever the gate
//! stands. What fits neither is a double trigger; where one is missing two periods pass.

use super::passages::Passage;
use crate::statistics::median;

/// A passage is accepted within this part of a period.
const TOLERANCE: f64 = 0.1;
/// The second passage is neither sooner nor later than these parts of a period after the first one.
const BETWEEN: std::ops::RangeInclusive<f64> = 0.1..=0.9;
/// After so many periods without a passage nothing is said of how many they were.
const LONGEST_GAP: f64 = 20.0;
/// Pairs of first passages that are tried.
const SEEDS: usize = 8;

/// A passage with its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Placed {
    pub(super) passage: Passage,
    /// To the one side (0) or the other (1).
    pub(super) side: usize,
    /// Which period of its side, from zero.
    pub(super) turn: usize,
}

/// The passages in order, and what did not fit.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Sorted {
    pub(super) placed: Vec<Placed>,
    /// Passages that fit no side.
    pub(super) spurious: usize,
    /// Passages that are missing.
    pub(super) missed: usize,
}

/// The passages sorted by sides, as most of them fit.
pub(super) fn sorted(passages: &[Passage]) -> Option<Sorted> {
    let period = typical_period(passages)?;
    let seeds = (0..passages.len().saturating_sub(2).min(SEEDS))
        .flat_map(|first| (first + 1..passages.len().min(first + 4)).map(move |second| (first, second)));
    let usable = |&(first, second): &(usize, usize)| {
        BETWEEN.contains(&((passages[second].time - passages[first].time) / period))
    };
    let tried = seeds.filter(usable).map(|(first, second)| follow(passages, first, second, period));
    // The earliest of equally good ones.
    tried.fold(None, |best: Option<Sorted>, found| match best {
        Some(best) if best.placed.len() >= found.placed.len() => Some(best),
        _ => Some(found),
    })
}

/// The middle one of the times from each passage to the next but one, double triggers left out.
fn typical_period(passages: &[Passage]) -> Option<f64> {
    let times: Vec<f64> = passages.iter().map(|passage| passage.time).collect();
    let intervals = |times: &[f64], step: usize| -> Vec<f64> {
        times.windows(step + 1).map(|window| window[step] - window[0]).collect()
    };
    let usual = median(intervals(&times, 1))?;
    let mut clean: Vec<f64> = vec![];
    for time in times {
        if clean.last().is_none_or(|last| time - last > 0.1 * usual) {
            clean.push(time);
        }
    }
    let period = median(intervals(&clean, 2))?;
    (period > 0.0 && period.is_finite()).then_some(period)
}

/// The passages that follow these two, one of each side.
fn follow(passages: &[Passage], first: usize, second: usize, period: f64) -> Sorted {
    let start = |index: usize, side| Placed { passage: passages[index], side, turn: 0 };
    let mut last = [start(first, 0), start(second, 1)];
    let mut period = period;
    let mut found = Sorted { placed: last.to_vec(), spurious: second - 1, missed: 0 };
    for &passage in &passages[second + 1..] {
        let fits = |placed: &Placed| {
            let turns = (passage.time - placed.passage.time) / period;
            let whole = libm::round(turns);
            let fits =
                (1.0..=LONGEST_GAP).contains(&whole) && (turns - whole).abs() <= TOLERANCE * whole.min(2.0);
            fits.then_some((placed.side, whole, (turns - whole).abs()))
        };
        let best = last.iter().filter_map(fits).min_by(|a, b| a.2.total_cmp(&b.2));
        let Some((side, whole, _)) = best else {
            found.spurious += 1;
            continue;
        };
        // The period changes slowly with the amplitude.
        period = (passage.time - last[side].passage.time) / whole;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 20")]
        let turns = whole as usize;
        found.missed += turns - 1;
        last[side] = Placed { passage, side, turn: last[side].turn + turns };
        found.placed.push(last[side]);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn passages(times: &[f64]) -> Vec<Passage> {
        times.iter().map(|&time| Passage { time, blocked: None }).collect()
    }

    /// Passages every 0.6 s and 0.4 s, without some and with others.
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
        let found = sorted(&passages(&times(&[], &[]))).unwrap();
        assert_eq!((found.placed.len(), found.spurious, found.missed), (40, 0, 0));
        assert!(
            found.placed.iter().all(|placed| placed.side == usize::from(placed.passage.time.fract() > 0.3))
        );
        assert_eq!(found.placed[39].turn, 19);
    }

    #[test]
    fn double_triggers_and_missed_passages_are_counted() {
        let found = sorted(&passages(&times(&[5, 12, 13], &[3.02, 9.61, 10.3]))).unwrap();
        assert_eq!((found.placed.len(), found.spurious, found.missed), (37, 3, 3));
        assert_eq!(found.placed.last().unwrap().turn, 19);
    }

    #[test]
    fn a_double_trigger_at_the_beginning_is_no_side() {
        let found = sorted(&passages(&times(&[], &[0.02]))).unwrap();
        assert_eq!((found.placed.len(), found.spurious), (40, 1));
    }
}
