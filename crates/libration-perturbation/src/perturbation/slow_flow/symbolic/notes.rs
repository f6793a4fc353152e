//! The reasons why formulas of steady states are not given.

use super::criteria::ResponseCurve;
use super::letters::{Column, Sum};
use super::result::{MOST_TERMS, SteadyState};
use super::steady::{Obstacle, Steady};

/// The notes on a state, after those that it has.
pub(super) fn notes(state: &SteadyState, is_driven: bool, steady: &Steady) -> Vec<String> {
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
    if let Some(reason) = steady.obstacle.and_then(|it| of_obstacle(it, state, steady)) {
        note(reason);
    }
    if state.relation.is_some() && state.critical_drive.is_none() {
        note("critical_drive: known for linear damping, a cubic backbone and one drive".to_owned());
    }
    notes
}

fn too_long() -> String {
    format!("relation: it has more than {MOST_TERMS} terms; use `equations`")
}

fn of_obstacle(obstacle: Obstacle, state: &SteadyState, steady: &Steady) -> Option<String> {
    let Steady { order, coupling, .. } = steady;
    let curve = "backbone, peak_amplitude, folds, critical_drive";
    let is_known = state.relation.is_some();
    Some(match obstacle {
        Obstacle::Absent => format!(
            "relation, phase, {curve}, trace, determinant: the phase does not occur to order {order}, at which the drive \
             changes neither amplitude nor phase"
        ),
        Obstacle::Order(needed) => format!(
            "relation, {curve}, determinant: the phase occurs from order {coupling} on, and these need order {needed}, or use \
             `equations`"
        ),
        Obstacle::Harmonics if is_known => format!(
            "trace, determinant, phase, {curve}: several harmonics of the phase occur; use `equations`"
        ),
        Obstacle::Harmonics => format!(
            "relation, trace, determinant, phase, {curve}: several harmonics of the phase occur; use `equations`"
        ),
        Obstacle::Sums if state.trace.is_some() => {
            "phase: its cosine and sine are quotients of sums; use `equations`".to_owned()
        }
        Obstacle::Sums if is_known => {
            "trace, determinant, phase: they are quotients of sums; use `equations`".to_owned()
        }
        Obstacle::Sums => format!(
            "relation, trace, determinant, phase, {curve}: they are quotients of sums, unless the drive is one sine or cosine; \
             use `equations`"
        ),
        Obstacle::Undetermined if is_known => {
            "trace, determinant, phase: the lowest order with the phase does not determine it; use `equations`".to_owned()
        }
        Obstacle::Undetermined => format!(
            "relation, trace, determinant, phase, {curve}: the lowest order with the phase does not determine it; use `equations`"
        ),
    })
}

/// The reason why a curve has no largest amplitude, or none that is given.
pub(super) fn peak_note(curve: &ResponseCurve<'_>, backbone: Option<&Sum>) -> String {
    let amplitude = curve.letters.place(Column::Amplitude);
    let is_level =
        |backbone: &Sum| curve.on_ridge(backbone).half_powers().all(|(powers, _)| powers[amplitude] == 0);
    let reason = match backbone {
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
