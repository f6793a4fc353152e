//! `libration backbone`: the frequency of an oscillator against its amplitude.

mod fields;
mod write;

use crate::arguments::{self, Asked, OscillatorOptions};
use crate::figure::chart::Picture;
use crate::output::{Form, FormOptions, announce};
use crate::query_error::{QueryError, option};
use crate::{figure, interrupt, parallel};
use libration::comparison::{Backbone as Curve, BackbonePoint};
use libration::perturbation::MAX_ORDER;
use libration::quantity::is_angle_name;
use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;

pub(crate) use fields::answers;

/// The frequency of an oscillator against its amplitude: from orbits, from the perturbation series, and exactly for the pendulum
///
/// Each orbit is a motion released from rest and integrated until it returns; its frequency comes with a bound on its
/// error. Amplitudes are measured from the equilibrium; frequencies are in radians per unit of time.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration backbone pendulum --amplitudes 10deg:170deg:10deg
  libration backbone duffing --amplitudes 0.1:3:0.1 --figure duffing.svg
  libration backbone \"x'' = -x^3\" --amplitudes 0.5,1,2 --json
  libration backbone helmholtz_duffing --set alpha=1/2 \\
    --amplitudes 0.1:1:0.1 --csv")
)]
pub(crate) struct Backbone {
    #[command(flatten)]
    oscillator: OscillatorOptions,
    /// Amplitudes START:STOP:STEP or a,b,…; with a unit if the variable is an angle
    #[arg(long, value_name = "A")]
    amplitudes: String,
    /// The order of the perturbation series
    #[arg(long, default_value = "9", value_parser = arguments::count::<MAX_ORDER>)]
    order: usize,
    /// Draw the curves to FILE.svg, .pdf, .png or .json instead of listing the points
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
}

/// More amplitudes than this take too long.
const MOST_AMPLITUDES: usize = 100_000;

/// The result to write.
struct BackboneResult {
    asked: Asked,
    curve: Curve,
    order: usize,
    /// Number of amplitudes requested.
    asked_for: usize,
    points: Vec<BackbonePoint>,
}

impl BackboneResult {
    /// The error that Ctrl-C came before the last amplitude.
    fn interruption(&self) -> Option<QueryError> {
        let (done, all) = (self.points.len(), self.asked_for);
        let told = || format!("interrupted: the points up to then are written, {done} of {all}");
        (done < all).then(|| QueryError::cancelled(told()))
    }

    fn is_angle(&self) -> bool {
        is_angle_name(&self.asked.equation.variables()[0])
    }

    /// The picture, for which more points are computed; `false` after a cancellation of that.
    fn picture(&self) -> (Picture, bool) {
        let amplitudes = figure::backbone::amplitudes_of_curves(&self.points);
        let sampled =
            parallel::map_unless_cancelled(&amplitudes, "points of the curve", |amplitude, progress| {
                self.curve.drawn_at(amplitude, progress)
            });
        let title = match self.asked.key {
            Some(_) => self.asked.title.clone(),
            None => self.asked.equation.to_string(),
        };
        let setting =
            figure::backbone::BackboneSetting { title, order: self.order, is_angle: self.is_angle() };
        let picture = figure::backbone::backbone(&self.curve, &self.points, &sampled, &setting);
        let value = |(name, value): &(String, _)| format!("{} = {value}", figure::names::symbol(name));
        let picture = picture.with_parameters(self.asked.values.iter().map(value));
        (picture, sampled.len() == amplitudes.len())
    }
}

impl Backbone {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let answer = Arc::new(self.computed()?);
        let mut interruption = answer.interruption();
        if self.figure.is_none() {
            let passed = Arc::clone(&answer);
            figure::data::pass(&self.layout, move || passed.picture().0);
        }
        let drawn = match &self.figure {
            Some(path) => {
                let (picture, is_complete) = answer.picture();
                if interruption.is_none() && !is_complete {
                    let reason = "interrupted: the curve is drawn as far as it was known";
                    interruption = Some(QueryError::cancelled(reason));
                }
                figure::file::finished(Some(path), &self.layout, &picture)?
            }
            None => vec![],
        };
        match self.form.form() {
            Form::Json => write::json(out, &answer)?,
            Form::Csv => write::csv(out, &answer)?,
            Form::Table => write::table(out, &answer, drawn.is_empty())?,
        }
        announce(out, self.form.form(), &drawn)?;
        out.flush()?;
        if let Some(interruption) = interruption {
            return Err(interruption);
        }
        if answer.points.iter().any(|point| point.orbit.is_ok()) {
            return Ok(());
        }
        let reason = answer.points.first().and_then(|point| point.orbit.as_ref().err());
        let reason = reason.map_or_else(String::new, ToString::to_string);
        Err(QueryError::no_result(
            option("amplitudes"),
            format!("none of them has a periodic orbit: {reason}"),
        ))
    }

    fn computed(&self) -> Result<BackboneResult, QueryError> {
        let asked = self.oscillator.asked()?;
        let variable = asked.equation.variables().first().map_or("", String::as_str);
        let is_angle = is_angle_name(variable);
        let amplitudes = arguments::displacements(&option("amplitudes"), &self.amplitudes, is_angle)?;
        if amplitudes.len() > MOST_AMPLITUDES {
            let reason = format!("{} are too many: give at most {MOST_AMPLITUDES}", amplitudes.len());
            return Err(QueryError::usage(option("amplitudes"), reason));
        }
        interrupt::listen()?;
        let (curve, asked_for) = (self.curve(&asked)?, amplitudes.len());
        let points = parallel::map_unless_cancelled(&amplitudes, "amplitudes", |amplitude, progress| {
            curve.at_displacement(amplitude, progress)
        });
        if points.is_empty() {
            return Err(early());
        }
        Ok(BackboneResult { asked, curve, order: self.order, asked_for, points })
    }

    /// The series has to be complete before the first amplitude.
    fn curve(&self, asked: &Asked) -> Result<Curve, QueryError> {
        let order = self.order;
        let curve = parallel::unless_cancelled(&format!("the series to order {order}"), |progress| {
            Curve::new(&asked.equation, asked.about.as_ref(), order, progress)
        });
        curve
            .ok_or_else(early)?
            .map_err(|error| QueryError::no_result("oscillator", &error).with_remedies(&error.remedies()))
    }
}

fn early() -> QueryError {
    let reason = "interrupted before the frequency at any amplitude was known: nothing is written";
    QueryError::cancelled(reason)
}
