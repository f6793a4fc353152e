//! Commas that may separate cells or decimals: distinguished if the file allows it, otherwise refused.

use super::MeasurementError;
use super::choices::{Choice, Suggestion};
use super::dialect::{Delimiter, Dialect, SAMPLE};
use super::heading::Heading;
use super::number::DecimalMark;
use super::options::ReadOptions;
use super::sheet::Sheet;
use super::text::is_blank_or_comment;
use std::borrow::Cow;

/// Refuses a text with ambiguous commas, unless their meaning is given.
pub(super) fn refuse(text: &str, sheet: &Sheet, options: &ReadOptions) -> Result<(), MeasurementError> {
    let rows: Vec<&str> = text
        .lines()
        .zip(1..)
        .filter(|(line, number)| {
            sheet.lines.first().is_some_and(|first| number >= first) && !is_blank_or_comment(line)
        })
        .map(|(line, _)| line)
        .take(SAMPLE)
        .collect();
    let is_said = options.delimiter.is_some() || options.decimal.is_some();
    let are_whole = || rows.iter().all(|row| of_whole_numbers(row));
    match sheet.dialect {
        Dialect { delimiter: Delimiter::Comma, mark: DecimalMark::Point, .. } => {
            let is_open = !is_said && sheet.header_line.is_none() && are_whole();
            if is_open { Err(commas_between_digits(sheet)) } else { Ok(()) }
        }
        // Numbers with a decimal comma in one column look like two columns of whole numbers.
        Dialect { mark: DecimalMark::Comma, .. } if !is_said && are_whole() => {
            Err(commas_between_digits(sheet))
        }
        // Semicolons stand between cells where commas are decimal ones.
        Dialect { mark: DecimalMark::Comma, delimiter, .. }
            if options.decimal.is_none() && delimiter != Delimiter::Semicolon =>
        {
            only_thousands(&rows, delimiter).map_or(Ok(()), |number| Err(thousands(&number)))
        }
        _ => Ok(()),
    }
}

/// Returns `true` for `0,52` and the like below a single name with a unit, some with two digits or more after the comma: a second column without a
/// name may hold states, which have one, and other words may be a title.
pub(super) fn are_decimals_below_one_name(text: &str) -> bool {
    let lines: Vec<&str> = text.lines().filter(|line| !is_blank_or_comment(line)).take(SAMPLE).collect();
    let first = lines.iter().position(|line| of_whole_numbers(line)).unwrap_or(0);
    let (above, rows) = lines.split_at(first);
    let is_name = |name: &&str| Heading::read(name, None, None).unit.is_some() && !name.contains(',');
    let digits = |row: &&str| row.trim().split_once(',').map_or(0, |(_, digits)| digits.len());
    above.last().is_some_and(is_name)
        && rows.iter().all(|row| row.matches(',').count() < 2)
        && rows.iter().map(digits).any(|digits| digits > 1)
}

/// Returns `true` for digits and single commas between them, as in `0,5,1,2`: no blank, point, sign after a comma or quote shows the meaning of a
/// comma.
fn of_whole_numbers(row: &str) -> bool {
    let row = row.trim();
    let digits = |cell: &str| !cell.is_empty() && cell.bytes().all(|byte| byte.is_ascii_digit());
    let cells: Vec<&str> = row.split(',').collect();
    let first = cells[0].trim_start_matches('-');
    let may_be_whole = |index: usize| index.is_multiple_of(2);
    cells.len() > 1
        && digits(first)
        && cells.iter().enumerate().skip(1).all(|(index, cell)| {
            digits(cell) || may_be_whole(index) && cell.strip_prefix('-').is_some_and(digits)
        })
}

fn commas_between_digits(sheet: &Sheet) -> MeasurementError {
    let line = sheet.lines[0];
    MeasurementError::Undecided {
        question: format!(
            "from line {line} on, commas stand between whole numbers or are decimal commas: no header decides"
        ),
        choices: vec![Suggestion::new(Choice::Decimal, "point"), Suggestion::new(Choice::Decimal, "comma")],
    }
}

/// A number, if every comma has just three digits after it and one to three before it that do not begin with zero.
fn only_thousands(rows: &[&str], delimiter: Delimiter) -> Option<String> {
    let dialect = Dialect::new(delimiter, DecimalMark::Comma);
    let (mut first, text) = (None, rows.join("\n"));
    for row in dialect.rows(&text) {
        for cell in row.cells.iter().filter(|cell| cell.contains(',')) {
            if !may_be_thousands(cell) {
                return None;
            }
            first.get_or_insert_with(|| cell.to_owned());
        }
    }
    first
}

/// Returns `true` if exactly three digits follow a comma, and one to three precede it that do not begin with zero.
pub(super) fn may_be_thousands(cell: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    cell.trim().trim_start_matches(['-', '+', '−']).split_once(',').is_some_and(|(whole, fraction)| {
        digits(whole)
            && digits(fraction)
            && fraction.len() == 3
            && whole.len() <= 3
            && !whole.starts_with('0')
    })
}

/// The text of a workbook; refused if its only commas may be marks of thousands, unless the decimal mark is given.
pub(super) fn of_cells<'a>(text: &'a str, options: &ReadOptions) -> Result<Cow<'a, str>, MeasurementError> {
    let ambiguous = text.split(['\t', '\n']).find(|cell| may_be_thousands(cell));
    match (ambiguous, options.decimal) {
        (None, _) | (_, Some(DecimalMark::Point)) => Ok(text.into()),
        (Some(number), None) => Err(thousands(number.trim())),
        (Some(_), Some(DecimalMark::Comma)) => {
            let in_cell =
                |cell: &str| if may_be_thousands(cell) { cell.replace(',', ".") } else { cell.to_owned() };
            let in_line = |line: &str| line.split('\t').map(in_cell).collect::<Vec<_>>().join("\t");
            Ok(text.split('\n').map(in_line).collect::<Vec<_>>().join("\n").into())
        }
    }
}

fn thousands(number: &str) -> MeasurementError {
    MeasurementError::Undecided {
        question: format!(
            "the comma in `{number}` may be a decimal comma or a mark of thousands, which are not read"
        ),
        choices: vec![Suggestion::new(Choice::Decimal, "comma")],
    }
}
