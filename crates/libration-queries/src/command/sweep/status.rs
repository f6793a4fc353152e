//! `libration sweep status`: the progress of a sweep.

use super::join::opened;
use super::plan::Plan;
use super::progress::SweepProgress;
use super::store::Store;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::table::sheet;
use crate::output::{Form, FormOptions, json};
use crate::query_error::QueryError;
use std::io::Write;
use std::path::PathBuf;

/// Show the progress of a sweep and the missing shards
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration sweep period --over amplitude=10deg:170deg:10deg --output periods
  libration sweep status periods")
)]
pub(crate) struct Status {
    /// The directories of the shards; a single one if all write to it
    #[arg(value_name = "DIR", required = true)]
    directories: Vec<PathBuf>,
    #[command(flatten)]
    form: FormOptions,
}

impl Status {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        write(out, self.form.form(), &opened(&self.directories)?)
    }
}

/// The plan of a sweep, and its progress.
struct SweepState<'a> {
    plan: &'a Plan,
    progress: SweepProgress,
}

impl SweepState<'_> {
    fn question(&self) -> String {
        self.plan.template.0.join(" ")
    }

    fn kept(&self) -> impl Iterator<Item = &str> {
        self.plan.kept.iter().map(|field| field.kept.name.as_str())
    }
}

/// Writes the progress of one sweep in several directories.
pub(crate) fn write(out: &mut dyn Write, form: Form, stores: &[Store]) -> Result<(), QueryError> {
    let state = SweepState { plan: &stores[0].plan, progress: SweepProgress::of(stores)? };
    let fields = of_status();
    match form {
        Form::Json => json::document(out, fields.record(&state))?,
        Form::Csv => fields.write_csv(out, [&state])?,
        Form::Table => sheet(out, &fields.lines(&state))?,
    }
    Ok(())
}

fn of_status<'a>() -> Fields<SweepState<'a>> {
    type Of<'a> = Field<SweepState<'a>>;
    let progress = Fields::from([
        Of::value("chunks", "1", "number of chunks of the sweep", |state| state.progress.chunks.into()),
        Of::value("chunks_whole", "1", "number of them that are complete", |state| {
            state.progress.done.len().into()
        })
        .line_of("complete chunks", |state| {
            format!("{} of {}", state.progress.done.len(), state.progress.chunks)
        }),
        Of::value("points", "1", "number of points of the grid", |state| state.progress.points.into()),
        Of::value("points_done", "1", "number of points in complete chunks", |state| {
            state.progress.points_done.into()
        })
        .line_of("points", |state| format!("{} of {}", state.progress.points_done, state.progress.points)),
        Of::value("without_answer", "1", "number of them without a result", |state| {
            state.progress.without_answer.into()
        })
        .line_of("without a result", |state| state.progress.without_answer.to_string()),
        Of::value("missing", "", "missing parts, in words, or null", |state| state.progress.missing().into())
            .line_of("missing", |state| state.progress.missing().unwrap_or_else(|| "nothing".to_owned())),
    ]);
    let asked = Fields::from([
        Of::value("question", "", "the command, where {NAME} stands for the value of an axis", |state| {
            state.question().into()
        })
        .line_of("question", SweepState::question),
        Of::value("kept[]", "", "names of the numbers kept of each result", |state| json::list(state.kept()))
            .line_of("kept of each result", |state| state.kept().collect::<Vec<_>>().join(", ")),
    ]);
    asked.and(progress)
}

pub(crate) fn answers() -> Vec<Answers> {
    let (json, csv) = (of_status().described(""), of_status().described_in_csv());
    vec![Answers { command: "sweep status", option: "", json, csv }]
}
