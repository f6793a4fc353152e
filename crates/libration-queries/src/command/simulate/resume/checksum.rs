//! A checksum that is updated byte by byte: FNV-1a with 64 bits, <https://datatracker.ietf.org/doc/html/rfc9923>.

/// The checksum of the bytes so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checksum(u64);

impl Checksum {
    /// The checksum of an empty sequence.
    pub const NONE: Self = Self(0xcbf2_9ce4_8422_2325);

    /// Updates the checksum with further bytes.
    pub fn include(&mut self, bytes: &[u8]) {
        /// The prime of the FNV hash with 64 bits.
        const PRIME: u64 = 0x0000_0100_0000_01b3;
        self.0 = bytes.iter().fold(self.0, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(PRIME));
    }

    /// The checksum as a number.
    pub fn value(self) -> u64 {
        self.0
    }
}
