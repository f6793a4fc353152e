//! `libration figure spectrum`: the harmonics of the angle.

use super::PictureOptions;
use super::releases::releases;
use crate::arguments::{self, AngleList};
use crate::figure::chart::Picture;
use crate::figure::spectrum::spectra;
use crate::query_error::{QueryError, option};
use libration::pendulum::Pendulum;

/// The highest harmonic that may be requested.
const HIGHEST: usize = 4000;

/// The harmonics of the angle at several amplitudes
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration figure spectrum --output spectrum.svg
  libration figure spectrum --amplitudes 60deg,150deg,179deg --harmonics 61 \\
    --output spectrum.png")
)]
pub(super) struct Spectrum {
    /// The amplitudes
    #[arg(long, default_value = "30deg,90deg,150deg,179deg", value_parser = arguments::angle_list)]
    amplitudes: AngleList,
    /// The smallest coefficient shown, in radians
    #[arg(long, default_value = "1e-16", value_parser = arguments::positive)]
    lowest: f64,
    /// The highest harmonic
    #[arg(long, alias = "highest", default_value = "41", value_parser = arguments::count::<HIGHEST>)]
    harmonics: usize,
    #[command(flatten)]
    pub(super) options: PictureOptions,
}

impl Spectrum {
    pub(super) fn picture(&self) -> Result<Picture, QueryError> {
        let no_answer = |error| QueryError::no_result(option("amplitudes"), error);
        let pendulum = Pendulum::from_angular_frequency(1.0).map_err(no_answer)?;
        let mut shown = vec![];
        for release in releases(&self.amplitudes)? {
            let motion = pendulum.released_from(release.angle).map_err(no_answer)?;
            let mut harmonics = motion.harmonics(self.lowest, self.harmonics);
            harmonics.terms.retain(|term| term.n <= self.harmonics);
            shown.push((release.label, harmonics));
        }
        Ok(spectra(&shown, self.lowest))
    }
}
