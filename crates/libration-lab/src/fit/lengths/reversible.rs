//! The reversible pendulum by Bessel's formula.
//!
//! 8π²/g = (T1² + T2²)/(h1 + h2) + (T1² − T2²)/(h1 − h2), where h1 and h2 are the distances of both knife edges from the centre of mass between them. The sum
//! is the distance of the edges, which is measured directly; the difference needs the centre of mass, and enters with a small factor only where the
//! periods are nearly equal.
//!
//! Reference: F. W. Bessel, *Untersuchungen über die Länge des einfachen Secundenpendels*, Abh. Akad. Wiss. Berlin 1826.

use std::f64::consts::PI;

use super::model::{LengthFit, LengthModel};
use super::table::{LengthRow, LengthTable};
use crate::fit::budget::{BudgetInput, Contribution, Evaluation};
use crate::fit::error::FitError;
use crate::fit::readings::RepeatedReadings;
use crate::fit::uncertain::Uncertain;
use libration::quantity::Quantity;

/// Largest relative uncertainty of the difference of the distances at which it counts as known: the second term is then linear in it to a few per
/// cent.
const KNOWN: f64 = 0.2;

/// Computes g by the two distances of the table from the centre of mass, each with one or more periods, and the distance of the edges, for which the sum
/// of both is taken if it is not given.
///
/// # Errors
/// Fails for other than two distances, for periods without uncertainties, and for distances whose difference is not known.
pub(super) fn reversible(
    table: &LengthTable,
    edges: Option<Quantity>,
) -> Result<(LengthFit, Vec<Contribution>), FitError> {
    let mut lengths: Vec<f64> = table.rows.iter().map(|row| row.length.abs()).collect();
    lengths.sort_by(f64::total_cmp);
    lengths.dedup();
    let &[near, far] = &lengths[..] else { return Err(FitError::KnifeEdges { count: lengths.len() }) };
    if !table.is_weighted() {
        return Err(FitError::KnifeEdgePeriods);
    }
    let sides = [far, near].map(|length| EdgeMean::of(table, length));
    let [first, second] = &sides;
    let of_both = libm::hypot(first.length_uncertainty, second.length_uncertainty);
    let Uncertain { value: difference, uncertainty: of_difference } = known_difference(far - near, of_both)?;
    let Uncertain { value: sum, uncertainty: of_sum } = distance_of_edges(edges, far + near, of_both)?;
    let terms = [(first.square + second.square) / sum, (first.square - second.square) / difference];
    let gravity = 8.0 * PI * PI / (terms[0] + terms[1]);
    // dg = −g²/8π² d(terms), 1/g being y/h of a simple pendulum.
    let factor = gravity * gravity / (8.0 * PI * PI);
    let of_periods = libm::hypot(
        (1.0 / sum + 1.0 / difference) * first.square_uncertainty,
        (1.0 / sum - 1.0 / difference) * second.square_uncertainty,
    );
    let change = |input, value, uncertainty: f64, part: f64| {
        let sensitivity = if uncertainty > 0.0 { factor * part / uncertainty } else { 0.0 };
        Contribution::judged(input, value, Some(uncertainty), sensitivity)
    };
    let of_periods = Contribution {
        evaluation: Evaluation::Statistics,
        ..change(BudgetInput::Slope, 1.0 / gravity, of_periods / (8.0 * PI * PI), -of_periods)
    };
    let of_distances = match edges {
        Some(_) => vec![
            change(BudgetInput::Length, sum, of_sum, terms[0] * of_sum / sum),
            change(
                BudgetInput::CentreOfMass,
                difference,
                of_difference,
                terms[1] * of_difference / difference,
            ),
        ],
        // Sum and difference are of the same two distances, and one input together.
        None => {
            let [first, second] = [
                (terms[0] / sum + terms[1] / difference) * first.length_uncertainty,
                (terms[0] / sum - terms[1] / difference) * second.length_uncertainty,
            ];
            vec![change(BudgetInput::Length, sum, of_sum, libm::hypot(first, second))]
        }
    };
    let contributions: Vec<Contribution> = [vec![of_periods], of_distances].concat();
    let square: f64 =
        contributions.iter().map(|contribution| contribution.change() * contribution.change()).sum();
    let gravity = Uncertain { value: gravity, uncertainty: square.sqrt() };
    Ok((described(table, gravity), contributions))
}

/// The difference of the distances from the centre of mass, if it is known.
fn known_difference(difference: f64, uncertainty: f64) -> Result<Uncertain, FitError> {
    if uncertainty > KNOWN * difference {
        return Err(FitError::CentreOfMass { difference, uncertainty });
    }
    Ok(Uncertain { value: difference, uncertainty })
}

/// The distance of the edges, as given, else the sum of their distances from the centre of mass.
fn distance_of_edges(edges: Option<Quantity>, sum: f64, of_sum: f64) -> Result<Uncertain, FitError> {
    let (value, uncertainty) =
        edges.map_or((sum, of_sum), |distance| (distance.value, distance.uncertainty.unwrap_or(0.0)));
    if !(value > 0.0 && value.is_finite() && (0.0..f64::INFINITY).contains(&uncertainty)) {
        return Err(FitError::Length { value, uncertainty });
    }
    Ok(Uncertain { value, uncertainty })
}

/// The square of the radius of gyration that the periods about the far edge give.
pub(super) fn gyration(table: &LengthTable, gravity: f64) -> f64 {
    let far = table.rows.iter().map(|row| row.length.abs()).fold(0.0, f64::max);
    let square = EdgeMean::of(table, far).square / (4.0 * PI * PI);
    gravity * square * far - far * far
}

/// The fit with the radius of gyration that the periods about the far edge give, and the residuals of single periods.
fn described(table: &LengthTable, gravity: Uncertain) -> LengthFit {
    let rows = &table.rows;
    let gyration = gyration(table, gravity.value);
    let residual = |row: &LengthRow| {
        let height = row.length.abs();
        row.period - 2.0 * PI * row.ratio * ((height + gyration / height) / gravity.value).sqrt()
    };
    LengthFit {
        model: LengthModel::Reversible,
        g: gravity,
        offset: None,
        gyration: None,
        correlation: None,
        chi2: None,
        dof: 0,
        aicc: None,
        p_value: None,
        other_centre: None,
        residuals: rows.iter().map(residual).collect(),
        standard_deviations: rows.iter().map(|row| row.period_uncertainty).collect(),
        readings_degrees_of_freedom: table.readings.as_ref().map_or(f64::INFINITY, RepeatedReadings::pooled),
        scatter: None,
    }
}

/// The weighted mean of T² of small swings about one edge.
struct EdgeMean {
    square: f64,
    square_uncertainty: f64,
    length_uncertainty: f64,
}

impl EdgeMean {
    fn of(table: &LengthTable, length: f64) -> Self {
        let rows = || table.rows.iter().filter(|row| row.length.abs().total_cmp(&length).is_eq());
        let square = |row: &LengthRow| row.period * row.period / (row.ratio * row.ratio);
        let weight = |row: &LengthRow| {
            let uncertainty = 2.0 * square(row) * row.period_uncertainty / row.period;
            1.0 / (uncertainty * uncertainty)
        };
        let weights: f64 = rows().map(weight).sum();
        Self {
            square: rows().map(|row| weight(row) * square(row)).sum::<f64>() / weights,
            square_uncertainty: 1.0 / weights.sqrt(),
            length_uncertainty: rows().map(|row| row.length_uncertainty).fold(0.0, f64::max),
        }
    }
}
