//! Memory that begins at a line of the cache.

/// Numbers in memory. The first one stands at a multiple of 64 bytes, so that no vector crosses two lines of the cache; if `align_offset` cannot
/// find the multiple, the numbers are right and only slower.
///
/// ```
/// let numbers = libration_jit::Aligned::zeros(3);
/// assert_eq!(numbers.numbers(), [0.0; 3]);
/// ```
#[derive(Debug, Default)]
pub struct Aligned {
    memory: Vec<f64>,
    first: usize,
    count: usize,
}

impl Aligned {
    /// A vector of `count` zeros.
    #[must_use]
    pub fn zeros(count: usize) -> Self {
        /// Bytes of a cache line.
        const LINE: usize = 64;
        const MOST: usize = LINE / size_of::<f64>() - 1;
        let memory = vec![0.0; count + MOST];
        let first = memory.as_ptr().align_offset(LINE).min(MOST);
        Self { memory, first, count }
    }

    /// The numbers.
    #[must_use]
    #[inline(always)]
    pub fn numbers(&self) -> &[f64] {
        &self.memory[self.first..self.first + self.count]
    }

    /// The numbers, for writing.
    #[must_use]
    #[inline(always)]
    pub fn numbers_mut(&mut self) -> &mut [f64] {
        &mut self.memory[self.first..self.first + self.count]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_number_is_at_a_line_of_the_cache() {
        for count in 0..20 {
            let mut numbers = Aligned::zeros(count);
            assert_eq!(numbers.numbers_mut().len(), count);
            assert_eq!(numbers.numbers().as_ptr().addr() % 64, 0);
        }
    }
}
