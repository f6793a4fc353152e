//! Three axes of a gyroscope → the rate about the one axis that the pendulum turns about, however the device is fixed to it.

use super::super::sheet::Sheet;
use super::value::Value;
use crate::statistics::count;
use nalgebra::{Matrix3, Vector3};

/// The axis with 99.9 % of the mean square: the others then change the rate by less than 5e-4 of it, while makers state
/// sensitivities to 1 %.
pub(super) fn strongest(sheet: &Sheet, columns: &[usize]) -> Option<usize> {
    let power = |&column: &usize| {
        let numbers: Vec<f64> = sheet.channels[column].numbers().flatten().collect();
        numbers.iter().map(|number| number * number).sum::<f64>()
    };
    let powers: Vec<f64> = columns.iter().map(power).collect();
    let total: f64 = powers.iter().sum();
    columns.iter().zip(&powers).find(|(_, power)| **power > 0.999 * total).map(|(column, _)| *column)
}

/// Three axes in one unit, and the direction about which they turn together.
pub(super) fn about_one_axis(sheet: &Sheet, columns: &[usize]) -> Option<Value> {
    let axes: [usize; 3] = columns.try_into().ok()?;
    let unit = |column: usize| &sheet.channels[column].heading.unit_text;
    if axes.iter().any(|&column| unit(column) != unit(axes[0])) {
        return None;
    }
    let [x, y, z] = axes.map(|column| sheet.channels[column].numbers());
    let rows: Vec<[f64; 3]> = x.zip(y).zip(z).filter_map(|((x, y), z)| Some([x?, y?, z?])).collect();
    principal_axis(&rows).map(|axis| Value::Axes(axes, axis))
}

/// Fewest rows for a direction: fewer lie along some direction by chance. Of noise alone ten rows never had 95 % of their squares along one in 20
/// 000 trials, five one time in 330, four one in 40.
pub const FEWEST: usize = 10;

/// The direction with 95 % of the variance of these rates, with its largest component positive: the rest is wobble and noise about a fixed axis in
/// the device. The mean is the reading of the sensor at rest.
pub fn principal_axis(rows: &[[f64; 3]]) -> Option<[f64; 3]> {
    if rows.len() < FEWEST {
        return None;
    }
    let sum = rows.iter().fold(Vector3::zeros(), |sum, row| sum + Vector3::from(*row));
    let mean = sum / count(rows.len());
    let scatter = rows.iter().fold(Matrix3::zeros(), |scatter, row| {
        let from_mean = Vector3::from(*row) - mean;
        scatter + from_mean * from_mean.transpose()
    });
    let decomposition = scatter.iter().all(|part| part.is_finite()).then(|| scatter.symmetric_eigen())?;
    let (values, largest) = (decomposition.eigenvalues, decomposition.eigenvalues.imax());
    let axis = decomposition.eigenvectors.column(largest).into_owned();
    let sign = axis[axis.iamax()].signum();
    (values[largest] > 0.95 * values.sum()).then(|| (axis * sign).into())
}
