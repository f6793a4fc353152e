//! An uncertainty budget for g as a laboratory writes it: the size of each effect on g and its contribution to the uncertainty.
//!
//! g = (4π²L/T0²)·(1 + 2r²/5L² + μλ²/3 + kσ)/(1 + μλ/2 − σ), a ball on a rod in air (see the rows for the letters), with factors for a support that
//! yields, a knife edge, the temperature and others. Effects whose inputs are not given are not corrected; the budget then states their size for a
//! usual pendulum, if it can be estimated at all.
//!
//! Reference: R. A. Nelson and M. G. Olsson, *The pendulum – Rich physics from a simple system*, Am. J. Phys. 54, 112 (1986),
//! doi:10.1119/1.14703; the mass of air that moves along: G. G. Stokes, Trans. Cambridge Philos. Soc. 9, part II, 8 (1851), with
//! the viscous layer as in L. D. Landau and E. M. Lifshitz, *Fluid Mechanics*, § 24.
//!
//! # Method
//! g is one function of all inputs. Sensitivity coefficients are its derivatives by the five-point rule with steps of a thousandth of each value,
//! so that an uncertainty, however large, does not leave the domain. Inputs of which one enters another are correlated: the angular width of the
//! bob at a gate depends on the length. A fitted input has the degrees of freedom of its scatter where its uncertainty comes from the scatter.

mod apparatus;
mod bob;
mod combined;
pub(crate) mod derivative;
mod effects;
mod input;
mod inputs;
mod of_table;
mod rows;
mod warning;

pub use apparatus::{AIR_DENSITY, Apparatus, Corrections, MeasuredPeriod, PeriodDamping};
pub use bob::{Bob, BobShape};
pub use combined::{COVERAGE_PROBABILITY, CombinedUncertainty, Contribution, Correlation};
pub(in crate::fit) use effects::{BudgetEffect, Values};
pub use input::BudgetInput;
pub(in crate::fit) use of_table::{TableBudget, input_row, of_table};
pub use warning::BudgetWarning;

use super::uncertain::Uncertain;

/// Reasons for the lack of a budget.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BudgetError {
    /// A quantity that must be above zero.
    #[error("the {name} is {value:?}: give a finite number above zero")]
    NotPositive {
        /// Name of the quantity.
        name: &'static str,
        /// The given value.
        value: f64,
    },
    /// An uncertainty below zero.
    #[error("the uncertainty of the {name} is {value:?}: give a finite number of zero or more")]
    Uncertainty {
        /// Name of the quantity.
        name: &'static str,
        /// The given value.
        value: f64,
    },
    /// A number that is not finite.
    #[error("the {name} is {value:?}: give a finite number")]
    NotFinite {
        /// Name of the quantity.
        name: &'static str,
        /// The given value.
        value: f64,
    },
    /// Sizes that no bob of its shape has.
    #[error("no {shape} has these sizes: {reason}")]
    Bob {
        /// Name of the shape.
        shape: &'static str,
        /// The reason, as a sentence.
        reason: &'static str,
    },
    /// A stiffness of the support without the mass of the bob.
    #[error(
        "the stiffness of the support is not used without the mass of the bob: give the mass of the bob too"
    )]
    SupportWithoutBob,
    /// A support that would move more than the bob.
    #[error(
        "the support is too weak for a pendulum of this mass and period: check its stiffness and its unit"
    )]
    SupportTooWeak,
    /// A difference of temperatures without the coefficient of expansion.
    #[error("the difference of temperatures is not used without a coefficient of expansion: give both")]
    WarmingWithoutExpansion,
    /// A bob that reaches the pivot.
    #[error(
        "a bob of radius {radius:?} m does not fit a pendulum of {length:?} m: the length goes to the centre of the bob"
    )]
    BobTooLarge {
        /// Radius of the bob, in metres.
        radius: f64,
        /// Length of the pendulum, in metres.
        length: f64,
    },
    /// A bob that floats in air.
    #[error("the bob is not denser than the air: check its mass and radius, or its density")]
    BobTooLight,
    /// A number that is not an amplitude.
    #[error("the amplitude {0:?} rad is not below pi")]
    Amplitude(f64),
    /// A mass of the rod without the mass of the bob, to which it is relative.
    #[error("the mass of the rod is not used without that of the bob: give the mass of the bob too")]
    RodWithoutBob,
    /// A correlation of an input that the budget does not have.
    #[error(
        "the {0} is correlated with another input and was not given: give it too, or leave out the correlation"
    )]
    CorrelationWithNothing(&'static str),
    /// A number that is not a correlation coefficient, or a correlation of an input with itself.
    #[error(
        "a correlation coefficient of {coefficient} is not possible: give a number from -1 to 1 between two different inputs"
    )]
    Correlation {
        /// The given value.
        coefficient: f64,
    },
    /// A pair of inputs with two coefficients.
    #[error(
        "there are two correlations of {first} and {second}: give one; that of a period with the dimensions of the bob used for it is \
         computed"
    )]
    CorrelationRepeated {
        /// An input.
        first: &'static str,
        /// The second one.
        second: &'static str,
    },
    /// Correlations that contradict each other.
    #[error("the correlations contradict each other: no inputs can be correlated like this")]
    Correlations,
}

/// Type of evaluation of an uncertainty (Guide to the Expression of Uncertainty in Measurement, 4.2 and 4.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evaluation {
    /// Type A: by the scatter of measurements.
    Statistics,
    /// Type B: by knowledge of instruments and theory.
    Judgement,
}

impl Evaluation {
    /// `A` or `B`.
    #[must_use]
    pub fn letter(self) -> char {
        match self {
            Self::Statistics => 'A',
            Self::Judgement => 'B',
        }
    }
}

/// Correction for an effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Correction {
    /// Relative change of g by the correction.
    Applied(f64),
    /// Relative change of g for a typical pendulum; that of this one is not known.
    Typical(f64),
    /// Neither the effect nor its typical size is known.
    Unknown,
    /// An input that corrects nothing.
    Input,
}

/// A row of a budget.
#[derive(Clone, Debug, PartialEq)]
pub struct BudgetRow {
    /// Name of the effect.
    pub name: &'static str,
    /// Factor of g, or source of the uncertainty.
    pub formula: &'static str,
    /// Correction of g.
    pub correction: Correction,
    /// Contribution to the standard uncertainty of g, in m/s²; `None` where it is not known.
    pub uncertainty: Option<f64>,
    /// Type of evaluation of that contribution.
    pub evaluation: Evaluation,
    /// Numbers that were used, or inputs that would be needed.
    pub note: String,
}

/// g and the sources of its uncertainty.
#[derive(Clone, Debug, PartialEq)]
pub struct Budget {
    /// Rows in the order in which a laboratory writes them.
    pub rows: Vec<BudgetRow>,
    /// The length that g is computed with, in m.
    pub length: f64,
    /// g with the corrections that are applied, in m/s².
    pub g: f64,
    /// The standard uncertainty of g, in m/s², from the inputs whose uncertainty is known.
    pub uncertainty: f64,
    /// The same uncertainty input by input.
    pub combined: CombinedUncertainty,
    /// Shift of the mean of g because g is not linear over the uncertainties of its inputs, in m/s².
    pub curvature: f64,
}

impl Budget {
    /// g with its uncertainty.
    #[must_use]
    pub fn gravity(&self) -> Uncertain {
        Uncertain { value: self.g, uncertainty: self.uncertainty }
    }

    /// Returns `true` if g is nearly linear over the uncertainties of its inputs: the shift of its mean is below a tenth of the uncertainty.
    /// Otherwise the uncertainty is rough (Guide to the Expression of Uncertainty in Measurement, 5.1.2, note).
    #[must_use]
    pub fn is_linear(&self) -> bool {
        self.curvature.abs() <= 0.1 * self.uncertainty
    }
}

/// Computes the budget of this pendulum with this period; inputs are independent except for these correlations.
///
/// # Errors
/// Fails for a length, mass, density or period that is not above zero, an uncertainty below zero, a bob that does not fit or floats,
/// and impossible correlations.
///
/// # Examples
/// ```
/// use libration_lab::fit::{Apparatus, Bob, Corrections, MeasuredPeriod, evaluate_budget};
/// use libration::quantity::{Dimension, parse};
///
/// let length = parse("1.0000(5) m", Dimension::Length)?;
/// let t0 = parse("2.0065(2) s", Dimension::Time)?;
/// let bare = evaluate_budget(&Apparatus::of_length(length), &MeasuredPeriod::of_small_swings(t0), &[])?;
/// let bob = Some(Bob::ball(parse("20.0(1) mm", Dimension::Length)?));
/// let corrections = Corrections { bob, ..Corrections::default() };
/// let ball = evaluate_budget(&Apparatus { length, corrections }, &MeasuredPeriod::of_small_swings(t0), &[])?;
/// assert!((ball.g / bare.g - 1.00016).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn evaluate_budget(
    apparatus: &Apparatus,
    period: &MeasuredPeriod,
    correlations: &[Correlation],
) -> Result<Budget, BudgetError> {
    inputs::Inputs::new(apparatus, period)?.budget(correlations)
}
