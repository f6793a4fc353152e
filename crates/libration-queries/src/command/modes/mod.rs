//! `libration modes`: small oscillations of a system, and their change with the amplitude.

mod fields;
mod follow;
mod write;

use crate::arguments::{EquilibriumOptions, SystemOptions};
use crate::figure;
use crate::interrupt;
use crate::output::{Form, FormOptions, announce};
use crate::parallel;
use crate::query_error::{QueryError, argument, option};
use follow::{FollowOptions, FollowedMode};
use libration::nonlinear_modes::{NonlinearMode, NonlinearModeError};
use libration::normal_modes::NormalModes;
use libration::systems::Model;
use std::io::Write;
use std::path::PathBuf;

pub(crate) use fields::answers;

/// The normal modes of a system about an equilibrium: frequencies and shapes, exact where possible, and their change with the amplitude
///
/// Shapes are scaled so that their largest part is 1. With a the amplitude of that coordinate, the frequency is
/// Ω = ω + κa² as long as a is small.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration modes double_pendulum
  libration modes spring_pendulum --json
  libration modes coupled_pendulums --figure shapes.svg
  libration modes \"x'' = y - 2*x - x^3; y'' = x - 2*y\"
  libration modes pendulum --about theta=180deg
  libration modes double_pendulum --follow 2 --amplitudes 10deg:80deg:10deg")
)]
pub(crate) struct Modes {
    #[command(flatten)]
    system: SystemOptions,
    #[command(flatten)]
    equilibrium: EquilibriumOptions,
    #[command(flatten)]
    follow: FollowOptions,
    /// Draw the shapes to FILE.svg, .pdf, .png or .json
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
}

/// The result to write.
struct ModesResult {
    model: Model,
    modes: NormalModes,
}

impl Modes {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let model = self.system.model()?;
        let guess = self.equilibrium.guess(&model)?;
        interrupt::listen()?;
        let modes = parallel::unless_cancelled("the modes", |progress| {
            NormalModes::about(model.equation(), &guess, progress)
        });
        let early = || QueryError::cancelled("interrupted before the modes were known: nothing is written");
        let modes = modes.ok_or_else(early)?;
        let modes = modes.map_err(|error| QueryError::no_result(argument("SYSTEM|EQUATION"), error))?;
        if let Some(number) = self.follow.follow {
            return self.followed(out, model, &modes, number - 1);
        }
        let answer = ModesResult { model, modes };
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::modes::shapes(&answer.model, &answer.modes))
        })?;
        match self.form.form() {
            Form::Json => write::json(out, &answer)?,
            Form::Csv => write::csv(out, &answer)?,
            Form::Table => write::sheets(out, &answer)?,
        }
        Ok(announce(out, self.form.form(), &drawn)?)
    }

    /// The mode with a number from 0 followed in amplitude.
    fn followed(
        &self,
        out: &mut dyn Write,
        model: Model,
        modes: &NormalModes,
        mode: usize,
    ) -> Result<(), QueryError> {
        let coordinate = self.follow.coordinate(&model)?;
        let amplitudes = self.follow.amplitudes(&model.coordinates()[coordinate])?;
        let mode_family = parallel::unless_cancelled("the orbits of the mode", |progress| {
            NonlinearMode::follow(model.equation(), modes, mode, coordinate, &amplitudes, progress)
        });
        let early = || QueryError::cancelled("interrupted before the orbits were known: nothing is written");
        let branch = mode_family.ok_or_else(early)?.map_err(|error| match error {
            NonlinearModeError::NoMode { .. } => QueryError::usage(option("follow"), error),
            NonlinearModeError::AtRest(_) => QueryError::usage(option("coordinate"), error),
            _ => QueryError::no_result(option("follow"), error),
        })?;
        let followed = FollowedMode { model, mode, coordinate, branch };
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::nonlinear_modes::backbone(
                &followed.model,
                followed.mode,
                followed.coordinate,
                &followed.branch,
            ))
        })?;
        followed.write(out, self.form.form())?;
        Ok(announce(out, self.form.form(), &drawn)?)
    }
}
