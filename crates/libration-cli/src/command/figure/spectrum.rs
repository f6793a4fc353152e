//! `libration figure spectrum`: the harmonics of the angle.

use super::PictureOptions;
use super::releases::releases;
use crate::arguments::{self, AngleList};
use crate::failure::Failure;
use crate::figure::chart::Picture;
use crate::figure::spectrum::spectra;
use libration::pendulum::Pendulum;

/// More harmonics than a picture can show apart.
const LIMIT: usize = 2000;

/// Harmonics of the angle at several amplitudes
#[derive(Debug, clap::Args)]
pub(super) struct Spectrum {
    /// Amplitudes
    #[arg(long, default_value = "30deg,90deg,150deg,179deg", value_parser = arguments::angle_list)]
    amplitudes: AngleList,
    /// The smallest coefficient shown, in radians
    #[arg(long, default_value = "1e-16", value_parser = arguments::positive)]
    lowest: f64,
    /// The highest harmonic shown
    #[arg(long, default_value = "41", value_parser = clap::value_parser!(u32).range(1..=4000))]
    highest: u32,
    #[command(flatten)]
    pub(super) options: PictureOptions,
}

impl Spectrum {
    pub(super) fn picture(&self) -> Result<Picture, Failure> {
        let no_answer = |error| Failure::no_answer("--amplitudes", error);
        let pendulum = Pendulum::from_angular_frequency(1.0).map_err(no_answer)?;
        let mut shown = vec![];
        for release in releases(&self.amplitudes)? {
            let motion = pendulum.released_from(release.angle).map_err(no_answer)?;
            let mut harmonics = motion.harmonics(self.lowest, LIMIT);
            harmonics.terms.retain(|term| u32::try_from(term.n).is_ok_and(|n| n <= self.highest));
            shown.push((release.label, harmonics));
        }
        Ok(spectra(&shown, self.lowest))
    }
}
