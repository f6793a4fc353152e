//! `libration melnikov`: when a perturbed pendulum has chaotic motions, and its resonances.

mod fields;
mod write;

use crate::arguments::{ParameterSpan, SystemOptions, count, parameter_span};
use crate::figure::melnikov::Perturbed;
use crate::output::{FormOptions, announce};
use crate::query_error::{QueryError, argument, option};
use crate::{figure, interrupt, parallel};
use libration::melnikov::{
    DriveResonance, Melnikov, MelnikovError, PerturbedPendulum, Tangency, TangencyError, Threshold,
    thresholds,
};
use libration::systems::Model;
use std::io::Write;
use std::path::PathBuf;

pub(crate) use fields::answers;

/// Largest q of a resonance p:q.
const MOST_PERIODS: usize = 1000;

/// Conditions for chaotic motion of a weakly perturbed pendulum: the Melnikov function with its zeros and thresholds, resonances, their widths and overlap
///
/// Everything in the equation but −ω0²·sin of the angle, counted from where the pendulum hangs, is taken as the perturbation, to first order.
/// Where the Melnikov function has simple zeros, the motions that leave the upright position and those that return to it cross, and there is
/// chaos next to them.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration melnikov driven_pendulum --set c=0.1,omega=1 --over A=0:1
  libration melnikov driven_pendulum --set A=0.3,c=0.1,omega=1 --json
  libration melnikov \"x'' + 0.1 x' + sin(x) = A cos(t) + A/3*cos(3t)\" \\
    --over A=0:1 --figure melnikov.svg
  libration melnikov \"x'' + sin(x) = 0.05 cos(2t)\" --max-drive-periods 10

With --over the function and the resonances are those of the first threshold in
the range, or of its end where there is none, and the manifolds themselves are
followed to where they touch, to all orders. M counts energy per m*l^2, in
rad^2/s^2, actions are per m*l^2, in rad^2/s.")
)]
pub(crate) struct MelnikovQuestion {
    #[command(flatten)]
    system: SystemOptions,
    /// A parameter and the range in which to look for thresholds, such as A=0:1
    #[arg(long, value_name = "NAME=FROM:TO", value_parser = parameter_span)]
    over: Option<ParameterSpan>,
    /// The largest number of periods of the drive, q, of a resonance p:q
    #[arg(long, alias = "orders", value_name = "Q", default_value = "5", value_parser = count::<MOST_PERIODS>)]
    max_drive_periods: usize,
    /// Draw the function, and the resonances on the curve of frequencies, to FILE.svg, .pdf, .png or .json instead of listing them
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
}

/// The parameter at which the manifolds begin or cease to cross: to first order, and of the actual manifolds.
struct Crossing {
    threshold: Threshold,
    tangency: Result<Tangency, TangencyError>,
}

/// The result to write.
struct MelnikovResult {
    model: Model,
    /// The parameter with the value at which the function is given.
    at: Option<(String, f64)>,
    pendulum: PerturbedPendulum,
    separatrices: [Melnikov; 2],
    thresholds: Option<Vec<Crossing>>,
    resonances: Vec<DriveResonance>,
}

impl MelnikovQuestion {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        interrupt::listen()?;
        let answer = self.analysis()?;
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::melnikov::melnikov(&answer.shown()))
        })?;
        answer.write(out, self.form.form(), drawn.is_empty())?;
        Ok(announce(out, self.form.form(), &drawn)?)
    }

    fn analysis(&self) -> Result<MelnikovResult, QueryError> {
        let open = self.over.as_ref().map(|over| over.name.as_str());
        let model = self.system.model_with_open(open.as_slice(), &option("over"))?;
        let thresholds = match &self.over {
            Some(over) => Some(crossings(&model, over)?),
            None => None,
        };
        let first = thresholds.iter().flatten().map(|crossing| crossing.threshold.value).reduce(f64::min);
        let at = self.over.as_ref().map(|over| (over.name.clone(), first.unwrap_or(over.range[1])));
        let equation = match &at {
            Some((name, value)) => {
                let value =
                    format!("{value:?}").parse().map_err(|error| QueryError::usage(option("over"), error))?;
                let equation = model.equation().with(&[(name, value)]);
                equation.map_err(|error| QueryError::usage(option("over"), error))?
            }
            None => model.equation().clone(),
        };
        let pendulum = PerturbedPendulum::new(&equation).map_err(failure)?;
        let largest = u32::try_from(self.max_drive_periods).unwrap_or(u32::MAX);
        let resonances =
            parallel::unless_cancelled("the resonances", |progress| pendulum.resonances(largest, progress));
        let resonances = resonances.and_then(Result::ok).ok_or_else(|| interrupted("resonances"))?;
        let separatrices = parallel::unless_cancelled("the Melnikov functions", |progress| {
            Melnikov::both(&pendulum, progress)
        });
        let separatrices =
            separatrices.and_then(Result::ok).ok_or_else(|| interrupted("Melnikov functions"))?;
        Ok(MelnikovResult { model, at, pendulum, separatrices, thresholds, resonances })
    }
}

impl MelnikovResult {
    /// The content of the picture.
    fn shown(&self) -> Perturbed<'_> {
        Perturbed {
            model: &self.model,
            at: self.at.as_ref().map(|(name, value)| (name.as_str(), *value)),
            omega0: self.pendulum.omega0(),
            separatrices: &self.separatrices,
            resonances: &self.resonances,
        }
    }
}

fn crossings(model: &Model, over: &ParameterSpan) -> Result<Vec<Crossing>, QueryError> {
    let thresholds = parallel::unless_cancelled_counted("the thresholds", "steps", |progress| {
        thresholds(model.equation(), &over.name, over.range, progress)
    });
    let thresholds = thresholds.ok_or_else(|| interrupted("thresholds"))?.map_err(failure)?;
    let crossings =
        parallel::unless_cancelled_counted("the tangencies", "steps of integration", |progress| {
            let crossing = |threshold: Threshold| Crossing {
                tangency: threshold.tangency(model.equation(), &over.name, progress),
                threshold,
            };
            thresholds.into_iter().map(crossing).collect()
        });
    crossings.ok_or_else(|| interrupted("tangencies"))
}

fn interrupted(before: &str) -> QueryError {
    QueryError::cancelled(format!("interrupted before the {before} were known: nothing is written"))
}

fn failure(error: MelnikovError) -> QueryError {
    match error {
        MelnikovError::Interrupted(_) => interrupted("thresholds"),
        MelnikovError::Range { .. } | MelnikovError::At { .. } => QueryError::usage(option("over"), error),
        _ => QueryError::no_result(argument("SYSTEM|EQUATION"), error),
    }
}
