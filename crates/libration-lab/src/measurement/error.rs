//! Errors in files of measurements.

use super::choices::{Choice, Suggestion};
use libration::quantity::alternatives;

/// Reason why a file is not a recording, or lacks the data requested.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeasurementError {
    /// Relative uncertainties whose heading does not state the unit of their values.
    #[error(
        "{location} holds relative uncertainties, and its heading does not say whether in % or as fractions: write % into it, or multiply them by the values"
    )]
    RelativeWithoutUnit {
        /// The column.
        location: String,
    },
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
    #[error(
        "line {line} has {cells} cell{} where {expected} were expected: complete or remove the row",
        if *cells == 1 { "" } else { "s" }
    )]
    Ragged {
        /// Number of the line, from 1.
        line: u64,
        /// Cells in the row.
        cells: usize,
        /// Cells in the rows before.
        expected: usize,
    },
    /// A header with another number of names than there are columns.
    #[error(
        "line {line} names {names} columns, the rows below have {columns}: complete the header, or specify that there is none"
    )]
    HeaderWidth {
        /// Number of the line, from 1.
        line: u64,
        /// Names.
        names: usize,
        /// Columns.
        columns: usize,
    },
    /// Numbers above the first complete row.
    #[error(
        "line {line} is neither a header nor a row of numbers like those below it: correct it, or specify the header line"
    )]
    NeitherHeaderNorNumbers {
        /// Number of the line, from 1.
        line: u64,
    },
    /// A cell over several lines.
    #[error("line {line} begins a quoted cell that is not closed on the same line: close the quote")]
    UnclosedQuote {
        /// Number of the line, from 1.
        line: u64,
    },
    /// A column whose cells have incompatible units.
    #[error("{column} has {units}: write all of them in one unit")]
    MixedUnits {
        /// The column, as messages name it.
        column: String,
        /// The units that are mixed.
        units: String,
    },
    /// A cell that is not a finite number.
    #[error(
        "line {line}, column {column}: `{cell}` is not a finite number: write it as 1.25 or 1.25e-3, or begin the line with # to leave it out"
    )]
    NotANumber {
        /// Number of the line, from 1.
        line: u64,
        /// Number of the column, from 1.
        column: usize,
        /// The cell, shortened.
        cell: String,
    },
    /// A formula of a spreadsheet in place of its value.
    #[error(
        "line {line}, column {column}: `{cell}` is a formula without its value: save the table with values in place of formulas"
    )]
    Formula {
        /// Number of the line, from 1.
        line: u64,
        /// Number of the column, from 1.
        column: usize,
        /// The cell, shortened.
        cell: String,
    },
    /// Numbers with decimal commas among others with decimal points.
    #[error("{}: `{cell}` has a {}, and other numbers of the table have a decimal {mark}: write all with the same decimal mark, without marks of thousands", in_lines(.lines), .mark.other())]
    MixedMarks {
        /// Lines with the other mark, from 1.
        lines: Vec<u64>,
        /// The first cell with the other mark, shortened.
        cell: String,
        /// The mark with which the table is read.
        mark: super::DecimalMark,
    },
    /// No column of this number or name.
    #[error("there is no column `{asked}`: the table has {available}")]
    NoSuchColumn {
        /// The number or name.
        asked: String,
        /// The columns available.
        available: String,
    },
    /// Two columns of this name.
    #[error("several columns are named `{0}`: give a number, counted from 1")]
    AmbiguousColumn(String),
    /// No sheet of several has the data requested; the error is that of the first.
    #[error("no sheet has the requested columns; `{name}`: {error}")]
    OfSheet {
        /// The sheet.
        name: String,
        /// The reason.
        error: Box<Self>,
    },
    /// No sheet or run of this name.
    #[error("there is no {what} `{asked}`: the file has {available}")]
    NoSuch {
        /// `sheet` or `run`.
        what: &'static str,
        /// The name requested.
        asked: String,
        /// The names available.
        available: String,
    },
    /// No row is complete in the columns requested.
    #[error("none of the {0} rows has a number in every requested column: give other columns")]
    NothingComplete(usize),
    /// Fewer columns of numbers than needed.
    #[error("{names} are needed, and the table has {numbers} column{} of numbers{words}", if *.numbers == 1 { "" } else { "s" })]
    TooFewColumns {
        /// The quantities needed.
        names: String,
        /// Number of columns of numbers.
        numbers: usize,
        /// A clause about a column of text, or nothing.
        words: String,
    },
    /// More than any measurement has.
    #[error("{location} has {count} {what}, the limit is {limit}: give fewer")]
    TooMany {
        /// The kind of items.
        what: &'static str,
        /// The number of columns.
        count: usize,
        /// The position of the cell.
        location: String,
        /// Largest number that is allowed.
        limit: usize,
    },
    /// A setting that the file does not determine.
    #[error("{question}: give {}", listed(.choices, &assigned))]
    Undecided {
        /// The open question, with its reason.
        question: String,
        /// Choices that would decide it.
        choices: Vec<Suggestion>,
    },
    /// Times that go back more often than a clock is set back or a row misplaced.
    #[error(
        "line {line}: the time {after} follows {before}, and not only there: put the rows in the order of time, or split the runs"
    )]
    TimeGoesBack {
        /// Number of the line, from 1.
        line: u64,
        /// The earlier time, as in the file.
        before: f64,
        /// The later time, as in the file.
        after: f64,
    },
    /// A number that is not a state of a photogate.
    #[error("line {line}: {value} is not a state of a photogate: give 1 or blocked, 0 or unblocked")]
    NotAState {
        /// Number of the line, from 1.
        line: u64,
        /// The number, as in the file.
        value: f64,
    },
    /// Positions that do not determine the pivot.
    #[error("{0}: give the position of the pivot as pivot=X,Y")]
    PivotUnknown(String),
    /// Horizontal and vertical positions in different units.
    #[error("the positions are in {x} and in {y}: give both in one unit")]
    PositionUnits {
        /// The unit of the horizontal positions.
        x: String,
        /// The unit of the vertical positions.
        y: String,
    },
    /// Values that are not a trace.
    #[error(transparent)]
    Trace(#[from] super::TraceError),
    /// A column whose heading states a content other than the requested one.
    #[error("{column} holds {content} by its header, where {expected} are needed: give other columns")]
    HoldsOther {
        /// The number and name of the column.
        column: String,
        /// The quantity by its header.
        content: &'static str,
        /// The role for which it was chosen.
        expected: super::Role,
    },
    /// Times without measured values.
    #[error(
        "{0} holds times, and no other column can be an angle: a trace needs angles, angular velocities or positions"
    )]
    OnlyTimes(String),
    /// A column with two levels, in place of angles.
    #[error(
        "{column} is at one of two levels in nearly all rows, as the signal of a light barrier: it contains the times of passages, not angles"
    )]
    GateSignal {
        /// The number and name of the column.
        column: String,
        /// The number of the column, from one.
        number: usize,
    },
    /// Times that go back again and again.
    #[error(
        "{goes_back} of {rows} times are less than the one before: they are not times of a photogate; are they periods?"
    )]
    NotGateTimes {
        /// Number of times that are less than the one before.
        goes_back: usize,
        /// Number of all times.
        rows: usize,
    },
    /// Times of a gate that go back and continue from there.
    #[error(
        "line {line}: the time goes back from {before} s to {after} s and continues from there, as of a clock that overflowed or was set back, \
         or of another run: take the times before or after that line alone"
    )]
    GateClockRestarts {
        /// Number of the line, from 1.
        line: u64,
        /// The time before, in seconds.
        before: f64,
        /// The time on that line, in seconds.
        after: f64,
    },
    /// A signal without passages of a gate.
    #[error(
        "{column} does not show three dips or peaks that last for two rows or more and stand out from its noise by ten standard deviations: no passages can \
         be taken from it"
    )]
    NoPassages {
        /// The number and name of the column.
        column: String,
    },
    /// Accelerations, from which alone neither angle nor angular velocity follows.
    #[error(
        "{column} holds accelerations: along the string g·cos θ + r·θ′², which goes through two periods in one swing, across it \
         g·sin θ + r·θ″, which vanishes where the pendulum is a simple one of length r. What is missing is the sensor's distance r \
         from the pivot, its direction and its sign: record the gyroscope, whose angular velocity needs none of them"
    )]
    Accelerations {
        /// The number and name of the column.
        column: String,
    },
    /// Times so coarse that rows share them, and that are not roundings of equally spaced ones.
    #[error(
        "{run}the times have {digits} significant digits, so several rows share one time, and no evenly spaced times round to them, as where rows \
         are missing: export the times with more digits"
    )]
    CoarseTimes {
        /// The run, with a colon, or an empty text.
        run: String,
        /// Number of digits.
        digits: usize,
    },
    /// Times that are not roundings of equally spaced ones.
    #[error("{run}the times are not evenly spaced times that were rounded: keep them as written")]
    NotEven {
        /// The run, with a colon, or an empty text.
        run: String,
    },
    /// No row between the times that are requested.
    #[error("{run}no row lies between the given times: the times run from {first} to {last} s")]
    NothingBetween {
        /// The run, with a colon, or an empty text.
        run: String,
        /// The first time, in seconds.
        first: f64,
        /// The last time, in seconds.
        last: f64,
    },
    /// A unit that does not fit its quantity.
    #[error("{unit} is not a unit of {of}: give one such as {examples}")]
    WrongUnit {
        /// The unit given.
        unit: super::Unit,
        /// The quantity.
        of: &'static str,
        /// Examples of units of the quantity.
        examples: &'static str,
    },
}

impl MeasurementError {
    /// The message, with choices as a front end writes them: `setting` writes a choice with its alternative values.
    #[must_use]
    pub fn message(&self, setting: &dyn Fn(Choice, &[&str]) -> String) -> String {
        match self {
            Self::Undecided { question, choices } => format!("{question}: give {}", listed(choices, setting)),
            Self::OfSheet { name: sheet, error } => {
                format!("no sheet has the requested columns; `{sheet}`: {}", error.message(setting))
            }
            Self::PivotUnknown(why) => {
                format!("{why}: give the position of the pivot as {}", setting(Choice::Pivot, &["X,Y"]))
            }
            other => other.to_string(),
        }
    }
}

/// `angle-unit=rad or deg or counts-per-turn=4000`, `angle=2 or 3 and angle-unit=rad or deg`.
fn listed(choices: &[Suggestion], setting: &dyn Fn(Choice, &[&str]) -> String) -> String {
    let mut text = String::new();
    let mut before: Option<Choice> = None;
    for alike in choices.chunk_by(|one, next| one.choice == next.choice) {
        let choice = alike[0].choice;
        text += match before {
            None => "",
            Some(other) if is_the_scale(other) && is_the_scale(choice) => " or ",
            Some(_) if choice == Choice::X => ", or ",
            Some(_) => " and ",
        };
        let values: Vec<&str> = alike.iter().map(|suggestion| suggestion.value.as_ref()).collect();
        text += &setting(choice, &values);
        before = Some(choice);
    }
    text
}

/// `line 5`, `lines 5, 7`.
fn in_lines(lines: &[u64]) -> String {
    const SHOWN: usize = 5;
    let numbers: Vec<String> = lines.iter().take(SHOWN).map(u64::to_string).collect();
    let (plural, more) =
        (if lines.len() > 1 { "s" } else { "" }, if lines.len() > SHOWN { ", …" } else { "" });
    format!("line{plural} {}{more}", numbers.join(", "))
}

/// The choice with its values, as the library writes it: `angle-unit=rad or deg`.
fn assigned(choice: Choice, values: &[&str]) -> String {
    format!("{choice}={}", alternatives(values))
}

/// Returns `true` for choices of the unit or scale of values.
fn is_the_scale(choice: Choice) -> bool {
    matches!(choice, Choice::Unit | Choice::CountsPerTurn)
}
