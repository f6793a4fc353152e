//! `libration motion`: angle and velocity in time, exact and approximate.

mod fields;
mod write;

use crate::arguments::{self, PendulumOptions, TimeOptions};
use crate::figure::parameters;
use crate::output::progress::counted;
use crate::output::{FormOptions, announce};
use crate::query_error::{QueryError, option};
use crate::{figure, interrupt};
use libration::pendulum::ApproximateMotion;
use libration::quantity::Angle;
use std::io::Write;
use std::path::PathBuf;

pub(crate) use fields::answers;

/// Angle and velocity in time, from any starting angle and velocity
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration motion 60deg                                # one period
  libration motion 150deg --times 0:10:0.5 --csv
  libration motion 0 --velocity 7rad/s --times 0,1,2    # a rotation
  libration motion pi-1e-300 --times 0:2000:100         # almost upright
  libration motion 90deg --compare small-angle,fourier-3 --figure motion.svg
  libration motion 150deg --times 0:10:1 --animate --figure swing.svg")
)]
pub(crate) struct Motion {
    /// The starting angle, such as 60deg, 1.2rad or pi-1e-6; beyond the top, whole turns are counted
    #[arg(value_parser = arguments::angle)]
    angle: Angle,
    /// The starting velocity, such as 0.3rad/s or 20deg/s; plain numbers are rad/s
    #[arg(long, default_value = "0rad/s", value_parser = arguments::angular_velocity)]
    velocity: f64,
    #[command(flatten)]
    times: TimeOptions,
    /// Approximate motions to compare with: small-angle, fourier-3, fourier-5, fourier-7
    #[arg(long, value_name = "KEY,KEY", value_delimiter = ',', value_parser = ApproximateMotion::by_key)]
    compare: Vec<ApproximateMotion>,
    /// Draw the motion to FILE.svg, .pdf, .png or .json instead of listing it
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    /// Animate the pendulum next to its curve (an SVG animation, for browsers)
    #[arg(long, requires = "figure")]
    animate: bool,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    pendulum: PendulumOptions,
    #[command(flatten)]
    form: FormOptions,
}

impl Motion {
    fn made_with(&self) -> Vec<String> {
        parameters::of_release(self.angle, self.velocity)
            .into_iter()
            .chain(parameters::of_pendulum(self.pendulum.length(), self.pendulum.gravity()))
            .collect()
    }

    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let pendulum = self.pendulum.pendulum()?;
        let motion = arguments::motion(&pendulum, self.angle, self.velocity)?;
        let comparison = Comparison::new(self, pendulum.angular_frequency())?;
        let times = self.times.read(&pendulum, &motion)?;
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            let picture = figure::motion::compared(&motion, &comparison.curves(), times.ends());
            let made_with = self.made_with();
            let picture = picture.with_parameters(made_with);
            Ok(match self.animate {
                true => figure::animation::of_motion(picture, &motion, times.ends()),
                false => picture,
            })
        })?;
        let listed = drawn.is_empty();
        let answer =
            write::MotionResult { pendulum: self.pendulum, motion: &motion, comparison: &comparison, listed };
        interrupt::listen()?;
        let samples = counted(times.iter(), times.len(), "times");
        answer.write(out, self.form.form(), samples)?;
        announce(out, self.form.form(), &drawn)?;
        interrupt::ended_early("the samples")
    }
}

/// The exact motion and the approximate ones, with the data for their output.
#[derive(Clone, Debug)]
pub(crate) struct Comparison {
    pub(crate) approximations: Vec<ApproximateMotion>,
    amplitude: f64,
    angular_frequency: f64,
}

impl Comparison {
    fn new(question: &Motion, angular_frequency: f64) -> Result<Self, QueryError> {
        let amplitude = match question.compare.is_empty() {
            true => 0.0,
            false => ApproximateMotion::amplitude_of(&question.angle, question.velocity)
                .map_err(|error| QueryError::no_result(option("compare"), error))?,
        };
        Ok(Self { approximations: question.compare.clone(), amplitude, angular_frequency })
    }

    /// The approximations as a picture needs them.
    fn curves(&self) -> Vec<figure::motion::Approximation<'_>> {
        let curve = |approximation| figure::motion::Approximation {
            name: ApproximateMotion::name(approximation),
            angle_at: Box::new(move |time| self.angle_at(approximation, time)),
        };
        self.approximations.iter().map(curve).collect()
    }

    /// The angle of one approximate motion at a time.
    pub(crate) fn angle_at(&self, approximation: &ApproximateMotion, time: f64) -> f64 {
        approximation.angle(self.amplitude, self.angular_frequency * time)
    }
}
