//! Normal gravity at a latitude and height, with which a measured g is compared.
//!
//! # Method
//! Somigliana's closed form on the ellipsoid of the Geodetic Reference System 1980, γ = γe(1 + k sin²φ)/√(1 − e² sin²φ), and above it the free-air term
//! to the second power of the height, γ(1 − 2(1 + f + m − 2f sin²φ)h/a + 3h²/a²). What is left at a place is its anomaly, by the density and the shape
//! of the ground: its standard deviation is taken as 3·10⁻⁴ m/s² in lowland and 10⁻³ m/s² in mountains.
//!
//! # Accuracy
//! 10⁻⁸ m/s² on the ellipsoid, 5·10⁻⁷ m/s² below 3 km, of the normal field, far below the anomaly.
//!
//! # References
//! H. Moritz, *Geodetic Reference System 1980*, Bull. Géod. 54, 395 (1980), doi:10.1007/BF02521480; the free-air term: W. A. Heiskanen and H. Moritz,
//! *Physical Geodesy*, eq. 2-123 (1967).

use super::uncertain::Uncertain;

/// Normal gravity at the equator, in m/s².
const AT_EQUATOR: f64 = 9.780_326_771_5;
/// k = (bγp − aγe)/(aγe).
const RISE: f64 = 0.001_931_851_353;
/// e², the square of the first eccentricity.
const ECCENTRICITY_SQUARE: f64 = 0.006_694_380_022_90;
/// a, the equatorial radius, in metres.
const EQUATORIAL_RADIUS: f64 = 6_378_137.0;
/// f, the flattening.
const FLATTENING: f64 = 0.003_352_810_681_18;
/// m = ω²a²b/GM.
const CENTRIFUGAL: f64 = 0.003_449_786_003_08;

/// Standard uncertainty of gravity by the local anomaly in lowland, in m/s².
const ANOMALY_IN_LOWLAND: f64 = 3e-4;
/// The uncertainty by that anomaly in mountains, and where the height is not known.
const ANOMALY_IN_MOUNTAINS: f64 = 1e-3;
/// Height in metres above which a place counts as in mountains.
const HEIGHT_OF_MOUNTAINS: f64 = 500.0;
/// Heights of places on the surface of the Earth, in metres, with a margin.
const HEIGHTS: std::ops::RangeInclusive<f64> = -500.0..=9000.0;

/// Reasons for the lack of a normal gravity.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum NormalGravityError {
    /// A latitude beyond the poles, in radians.
    #[error("a latitude of {:.6} deg is beyond the poles: give -90 to 90 deg", .0.to_degrees())]
    Latitude(f64),
    /// A height that is not on the surface of the Earth, in metres.
    #[error("a height of {0:?} m is not on the surface of the Earth: give -500 to 9000 m")]
    Height(f64),
}

/// Normal gravity in m/s² at a geodetic latitude in radians and a height in metres above the ellipsoid, for which that above sea level will do; its
/// standard uncertainty is that of the local anomaly. Without a height, that of the sea is taken, with the uncertainty in mountains, which covers 300 m.
///
/// # Errors
/// Fails for a latitude beyond the poles and a height that is not on the surface of the Earth.
///
/// # Examples
/// ```
/// use libration_lab::fit::normal_gravity;
/// let here = normal_gravity(48.0_f64.to_radians(), Some(300.0))?;
/// assert_eq!(here.to_string(), "9.80798 ± 0.00030");
/// # Ok::<(), libration_lab::fit::NormalGravityError>(())
/// ```
pub fn normal_gravity(latitude: f64, height: Option<f64>) -> Result<Uncertain, NormalGravityError> {
    // A latitude of 90 deg may be rounded up.
    if latitude.is_nan() || latitude.abs() > std::f64::consts::FRAC_PI_2 * (1.0 + f64::EPSILON) {
        return Err(NormalGravityError::Latitude(latitude));
    }
    if let Some(height) = height.filter(|height| !HEIGHTS.contains(height)) {
        return Err(NormalGravityError::Height(height));
    }
    let sine = libm::sin(latitude);
    let square = sine * sine;
    let on_ellipsoid = AT_EQUATOR * (1.0 + RISE * square) / (1.0 - ECCENTRICITY_SQUARE * square).sqrt();
    let part = height.unwrap_or(0.0) / EQUATORIAL_RADIUS;
    let linear = 2.0 * (1.0 + FLATTENING + CENTRIFUGAL - 2.0 * FLATTENING * square);
    let is_lowland = height.is_some_and(|height| height <= HEIGHT_OF_MOUNTAINS);
    Ok(Uncertain {
        value: on_ellipsoid * (1.0 - linear * part + 3.0 * part * part),
        uncertainty: if is_lowland { ANOMALY_IN_LOWLAND } else { ANOMALY_IN_MOUNTAINS },
    })
}
