//! A recording: the options that override what is inferred from a file, and its reading.

use super::read_bytes;
use super::table::{DialectOptions, column};
use super::table_columns::TableFit;
use super::undecided::what_would_decide;
use crate::call::in_words;
use crate::query_error::QueryError;
use libration_lab::measurement::{
    Choices, Column, Finding, Gates, MeasurementError, Recording, Table, TimeStamps, Traces, Unit,
};
use std::path::Path;

/// Options for the reading of a recording, in place of the settings in the file.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Reading (detected in the file unless given)")]
pub(crate) struct RecordingOptions {
    /// Column of times, by number or name
    #[arg(long, value_name = "COLUMN", value_parser = column)]
    time: Option<Column>,
    /// Unit of times: s, ms, us, min
    #[arg(long, value_name = "UNIT", value_parser = unit)]
    time_unit: Option<Unit>,
    /// Times are numbers of frames of a video, with this many frames per second
    #[arg(long, value_name = "F", value_parser = super::positive, conflicts_with = "time_unit")]
    frame_rate: Option<f64>,
    /// Column of angles, by number or name
    #[arg(long, value_name = "COLUMN", value_parser = column)]
    angle: Option<Column>,
    /// Column of angular velocities, such as those of a gyroscope
    #[arg(long, value_name = "COLUMN", value_parser = column, conflicts_with_all = ["angle", "x", "y"])]
    angular_velocity: Option<Column>,
    /// Unit of angles or angular velocities: rad, deg, turn, rad/s, deg/s
    #[arg(long, alias = "unit", value_name = "UNIT", value_parser = unit)]
    angle_unit: Option<Unit>,
    /// Angles are encoder counts, with this many per turn
    #[arg(long, value_name = "N", value_parser = super::positive, conflicts_with = "angle_unit")]
    counts_per_turn: Option<f64>,
    /// Column of horizontal positions, instead of an angle
    #[arg(long, value_name = "COLUMN", value_parser = column, conflicts_with = "angle")]
    x: Option<Column>,
    /// Column of vertical positions
    #[arg(long, value_name = "COLUMN", value_parser = column, conflicts_with = "angle")]
    y: Option<Column>,
    /// Position of the pivot, in the unit of the positions, such as 0.1,1.5; otherwise a circle is fitted
    #[arg(long, value_name = "X,Y", value_parser = pivot)]
    pivot: Option<(f64, f64)>,
    /// Column of uncertainties of the angles or angular velocities
    #[arg(long, value_name = "COLUMN", value_parser = column)]
    uncertainty: Option<Column>,
    /// Column of the photogate's state, 1 or blocked, 0 or unblocked
    #[arg(long, value_name = "COLUMN", value_parser = column)]
    gate: Option<Column>,
    /// Column of a continuous signal whose dips or peaks are passages, as of a light sensor or of an accelerometer along the string
    #[arg(long, value_name = "COLUMN", value_parser = column, conflicts_with = "gate")]
    signal: Option<Column>,
    /// Ignore rows before this time, on the clock of the file
    #[arg(long, value_name = "TIME", value_parser = super::finite_time)]
    from: Option<f64>,
    /// Ignore rows after this time
    #[arg(long, value_name = "TIME", value_parser = super::finite_time)]
    to: Option<f64>,
    /// Take the times in the file as rounded, and use the equally spaced times from which they come
    #[arg(long, conflicts_with = "times_as_written")]
    even_times: bool,
    /// Use the times as written, even if they look like rounded, equally spaced ones
    #[arg(long)]
    times_as_written: bool,
    /// The run: its name, or its number as in `Run #3`; several as 1,2,6
    #[arg(long, value_name = "RUN,…")]
    run: Option<String>,
    #[command(flatten)]
    dialect: DialectOptions,
}

impl RecordingOptions {
    /// The file, read and not yet interpreted.
    pub(crate) fn recording(&self, path: &Path) -> Result<Recording, QueryError> {
        self.recording_in(path, &read_bytes(path)?)
    }

    /// The recording of a file whose bytes are known.
    pub(crate) fn recording_in(&self, path: &Path, bytes: &[u8]) -> Result<Recording, QueryError> {
        Recording::read(bytes, &self.dialect.options()).map_err(|error| failure(path, &error))
    }

    /// The fit of a table that these bytes hold, where its headings name both quantities.
    pub(crate) fn table_fit(&self, bytes: &[u8]) -> Option<TableFit> {
        let table = Table::read_sheet(bytes, &self.dialect.options(), self.dialect.sheet.as_ref());
        TableFit::of(&table.ok()?)
    }

    /// The traces of a file with all that was inferred from it.
    pub(crate) fn traces(&self, path: &Path) -> Result<Traces, QueryError> {
        let recording = self.recording(path)?;
        let mut traces = recording.traces(&self.choices()).map_err(|error| failure(path, &error))?;
        traces.findings.splice(0..0, recording.findings());
        Ok(traces)
    }

    /// The times of a photogate with all that was inferred from the file.
    pub(crate) fn gate_times(&self, path: &Path) -> Result<Gates, QueryError> {
        let recording = self.recording(path)?;
        let mut gates = recording.gate_times(&self.choices()).map_err(|error| failure(path, &error))?;
        gates.findings.splice(0..0, recording.findings());
        Ok(gates)
    }

    pub(crate) fn choices(&self) -> Choices {
        Choices {
            sheet: self.dialect.sheet.clone(),
            run: self.run.clone(),
            time: self.time.clone(),
            time_unit: self.time_unit,
            frame_rate: self.frame_rate,
            angle: self.angle.clone(),
            angular_velocity: self.angular_velocity.clone(),
            unit: self.angle_unit,
            counts_per_turn: self.counts_per_turn,
            x: self.x.clone(),
            y: self.y.clone(),
            pivot: self.pivot,
            uncertainty: self.uncertainty.clone(),
            gate: self.gate.clone(),
            signal: self.signal.clone(),
            from: self.from,
            to: self.to,
            stamps: match (self.even_times, self.times_as_written) {
                (true, _) => Some(TimeStamps::Even),
                (false, true) => Some(TimeStamps::AsWritten),
                (false, false) => None,
            },
        }
    }
}

/// A finding, with the option that would override it.
pub(crate) fn finding_with_option(finding: &Finding) -> String {
    match finding.choice {
        Some(choice) => in_words(&format!("{} (<--{choice}>)", finding.text)),
        None => finding.text.clone(),
    }
}

fn failure(path: &Path, error: &MeasurementError) -> QueryError {
    QueryError::no_result(&path.display().to_string(), what_would_decide(error))
}

fn unit(text: &str) -> Result<Unit, String> {
    text.parse::<Unit>().map_err(|error| error.to_string())
}

fn pivot(text: &str) -> Result<(f64, f64), String> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|number| number.is_finite());
    let pair = text.split_once(',').and_then(|(x, y)| Some((number(x)?, number(y)?)));
    pair.ok_or_else(|| "give two numbers, such as 0.1,1.5".to_owned())
}
