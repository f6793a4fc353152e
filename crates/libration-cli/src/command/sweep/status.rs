//! `libration sweep status`: how far a sweep is.

use super::join::opened;
use super::progress::Progress;
use crate::failure::Failure;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::table::sheet;
use crate::output::{Form, FormOptions, json};
use std::io::Write;
use std::path::PathBuf;

/// Say how far a sweep is, and which shards are missing
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration sweep period --over amplitude=10deg:170deg:10deg --output periods
  libration sweep status periods")]
pub(crate) struct Status {
    /// The directories of the shards; one where all write to the same
    #[arg(value_name = "DIR", required = true)]
    directories: Vec<PathBuf>,
    #[command(flatten)]
    form: FormOptions,
}

impl Status {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let stores = opened(&self.directories)?;
        let answer = (stores[0].plan.template.0.join(" "), Progress::of(&stores)?);
        write(out, self.form.form(), &answer)
    }
}

pub(crate) fn write(out: &mut dyn Write, form: Form, answer: &(String, Progress)) -> Result<(), Failure> {
    let fields = of_status();
    match form {
        Form::Json => json::document(out, fields.record(answer))?,
        Form::Csv => fields.write_csv(out, [answer])?,
        Form::Table => sheet(out, &fields.lines(answer))?,
    }
    Ok(())
}

fn of_status() -> Fields<(String, Progress)> {
    type Of = Field<(String, Progress)>;
    Fields::from([
        Of::value("question", "", "the question, where {NAME} stands for the value of an axis", |it| {
            it.0.as_str().into()
        })
        .line_of("question", |it| it.0.clone()),
        Of::value("chunks", "1", "number of chunks of the sweep", |it| it.1.chunks.into()),
        Of::value("chunks_whole", "1", "number of them that are whole", |it| it.1.done.len().into())
            .line_of("whole chunks", |it| format!("{} of {}", it.1.done.len(), it.1.chunks)),
        Of::value("points", "1", "number of points of the grid", |it| it.1.points.into()),
        Of::value("points_done", "1", "number of points in whole chunks", |it| it.1.points_done.into())
            .line_of("points", |it| format!("{} of {}", it.1.points_done, it.1.points)),
        Of::value("without_answer", "1", "number of them without an answer", |it| it.1.without_answer.into())
            .line_of("without an answer", |it| it.1.without_answer.to_string()),
        Of::value("missing", "", "what is missing, in words, or null", |it| it.1.missing().into())
            .line_of("missing", |it| it.1.missing().unwrap_or_else(|| "nothing".to_owned())),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let (json, csv) = (of_status().described(""), of_status().described_in_csv());
    vec![Answers { command: "sweep status", option: "", json, csv }]
}
