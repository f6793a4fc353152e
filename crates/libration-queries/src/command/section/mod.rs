//! `libration section`: Poincaré sections.

pub(crate) mod point_errors;
mod write;

use crate::arguments::{
    SectionOptions, SeveralInitialOptions, SystemOptions, free_on, places_in_state, section_failure,
};
use crate::figure::section::StateAxis;
use crate::output::{FormOptions, announce};
use crate::query_error::{QueryError, option};
use crate::{figure, interrupt, parallel};
use libration::chaos::{
    PoincareSection, Points, Section, SectionEnding, angles, compute_section, compute_section_with_errors,
};
use libration::progress::Status;
use libration::systems::Model;
use libration::taylor::{Cause, Moment};
use std::cell::Cell;
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

pub(crate) use write::answers;

/// Number of points kept by default.
const POINTS: usize = 1000;

/// Poincaré section: the state once per drive period, or whenever a formula crosses zero
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration section driven_pendulum --set A=1.5,c=1/2 --initial theta=0.2 \\
    --points 1000 --figure attractor.png
  libration section \"x'' + 0.05 x' + x^3 = 7.5 cos(t)\" \\
    --initial \"x=3,x'=4\" --phase 0.25 --points 100 --csv
  libration section lorenz --initial x=1,y=1,z=1 --at \"z'\" \\
    --direction falling --points 50
  libration section \"x'' = -x - 2 x y; y'' = -y - x^2 + y^2\" --at x \\
    --initial \"y=0.1,x'=0.4\" --initial \"y=-0.2,x'=0.4\" --points 50

The first points belong to the transient and are discarded; --skip says how many.
Repeat --initial for several motions, computed on all cores. Ctrl-C stops early
and keeps the points computed so far.")
)]
pub(crate) struct PoincareQuestion {
    #[command(flatten)]
    system: SystemOptions,
    #[command(flatten)]
    initial: SeveralInitialOptions,
    #[command(flatten)]
    section: SectionOptions,
    /// The two state variables that the picture shows [default: a coordinate and its velocity]
    #[arg(long, value_name = "NAME,NAME", requires = "figure")]
    axes: Option<String>,
    /// Draw the section to FILE.svg, .pdf, .png or .json instead of listing the points
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
}

/// The sections of all motions, with the settings of their output.
pub(crate) struct SectionResult<'a> {
    pub(crate) model: &'a Model,
    pub(crate) options: &'a SectionOptions,
    pub(crate) section: String,
    pub(crate) points: Points,
    pub(crate) angles: Vec<bool>,
    pub(crate) starts: Vec<Vec<f64>>,
    pub(crate) sections: Vec<PoincareSection>,
}

impl PoincareQuestion {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let model = self.system.model()?;
        let starts: Vec<Vec<f64>> =
            self.initial.read(&model)?.into_iter().map(|initial| initial.state).collect();
        let (section, points) = (self.section.section(&model)?, self.section.points_of_section(POINTS));
        let sections = self.sections(&model, &section, &starts)?;
        let answer = SectionResult {
            model: &model,
            options: &self.section,
            section: self.section.description(&section, model.equation()),
            points,
            angles: angles(model.equation()),
            starts,
            sections,
        };
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            let axes = self.axes(&model, &section)?.map(|component| StateAxis::new(&model, component));
            Ok(figure::section::section(&model, &answer.starts, &answer.sections, &axes))
        })?;
        answer.write(out, self.form.form(), drawn.is_empty())?;
        announce(out, self.form.form(), &drawn)?;
        out.flush()?;
        answer.failure().map_or(Ok(()), Err)
    }

    /// The axes of the picture: the first coordinate that the surface leaves free, and its velocity, or the next coordinate if that is not free.
    fn axes(&self, model: &Model, section: &Section) -> Result<[usize; 2], QueryError> {
        if let Some(names) = &self.axes {
            return places_in_state(model, &option("axes"), names);
        }
        let free = free_on(section, model);
        let mut coordinates = free.iter().copied().filter(|&component| component < model.coordinates().len());
        let first = coordinates.next().unwrap_or(0);
        let velocity = model.layout().velocity(first);
        let second = velocity.filter(|component| free.contains(component)).or_else(|| coordinates.next());
        Ok([first, second.or(velocity).unwrap_or(first)])
    }

    /// One section for each start, side by side.
    fn sections(
        &self,
        model: &Model,
        section: &Section,
        starts: &[Vec<f64>],
    ) -> Result<Vec<PoincareSection>, QueryError> {
        let points = self.section.points_of_section(POINTS);
        let (effort, taken) = (self.section.effort(), AtomicUsize::new(0));
        let with_errors = self.section.with_errors(self.figure.is_some(), self.form.form());
        let compute = if with_errors { compute_section_with_errors } else { compute_section };
        let all = points.recorded * starts.len();
        let how_far = || format!("{} of {all} points", taken.load(Ordering::Relaxed));
        let of_start = |state: &Vec<f64>| {
            let start = Moment { time: 0.0, state: state.clone() };
            let before = Cell::new(0);
            let progress = |status: Status| {
                taken.fetch_add(status.done - before.replace(status.done), Ordering::Relaxed);
                parallel::update(&how_far)
            };
            compute(model.equation(), &start, section, points, &effort, &progress)
        };
        interrupt::listen()?;
        let sections = parallel::with_progress(how_far, || parallel::map(starts, of_start));
        sections.into_iter().collect::<Result<_, _>>().map_err(section_failure)
    }
}

impl SectionResult<'_> {
    /// The reason for missing points, if there are any.
    fn failure(&self) -> Option<QueryError> {
        let first = self.sections.iter().find_map(|section| section.stopped)?;
        Some(match first {
            SectionEnding::Stopped(Cause::Interrupted) => {
                QueryError::cancelled("interrupted: the points up to then are written")
            }
            other => {
                let reason = other.to_string();
                let reason = reason.trim_end_matches(',');
                QueryError::no_result("section", format!("{reason}: {}", self.what_is_written()))
            }
        })
    }

    fn what_is_written(&self) -> &'static str {
        match self.sections.iter().all(|section| section.points.is_empty()) {
            true => "no point is written",
            false => "the points up to then are written",
        }
    }
}
