//! `libration figure phase`: the phase portrait.

use super::PictureOptions;
use super::releases::releases;
use crate::arguments::{self, AngleList};
use crate::figure::chart::Picture;
use crate::figure::phase::{Orbit, Portrait, portrait};
use crate::output::number;
use crate::query_error::QueryError;
use libration::pendulum::{Pendulum, PendulumError};

/// The phase portrait: librations, the separatrix, and rotations
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration figure phase --output phase.svg
  libration figure phase --amplitudes 45deg,135deg --energies 1.5 \\
    --output phase.png")
)]
pub(super) struct Phase {
    /// Amplitudes of the librations
    #[arg(long, default_value = "30deg,75deg,120deg,160deg", value_parser = arguments::angle_list)]
    amplitudes: AngleList,
    /// Energies of the rotations, E/(2mgl), each above 1
    #[arg(long, value_name = "E,E", default_value = "1.3,2", value_delimiter = ',', value_parser = above_one)]
    energies: Vec<f64>,
    #[command(flatten)]
    pub(super) options: PictureOptions,
}

impl Phase {
    pub(super) fn picture(&self) -> Result<Picture, QueryError> {
        let pendulum = Pendulum::from_angular_frequency(1.0).map_err(no_answer)?;
        Ok(portrait(&Portrait {
            librations: self.librations(&pendulum)?,
            separatrix: pendulum.on_separatrix(),
            rotations: self.rotations(&pendulum)?,
        }))
    }

    fn librations(&self, pendulum: &Pendulum) -> Result<Vec<Orbit>, QueryError> {
        let orbit = |release: super::releases::Release| {
            let motion = pendulum.released_from(release.angle).map_err(no_answer)?;
            Ok(Orbit { label: format!("libration, {}", release.label), motion })
        };
        releases(&self.amplitudes)?.into_iter().map(orbit).collect()
    }

    fn rotations(&self, pendulum: &Pendulum) -> Result<Vec<Orbit>, QueryError> {
        let orbit = |&energy: &f64| {
            let motion = pendulum.with_energy_ratio(energy).map_err(no_answer)?;
            Ok(Orbit { label: format!("rotation, E = {} × 2mgl", number::short(energy, 6)), motion })
        };
        self.energies.iter().map(orbit).collect()
    }
}

fn no_answer(error: PendulumError) -> QueryError {
    QueryError::no_result("phase portrait", error)
}

fn above_one(text: &str) -> Result<f64, String> {
    let energy = arguments::positive(text).ok().filter(|energy| *energy > 1.0);
    energy.ok_or_else(|| {
        "a rotation has more than the energy of the separatrix: give a number above 1".to_owned()
    })
}
