//! The verdict: regular, chaotic or undecided, with the reason.

use std::fmt;

use super::super::extent::Extent;
use super::super::structure::Theorem;
use super::record::Record;
use crate::taylor::{Cause, Effort};

/// The conclusion from the growth of deviations about a motion.
#[derive(Clone, Debug, PartialEq)]
pub enum LyapunovVerdict {
    /// Deviations do not grow exponentially, or cannot by a theorem.
    Regular(Regularity),
    /// Deviations grow exponentially throughout a bounded motion and its neighbours.
    Chaotic,
    /// Neither is established.
    Undecided(Doubt),
}

/// The reason why a motion is regular.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Regularity {
    /// The equations exclude chaos.
    Theorem(Theorem),
    /// The motion is at an equilibrium.
    AtRest,
    /// All neighbouring motions converge to the motion.
    Converging,
    /// Deviations grow at most in proportion to the time, within the measured time.
    Slow {
        /// Exponents above this value would have been detected.
        below: f64,
    },
}

/// The reason why the verdict is undecided.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// The motion stopped, or was interrupted.
    Stopped(Cause),
    /// The deviation has grown too little to distinguish exponential growth from growth in proportion to the time.
    TooShort {
        /// The logarithm of the factor of growth.
        growth: f64,
    },
    /// Some part of the motion shows no growth.
    Unsteady,
    /// The motion covers an ever larger range.
    Unbounded,
    /// The deviation becomes so small in between, as next to a separatrix, that its digits are lost.
    DigitsLost {
        /// The logarithm of the factor by which it shrinks before it grows again.
        valley: f64,
    },
    /// A neighbouring start gives another result, so that the motion is an unstable one.
    Neighbours {
        /// The exponent of the neighbouring motion.
        exponent: f64,
    },
}

// The figures for measured motions come from a damped driven pendulum (A from 0.5 to 1.5), an undamped one driven weakly and strongly, the
// Hénon–Heiles system at E = 1/12, 1/8 and 1/6, driven Duffing oscillators and coupled quartic ones: 48 starts, of which 27 were regular with
// 100, 300 and 1000 intervals alike (6 converged). With 1000 intervals 18 were chaotic, and 3 weakly chaotic ones undecided.

/// A deviation that grows in proportion to the time doubles in twice the time, ln 2 = 0.7; next to a resonance
/// it may grow like the square of the time. For regular motions that do not converge the larger rise was at most
/// 1.20 (0.56 to 0.91 with 1000 intervals), for the others at least 13.6 with 100 intervals and 69 with 1000.
const SLOW_RISE: f64 = 1.5;
/// A single passage of an unstable motion, at the smallest distance that numbers allow, produces e³⁷; growth
/// in proportion to the time adds little to that. Of the 21 motions that are not regular, 20 had grown by less
/// than e¹⁰⁰ with 100 intervals, 2 with 300, none with 1000; the regular ones had grown by at most e^4.1.
const EXPONENTIAL_GROWTH: f64 = 100.0;
/// Number of standard errors above zero: for the mean of ten blocks, Student's t exceeds it by chance in 4 of 10 000 cases. For regular motions
/// the exponent was up to 4.9 standard errors above zero, since it falls to zero as (ln t)/t.
const CERTAIN: f64 = 5.0;
/// Factor by which the range of an unbounded motion exceeds that of its first half: a steady drift gives two, a motion that has covered its
/// whole range gives one. For bounded motions it was up to 1.44 with 100 intervals, 1.34 with 300 and 1.05 with 1000.
const WIDER: f64 = 1.5;

/// One measured motion.
#[derive(Clone, Debug)]
#[doc(hidden)]
pub struct Evidence {
    /// The growth of the deviation.
    pub record: Record,
    /// The range of the motion in the first half of the time, and in the whole time.
    extents: [Extent; 2],
    /// The cause for which the motion ended early.
    pub stopped: Option<Cause>,
}

impl Evidence {
    /// The evidence before the first interval.
    pub fn new(interval: f64, numbers: usize) -> Self {
        let nothing = Extent::new(numbers);
        Self { record: Record::new(interval), extents: [nothing.clone(), nothing], stopped: None }
    }

    /// Adds the growth in one of `of` intervals, and the state at its end.
    pub fn add(&mut self, growth: f64, state: &[f64], of: usize) {
        self.record.push(growth);
        let first_half = 2 * self.record.intervals() <= of;
        self.extents.iter_mut().skip(usize::from(!first_half)).for_each(|extent| extent.include(state));
    }

    /// The largest factor by which the range of a component exceeds that of the first half.
    fn widening(&self, unconfined: &[bool]) -> f64 {
        let [half, whole] = self.extents.each_ref().map(Extent::widths);
        let free = unconfined.iter().copied().chain(std::iter::repeat(false));
        let confined = half.iter().zip(&whole).zip(free).filter(|(_, free)| !free);
        confined.map(|((half, whole), _)| if whole > half { whole / half } else { 1.0 }).fold(1.0, f64::max)
    }

    /// The verdict on a single motion, integrated to these tolerances. Unconfined components may grow without bound.
    pub fn verdict(&self, effort: &Effort, unconfined: &[bool]) -> LyapunovVerdict {
        let record = &self.record;
        if let Some(cause) = self.stopped {
            return LyapunovVerdict::Undecided(Doubt::Stopped(cause));
        }
        if record.blocks().is_empty() {
            return LyapunovVerdict::Undecided(Doubt::TooShort { growth: record.growth() });
        }
        if self.converges() {
            return LyapunovVerdict::Regular(Regularity::Converging);
        }
        let valley = record.deepest_valley();
        if valley > deepest_harmless_valley(effort) {
            return LyapunovVerdict::Undecided(Doubt::DigitsLost { valley });
        }
        if record.rises().iter().all(|rise| *rise <= SLOW_RISE) {
            return LyapunovVerdict::Regular(Regularity::Slow { below: 2.0 * SLOW_RISE / record.duration() });
        }
        self.doubt(unconfined).map_or(LyapunovVerdict::Chaotic, LyapunovVerdict::Undecided)
    }

    fn converges(&self) -> bool {
        let exponent = self.record.exponent();
        exponent + CERTAIN * self.record.variation() < 0.0
            && self.record.blocks().iter().all(|rate| *rate < 0.0)
    }

    /// The reason against chaos in a motion whose deviation grows fast.
    fn doubt(&self, unconfined: &[bool]) -> Option<Doubt> {
        let record = &self.record;
        let growth = record.growth();
        if self.widening(unconfined) > WIDER {
            return Some(Doubt::Unbounded);
        }
        if growth < EXPONENTIAL_GROWTH {
            return Some(Doubt::TooShort { growth });
        }
        let steady = record.blocks().iter().all(|rate| *rate > 0.0)
            && record.exponent() > CERTAIN * record.variation();
        (!steady).then_some(Doubt::Unsteady)
    }

    /// Returns `true` if the exponents of two motions are of the same size, within their errors.
    pub fn agrees_with(&self, other: &Self) -> bool {
        let [here, others] =
            [self, other].map(|verdict| (verdict.record.exponent(), verdict.record.variation()));
        (here.0 - others.0).abs() <= 0.5 * here.0.max(others.0) + CERTAIN * libm::hypot(here.1, others.1)
    }
}

/// The deepest valley of the logarithm that leaves significant digits.
///
/// Next to a separatrix a deviation is a time lag. It grows by 1/δ at each return, where δ is the distance in energy,
/// and shrinks by √δ in between. An error of a step, ε relative to the deviation, is a distance too and returns as
/// ε/δ of it. With the depth ln 1/√δ of the valley this is ε·e^(2·depth), which may be up to a thousandth.
fn deepest_harmless_valley(effort: &Effort) -> f64 {
    const THOUSANDTH: f64 = 1e-3;
    0.5 * libm::log(THOUSANDTH / effort.relative.max(f64::EPSILON))
}

impl fmt::Display for LyapunovVerdict {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Regular(_) => "regular",
            Self::Chaotic => "chaotic",
            Self::Undecided(_) => "undecided",
        })
    }
}

impl LyapunovVerdict {
    /// The reason in a sentence.
    #[must_use]
    pub fn reason(&self) -> String {
        match self {
            Self::Regular(regularity) => regularity.to_string(),
            Self::Chaotic => {
                "deviations grow exponentially all along the motion, which stays bounded, and on two \
                              motions that begin next to it"
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
                "without the time in the equations the states move in a plane, or in independent planes, where there is no chaos \
                 (Poincaré and Bendixson)",
            ),
            Self::Theorem(Theorem::Linear) => {
                formatter.write_str("the equations are linear, so deviations obey the same equations as motions")
            }
            Self::AtRest => formatter.write_str("the motion stays at an equilibrium"),
            Self::Converging => formatter.write_str("neighbouring motions converge all along the motion"),
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
            Self::Unbounded => formatter.write_str("the motion is not bounded"),
            Self::DigitsLost { valley } => write!(
                formatter,
                "the deviation shrinks by the factor e^-{valley:.1} in between, as next to a separatrix, and loses its \
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
