//! Releases from rest at several amplitudes, for the pictures.

use crate::arguments::AngleList;
use crate::output::number;
use crate::query_error::{QueryError, option};
use libration::pendulum::Amplitude;
use libration::quantity::Angle;

/// The angle of a release and its name in the legend.
pub(super) struct Release {
    pub(super) angle: Angle,
    pub(super) label: String,
}

/// The releases from these angles, each of which must give a swing.
pub(super) fn releases(angles: &AngleList) -> Result<Vec<Release>, QueryError> {
    angles.iter().map(|angle| release(*angle)).collect()
}

fn release(angle: Angle) -> Result<Release, QueryError> {
    let amplitude =
        Amplitude::new(angle).map_err(|error| QueryError::no_result(option("amplitudes"), error))?;
    if amplitude.radians() <= 0.0 {
        return Err(QueryError::no_result(
            option("amplitudes"),
            "a pendulum released from 0 does not move: give a larger angle",
        ));
    }
    Ok(Release { angle, label: label(&angle) })
}

/// Degrees, or the distance from the top if degrees would be rounded to 180.
fn label(angle: &Angle) -> String {
    if angle.complement() < 1e-5 {
        return format!("π − {} rad", number::short(angle.complement(), 3));
    }
    format!("{}°", number::short(angle.degrees(), 7))
}
