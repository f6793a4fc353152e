//! Fit of the extreme between two passages: the shape of a swing times a polynomial of a few coefficients.

use super::local_fit::{Points, powers};
use super::shape::Shape;
use super::turning_point::Extreme;
use super::window::Window;

/// Fraction of the quarter periods before and after the extreme that is used. With 0.5 amplitudes were less certain by a tenth to a fifth in 15 of
/// 24 recordings (`mod.rs`), with 0.95 more certain in none.
const REACH: f64 = 0.75;
/// Number of points above which the swing may be skewed: with 2 and 8 nothing changed in any recording.
const POINTS_FOR_SKEWNESS: usize = 4;
/// Number of points above which the length of the swing is free: with 4 the coarsest recording, of ten rows in a period, had amplitudes and β less
/// certain by a quarter; with 12 β moved by half of its uncertainty in two.
const POINTS_FOR_LENGTH: usize = 6;
/// Largest distance of the extreme from the middle, in quarter periods: with 0.1 and 0.6 nothing changed.
const FURTHEST: f64 = 0.3;

/// Fits the extreme between the passages at these two times, and returns it with the residuals in units of the noise.
pub(super) fn extreme(
    window: &Window<'_>,
    shape: &Shape,
    passages: [f64; 2],
    noise: Option<f64>,
) -> Option<(Extreme, Vec<f64>)> {
    let (middle, quarter) = (0.5 * (passages[0] + passages[1]), 0.5 * (passages[1] - passages[0]));
    let near: Vec<(f64, f64, f64)> =
        window.rows(middle - REACH * quarter, middle + REACH * quarter).collect();
    let order = match near.len() {
        POINTS_FOR_LENGTH.. => 2,
        POINTS_FOR_SKEWNESS.. => 1,
        _ => 0,
    };
    let both_sides = near.iter().any(|row| row.0 <= middle) && near.iter().any(|row| row.0 >= middle);
    if near.len() < 2 || !both_sides {
        return None;
    }
    let form = shape.near_extreme_for(near.len(), REACH);
    let mut points = Points::with_width(order + 1);
    for &(time, value, deviation) in &near {
        let x = (time - middle) / quarter;
        points.push(powers(x, form(x)), value, deviation);
    }
    let fit = points.fit(noise)?;
    let coefficient = |power: usize| fit.coefficients.get(power).copied().unwrap_or(0.0);
    // (1 − κx²/2)(a + bx + cx²) is highest at x = b/(κa − 2c).
    let [height, skewness, length] = [0, 1, 2].map(coefficient);
    let bend = shape.curvature() * height - 2.0 * length;
    let offset = if bend * height > 0.0 { (skewness / bend).clamp(-FURTHEST, FURTHEST) } else { 0.0 };
    let value = shape.near_extreme(offset) * (height + offset * (skewness + offset * length));
    let uncertainty = noise.unwrap_or(1.0) * fit.covariance[(0, 0)].sqrt();
    Some((Extreme { time: middle + offset * quarter, value, uncertainty }, fit.residuals))
}
