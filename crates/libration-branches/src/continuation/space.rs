//! Spaces of periodic motions, each of which is followed separately.

use super::mirror::Mirror;
use std::f64::consts::{PI, TAU};

/// Period of a motion, in halves of the drive's period, and its symmetry.
///
/// When a parameter changes, motions of one space remain in it. A fold of symmetric motions is therefore a singular point within their space,
/// while a motion that loses its symmetry or doubles its period leaves the space: the two never occur in the same equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Space {
    /// Number of halves of the drive's period after which the motion repeats itself.
    pub half_periods: u32,
    /// `true` if the motion is then its mirror image, in which all coordinates, or some of them, have the opposite sign.
    pub mirrored: bool,
    /// The angle that rotates during this time, for rotating solutions.
    pub rotation: Option<Rotation>,
    /// The turns by which the mirror image lies beside the motion, which is its own image about another place, such as the upright pendulum.
    pub(super) beside: Option<Rotation>,
}

/// An angle that returns after whole turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rotation {
    /// The index of the coordinate, from 0.
    pub coordinate: usize,
    /// Number of turns; negative for backward ones.
    pub turns: i32,
}

/// The shift in time, in halves of the drive's period, after which the mirror image of a motion is a motion too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Symmetry {
    /// No shift: a pendulum whose pivot moves up and down.
    Unshifted,
    /// Half a period: a pendulum driven by a torque.
    HalfPeriod,
}

impl Space {
    /// Space of motions with a period of this number of drive periods.
    pub(super) const fn of_periods(periods: u32) -> Self {
        Self { half_periods: 2 * periods, mirrored: false, rotation: None, beside: None }
    }

    /// Space of the symmetric motions within this one; `None` if there are none.
    pub(super) fn symmetric(self, symmetry: Option<Symmetry>) -> Option<Self> {
        let half_periods = self.half_periods / 2;
        let fits = match symmetry? {
            Symmetry::Unshifted => half_periods.is_multiple_of(2),
            Symmetry::HalfPeriod => !half_periods.is_multiple_of(2),
        };
        let may_be = fits && !self.mirrored && self.rotation.is_none();
        may_be.then_some(Self { half_periods, mirrored: true, rotation: None, beside: None })
    }

    /// The spaces contained in this one: of symmetric motions, and of motions with half the period.
    pub(super) fn within(self, symmetry: Option<Symmetry>) -> Vec<Self> {
        let turns = self.rotation.map_or(0, |rotation| rotation.turns);
        let is_even = !self.mirrored && self.half_periods.is_multiple_of(4) && turns % 2 == 0;
        let rotation = self.rotation.map(|rotation| Rotation { turns: turns / 2, ..rotation });
        let half = is_even.then_some(Self { half_periods: self.half_periods / 2, rotation, ..self });
        self.symmetric(symmetry).into_iter().chain(half).collect()
    }

    /// The space of the motions that branch off: twice as long, without a mirror.
    pub(super) fn doubled(self) -> Self {
        let rotation = self.rotation.map(Rotation::doubled);
        Self { half_periods: 2 * self.half_periods, mirrored: false, rotation, beside: None }
    }

    /// Number of drive periods in the period of the motion; a mirrored motion needs twice the time to return to its state.
    #[must_use]
    pub const fn drive_periods(self) -> u32 {
        if self.mirrored { self.half_periods } else { self.half_periods / 2 }
    }

    /// Number of turns that a component of the state has made at the end.
    pub(super) fn turns_of(self, number: usize) -> i32 {
        self.rotation.map_or(0, |rotation| rotation.turns_of(number))
    }

    /// Number of turns between the end, or its mirror image, and the start.
    pub(super) fn turns_missed(self, number: usize) -> i32 {
        self.turns_of(number) + self.turns_beside(number)
    }

    /// Number of turns between the mirror image of a component and the component.
    pub(super) fn turns_beside(self, number: usize) -> i32 {
        self.beside.map_or(0, |beside| beside.turns_of(number))
    }

    /// The only state that is its own mirror image at all times, if the image changes all components.
    pub(super) fn fixed_state(self, mirror: &Mirror) -> Option<Vec<f64>> {
        let half_turns = |(number, x): (usize, &f64)| x - PI * f64::from(self.turns_beside(number));
        mirror.fixed_state().map(|state| state.iter().enumerate().map(half_turns).collect())
    }

    /// Difference between the end, or its mirror image, and the start, without the turns.
    pub(super) fn missed(self, end: &[f64], start: &[f64], mirror: &Mirror) -> Vec<f64> {
        let image = |component: usize, x: f64| if self.mirrored { mirror.image(component, x) } else { x };
        let pairs = end.iter().zip(start).enumerate();
        pairs
            .map(|(number, (end, start))| {
                image(number, *end) - start - TAU * f64::from(self.turns_missed(number))
            })
            .collect()
    }
}

impl Rotation {
    pub(super) const fn doubled(self) -> Self {
        Self { turns: 2 * self.turns, ..self }
    }

    /// Number of turns of a coordinate; 0 for those that do not rotate.
    #[must_use]
    pub const fn turns_of(self, coordinate: usize) -> i32 {
        if coordinate == self.coordinate { self.turns } else { 0 }
    }
}
