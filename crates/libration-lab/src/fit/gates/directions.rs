//! Assignment of passages to directions: those of one side are whole periods apart, wherever the gate
//! stands. A passage that fits neither is a double trigger; where one is missing two periods pass.

use super::passages::Passage;
use crate::statistics::median;

// The numbers were varied over 1625 synthetic records: 65 motions released at 3° to 178°, weakly and strongly damped, past gates at
// the centre and off it; as they were, and with passages missing, doubled, added, without the first ones, and with a jitter of 1 %.
// The comment on a number states how many of 79 467 passages were lost, and how many were counted in the wrong position. Of nine measured
// swings past three gates each, by an encoder and by cameras, none is lost; with the typical period alone 6 of 351 from 81° were.

/// Fraction of a period within which a passage is accepted. 651 were lost and 712 in the wrong position; with 0.05 1231 and 337, with 0.15 885 and
/// 2034.
const TOLERANCE: f64 = 0.1;
/// Accepted intervals from the first passage to the second, in periods. With lower limits of 0.05 and 0.2 the records were sorted alike but
/// for 20 passages; with 0.3, 3988 were lost.
const BETWEEN: std::ops::RangeInclusive<f64> = 0.1..=0.9;
/// Number of periods without a passage after which they are no longer counted. With 5 and 100 all were sorted alike; with 2 2814
/// were lost.
const LONGEST_GAP: f64 = 20.0;
/// First passages that are tried. With 16 and 64 all were sorted alike, with 4 27 more were lost, with 2 1682.
const SEEDS: usize = 8;
/// Second passages that are tried with each: with 1 and 6 the passages of 86 records (amplitudes from 6° to 132°, gates up to seven tenths
/// of them, with missed passages and double triggers) were sorted alike.
const SECONDS: usize = 3;
/// Range of the first period, relative to the typical one: with the typical one alone 8067 were lost, mainly from amplitudes beyond 90°, whose
/// period is far longer; up to 1.5 783, up to 2 and 4 as many as up to 2.5, which a pendulum has at 170°.
const FIRST_PERIODS: std::ops::RangeInclusive<f64> = 0.9..=2.5;

/// A passage with its position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    pub passage: Passage,
    /// Side of the passage: the one (0) or the other (1).
    pub side: usize,
    /// Index of the period of its side, from zero.
    pub turn: usize,
}

/// The passages in order, and the number of those that did not fit.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Sorted {
    pub placed: Vec<Placed>,
    /// Passages that fit no side.
    pub spurious: usize,
    /// Passages that are missing.
    pub missed: usize,
}

/// Sorts the passages by sides so that most of them fit.
pub fn sorted(passages: &[Passage]) -> Option<Sorted> {
    let typical = typical_period(passages)?;
    let seeds = (0..passages.len().saturating_sub(2).min(SEEDS)).flat_map(|first| {
        let seconds = first + 1..passages.len().min(first + 1 + SECONDS);
        seconds.map(move |second| (first, second))
    });
    let tried = seeds.flat_map(|(first, second)| {
        let part = (passages[second].time - passages[first].time).abs();
        let periods = first_periods(passages, first, second, typical);
        let usable = periods.filter(move |period| BETWEEN.contains(&(part / period)));
        usable.map(move |period| follow(passages, first, second, period))
    });
    // The earliest of equally good ones.
    tried.fold(None, |best: Option<Sorted>, candidate| match best {
        Some(best) if best.placed.len() >= candidate.placed.len() => Some(best),
        _ => Some(candidate),
    })
}

/// The periods with which the passages may begin: the time from the first one to one of the two after the second, and the typical one.
fn first_periods(
    passages: &[Passage],
    first: usize,
    second: usize,
    typical: f64,
) -> impl Iterator<Item = f64> {
    let begin = passages[first].time;
    let next = passages[second + 1..].iter().take(2).map(move |passage| passage.time - begin);
    next.filter(move |period| FIRST_PERIODS.contains(&(period / typical))).chain([typical])
}

/// The median of the times from each passage to the next but one, without double triggers.
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
    let mut sorted = Sorted { placed: last.to_vec(), spurious: second - 1, missed: 0 };
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
            sorted.spurious += 1;
            continue;
        };
        // The period changes slowly with the amplitude.
        period = (passage.time - last[side].passage.time) / whole;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 20")]
        let turns = whole as usize;
        sorted.missed += turns - 1;
        last[side] = Placed { passage, side, turn: last[side].turn + turns };
        sorted.placed.push(last[side]);
    }
    sorted
}
