//! Many motions of a system in one run, from a table of initial values and parameters.

mod ensemble;
mod fields;
mod follow;
mod list;
mod setting;
mod write;

use super::Simulate;
use super::ending::Ending;
use crate::arguments::{GivenSystem, Meaning, MotionTable, Tolerances};
use crate::figure;
use crate::figure::motions::{MOST_CURVES, Motions};
use crate::figure::section::StateAxis;
use crate::figure::simulation::POINTS;
use crate::output::file::NewFile;
use crate::output::{Form, announce};
use crate::query_error::{Parameter, QueryError, option};
use crate::{arguments, interrupt};
use follow::Followed;
use libration::systems::Model;
use list::Listed;
use setting::Setting;
use std::io::Write;
use std::path::Path;

pub(super) use fields::answers;

/// The samples of all motions are kept until the last one is known: at most this many numbers, half a gigabyte.
const MOST_NUMBERS: usize = 1 << 26;

/// The motions of a table, with the query common to all.
pub(super) struct SimulatedEach<'a> {
    path: &'a Path,
    table: &'a MotionTable,
    /// The model with the parameters of the table open.
    model: &'a Model,
    tolerances: &'a Tolerances,
    with_events: bool,
    motions: Vec<(&'a Listed<'a>, Followed<'a>)>,
}

impl Simulate {
    /// The motions of a table, each as it would be alone.
    pub(super) fn answer_each(&self, path: &Path, out: &mut dyn Write) -> Result<(), QueryError> {
        self.refuse_for_each()?;
        let system = self.system.given()?;
        let table = MotionTable::read(path, &system)?;
        let model = open_model(&system, &table)?;
        let mut settings: Vec<Setting> = vec![];
        let setting_indices = setting::places(self, path, &system, &table, &mut settings)?;
        let motions = list::listed(self, path, &table, &setting_indices, &settings)?;
        self.check_size(&motions)?;
        let axes =
            self.axes.as_deref().map(|names| arguments::places_in_state(&model, &option("axes"), names));
        let axes = axes.transpose()?.map(|components| components.map(|index| StateAxis::new(&model, index)));
        interrupt::listen()?;
        let is_drawn = figure::file::is_drawn(self.figure.as_deref()) && motions.len() <= MOST_CURVES;
        let followed = follow::all(&motions, is_drawn);
        let done = motions.iter().zip(followed).filter_map(|(motion, followed)| Some((motion, followed?)));
        let answer = SimulatedEach {
            path,
            table: &table,
            model: &model,
            tolerances: &self.tolerance,
            with_events: !settings[0].watched.is_empty(),
            motions: done.collect(),
        };
        let drawn =
            figure::file::drawn(self.figure.as_deref(), &self.layout, || Ok(answer.picture(axes.as_ref())))?;
        self.write_each(&answer, drawn, out)?;
        answer.into_result(motions.len())
    }

    /// Writes the result to its destination.
    fn write_each(
        &self,
        answer: &SimulatedEach<'_>,
        drawn: Vec<String>,
        out: &mut dyn Write,
    ) -> Result<(), QueryError> {
        let form = self.form.form_of_file(self.output.as_deref());
        let listed = drawn.is_empty();
        let (on_screen, written) = match &self.output {
            None => {
                answer.write(form, listed, out)?;
                (form, drawn)
            }
            Some(path) => {
                let mut file = NewFile::create(path)?;
                answer.write(form, listed, &mut file)?;
                file.finish()?;
                let subject = figure::names::subject(answer.model);
                let text =
                    format!("{} written: {} motions of {subject}", path.display(), answer.motions.len());
                (Form::Table, [vec![text], drawn].concat())
            }
        };
        announce(out, on_screen, &written)?;
        Ok(out.flush()?)
    }

    /// Refuses options for a single motion.
    fn refuse_for_each(&self) -> Result<(), QueryError> {
        let refused = |about: Parameter, reason: &str| Err(QueryError::usage(about, reason));
        match () {
            () if self.resume.is_some() => refused(
                option("resume"),
                "it continues one motion, and <--each> gives several: run them again from 0",
            ),
            () if self.animate => refused(
                option("animate"),
                "it shows the bodies of one motion, and <--each> gives several: give one of them",
            ),
            () => self.refuse_beside_sensitivities(),
        }
    }

    /// Refuses more than is kept, or can be distinguished.
    fn check_size(&self, motions: &[Listed<'_>]) -> Result<(), QueryError> {
        let points = if self.figure.is_some() { POINTS as usize + 1 } else { 0 };
        let of_one = |listed: &Listed<'_>| {
            let width = listed.motion.initial.state.len() + listed.motion.column_names().len() + 1;
            self.times.len().saturating_add(points).saturating_mul(width)
        };
        let numbers = motions.iter().map(of_one).fold(0, usize::saturating_add);
        if self.figure.is_some() && motions.len() > MOST_CURVES {
            let reason = format!(
                "a picture distinguishes at most {MOST_CURVES} motions, and there are {}: give fewer, or list them",
                motions.len()
            );
            return Err(QueryError::usage(option("figure"), reason));
        }
        if numbers > MOST_NUMBERS {
            let reason = format!(
                "{} motions at {} times are {numbers} numbers, and at most {MOST_NUMBERS} are kept: give fewer <--times> or fewer motions",
                motions.len(),
                self.times.len()
            );
            return Err(QueryError::usage(option("each"), reason));
        }
        Ok(())
    }
}

/// The model with the parameters of a table open.
fn open_model(system: &GivenSystem<'_>, table: &MotionTable) -> Result<Model, QueryError> {
    let parameters = table.columns.iter().filter(|column| column.meaning == Meaning::Parameter);
    system
        .model_with_open(&parameters.map(|column| column.title.as_str()).collect::<Vec<_>>(), &option("each"))
}

impl SimulatedEach<'_> {
    fn picture(&self, axes: Option<&[StateAxis; 2]>) -> figure::chart::Picture {
        let curves = self
            .motions
            .iter()
            .filter_map(|(listed, followed)| Some((listed.label(self.table), followed.trace.as_ref()?)));
        let motions = Motions { model: self.model, traces: curves.collect() };
        match axes {
            Some(axes) => motions.in_plane(axes),
            None => motions.in_time(),
        }
    }

    /// The error after the result is written: the number of motions, out of `all`, that did not reach their ends.
    fn into_result(self, all: usize) -> Result<(), QueryError> {
        /// More are not listed.
        const MOST: usize = 3;
        let is_interrupted = |followed: &Followed<'_>| matches!(followed.ending, Ending::Interrupted(_));
        let complete = self.motions.iter().filter(|(_, followed)| !is_interrupted(followed)).count();
        if complete < all {
            return Err(QueryError::cancelled(format!(
                "interrupted: {complete} of {all} motions are done, and what was computed of the others is written"
            )));
        }
        let reason = |(listed, followed): &(&Listed<'_>, Followed<'_>)| match &followed.ending {
            Ending::NotReached(reason) | Ending::Stopped(reason) => {
                Some(format!("motion {}: {reason}", listed.title(self.table)))
            }
            _ => None,
        };
        let reasons: Vec<String> = self.motions.iter().filter_map(reason).collect();
        let others = match reasons.len().saturating_sub(MOST) {
            0 => String::new(),
            others => format!("; and {others} more of {all} motions"),
        };
        match reasons.as_slice() {
            [] => Ok(()),
            some => Err(QueryError::failed(some[..some.len().min(MOST)].join("; ") + &others)),
        }
    }
}
