//! Starts of the search: balances of one harmonic, which are linear in c² and A².
//!
//! (ω²(a) − Ω²)²a² + c²Ω²a² = A², with ω²(a) = ω0²·g(a) + ¾κa². For given ω0² and κ the best c² and A² follow at once, so that at most two
//! numbers are searched for on a grid.

use super::model::ResponseModel;
use super::required_drive::OneHarmonic;
use super::table::ResponseTable;
use libration::internals::InOrder;

/// Values of ω0² on the grid.
const SQUARES: u32 = 160;
/// ¾κa²/ω0² at the largest amplitude.
const CUBIC_PARTS: [f64; 19] = [
    -0.8, -0.6, -0.45, -0.3, -0.2, -0.12, -0.06, -0.02, 0.0, 0.02, 0.06, 0.12, 0.25, 0.5, 0.8, 1.3, 2.5, 5.0,
    10.0,
];
/// Number of the best points of the grid from which a search starts.
const BEST: usize = 5;
/// Initial damping, relative to the frequency, in place of zero, which has no sign to change.
const LEAST_DAMPING: f64 = 1e-3;

/// Starting parameters ω0², c, perhaps κ, and A, the best first.
pub(super) fn starts(table: &ResponseTable, model: ResponseModel) -> Vec<Vec<f64>> {
    let [low, high] = table.frequency_range();
    // A soft oscillator responds below its frequency, a hard one above.
    let (low, high) = (0.5 * low * low, 4.0 * high * high);
    let largest = table.largest_amplitude();
    let parts: &[f64] = if model == ResponseModel::Duffing { &CUBIC_PARTS } else { &[0.0] };
    let mut best: Vec<(f64, Vec<f64>)> = vec![];
    for part in parts {
        let mut of_part: Vec<(f64, Vec<f64>)> = (0..=SQUARES)
            .map(|step| {
                let square = low * libm::exp(f64::from(step) / f64::from(SQUARES) * libm::log(high / low));
                let cubic = part * square / (0.75 * largest * largest);
                with_linear_part(table, model, square, cubic)
            })
            .collect();
        of_part.put_in_order(|a, b| a.0.total_cmp(&b.0));
        of_part.truncate(if parts.len() > 1 { 1 } else { BEST });
        best.extend(of_part);
    }
    best.put_in_order(|a, b| a.0.total_cmp(&b.0));
    best.truncate(BEST);
    best.into_iter().map(|(_, parameters)| parameters).collect()
}

/// The sum of the squared misfits relative to A², and the parameters.
fn with_linear_part(table: &ResponseTable, model: ResponseModel, square: f64, cubic: f64) -> (f64, Vec<f64>) {
    let coefficients = [square, 0.0, cubic];
    let terms = || {
        table.rows.iter().map(|row| {
            let elastic = OneHarmonic(model).resonance_squared(row.amplitude, &coefficients)
                - row.frequency * row.frequency;
            let weight = row.amplitude / row.amplitude_uncertainty;
            let amplitude = row.amplitude * row.amplitude;
            (weight * weight, elastic * elastic * amplitude, row.frequency * row.frequency * amplitude)
        })
    };
    // The means, and the slope of the elastic against the damping force.
    let total: f64 = terms().map(|(weight, ..)| weight).sum();
    let elastic: f64 = terms().map(|(weight, elastic, _)| weight * elastic).sum::<f64>() / total;
    let viscous: f64 = terms().map(|(weight, _, viscous)| weight * viscous).sum::<f64>() / total;
    let both: f64 = terms().map(|(w, e, v)| w * (e - elastic) * (v - viscous)).sum();
    let alone: f64 = terms().map(|(w, _, v)| w * (v - viscous) * (v - viscous)).sum();
    let damping = if alone > 0.0 { (-both / alone).max(0.0) } else { 0.0 };
    let drive = elastic + damping * viscous;
    let misfit: f64 = terms()
        .map(|(w, e, v)| {
            let miss = (e + damping * v) / drive - 1.0;
            w * miss * miss
        })
        .sum();
    let damping = damping.sqrt().max(LEAST_DAMPING * square.sqrt());
    let mut parameters = vec![square, damping];
    parameters.extend((model == ResponseModel::Duffing).then_some(cubic));
    parameters.push(drive.sqrt());
    (misfit, parameters)
}
