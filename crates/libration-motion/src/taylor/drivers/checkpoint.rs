//! All that an integration carries from step to step.
//!
//! # Method
//! A checkpoint holds the state in two words, the unit of time, the signs of absolute values and the sides of events; from these the integration
//! continues bit for bit. A step that ends only because the last requested time is near is not a checkpoint: on the way to later times it would
//! have ended elsewhere. `simulate --resume` keeps the part of a file that the last checkpoint covers and computes the rest again, so that an
//! incomplete last line does no harm.

use crate::taylor::System;
use crate::taylor::events::contacts::Contacts;

/// The start of a step, from which an integration can be resumed bit for bit as if it had never stopped.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// The time.
    pub time: f64,
    /// The numbers that [`System::state_names`] names, each in two words.
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
    /// Its sign.
    pub sign: f64,
    /// `true` if the argument is a velocity that friction keeps at zero.
    pub sticks: bool,
    /// Number of its leading coefficients that are zero.
    pub zeros: usize,
}

/// The state of the formula of an event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EventCheckpoint {
    /// The side of zero on which it is.
    pub side: Option<f64>,
    /// Time of its last zero.
    pub last: Option<f64>,
    /// `true` if the formula is within the tolerance of zero.
    pub near: bool,
    /// Number of its zeros that counted, the start excepted.
    pub found: u64,
}

impl Checkpoint {
    /// Returns whether the checkpoint can belong to this system.
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

    /// The state in one word.
    pub(in crate::taylor) fn rounded_state(&self) -> Vec<f64> {
        self.state.iter().map(|[high, low]| high + low).collect()
    }
}

impl EventCheckpoint {
    pub(in crate::taylor) fn from_contacts(contacts: &Contacts) -> Self {
        let Contacts { side, last, near, found, .. } = *contacts;
        Self { side, last: Some(last).filter(|last| last.is_finite()), near, found }
    }

    pub(in crate::taylor) fn contacts(&self) -> Contacts {
        let last = self.last.unwrap_or(f64::NEG_INFINITY);
        Contacts { side: self.side, begun: true, last, near: self.near, found: self.found }
    }
}
