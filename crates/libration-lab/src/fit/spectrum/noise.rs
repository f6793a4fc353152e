//! The noise about each harmonic.

use super::window_fit::{Wave, WindowFit};
use crate::statistics::count;

/// Distance from a harmonic, in orders: two waves from both lines in a window of five swings, where a further whole wave fits in.
const BESIDE: f64 = 0.4;
/// Fewest waves of a band; with fewer, all residuals are used together as if the noise were white, as for windows of three swings.
const FEWEST: usize = 4;
/// Smallest fraction of a wave outside the span of the columns: with less, it has too little information about the noise.
const LEAST_FREE: f64 = 0.3;

/// The variance of a row that noise about a harmonic would have if it were white.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Noise {
    pub(super) variance: f64,
    pub(super) degrees_of_freedom: usize,
}

/// The noise about each harmonic from n = 0, in all windows together.
pub(super) fn about_harmonics(fits: &[WindowFit], highest: usize) -> Vec<Noise> {
    (0..=highest).map(|n| about(fits, n)).collect()
}

fn about(fits: &[WindowFit], n: usize) -> Noise {
    let order = count(n);
    let beside = if n == 0 { [BESIDE, 1.0 - BESIDE] } else { [order - BESIDE, order + BESIDE] };
    let waves = fits.iter().flat_map(|fit| beside.into_iter().flat_map(|multiple| fit.noise_at(multiple)));
    let waves: Vec<Wave> = waves.filter(|wave| wave.free > LEAST_FREE * wave.whole).collect();
    if waves.len() < FEWEST {
        return of_all(fits);
    }
    let square: f64 = waves.iter().map(|wave| wave.square).sum();
    let free: f64 = waves.iter().map(|wave| wave.free).sum();
    Noise { variance: square / free, degrees_of_freedom: waves.len() }
}

fn of_all(fits: &[WindowFit]) -> Noise {
    let chi2: f64 = fits.iter().map(WindowFit::chi2).sum();
    let degrees_of_freedom = fits.iter().map(WindowFit::degrees_of_freedom).sum();
    Noise { variance: chi2 / count(degrees_of_freedom), degrees_of_freedom }
}
