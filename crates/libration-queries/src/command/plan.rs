//! `libration plan`: which swings to record for g.

use crate::arguments;
use crate::figure;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::table::{Table, sheet};
use crate::output::{Form, FormOptions, announce, csv, json};
use crate::query_error::QueryError;
use libration::pendulum::Amplitude;
use libration::quantity::{Angle, Quantity, angles};
use libration_lab::fit::plan::{Plan, PlannedRecording, PlannedSwings, plan};
use serde_json::Value;
use std::io::{self, Write};

/// Plan a measurement of g: amplitude of release, number of swings, uncertainty of the length
///
/// The rows have independent errors of the angle, and a fit finds ω0, damping and start from them, as `libration fit trace --model linear` does; without a model the fit does not know the law of damping either, and its uncertainties for few swings are about half as large again. The uncertainty of ω0 is the Cramér–Rao bound; length, clock and the scale of the angles add their parts, as in the budget of the measurement.
#[derive(Debug, clap::Args)]
#[command(override_usage = USAGE)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration plan --g-to 1e-3 --length 1m±0.5mm --angle-noise 0.2deg --rate 60
  libration plan --g-to 0.01% --length 0.5m±10um --angle-noise 0.01deg \\
    --rate 240 --angle-scale 0.1% --clock 1e-6
  libration plan --g-to 2e-3 --length 57cm±1mm --angle-noise 1deg --rate 30 \\
    --linear 0.03/s --amplitudes 5deg:60deg:5deg --csv
  libration plan --g-to 1e-3 --length 1m±0.5mm --angle-noise 0.2deg --rate 60 \\
    --figure plan.svg")
)]
pub(crate) struct PlanQuestion {
    /// The target relative standard uncertainty of g, such as 1e-3 or 0.1%
    #[arg(long, value_name = "PART", value_parser = arguments::part)]
    g_to: f64,
    /// Distance from the pivot to the centre of the bob, with its uncertainty, such as 1.0000(5)m
    #[arg(long, value_parser = arguments::length_with_uncertainty)]
    length: Quantity,
    /// Standard deviation of the angle in a row, such as 0.2deg
    #[arg(long, value_name = "ANGLE", value_parser = arguments::angle)]
    angle_noise: Angle,
    /// Rows per second, such as 60
    #[arg(long, value_name = "ROWS", value_parser = arguments::positive)]
    rate: f64,
    /// Amplitudes to choose from, such as 5deg,20deg or 5deg:60deg:5deg
    #[arg(long, value_name = "A,A", default_value = "5deg,10deg,15deg,20deg,30deg,45deg,60deg,90deg", value_parser = amplitudes)]
    amplitudes: Choices,
    /// Coefficient of linear damping, such as 0.03/s: the amplitude falls as exp(-b t/2) [default: none]
    #[arg(long, alias = "linear-damping", value_name = "RATE", value_parser = arguments::rate_with_uncertainty)]
    linear: Option<Quantity>,
    /// Relative uncertainty of the scale of all angles
    #[arg(long, value_name = "PART", default_value = "1%", value_parser = arguments::part)]
    angle_scale: f64,
    /// Relative uncertainty of the clock or frame rate
    #[arg(long, value_name = "PART", default_value = "0", value_parser = arguments::part)]
    clock: f64,
    /// Approximate acceleration of free fall
    #[arg(long, default_value = "9.80665m/s^2", value_parser = arguments::gravity)]
    gravity: f64,
    #[command(flatten)]
    picture: figure::PictureOptions,
    #[command(flatten)]
    form: FormOptions,
}

const USAGE: &str = "libration plan --g-to <PART> --length <LENGTH> --angle-noise <ANGLE>
                      --rate <ROWS> [OPTIONS]";

/// The amplitudes to choose from.
#[derive(Clone, Debug)]
pub(super) struct Choices(Vec<Amplitude>);

/// Largest number of amplitudes.
const MOST: usize = 1000;

fn amplitudes(text: &str) -> Result<Choices, String> {
    let angles = angles(text).map_err(|error| error.to_string())?;
    arguments::say_radians(text);
    if angles.len() > MOST {
        return Err(format!("{} amplitudes are too many: give at most {MOST}", angles.len()));
    }
    let amplitudes = angles.into_iter().map(Amplitude::new).collect::<Result<Vec<_>, _>>();
    amplitudes.map(Choices).map_err(|error| error.to_string())
}

/// A choice; `true` with the best one.
struct Choice<'a> {
    swings: &'a PlannedSwings,
    is_best: bool,
}

impl PlanQuestion {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let recording = PlannedRecording {
            length: self.length,
            gravity: self.gravity,
            angle_noise: self.angle_noise.radians(),
            rate: self.rate,
            linear_damping: self.linear.map_or(0.0, |damping| damping.value),
            angle_scale: self.angle_scale,
            clock: self.clock,
        };
        let outcome = plan(&recording, self.g_to, &self.amplitudes.0);
        let plan = outcome.map_err(|error| QueryError::no_result("plan", error))?;
        let drawn = self.picture.drawn({
            let plan = plan.clone();
            move || figure::plan::plan(&plan)
        })?;
        match self.form.form() {
            Form::Json => json::document(out, of_plan().record(&plan))?,
            Form::Csv => write_csv(out, &plan)?,
            Form::Table => write_table(out, &plan)?,
        }
        Ok(announce(out, self.form.form(), &drawn)?)
    }
}

fn choices(plan: &Plan) -> Vec<Choice<'_>> {
    let choices = plan.choices.iter().enumerate();
    choices.map(|(index, swings)| Choice { swings, is_best: plan.best == Some(index) }).collect()
}

fn write_csv(out: &mut dyn Write, plan: &Plan) -> io::Result<()> {
    let of_choice = of_choice();
    csv::line(out, &of_choice.csv_names())?;
    choices(plan).iter().try_for_each(|choice| csv::line(out, &of_choice.csv_cells(choice)))
}

fn write_table(out: &mut dyn Write, plan: &Plan) -> io::Result<()> {
    sheet(out, &of_plan().lines(plan))?;
    writeln!(out)?;
    let of_choice = of_choice();
    let mut table = Table::new(of_choice.columns());
    choices(plan).iter().try_for_each(|choice| table.row(out, of_choice.cells(choice)))?;
    table.finish(out)
}

fn of_plan() -> Fields<Plan> {
    type Of = Field<Plan>;
    Fields::from([
        Of::number("wanted", "1", "target standard uncertainty of g, as a part of g", |plan| plan.target)
            .line("u(g)/g wanted", 3),
        Of::number(
            "left_for_recording",
            "1",
            "contribution to it that is left for noise and scale of the angles, as a part of g",
            |plan| plan.left_for_recording,
        )
        .line("for the recording", 3),
        Of::nullable(
            "length_uncertainty_needed_m",
            "m",
            "uncertainty of the length that is required, or null where the present one suffices",
            |plan| plan.length_needed,
        ),
        Of::value("swings", "1", "fewest swings that suffice, or null where none do", |plan| {
            plan.best().and_then(|best| best.swings).into()
        }),
        Of::nullable("amplitude_rad", "rad", "amplitude of their release, or null", |plan| {
            plan.best().map(|best| best.amplitude)
        }),
        Of::nullable("duration_s", "s", "their duration, or null", |plan| {
            plan.best().map(|best| best.duration)
        }),
        Of::value("advice[]", "", "advice, in sentences", |plan| json::list(plan.advice()))
            .line_of("advice", |plan| plan.advice().join("; ")),
        Of::nested("choices[].", &of_choice(), |plan| of_choice().records(&choices(plan))),
    ])
}

fn of_choice<'a>() -> Fields<Choice<'a>> {
    type Of<'a> = Field<Choice<'a>>;
    let part = |name, meaning, title, value: fn(&Choice<'a>) -> f64| {
        Of::number(name, "1", meaning, value).short(title, 3)
    };
    Fields::from([
        Of::number("amplitude_rad", "rad", "amplitude of the release", |choice| choice.swings.amplitude)
            .degrees("amplitude / °", 4),
        Of::value("swings", "1", "fewest swings that suffice, or null where 10000 do not", |choice| {
            choice.swings.swings.map_or(Value::Null, Value::from)
        })
        .numeral("swings", |choice| {
            choice.swings.swings.map_or("–".to_owned(), |swings| swings.to_string())
        }),
        Of::nullable("duration_s", "s", "their duration, or null", |choice| {
            choice.swings.swings.map(|_| choice.swings.duration)
        })
        .short("time / s", 4)
        .or("–"),
        part("noise", "uncertainty of g by the noise of the angles, as a part of g", "noise", |choice| {
            choice.swings.expected.noise
        }),
        part(
            "angle_scale",
            "the same by the scale of the angles; where swings is null, of 10000",
            "scale",
            |choice| choice.swings.expected.angle_scale,
        ),
        part("length", "the same by the length, with its present uncertainty", "length", |choice| {
            choice.swings.expected.length
        }),
        part("clock", "the same by the clock", "clock", |choice| choice.swings.expected.clock),
        part("total", "the same by all of them", "u(g)/g", |choice| choice.swings.expected.total()),
        Of::value("is_best", "", "true if it has the fewest swings", |choice| choice.is_best.into())
            .words("", |choice| if choice.is_best { "best".to_owned() } else { String::new() }),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    vec![Answers {
        command: "plan",
        option: "",
        json: of_plan().described(""),
        csv: of_choice().described_in_csv(),
    }]
}
