//! The quantities of a periodic motion that depend on its amplitude.

use std::fmt;
use std::str::FromStr;

/// The quantity of a periodic motion that a series describes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SeriesQuantity {
    /// T/T0.
    #[default]
    Period,
    /// Ω/ω0.
    Frequency,
    /// The coefficient of cos kΩt; of sin kΩt where the phase begins at a [passage](crate::perturbation::PhaseOrigin::Passage).
    Cosine(usize),
}

/// A text that names no quantity.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown quantity `{0}`: give period, frequency, or a harmonic such as a3")]
pub struct ParseSeriesQuantityError(String);

impl fmt::Display for SeriesQuantity {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Period => formatter.write_str("period"),
            Self::Frequency => formatter.write_str("frequency"),
            Self::Cosine(k) => write!(formatter, "a{k}"),
        }
    }
}

impl FromStr for SeriesQuantity {
    type Err = ParseSeriesQuantityError;

    fn from_str(text: &str) -> Result<Self, ParseSeriesQuantityError> {
        /// Largest number of a harmonic, beyond all orders of expansions.
        const HIGHEST: usize = 10_000;
        let text = text.trim();
        match text {
            "period" => Ok(Self::Period),
            "frequency" => Ok(Self::Frequency),
            _ => {
                let harmonic = text.strip_prefix('a').and_then(|k| k.parse().ok()).filter(|k| *k <= HIGHEST);
                harmonic
                    .map(Self::Cosine)
                    .ok_or_else(|| ParseSeriesQuantityError(text.chars().take(60).collect()))
            }
        }
    }
}
