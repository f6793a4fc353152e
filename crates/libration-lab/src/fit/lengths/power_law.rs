//! T = a·Lⁿ as a straight line of the logarithms.

use nalgebra::{DMatrix, DVector};

use super::table::{LengthRow, LengthTable};
use crate::fit::scatter;
use crate::fit::uncertain::Uncertain;
use crate::statistics::{count, is_settled, weighted_least_squares};

/// Rounds in which the weights are renewed; the error falls by a factor of (σ of n)/n or so each time.
const MOST_ROUNDS: usize = 100;

/// Power law of the period of small swings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLaw {
    /// n, which is 1/2 for a simple pendulum without an offset of the lengths.
    pub exponent: Uncertain,
    /// a, the period at a length of 1 m, in seconds.
    pub factor: Uncertain,
    /// Degrees of freedom of the uncertainties; infinite where they come from stated ones.
    pub degrees_of_freedom: f64,
}

/// Fits the power law to positive lengths; `None` for fewer than three rows, for equal lengths, and for weights that do not settle.
pub(super) fn power_law(table: &LengthTable) -> Option<PowerLaw> {
    let rows = &table.rows;
    if rows.len() < 3 || rows.iter().any(|row| row.length <= 0.0) {
        return None;
    }
    let matrix = DMatrix::from_fn(rows.len(), 2, |i, k| if k == 0 { libm::log(rows[i].length) } else { 1.0 });
    let values = DVector::from_iterator(rows.len(), rows.iter().map(|row| 0.5 * libm::log(row.square())));
    let solved = |exponent: f64| {
        let weights: Vec<f64> = rows.iter().map(|row| weight(table, row, exponent)).collect();
        weighted_least_squares(matrix.clone(), values.clone(), &weights).ok()
    };
    let mut fit = solved(0.5)?;
    // The weights depend on the exponent by the uncertainties of the lengths alone.
    for round in 0.. {
        let next = solved(fit.coefficients[0])?;
        let last = std::mem::replace(&mut fit, next).coefficients;
        if is_settled(last.as_slice(), fit.coefficients.as_slice(), &fit.covariance, 1.0) {
            break;
        }
        if round == MOST_ROUNDS {
            return None;
        }
    }
    let (exponent, dof) = (fit.coefficients[0], rows.len() - 2);
    let chi2 = table.weighted.then(|| fit.chi2());
    let enlargement = scatter::enlargement(chi2, dof);
    let unit = if table.weighted { enlargement * enlargement } else { fit.chi2() / count(dof) };
    let uncertainty = |index: usize| (unit * fit.covariance[(index, index)]).sqrt();
    // The logarithms are of T/2π.
    let factor = std::f64::consts::TAU * libm::exp(fit.coefficients[1]);
    Some(PowerLaw {
        exponent: Uncertain { value: exponent, uncertainty: uncertainty(0) },
        factor: Uncertain { value: factor, uncertainty: factor * uncertainty(1) },
        degrees_of_freedom: scatter::degrees_of_freedom(chi2, dof),
    })
}

fn weight(table: &LengthTable, row: &LengthRow, exponent: f64) -> f64 {
    if !table.weighted {
        return row.period;
    }
    1.0 / libm::hypot(row.period_uncertainty / row.period, exponent * row.length_uncertainty / row.length)
}
