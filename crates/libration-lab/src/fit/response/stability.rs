//! The stability of a response by the map of deviations over half a period.

use libration::orbit::Stability;

/// The stability that a map of deviations over half a period establishes within its errors, when the exact factor of their area is known and the map is
/// integrated to a relative tolerance.
///
/// # Method
/// Under linear damping that factor is exp(−∫c dt) (Liouville's theorem). The difference of the map's determinant from it shows the error of the map, with
/// that of the trace the multipliers λ² − λ·trace + area = 0.
pub fn stability(map: [[f64; 2]; 2], area: f64, tolerance: f64) -> Stability {
    /// The factor between the error of the trace and that of the determinant, which is one combination of the errors of four entries.
    const MARGIN: f64 = 16.0;
    /// Roundings of a multiplier.
    const ROUNDINGS: f64 = 8.0;
    let [[a, b], [c, d]] = map;
    let size = map.iter().flatten().fold(1.0, |size: f64, entry| size.max(entry.abs()));
    let off = ((a * d - b * c - area) / size).abs().max(tolerance * size);
    let trace = (a + d).abs();
    let largest = |trace: f64| {
        let half = 0.5 * trace;
        let square = half * half - area;
        if square > 0.0 { half + square.sqrt() } else { area.sqrt() }
    };
    let [multiplier, upper] = [trace, trace + MARGIN * off].map(largest);
    let rounding = ROUNDINGS * f64::EPSILON;
    let both = [(multiplier, upper - multiplier), (area / multiplier, area / multiplier - area / upper)];
    Stability::of(both.map(|(size, error)| (size, error + rounding * size)))
}
