//! The parsers with the properties that hold for every input.

use crate::corpus;
use crate::runner::Target;
use libration::expression::{Equation, EquationError, Expression, Fault, ParseError};
use libration::quantity::{Angle, Dimension, parse};
use libration_queries::{Host, InputFile, ask};
use libration_testing::zip_archive::{Packed, archive as archive_of};
use std::ffi::OsString;
use std::io::{self, Read};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// All targets.
#[must_use]
pub fn all() -> Vec<Target> {
    let target = |name, corpus: Vec<Vec<u8>>, dictionary, run| Target { name, corpus, dictionary, run };
    vec![
        target("equation", corpus::equations(), corpus::EQUATION, equation),
        target("angle", corpus::angles(), corpus::QUANTITY, angle),
        target("quantity", corpus::quantities(), corpus::QUANTITY, quantity),
        target("table", corpus::tables(), corpus::TABLE, table),
        target("archive", corpus::archives(), corpus::TABLE, archive),
        target("resume", corpus::resumes(), corpus::RESUME, resume),
    ]
}

/// Checks that a formula survives writing: the text written for it is parsed as the same formula.
fn equation(input: &[u8]) -> Result<(), String> {
    let text = String::from_utf8_lossy(input);
    if let Ok(read) = text.parse::<Expression>() {
        let written = read.to_string();
        match written.parse::<Expression>() {
            Ok(again) => same(&written, &again.to_string())?,
            Err(error) => is_too_deep(&written, error.into())?,
        }
    }
    match text.parse::<Equation>() {
        Ok(read) => {
            let written = read.to_string();
            match written.parse::<Equation>() {
                Ok(again) => same(&written, &again.to_string()),
                Err(error) => is_too_deep(&written, error),
            }
        }
        Err(error) => is_short(&error.to_string()),
    }
}

/// Accepts the error for a formula that is nested too deeply, because written formulas have additional brackets. Returns any other error.
fn is_too_deep(written: &str, error: EquationError) -> Result<(), String> {
    match error {
        EquationError::Formula(ParseError { fault: Fault::TooDeep { .. }, .. }) => Ok(()),
        error => Err(format!("`{written}`: {error}")),
    }
}

fn same(written: &str, again: &str) -> Result<(), String> {
    if written == again { Ok(()) } else { Err(format!("`{written}` is read and written as `{again}`")) }
}

/// Checks that an angle is finite and that its part in the turn is at most π.
fn angle(input: &[u8]) -> Result<(), String> {
    let text = String::from_utf8_lossy(input);
    match text.parse::<Angle>() {
        Ok(angle) if angle.radians().is_finite() && angle.in_turn().abs() <= std::f64::consts::PI => Ok(()),
        Ok(angle) => Err(format!("read as {} rad, {} in the turn", angle.radians(), angle.in_turn())),
        Err(error) => is_short(&error.to_string()),
    }
}

/// Checks that a quantity and its uncertainty are finite.
fn quantity(input: &[u8]) -> Result<(), String> {
    let text = String::from_utf8_lossy(input);
    for dimension in [Dimension::Length, Dimension::Acceleration, Dimension::AngularVelocity] {
        match parse(&text, dimension) {
            Ok(it) if it.value.is_finite() && it.uncertainty.is_none_or(|it| it.is_finite() && it >= 0.0) => {
            }
            Ok(it) => return Err(format!("read as {} ± {:?}", it.value, it.uncertainty)),
            Err(error) => is_short(&error.to_string())?,
        }
    }
    Ok(())
}

/// Checks that a table is described as JSON or rejected with a message.
fn table(input: &[u8]) -> Result<(), String> {
    inspected("table.csv", input)
}

/// The same check for workbooks and archives.
fn archive(input: &[u8]) -> Result<(), String> {
    ["table.xlsx", "table.ods", "table.zip", "table.xls"]
        .iter()
        .try_for_each(|name| inspected(name, input))?;
    // The input as a worksheet inside an archive with valid checksums.
    inspected("table.xlsx", &corpus::workbook(input, |name, bytes| Packed::stored(name, bytes)))?;
    inspected("table.zip", &archive_of(&[Packed::stored("table.csv", input)]))
}

fn inspected(name: &str, input: &[u8]) -> Result<(), String> {
    let (output, answered) = asked(&["inspect", name, "--json"], input);
    match answered {
        Ok(()) => is_json(&output),
        Err(message) => is_short(&message),
    }
}

/// Checks that a run is continued or its file rejected with a message.
fn resume(input: &[u8]) -> Result<(), String> {
    let words =
        ["simulate", "pendulum", "--initial", "theta=1", "--times", "0,1", "--json", "--resume", "run.json"];
    let (output, answered) = asked(&words, input);
    match answered {
        Ok(()) => is_json(&output),
        Err(message) => is_short(&message),
    }
}

/// File access that returns the input for every file.
struct Files {
    input: Vec<u8>,
    output: Mutex<Vec<u8>>,
}

impl Host for Files {
    fn write(&self, bytes: &[u8]) -> io::Result<()> {
        self.output.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(bytes);
        Ok(())
    }

    fn read(&self) -> Box<dyn Read + '_> {
        Box::new(&*self.input)
    }

    fn open(&self, _: &Path) -> io::Result<InputFile<'_>> {
        Ok(InputFile { size: u64::try_from(self.input.len()).unwrap_or(0), bytes: Box::new(&*self.input) })
    }

    fn keeps_files(&self) -> bool {
        true
    }
}

fn asked(words: &[&str], input: &[u8]) -> (Vec<u8>, Result<(), String>) {
    let host = Arc::new(Files { input: input.to_vec(), output: Mutex::default() });
    let answered = ask(words.iter().map(OsString::from), host.clone());
    let output = std::mem::take(&mut *host.output.lock().unwrap_or_else(PoisonError::into_inner));
    (output, answered.map_err(|error| error.to_string()))
}

fn is_json(output: &[u8]) -> Result<(), String> {
    serde_json::from_slice::<serde_json::Value>(output).map(drop).map_err(|error| format!("no JSON: {error}"))
}

/// Checks that a message does not repeat long input and contains no control characters.
fn is_short(message: &str) -> Result<(), String> {
    if message.len() > 20_000 {
        return Err(format!("a message of {} bytes", message.len()));
    }
    match message.chars().find(|it| it.is_control() && *it != '\n') {
        Some(control) => Err(format!("the message has the control character {control:?}")),
        None => Ok(()),
    }
}
