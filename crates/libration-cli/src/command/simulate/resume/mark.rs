//! How far an answer is certain whatever comes behind it, and what is needed to go on from there.

use libration::systems::EnergyAccount;
use libration::taylor::{Checkpoint, EventCheckpoint, ModulusCheckpoint};
use serde_json::{Value, json};

/// The end of a step that ends there whatever the last of the times is, with what was written until then.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mark {
    pub(crate) checkpoint: Checkpoint,
    pub(crate) samples: usize,
    pub(crate) events: usize,
    /// Of a CSV file.
    pub(crate) bytes: u64,
    pub(crate) checksum: u64,
    /// The account of the energy, where there is one.
    pub(crate) energy: Option<EnergyAccount>,
}

impl Mark {
    pub(super) fn to_json(&self) -> Value {
        let Checkpoint { time, state, unit, moduli, events, steps } = &self.checkpoint;
        let modulus = |it: &ModulusCheckpoint| json!([it.sign, it.sticks, it.zeros]);
        let event = |it: &EventCheckpoint| json!([it.side, it.last, it.near]);
        json!({
            "time": time,
            "state": state,
            "unit": unit,
            "absolute_values": moduli.iter().map(modulus).collect::<Vec<_>>(),
            "event_formulas": events.iter().map(event).collect::<Vec<_>>(),
            "steps": steps,
            "samples": self.samples,
            "events": self.events,
            "bytes": self.bytes,
            "checksum": format!("{:016x}", self.checksum),
            "energy": self.energy.as_ref().map(energy_to_json),
        })
    }

    pub(super) fn from_json(value: &Value) -> Option<Self> {
        let checkpoint = Checkpoint {
            time: value["time"].as_f64()?,
            state: list(&value["state"], |pair| Some([pair[0].as_f64()?, pair[1].as_f64()?]))?,
            unit: value["unit"].as_f64()?,
            moduli: list(&value["absolute_values"], modulus)?,
            events: list(&value["event_formulas"], event)?,
            steps: count(&value["steps"])?,
        };
        Some(Self {
            checkpoint,
            samples: count(&value["samples"])?,
            events: count(&value["events"])?,
            bytes: value["bytes"].as_u64()?,
            checksum: u64::from_str_radix(value["checksum"].as_str()?, 16).ok()?,
            energy: match &value["energy"] {
                Value::Null => None,
                energy => Some(energy_from_json(energy)?),
            },
        })
    }
}

fn modulus(value: &Value) -> Option<ModulusCheckpoint> {
    let (sign, sticks, zeros) = (value[0].as_f64()?, value[1].as_bool()?, count(&value[2])?);
    Some(ModulusCheckpoint { sign, sticks, zeros })
}

fn event(value: &Value) -> Option<EventCheckpoint> {
    Some(EventCheckpoint { side: value[0].as_f64(), last: value[1].as_f64(), near: value[2].as_bool()? })
}

/// Numbers that are not finite, as of an energy without a value, are null.
fn energy_to_json(account: &EnergyAccount) -> Value {
    let EnergyAccount { start, last, potential, quadrature_error, largest_change, largest_kinetic } = account;
    json!({
        "start": start,
        "last": last,
        "potential": potential,
        "missed": quadrature_error,
        "largest_change": largest_change,
        "largest_kinetic": largest_kinetic,
    })
}

fn energy_from_json(value: &Value) -> Option<EnergyAccount> {
    let number = |value: &Value| Some(value.as_f64().unwrap_or(f64::NAN));
    let potential = list(&value["potential"], number)?;
    Some(EnergyAccount {
        start: list(&value["start"], number)?,
        last: list(&value["last"], number)?,
        potential: potential.try_into().ok()?,
        quadrature_error: number(&value["missed"])?,
        largest_change: number(&value["largest_change"])?,
        largest_kinetic: number(&value["largest_kinetic"])?,
    })
}

fn list<T>(value: &Value, read: impl Fn(&Value) -> Option<T>) -> Option<Vec<T>> {
    value.as_array()?.iter().map(read).collect()
}

fn count(value: &Value) -> Option<usize> {
    usize::try_from(value.as_u64()?).ok()
}
