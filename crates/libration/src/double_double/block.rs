//! Blocks of numbers that go through the stages of a batch together.

use super::DoubleDouble;

/// How many elements make a block: enough to hide the latency of long chains of dependent operations, few
/// enough to stay in the first-level cache.
pub(crate) const BLOCK: usize = 64;

/// A block of two-word numbers, word by word for the vector units. Aligned, as all that holds blocks, so that no vector crosses the lines
/// of the cache, which takes twice the time.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(crate) struct Words {
    pub(crate) hi: [f64; BLOCK],
    pub(crate) lo: [f64; BLOCK],
}

impl Words {
    pub(crate) const ZERO: Self = Self { hi: [0.0; BLOCK], lo: [0.0; BLOCK] };
    pub(crate) const ONE: Self = Self { hi: [1.0; BLOCK], lo: [0.0; BLOCK] };

    #[inline(always)]
    pub(crate) fn set(&mut self, i: usize, x: DoubleDouble) {
        (self.hi[i], self.lo[i]) = (x.hi, x.lo);
    }

    #[inline(always)]
    pub(crate) fn get(&self, i: usize) -> DoubleDouble {
        DoubleDouble::new(self.hi[i], self.lo[i])
    }
}
