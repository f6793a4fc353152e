//! The standard output: it takes the answer, or a picture in its place.

use super::progress::Screen;
use std::io::{self, BufWriter, StdoutLock, Write, stdout};
use std::sync::atomic::{AtomicBool, Ordering};

static TAKEN: AtomicBool = AtomicBool::new(false);

/// Keeps the standard output for what is written to `-`, so that nothing else stands there.
pub(crate) fn keep_for_files() {
    TAKEN.store(true, Ordering::Relaxed);
}

/// What of the answer goes to the standard output: all, or nothing when a file goes there.
pub(crate) struct StandardOutput(BufWriter<Screen<StdoutLock<'static>>>);

impl StandardOutput {
    pub(crate) fn new() -> Self {
        Self(BufWriter::with_capacity(1 << 16, Screen::new(stdout().lock())))
    }
}

impl Write for StandardOutput {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if TAKEN.load(Ordering::Relaxed) { Ok(bytes.len()) } else { self.0.write(bytes) }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}
