//! Values of a pendulum with some kinds of damping, to be compared with data.

use super::DampingModel;
use super::layout::Layout;
use super::series::Series;
use super::swing::{Course, Seen, Swing};
use crate::statistics::levenberg_marquardt::Linearised;
use crate::statistics::triangle;
use libration::taylor::Effort;
use nalgebra::{DMatrix, DVector};

/// The motion of some traces, and its parameters.
#[derive(Clone, Debug)]
pub struct Model {
    pub layout: Layout,
    swing: Swing,
    free_scale: bool,
}

/// Residuals of the rows of one trace, with the derivatives with respect to their parameters.
#[derive(Clone, Debug)]
pub struct ResidualRows {
    /// Indices of these parameters among all.
    places: Vec<usize>,
    /// The derivatives, then the residuals, all times the weights.
    matrix: DMatrix<f64>,
}

impl Model {
    /// Returns the model of this number of traces; the scale of the angles is one if it is not free.
    pub(super) fn new(terms: DampingModel, traces: usize, free_scale: bool) -> Self {
        Self { layout: Layout::new(terms, traces), swing: Swing::new(terms), free_scale }
    }

    /// The indices of the parameters that are varied.
    pub fn free(&self) -> Vec<usize> {
        (0..self.layout.len()).filter(|&index| self.free_scale || index != self.layout.scale()).collect()
    }

    /// The rows of each trace at these parameters; `None` where the motion cannot be
    /// integrated.
    pub fn rows(
        &self,
        series: &[Series<'_>],
        parameters: &[f64],
        free: &[usize],
        effort: &Effort,
    ) -> Option<Vec<ResidualRows>> {
        let layout = self.layout;
        if parameters[Layout::OMEGA0] <= 0.0 {
            return None;
        }
        let mut courses = vec![];
        for (number, series) in series.iter().enumerate() {
            courses.push(Course {
                omega0: parameters[Layout::OMEGA0],
                coefficients: &parameters[layout.coefficients()],
                start: layout.first_state(number).map(|index| parameters[index]),
                times: &series.times,
                observable: series.observable,
            });
        }
        let seen = self.swing.seen(&courses, effort)?;
        let all = seen.iter().zip(series).enumerate();
        let rows = all.map(|(number, (seen, series))| self.rows_of(number, series, seen, parameters, free));
        let rows: Vec<ResidualRows> = rows.collect();
        rows.iter().all(|rows| rows.matrix.iter().all(|x| x.is_finite())).then_some(rows)
    }

    fn rows_of(
        &self,
        number: usize,
        series: &Series<'_>,
        seen: &Seen,
        parameters: &[f64],
        free: &[usize],
    ) -> ResidualRows {
        let layout = self.layout;
        let (offset, scale) = (layout.offset(number), layout.scale());
        let of_motion: Vec<usize> = layout.of_motion(number).collect();
        let is_own = |index: &usize| *index == offset || *index == scale || of_motion.contains(index);
        let indices: Vec<usize> = free.iter().copied().filter(is_own).collect();
        let mut matrix = DMatrix::zeros(series.times.len(), indices.len() + 1);
        for (&index, mut column) in indices.iter().zip(matrix.column_iter_mut()) {
            let weights = column.iter_mut().zip(series.weights.iter());
            match of_motion.iter().position(|&other| other == index) {
                Some(derivative) => {
                    for ((x, weight), slope) in weights.zip(&seen.derivatives[derivative]) {
                        *x = parameters[scale] * slope * weight;
                    }
                }
                None if index == offset => weights.for_each(|(x, weight)| *x = *weight),
                None => weights.zip(&seen.values).for_each(|((x, weight), value)| *x = value * weight),
            }
        }
        let residuals = matrix.column_mut(indices.len());
        let observed = series.values.iter().zip(series.weights.iter());
        for ((x, value), (observed, weight)) in residuals.into_iter().zip(&seen.values).zip(observed) {
            *x = (parameters[offset] + parameters[scale] * value - observed) * weight;
        }
        ResidualRows { places: indices, matrix }
    }
}

impl ResidualRows {
    /// Indices, among all parameters, of those that the rows depend on.
    pub fn places(&self) -> &[usize] {
        &self.places
    }

    /// The residuals, times their weights.
    pub fn residuals(&self) -> Vec<f64> {
        self.matrix.column(self.places.len()).iter().copied().collect()
    }

    /// All rows, with derivatives with respect to all free parameters.
    pub fn whole(rows: &[Self], free: &[usize]) -> Linearised {
        stacked(&rows.iter().map(|rows| (&rows.places[..], &rows.matrix)).collect::<Vec<_>>(), free)
    }

    /// Rows reduced to at most one more than the number of parameters, with the same sum of squares and the same derivatives.
    pub fn few(rows: &[Self], free: &[usize]) -> Linearised {
        let few: Vec<DMatrix<f64>> = rows.iter().map(|rows| triangle(&rows.matrix)).collect();
        let parts = rows.iter().zip(&few).map(|(rows, few)| (&rows.places[..], few));
        stacked(&parts.collect::<Vec<_>>(), free)
    }
}

/// Concatenates the rows of all parts.
fn stacked(parts: &[(&[usize], &DMatrix<f64>)], free: &[usize]) -> Linearised {
    let total = parts.iter().map(|(_, matrix)| matrix.nrows()).sum();
    let mut residuals = DVector::zeros(total);
    let mut jacobian = DMatrix::zeros(total, free.len());
    let mut first = 0;
    for (indices, matrix) in parts {
        let rows = matrix.nrows();
        for (source, index) in indices.iter().enumerate() {
            if let Some(column) = free.iter().position(|other| other == index) {
                jacobian.column_mut(column).rows_mut(first, rows).copy_from(&matrix.column(source));
            }
        }
        residuals.rows_mut(first, rows).copy_from(&matrix.column(indices.len()));
        first += rows;
    }
    Linearised { residuals, jacobian }
}
