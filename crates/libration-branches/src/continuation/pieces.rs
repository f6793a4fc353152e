//! The check that a strongly unstable motion closes over its whole period, piece by piece.

use super::family::{Family, TOLERANCES};
use super::space::Space;
use libration_kernels::elementary::count;
use libration_motion::internals::periodic::{CLOSED, Frame, Nodes, Piece};
use libration_motion::taylor::OwnedStep;
use std::f64::consts::TAU;

/// A motion of a space that is to be checked.
#[derive(Clone, Copy)]
pub(super) struct Checked<'a> {
    pub(super) space: Space,
    /// The unknowns, then the parameter.
    pub(super) place: &'a [f64],
    /// The steps over the time of the space.
    pub(super) steps: &'a [OwnedStep],
    /// The direction of the branch and the errors across it, in units.
    pub(super) tangent: &'a [f64],
    pub(super) errors: &'a [f64],
    pub(super) units: &'a [f64],
}

impl Family<'_> {
    /// `true` if there is an orbit of the whole equation next to a motion, within its errors: integrated from node to node over the whole period,
    /// each piece ends where the next one begins. `growth` is that of deviations in the period.
    pub(super) fn closes_by_pieces(&self, motion: Checked<'_>, growth: f64) -> bool {
        /// The growth of deviations in a piece that is aimed at, and how often pieces are halved where it is uneven.
        const GROWTH: f64 = 1e3;
        const HALVINGS: u32 = 4;
        const MOST_PIECES: f64 = 128.0;
        let even = 2.0 * libm::ceil(libm::log(growth) / libm::log(GROWTH)).max(1.0);
        let counts = (0..HALVINGS).map(|halvings| even * libm::exp2(f64::from(halvings)));
        counts.take_while(|pieces| *pieces <= MOST_PIECES).any(|pieces| {
            self.closed_by_pieces(motion, pieces).is_some_and(|closed| {
                let found = closed.states[0].iter().chain(&closed.further);
                let off = found.zip(motion.place).map(|(a, b)| a - b);
                let allowed = motion.errors.iter().zip(motion.place).zip(motion.units);
                off.zip(allowed).all(|(off, ((error, x), unit))| {
                    off.abs() <= CLOSED * (error * unit + f64::EPSILON * x.abs())
                })
            })
        })
    }

    fn closed_by_pieces(&self, motion: Checked<'_>, pieces: f64) -> Option<Nodes> {
        let Checked { space, place, steps, tangent, units, .. } = motion;
        let numbers = self.layout.numbers();
        let (parameter, unknowns) = place.split_last()?;
        let half = self.duration(space, unknowns, &[*parameter])?;
        let times = if space.mirrored { 2.0 } else { 1.0 };
        let at = |time: f64| {
            let (time, is_mirrored) =
                if space.mirrored && time >= half { (time - half, true) } else { (time, false) };
            let step = steps.iter().find(|own| time <= own.step().end())?.step();
            let sign = |number: usize| if is_mirrored { self.signs[number] } else { 1.0 };
            Some(step.state_at(time).into_iter().enumerate().map(|(number, x)| sign(number) * x).collect())
        };
        let indices = || std::iter::successors(Some(0.0), |k| Some(k + 1.0)).take_while(|k| *k < pieces);
        let states = indices().map(|k| at(times * half * k / pieces)).collect::<Option<Vec<Vec<f64>>>>()?;
        let shift: Vec<f64> = (0..numbers).map(|number| TAU * f64::from(space.turns_of(number))).collect();
        let conditions: Vec<Vec<f64>> =
            [tangent.to_vec()].into_iter().chain(self.phase_row(unknowns, *parameter, units)).collect();
        let frame = Frame { units, shift: &shift, conditions: &conditions };
        let piece = |number: usize, state: &[f64], further: &[f64]| {
            let parameters = &further[further.len() - 1..];
            let whole = times * self.duration(space, further, parameters)?;
            let slopes = self.duration_slopes(space, parameters)?;
            let parts = [count(number), count(number + 1)].map(|k| k / pieces);
            let found = self.variations(state, parameters, parts.map(|part| whole * part), TOLERANCES[0])?;
            let [from, to] = [(state, parts[0]), (&found.end[..], parts[1])]
                .map(|(state, part)| self.rate(state, whole * part, parameters));
            let (from, to) = (from?, to?);
            let grown = |row: &Vec<f64>| row.iter().zip(&from).map(|(x, rate)| x * rate).sum::<f64>();
            // The end by the whole duration, of which both times are parts.
            let by_whole: Vec<f64> = found
                .by_start
                .iter()
                .zip(&to)
                .map(|(row, rate)| times * (parts[1] * rate - parts[0] * grown(row)))
                .collect();
            let last = further.len() - 1;
            let column = |k: usize| {
                let own = |i: usize| if k == last { found.by_parameters[0][i] } else { 0.0 };
                by_whole.iter().enumerate().map(|(i, x)| slopes[k] * x + own(i)).collect()
            };
            let by_further = (0..further.len()).map(column).collect();
            Some(Piece { by_further, end: found.end, by_start: found.by_start })
        };
        Nodes { states, further: place[numbers..].to_vec() }.closed(frame, piece)
    }

    /// The condition that a motion without a drive begins where its first coordinate turns back, to the first order and in units.
    fn phase_row(&self, unknowns: &[f64], parameter: f64, units: &[f64]) -> Option<Vec<f64>> {
        let numbers = self.layout.numbers();
        let found = self.field()?.at(self.state(unknowns), &[parameter])?;
        let (by_state, by_parameter) = found.slopes[0].split_at(numbers);
        let slopes = by_state.iter().chain(&[0.0]).chain(by_parameter);
        let row: Vec<f64> = slopes.zip(units).map(|(slope, unit)| slope * unit).collect();
        let size = row.iter().fold(0.0, |size: f64, x| libm::hypot(size, *x));
        Some(row.into_iter().map(|x| x / size).collect())
    }
}
