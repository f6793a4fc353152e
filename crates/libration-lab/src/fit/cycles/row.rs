//! A cycle as a row of the fits of T0 and β, with the errors that it shares with its neighbours.

/// A cycle with what its errors come from.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::fit) struct Row {
    /// Of its middle.
    pub(super) time: f64,
    pub(super) period: f64,
    /// Of everything that was measured for it.
    pub(super) errors: Vec<Share>,
    /// Its two extremes.
    pub(super) sides: [Side; 2],
    /// The mean of T/T0 for the two half swings.
    pub(in crate::fit) ratio: f64,
}

/// What an independent error is of; rows that share it are correlated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::fit) enum Source {
    /// Of the time of the passage of this number.
    Passage(usize),
    /// Of the amplitude of this number, by an extreme or by the speed at a passage.
    Amplitude(usize),
}

/// What an independent error does to a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::fit) struct Share {
    pub(in crate::fit) source: Source,
    pub(in crate::fit) variance: f64,
    /// What the period changes by with it.
    pub(in crate::fit) of_period: f64,
    /// What T/T0 changes by with it.
    pub(in crate::fit) of_ratio: f64,
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
    /// What is left over of the period, which changes by `slope` with T/T0, changes by this with the error.
    fn of_residual(&self, slope: f64) -> f64 {
        self.of_period - slope * self.of_ratio
    }
}

impl Row {
    /// The mean of its two extremes, in radians.
    pub(super) fn amplitude(&self) -> f64 {
        0.5 * (self.sides[0].amplitude + self.sides[1].amplitude)
    }

    /// Above those of its errors and its extremes.
    pub(super) fn next_number(&self) -> usize {
        let errors = self.errors.iter().map(|share| share.source.number());
        errors.chain(self.sides.iter().map(|side| side.number)).max().map_or(0, |last| last + 1)
    }

    /// The same with errors and extremes that are counted from this number on.
    pub(super) fn numbered_from(&self, first: usize) -> Self {
        let renumbered = |share: &Share| Share { source: share.source.numbered_from(first), ..*share };
        let errors = self.errors.iter().map(renumbered).collect();
        let sides = self.sides.map(|side| Side { number: first + side.number, ..side });
        Self { errors, sides, ..*self }
    }

    /// The covariance that the noise gives two rows, when the period changes by `slope`·R′ with the amplitude.
    pub(super) fn noise_with(&self, other: &Self, slope: f64) -> f64 {
        let both = |(own, shared): (&Share, &Share)| {
            own.of_residual(slope) * shared.of_residual(slope) * own.variance
        };
        self.shared_errors(other).map(both).sum()
    }

    /// The covariance of T/T0 of the one with what noise leaves over of the period of the other.
    pub(super) fn ratio_noise_with(&self, other: &Self, slope: f64) -> f64 {
        let both = |(own, shared): (&Share, &Share)| own.of_ratio * shared.of_residual(slope) * own.variance;
        self.shared_errors(other).map(both).sum()
    }

    /// Of the ratio, from the noise of the amplitudes.
    pub(super) fn ratio_variance(&self) -> f64 {
        self.errors.iter().map(|share| share.of_ratio * share.of_ratio * share.variance).sum()
    }

    /// Of the period, from the noise of the passages.
    pub(super) fn period_variance(&self) -> f64 {
        self.errors.iter().map(|share| share.of_period * share.of_period * share.variance).sum()
    }

    fn shared_errors<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = (&'a Share, &'a Share)> {
        let pairs = self.errors.iter().flat_map(|own| other.errors.iter().map(move |shared| (own, shared)));
        pairs.filter(|(own, shared)| own.source == shared.source)
    }
}
