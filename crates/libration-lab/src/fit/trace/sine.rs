//! The sine through the first rows of a trace, from which a search begins where the rows between gaps are too few for the weak form.

use std::f64::consts::TAU;

use libration::progress::Quiet;
use nalgebra::{DMatrix, DVector};

use crate::fit::spectrum::lomb_scargle;
use crate::statistics::least_squares;

/// A sine and a constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sine {
    /// Angular frequency in rad/s.
    pub(super) frequency: f64,
    pub(super) constant: f64,
    /// The sine and its derivative at the first time.
    pub(super) state: [f64; 2],
}

/// Most and fewest rows of a search for the frequency. Of 228 traces with gaps one was lost with a fewest of 12 rows, and 20 with 30; with
/// at most 200 rows all ended alike.
const ROWS: [usize; 2] = [1000, 12];
/// Least part of the variance that a sine explains: noise exceeds it at one frequency with a probability of 0.2^4.5 = 7e-4 for twelve rows (Zechmeister
/// and Kürster, see [`lomb_scargle`]). With 0.5 all of 436 traces ended alike; with 0.95 seventeen more were lost, and with
/// none two sines of one size were fitted.
const EXPLAINED: f64 = 0.8;

/// Fits the sine to the first two swings, with the frequency that explains as many of the first rows as possible; `None` if none does.
pub(super) fn sine(times: &[f64], values: &[f64]) -> Option<Sine> {
    let halved = |rows: &usize| Some(rows / 2).filter(|rows| *rows >= ROWS[1]);
    let frequency = std::iter::successors(Some(times.len().min(ROWS[0])), halved)
        .find_map(|rows| frequency(&times[..rows], &values[..rows]))?;
    let phases: Vec<f64> = times.iter().map(|time| frequency * (time - times[0])).collect();
    let rows = phases.partition_point(|phase| *phase < 2.0 * TAU).max(6).min(times.len());
    let column =
        |of: fn(f64) -> f64| DVector::from_iterator(rows, phases[..rows].iter().map(|phase| of(*phase)));
    let columns = [column(|_| 1.0), column(libm::cos), column(libm::sin)];
    let values = DVector::from_row_slice(&values[..rows]);
    let fitted = least_squares(&DMatrix::from_columns(&columns), &values).ok()?.coefficients;
    Some(Sine { frequency, constant: fitted[0], state: [fitted[1], frequency * fitted[2]] })
}

/// The angular frequency of the sine that explains most; `None` if it explains too little.
fn frequency(times: &[f64], values: &[f64]) -> Option<f64> {
    let span = times.last()? - times.first()?;
    let spectrum = lomb_scargle(times, values, None, 0.125 / span, 4 * times.len(), &Quiet).ok()?;
    let possible = spectrum.into_iter().filter(|point| point.power >= EXPLAINED);
    Some(TAU * possible.max_by(|a, b| a.power.total_cmp(&b.power))?.frequency)
}
