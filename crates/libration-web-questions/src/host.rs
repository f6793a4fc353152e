//! The page as the host of a run: its files are in memory, its clock is that of the browser.

use crate::page;
use libration_queries::{Host, InputFile, MarkedWords, Words};
use std::collections::BTreeMap;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// The host of a query with its files; the file called `-` is the standard input.
#[derive(Debug)]
pub(crate) struct PageHost {
    files: BTreeMap<PathBuf, Vec<u8>>,
    /// Time of the next question to the page about a cancellation.
    due: Mutex<Duration>,
}

/// Interval between these questions.
const PAUSE: Duration = Duration::from_millis(50);

impl PageHost {
    pub(crate) fn new(files: BTreeMap<PathBuf, Vec<u8>>) -> Self {
        Self { files, due: Mutex::new(Duration::ZERO) }
    }
}

impl Host for PageHost {
    fn write(&self, bytes: &[u8]) -> io::Result<()> {
        page::output(bytes);
        Ok(())
    }

    fn read(&self) -> Box<dyn Read + '_> {
        Box::new(self.files.get(Path::new("-")).map_or(&[][..], Vec::as_slice))
    }

    fn open(&self, path: &Path) -> io::Result<InputFile<'_>> {
        let bytes = self.files.get(path).ok_or_else(|| {
            io::Error::new(io::ErrorKind::NotFound, "no file of this name was given to the page")
        })?;
        Ok(InputFile { size: bytes.len() as u64, bytes: Box::new(bytes.as_slice()) })
    }

    fn keeps_files(&self) -> bool {
        true
    }

    fn keep(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        page::written(&path.to_string_lossy(), bytes);
        Ok(())
    }

    fn goes_on(&self) -> bool {
        let (mut due, now) = (self.due.lock().unwrap_or_else(PoisonError::into_inner), self.now());
        if now < *due {
            return true;
        }
        *due = now + PAUSE;
        drop(due);
        page::goes_on()
    }

    fn now(&self) -> Duration {
        Duration::try_from_secs_f64(page::milliseconds() / 1000.0).unwrap_or_default()
    }

    fn words(&self) -> &dyn Words {
        &MarkedWords
    }

    fn note(&self, sentence: &str) {
        page::note(sentence);
    }

    fn progress(&self, how_far: Option<&str>) {
        page::progress(how_far.unwrap_or_default());
    }
}
