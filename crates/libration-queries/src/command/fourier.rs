//! `libration fourier`: the harmonics of a motion.

use crate::arguments::{self, PendulumOptions};
use crate::figure::{PictureOptions, parameters, spectrum};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::table::{Table, sheet};
use crate::output::{Form, FormOptions, announce, csv, json};
use crate::query_error::QueryError;
use libration::pendulum::{FourierSeries, FourierTerm, Motion, Regime};
use libration::quantity::Angle;
use std::io::Write;

/// More harmonics than this are never requested by a tolerance.
const LIMIT: usize = 1_000_000;

/// The Fourier coefficients of the angle and of the velocity
///
/// In libration θ(t) = Σ aₙ cos(nΩτ), where τ is the time since the positive turning point. In rotation
/// θ(t) = mean velocity · τ + Σ aₙ sin(nΩτ), where τ is the time since the bottom.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration fourier 150deg
  libration fourier 60deg --harmonics 3 --json
  libration fourier 0 --velocity 7rad/s
  libration fourier 179deg --figure harmonics.svg")
)]
pub(crate) struct Fourier {
    /// The starting angle, such as 60deg, 1.2rad or pi-1e-6
    #[arg(value_parser = arguments::angle)]
    angle: Angle,
    /// The starting velocity, such as 0.3rad/s or 20deg/s; plain numbers are rad/s
    #[arg(long, default_value = "0rad/s", value_parser = arguments::angular_velocity)]
    velocity: f64,
    /// Number of harmonics to list
    #[arg(long, conflicts_with = "tolerance", value_parser = arguments::count::<LIMIT>)]
    harmonics: Option<usize>,
    /// List all harmonics of the angle that are at least this large, in radians
    #[arg(long, default_value = "1e-16", value_parser = arguments::positive)]
    tolerance: f64,
    #[command(flatten)]
    picture: PictureOptions,
    #[command(flatten)]
    pendulum: PendulumOptions,
    #[command(flatten)]
    form: FormOptions,
}

impl Fourier {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let motion = arguments::motion(&self.pendulum.pendulum()?, self.angle, self.velocity)?;
        let harmonics = self.harmonics_of(&motion)?;
        let (shown, made_with) = (harmonics.clone(), self.made_with());
        let picture = move || spectrum::of_motion(&shown).with_parameters(made_with.clone());
        let drawn = self.picture.drawn(picture)?;
        match self.form.form() {
            Form::Json => self.write_json(out, &motion, &harmonics)?,
            Form::Csv => write_csv(out, &harmonics)?,
            Form::Table => self.write_table(out, &motion, &harmonics)?,
        }
        Ok(announce(out, self.form.form(), &drawn)?)
    }

    fn made_with(&self) -> Vec<String> {
        let start = parameters::of_release(self.angle, self.velocity);
        start
            .into_iter()
            .chain(parameters::of_pendulum(self.pendulum.length(), self.pendulum.gravity()))
            .collect()
    }

    fn harmonics_of(&self, motion: &Motion) -> Result<FourierSeries, QueryError> {
        if motion.regime() == Regime::Separatrix {
            let reason = "a motion on the separatrix never returns and has no harmonics: change the angle or the velocity";
            return Err(QueryError::no_result("motion", reason));
        }
        let harmonics = match self.harmonics {
            Some(count) => motion.harmonics(0.0, count),
            None => motion.harmonics(self.tolerance, LIMIT),
        };
        Ok(harmonics)
    }

    fn write_json(
        &self,
        out: &mut dyn Write,
        motion: &Motion,
        harmonics: &FourierSeries,
    ) -> Result<(), QueryError> {
        let head = of_motion().added_to(self.pendulum.record(), &(*motion, harmonics));
        let of_term = of_term();
        let terms = harmonics.terms.iter().map(|term| of_term.record(term));
        Ok(json::document_with_list(out, head, "harmonics", terms)?)
    }

    fn write_table(
        &self,
        out: &mut dyn Write,
        motion: &Motion,
        harmonics: &FourierSeries,
    ) -> Result<(), QueryError> {
        sheet(out, &[self.pendulum.lines(), of_motion().lines(&(*motion, harmonics))].concat())?;
        writeln!(out)?;
        let of_term = of_term();
        let mut table = Table::new(of_term.columns());
        harmonics.terms.iter().try_for_each(|term| table.row(out, of_term.cells(term)))?;
        Ok(table.finish(out)?)
    }
}

fn write_csv(out: &mut dyn Write, harmonics: &FourierSeries) -> Result<(), QueryError> {
    let of_term = of_term();
    csv::line(out, &of_term.csv_names())?;
    Ok(harmonics.terms.iter().try_for_each(|term| csv::line(out, &of_term.csv_cells(term)))?)
}

/// Number of digits shown.
const DIGITS: usize = 13;

fn of_motion<'a>() -> Fields<(Motion, &'a FourierSeries)> {
    type Of<'a> = Field<(Motion, &'a FourierSeries)>;
    Fields::from([
        Of::value("regime", "", "rest, libration or rotation", |(motion, _)| {
            motion.regime().to_string().into()
        })
        .line_of("regime", |(motion, _)| motion.regime().to_string()),
        Of::number("period_s", "s", "period, in rotation the time of a turn", |(motion, _)| motion.period())
            .line("period", DIGITS),
        Of::number("fundamental_rad_per_s", "rad/s", "fundamental angular frequency Ω", |(_, harmonics)| {
            harmonics.fundamental
        })
        .line("fundamental Ω", DIGITS),
        Of::number(
            "mean_velocity_rad_per_s",
            "rad/s",
            "mean angular velocity, which only a rotation has",
            |(_, harmonics)| harmonics.mean_velocity,
        )
        .line("mean velocity", DIGITS),
    ])
}

fn of_term() -> Fields<FourierTerm> {
    type Of = Field<FourierTerm>;
    Fields::from([
        Of::value("n", "1", "number of the harmonic, of frequency nΩ", |term| term.n.into())
            .numeral("n", |term| term.n.to_string()),
        Of::number(
            "angle_rad",
            "rad",
            "coefficient of the angle: of cos nΩτ in libration, of sin nΩτ in rotation",
            |term| term.angle,
        )
        .rounded("angle / rad", DIGITS),
        Of::number(
            "velocity_rad_per_s",
            "rad/s",
            "coefficient of the angular velocity: of −sin nΩτ in libration, of cos nΩτ in rotation",
            |term| term.velocity,
        )
        .rounded("velocity / (rad/s)", DIGITS),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [
        PendulumOptions::fields().described(""),
        of_motion().described(""),
        of_term().described("harmonics[]."),
    ];
    vec![Answers { command: "fourier", option: "", json: json.concat(), csv: of_term().described_in_csv() }]
}
