//! The output of a query: the result, or a picture in its place.

use crate::call::{self, Output};
use std::io::{self, BufWriter, Write};

/// Keeps the output for files written to `-`, so that nothing else is written to it.
pub(crate) fn keep_for_files() {
    call::current().take_output();
}

/// The standard output of a result: all of it, or nothing if a file is written there.
pub(crate) struct StandardOutput(BufWriter<Output>);

impl StandardOutput {
    pub(crate) fn new() -> Self {
        Self(BufWriter::with_capacity(1 << 16, Output::new()))
    }
}

impl Write for StandardOutput {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.0.get_ref().is_taken() { Ok(bytes.len()) } else { self.0.write(bytes) }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}
