//! Fit of the time of a passage of the centre: through the inverse of the shape of a swing, values near it lie on a line in time, or nearly so.

use super::local_fit::{Points, powers};
use super::shape::Shape;
use super::window::Window;

/// Fraction of the extreme up to which rows are used; beyond it their noise would be stretched. With 0.5 periods were less certain by up to a
/// factor of two in 11 of 24 recordings (`mod.rs`), and the coarsest had 14 cycles for 80; with 0.95 β moved by up to two uncertainties in the five
/// by an encoder that have one.
const REACH: f64 = 0.8;
/// Number of points above which the curve has a term of second order: with 4 one recording by a camera had an outlier, with 10 β moved by half of
/// its uncertainty in two.
const POINTS_FOR_SQUARE: usize = 6;
/// Number of points for a term of third order: with 6 one by a camera had less certain periods, with 20 only one uncertainty changed, by a tenth.
const POINTS_FOR_CUBE: usize = 10;
/// Smallest slope of a passage: with 1, the inverse of the shape rises by one in a quarter period. With 0.1
/// and 0.4 nothing changed.
const LEAST_SLOPE: f64 = 0.2;
/// Smallest distance from the extreme, in quarter periods, at which a row is used: with 0.03 and 0.3 nothing changed.
const NEAREST: f64 = 0.1;
/// Rounds: with 2 and 6 nothing changed.
const ROUNDS: usize = 3;

/// A passage of the centre.
#[derive(Clone, Copy, Debug)]
pub(super) struct CentrePassage {
    /// Time in seconds.
    pub(super) time: f64,
    /// Standard uncertainty by the noise, in seconds.
    pub(super) uncertainty: f64,
}

/// Fits the passage between two turning points, and returns it with the residuals in units of the noise that is known or is to be found.
///
/// `extreme` is the mean size of the extremes before and after the passage; `about` is its approximate
/// time, and `quarter` a quarter of the period.
pub(super) fn passage(
    window: &Window<'_>,
    shape: &Shape,
    extreme: f64,
    about: f64,
    quarter: f64,
    noise: Option<f64>,
) -> Option<(CentrePassage, Vec<f64>)> {
    let reach = quarter * shape.time_since_zero(REACH);
    let near: Vec<(f64, f64, f64)> = window.rows(about - reach, about + reach).collect();
    let both_sides = near.iter().any(|row| row.0 <= about) && near.iter().any(|row| row.0 >= about);
    if near.len() < 2 || !both_sides {
        return None;
    }
    let order = match near.len() {
        POINTS_FOR_CUBE.. => 3,
        POINTS_FOR_SQUARE.. => 2,
        _ => 1,
    };
    let (time_since_zero, slope_at) =
        (shape.time_since_zero_for(near.len()), shape.slope_near_zero_for(near.len(), NEAREST));
    let parts: Vec<f64> = near.iter().map(|row| time_since_zero(row.1 / extreme)).collect();
    let mut centre = about;
    let mut last = None;
    // The curve is read where it is zero, so it is fitted again about that point.
    for _ in 0..ROUNDS {
        let mut points = Points::with_width(order + 1);
        for (&(time, _, deviation), &part) in near.iter().zip(&parts) {
            let x = (time - centre) / quarter;
            // Noise counts as it does where the value should be, not where it is.
            points.push(powers(x, 1.0), part, deviation * slope_at(x) / extreme);
        }
        let fit = points.fit(noise)?;
        let slope = fit.coefficients[1];
        if slope.abs() < LEAST_SLOPE {
            return None;
        }
        centre -= quarter * (fit.coefficients[0] / slope).clamp(-0.5, 0.5);
        let spread = noise.unwrap_or(1.0) * fit.covariance[(0, 0)].sqrt() * quarter / slope.abs();
        last = Some((CentrePassage { time: centre, uncertainty: spread }, fit.residuals));
    }
    last
}
