//! Starting points of searches over all amplitudes, not too dense at the bottom or the top.

use super::swing::SwingAmplitude;
use libration_kernels::double_double::DoubleDouble;

/// The coordinate of the search: u = ln(θ0/(π − θ0)). The bottom, where errors are powers of θ0, and the top, where they are powers of 1/u, are
/// both at infinity.
pub(super) type Coordinate = f64;

/// θ0 = 3e-150.
const LOWEST: Coordinate = -345.0;
/// π − θ0 = 8e-300.
const HIGHEST: Coordinate = 688.0;
/// End of the evenly spaced points, counted from 0; beyond it the spacing grows by a constant factor.
const EVEN: Coordinate = 8.0;
const STEPS_PER_UNIT: i16 = 16;
const GROWTH: f64 = 1.15;

/// The starting points of every search, in increasing order.
pub(super) fn points() -> Vec<Coordinate> {
    let half = 8 * STEPS_PER_UNIT;
    let even = (-half..=half).map(|i| f64::from(i) / f64::from(STEPS_PER_UNIT));
    let mut below: Vec<_> = growing(-LOWEST).map(|u| -u).collect();
    below.reverse();
    below.into_iter().chain(even).chain(growing(HIGHEST)).collect()
}

fn growing(last: f64) -> impl Iterator<Item = f64> {
    let ahead =
        std::iter::successors(Some(EVEN * GROWTH), |u| Some(u * GROWTH)).take_while(move |u| *u < last);
    ahead.chain(std::iter::once(last))
}

pub(super) fn amplitude_at(u: Coordinate) -> SwingAmplitude {
    let smaller = std::f64::consts::PI / (1.0 + libm::exp(u.abs()));
    let words = DoubleDouble::from(smaller);
    if u <= 0.0 { SwingAmplitude::FromBottom(words) } else { SwingAmplitude::FromTop(words) }
}

/// The coordinate of an amplitude, limited to the range of the search.
pub(super) fn coordinate_of(amplitude: SwingAmplitude) -> Coordinate {
    let quotient = amplitude.radians() / amplitude.complement();
    libm::log(quotient).clamp(LOWEST, HIGHEST)
}
