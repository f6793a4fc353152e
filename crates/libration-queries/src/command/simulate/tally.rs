//! Output with a count of its bytes.

use super::resume::Checksum;
use std::io::{self, Write};

/// Counts bytes on their way.
pub(super) struct Tally<'a> {
    out: &'a mut dyn Write,
    pub(super) bytes: u64,
    pub(super) checksum: Checksum,
}

impl<'a> Tally<'a> {
    pub(super) fn new(out: &'a mut dyn Write) -> Self {
        Self { out, bytes: 0, checksum: Checksum::NONE }
    }
}

impl Write for Tally<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.out.write(bytes)?;
        self.bytes += u64::try_from(written).unwrap_or(u64::MAX);
        self.checksum.include(&bytes[..written]);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}
