//! `libration figure motion`: the angle in time after release from several amplitudes.

use super::PictureOptions;
use super::releases::releases;
use crate::arguments::{self, AngleList};
use crate::figure::chart::Picture;
use crate::figure::motion::{self, DrawnRelease};
use crate::query_error::{QueryError, option};
use libration::pendulum::Pendulum;
use std::f64::consts::TAU;

/// The angle in time after release from several amplitudes, with the small-angle cosine
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration figure motion --output motion.svg
  libration figure motion --amplitudes 30deg,90deg,179deg --periods 3 \\
    --output motion.png")
)]
pub(super) struct MotionFigure {
    /// Angles of release
    #[arg(long, default_value = "30deg,90deg,150deg,179deg", value_parser = arguments::angle_list)]
    amplitudes: AngleList,
    /// Number of small-angle periods to show
    #[arg(long, default_value = "2", value_parser = arguments::positive)]
    periods: f64,
    #[command(flatten)]
    pub(super) options: PictureOptions,
}

impl MotionFigure {
    pub(super) fn picture(&self) -> Result<Picture, QueryError> {
        let no_answer = |error| QueryError::no_result(option("amplitudes"), error);
        let pendulum = Pendulum::from_angular_frequency(TAU).map_err(no_answer)?;
        let mut swings = vec![];
        for release in releases(&self.amplitudes)? {
            let motion = pendulum.released_from(release.angle).map_err(no_answer)?;
            swings.push(DrawnRelease { label: release.label, amplitude: release.angle.radians(), motion });
        }
        Ok(motion::releases(&swings, self.periods))
    }
}
