//! Unfinished files of killed runs.
//!
//! A run keeps the lock of its unfinished file as long as it lives, so that those without are known to be left.

use crate::call;
use std::ffi::OsStr;
use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};

/// The name of the unfinished file of a process: `.NAME.PID.part`.
pub(super) fn name(name: &OsStr, process: u32) -> std::ffi::OsString {
    let mut hidden = std::ffi::OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{process}.part"));
    hidden
}

/// The unfinished files next to a file, of any process.
fn unfinished(path: &Path) -> Vec<PathBuf> {
    let Some(name) = path.file_name().and_then(OsStr::to_str) else { return vec![] };
    let is_one = |other: &OsStr| {
        let middle = other.to_str().and_then(|other| {
            other.strip_prefix('.')?.strip_prefix(name)?.strip_prefix('.')?.strip_suffix(".part")
        });
        middle.is_some_and(|process| !process.is_empty() && process.bytes().all(|byte| byte.is_ascii_digit()))
    };
    let directory = path.parent().filter(|directory| !directory.as_os_str().is_empty());
    let Ok(entries) = fs::read_dir(directory.unwrap_or(Path::new("."))) else { return vec![] };
    let names = entries.filter_map(Result::ok).map(|entry| entry.file_name());
    names.filter(|name| is_one(name)).map(|name| path.with_file_name(name)).collect()
}

/// An unfinished file of an ended run, locked for other runs as long as this value lives.
#[derive(Debug)]
pub(crate) struct Leftover {
    pub(crate) path: PathBuf,
    _locked: File,
}

/// The files that ended runs have left next to a file.
pub(crate) fn beside(path: &Path) -> Vec<Leftover> {
    unfinished(path).into_iter().filter_map(taken).collect()
}

fn taken(path: PathBuf) -> Option<Leftover> {
    let file = File::open(&path).ok()?;
    match file.try_lock() {
        Ok(()) => Some(Leftover { path, _locked: file }),
        // Somebody writes it, or nobody can tell.
        Err(TryLockError::WouldBlock | TryLockError::Error(_)) => None,
    }
}

/// Removes unfinished files of killed runs, with a note.
pub(super) fn remove(path: &Path) {
    for leftover in beside(path) {
        let removed = fs::remove_file(&leftover.path);
        // Of most there is none, nor an unfinished one.
        let state = state_of(&leftover.path);
        let _ = fs::remove_file(&state);
        for unfinished in beside(&state) {
            let _ = fs::remove_file(&unfinished.path);
        }
        if removed.is_ok() {
            let name = leftover.path.display();
            call::current().note(&format!("removed {name}, left by a killed run"));
        }
    }
}

/// The file with the data for the continuation of a file of samples: `NAME.state`.
pub(crate) fn state_of(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".state");
    name.into()
}
