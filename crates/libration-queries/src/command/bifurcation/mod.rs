//! `libration bifurcation`: the section of a motion for each value of a parameter.

mod write;

use crate::arguments::{
    CoordinateName, InitialOptions, ParameterRange, SectionOptions, SystemOptions, free_on, parameter_range,
    place_in_state, section_failure,
};
use crate::figure::section::{DiagramSweep, StateAxis};
use crate::output::{FormOptions, announce};
use crate::query_error::{QueryError, option};
use crate::{figure, interrupt, parallel};
use libration::chaos::{
    Continuation, DiagramColumn, DiagramError, Family, Points, Section, angles, compute_bifurcation_diagram,
};
use libration::progress::Status;
use libration::systems::Model;
use libration::taylor::Moment;
use std::cell::Cell;
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

pub(crate) use write::answers;

/// Number of points kept for each value by default.
const POINTS: usize = 100;
/// Number of values that are one piece of work.
const PIECE: usize = 32;

/// Bifurcation diagram: the Poincaré section of a motion for each value of a parameter
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration bifurcation driven_pendulum --set c=1/2 --over A=1:1.5:0.05 \\
    --initial theta=0.2 --points 30 --figure diagram.png
  libration bifurcation \"x'' + 0.2 x' + x + x^3 = A cos(1.8 t)\" \\
    --over A=0.5:3:0.5 --initial x=0 --sweep both --points 5

With --sweep each motion starts where the one for the previous value ended, so
that a solution is followed as long as it is stable; sweeping up and down shows
hysteresis. Ctrl-C stops early and keeps the values that are complete.")
)]
pub(crate) struct Bifurcation {
    #[command(flatten)]
    system: SystemOptions,
    /// The parameter and its values, from A to B in steps, such as A=1:1.5:0.01
    #[arg(long, value_name = "NAME=A:B:STEP", value_parser = parameter_range)]
    over: ParameterRange,
    #[command(flatten)]
    initial: InitialOptions,
    /// Start each motion where the previous one ended, taking the values in this order
    #[arg(long, value_name = "ORDER")]
    sweep: Option<SweepOrder>,
    #[command(flatten)]
    section: SectionOptions,
    /// The state variable that the picture shows [default: the first coordinate, or its velocity if it is an angle, unless --at fixes it]
    #[arg(long, value_name = "NAME", requires = "figure")]
    axis: Option<CoordinateName>,
    /// Draw the diagram to FILE.svg, .pdf, .png or .json instead of listing the points
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
}

/// The order in which the parameter takes its values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum SweepOrder {
    /// As given
    Up,
    /// In reverse
    Down,
    /// Up, then down
    Both,
}

/// The diagram, with the settings of its output.
pub(crate) struct Diagram<'a> {
    pub(crate) model: &'a Model,
    pub(crate) options: &'a SectionOptions,
    pub(crate) section: String,
    pub(crate) points: Points,
    pub(crate) angles: Vec<bool>,
    pub(crate) parameter: &'a ParameterRange,
    pub(crate) sweeps: Vec<DiagramSweep>,
}

impl Bifurcation {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let model = self.system.model_with_open(&[&self.over.name], &option("over"))?;
        let start = Moment { time: 0.0, state: self.initial.read(&model)?.state };
        let section = self.section.section(&model)?;
        let diagram = Diagram {
            model: &model,
            options: &self.section,
            section: self.section.description(&section, model.equation()),
            points: self.section.points_of_attractor(POINTS),
            angles: angles(model.equation()),
            parameter: &self.over,
            sweeps: self.sweeps(&model, &section, &start)?,
        };
        let reason = diagram.without_points().filter(|_| diagram.is_complete());
        let mut without_points = reason.map(|reason| {
            QueryError::no_result(option("over"), format!("no value has a point of the diagram: {reason}"))
        });
        // Nothing is drawn, and the standard output may be the picture.
        if self.figure.is_some()
            && let Some(error) = without_points.take()
        {
            return Err(error);
        }
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::section::bifurcation(
                &model,
                &self.over.name,
                &diagram.sweeps,
                &StateAxis::new(&model, self.axis(&model, &section)?),
            ))
        })?;
        diagram.write(out, self.form.form(), drawn.is_empty())?;
        announce(out, self.form.form(), &drawn)?;
        out.flush()?;
        if !diagram.is_complete() {
            return Err(QueryError::cancelled("interrupted: the complete values are written"));
        }
        without_points.map_or(Ok(()), Err)
    }

    /// The index of the state component in the picture: the first that the surface leaves free, if it does not the usual one.
    fn axis(&self, model: &Model, section: &Section) -> Result<usize, QueryError> {
        if let Some(name) = &self.axis {
            return place_in_state(model, &option("axis"), name);
        }
        let usual = if angles(model.equation())[0] { model.layout().driven(0) } else { 0 };
        let free = free_on(section, model);
        Ok(free
            .iter()
            .copied()
            .find(|&component| component == usual)
            .or(free.first().copied())
            .unwrap_or(usual))
    }

    fn sweeps(
        &self,
        model: &Model,
        section: &Section,
        start: &Moment,
    ) -> Result<Vec<DiagramSweep>, QueryError> {
        let family = Family {
            equation: model.equation(),
            parameter: &self.over.name,
            section,
            points: self.section.points_of_attractor(POINTS),
            with_errors: self.section.with_errors(self.figure.is_some(), self.form.form()),
        };
        let pieces = self.pieces();
        let (effort, done) = (self.section.effort(), AtomicUsize::new(0));
        let all: usize = pieces.iter().map(|piece| piece.values.len()).sum();
        let how_far = || format!("{} of {all} values", done.load(Ordering::Relaxed));
        let work = |piece: &ParameterPiece| {
            let before = Cell::new(0);
            let progress = |status: Status| {
                done.fetch_add(status.done - before.replace(status.done), Ordering::Relaxed);
                parallel::update(&how_far)
            };
            let (values, continuation) = (&piece.values, piece.continuation);
            compute_bifurcation_diagram(&family, values, start, continuation, &effort, &progress)
        };
        interrupt::listen()?;
        let columns = parallel::with_progress(how_far, || parallel::map(&pieces, work));
        let columns = columns.into_iter().collect::<Result<Vec<_>, _>>().map_err(failure)?;
        Ok(joined(&pieces, columns))
    }

    /// Independent pieces of the work.
    fn pieces(&self) -> Vec<ParameterPiece> {
        let values = &self.over.values;
        let sweep =
            |name, values: Vec<f64>| ParameterPiece { name, values, continuation: Continuation::LastState };
        let up = || sweep("up", values.clone());
        let down = || sweep("down", values.iter().rev().copied().collect());
        match self.sweep {
            Some(SweepOrder::Up) => vec![up()],
            Some(SweepOrder::Down) => vec![down()],
            Some(SweepOrder::Both) => vec![up(), down()],
            None => {
                let continuation = Continuation::SameStart;
                let piece = |values: &[f64]| ParameterPiece {
                    name: "same start",
                    values: values.to_vec(),
                    continuation,
                };
                values.chunks(PIECE).map(piece).collect()
            }
        }
    }
}

/// Values for one thread.
struct ParameterPiece {
    name: &'static str,
    values: Vec<f64>,
    continuation: Continuation,
}

/// The columns of pieces with the same name, one after the other.
fn joined(pieces: &[ParameterPiece], columns: Vec<Vec<DiagramColumn>>) -> Vec<DiagramSweep> {
    let mut sweeps: Vec<DiagramSweep> = vec![];
    for (piece, columns) in pieces.iter().zip(columns) {
        match sweeps.last_mut() {
            Some(sweep) if sweep.name == piece.name => sweep.columns.extend(columns),
            _ => sweeps.push(DiagramSweep { name: piece.name, columns }),
        }
    }
    sweeps
}

fn failure(error: DiagramError) -> QueryError {
    match error {
        DiagramError::Section(error) => section_failure(error),
        other => QueryError::usage(option("over"), other),
    }
}
