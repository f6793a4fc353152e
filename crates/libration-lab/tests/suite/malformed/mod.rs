//! Hundreds of damaged files: each is refused with a message that names the position, or read correctly to the last bit.

mod archives;
mod damage;
mod packed;
mod single;
mod style;

use libration_lab::measurement::{Choices, MeasurementError, ReadOptions, Recording, Traces};

/// Expected result of reading a file.
pub(crate) enum Expected {
    /// Read, with exactly these times and angles.
    Read(Vec<(f64, f64)>),
    /// Refused, with these words in the message.
    Refused(Vec<String>),
    /// Read with these, or refused.
    ReadOrRefused(Vec<(f64, f64)>),
}

/// A damaged file.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
    pub(crate) expected: Expected,
}

impl Case {
    pub(crate) fn refused(name: impl Into<String>, bytes: impl Into<Vec<u8>>, words: &[&str]) -> Self {
        let words = words.iter().map(|&word| word.to_owned()).collect();
        Self { name: name.into(), bytes: bytes.into(), expected: Expected::Refused(words) }
    }

    pub(crate) fn read(name: impl Into<String>, bytes: impl Into<Vec<u8>>, rows: Vec<(f64, f64)>) -> Self {
        Self { name: name.into(), bytes: bytes.into(), expected: Expected::Read(rows) }
    }

    /// Description of the result, if it is not the expected one.
    fn complaint(&self) -> Option<String> {
        let outcome = traces(&self.bytes);
        let is_fine = match (&self.expected, &outcome) {
            (Expected::Read(rows) | Expected::ReadOrRefused(rows), Ok(recording)) => {
                rows_of(recording) == *rows
            }
            (Expected::Refused(words), Err(error)) => {
                words.iter().all(|word| error.to_string().contains(word))
            }
            (Expected::ReadOrRefused(_), Err(_)) => true,
            _ => false,
        };
        let text = match outcome {
            Ok(recording) => format!(
                "read {:?} …, {:?}",
                rows_of(&recording).iter().take(3).collect::<Vec<_>>(),
                recording.findings
            ),
            Err(error) => error.to_string(),
        };
        (!is_fine).then(|| {
            format!(
                "{}: {text}\n{}",
                self.name,
                String::from_utf8_lossy(&self.bytes[..self.bytes.len().min(200)])
            )
        })
    }
}

fn traces(bytes: &[u8]) -> Result<Traces, MeasurementError> {
    let options = ReadOptions { size_limit: 1 << 20, ..ReadOptions::default() };
    Recording::read(bytes, &options)?.traces(&Choices::default())
}

/// Times and values of all traces, one after the other.
fn rows_of(traces: &Traces) -> Vec<(f64, f64)> {
    let rows = traces.traces.iter().flat_map(|trace| trace.times().iter().zip(trace.values()));
    rows.map(|(&time, &value)| (time, value)).collect()
}

fn check(cases: &[Case]) {
    let complaints: Vec<String> = cases.iter().filter_map(Case::complaint).collect();
    assert!(complaints.is_empty(), "{} of {}:\n\n{}", complaints.len(), cases.len(), complaints.join("\n\n"));
}

#[test]
fn a_table_in_every_dialect_is_read_to_the_last_bit() {
    check(&style::whole_files());
}

#[test]
fn damaged_text_is_refused_or_read_right() {
    let cases = damage::cases();
    assert!(cases.len() >= 200, "only {}", cases.len());
    check(&cases);
}

#[test]
fn odd_files_are_refused_or_read_right() {
    check(&single::cases());
}

#[test]
fn damaged_workbooks_and_archives_are_refused_or_read_right() {
    let cases = packed::cases();
    assert!(cases.len() >= 200, "only {}", cases.len());
    check(&cases);
}

#[test]
fn archives_of_other_programs_are_read_and_hostile_ones_refused() {
    check(&archives::cases());
}
