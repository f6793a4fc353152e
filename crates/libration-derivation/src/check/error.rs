//! Errors of derivations.

use super::super::evaluate::EvaluationError;
use libration::oscillator::Remedy;
use libration::pendulum::PendulumError;
use libration::perturbation::{ExpansionError, OpenGaugeError, SlowFlowError, SymbolicSlowFlowError};
use libration::progress::Interrupted;

/// The reason why a derivation does not exist.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DerivationError {
    /// A formula that does not hold: an error of this program.
    #[error("the formula {formula} fails its check: {reason}")]
    Failed {
        /// The formula in LaTeX.
        formula: String,
        /// The reason why it fails.
        reason: String,
    },
    /// A formula that cannot be evaluated.
    #[error("the formula {formula} cannot be checked: {reason}")]
    Unchecked {
        /// The formula in LaTeX.
        formula: String,
        /// The reason why it has no value.
        reason: EvaluationError,
    },
    /// An amplitude at which the steps cannot be shown with their numbers.
    #[error(
        "an amplitude of {degrees:?} degrees: the numbers of each step are shown for 0.01 to {largest} degrees"
    )]
    Amplitude {
        /// The amplitude in degrees.
        degrees: f64,
        /// The largest amplitude of this derivation in degrees.
        largest: f64,
    },
    /// An order that is not derived step by step.
    #[error("order {order} is not derived step by step: give 2 to 9")]
    Order {
        /// The order that was requested.
        order: usize,
    },
    /// A power of the amplitude that is not derived step by step.
    #[error("order {order} is not derived step by step: give 1 to 9")]
    AmplitudeOrder {
        /// The order that was requested.
        order: usize,
    },
    /// A power of the small parameter that is not derived step by step.
    #[error("damping order {order} is not derived step by step: give 1 to 4")]
    DampingOrder {
        /// The order that was requested.
        order: usize,
    },
    /// A power of the excitation that is not derived step by step.
    #[error("order {order} is not derived step by step: give 1 to 9")]
    CycleOrder {
        /// The order that was requested.
        order: usize,
    },
    /// An equation without self-excitation.
    #[error(
        "there is no limit cycle that is born with the small terms, as in x'' - mu*(1 - x^2)*x' + x = 0; \
         the derivations for others are those of perturbation and averaging"
    )]
    NoExcitation,
    /// An acceleration that depends on the velocity.
    #[error(
        "the acceleration depends on the velocity: the derivation is for even powers of it, with which a motion retraces its path; that by averaging \
         accepts others where a small symbol multiplies them"
    )]
    Velocity,
    /// A force with different power series on its two sides.
    #[error(
        "the force has one power series above the equilibrium and another below, which is not its mirror image: the derivation is for odd forces, such \
         as x + x*abs(x)"
    )]
    TwoSided,
    /// Another gauge for a force with two sides.
    #[error(
        "the series of a force with two sides are derived in the largest displacement: leave the gauge out, or give x_max"
    )]
    GaugeOfTwoSided,
    /// Numbers requested of an oscillator with symbols or constants.
    #[error(
        "the numbers at an amplitude need fractions for all parameters: leave the amplitude out, or give values to the symbols"
    )]
    NoNumbers,
    /// Irrational numbers in the equation.
    #[error(
        "the equilibrium is not a fraction or a formula of the symbols, or the Taylor coefficients are not sums of products of symbols and constants: \
         the derivation is exact"
    )]
    NoFractions,
    /// An irrational frequency.
    #[error(
        "the frequency of small swings is not a fraction: choose the unit of time so that it is, as in omega0 = 1"
    )]
    NoFractionalFrequency,
    /// Small terms that are not polynomials.
    #[error(
        "the small terms must be polynomials in displacement, velocity and small parameter, up to abs and sign of the velocity, and all that \
         depends on the velocity must be small"
    )]
    NoPolynomial,
    /// A symbol of the equation that has another meaning in the derivation.
    #[error("the symbol {letter} has another meaning in the derivation: rename it")]
    TakenLetter {
        /// The symbol.
        letter: String,
    },
    /// A limit cycle that is not expanded in fractions.
    #[error("the amplitude at which the limit cycle begins is not a fraction: the derivation is exact")]
    NoCycle,
    /// Two methods that disagree: an error of this program.
    #[error("{what} do not agree: this is an error of the program")]
    Disagreement {
        /// The quantity on which the methods disagree.
        what: &'static str,
    },
    /// A slow flow that needs more than products of two small terms of one order.
    #[error(
        "the slow flow needs more than products of two small terms of one order: derivations go to these, and only with a small drive and without abs and sign in the terms of lowest order"
    )]
    SeveralOrders,
    /// An equation without a slow flow with symbols.
    #[error(transparent)]
    Symbolic(#[from] SymbolicSlowFlowError),
    /// An equation without a slow flow.
    #[error(transparent)]
    SlowFlow(#[from] SlowFlowError),
    /// An oscillator without an expansion.
    #[error(transparent)]
    Expansion(#[from] ExpansionError),
    /// An oscillator without equations for the open gauge.
    #[error(transparent)]
    OpenGauge(#[from] OpenGaugeError),
    /// An invalid amplitude.
    #[error("an amplitude of {0:?} is not positive and finite")]
    NotAnAmplitude(f64),
    /// An invalid pendulum.
    #[error(transparent)]
    Pendulum(#[from] PendulumError),
    /// Cancellation before the first step.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

impl DerivationError {
    /// The commands that compute a result without a derivation.
    #[must_use]
    pub fn remedies(&self) -> Vec<Remedy> {
        match self {
            Self::Amplitude { .. } => vec![Remedy::Period],
            Self::SeveralOrders => vec![Remedy::Expansion],
            Self::AmplitudeOrder { .. } | Self::DampingOrder { .. } | Self::NoFractionalFrequency => {
                vec![Remedy::SlowFlow]
            }
            Self::Order { .. }
            | Self::CycleOrder { .. }
            | Self::Velocity
            | Self::TwoSided
            | Self::NoFractions
            | Self::NoPolynomial
            | Self::NoCycle => vec![Remedy::Expansion],
            Self::SlowFlow(error) => error.remedies(),
            Self::Expansion(error) => error.remedies(),
            _ => vec![],
        }
    }
}
