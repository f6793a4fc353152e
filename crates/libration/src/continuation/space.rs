//! Spaces of periodic motions that are followed each for itself.

/// How a motion repeats itself: after so many halves of the drive's period, as it is or mirrored.
///
/// Motions of one space stay among themselves when a parameter changes. So a fold of symmetric motions is a singular point in their
/// own space, while a motion that loses its symmetry, or doubles its period, leaves it: the two never meet in one equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Space {
    /// After how many halves of the drive's period.
    pub half_periods: u32,
    /// Whether all coordinates have the opposite sign then.
    pub mirrored: bool,
}

/// The shift in time, in halves of the drive's period, with which the mirror image of a motion is a motion too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Symmetry {
    /// None: the pendulum whose pivot is shaken up and down.
    Unshifted,
    /// Half a period: the pendulum driven by a torque.
    HalfPeriod,
}

impl Space {
    /// Motions with so many periods of the drive.
    pub(super) const fn of_periods(periods: u32) -> Self {
        Self { half_periods: 2 * periods, mirrored: false }
    }

    /// Those of them that are symmetric, where there are such.
    pub(super) fn symmetric(self, symmetry: Option<Symmetry>) -> Option<Self> {
        let half_periods = self.half_periods / 2;
        let fits = match symmetry? {
            Symmetry::Unshifted => half_periods.is_multiple_of(2),
            Symmetry::HalfPeriod => !half_periods.is_multiple_of(2),
        };
        (fits && !self.mirrored).then_some(Self { half_periods, mirrored: true })
    }

    /// The spaces that are parts of this one: of symmetric motions, and of those with half the period.
    pub(super) fn within(self, symmetry: Option<Symmetry>) -> Vec<Self> {
        let is_even = !self.mirrored && self.half_periods.is_multiple_of(4);
        let half = is_even.then_some(Self { half_periods: self.half_periods / 2, ..self });
        self.symmetric(symmetry).into_iter().chain(half).collect()
    }

    /// The space into which motions go that leave this one: twice as long, without a mirror.
    pub(super) const fn doubled(self) -> Self {
        Self { half_periods: 2 * self.half_periods, mirrored: false }
    }

    /// The number of periods of the drive in one of the motion; of a mirrored motion, which takes twice the time to be as it was.
    #[must_use]
    pub const fn drive_periods(self) -> u32 {
        if self.mirrored { self.half_periods } else { self.half_periods / 2 }
    }

    pub(super) const fn sign(self) -> f64 {
        if self.mirrored { -1.0 } else { 1.0 }
    }
}
