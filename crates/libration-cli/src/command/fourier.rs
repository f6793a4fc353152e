//! `libration fourier`: the harmonics of a motion.

use crate::arguments::{self, PendulumOptions};
use crate::failure::Failure;
use crate::output::table::{Column, Table, sheet};
use crate::output::{Form, FormOptions, csv, json, json::Record, number};
use libration::pendulum::{Harmonics, Motion, Regime};
use libration::quantity::Angle;
use std::io::Write;

/// More harmonics than this are never asked for by a tolerance.
const LIMIT: usize = 1_000_000;

/// The Fourier coefficients of the angle and of the velocity
///
/// In libration θ(t) = Σ aₙ cos(nΩτ), where τ is the time since the positive turning point. In rotation
/// θ(t) = mean velocity · τ + Σ aₙ sin(nΩτ), where τ is the time since the bottom.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration fourier 150deg
  libration fourier 60deg --harmonics 3 --json
  libration fourier 0 --velocity 7rad/s")]
pub(crate) struct Fourier {
    /// The starting angle, such as 60deg, 1.2rad or pi-1e-6
    #[arg(value_parser = arguments::angle)]
    angle: Angle,
    /// The starting velocity, such as 0.3rad/s or 20deg/s; plain numbers are rad/s
    #[arg(long, default_value = "0rad/s", value_parser = arguments::angular_velocity)]
    velocity: f64,
    /// How many harmonics to list
    #[arg(long, conflicts_with = "tolerance", value_parser = arguments::count::<LIMIT>)]
    harmonics: Option<usize>,
    /// List all harmonics of the angle that are at least this large, in radians
    #[arg(long, default_value = "1e-16", value_parser = arguments::positive)]
    tolerance: f64,
    #[command(flatten)]
    pendulum: PendulumOptions,
    #[command(flatten)]
    form: FormOptions,
}

impl Fourier {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let motion = arguments::motion(&self.pendulum.pendulum()?, self.angle, self.velocity)?;
        let harmonics = self.harmonics_of(&motion)?;
        match self.form.form() {
            Form::Json => self.write_json(out, &motion, &harmonics),
            Form::Csv => write_csv(out, &harmonics),
            Form::Table => self.write_table(out, &motion, &harmonics),
        }
    }

    fn harmonics_of(&self, motion: &Motion) -> Result<Harmonics, Failure> {
        if motion.regime() == Regime::Separatrix {
            let reason = "a motion on the separatrix never returns and has no harmonics: change the angle or the velocity";
            return Err(Failure::no_answer("motion", reason));
        }
        let harmonics = match self.harmonics {
            Some(count) => motion.harmonics(0.0, count),
            None => motion.harmonics(self.tolerance, LIMIT),
        };
        Ok(harmonics)
    }

    fn write_json(&self, out: &mut dyn Write, motion: &Motion, harmonics: &Harmonics) -> Result<(), Failure> {
        let head = self
            .pendulum
            .record()
            .with("regime", motion.regime().to_string())
            .number("period_s", motion.period())
            .number("fundamental_rad_per_s", harmonics.fundamental)
            .number("mean_velocity_rad_per_s", harmonics.mean_velocity);
        let terms = harmonics.terms.iter().map(|term| {
            Record::new()
                .with("n", term.n)
                .number("angle_rad", term.angle)
                .number("velocity_rad_per_s", term.velocity)
        });
        Ok(json::document_with_list(out, head, "harmonics", terms)?)
    }

    fn write_table(
        &self,
        out: &mut dyn Write,
        motion: &Motion,
        harmonics: &Harmonics,
    ) -> Result<(), Failure> {
        let [length, gravity] = self.pendulum.lines();
        sheet(
            out,
            &[
                length,
                gravity,
                ("regime", motion.regime().to_string()),
                ("period", number::seconds(motion.period(), 13)),
                ("fundamental Ω", format!("{} rad/s", number::rounded(harmonics.fundamental, 13))),
                ("mean velocity", format!("{} rad/s", number::rounded(harmonics.mean_velocity, 13))),
            ],
        )?;
        writeln!(out)?;
        let mut table = Table::new(vec![
            Column::numbers("n"),
            Column::numbers("angle / rad"),
            Column::numbers("velocity / (rad/s)"),
        ]);
        for term in &harmonics.terms {
            let cells = [term.angle, term.velocity].map(|value| number::rounded(value, 13));
            table.row(out, [vec![term.n.to_string()], cells.to_vec()].concat())?;
        }
        Ok(table.finish(out)?)
    }
}

fn write_csv(out: &mut dyn Write, harmonics: &Harmonics) -> Result<(), Failure> {
    csv::line(out, &["n", "angle_rad", "velocity_rad_per_s"])?;
    for term in &harmonics.terms {
        csv::line(out, &[term.n.to_string(), number::exact(term.angle), number::exact(term.velocity)])?;
    }
    Ok(())
}
