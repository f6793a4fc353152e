//! Why an equation is no oscillator.

use crate::expression::EquationError;

/// Why an equation of motion cannot be taken as an oscillator about an equilibrium.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum OscillatorError {
    /// An equation or values that are not understood.
    #[error(transparent)]
    Equation(#[from] EquationError),
    /// More than one variable.
    #[error("there are {} variables, {}: give one equation of motion", names.len(), names.join(", "))]
    SeveralVariables {
        /// Their names.
        names: Vec<String>,
    },
    /// The time itself in the equation.
    #[error("the acceleration depends on t: leave the driving out, or give the equation to a simulation")]
    DependsOnTime,
    /// Parameters that have no value.
    #[error(
        "no value is given for {}: give one, as {}=0.1; only the strength of a self-excitation may stay open, as mu in \
         x'' - mu*(1-x^2)*x' + x = 0",
        names.join(", "),
        names.first().map_or("mu", String::as_str)
    )]
    WithoutValue {
        /// Their names.
        names: Vec<String>,
    },
    /// A force that vanishes nowhere.
    #[error(
        "the acceleration at rest passes zero nowhere ({searched} was searched): there is no equilibrium to oscillate about"
    )]
    NoEquilibrium {
        /// Where it was looked for.
        searched: String,
    },
    /// Equilibria, but none about which there are oscillations.
    #[error("there are no oscillations about any equilibrium: {}", list(.0))]
    NoStableEquilibrium(Vec<Refusal>),
    /// A place given as the equilibrium where the force does not vanish.
    #[error("{at} is no equilibrium: the acceleration does not vanish there")]
    NotAnEquilibrium {
        /// The place.
        at: String,
    },
}

/// Why there are no oscillations about an equilibrium.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("at {at} {why}")]
pub struct Refusal {
    /// The place.
    pub at: String,
    /// The reason.
    pub why: Unfit,
}

/// What is wrong with an equilibrium.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Unfit {
    /// The force drives away, or has no linear part.
    #[error("the force does not drive back: omega0^2 is {omega0_squared} and must be positive")]
    NotRestoring {
        /// −∂F/∂x.
        omega0_squared: String,
    },
    /// The force has no derivative there.
    #[error("the acceleration has no derivative")]
    NotSmooth,
    /// Energy is lost or won in small oscillations.
    #[error(
        "small motions decay or grow, as the acceleration holds {damping} times the velocity: leave that out, or leave \
         open a parameter that multiplies it for a limit cycle"
    )]
    Damped {
        /// ∂F/∂x′.
        damping: String,
    },
    /// Energy is lost or won in larger ones, or it cannot be excluded.
    #[error("the acceleration is not the same for the opposite velocity, so that motions may decay or grow")]
    Irreversible,
}

fn list(refusals: &[Refusal]) -> String {
    const SHOWN: usize = 5;
    let shown: Vec<String> = refusals.iter().take(SHOWN).map(Refusal::to_string).collect();
    let more = refusals.len().saturating_sub(SHOWN);
    let rest = if more > 0 { format!("; and {more} more") } else { String::new() };
    shown.join("; ") + &rest
}
