//! Whole turns, which change the values of coordinates and not the motion.

use super::space::Rotation;
use libration_motion::chaos::turning_groups;
use libration_numbers::expression::Equation;
use std::f64::consts::TAU;

/// The groups of coordinates that turn together without a change of the equations.
#[derive(Debug)]
pub(super) struct Turns(Vec<Vec<usize>>);

impl Turns {
    pub(super) fn of(equation: &Equation) -> Self {
        Self(turning_groups(equation))
    }

    pub(super) fn is_angle(&self, coordinate: usize) -> bool {
        self.0.iter().any(|group| **group == [coordinate])
    }

    /// The angle that differs by whole turns, if it is only one.
    pub(super) fn between(&self, differences: &[f64]) -> Option<Rotation> {
        let turns = |angle: &Vec<usize>| {
            let &[coordinate] = &angle[..] else { return None };
            #[expect(clippy::cast_possible_truncation, reason = "rounded, and saturates where no motion is")]
            let turns = libm::rint(differences[coordinate] / TAU) as i32;
            (turns != 0).then_some(Rotation { coordinate, turns })
        };
        let mut all = self.0.iter().filter_map(turns);
        all.next().filter(|_| all.next().is_none())
    }

    /// Returns `true` for a coordinate that turns with others.
    pub(super) fn is_coupled(&self, coordinate: usize) -> bool {
        self.0.iter().any(|group| group.len() > 1 && group.contains(&coordinate))
    }

    /// Subtracts whole turns from coordinates so that the means of the groups are at most half a turn.
    pub(super) fn subtract(&self, coordinates: &mut [f64], mean: impl Fn(usize) -> f64) {
        /// A mean of half a turn stays, also with a rounding error: -π and π become the same.
        const ASIDE: f64 = 1e-9;
        for group in &self.0 {
            let (sum, number) = group
                .iter()
                .fold((0.0, 0.0), |(sum, number), coordinate| (sum + mean(*coordinate), number + 1.0));
            let turns = TAU * libm::rint(sum / number / TAU - ASIDE);
            group.iter().for_each(|coordinate| coordinates[*coordinate] -= turns);
        }
    }

    /// Returns `true` if every component of two states differs, but for turns, by at most a part of its size.
    pub(super) fn are_near(&self, a: &[f64], b: &[f64], sizes: &[f64], part: f64) -> bool {
        let apart: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
        let mut without = apart.clone();
        self.subtract(&mut without, |coordinate| apart[coordinate]);
        without.iter().zip(sizes).all(|(far, size)| far.abs() <= part * size)
    }
}
