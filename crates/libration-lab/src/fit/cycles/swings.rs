//! Assignment of rows to swings: approximate turning points, and rotations over the top.

use std::f64::consts::TAU;

use super::CyclesError;
use crate::measurement::{Observable, Trace};
use crate::statistics::{median, robust_deviation};

/// Fraction of the last swing by which the value must have gone back at a turning point. With 0.2 two of 24 recordings (`mod.rs`) had one cycle
/// more, with 0.45 three one less; with 0.15 the strongly damped one had two outliers, with 0.6 no cycles.
const RETURN: f64 = 0.3;
/// Part of the range of all values by which the first turn must go back. With 0.4 all recordings had the same cycles, with 0.1 one of a
/// pendulum nearly at rest had one less.
const FIRST_RETURN: f64 = 0.2;
/// Fraction of the median swing below which swings are disturbances. With 0.2 all recordings had the same cycles, with 0.5 one
/// by a camera had one less.
const SHORTEST: f64 = 0.35;
/// Amplitude, in standard deviations of the noise of the pendulum at rest, below which a swing is lost. With 3 and 8
/// all recordings had the same cycles.
const FAINTEST: f64 = 5.0;

/// Successive swings to and fro about one centre, by the rows of their turning points.
#[derive(Clone, Debug)]
pub struct Stretch {
    /// The rows of the turning points.
    pub turns: Vec<usize>,
    /// The value about which they go.
    pub centre: f64,
}

/// The stretches of a trace, and the number of rotations over the top.
#[derive(Clone, Debug)]
pub struct Swings {
    pub stretches: Vec<Stretch>,
    pub rotations: usize,
    /// Time in seconds after which the swing is lost in the noise, and left out.
    pub(super) lost: Option<f64>,
}

/// Finds the swings of a trace.
pub fn swings(trace: &Trace) -> Result<Swings, CyclesError> {
    /// Fewest rows: one cycle and a half of eight rows each. With 6 and 30 nothing changed in 21 recordings.
    const FEWEST_ROWS: usize = 12;
    if trace.len() < FEWEST_ROWS {
        return Err(CyclesError::TooFewRows(trace.len()));
    }
    let calm = without_spikes(trace.values());
    let turns = turns(&calm, whole_turn(trace.observable()))?;
    let heard = above_noise(trace.values(), &turns);
    let lost = turns.get(heard).map(|&row| trace.times()[row]);
    let turns = without_disturbances(turns[..heard].to_vec(), trace.times());
    let of_trace = match trace.observable() {
        Observable::Angle => of_angles(&calm, &turns),
        Observable::AngularVelocity => of_velocities(&calm, &turns, trace.times()),
    };
    match (Swings { lost, ..of_trace }) {
        Swings { stretches, rotations, .. }
            if stretches.is_empty() && (rotations > 0 || turns_over(trace)) =>
        {
            Err(CyclesError::OnlyRotations)
        }
        Swings { stretches, .. } if stretches.is_empty() => Err(CyclesError::TooShort { turning_points: 0 }),
        swings => Ok(swings),
    }
}

/// The change of a value in a rotation over the top.
fn whole_turn(observable: Observable) -> f64 {
    match observable {
        Observable::Angle => TAU,
        Observable::AngularVelocity => f64::INFINITY,
    }
}

/// Returns `true` if the angle goes a whole turn without turning back.
fn turns_over(trace: &Trace) -> bool {
    trace.observable() == Observable::Angle && range(trace.values()) >= TAU
}

/// Replaces each value by the median of itself and its neighbours.
pub fn without_spikes(values: &[f64]) -> Vec<f64> {
    let middle = |row: usize| {
        let (before, after) = (values[row.saturating_sub(1)], values[(row + 1).min(values.len() - 1)]);
        values[row].clamp(before.min(after), before.max(after))
    };
    let inner = (1..values.len() - 1).map(middle);
    [values[0]].into_iter().chain(inner).chain(values.last().copied()).collect()
}

/// The rows where the values turn back by more than a fraction of the last swing, alternately highest and lowest.
pub(super) fn turns(values: &[f64], whole_turn: f64) -> Result<Vec<usize>, CyclesError> {
    let range = range(values);
    if range <= 0.0 {
        return Err(CyclesError::NothingSwings(values[0]));
    }
    let (mut turns, mut needed) = (vec![], FIRST_RETURN * range.min(whole_turn));
    // The highest and the lowest row since the last turn; the one that is left distinguishes a rise from a fall.
    let (mut highest, mut lowest) = (0, 0);
    let mut rising: Option<bool> = None;
    for row in 0..values.len() {
        highest = if values[row] > values[highest] { row } else { highest };
        lowest = if values[row] < values[lowest] { row } else { lowest };
        let fell = rising != Some(false) && values[highest] - values[row] > needed;
        let rose = rising != Some(true) && values[row] - values[lowest] > needed;
        if !fell && !rose {
            continue;
        }
        let turn = if fell { highest } else { lowest };
        if let Some(&last) = turns.last() {
            let swing = f64::abs(values[turn] - values[last]);
            needed = if swing < whole_turn { RETURN * swing } else { needed };
        }
        turns.push(turn);
        rising = Some(rose);
        (highest, lowest) = (row, row);
    }
    Ok(turns)
}

fn range(values: &[f64]) -> f64 {
    let highest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let lowest = values.iter().copied().fold(f64::INFINITY, f64::min);
    highest - lowest
}

/// The number of turns before the swing is lost in the noise, if the trace ends at rest.
fn above_noise(values: &[f64], turns: &[usize]) -> usize {
    /// Number of consecutive faint swings after which a swing is lost: single ones may be small for other reasons. With 1
    /// and 6 nothing changed in twelve of the recordings.
    const IN_A_ROW: usize = 3;
    let Some(noise) = noise_at_rest(values) else { return turns.len() };
    let faint: Vec<bool> = turns
        .windows(2)
        .map(|pair| f64::abs(values[pair[1]] - values[pair[0]]) < 2.0 * FAINTEST * noise)
        .collect();
    let first = faint.windows(IN_A_ROW).position(|row| row.iter().all(|&faint| faint));
    // Where nearly all swings are as faint, they are not distinguished from noise.
    first.filter(|&swing| swing >= IN_A_ROW).map_or(turns.len(), |swing| swing + 1)
}

/// The noise of the last part of a trace if it contains only noise: the correlation of neighbours is then no
/// larger than that of rows far from each other.
fn noise_at_rest(values: &[f64]) -> Option<f64> {
    /// Number of parts of the trace, of which the last one is used: with 10 and 40 nothing changed in twelve of the recordings.
    const PARTS: usize = 20;
    /// Fewest rows of a stretch: a standard deviation from them is known to 1/√46, or a seventh.
    const FEWEST_ROWS: usize = 24;
    /// Ratio of the scatter of differences, over √2, to that of values; 1 for white noise, at most 0.54 for a swing with 8 rows in a period.
    const WHITE: f64 = 0.6;
    let last = &values[values.len().saturating_sub(FEWEST_ROWS.max(values.len() / PARTS))..];
    let middle = median(last.to_vec())?;
    let scatter = robust_deviation(&last.iter().map(|value| value - middle).collect::<Vec<f64>>())?;
    let differences: Vec<f64> = last.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let of_neighbours = robust_deviation(&differences)? / std::f64::consts::SQRT_2;
    // Of values that jump between few counts, most are equal.
    let jumps = differences.iter().map(|jump| jump.abs()).filter(|&jump| jump > 0.0).collect();
    (of_neighbours >= WHITE * scatter).then(|| scatter.max(median(jumps).unwrap_or(0.0)))
}

/// Drops the pairs of turns between which hardly any time passes.
fn without_disturbances(turns: Vec<usize>, times: &[f64]) -> Vec<usize> {
    let duration = |from: usize, to: usize| times[to] - times[from];
    let durations = turns.windows(2).map(|pair| duration(pair[0], pair[1]));
    let Some(usual) = median(durations.collect()) else { return turns };
    let mut undisturbed: Vec<usize> = vec![];
    for turn in turns {
        match undisturbed.last() {
            Some(&last) if duration(last, turn) < SHORTEST * usual => _ = undisturbed.pop(),
            _ => undisturbed.push(turn),
        }
    }
    undisturbed
}

/// Turning points between which the angle goes less than a turn, about centres that differ by whole turns.
fn of_angles(values: &[f64], turns: &[usize]) -> Swings {
    let over = |pair: &[usize]| (values[pair[1]] - values[pair[0]]).abs() >= TAU;
    let rotations = turns.windows(2).filter(|pair| over(pair)).count();
    let middles = turns.windows(2).filter(|pair| !over(pair));
    let middles: Vec<f64> = middles.map(|pair| f64::midpoint(values[pair[0]], values[pair[1]])).collect();
    let Some(first) = middles.first().copied() else {
        return Swings { stretches: vec![], rotations, lost: None };
    };
    let whole_turns = |middle: f64| TAU * libm::round((middle - first) / TAU);
    let centre =
        median(middles.iter().map(|&middle| middle - whole_turns(middle)).collect()).unwrap_or(first);
    let mut stretches: Vec<Stretch> = vec![];
    let mut last = None;
    for pair in turns.windows(2).filter(|pair| !over(pair)) {
        let middle = centre + whole_turns(f64::midpoint(values[pair[0]], values[pair[1]]));
        // At the edges of a gap there are false turns, perhaps on the same side: the centre is not passed between them.
        if (values[pair[0]] > middle) == (values[pair[1]] > middle) {
            continue;
        }
        match stretches.last_mut() {
            Some(stretch) if last == Some(pair[0]) && (stretch.centre - middle).abs() < 1.0 => {
                stretch.turns.push(pair[1]);
            }
            _ => stretches.push(Stretch { turns: pair.to_vec(), centre: middle }),
        }
        last = Some(pair[1]);
    }
    Swings { stretches, rotations, lost: None }
}

/// Fastest points in alternating directions, between which the pendulum goes less than a turn.
fn of_velocities(values: &[f64], turns: &[usize], times: &[f64]) -> Swings {
    let apart = |pair: &[usize]| values[pair[0]] * values[pair[1]] < 0.0;
    let (mut stretches, mut rotations): (Vec<Stretch>, usize) = (vec![], 0);
    let mut last = None;
    for (index, pair) in turns.windows(2).enumerate() {
        if !apart(pair) || furthest_way(values, times, pair) >= TAU {
            // A trace may begin and end at rest, which is not a rotation.
            rotations += usize::from(index > 0 && index + 2 < turns.len());
            continue;
        }
        match stretches.last_mut() {
            Some(stretch) if last == Some(pair[0]) => stretch.turns.push(pair[1]),
            _ => stretches.push(Stretch { turns: pair.to_vec(), centre: 0.0 }),
        }
        last = Some(pair[1]);
    }
    Swings { stretches, rotations, lost: None }
}

/// Twice the longer distance between a point of largest velocity and the state at rest between two of them, in radians: the range of a whole swing.
fn furthest_way(values: &[f64], times: &[f64], pair: &[usize]) -> f64 {
    let ways =
        (pair[0]..pair[1]).map(|row| 0.5 * (values[row] + values[row + 1]) * (times[row + 1] - times[row]));
    let (forwards, backwards) =
        ways.fold((0.0, 0.0), |(up, down), way| if way > 0.0 { (up + way, down) } else { (up, down - way) });
    2.0 * f64::max(forwards, backwards)
}
