//! Register allocation: the values that the vector registers hold.

/// The value in each register.
#[derive(Debug)]
pub(crate) struct Registers {
    held: Vec<Option<usize>>,
}

impl Registers {
    pub(crate) fn new(count: usize) -> Self {
        Self { held: vec![None; count] }
    }

    pub(crate) fn find(&self, value: usize) -> Option<usize> {
        self.held.iter().position(|held| *held == Some(value))
    }

    pub(crate) fn hold(&mut self, register: usize, value: usize) {
        self.held[register] = Some(value);
    }

    pub(crate) fn rename(&mut self, value: usize, new: usize) {
        for held in self.held.iter_mut().flatten().filter(|held| **held == value) {
            *held = new;
        }
    }

    pub(crate) fn free(&mut self, value: usize) {
        for held in &mut self.held {
            held.take_if(|held| *held == value);
        }
    }

    /// A register for a new value: an empty one, or else the one whose value is needed last. Values for which `next_use` is `None` are not
    /// displaced.
    ///
    /// Reference: L. A. Belady, IBM Syst. J. 5, 78 (1966), doi:10.1147/sj.52.0078.
    pub(crate) fn take(&self, next_use: impl Fn(usize) -> Option<usize>) -> Option<usize> {
        if let Some(empty) = self.held.iter().position(Option::is_none) {
            return Some(empty);
        }
        let candidates = self.held.iter().enumerate();
        let candidates =
            candidates.filter_map(|(register, held)| held.and_then(&next_use).map(|next| (next, register)));
        candidates.max().map(|(_, register)| register)
    }
}
