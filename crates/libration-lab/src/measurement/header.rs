//! The lines above the numbers of a text → the names, units and titles of its columns.

use super::dialect::{Delimiter, Dialect, TextRow};
use super::heading::{Heading, bare, name_minima, name_uncertainties};
use super::options::Header;
use super::text::COMMENT;
use super::{MeasurementError, QuantityKind, Unit};

/// Contents of the lines above the numbers.
pub(super) struct Names {
    pub(super) headings: Vec<Heading>,
    pub(super) line: Option<u64>,
    pub(super) preamble: Vec<(u64, String)>,
    /// Names beyond the last column.
    pub(super) beyond: Vec<String>,
}

impl Names {
    pub(super) fn read(
        text: &str,
        mut above: Vec<TextRow>,
        width: usize,
        dialect: Dialect,
        header: Header,
        first_line: u64,
    ) -> Result<Self, MeasurementError> {
        let units = units_below(&mut above);
        let names = match above.pop() {
            Some(row) if header == Header::Detect && row.filled() == 1 && width > 1 => {
                above.push(row);
                None
            }
            Some(row) => Some(row),
            None => in_comment(text, width, dialect, first_line),
        };
        let short_names = units.is_some()
            && names.is_some()
            && above.last().is_some_and(|row| {
                Some(row.filled()) == names.as_ref().map(TextRow::filled) && row.filled() > 1
            });
        let names = if short_names { above.pop() } else { names };
        let (cells, beyond) = match &names {
            Some(row) => name_cells(row, text, dialect, width)?,
            None => (vec![String::new(); width], Vec::new()),
        };
        let cells = merged(cells, &mut above);
        let groups = groups(&cells, &mut above);
        let heading = |(index, name): (usize, &String)| {
            Heading::read(
                name,
                units.as_ref().and_then(|row| row.cells.get(index)),
                groups.get(index).map(String::as_str),
            )
        };
        let mut headings: Vec<Heading> = cells.iter().enumerate().map(heading).collect();
        name_minima(&mut headings);
        name_uncertainties(&mut headings);
        number_runs(&mut headings);
        let preamble =
            above.iter().map(|row| (row.line, row.cells.iter().collect::<Vec<_>>().join(" "))).collect();
        Ok(Self { headings, line: names.map(|row| row.line), preamble, beyond })
    }
}

/// A last line of units only, with a line of the same length above it.
fn units_below(above: &mut Vec<TextRow>) -> Option<TextRow> {
    let [.., names, units] = &above[..] else { return None };
    let is_known_unit = |cell: &str| bare(cell).parse::<Unit>().is_ok();
    let is_unit = |cell: &str| cell.is_empty() || is_known_unit(cell) || cell.starts_with(['(', '[']);
    let are_units = units.cells.iter().any(is_known_unit) && units.cells.iter().all(is_unit);
    if are_units && names.filled() >= units.filled() { above.pop() } else { None }
}

/// The last comment above the numbers, if it contains known names in the right number of cells.
fn in_comment(text: &str, width: usize, dialect: Dialect, first_line: u64) -> Option<TextRow> {
    let lines = (1..first_line).zip(text.lines()).filter(|(_, line)| line.trim_start().starts_with(COMMENT));
    let (line, comment) = lines.last()?;
    let row = dialect.rows(comment.trim_start().trim_start_matches(COMMENT)).next()?;
    let row = TextRow { line, ..row };
    let (cells, beyond) = name_cells(&row, comment, dialect, width).ok()?;
    let knows = |cell: &String| Heading::read(cell, None, None).quantity != QuantityKind::Other;
    (cells.len() == width && beyond.is_empty() && row.filled() == width && cells.iter().any(knows))
        .then_some(row)
}

/// Names of the columns, and the names beyond the last column. Words separated by blanks are joined at brackets and strokes, or across single
/// blanks; other names beyond the last column have no numbers below them.
fn name_cells(
    row: &TextRow,
    text: &str,
    dialect: Dialect,
    width: usize,
) -> Result<(Vec<String>, Vec<String>), MeasurementError> {
    let mut cells: Vec<String> = row.cells.iter().map(String::from).collect();
    if row.filled() > width {
        cells = joined(&cells);
    }
    let filled =
        |cells: &[String]| cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1);
    let is_torn = dialect.delimiter == Delimiter::Whitespace;
    if is_torn && filled(&cells) > width {
        cells = between_wide_blanks(row, text).filter(|names| names.len() == width).unwrap_or(cells);
    }
    let names = filled(&cells);
    if cells.len() < width || names > width && (is_torn || cells[..width].iter().any(String::is_empty)) {
        return Err(MeasurementError::HeaderWidth { line: row.line, names, columns: width });
    }
    cells.truncate(names.max(width));
    let beyond = cells.split_off(width);
    Ok((cells, beyond))
}

/// `elapsed time (s)   swing angle (deg)`: names with tabs, or two blanks or more, between them.
pub(super) fn between_wide_blanks(row: &TextRow, text: &str) -> Option<Vec<String>> {
    let line = text.lines().nth(usize::try_from(row.line).ok()?.checked_sub(1)?)?;
    let spaced = line.replace('\t', "  ");
    Some(spaced.split("  ").map(str::trim).filter(|name| !name.is_empty()).map(String::from).collect())
}

/// Numbers the runs: `t_1, θ_1, t_2, θ_2` are two runs, since each has separate times; `t, θ_1, θ_2` are not.
fn number_runs(headings: &mut [Heading]) {
    let of_times = |heading: &Heading| heading.index.clone().filter(|_| heading.is(QuantityKind::Time));
    let times: Vec<String> = headings.iter().filter_map(of_times).collect();
    if times.len() < 2 {
        return;
    }
    for heading in headings.iter_mut().filter(|heading| heading.run.is_none()) {
        heading.run =
            heading.index.as_ref().filter(|index| times.contains(index)).map(|index| format!("run {index}"));
    }
}

fn joined(cells: &[String]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for cell in cells {
        match names.last_mut() {
            Some(name) if cell.starts_with(['(', '[', '/']) || name.ends_with('/') => {
                name.push(' ');
                name.push_str(cell);
            }
            _ => names.push(cell.clone()),
        }
    }
    names
}

/// `Length (cm),Period (s),,` over `,Trial 1,Trial 2,Trial 3`: cells of a worksheet that were merged, some over both rows, others over several columns.
fn merged(names: Vec<String>, above: &mut Vec<TextRow>) -> Vec<String> {
    let titles: Vec<String> =
        above.last().map(|row| row.cells.iter().map(String::from).collect()).unwrap_or_default();
    let title = |index: usize| titles.get(index).map_or("", String::as_str).trim();
    let is_over_both = |index: usize| names[index].is_empty() && !title(index).is_empty();
    let has_unit = |index: usize| Heading::read(title(index), None, None).unit.is_some();
    // `,Trial,,` over `L (m),1,2,3`
    let is_number = |index: usize| !title(index).is_empty() && names[index].parse::<u32>().is_ok();
    let is_any = |of: &dyn Fn(usize) -> bool| (0..names.len()).any(of);
    let is_merged = is_any(&is_over_both) && is_any(&has_unit) || is_any(&is_number);
    if !is_merged || titles.len() > names.len() {
        return names;
    }
    above.pop();
    let mut current = "";
    let combined = |(index, name): (usize, &String)| {
        if !title(index).is_empty() {
            current = title(index);
        }
        if name.is_empty() {
            return std::mem::take(&mut current).into();
        }
        Heading::under_title(name, current)
    };
    names.iter().enumerate().map(combined).collect()
}

/// Titles over groups of columns, as Tracker writes them when it exports several tracks at once.
fn groups(names: &[String], above: &mut Vec<TextRow>) -> Vec<String> {
    let repeats = |name: &String| !name.is_empty() && names.iter().filter(|other| *other == name).count() > 1;
    let has_titles = above.last().is_some_and(|row| row.filled() > 1 && row.filled() <= names.len());
    if !names.iter().any(repeats) || !has_titles {
        return Vec::new();
    }
    let titles = above.pop().map(|row| row.cells).unwrap_or_default();
    let mut current = String::new();
    (0..names.len())
        .map(|index| {
            if let Some(title) = titles.get(index).filter(|title| !title.is_empty()) {
                current = title.into();
            }
            current.clone()
        })
        .collect()
}
