//! All queries of the command, for `_ask.py`, and the command itself.
//!
//! # Method
//! `libration.questions` has a function for each command, which `scripts/questions` generates from clap's description
//! (`libration_queries::questions`). Names, choices and meanings are stated in the command alone, and a test fails if Python lacks one.
//! Arguments are passed as the words of a command line (`_ask.py`). The JSON result becomes an `Answer` (`answer.py`), a mapping whose lists are
//! arrays; `Fit`, `Recording` and `Paper` are derived from it and have further methods.

use std::ffi::OsString;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use libration_queries::{
    Host, InputFile, Kind, ParameterDescription, ParameterKind, QueryError, QueryParameter, Words,
};
use pyo3::exceptions::{PyOSError, PyUnicodeDecodeError};
use pyo3::prelude::*;

use crate::errors::{MissingFile, NoAnswer, UsageError, refusal};
use crate::progress::CallProgress;

/// Name, in messages, of columns that are given in place of a file (`_ask.py`).
const TABLE: &str = "the table";

/// Collects the result and the notes of one query.
struct Conversation {
    progress: CallProgress,
    input: Vec<u8>,
    answer: Mutex<Vec<u8>>,
    notes: Mutex<Vec<String>>,
    takes_chart: bool,
    chart: Mutex<Option<ChartAsJson>>,
}

/// A function that writes the picture of a result as JSON.
type ChartAsJson = Box<dyn Fn() -> String + Send + Sync>;

/// The picture of a result, written as JSON when it is first needed.
#[pyclass(frozen, module = "libration")]
pub(crate) struct Chart(ChartAsJson);

#[pymethods]
impl Chart {
    /// The JSON of `--figure FILE.json`.
    fn json(&self, py: Python<'_>) -> String {
        py.detach(|| (self.0)())
    }
}

impl Host for Conversation {
    fn write(&self, bytes: &[u8]) -> io::Result<()> {
        self.answer.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(bytes);
        Ok(())
    }

    fn read(&self) -> Box<dyn Read + '_> {
        Box::new(&*self.input)
    }

    fn open(&self, path: &Path) -> io::Result<InputFile<'_>> {
        if path == Path::new(TABLE) && !self.input.is_empty() {
            return Ok(InputFile { size: self.input.len() as u64, bytes: Box::new(&*self.input) });
        }
        let file = File::open(path)?;
        Ok(InputFile { size: file.metadata()?.len(), bytes: Box::new(file) })
    }

    fn note(&self, sentence: &str) {
        self.notes.lock().unwrap_or_else(PoisonError::into_inner).push(sentence.to_owned());
    }

    fn words(&self) -> &dyn Words {
        &PythonWords
    }

    fn takes_chart(&self) -> bool {
        self.takes_chart
    }

    fn chart(&self, to_json: ChartAsJson) {
        *self.chart.lock().unwrap_or_else(PoisonError::into_inner) = Some(to_json);
    }

    fn progress(&self, how_far: Option<&str>) {
        if let Some(how_far) = how_far {
            self.progress.report(how_far);
        }
    }

    fn goes_on(&self) -> bool {
        !self.progress.is_cancelled()
    }
}

/// The result, its notes, the exception if the result is missing or incomplete, and its picture if that is asked for.
type Answered = (String, Vec<String>, Option<PyErr>, Option<Chart>);

/// Runs a command line and returns its result; `input` is the content of the file `-` or `the table`.
#[pyfunction]
#[pyo3(signature = (arguments, input=None, progress=None, chart=false))]
pub(crate) fn ask(
    py: Python<'_>,
    arguments: Vec<OsString>,
    input: Option<Vec<u8>>,
    progress: Option<Py<PyAny>>,
    chart: bool,
) -> PyResult<Answered> {
    let conversation = Arc::new(Conversation {
        progress: CallProgress::new(progress),
        input: input.unwrap_or_default(),
        answer: Mutex::default(),
        notes: Mutex::default(),
        takes_chart: chart,
        chart: Mutex::default(),
    });
    let answered = py.detach(|| libration_queries::ask(arguments, conversation.clone()));
    let take =
        |text: &Mutex<Vec<u8>>| std::mem::take(&mut *text.lock().unwrap_or_else(PoisonError::into_inner));
    let answer = String::from_utf8(take(&conversation.answer));
    let answer = answer.map_err(|error| PyUnicodeDecodeError::new_err(error.to_string()))?;
    let notes = std::mem::take(&mut *conversation.notes.lock().unwrap_or_else(PoisonError::into_inner));
    let stopped_by = conversation.progress.stopped_by();
    let chart = conversation.chart.lock().unwrap_or_else(PoisonError::into_inner).take().map(Chart);
    Ok((answer, notes, stopped_by.or(answered.err().map(|error| raised(py, &error))), chart))
}

/// The names of parameters and queries in the Python package.
pub(crate) struct PythonWords;

impl Words for PythonWords {
    fn parameter(&self, parameter: &QueryParameter) -> String {
        let name = parameter.name().replace('-', "_");
        let name = name.to_lowercase();
        if matches!(name.as_str(), "from" | "lambda") { name + "_" } else { name }
    }

    fn value(&self, value: &str) -> String {
        let literal = |text: &str| match text.parse::<f64>() {
            Ok(_) => text.to_owned(),
            Err(_) => format!("\"{text}\""),
        };
        let pairs = value.split(',').map(|item| item.split_once('='));
        match pairs.collect::<Option<Vec<_>>>() {
            Some(pairs) => {
                let pairs = pairs.into_iter().map(|(name, value)| format!("\"{name}\": {}", literal(value)));
                format!("{{{}}}", pairs.collect::<Vec<_>>().join(", "))
            }
            None => literal(value),
        }
    }

    fn setting(&self, parameter: &QueryParameter, values: &[String]) -> String {
        let values: Vec<_> = values.iter().map(|value| self.value(value)).collect();
        format!("{}={}", self.parameter(parameter), values.join(" or "))
    }

    fn query(&self, words: &str) -> String {
        // `list` is a built-in type of Python.
        if words == "list" {
            "questions.list_".to_owned()
        } else {
            format!("questions.{}", words.replace(' ', "_"))
        }
    }
}

/// The error as an exception, with `parameters`, `item`, `hint` and `suggestion` as attributes.
pub(crate) fn raised(py: Python<'_>, error: &QueryError) -> PyErr {
    let message = error.in_words(&PythonWords);
    let exception = match error.kind() {
        Kind::Usage => refusal::<UsageError>(message),
        Kind::NoResult | Kind::Cancelled => refusal::<NoAnswer>(message),
        Kind::MissingFile => refusal::<MissingFile>(message),
        Kind::Output(_) => return PyOSError::new_err(message),
    };
    let parameters: Vec<_> =
        error.parameters().iter().map(|parameter| PythonWords.parameter(parameter)).collect();
    let value = exception.value(py);
    let set = value
        .setattr("parameters", parameters)
        .and_then(|()| value.setattr("hint", error.hint(&PythonWords)))
        .and_then(|()| value.setattr("item", error.item()))
        .and_then(|()| value.setattr("suggestion", error.suggestion()));
    set.err().unwrap_or(exception)
}

/// Runs the command on the standard streams of the process; returns its exit status.
#[pyfunction]
pub(crate) fn program(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| libration_cli::program(arguments))
}

/// Name, kind ("argument", "option" or "flag"), placeholder of the value, whether it is
/// required, whether it may be repeated, the choices, the meaning, the type of the value.
type ParameterData = (String, &'static str, String, bool, bool, Vec<String>, String, &'static str);

/// All queries: words, purpose, remarks, parameters.
#[pyfunction]
pub(crate) fn questions() -> Vec<(String, String, String, Vec<ParameterData>)> {
    let given = |description: ParameterDescription| {
        let kind = match description.kind {
            ParameterKind::Argument => "argument",
            ParameterKind::Option => "option",
            ParameterKind::Flag => "flag",
        };
        let value_type = description.value_type.name();
        (
            description.name,
            kind,
            description.value,
            description.is_required,
            description.is_repeated,
            description.choices,
            description.meaning,
            value_type,
        )
    };
    let asked = libration_queries::questions().into_iter();
    asked
        .map(|asked| {
            (asked.words, asked.about, asked.remarks, asked.parameters.into_iter().map(given).collect())
        })
        .collect()
}
