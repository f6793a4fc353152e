//! `libration orbit`: one periodic orbit.

mod fields;
mod write;

use crate::arguments::{
    CoordinateName, InitialOptions, SystemOptions, coordinate, count, positive, with_idle_drive,
};
use crate::output::number::count as number;
use crate::output::{FormOptions, announce};
use crate::query_error::{QueryError, option};
use crate::{call, figure, interrupt, parallel};
use libration::chaos::drive_period;
use libration::orbit::{Harmonics, Orbit, OrbitError, OrbitKind, OrbitSearch};
use libration::systems::Model;
use std::io::Write;
use std::path::PathBuf;

pub(crate) use fields::answers;

/// Largest number of drive periods in a period of the orbit.
const MOST_PERIODS: usize = 1000;

/// A periodic orbit: its period, harmonics, Floquet multipliers and stability, with errors
///
/// For a driven system, the periodic response near the start, or the one to which the start leads; without a drive, the motion from the start
/// if it returns, a limit cycle, or the orbit near a guess of its period. Without a drive the period is the least one.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration orbit driven_pendulum --set A=0.15,c=0.1,omega=0.82
  libration orbit \"x'' = (1 - x^2) x' - x\" --initial x=0.5
  libration orbit pendulum --initial theta=60deg --figure orbit.svg
  libration orbit double_pendulum --period 8 --json \\
    --initial theta1=0.1,theta2=0.141
  libration orbit spring_pendulum --set kappa=3 --period 7 --hold theta \\
    --initial r=1.4,theta=5deg
  libration orbit \"x'' + 0.05 x' + x + x^3 = 5 cos(9 t)\" --drive-periods 3 \\
    --initial x=3

Where energy is conserved the start chooses one orbit of a family: its largest
coordinate is kept, or that of --hold, and the velocity of that one.")
)]
pub(crate) struct OrbitQuestion {
    #[command(flatten)]
    system: SystemOptions,
    #[command(flatten)]
    initial: InitialOptions,
    /// A guess of the period, in seconds; for a driven system, the period of the response, to a thousandth of that of the drive
    #[arg(long, value_name = "T", value_parser = positive, conflicts_with = "drive_periods")]
    period: Option<f64>,
    /// Number of periods of the drive in one period of the orbit, for subharmonic orbits
    #[arg(long, value_name = "N", default_value = "1", value_parser = count::<MOST_PERIODS>)]
    drive_periods: usize,
    /// The coordinate whose value at the start is kept, in a family of orbits near a guess [default: the farthest from zero]
    #[arg(long, value_name = "NAME", requires = "period")]
    hold: Option<CoordinateName>,
    /// Draw the orbit to FILE.svg, .pdf, .png or .json, in time and in the plane of coordinate and velocity
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
}

/// The result to write.
pub(crate) struct OrbitResult {
    model: Model,
    kind: OrbitKind,
    orbit: Orbit,
    /// Harmonics of each coordinate.
    harmonics: Vec<Harmonics>,
}

impl OrbitQuestion {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let model = self.system.model()?;
        let search = self.search(&model)?;
        interrupt::listen()?;
        let outcome = parallel::unless_cancelled_counted("the orbit", "steps of integration", |progress| {
            let (kind, orbit) = Orbit::search(model.equation(), &search, progress)?;
            let harmonics =
                (0..model.coordinates().len()).map(|coordinate| orbit.harmonics(coordinate)).collect();
            Ok((kind, orbit, harmonics))
        });
        let early = || QueryError::cancelled("interrupted before the orbit was known: nothing is written");
        let (kind, orbit, harmonics) = outcome.ok_or_else(early)?.map_err(|error| failure(error, &model))?;
        note_shorter_period(&model, &orbit);
        let answer = OrbitResult { model, kind, orbit, harmonics };
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::orbit::orbit(&answer.model, &answer.orbit))
        })?;
        answer.write(out, self.form.form(), drawn.is_empty())?;
        announce(out, self.form.form(), &drawn)?;
        Ok(out.flush()?)
    }

    /// The search for the orbit: a driven system may begin at rest, others need an initial state.
    fn search(&self, model: &Model) -> Result<OrbitSearch, QueryError> {
        let driven = drive_period(model.equation());
        let start = match (self.initial.is_given(), driven) {
            (false, Some(_)) => model.state_at_rest(),
            _ => self.initial.read(model)?.state,
        };
        let multiple = |period: f64| {
            let drive = driven?;
            Some(f64::from(drive_periods(period, drive)?) * drive)
        };
        let given = self.period.map(|period| multiple(period).unwrap_or(period));
        let period = given.or(driven.map(|period| number(self.drive_periods) * period));
        if driven.is_none() && self.drive_periods > 1 {
            let reason = "the equations have no drive with a known period: give a guess with <--period>";
            return Err(QueryError::usage(option("drive-periods"), reason));
        }
        let held = self.hold.as_ref().map(|name| coordinate(model, &option("hold"), name)).transpose()?;
        Ok(OrbitSearch { start, period, conserves_energy: model.energy().is_ok(), held })
    }
}

/// Number of drive periods in a period that is a multiple of the drive period, within the accuracy of a written number.
fn drive_periods(period: f64, drive: f64) -> Option<u32> {
    /// Accuracy of a period that was typed with three or four digits.
    const WRITTEN: f64 = 1e-3;
    (1..=1000).find(|periods| (period - f64::from(*periods) * drive).abs() < WRITTEN * drive)
}

/// Notes that a response repeats after fewer periods of the drive: its multipliers are then powers of those over its least period.
fn note_shorter_period(model: &Model, orbit: &Orbit) {
    let parts =
        |all: u32| (2..=all).rev().find(|part| all.is_multiple_of(*part) && orbit.repeats_after(*part));
    let all = drive_period(model.equation()).and_then(|drive| drive_periods(orbit.period(), drive));
    if let Some((all, parts)) = all.and_then(|all| Some((all, parts(all)?))) {
        let least = all / parts;
        call::current().note(&format!(
            "the response repeats after {least} of {all} periods of the drive: <--drive-periods> {least} gives the multipliers of its own period"
        ));
    }
}

/// The error, which names an option where that option can remove it.
fn failure(error: OrbitError, model: &Model) -> QueryError {
    match error {
        OrbitError::NoCycle(_) => QueryError::no_result("orbit", with_idle_drive(error, model)),
        OrbitError::NoPeriod | OrbitError::NotOfDrive(_) => QueryError::usage(option("period"), error),
        _ => QueryError::no_result("orbit", error),
    }
}
