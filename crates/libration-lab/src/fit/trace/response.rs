//! Linear response of the parameters to residuals next to the minimum.

use nalgebra::{DMatrix, DVector};

use super::minimum::TraceMinimum;
use super::{Parameter, TraceFitError, huber};
use crate::measurement::Trace;
use crate::statistics::levenberg_marquardt::Linearised;
use crate::statistics::{Design, Undetermined};

/// Tolerance for a column that the others span: derivatives of the motion are integrated to 1e-12, and such errors,
/// accumulated by an order of magnitude during the integration, remain of it.
const EXACTNESS: f64 = 1e-11;

/// A problem of least squares at its minimum, in which parameters respond linearly to residuals.
pub(super) struct Response {
    pub(super) linearised: Linearised,
    /// Matrix with a row for each parameter and a column for each residual.
    pub(super) matrix: DMatrix<f64>,
}

impl Response {
    /// Computes the response at a minimum, with the weights of its rows.
    pub(super) fn new(minimum: &TraceMinimum, parameters: &[Parameter]) -> Result<Self, TraceFitError> {
        Self::with(minimum.linearised.clone(), parameters)
    }

    /// Computes the response of the bounded least squares problem, which equals the robust one for many rows: outliers are bounded, and their rows
    /// have full weight, so that the noise is the same in all.
    pub(super) fn without_weights(
        minimum: &TraceMinimum,
        traces: &[Trace],
        parameters: &[Parameter],
    ) -> Result<Self, TraceFitError> {
        let mut jacobian = minimum.linearised.jacobian.clone();
        for (mut row, part) in jacobian.row_iter_mut().zip(minimum.weights.parts(traces)) {
            row /= part;
        }
        let residuals = DVector::from_vec(huber::bounded(&minimum.standard_residuals(traces)));
        Self::with(Linearised { residuals, jacobian }, parameters)
    }

    fn with(linearised: Linearised, parameters: &[Parameter]) -> Result<Self, TraceFitError> {
        let undetermined = |column: usize| TraceFitError::Undetermined { parameter: parameters[column].kind };
        let design = Design::new(&linearised.jacobian, EXACTNESS).map_err(|reason| match reason {
            Undetermined::Dependent { column } => undetermined(column),
            Undetermined::TooFewRows | Undetermined::NotFinite => undetermined(0),
        })?;
        Ok(Self { matrix: design.pseudo_inverse(), linearised })
    }

    /// Covariance of the parameters, if the residuals were independent with a variance of one.
    pub(super) fn covariance(&self) -> DMatrix<f64> {
        &self.matrix * self.matrix.transpose()
    }
}
