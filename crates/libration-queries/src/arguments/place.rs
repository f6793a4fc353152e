//! The place of a measurement, and its normal gravity.

use super::text;
use crate::query_error::{QueryError, option};
use libration_lab::fit::{NormalGravityError, Uncertain, normal_gravity};

/// The place of a measurement.
#[derive(Clone, Copy, Debug, clap::Args)]
#[command(next_help_heading = "Place, for the normal gravity there")]
pub(crate) struct PlaceOptions {
    /// Geographic latitude, such as 48.1deg, or -33.9deg in the south: gives the normal gravity there next to the result
    #[arg(long, value_name = "ANGLE", value_parser = text::latitude, allow_hyphen_values = true)]
    latitude: Option<f64>,
    /// Elevation, the height above sea level, such as 520m [default: not known]
    #[arg(long, value_name = "LENGTH", value_parser = text::elevation, requires = "latitude", allow_hyphen_values = true)]
    elevation: Option<f64>,
}

impl PlaceOptions {
    /// Normal gravity at the place; `None` without a latitude.
    ///
    /// # Errors
    /// Fails for a place that is not on the Earth.
    pub(crate) fn normal_gravity(&self) -> Result<Option<Uncertain>, QueryError> {
        let Some(latitude) = self.latitude else { return Ok(None) };
        normal_gravity(latitude, self.elevation).map(Some).map_err(|error| {
            let of_height = matches!(error, NormalGravityError::Height(_));
            QueryError::usage(option(if of_height { "elevation" } else { "latitude" }), error)
        })
    }
}
