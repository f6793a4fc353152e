//! Memory beside the places.

/// What compiled code needs beside the places, kept from one run to the next so that it need not be asked for again.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    #[cfg(all(target_arch = "x86_64", unix))]
    memory: Vec<f64>,
}

#[cfg(all(target_arch = "x86_64", unix))]
impl Scratch {
    /// So many numbers, the first at a multiple of 64 bytes, as long loads want it; anywhere if the system cannot tell.
    pub(crate) fn numbers(&mut self, count: usize) -> &mut [f64] {
        const LINE: usize = 64;
        const MOST: usize = LINE / size_of::<f64>() - 1;
        if self.memory.len() < count + MOST {
            self.memory.resize(count + MOST, 0.0);
        }
        let first = self.memory.as_ptr().align_offset(LINE).min(MOST);
        &mut self.memory[first..first + count]
    }
}
