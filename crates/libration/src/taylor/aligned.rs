//! Memory that begins at a line of the cache.

/// Numbers in memory, the first at a multiple of 64 bytes, so that no vector crosses two lines; anywhere if the system cannot tell.
#[derive(Debug)]
pub(super) struct Aligned {
    memory: Vec<f64>,
    first: usize,
    count: usize,
}

impl Aligned {
    /// So many zeros.
    pub(super) fn zeros(count: usize) -> Self {
        const LINE: usize = 64;
        const MOST: usize = LINE / size_of::<f64>() - 1;
        let memory = vec![0.0; count + MOST];
        let first = memory.as_ptr().align_offset(LINE).min(MOST);
        Self { memory, first, count }
    }

    #[inline(always)]
    pub(super) fn numbers(&self) -> &[f64] {
        &self.memory[self.first..self.first + self.count]
    }

    #[inline(always)]
    pub(super) fn numbers_mut(&mut self) -> &mut [f64] {
        &mut self.memory[self.first..self.first + self.count]
    }
}
