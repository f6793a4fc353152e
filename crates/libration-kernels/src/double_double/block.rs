//! Blocks of numbers that go through the stages of a batch together.

use super::DoubleDouble;

/// Number of elements of a block: enough to hide the latency of long chains of dependent operations, and few enough to stay in the first-level
/// cache.
pub const BLOCK: usize = 64;

/// A block of two-word numbers, word by word for the vector units. Every type that holds blocks is aligned, so that no vector crosses two lines
/// of the cache, which would take twice the time.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Words {
    /// The leading words.
    pub hi: [f64; BLOCK],
    /// The second words.
    pub lo: [f64; BLOCK],
}

impl Words {
    /// Zeros.
    pub const ZERO: Self = Self { hi: [0.0; BLOCK], lo: [0.0; BLOCK] };
    /// Ones.
    pub const ONE: Self = Self { hi: [1.0; BLOCK], lo: [0.0; BLOCK] };

    /// Sets the number at index `i`.
    #[inline(always)]
    pub fn set(&mut self, i: usize, x: DoubleDouble) {
        (self.hi[i], self.lo[i]) = (x.hi, x.lo);
    }

    /// Returns the number at index `i`.
    #[inline(always)]
    pub fn get(&self, i: usize) -> DoubleDouble {
        DoubleDouble::new(self.hi[i], self.lo[i])
    }
}
