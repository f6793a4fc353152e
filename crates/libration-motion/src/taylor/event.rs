//! What can happen on the way.

use libration_numbers::expression::Expression;

/// A formula of coordinates, velocities and time whose zeros are looked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// The formula.
    pub formula: Expression,
    /// Which of its zeros count.
    pub direction: Direction,
    /// At the how-manieth of those that count the integration ends, the start apart; never if there is none.
    pub ends_at: Option<u64>,
}

/// Which changes of sign count, in the order in which the motion is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Both, and contacts without a change of sign.
    Any,
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
}

/// How a formula is zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// It becomes positive.
    Rising,
    /// It becomes negative.
    Falling,
    /// Within the tolerance it touches zero and returns.
    Grazing,
    /// The motion begins there.
    Start,
}

/// An event that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Occurrence {
    /// Which one of [`System::events`](super::System::events).
    pub event: usize,
    /// When.
    pub time: f64,
    /// Coordinates and velocities there.
    pub state: Vec<f64>,
    /// How.
    pub contact: Contact,
}

impl Event {
    /// Every zero of a formula; none of them ends the integration.
    #[must_use]
    pub fn zero_of(formula: Expression) -> Self {
        Self { formula, direction: Direction::Any, ends_at: None }
    }

    pub(super) fn counts(&self, contact: Contact) -> bool {
        match self.direction {
            Direction::Any => true,
            Direction::Rising => contact == Contact::Rising,
            Direction::Falling => contact == Contact::Falling,
        }
    }
}
