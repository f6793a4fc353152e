//! A cycle as a row of the fits of T0 and β.

/// A cycle with what its errors come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::fit) struct Row {
    /// Of its middle.
    pub(super) time: f64,
    pub(super) period: f64,
    /// Numbers and variances of the passages it begins and ends with.
    pub(super) passages: [(usize, f64); 2],
    /// Its two extremes.
    pub(super) sides: [Side; 2],
    /// The mean of T/T0 for the two half swings.
    pub(in crate::fit) ratio: f64,
}

/// An extreme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::fit) struct Side {
    pub(super) number: usize,
    pub(super) amplitude: f64,
    pub(super) variance: f64,
    /// What the ratio of the cycle changes by with this amplitude.
    pub(super) slope: f64,
}

impl Row {
    /// Above those of its passages and its extremes.
    pub(super) fn next_number(&self) -> usize {
        let passages = self.passages.iter().map(|(number, _)| *number);
        passages.chain(self.sides.iter().map(|side| side.number)).max().map_or(0, |last| last + 1)
    }

    /// The same with passages and extremes that are counted from this number on.
    pub(super) fn numbered_from(&self, first: usize) -> Self {
        let passages = self.passages.map(|(number, variance)| (first + number, variance));
        let sides = self.sides.map(|side| Side { number: first + side.number, ..side });
        Self { passages, sides, ..*self }
    }
}
