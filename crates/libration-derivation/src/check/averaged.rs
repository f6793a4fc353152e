//! Formulas of the slow flow under a weak force, power by power.

use super::super::formula::{Formula, Name};
use libration::algebra::Rational;

/// factor·xⁱ·x′ᵏ·cʲ.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceTerm {
    /// The factor.
    pub factor: Rational,
    /// i.
    pub position: usize,
    /// k.
    pub velocity: usize,
    /// j.
    pub parameter: usize,
}

/// The equation x″ + ω0²·x + Σ terms = 0.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowTerms {
    /// ω0.
    pub omega0: Rational,
    /// The terms as long as x falls.
    pub terms: Vec<ForceTerm>,
    /// `true` if the coefficients are different while x rises.
    pub kinked: bool,
    /// One if a term contains neither displacement nor velocity, so that its parameter counts as a power of the amplitude; otherwise zero.
    pub lift: usize,
}

/// A formula of a slow flow, and its equation of motion.
#[derive(Clone, Debug, PartialEq)]
pub struct AveragedFormula {
    /// The equation.
    pub flow: FlowTerms,
    /// Statement of the formula.
    pub claim: AveragedClaim,
}

/// The statement of a formula of a slow flow.
#[derive(Clone, Debug, PartialEq)]
pub enum AveragedClaim {
    /// The second time derivative of x(A, ψ).
    ChainRule,
    /// The contribution of lower powers to the right side, at a power of A and of the parameter.
    Forcing {
        /// The power of A.
        power: usize,
        /// The power of the parameter.
        parameter: usize,
        /// The contribution.
        value: Formula,
    },
    /// A coefficient of A′.
    Growth {
        /// The power of A.
        power: usize,
        /// The power of the parameter.
        parameter: usize,
    },
    /// A coefficient of ψ′.
    Frequency {
        /// The power of A.
        power: usize,
        /// The power of the parameter.
        parameter: usize,
    },
    /// A coefficient of the motion.
    Motion {
        /// The power of A.
        power: usize,
        /// The power of the parameter.
        parameter: usize,
    },
    /// A coefficient of the velocity.
    Velocity {
        /// The power of A.
        power: usize,
        /// The power of the parameter.
        parameter: usize,
    },
    /// A′ up to the highest known power.
    AmplitudeLaw {
        /// The small parameter.
        parameter: Name,
    },
    /// ψ′ up to the highest known power.
    PhaseLaw {
        /// The small parameter.
        parameter: Name,
    },
    /// The mean energy loss by the weak force, at first power of the parameter.
    Loss {
        /// The highest power of A.
        highest: usize,
    },
    /// A′ at first power of the parameter.
    FirstLaw,
    /// The limit cycle of a slow flow: the square of its amplitude, its frequency or its exponent, as series in the parameter.
    Cycle {
        /// The small parameter.
        parameter: Name,
        /// Quantity of the limit cycle.
        quantity: CycleQuantity,
    },
}

/// A quantity of a limit cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CycleQuantity {
    /// The square of the amplitude.
    SquaredAmplitude,
    /// The angular frequency.
    Frequency,
    /// The growth rate of a small distance from the cycle.
    Exponent,
}
