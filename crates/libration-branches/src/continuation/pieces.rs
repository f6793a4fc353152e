//! Check, piece by piece, that a strongly unstable motion closes over its whole period.

use super::family::{Family, TOLERANCES};
use super::space::Space;
use libration_motion::internals::periodic::{Checked, Frame, Piece, norm};
use libration_motion::taylor::OwnedStep;
use std::f64::consts::TAU;

/// A motion of a space whose closure is checked.
#[derive(Clone, Copy)]
pub(super) struct MotionToCheck<'a> {
    pub(super) space: Space,
    /// The unknowns, then the parameter.
    pub(super) position: &'a [f64],
    /// The steps over the time of the space.
    pub(super) steps: &'a [OwnedStep],
    /// The direction of the branch and the errors perpendicular to it, in scaled units.
    pub(super) tangent: &'a [f64],
    pub(super) errors: &'a [f64],
    pub(super) units: &'a [f64],
}

impl Family<'_> {
    /// `true` if there is an orbit of the whole equation near a motion, within its errors, by
    /// integration piece by piece over the whole period. `growth` is that of deviations over the period.
    pub(super) fn closes_by_pieces(&self, motion: MotionToCheck<'_>, growth: f64) -> bool {
        let MotionToCheck { space, position, steps, tangent, errors, units } = motion;
        let Some((&parameter, unknowns)) = position.split_last() else { return false };
        let Some(half) = self.duration(space, unknowns, &[parameter]) else { return false };
        let times = if space.mirrored { 2.0 } else { 1.0 };
        let state_at = |part: f64| {
            let time = times * half * part;
            let (time, is_mirrored) =
                if space.mirrored && time >= half { (time - half, true) } else { (time, false) };
            let step = steps.iter().find(|owned| time <= owned.step().end())?.step();
            let state = step.state_at(time);
            if !is_mirrored {
                return Some(state);
            }
            let image = self.mirror.image_of(&state);
            let beside = |(number, x)| x - TAU * f64::from(space.turns_beside(number));
            Some(image.into_iter().enumerate().map(beside).collect())
        };
        let turns = |number: usize| TAU * f64::from(space.turns_of(number));
        let shift: Vec<f64> = (0..self.layout.numbers()).map(turns).collect();
        let conditions: Vec<Vec<f64>> =
            [tangent.to_vec()].into_iter().chain(self.phase_row(unknowns, parameter, units)).collect();
        let frame = Frame { units, shift: &shift, conditions: &conditions };
        let piece = |parts: [f64; 2], state: &[f64], further: &[f64]| {
            let parameters = &further[further.len() - 1..];
            let whole = times * self.duration(space, further, parameters)?;
            let slopes = self.duration_slopes(space, parameters)?;
            let integrated =
                self.variations(state, parameters, parts.map(|part| whole * part), TOLERANCES[0])?;
            let by_whole = Piece::by_duration(
                &integrated.by_start,
                integrated.rates.each_ref().map(|rate| &rate[..]),
                parts,
            );
            let last = further.len() - 1;
            let column = |k: usize| {
                let by_value = |i: usize| if k == last { integrated.by_parameters[0][i] } else { 0.0 };
                by_whole.iter().enumerate().map(|(i, x)| slopes[k] * (times * x) + by_value(i)).collect()
            };
            let by_further = (0..further.len()).map(column).collect();
            Some(Piece { by_further, end: integrated.end, by_start: integrated.by_start })
        };
        Checked { frame, position, errors, growth }.closes(state_at, piece)
    }

    /// The linearised condition, in scaled units, that an autonomous motion begins where its first coordinate turns back.
    fn phase_row(&self, unknowns: &[f64], parameter: f64, units: &[f64]) -> Option<Vec<f64>> {
        let numbers = self.layout.numbers();
        let rates = self.field()?.at(self.state(unknowns), &[parameter])?;
        let (by_state, by_parameter) = rates.slopes[0].split_at(numbers);
        let slopes = by_state.iter().chain(&[0.0]).chain(by_parameter);
        let row: Vec<f64> = slopes.zip(units).map(|(slope, unit)| slope * unit).collect();
        let size = norm(&row);
        Some(row.into_iter().map(|x| x / size).collect())
    }
}
