//! The reasons why an equation is not an oscillator.

use super::neighbourhood::{Roughness, Tendency};
use super::remedy::Remedy;
use super::roots::SEARCHED;
use libration_numbers::expression::{EquationError, SecondOrderError};

/// The reason why an equation of motion cannot be taken as an oscillator about an equilibrium.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum OscillatorError {
    /// An equation or values that could not be parsed.
    #[error(transparent)]
    Equation(#[from] EquationError),
    /// An equation of first order.
    #[error(transparent)]
    NotSecondOrder(#[from] SecondOrderError),
    /// More than one variable.
    #[error(
        "there are {} variables, {}: give one equation of motion",
        names.len(),
        names.join(", ")
    )]
    SeveralVariables {
        /// The names of the variables.
        names: Vec<String>,
    },
    /// The time itself in the equation.
    #[error("the acceleration depends on t: leave the driving out")]
    DependsOnTime,
    /// Parameters that have no value.
    #[error(
        "no value is given for {}: give one, such as {}=0.1 (only the strength of a self-excitation may stay open, such as mu in \
             x'' - mu*(1-x^2)*x' + x = 0)",
        names.join(", "),
        names.first().map_or("mu", String::as_str)
    )]
    WithoutValue {
        /// The names of the parameters.
        names: Vec<String>,
    },
    /// A self-excitation of an oscillator that is not linear.
    #[error(
        "a limit cycle is expanded in {parameter} only about a linear oscillator with rational coefficients, such as x'' = -2*x, and at {parameter} = 0 the \
             equation is {variable}'' = {left}: give {parameter} a value"
    )]
    ExcitedNonlinear {
        /// The open parameter.
        parameter: String,
        /// The variable.
        variable: String,
        /// The acceleration at strength zero.
        left: String,
    },
    /// An open parameter that occurs otherwise than as the strength of a self-excitation.
    #[error(
        "{parameter} has no value, and is not the strength of a self-excitation, as the acceleration is not the same when both {parameter} and the velocity change sign: give it a value, such as {parameter}=0.1"
    )]
    NoStrength {
        /// The open parameter.
        parameter: String,
    },
    /// A force that has no value at any tried position.
    #[error("the acceleration at rest has no value at any position tried, from -{SEARCHED} to {SEARCHED}")]
    NoValues,
    /// A force that vanishes nowhere.
    #[error("there is no equilibrium to oscillate about: the acceleration at rest never passes through zero")]
    NoEquilibrium,
    /// A force for which no zero was found.
    #[error(
        "no equilibrium was found: the acceleration at rest does not pass through zero from -{SEARCHED} to {SEARCHED}, the \
         range of the search; if there is one further out, give it, such as {}",
        2.0 * SEARCHED
    )]
    NotFound,
    /// Equilibria without an expansion.
    #[error("there is no expansion about any equilibrium: {}", list(.0))]
    NoStableEquilibrium(Vec<RejectedEquilibrium>),
    /// An expression, given as the equilibrium, that is not a constant.
    #[error("`{place}` is not a position: {why}")]
    NotAPlace {
        /// The given expression, shortened.
        place: String,
        /// The reason.
        why: String,
    },
    /// A position given as the equilibrium at which the force does not vanish.
    #[error("there is no equilibrium at {at}: the acceleration does not vanish there or nearby")]
    NotAnEquilibrium {
        /// The position, shortened.
        at: String,
    },
}

impl OscillatorError {
    /// The computations that have a result for such an equation.
    #[must_use]
    pub fn remedies(&self) -> Vec<Remedy> {
        match self {
            Self::SeveralVariables { .. } => vec![Remedy::NormalModes],
            Self::DependsOnTime => vec![Remedy::Simulation],
            Self::ExcitedNonlinear { .. } => vec![Remedy::SlowFlow, Remedy::Simulation],
            Self::NoStableEquilibrium(rejected) => {
                let mut remedies: Vec<Remedy> =
                    rejected.iter().flat_map(|rejection| rejection.reason.remedies()).collect();
                remedies.sort_unstable();
                remedies.dedup();
                remedies
            }
            _ => vec![],
        }
    }
}

impl RejectionReason {
    /// The computations that have a result for such an equilibrium.
    fn remedies(&self) -> Vec<Remedy> {
        match self {
            Self::NoLinearPart { force: Some(Tendency::Back), frequency }
            | Self::NotAnalytic { force: Some(Tendency::Back), frequency, .. } => {
                frequency.remedy().into_iter().collect()
            }
            Self::CircularArcs { .. } => vec![Remedy::Backbone],
            Self::Damped { .. } => vec![Remedy::Simulation, Remedy::SlowFlow],
            Self::Irreversible => vec![Remedy::Simulation],
            _ => vec![],
        }
    }
}

/// The reason why there are no oscillations about an equilibrium.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("at {at} {reason}")]
pub struct RejectedEquilibrium {
    /// The position.
    pub at: String,
    /// The reason.
    pub reason: RejectionReason,
}

/// The defect of an equilibrium.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RejectionReason {
    /// The force points away from the equilibrium.
    #[error("the force points away from it: omega0^2 is {omega0_squared} and must be positive")]
    NotRestoring {
        /// −∂F/∂x.
        omega0_squared: String,
    },
    /// The force has no linear part.
    #[error("{}", without_linear_part(*.force, *.frequency))]
    NoLinearPart {
        /// The direction of the force, if known.
        force: Option<Tendency>,
        /// The method that finds a frequency there.
        frequency: FrequencySource,
    },
    /// The force has no power series at the equilibrium.
    #[error("the acceleration has no power series to expand: {roughness}{}", without_series(*.force, *.frequency))]
    NotAnalytic {
        /// The defect of the force.
        roughness: Roughness,
        /// The direction of the force, if known.
        force: Option<Tendency>,
        /// The method that finds a frequency there.
        frequency: FrequencySource,
    },
    /// The force jumps between two straight lines.
    #[error(
        "the force jumps from {jump} to -{jump}: the frequency grows without limit as the amplitude A goes to zero, and has no expansion in it. \
         The motion is made of circular arcs with omega^2 = {omega_squared}, and its period is exactly 4/omega*arccos(k/(k + omega^2*A)), k = {jump}; \
         the frequency at any amplitude is found without an expansion"
    )]
    CircularArcs {
        /// k of the force −k·sign(x) − ω²·x.
        jump: String,
        /// ω².
        omega_squared: String,
    },
    /// Small oscillations lose or gain energy.
    #[error(
        "small motions {}, because the acceleration contains {damping} times the velocity: for an expansion leave \
             that term out, or leave its strength open, as in c*x'",
        if damping.starts_with('-') { "decay" } else { "grow" }
    )]
    Damped {
        /// ∂F/∂x′.
        damping: String,
    },
    /// Larger oscillations lose or gain energy, or this cannot be excluded.
    #[error(
        "the acceleration is neither the same for the opposite velocity nor the opposite for the opposite displacement, so that motions \
         may decay or grow"
    )]
    Irreversible,
}

/// The method that computes the frequency of oscillations without an expansion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrequencySource {
    /// A periodic orbit for each amplitude.
    Orbits,
    /// The motion in time.
    Motion,
    /// No method, since integration does not pass the equilibrium.
    Nothing,
}

impl FrequencySource {
    fn advice(self) -> &'static str {
        match self {
            Self::Orbits => ": the frequency at any amplitude is found without one",
            Self::Motion => ": the motion is followed without one",
            Self::Nothing => "",
        }
    }

    fn remedy(self) -> Option<Remedy> {
        match self {
            Self::Orbits => Some(Remedy::Backbone),
            Self::Motion => Some(Remedy::Simulation),
            Self::Nothing => None,
        }
    }
}

fn without_linear_part(force: Option<Tendency>, frequency: FrequencySource) -> String {
    match force {
        Some(Tendency::Back) => format!(
            "the restoring force has no linear part: omega0^2 is 0, so that the frequency goes to zero with the amplitude and has no \
             expansion{}",
            frequency.advice()
        ),
        Some(Tendency::Away) => "the force points away from it, with omega0^2 = 0".to_owned(),
        Some(Tendency::OneWay) => "the force points the same way on both sides, with omega0^2 = 0".to_owned(),
        Some(Tendency::None) => "there is no force anywhere near it: omega0^2 is 0".to_owned(),
        None => "omega0^2 is 0 and must be positive".to_owned(),
    }
}

fn without_series(force: Option<Tendency>, frequency: FrequencySource) -> String {
    match force {
        Some(Tendency::Back) => format!("; the force points back to it{}", frequency.advice()),
        Some(Tendency::Away) => "; the force points away from it".to_owned(),
        Some(Tendency::OneWay) => "; the force points the same way on both sides".to_owned(),
        _ => String::new(),
    }
}

fn list(refusals: &[RejectedEquilibrium]) -> String {
    const SHOWN: usize = 5;
    let shown: Vec<String> = refusals.iter().take(SHOWN).map(RejectedEquilibrium::to_string).collect();
    let more = refusals.len().saturating_sub(SHOWN);
    let rest = if more > 0 { format!("; and {more} more") } else { String::new() };
    shown.join("; ") + &rest
}
