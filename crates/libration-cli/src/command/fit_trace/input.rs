//! The recordings that are fitted, and the part of them that counts.

use crate::arguments::{RecordingOptions, finite_time, told};
use crate::failure::Failure;
use libration::measurement::{Faults, Trace};
use std::path::{Path, PathBuf};

/// Which files, and from when to when.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Input {
    /// Recordings of the same pendulum: angle, angular velocity or position against time; - for the standard input
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Leave out rows before this time, in the time of the file
    #[arg(long, value_name = "TIME", value_parser = finite_time)]
    from: Option<f64>,
    /// Leave out rows after this time
    #[arg(long, value_name = "TIME", value_parser = finite_time)]
    to: Option<f64>,
    /// Take the even times of which those in the file are roundings
    #[arg(long)]
    even_times: bool,
}

/// What was read.
#[derive(Clone, Debug)]
pub(super) struct Measured {
    pub(super) files: Vec<File>,
    /// Of all files, in their order.
    pub(super) traces: Vec<Trace>,
}

/// A file, and what was told from it.
#[derive(Clone, Debug)]
pub(super) struct File {
    pub(super) name: String,
    pub(super) findings: Vec<String>,
}

impl Input {
    pub(super) fn read(&self, options: &RecordingOptions) -> Result<Measured, Failure> {
        let mut measured = Measured { files: vec![], traces: vec![] };
        for path in &self.files {
            let name = path.display().to_string();
            let found = options.traces(path)?;
            for trace in &found.traces {
                let part = self.part(trace, &self.name(trace, path));
                measured.traces.push(part.map_err(|reason| Failure::no_answer(&name, reason))?);
            }
            measured.files.push(File { name, findings: found.findings.iter().map(told).collect() });
        }
        Ok(measured)
    }

    /// The name of the run, the file, or both: whatever tells the trace from the others.
    fn name(&self, trace: &Trace, path: &Path) -> String {
        let file = short_name(path);
        match trace.name() {
            "" => file,
            run if self.files.len() == 1 => run.to_owned(),
            run => format!("{file}, {run}"),
        }
    }

    /// The rows from when to when, under this name.
    fn part(&self, trace: &Trace, name: &str) -> Result<Trace, String> {
        let (from, to) = (self.from.unwrap_or(f64::NEG_INFINITY), self.to.unwrap_or(f64::INFINITY));
        let times = trace.times();
        let even = if self.even_times { Some(even_times(trace, name)?) } else { None };
        let chosen = |column: &[f64]| -> Vec<f64> {
            let rows = column.iter().zip(times).filter(|(_, time)| (from..=to).contains(*time));
            rows.map(|(value, _)| *value).collect()
        };
        let uncertainties = trace.uncertainties().map(chosen);
        let taken = chosen(even.as_deref().unwrap_or(times));
        Trace::new(name, trace.seen(), taken, chosen(trace.values()), uncertainties).map_err(|_| {
            let (first, last) = (times[0], times[times.len() - 1]);
            format!("--from and --to leave no row of {name}: its times are from {first} to {last} s")
        })
    }
}

/// Without the folders.
fn short_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// The even times that the instrument had before they were rounded.
fn even_times(trace: &Trace, name: &str) -> Result<Vec<f64>, String> {
    let grid = Faults::find(trace.times(), trace.values(), None).clock.and_then(|clock| clock.grid);
    grid.map(|grid| grid.times()).ok_or_else(|| {
        format!("the times of {name} are not rounded ones of even intervals: leave out --even-times")
    })
}

impl Measured {
    /// The files' names without folders, as one.
    pub(super) fn short_names(&self) -> String {
        let names = self.files.iter().map(|file| short_name(Path::new(&file.name)));
        names.collect::<Vec<_>>().join(", ")
    }

    /// The files' names, as one.
    pub(super) fn names(&self) -> String {
        self.files.iter().map(|file| file.name.as_str()).collect::<Vec<_>>().join(", ")
    }
}
