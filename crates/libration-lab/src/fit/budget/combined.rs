//! Propagation of the uncertainties of the inputs to that of g, as in the Guide to the Expression of Uncertainty in Measurement.
//!
//! u² = Σ cᵢcⱼ r(xᵢ, xⱼ) uᵢuⱼ with the sensitivity coefficients cᵢ = ∂g/∂xᵢ (5.2.2), effective degrees of freedom after Welch and
//! Satterthwaite (G.4.1), and U = k·u with Student's k for 95 % (G.6.4).
//!
//! Reference: JCGM 100:2008.

use nalgebra::DMatrix;

use super::{BudgetError, BudgetInput, Evaluation};
use crate::statistics::student::quantile;

/// The probability that the true value is within the expanded uncertainty.
pub const COVERAGE_PROBABILITY: f64 = 0.95;

/// Contribution of an input to the uncertainty of g.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contribution {
    /// The input.
    pub input: BudgetInput,
    /// Its value, in its SI unit.
    pub value: f64,
    /// Its standard uncertainty; none where it was not given.
    pub uncertainty: Option<f64>,
    /// ∂g/∂x.
    pub sensitivity: f64,
    /// Type of evaluation of its uncertainty.
    pub evaluation: Evaluation,
    /// Degrees of freedom of its uncertainty; infinite where that is taken as known.
    pub degrees_of_freedom: f64,
}

impl Contribution {
    /// Returns the contribution of an input whose uncertainty was judged.
    #[doc(hidden)]
    pub fn judged(input: BudgetInput, value: f64, uncertainty: Option<f64>, sensitivity: f64) -> Self {
        let (evaluation, degrees_of_freedom) = (Evaluation::Judgement, f64::INFINITY);
        Self { input, value, uncertainty, sensitivity, evaluation, degrees_of_freedom }
    }

    /// Change of g with one standard uncertainty of the input, in m/s²; zero where that is not known.
    #[must_use]
    pub fn change(&self) -> f64 {
        self.sensitivity * self.uncertainty.unwrap_or(0.0)
    }
}

/// Correlation of two inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correlation {
    /// The two inputs, different ones.
    pub between: [BudgetInput; 2],
    /// Correlation coefficient, from −1 to 1.
    pub coefficient: f64,
}

/// The uncertainty of g with all contributions to it.
#[derive(Clone, Debug, PartialEq)]
pub struct CombinedUncertainty {
    /// Contributions of all inputs.
    pub contributions: Vec<Contribution>,
    /// Correlations of pairs of inputs.
    pub correlations: Vec<Correlation>,
    /// The standard uncertainty, in m/s²; unknown uncertainties are not in it.
    pub standard: f64,
    /// The effective degrees of freedom; infinite where every uncertainty that contributes is taken as known; where none contributes, those of
    /// the fewest data.
    pub degrees_of_freedom: f64,
}

impl CombinedUncertainty {
    #[doc(hidden)]
    pub fn new(contributions: Vec<Contribution>, correlations: &[Correlation]) -> Result<Self, BudgetError> {
        let matrix = matrix(&contributions, correlations)?;
        let changes = DMatrix::from_fn(contributions.len(), 1, |row, _| contributions[row].change());
        let variance = (changes.transpose() * matrix * changes)[(0, 0)].max(0.0);
        let term = |each: &Contribution| square(square(each.change())) / each.degrees_of_freedom;
        let spread: f64 = contributions.iter().map(term).sum();
        Ok(Self {
            standard: variance.sqrt(),
            degrees_of_freedom: if spread > 0.0 {
                variance * variance / spread
            } else {
                known_by(&contributions)
            },
            correlations: correlations.to_vec(),
            contributions,
        })
    }

    /// The part of the variance that an input makes by itself; zero without any variance.
    #[must_use]
    pub fn share(&self, contribution: &Contribution) -> f64 {
        if self.standard > 0.0 { square(contribution.change() / self.standard) } else { 0.0 }
    }

    /// The part of the variance that the correlations make, which may be negative.
    #[must_use]
    pub fn share_of_correlations(&self) -> f64 {
        let change = |input| {
            self.contributions.iter().find(|each| each.input == input).map_or(0.0, Contribution::change)
        };
        let product =
            |both: &Correlation| 2.0 * both.coefficient * change(both.between[0]) * change(both.between[1]);
        let sum: f64 = self.correlations.iter().map(product).sum();
        if self.standard > 0.0 { sum / square(self.standard) } else { 0.0 }
    }

    /// k, Student's factor for 95 % with the effective degrees of freedom.
    #[must_use]
    pub fn coverage_factor(&self) -> f64 {
        quantile(1.0 - COVERAGE_PROBABILITY, self.degrees_of_freedom)
    }

    /// U = k·u, in m/s²: the true value is within it with a probability of 95 %.
    #[must_use]
    pub fn expanded(&self) -> f64 {
        self.coverage_factor() * self.standard
    }

    /// The inputs that matter and were given without an uncertainty.
    pub fn without_uncertainty(&self) -> impl Iterator<Item = BudgetInput> {
        let open =
            self.contributions.iter().filter(|each| each.uncertainty.is_none() && each.sensitivity != 0.0);
        open.map(|each| each.input)
    }
}

/// The degrees of freedom if statistics contribute no uncertainty: infinite with a judged contribution, otherwise those of the fewest data.
fn known_by(contributions: &[Contribution]) -> f64 {
    if contributions.iter().any(|each| each.degrees_of_freedom.is_infinite() && each.change().abs() > 0.0) {
        return f64::INFINITY;
    }
    contributions.iter().map(|each| each.degrees_of_freedom).fold(f64::INFINITY, f64::min)
}

/// The correlations of all inputs; refuses those for which some variance would be negative.
fn matrix(contributions: &[Contribution], correlations: &[Correlation]) -> Result<DMatrix<f64>, BudgetError> {
    /// Rounding of a matrix whose smallest eigenvalue is zero.
    const ROUNDING: f64 = 1e-12;
    let index = |input: BudgetInput| {
        let position = contributions.iter().position(|each| each.input == input);
        position.ok_or(BudgetError::CorrelationWithNothing(input.name()))
    };
    let mut matrix = DMatrix::identity(contributions.len(), contributions.len());
    for &Correlation { between, coefficient } in correlations {
        let [row, column] = [index(between[0])?, index(between[1])?];
        if row == column || !(-1.0..=1.0).contains(&coefficient) {
            return Err(BudgetError::Correlation { coefficient });
        }
        if matrix[(row, column)] != 0.0 {
            let [first, second] = between.map(BudgetInput::name);
            return Err(BudgetError::CorrelationRepeated { first, second });
        }
        matrix[(row, column)] = coefficient;
        matrix[(column, row)] = coefficient;
    }
    let least = matrix.clone().symmetric_eigenvalues().min();
    if least < -ROUNDING { Err(BudgetError::Correlations) } else { Ok(matrix) }
}

fn square(x: f64) -> f64 {
    x * x
}
