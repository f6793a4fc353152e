//! Helpers that run the command.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Runs `libration` with these arguments, separated by blanks.
pub(crate) fn libration(arguments: &str) -> Output {
    run(&arguments.split_whitespace().collect::<Vec<_>>())
}

pub(crate) fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_libration")).args(arguments).output().unwrap()
}

/// The JSON result of a query that succeeds.
pub(crate) fn json(arguments: &str) -> Value {
    let output = libration(&format!("{arguments} --json"));
    assert!(output.status.success(), "{arguments}: {}", message(&output));
    let value: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(value["schema"], 2, "{arguments}");
    value
}

/// The result as text.
pub(crate) fn text(arguments: &str) -> String {
    let output = libration(arguments);
    assert!(output.status.success(), "{arguments}: {}", message(&output));
    String::from_utf8(output.stdout).unwrap()
}

/// The message of a command line that is rejected as a usage error.
pub(crate) fn refusal(arguments: &str) -> String {
    let output = libration(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments}: {}", message(&output));
    message(&output)
}

/// Text on one line, as before it was wrapped.
pub(crate) fn unfolded(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

pub(crate) fn message(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A fresh directory for this test.
pub(crate) fn directory(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

pub(crate) fn close(value: &Value, expected: f64, relative: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - expected).abs() <= relative * expected.abs(), "{value} is not {expected}");
}
