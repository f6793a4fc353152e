//! `libration decay`: the amplitude of a damped pendulum, integrated and by two laws.

mod options;
mod report;
mod write;

use crate::arguments::{self, PendulumOptions};
use crate::failure::Failure;
use crate::figure;
use crate::output::FormOptions;
use libration::pendulum::Pendulum;
use libration::quantity::Angle;
use options::{DampingOptions, Extent};
use std::io::Write;
use std::path::PathBuf;

pub(crate) use report::{Report, Turn};

/// How the swings of a damped pendulum die down, cycle by cycle
///
/// The amplitude by integration of θ″ + Σ cₙ θ′|θ′|ⁿ⁻¹ + ω0² sin θ = 0, beside the one by averaging, dE/dt being the mean over a cycle
/// without damping with exact integrals at any amplitude, and beside the law of small amplitudes; the time of each cycle
/// beside the exact period of the amplitude in its middle.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration decay 60deg --linear 0.1                        viscous damping, 20 cycles
  libration decay 1 --quadratic 0.1 --omega0 1 --cycles 4   drag of a fast flow, in units of the pendulum's own time
  libration decay 90deg --dry 0.2 --linear 0.02             until dry friction holds it
  libration decay 150deg --quadratic 0.05 --until 60s --figure decay.svg
  libration decay 40deg --power 1.5:0.1 --csv               any power of the velocity

Coefficients are per moment of inertia, in SI units: a drag torque of b kg m²/s times θ′ on a pendulum of ml² has c = b/(ml²).")]
pub(crate) struct Decay {
    /// The amplitude of the release from rest, such as 60deg, 1.2rad, pi-1e-6
    #[arg(value_parser = arguments::angle)]
    amplitude: Angle,
    #[command(flatten)]
    damping: DampingOptions,
    #[command(flatten)]
    extent: Extent,
    /// Draw amplitude and period against time to FILE.svg or FILE.png
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    pendulum: PendulumOptions,
    /// ω0 = √(g/l), such as 1rad/s, instead of length and gravity
    #[arg(long, value_name = "VELOCITY", value_parser = arguments::angular_velocity, conflicts_with_all = ["length", "gravity"])]
    omega0: Option<f64>,
    #[command(flatten)]
    form: FormOptions,
}

impl Decay {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let pendulum = match self.omega0 {
            Some(omega0) => {
                Pendulum::from_angular_frequency(omega0).map_err(|error| Failure::usage("--omega0", error))?
            }
            None => self.pendulum.pendulum()?,
        };
        let damping = self.damping.damping()?;
        let decay = libration::decay::Decay::new(pendulum, damping, self.amplitude)
            .map_err(|error| Failure::no_answer("decay", error))?;
        let report = Report::new(&decay, self.extent)?;
        if let Some(path) = &self.figure {
            figure::file::write(path, &figure::decay::of(&decay, &report))?;
        }
        let given = self.omega0.is_none().then_some(self.pendulum);
        write::Answer { given, decay: &decay, report: &report }.write(out, self.form.form())
    }
}
