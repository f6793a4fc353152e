//! Environment of a run.
//!
//! # Method `libration_queries::ask` takes the words of a command line and a host: a program on a terminal (`program.rs`), Python, the page or a
//! test. Streams, signals and the width of the output belong to the host; apart from these, a run uses only the files that it reads and writes.

use crate::query_error::text::{CommandWords, Words};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// The environment of a run: receives its result, provides its standard input and files, and may cancel it.
///
/// Its methods are called on the thread that starts the run and on its worker threads. The default methods do nothing: no input, no notes, no
/// progress, and no cancellation; files and the time are those of the system.
///
/// # Examples
/// ```
/// use libration_queries::Host;
/// use std::io;
/// use std::sync::{Arc, Mutex};
///
/// #[derive(Default)]
/// struct Memory(Mutex<Vec<u8>>);
///
/// impl Host for Memory {
///     fn write(&self, bytes: &[u8]) -> io::Result<()> {
///         self.0.lock().map_err(|_| io::ErrorKind::Other)?.extend_from_slice(bytes);
///         Ok(())
///     }
/// }
///
/// let memory = Arc::new(Memory::default());
/// libration_queries::ask(["period", "60deg", "--json"].map(Into::into), memory.clone())?;
/// let answer = memory.0.lock().map_err(|_| "a thread has failed")?;
/// assert!(answer.starts_with(b"{"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Host: Send + Sync {
    /// Takes the next part of the result, or of the file that replaces it.
    ///
    /// # Errors
    /// Where no more can be taken, which ends the result.
    fn write(&self, bytes: &[u8]) -> io::Result<()>;

    /// The content of a file called `-`.
    fn read(&self) -> Box<dyn Read + '_> {
        Box::new(io::empty())
    }

    /// The file at a path.
    ///
    /// # Errors
    /// Where there is none, or it cannot be read.
    fn open(&self, path: &Path) -> io::Result<InputFile<'_>> {
        let file = File::open(path)?;
        Ok(InputFile { size: file.metadata()?.len(), bytes: Box::new(file) })
    }

    /// Returns `true` if files go to [`keep`](Self::keep) and not to the disk.
    fn keeps_files(&self) -> bool {
        false
    }

    /// Takes a complete file that the query has written.
    ///
    /// # Errors
    /// Where it cannot be taken, which is then why there is no result.
    fn keep(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let _ = (path, bytes);
        Err(io::ErrorKind::Unsupported.into())
    }

    /// The time since 1970 began, in UTC.
    fn now(&self) -> Duration {
        SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default()
    }

    /// Receives a note about a query, such as the reading of its equation.
    fn note(&self, sentence: &str) {
        let _ = sentence;
    }

    /// Returns `true` if [`chart`](Self::chart) takes the picture of a result, also where the query names no file for it.
    fn takes_chart(&self) -> bool {
        false
    }

    /// Takes the picture of a result as a function that writes it as JSON, which takes time in proportion to its points.
    fn chart(&self, to_json: Box<dyn Fn() -> String + Send + Sync>) {
        let _ = to_json;
    }

    /// The names of parameters and queries in the sentences of results.
    fn words(&self) -> &dyn Words {
        &CommandWords
    }

    /// Receives the progress of long work from time to time; `None` after it.
    fn progress(&self, how_far: Option<&str>) {
        let _ = how_far;
    }

    /// Begins to listen for a cancellation, after which the output keeps what is done.
    ///
    /// # Errors
    /// Where nobody could ask for that; the question is then refused.
    fn listen(&self) -> io::Result<()> {
        Ok(())
    }

    /// Returns `true` while a long run may continue. Called often, also by the thread that has started the run.
    fn goes_on(&self) -> bool {
        true
    }

    /// The number of columns that a table to read may have.
    fn columns(&self) -> usize {
        80
    }
}

/// A file that is read.
#[expect(missing_debug_implementations, reason = "what reads has none")]
pub struct InputFile<'a> {
    /// Stated size in bytes; pipes and devices state 0.
    pub size: u64,
    /// Content of the file.
    pub bytes: Box<dyn Read + 'a>,
}
