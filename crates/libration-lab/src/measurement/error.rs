//! What can be wrong with a file of measurements.

use super::choices::{Choice, Suggestion};

/// Why a file is no recording, or has not what is asked of it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeasurementError {
    /// More bytes than the limit.
    #[error("the file has {size} bytes, the limit is {limit}: give a smaller table")]
    TooLarge {
        /// Bytes.
        size: usize,
        /// Bytes.
        limit: usize,
    },
    /// Not text.
    #[error("the file is {0}, not a table as text: export it as CSV in UTF-8")]
    NotText(&'static str),
    /// A workbook that cannot be read.
    #[error("the workbook cannot be read, {0}: save it again, or export it as CSV")]
    DamagedWorkbook(String),
    /// A ZIP archive that cannot be read.
    #[error("the ZIP archive cannot be read, {0}: export it again")]
    DamagedArchive(String),
    /// Nothing but blank lines, comments and perhaps a header.
    #[error("the file has no rows of data: give at least one line of numbers")]
    Empty,
    /// A row with another number of cells than the others.
    #[error("line {line} has {found} cells where {expected} were expected: complete or remove the row")]
    Ragged {
        /// Counted from one.
        line: u64,
        /// Cells in the row.
        found: usize,
        /// Cells in the rows before.
        expected: usize,
    },
    /// A header with another number of names than there are columns.
    #[error(
        "line {line} names {names} columns, the rows below have {columns}: complete the header, or say that there is none"
    )]
    HeaderWidth {
        /// Counted from one.
        line: u64,
        /// Names.
        names: usize,
        /// Columns.
        columns: usize,
    },
    /// Numbers above the first good row.
    #[error(
        "line {line} is neither a header nor a row of numbers like those below it: correct it, or say which line is the header"
    )]
    NeitherHeaderNorNumbers {
        /// Counted from one.
        line: u64,
    },
    /// A cell over several lines.
    #[error("line {line} begins a quoted cell that is not closed on the same line: close the quote")]
    UnclosedQuote {
        /// Counted from one.
        line: u64,
    },
    /// A column whose cells have units that do not go together.
    #[error("{column} has {found}: write all of them in one unit")]
    MixedUnits {
        /// The column, as messages name it.
        column: String,
        /// The units that are mixed.
        found: String,
    },
    /// A cell that is no finite number.
    #[error("line {line}, column {column}: `{cell}` is not a finite number: write it as 1.25 or 1.25e-3")]
    NotANumber {
        /// Counted from one.
        line: u64,
        /// Counted from one.
        column: usize,
        /// The cell, shortened.
        cell: String,
    },
    /// No column of this number or name.
    #[error("there is no column `{asked}`: the table has {available}")]
    NoSuchColumn {
        /// The number or name.
        asked: String,
        /// What there is.
        available: String,
    },
    /// Two columns of this name.
    #[error("several columns are named `{0}`: ask by number, counted from 1")]
    AmbiguousColumn(String),
    /// None of several sheets has what is asked for; the first says why.
    #[error("no sheet has what is asked for; `{name}`: {error}")]
    OfSheet {
        /// The sheet.
        name: String,
        /// Why not.
        error: Box<Self>,
    },
    /// No sheet or run of this name.
    #[error("there is no {what} `{asked}`: the file has {available}")]
    NoSuch {
        /// `sheet` or `run`.
        what: &'static str,
        /// As asked.
        asked: String,
        /// What there is.
        available: String,
    },
    /// Not one row is complete in the columns asked for.
    #[error("none of the {0} rows has a number in every column asked for: ask for other columns")]
    NothingComplete(usize),
    /// More than any measurement has.
    #[error("{place} has {count} {what}, the limit is {limit}: give fewer")]
    TooMany {
        /// Of what.
        what: &'static str,
        /// How many.
        count: usize,
        /// Where.
        place: String,
        /// At most.
        limit: usize,
    },
    /// Something that the file does not decide.
    #[error("{question}: say {}", listed(.choices, &|choice| format!("{choice}=")))]
    Undecided {
        /// What is open, and why.
        question: String,
        /// What would decide it.
        choices: Vec<Suggestion>,
    },
    /// Times that go back more often than a clock is set back or a row misplaced.
    #[error(
        "line {line}: the time {after} follows {before}, and not only there: put the rows in the order of time, or split the runs"
    )]
    TimeGoesBack {
        /// Counted from one.
        line: u64,
        /// As in the file.
        before: f64,
        /// As in the file.
        after: f64,
    },
    /// A number that is no state of a photogate.
    #[error("line {line}: {found} is not a state of a photogate: give 1 or blocked, 0 or unblocked")]
    NotAState {
        /// Counted from one.
        line: u64,
        /// As in the file.
        found: f64,
    },
    /// Positions that do not say where the pivot is.
    #[error("{0}: say where the pivot is with pivot=X,Y")]
    PivotUnknown(String),
    /// Horizontal and vertical positions in different units.
    #[error("the positions are in {x} and in {y}: give both in one unit")]
    PositionUnits {
        /// Of the horizontal positions.
        x: String,
        /// Of the vertical positions.
        y: String,
    },
    /// Values that are no trace.
    #[error(transparent)]
    Trace(#[from] super::TraceError),
    /// A column whose heading says that it holds something else than it is asked for.
    #[error("{column} holds {found} by its header, where {expected} are needed: ask for other columns")]
    HoldsOther {
        /// Its number and name.
        column: String,
        /// By its header.
        found: &'static str,
        /// What it is asked for.
        expected: super::Role,
    },
    /// Times, and nothing that was measured at them.
    #[error(
        "{0} holds times, and no other column can be an angle: a trace needs angles, angular velocities or positions"
    )]
    OnlyTimes(String),
    /// Times that go back again and again.
    #[error(
        "{goes_back} of {rows} times are less than the one before: they are not times of a photogate; are they periods?"
    )]
    NotGateTimes {
        /// How many.
        goes_back: usize,
        /// Of how many.
        rows: usize,
    },
    /// Accelerations, from which alone neither angle nor angular velocity follows.
    #[error(
        "{column} holds accelerations: along the string g·cos θ + r·θ′², which goes through two periods in one swing, across it \
         g·sin θ + r·θ″, which vanishes where the pendulum is a simple one of length r. What is missing is the sensor's distance r \
         from the pivot, its direction and its sign: record the gyroscope, whose angular velocity needs none of them"
    )]
    Accelerations {
        /// Its number and name.
        column: String,
    },
    /// Times so coarse that rows share them, and that are no roundings of even ones.
    #[error(
        "{run}the times have {digits} significant digits, so several rows share one time, and no evenly spaced times round to them, as where rows \
         are missing: export the times with more digits"
    )]
    CoarseTimes {
        /// Whose they are, with a colon, or nothing.
        run: String,
        /// How many.
        digits: usize,
    },
    /// Times that are no roundings of even ones.
    #[error("{run}the times are not evenly spaced times that were rounded: keep them as written")]
    NotEven {
        /// Whose they are, with a colon, or nothing.
        run: String,
    },
    /// No row between the times that are asked for.
    #[error("{run}no row lies between the times asked for: the times run from {first} to {last} s")]
    NothingBetween {
        /// Whose they are, with a colon, or nothing.
        run: String,
        /// In seconds.
        first: f64,
        /// In seconds.
        last: f64,
    },
    /// A unit that does not fit what it is said of.
    #[error("{unit} is not a unit of {of}: give one such as {examples}")]
    WrongUnit {
        /// As said.
        unit: super::Unit,
        /// Of what.
        of: &'static str,
        /// What would do.
        examples: &'static str,
    },
}

impl MeasurementError {
    /// The message, with choices written as a shell of the library has them: `name` gives `unit=` or `--unit `, and so on.
    #[must_use]
    pub fn message(&self, name: &dyn Fn(Choice) -> String) -> String {
        match self {
            Self::Undecided { question, choices } => format!("{question}: say {}", listed(choices, name)),
            Self::OfSheet { name: sheet, error } => {
                format!("no sheet has what is asked for; `{sheet}`: {}", error.message(name))
            }
            Self::PivotUnknown(why) => {
                format!("{why}: say where the pivot is with {}X,Y", name(Choice::Pivot))
            }
            other => other.to_string(),
        }
    }
}

/// `unit=rad, deg or counts-per-turn=4000`, `angle=2 or 3 and unit=rad or deg`.
fn listed(choices: &[Suggestion], name: &dyn Fn(Choice) -> String) -> String {
    let mut text = String::new();
    let mut before: Option<Choice> = None;
    for (place, Suggestion { choice, value }) in choices.iter().enumerate() {
        let again = choices.get(place + 1).is_some_and(|next| next.choice == *choice);
        text += match before {
            None => "",
            Some(same) if same == *choice && again => ", ",
            Some(other) if other == *choice || is_the_scale(other) && is_the_scale(*choice) => " or ",
            Some(_) if *choice == Choice::X => ", or ",
            Some(_) => " and ",
        };
        if before != Some(*choice) {
            text += &name(*choice);
        }
        text += value;
        before = Some(*choice);
    }
    text
}

/// One of these says what a number of the file is in radians.
fn is_the_scale(choice: Choice) -> bool {
    matches!(choice, Choice::Unit | Choice::CountsPerTurn)
}
