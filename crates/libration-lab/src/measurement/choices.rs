//! Choices about a file that replace inferences from it.

use std::convert::Infallible;
use std::fmt;
use std::str::FromStr;

use super::heading::Unit;

/// A column, by its number counted from one or by its name without regard to case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Column {
    /// Number of the column, from 1.
    Number(usize),
    /// The name as in the header, with or without its unit.
    Name(String),
}

/// A whole number is a number, anything else a name.
impl FromStr for Column {
    type Err = Infallible;
    fn from_str(text: &str) -> Result<Self, Infallible> {
        let text = text.trim();
        Ok(text.parse().map_or_else(|_| Self::Name(text.into()), Self::Number))
    }
}

/// Roles of the columns of a recording that are not to be inferred from the file; `None` leaves the choice to the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Choices {
    /// The sheet, by its name or its number counted from one.
    pub sheet: Option<Column>,
    /// The run: the text after `Run #` in the header, or the number in the column of runs; several separated by
    /// commas.
    pub run: Option<String>,
    /// The column of times.
    pub time: Option<Column>,
    /// The unit of times.
    pub time_unit: Option<Unit>,
    /// Number of frames in a second, if the times are numbers of frames of a video.
    pub frame_rate: Option<f64>,
    /// The column of angles.
    pub angle: Option<Column>,
    /// The column of angular velocities.
    pub angular_velocity: Option<Column>,
    /// The unit of the angles or angular velocities.
    pub unit: Option<Unit>,
    /// Number of counts of an encoder in a turn.
    pub counts_per_turn: Option<f64>,
    /// The column of horizontal positions.
    pub x: Option<Column>,
    /// The column of vertical positions.
    pub y: Option<Column>,
    /// Position of the pivot, in the unit of the positions.
    pub pivot: Option<(f64, f64)>,
    /// The column of uncertainties of angles or angular velocities.
    pub uncertainty: Option<Column>,
    /// The column of the states of a photogate, blocked or not.
    pub gate: Option<Column>,
    /// The column of a continuous signal whose dips or peaks are passages of a gate.
    pub signal: Option<Column>,
    /// Leave out rows before this time, in seconds of the file's own time.
    pub from: Option<f64>,
    /// Leave out rows after this time.
    pub to: Option<f64>,
    /// The times to use if those of the file are rounded.
    pub stamps: Option<TimeStamps>,
}

/// The times to use if those of the file are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeStamps {
    /// The times as written.
    AsWritten,
    /// The equally spaced times of which they are roundings.
    Even,
}

/// Name of a choice, as an option has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Choice {
    /// The delimiter of cells.
    Delimiter,
    /// Decimal point or decimal comma.
    Decimal,
    /// The line that names the columns.
    Header,
    /// The sheet.
    Sheet,
    /// The run.
    Run,
    /// The column of times.
    Time,
    /// The unit of times.
    TimeUnit,
    /// Frames of a video in a second.
    FrameRate,
    /// The column of angles.
    Angle,
    /// The column of angular velocities.
    AngularVelocity,
    /// The unit of angles or angular velocities.
    Unit,
    /// Counts of the encoder in a turn.
    CountsPerTurn,
    /// The column of horizontal positions.
    X,
    /// The column of vertical positions.
    Y,
    /// The pivot.
    Pivot,
    /// The column of uncertainties.
    Uncertainty,
    /// The column of the photogate's state.
    Gate,
    /// The column of a continuous signal.
    Signal,
    /// Times as written, even if they are roundings of equally spaced ones.
    TimesAsWritten,
    /// The columns of a table of results.
    Columns,
    /// The role of a column of a table of results.
    Role,
}

impl fmt::Display for Choice {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Delimiter => "delimiter",
            Self::Decimal => "decimal",
            Self::Header => "header",
            Self::Sheet => "sheet",
            Self::Run => "run",
            Self::Time => "time",
            Self::TimeUnit => "time-unit",
            Self::FrameRate => "frame-rate",
            Self::Angle => "angle",
            Self::AngularVelocity => "angular-velocity",
            Self::Unit => "angle-unit",
            Self::CountsPerTurn => "counts-per-turn",
            Self::X => "x",
            Self::Y => "y",
            Self::Pivot => "pivot",
            Self::Uncertainty => "uncertainty",
            Self::Gate => "gate",
            Self::Signal => "signal",
            Self::TimesAsWritten => "times-as-written",
            Self::Columns => "columns",
            Self::Role => "role",
        })
    }
}

/// A choice with a value that would do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// The choice.
    pub choice: Choice,
    /// A value that would do.
    pub value: String,
}

impl Suggestion {
    pub(super) fn new(choice: Choice, value: impl Into<String>) -> Self {
        Self { choice, value: value.into() }
    }
}

impl fmt::Display for Suggestion {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}={}", self.choice, self.value)
    }
}

/// An inference from a file, as a sentence, and the choice that would override it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The sentence, without a full stop.
    pub text: String,
    /// The choice that would override it, if there is one.
    pub choice: Option<Choice>,
}

impl Finding {
    pub(super) fn new(text: impl Into<String>, choice: Choice) -> Self {
        Self { text: text.into(), choice: Some(choice) }
    }

    pub(super) fn fact(text: impl Into<String>) -> Self {
        Self { text: text.into(), choice: None }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.choice {
            Some(choice) => write!(out, "{} ({choice} overrides it)", self.text),
            None => out.write_str(&self.text),
        }
    }
}
