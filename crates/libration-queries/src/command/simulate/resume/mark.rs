//! Part of a result that does not depend on later times, and the data for its continuation.

use crate::output::field::{Field, Fields};
use crate::output::json;
use libration::systems::EnergyAccount;
use libration::taylor::{Checkpoint, EventCheckpoint, ModulusCheckpoint};
use serde_json::{Value, json};

/// The end of a step that does not depend on the last of the times, with the output up to it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mark {
    pub(crate) checkpoint: Checkpoint,
    pub(crate) samples: usize,
    pub(crate) events: usize,
    /// Length of a CSV file in bytes.
    pub(crate) bytes: u64,
    pub(crate) checksum: u64,
    /// The account of the energy, if there is one.
    pub(crate) energy: Option<EnergyAccount>,
    /// State of the error estimate, where errors are estimated.
    pub(crate) errors: Option<Vec<f64>>,
}

impl Mark {
    pub(super) fn fields() -> Fields<Self> {
        type Of = Field<Mark>;
        Fields::from([
            Of::value("time_s", "s", "time of the checkpoint that --resume continues from", |mark| {
                json::number(mark.checkpoint.time)
            }),
            Of::value("state[][]", "", "state there, each number as the sum of two", |mark| {
                json::list(mark.checkpoint.state.iter().map(|pair| json::numbers(pair)))
            }),
            Of::value("unit_s", "s", "unit of time of the series of the next step", |mark| {
                json::number(mark.checkpoint.unit)
            }),
            Of::value(
                "absolute_values[][]",
                "",
                "sign, sticking and leading zeros of each absolute value",
                |mark| {
                    let moduli = mark.checkpoint.moduli.iter();
                    json::list(moduli.map(|one| json!([one.sign, one.sticks, one.zeros])))
                },
            ),
            Of::value(
                "event_formulas[][]",
                "",
                "side of zero, last zero, nearness to zero and number of zeros of each event",
                |mark| {
                    let events = mark.checkpoint.events.iter();
                    json::list(events.map(|one| json!([one.side, one.last, one.near, one.found])))
                },
            ),
            Of::value("steps", "1", "steps up to there", |mark| mark.checkpoint.steps.into()),
            Of::value("samples", "1", "samples up to there", |mark| mark.samples.into()),
            Of::value("events", "1", "events up to there", |mark| mark.events.into()),
            Of::value("bytes", "1", "bytes of the CSV file up to there", |mark| mark.bytes.into()),
            Of::value("checksum", "", "checksum of those bytes, in hexadecimal digits", |mark| {
                format!("{:016x}", mark.checksum).into()
            }),
            Of::present_value(
                "errors[]",
                "",
                "source of the errors of the next states, left out where none are estimated",
                |mark| mark.errors.as_ref().map(|errors| json::numbers(errors)),
            ),
            Of::nested("energy.", &of_energy(), |mark| {
                mark.energy.as_ref().map(|account| of_energy().record(account)).into()
            }),
        ])
    }

    pub(super) fn from_json(value: &Value) -> Option<Self> {
        let checkpoint = Checkpoint {
            time: value["time_s"].as_f64()?,
            state: list(&value["state"], |pair| Some([pair[0].as_f64()?, pair[1].as_f64()?]))?,
            unit: value["unit_s"].as_f64()?,
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
            errors: match &value["errors"] {
                Value::Null => None,
                errors => Some(list(errors, Value::as_f64)?),
            },
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
    let (side, last) = (value[0].as_f64(), value[1].as_f64());
    Some(EventCheckpoint { side, last, near: value[2].as_bool()?, found: value[3].as_u64().unwrap_or(0) })
}

/// Numbers that are not finite, as of an energy without a value, are null.
fn of_energy() -> Fields<EnergyAccount> {
    type Of = Field<EnergyAccount>;
    Fields::from([
        Of::value("start[]", "", "state at which the energy balance begins", |account| {
            json::numbers(&account.start)
        }),
        Of::value("last[]", "", "state at its present end", |account| json::numbers(&account.last)),
        Of::value(
            "potential[]",
            "",
            "potential energy gained up to there, as the sum of two numbers",
            |account| json::numbers(&account.potential),
        ),
        Of::value("missed", "", "bound on the error of that potential energy beyond roundings", |account| {
            json::number(account.quadrature_error)
        }),
        Of::value("largest_change", "", "largest change of the energy since the start", |account| {
            json::number(account.largest_change)
        }),
        Of::value("largest_kinetic", "", "largest kinetic energy", |account| {
            json::number(account.largest_kinetic)
        }),
    ])
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
