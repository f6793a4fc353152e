//! Regular, chaotic, or undecided, and why.

use std::fmt;

use super::super::structure::Theorem;
use super::record::Record;
use crate::taylor::{Cause, Effort};

/// What the growth of deviations says about a motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Deviations do not grow exponentially, or cannot by a theorem.
    Regular(Regularity),
    /// Deviations grow exponentially and everywhere on a bounded motion and on its neighbours.
    Chaotic,
    /// Neither is shown.
    Undecided(Doubt),
}

/// Why a motion is regular.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Regularity {
    /// The equations allow no chaos.
    Theorem(Theorem),
    /// The motion rests in an equilibrium.
    AtRest,
    /// All neighbouring motions come nearer.
    Converging,
    /// Deviations grow no faster than in proportion to the time, as far as it was measured.
    Slow {
        /// An exponent above this would have shown.
        below: f64,
    },
}

/// Why nothing is decided.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// The motion stopped, or was interrupted.
    Stopped(Cause),
    /// The deviation has grown too little to tell exponential growth from one in proportion to the time.
    TooShort {
        /// The logarithm of the factor by which it has grown.
        growth: f64,
    },
    /// Not every part of the motion shows growth.
    Unsteady,
    /// The motion goes farther and farther.
    Unbounded,
    /// The deviation becomes so small again, as it does next to a separatrix, that its digits are lost.
    DigitsLost {
        /// The logarithm of the factor by which it has fallen.
        fall: f64,
    },
    /// A start next to this one does not show the same, as it is on an unstable motion.
    Neighbours {
        /// The exponent there.
        exponent: f64,
    },
}

/// A deviation that grows in proportion to the time doubles, ln 2 = 0.7, in twice the time; next to a resonance it may grow
/// like the time squared.
const SLOW_RISE: f64 = 1.5;
/// Passing once as near to an unstable motion as numbers can be makes e³⁷, and growth in proportion to the time adds
/// little to that.
const EXPONENTIAL_GROWTH: f64 = 100.0;
/// So many standard errors above zero.
const CERTAIN: f64 = 5.0;
/// A motion that goes farther than its first half by this factor is not bounded.
const WIDER: f64 = 1.5;

/// One measured motion.
#[derive(Clone, Debug)]
pub(super) struct Evidence {
    /// The growth of its deviation.
    pub(super) record: Record,
    /// By which factor its whole extent is wider than that of its first half.
    pub(super) widening: f64,
    /// Why it ended early.
    pub(super) stopped: Option<Cause>,
}

impl Evidence {
    /// What a single motion shows, integrated with this effort.
    pub(super) fn verdict(&self, effort: &Effort) -> Verdict {
        let record = &self.record;
        if let Some(cause) = self.stopped {
            return Verdict::Undecided(Doubt::Stopped(cause));
        }
        if record.blocks().is_empty() {
            return Verdict::Undecided(Doubt::TooShort { growth: record.growth() });
        }
        if self.converges() {
            return Verdict::Regular(Regularity::Converging);
        }
        let fall = record.largest_fall();
        if fall > largest_harmless_fall(effort) {
            return Verdict::Undecided(Doubt::DigitsLost { fall });
        }
        if record.rises().iter().all(|rise| *rise <= SLOW_RISE) {
            return Verdict::Regular(Regularity::Slow { below: 2.0 * SLOW_RISE / record.duration() });
        }
        self.doubt().map_or(Verdict::Chaotic, Verdict::Undecided)
    }

    fn converges(&self) -> bool {
        let exponent = self.record.exponent();
        exponent + CERTAIN * self.record.uncertainty() < 0.0
            && self.record.blocks().iter().all(|rate| *rate < 0.0)
    }

    /// What speaks against chaos in a motion whose deviation grows fast.
    fn doubt(&self) -> Option<Doubt> {
        let record = &self.record;
        let growth = record.growth();
        if self.widening > WIDER {
            return Some(Doubt::Unbounded);
        }
        if growth < EXPONENTIAL_GROWTH {
            return Some(Doubt::TooShort { growth });
        }
        let steady = record.blocks().iter().all(|rate| *rate > 0.0)
            && record.exponent() > CERTAIN * record.uncertainty();
        (!steady).then_some(Doubt::Unsteady)
    }

    /// Whether two motions have the same exponent.
    pub(super) fn agrees_with(&self, other: &Self) -> bool {
        let [own, others] = [self, other].map(|it| (it.record.exponent(), it.record.uncertainty()));
        (own.0 - others.0).abs() <= 0.1 * own.0.abs() + CERTAIN * libm::hypot(own.1, others.1)
    }
}

/// The largest fall of the logarithm with which digits remain.
///
/// Next to a separatrix a deviation grows as the time lag that it makes, by 1/δ at each return, where δ is the distance
/// in energy, and shrinks by √δ on the way. What a step errs in, ε of the deviation, is a distance too and comes back as
/// ε/δ of it. So by the square of its fall exceeds the growth what the equations say: by a thousandth at most.
fn largest_harmless_fall(effort: &Effort) -> f64 {
    const THOUSANDTH: f64 = 1e-3;
    0.5 * libm::log(THOUSANDTH / effort.relative.max(f64::EPSILON))
}

impl fmt::Display for Verdict {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Regular(_) => "regular",
            Self::Chaotic => "chaotic",
            Self::Undecided(_) => "undecided",
        })
    }
}

impl Verdict {
    /// The reason in a sentence.
    #[must_use]
    pub fn reason(&self) -> String {
        match self {
            Self::Regular(regularity) => regularity.to_string(),
            Self::Chaotic => {
                "deviations grow exponentially all along the motion, which stays bounded, and on two \
                              motions that begin next to it, with the same exponent"
                    .to_owned()
            }
            Self::Undecided(doubt) => doubt.to_string(),
        }
    }
}

impl fmt::Display for Regularity {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Theorem(Theorem::Plane) => formatter.write_str(
                "one coordinate without the time in its equation has a plane of states, in which there is no chaos \
                 (Poincaré and Bendixson)",
            ),
            Self::Theorem(Theorem::Linear) => {
                formatter.write_str("the equations are linear, and deviations obey them as motions do")
            }
            Self::AtRest => formatter.write_str("the motion rests in an equilibrium"),
            Self::Converging => formatter.write_str("neighbouring motions come nearer all along the motion"),
            Self::Slow { below } => write!(
                formatter,
                "deviations grow no faster than in proportion to the time, so far: an exponent above {below:.1e} would have \
                 shown"
            ),
        }
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stopped(cause) => write!(formatter, "{cause} before enough was measured"),
            Self::TooShort { growth } => write!(
                formatter,
                "the deviation has changed by the factor e^{growth:.1} only: measure longer, until e^{EXPONENTIAL_GROWTH} \
                 or until it grows in proportion to the time"
            ),
            Self::Unsteady => formatter.write_str("the growth is not steady: measure longer"),
            Self::Unbounded => formatter.write_str("the motion goes farther and farther"),
            Self::DigitsLost { fall } => write!(
                formatter,
                "the deviation shrinks by the factor e^-{fall:.1} on the way, as next to a separatrix, and loses its \
                 digits: give a smaller tolerance or another start"
            ),
            Self::Neighbours { exponent } => write!(
                formatter,
                "a motion that begins next to this one has the exponent {exponent:.3e}, so this one is exceptional: \
                 displace the start"
            ),
        }
    }
}
