//! Times at which a gate becomes blocked and free → passages of the bob.

use super::{GateSignals, GatesError};
use crate::statistics::count;
use crate::statistics::median;
use libration::internals::InOrder;

/// Intervals between edges that alternate between short and long ones, the short ones below this part of the long ones, are
/// those of a bob that blocks and frees the gate; a gate off the centre makes a smaller difference.
///
/// Of 162 synthetic records of edges, from amplitudes of 6° to 132° past gates up to nineteen twentieths of them, 6 were taken for
/// passages, all of bobs a third as wide as the amplitude, and of the 162 of passages 30 for edges, all of gates beyond eight
/// tenths of it; with 0.1 24 and 12, with 0.3 3 and 50.
const BLOCKED_PART: f64 = 0.2;

/// A passage of the bob.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passage {
    /// Time at which its middle passes, in seconds.
    pub time: f64,
    /// Duration for which the gate is blocked, in seconds, where both edges are known.
    pub blocked: Option<f64>,
}

/// The passages, and the number of edges without a partner.
#[derive(Clone, Debug, PartialEq)]
pub struct Passages {
    pub passages: Vec<Passage>,
    pub unpaired: usize,
    /// `true` if the times are edges.
    pub edges: bool,
}

/// Finds the passages from the times, in order.
pub fn passages(
    times: &[f64],
    blocked: Option<&[bool]>,
    signals: Option<GateSignals>,
) -> Result<Passages, GatesError> {
    if let Some(states) = blocked.filter(|states| states.len() != times.len()) {
        return Err(GatesError::Lengths { times: times.len(), states: states.len() });
    }
    if let Some(&time) = times.iter().find(|time| !time.is_finite()) {
        return Err(GatesError::NotFinite(time));
    }
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.put_in_order(|&a, &b| times[a].total_cmp(&times[b]));
    let sorted: Vec<f64> = order.iter().map(|&row| times[row]).collect();
    if let Some(states) = blocked {
        return Ok(paired(&sorted, &order.iter().map(|&row| states[row]).collect::<Vec<_>>()));
    }
    let edges = signals.map_or_else(|| alternate(&sorted), |signals| signals == GateSignals::Edges);
    Ok(if edges { by_duration(&sorted) } else { bare(&sorted) })
}

fn bare(times: &[f64]) -> Passages {
    let passages = times.iter().map(|&time| Passage { time, blocked: None }).collect();
    Passages { passages, unpaired: 0, edges: false }
}

/// Pairs the edges of a gate that is blocked, and then free.
fn paired(times: &[f64], states: &[bool]) -> Passages {
    let mut paired = Passages { passages: vec![], unpaired: 0, edges: true };
    let usual = usual_duration(times, states);
    let mut since = None;
    for (&time, &blocked) in times.iter().zip(states) {
        match (since, blocked) {
            (None, true) => since = Some(time),
            // Blocked twice without having been free: an edge seen twice, or one between that is missing.
            (Some(start), true) => {
                paired.unpaired += 1;
                since = Some(if time - start < usual { start } else { time });
            }
            (Some(start), false) => {
                paired.push(start, time);
                since = None;
            }
            (None, false) => paired.unpaired += 1,
        }
    }
    paired.unpaired += usize::from(since.is_some());
    paired
}

/// The median duration for which the gate is blocked.
fn usual_duration(times: &[f64], states: &[bool]) -> f64 {
    let rows = times.windows(2).zip(states.windows(2)).filter(|(_, states)| states[0] && !states[1]);
    median(rows.map(|(times, _)| times[1] - times[0]).collect()).unwrap_or(0.0)
}

/// Returns `true` if short and long intervals alternate as they do when a bob blocks and frees the gate.
fn alternate(times: &[f64]) -> bool {
    let mut intervals: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    intervals.sort_by(f64::total_cmp);
    let quarter = intervals.len() / 4;
    // A lower and an upper quartile; alternating intervals have half of theirs on either side.
    match (intervals.get(quarter), intervals.get(intervals.len().saturating_sub(1 + quarter))) {
        (Some(short), Some(long)) if intervals.len() >= 4 => *short < BLOCKED_PART * long,
        _ => false,
    }
}

/// Pairs edges without states: an interval much shorter than the long ones is one of a blocked gate.
fn by_duration(times: &[f64]) -> Passages {
    let intervals: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mean = intervals.iter().sum::<f64>() / count(intervals.len().max(1));
    let long = median(intervals.into_iter().filter(|&interval| interval >= mean).collect()).unwrap_or(0.0);
    let mut paired = Passages { passages: vec![], unpaired: 0, edges: true };
    let mut row = 0;
    while row < times.len() {
        match times.get(row + 1) {
            Some(&next) if next - times[row] < 0.5 * long => {
                paired.push(times[row], next);
                row += 2;
            }
            _ => {
                paired.unpaired += 1;
                row += 1;
            }
        }
    }
    paired
}

impl Passages {
    fn push(&mut self, from: f64, to: f64) {
        self.passages.push(Passage { time: 0.5 * (from + to), blocked: Some(to - from) });
    }
}
