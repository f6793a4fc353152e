//! Angles whose stated unit is impossible.

use std::f64::consts::{PI, TAU};

use super::Cycle;
use super::swings::{turns, without_spikes};
use crate::fit::angle_unit::MistakenUnit;
use crate::fit::period_table::{PeriodTable, Uncertainties};
use crate::measurement::{Observable, Trace};
use crate::statistics::median;

/// An angle that is not followed over the top jumps by a turn, and in addition by its noise.
const MORE_THAN_A_TURN: f64 = 1.1 * TAU;
const DEGREES_PER_RADIAN: f64 = 180.0 / PI;

/// Angles that swing to and fro by more than a turn, which is impossible for a free pendulum: it turns back only below the top,
/// and its energy never rises.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "{name} swings to and fro by {:.0}° to each side, and no free pendulum turns back beyond 180°: {}",
    half.to_degrees(),
    if *wrapped {
        "these angles jump by whole turns between rows too far apart to tell where: record faster, or write angles that are not wrapped"
    } else if *in_degrees {
        "these angles are degrees, not radians: give their unit as deg"
    } else {
        "check the unit of the angles, or leave out whatever is not a free swing"
    }
)]
pub struct BeyondATurn {
    /// Name of the trace.
    pub name: String,
    /// Half the change of the angle from one turning point to the next, in radians.
    pub half: f64,
    /// `true` if the numbers are angles of a pendulum when they are taken as degrees.
    pub in_degrees: bool,
    /// `true` if steps jump by whole turns, as those of angles that are wrapped at ±180° do.
    pub wrapped: bool,
}

/// Returns the amplitude and the likely reason if a trace of angles goes to and fro by more than a turn, at least twice in a row.
#[must_use]
pub fn beyond_a_turn(trace: &Trace) -> Option<BeyondATurn> {
    if trace.observable() != Observable::Angle || trace.len() < 3 {
        return None;
    }
    let calm = without_spikes(trace.values());
    let turns = turns(&calm, f64::INFINITY).ok()?;
    let swings: Vec<f64> = turns.windows(2).map(|pair| (calm[pair[1]] - calm[pair[0]]).abs()).collect();
    let both = swings.windows(2).map(|pair| pair[0].min(pair[1])).fold(0.0, f64::max);
    let largest = swings.iter().copied().fold(0.0, f64::max);
    (both > MORE_THAN_A_TURN).then(|| {
        let wrapped = is_wrapped(trace.values());
        let in_degrees = !wrapped && largest < TAU * DEGREES_PER_RADIAN;
        BeyondATurn { name: trace.name().to_owned(), half: 0.5 * both, in_degrees, wrapped }
    })
}

/// `true` if at least two steps differ by nearly a turn from those before them, and by many times the usual difference: of a smooth motion in any
/// unit the largest difference is 1.4 times the median.
fn is_wrapped(values: &[f64]) -> bool {
    const UNUSUAL: f64 = 3.0;
    const NEARLY: f64 = 1.5;
    let steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let changes: Vec<f64> = steps.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    let Some(usual) = median(changes.clone()) else { return false };
    let is_turn = |change: &&f64| (**change - TAU).abs() < NEARLY && **change > UNUSUAL * usual;
    changes.iter().filter(is_turn).count() >= 2
}

/// The unit of the angles of these cycles, of one trace or of several, if it is not the stated one: the period depends on the amplitude as for no
/// pendulum, but follows the exact law in the other unit.
#[must_use]
pub fn mistaken_unit<'a>(beta: f64, cycles: impl Iterator<Item = &'a Cycle>) -> Option<MistakenUnit> {
    let counted: Vec<&Cycle> = cycles.filter(|cycle| !cycle.outlier).collect();
    let column = |of: &dyn Fn(&Cycle) -> f64| counted.iter().map(|cycle| of(cycle)).collect::<Vec<f64>>();
    let (amplitudes, periods) = (column(&|cycle| cycle.amplitude.value), column(&|cycle| cycle.period.value));
    let of_amplitudes = column(&|cycle| cycle.amplitude.uncertainty);
    let of_periods = column(&|cycle| cycle.period.uncertainty);
    let uncertainties = Uncertainties { amplitudes: Some(&of_amplitudes), periods: Some(&of_periods) };
    let table = PeriodTable::new(&amplitudes, &periods, uncertainties).ok()?;
    MistakenUnit::of(beta, &table)
}
