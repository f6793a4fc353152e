//! Motions with an angle that rotates in step with the drive.
//!
//! # Method
//! The angle of a rotating solution returns increased by a number of turns, which is stored in its space
//! (`Rotation` in `space.rs`). Everything else is as for other motions; the range of the angle is that of
//! its lead over a uniform rotation. Rotating solutions are searched from sixteen phases of the angle.

use super::error::BranchError;
use super::search::{Search, Start};
use super::space::{Rotation, Space};
use std::f64::consts::TAU;

/// Number of evenly spaced phases of the angle from which motions are searched.
const PHASES: u32 = 16;
/// Drive periods between two trials of Newton's method, and the number of
/// trials: attracting motions are reached, as for those of `Orbit::driven`.
const SETTLING: [u32; 2] = [10, 5];

impl Search<'_> {
    /// Returns an error unless the coordinate of a rotation is an angle.
    pub(super) fn check(&self, rotation: Rotation) -> Result<(), BranchError> {
        let names = self.equation.variables();
        match names.get(rotation.coordinate) {
            Some(_) if self.family.turning.is_angle(rotation.coordinate) => Ok(()),
            Some(name) => Err(BranchError::NotAnAngle(name.clone())),
            None => Err(BranchError::NotAnAngle(format!("of number {}", rotation.coordinate))),
        }
    }

    /// The different motions that rotate at a value of the parameter: those that Newton's method finds from all phases of the angle at the
    /// uniform speed, or from the states to which the motion from there leads.
    pub(super) fn rotating(&self, rotation: Rotation, value: f64) -> Result<Vec<Start>, BranchError> {
        let space = Space { rotation: Some(rotation), ..self.space() };
        let none = || BranchError::NoRotation { turns: rotation.turns, drive_periods: space.drive_periods() };
        let duration = self.family.duration(space, &[], &[value]).ok_or_else(none)?;
        let mut starts: Vec<(Start, Vec<Vec<f64>>)> = vec![];
        for phase in 0..PHASES {
            let angle = TAU * f64::from(phase) / f64::from(PHASES);
            let Some(start) = self.rotating_from(space, self.even(rotation, angle, duration), value) else {
                continue;
            };
            self.family.watch.go_on()?;
            /// Largest difference relative to the size of the state.
            const SAME: f64 = 1e-7;
            let sizes = self.family.sizes_of(&start.unknowns, value, 1.0);
            let is_same = |copy: &Vec<f64>| self.family.turning.are_near(copy, &start.unknowns, &sizes, SAME);
            if !starts.iter().flat_map(|(_, copies)| copies).any(is_same) {
                let copies = self.copies(&start, value).unwrap_or_default();
                starts.push((start, copies));
            }
        }
        if starts.is_empty() { Err(none()) } else { Ok(starts.into_iter().map(|(start, _)| start).collect()) }
    }

    /// The given state, rotated by an angle, at the speed of the uniform rotation.
    fn even(&self, rotation: Rotation, angle: f64, duration: f64) -> Vec<f64> {
        let layout = &self.family.layout;
        let mut state = self.given();
        state[rotation.coordinate] += angle;
        if let Some(velocity) = layout.velocity(rotation.coordinate) {
            state[velocity] = TAU * f64::from(rotation.turns) / duration;
        }
        state
    }

    fn rotating_from(&self, space: Space, mut state: Vec<f64>, value: f64) -> Option<Start> {
        let corrector = self.corrector(space);
        let mut across = vec![0.0; state.len() + 1];
        across[state.len()] = 1.0;
        let [periods, trials] = SETTLING;
        let period = self.family.drive_period(&[value])?;
        for _ in 0..trials {
            let position: Vec<f64> = state.iter().copied().chain([value]).collect();
            let units = self.family.first_units(&position, 1.0);
            if let Some(corrected) = corrector.corrected(&position, &across, &units) {
                let mut unknowns = corrected.position;
                unknowns.pop();
                let angle = &mut unknowns[space.rotation?.coordinate];
                *angle -= TAU * libm::rint(*angle / TAU);
                return Some(Start { unknowns, space });
            }
            for _ in 0..periods {
                state = self.family.moved_on(&state, value, [0.0, period])?;
            }
        }
        None
    }
}
