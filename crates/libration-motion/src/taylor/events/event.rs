//! Events along a motion.

use libration_numbers::expression::Expression;

/// A formula of coordinates, velocities and time whose zeros are searched. If it stays at zero, as max(x, 0) does,
/// the event is the time at which it becomes zero. A zero at the end of the motion counts as a crossing.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// The formula.
    pub formula: Expression,
    /// The kinds of zeros that count.
    pub direction: Direction,
    /// The number of the counted zero, excluding the start, at which the integration ends; `None` if the event does not end it.
    pub ends_at: Option<u64>,
}

/// The sign changes that count, in the order in which the motion is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Sign changes in both directions, and contacts without a sign change.
    Any,
    /// Crossings from negative to positive.
    Rising,
    /// Crossings from positive to negative.
    Falling,
}

/// The kind of a formula's zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// The formula becomes positive.
    Rising,
    /// The formula becomes negative.
    Falling,
    /// The formula touches zero within the tolerance and returns.
    Grazing,
    /// The formula is zero at the start of the motion.
    Start,
}

/// A zero that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Occurrence {
    /// Index into [`System::events`](crate::taylor::System::events).
    pub event: usize,
    /// The time.
    pub time: f64,
    /// Coordinates and velocities at this time.
    pub state: Vec<f64>,
    /// The kind of the zero.
    pub contact: Contact,
}

impl Event {
    /// An event for every zero of a formula; none of them ends the integration.
    #[must_use]
    pub fn zero_of(formula: Expression) -> Self {
        Self { formula, direction: Direction::Any, ends_at: None }
    }

    pub(in crate::taylor) fn counts(&self, contact: Contact) -> bool {
        match self.direction {
            Direction::Any => true,
            Direction::Rising => contact == Contact::Rising,
            Direction::Falling => contact == Contact::Falling,
        }
    }
}
