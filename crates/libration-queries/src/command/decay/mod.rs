//! `libration decay`: the amplitude of a damped pendulum, integrated and by two laws.

mod fields;
mod options;
mod report;
mod slow_flow;
mod write;

use crate::arguments::{self, PendulumOptions};
use crate::figure::parameters;
use crate::output::{FormOptions, announce};
use crate::query_error::{QueryError, option};
use crate::{figure, interrupt};
use libration::pendulum::Pendulum;
use libration::quantity::Angle;
use options::{DampingOptions, Extent, SlowFlowOptions};
use std::io::Write;
use std::path::PathBuf;

use crate::figure::decay::MeasuredCycle;
pub(crate) use fields::answers;
use libration::decay::TurningPoint;
use report::{Cycle, Report};

/// The decay of a damped pendulum, cycle by cycle
///
/// The amplitudes are found by integrating θ″ + Σ cₙ θ′|θ′|ⁿ⁻¹ + ω0² sin θ = 0. They are compared with the averaged law, in which the energy falls at its mean rate over an undamped cycle (exact at any
/// amplitude), and with the small-amplitude law. The duration of each cycle is compared with the exact period at the
/// amplitude in its middle.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration decay 60deg --linear 0.1                # viscous damping, 20 cycles
  libration decay 1 --quadratic 0.1 --omega0 1 --cycles 4   # in units of 1/ω0
  libration decay 90deg --dry 0.2 --linear 0.02     # until friction holds it
  libration decay 150deg --quadratic 0.05 --until 60s --figure decay.svg
  libration decay 40deg --power 1.5:0.1 --csv       # any power of the velocity
  libration decay 30deg --quadratic 0.1 --order 5   # with the slow flow

Coefficients are divided by the moment of inertia, in SI units: a drag torque of
b kg m²/s times θ′ on a pendulum of moment of inertia ml² has c = b/(ml²).")
)]
pub(crate) struct Decay {
    /// The release angle, such as 60deg, 1.2rad or pi-1e-6
    #[arg(value_parser = arguments::angle)]
    amplitude: Angle,
    #[command(flatten)]
    damping: DampingOptions,
    #[command(flatten)]
    extent: Extent,
    #[command(flatten)]
    slow_flow: SlowFlowOptions,
    /// Draw amplitude and period against time to FILE.svg, .pdf, .png or .json instead of listing the cycles
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    pendulum: PendulumOptions,
    /// The frequency ω0 = √(g/l) of small swings, such as 1rad/s, instead of length and gravity
    #[arg(long, value_name = "VELOCITY", value_parser = arguments::angular_velocity, conflicts_with_all = ["length", "gravity"])]
    omega0: Option<f64>,
    #[command(flatten)]
    form: FormOptions,
}

impl Decay {
    fn made_with(&self, decay: &libration::decay::Decay) -> Vec<String> {
        let pendulum = match self.omega0 {
            Some(omega0) => vec![parameters::said("ω₀", omega0, "rad/s")],
            None => parameters::of_pendulum(self.pendulum.length(), self.pendulum.gravity()).to_vec(),
        };
        let start = parameters::amplitude(self.amplitude.radians());
        [vec![start], pendulum, parameters::of_damping(decay.damping())].concat()
    }

    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let pendulum = match self.omega0 {
            Some(omega0) => Pendulum::from_angular_frequency(omega0)
                .map_err(|error| QueryError::usage(option("omega0"), error))?,
            None => self.pendulum.pendulum()?,
        };
        let damping = self.damping.damping()?;
        let decay = libration::decay::Decay::new(pendulum, damping, self.amplitude)
            .map_err(|error| QueryError::no_result("decay", error))?;
        interrupt::listen()?;
        let slow = self.slow_flow.orders().map(|orders| slow_flow::follow(&decay, orders)).transpose()?;
        let mut report = Report::new(&decay, self.extent)?;
        if let Some(slow) = &slow {
            report.compare_with(slow);
        }
        let drawn = figure::file::drawn_later(self.figure.as_deref(), &self.layout, {
            let turns: Vec<TurningPoint> = report.turns.iter().map(|turn| turn.point).collect();
            let cycles = report.rows(&decay).filter_map(|row| row.whole);
            let cycles: Vec<MeasuredCycle> =
                cycles.map(|Cycle { middle, duration, .. }| MeasuredCycle { middle, duration }).collect();
            let (made_with, decay, slow) = (self.made_with(&decay), decay.clone(), slow.clone());
            move || {
                figure::decay::dying_swings(&decay, slow.as_ref(), &turns, &cycles)
                    .with_parameters(made_with.clone())
            }
        })?;
        let given = self.omega0.is_none().then_some(self.pendulum);
        let listed = drawn.is_empty();
        write::DecayResult { given, decay: &decay, slow: slow.as_ref(), report: &report, listed }
            .write(out, self.form.form())?;
        announce(out, self.form.form(), &drawn)?;
        if report.interrupted {
            out.flush()?;
            return Err(QueryError::cancelled("interrupted: the cycles up to then are written"));
        }
        Ok(())
    }
}
