//! A cycle as a row of the fits of T0 and β, with the errors that it shares with its neighbours.

/// A cycle with the sources of its errors.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::fit) struct CycleRow {
    /// Time of its middle.
    pub(super) time: f64,
    pub(super) period: f64,
    /// Errors of all measurements that enter it.
    pub(super) errors: Vec<Share>,
    /// Its two extremes.
    pub(super) sides: [Side; 2],
    /// The mean of T/T0 for the two half swings.
    pub(in crate::fit) ratio: f64,
}

/// Source of an independent error; rows that share it are correlated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::fit) enum Source {
    /// The time of the passage with this index.
    Passage(usize),
    /// The amplitude with this index, by an extreme or by the speed at a passage.
    Amplitude(usize),
}

/// Effect of an independent error on a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::fit) struct Share {
    pub(in crate::fit) source: Source,
    pub(in crate::fit) variance: f64,
    /// Derivative of the period with respect to the error.
    pub(in crate::fit) of_period: f64,
    /// Derivative of T/T0 with respect to the error.
    pub(in crate::fit) of_ratio: f64,
}

/// An extreme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::fit) struct Side {
    pub(super) number: usize,
    pub(super) amplitude: f64,
    pub(super) variance: f64,
    /// Derivative of the cycle's ratio with respect to this amplitude.
    pub(super) slope: f64,
}

impl Source {
    fn number(self) -> usize {
        let (Self::Passage(number) | Self::Amplitude(number)) = self;
        number
    }

    fn numbered_from(self, first: usize) -> Self {
        match self {
            Self::Passage(number) => Self::Passage(first + number),
            Self::Amplitude(number) => Self::Amplitude(first + number),
        }
    }
}

impl Share {
    /// Derivative of the period's residual with respect to the error, when the period changes by `slope` with T/T0.
    fn of_residual(&self, slope: f64) -> f64 {
        self.of_period - slope * self.of_ratio
    }
}

impl CycleRow {
    /// The mean amplitude of its two extremes, in radians.
    pub(crate) fn amplitude(&self) -> f64 {
        0.5 * (self.sides[0].amplitude + self.sides[1].amplitude)
    }

    /// The first index above those of its errors and its extremes.
    pub(super) fn next_number(&self) -> usize {
        let errors = self.errors.iter().map(|share| share.source.number());
        errors.chain(self.sides.iter().map(|side| side.number)).max().map_or(0, |last| last + 1)
    }

    /// Returns the row with errors and extremes that are counted from this index on.
    pub(super) fn numbered_from(&self, first: usize) -> Self {
        let renumbered = |share: &Share| Share { source: share.source.numbered_from(first), ..*share };
        let errors = self.errors.iter().map(renumbered).collect();
        let sides = self.sides.map(|side| Side { number: first + side.number, ..side });
        Self { errors, sides, ..*self }
    }

    /// The covariance that the noise gives two rows, when the period changes by `slope`·R′ with the amplitude.
    pub(super) fn noise_with(&self, other: &Self, slope: f64) -> f64 {
        let both = |(share, shared): (&Share, &Share)| {
            share.of_residual(slope) * shared.of_residual(slope) * share.variance
        };
        self.shared_errors(other).map(both).sum()
    }

    /// The covariance of T/T0 of one row with the noise in the residual of the period of the other.
    pub(super) fn ratio_noise_with(&self, other: &Self, slope: f64) -> f64 {
        let both =
            |(share, shared): (&Share, &Share)| share.of_ratio * shared.of_residual(slope) * share.variance;
        self.shared_errors(other).map(both).sum()
    }

    /// Variance of the ratio, from the noise of the amplitudes.
    pub(super) fn ratio_variance(&self) -> f64 {
        self.errors.iter().map(|share| share.of_ratio * share.of_ratio * share.variance).sum()
    }

    /// Variance of the period, from the noise of the passages.
    pub(super) fn period_variance(&self) -> f64 {
        self.errors.iter().map(|share| share.of_period * share.of_period * share.variance).sum()
    }

    fn shared_errors<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = (&'a Share, &'a Share)> {
        let pairs =
            self.errors.iter().flat_map(|share| other.errors.iter().map(move |shared| (share, shared)));
        pairs.filter(|(share, shared)| share.source == shared.source)
    }
}
