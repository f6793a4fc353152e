//! The recordings to be fitted, and the part of them that is used.

use crate::arguments::{RecordingOptions, finding_with_option};
use crate::query_error::QueryError;
use libration_lab::measurement::Trace;
use std::path::{Path, PathBuf};

/// The files.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct FitTraceInput {
    /// Recordings of the same pendulum: angle, angular velocity or position against time; - for standard input
    #[arg(required = true)]
    files: Vec<PathBuf>,
}

/// The recordings that were read.
#[derive(Clone, Debug)]
pub(super) struct ReadRecordings {
    pub(super) files: Vec<File>,
    /// Traces of all files, in the order of the files.
    pub(super) traces: Vec<Trace>,
}

/// A file with the inferences from it.
#[derive(Clone, Debug)]
pub(super) struct File {
    pub(super) name: String,
    pub(super) findings: Vec<String>,
}

impl FitTraceInput {
    pub(super) fn read(&self, options: &RecordingOptions) -> Result<ReadRecordings, QueryError> {
        let mut measured = ReadRecordings { files: vec![], traces: vec![] };
        for path in &self.files {
            let name = path.display().to_string();
            let traces = options.traces(path)?;
            for trace in traces.traces {
                let of_trace = self.name(&trace, path);
                measured.traces.push(trace.named(&of_trace));
            }
            measured
                .files
                .push(File { name, findings: traces.findings.iter().map(finding_with_option).collect() });
        }
        Ok(measured)
    }

    /// The name of the run, the file, or both: whatever distinguishes the trace from the others.
    fn name(&self, trace: &Trace, path: &Path) -> String {
        let file = short_name(path);
        match trace.name() {
            "" => file,
            run if self.files.len() == 1 => run.to_owned(),
            run => format!("{file}, {run}"),
        }
    }
}

/// The name of a file without its folders.
fn short_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

impl ReadRecordings {
    /// The files' names without folders, as one text.
    pub(super) fn short_names(&self) -> String {
        let names = self.files.iter().map(|file| short_name(Path::new(&file.name)));
        names.collect::<Vec<_>>().join(", ")
    }

    /// The files' names as one text.
    pub(super) fn names(&self) -> String {
        self.files.iter().map(|file| file.name.as_str()).collect::<Vec<_>>().join(", ")
    }
}
