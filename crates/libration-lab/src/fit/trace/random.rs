//! Pseudo-random numbers, the same in each run.

/// The generator of S. Vigna and others, `SplitMix64` (doi:10.1145/2660193.2660195).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Returns the generator with this seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number below `limit`, which is not zero.
    pub fn below(&mut self, limit: usize) -> usize {
        let limit = limit as u64;
        #[expect(clippy::cast_possible_truncation, reason = "it is below a number of rows")]
        let number = ((u128::from(self.next()) * u128::from(limit)) >> 64) as usize;
        number
    }
}
