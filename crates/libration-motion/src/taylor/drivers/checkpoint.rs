//! The complete state of an integration between two steps.
//!
//! # Method
//! A checkpoint contains the state in two words, the unit of time, the signs of absolute values and the sides of
//! events; from these the integration continues bit for bit. A step that ends only because the last requested time
//! is near has no checkpoint: with later times it would have ended elsewhere. `simulate --resume` keeps the part of
//! a file that the last checkpoint covers and computes the rest again, so that an incomplete last line does no harm.

use crate::taylor::System;
use crate::taylor::events::contacts::Contacts;

/// The start of a step, from which an integration can be resumed bit for bit, as if it had never stopped.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// The time.
    pub time: f64,
    /// The components named by [`System::state_names`], each in two words.
    pub state: Vec<[f64; 2]>,
    /// The unit of time of the next step's series.
    pub unit: f64,
    /// State of each absolute value in the equations.
    pub moduli: Vec<ModulusCheckpoint>,
    /// State of each event.
    pub events: Vec<EventCheckpoint>,
    /// Number of steps up to here.
    pub steps: usize,
}

/// The state of the argument of an absolute value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModulusCheckpoint {
    /// The sign of the argument.
    pub sign: f64,
    /// `true` if the argument is a velocity that friction keeps at zero.
    pub sticks: bool,
    /// Number of leading coefficients of the argument that are zero.
    pub zeros: usize,
}

/// The state of the formula of an event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EventCheckpoint {
    /// The side of zero on which the formula is.
    pub side: Option<f64>,
    /// Time of the last zero.
    pub last: Option<f64>,
    /// `true` if the formula is within the tolerance of zero.
    pub near: bool,
    /// Number of zeros that counted, excluding the start.
    pub found: u64,
}

impl Checkpoint {
    /// Returns `true` if the checkpoint can belong to this system.
    pub(in crate::taylor) fn fits(&self, system: &System) -> bool {
        let numbers = self.state.iter().flatten().chain([&self.time, &self.unit]);
        let signs = self.moduli.iter().all(|modulus| modulus.sign.abs() <= 1.0);
        self.state.len() == system.layout().numbers()
            && self.moduli.len() == system.moduli()
            && self.events.len() == system.events().len()
            && numbers.into_iter().all(|number| number.is_finite())
            && self.unit > 0.0
            && signs
    }

    /// The state rounded to one word.
    pub(in crate::taylor) fn rounded_state(&self) -> Vec<f64> {
        self.state.iter().map(|[high, low]| high + low).collect()
    }
}

impl EventCheckpoint {
    pub(in crate::taylor) fn from_contacts(contacts: &Contacts) -> Self {
        let Contacts { side, last, near, zeros, .. } = *contacts;
        Self { side, last: Some(last).filter(|last| last.is_finite()), near, found: zeros }
    }

    pub(in crate::taylor) fn contacts(&self) -> Contacts {
        let last = self.last.unwrap_or(f64::NEG_INFINITY);
        Contacts { side: self.side, begun: true, last, near: self.near, zeros: self.found }
    }
}
