//! A checksum of bytes as they come: FNV-1a with 64 bits, <https://datatracker.ietf.org/doc/html/rfc9923>.

/// The checksum of no bytes, or of those so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Checksum(u64);

impl Checksum {
    pub(crate) const NONE: Self = Self(0xcbf2_9ce4_8422_2325);

    pub(crate) fn include(&mut self, bytes: &[u8]) {
        const PRIME: u64 = 0x0000_0100_0000_01b3;
        self.0 = bytes.iter().fold(self.0, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(PRIME));
    }

    pub(crate) fn value(self) -> u64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_checksums_come_out() {
        // RFC 9923, appendix C.
        for (text, sum) in
            [("", 0xcbf29ce484222325), ("a", 0xaf63dc4c8601ec8c), ("foobar", 0x85944171f73967e8)]
        {
            let mut checksum = Checksum::NONE;
            text.bytes().for_each(|byte| checksum.include(&[byte]));
            assert_eq!(checksum.value(), sum, "{text}");
        }
    }
}
