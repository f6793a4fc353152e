//! The reasons for missing formulas of steady states.

use super::criteria::ResponseCurve;
use super::error::MAX_SYMBOLIC_SLOW_ORDER;
use super::letters::{Column, Sum};
use super::steady::{Obstacle, Steady};
use super::steady_state::{MOST_TERMS, SteadyState};

/// The notes on a state, after those that it has; `highest` is the highest order of the flow with forces that have kinks.
pub(super) fn notes(
    state: &SteadyState,
    is_driven: bool,
    steady: &Steady,
    highest: Option<i64>,
) -> Vec<String> {
    let mut notes = state.notes.clone();
    let mut note = |text: String| notes.push(text);
    let is_long = |sum: &Option<Sum>, text: &Option<String>| sum.is_some() && text.is_none();
    if !is_driven {
        match &steady.relation {
            None => note(format!(
                "relation: to order {} the amplitude does not change, every amplitude is steady",
                steady.order
            )),
            Some(sum) if state.relation.is_none() && sum.half_powers().count() <= MOST_TERMS => {
                note("relation: dA/dt is one power of A, no amplitude but zero is steady".to_owned());
            }
            Some(_) if state.relation.is_none() => note(too_long()),
            Some(_) => {}
        }
        note("peak_amplitude, folds, critical_drive, determinant: there is no drive".to_owned());
        return notes;
    }
    if is_long(&steady.relation, &state.relation) {
        note(too_long());
    }
    let missing = |obstacle| missing(obstacle, state, steady).join(", ");
    if let Some((obstacle, formulas)) = steady
        .obstacle
        .map(|obstacle| (obstacle, missing(obstacle)))
        .filter(|(_, formulas)| !formulas.is_empty())
    {
        note(format!("{formulas}: {}", reason(obstacle, steady, highest)));
    }
    let is_curve =
        steady.obstacle.is_none_or(|obstacle| obstacle == Obstacle::Sums) && steady.relation.is_some();
    if is_curve && state.critical_drive.is_none() {
        note("critical_drive: known for linear damping, a cubic backbone and one drive".to_owned());
    }
    notes
}

fn too_long() -> String {
    format!("relation: it has more than {MOST_TERMS} terms; use `equations`")
}

fn reason(obstacle: Obstacle, steady: &Steady, highest: Option<i64>) -> String {
    let Steady { order, coupling, .. } = steady;
    let most = i64::try_from(MAX_SYMBOLIC_SLOW_ORDER).unwrap_or(i64::MAX);
    let most = highest.map_or(most, |highest| highest.min(most));
    match obstacle {
        Obstacle::Absent => format!(
            "the phase does not occur to order {order}, at which the drive changes neither amplitude nor phase"
        ),
        Obstacle::Order(needed) => {
            let is_possible = needed <= most;
            let limit =
                if is_possible { "or higher".to_owned() } else { format!("above the highest, {most}") };
            format!(
                "the phase occurs from order {coupling} on, and these need order {needed} {limit}; use `equations`"
            )
        }
        Obstacle::Harmonics => "several harmonics of the phase occur; use `equations`".to_owned(),
        Obstacle::Sums => "no sums of products, unless the drive is one cosine; use `equations`".to_owned(),
        Obstacle::Undetermined => {
            "the lowest order with the phase does not determine it; use `equations`".to_owned()
        }
    }
}

/// The names of formulas that are missing because of the obstacle.
fn missing(obstacle: Obstacle, state: &SteadyState, steady: &Steady) -> Vec<&'static str> {
    let of_relation = steady.relation.is_none() || obstacle != Obstacle::Sums;
    let names = [
        ("relation", steady.relation.is_none()),
        ("phase", state.phase.is_none()),
        ("trace", state.trace.is_none()),
        ("determinant", state.determinant.is_none()),
        ("backbone", of_relation),
        ("peak_amplitude", of_relation),
        ("folds", of_relation),
        ("critical_drive", of_relation),
    ];
    names.into_iter().filter(|(_, is_missing)| *is_missing).map(|(name, _)| name).collect()
}

/// The reason why the largest amplitude of a curve is infinite or not given.
pub(super) fn peak_note(curve: &ResponseCurve<'_>, backbone: Option<&Sum>, steady: &Steady) -> String {
    let amplitude = curve.letters.index(Column::Amplitude);
    let is_level =
        |backbone: &Sum| curve.on_ridge(backbone).half_powers().all(|(powers, _)| powers[amplitude] == 0);
    let reason = match backbone {
        _ if steady.order < steady.complete => {
            return format!("peak_amplitude: damping enters the relation from order {} on", steady.complete);
        }
        None => "the backbone is not known",
        Some(backbone) if is_level(backbone) => {
            "on the backbone the relation does not depend on the amplitude, so that none is the largest"
        }
        Some(_) => {
            "not found as a sum of products or the root of one; `relation` at the backbone is zero there"
        }
    };
    format!("peak_amplitude: {reason}")
}
