//! Damage to text files in transit, applied to the table in every style.

use super::Case;
use super::style::{ROWS, STYLES, Style};

/// The row that is damaged.
const ROW: usize = 11;

/// A table in one style and the damage applied to it.
struct Workbench {
    style: Style,
    cases: Vec<Case>,
}

pub(crate) fn cases() -> Vec<Case> {
    let mut all = Vec::new();
    for style in STYLES {
        let mut bench = Workbench { style, cases: Vec::new() };
        bench.cells();
        bench.rows();
        bench.order();
        bench.headers();
        bench.blanks();
        bench.bytes();
        all.append(&mut bench.cases);
    }
    all
}

impl Workbench {
    fn line(&self) -> String {
        format!("line {}", self.style.line_of(ROW))
    }

    fn name(&self, what: &str) -> String {
        format!("{}: {what}", self.style.name)
    }

    fn refuse(&mut self, what: &str, text: impl Into<Vec<u8>>, words: &[&str]) {
        self.cases.push(Case::refused(self.name(what), text, words));
    }

    fn read(&mut self, what: &str, text: impl Into<Vec<u8>>, rows: Vec<(f64, f64)>) {
        self.cases.push(Case::read(self.name(what), text, rows));
    }

    /// The file with this text in the damaged row.
    fn with_cell(&self, column: usize, cell: &str) -> String {
        let mut rows = self.style.rows();
        rows[ROW][column] = if self.style.quoted { format!("\"{cell}\"") } else { cell.to_owned() };
        self.style.file(&self.style.header(), &rows)
    }

    fn with_rows(&self, change: impl FnOnce(&mut Vec<Vec<String>>)) -> String {
        let mut rows = self.style.rows();
        change(&mut rows);
        self.style.file(&self.style.header(), &rows)
    }

    fn truth_without(&self, left_out: &[usize]) -> Vec<(f64, f64)> {
        let rows = self.style.truth().into_iter().enumerate();
        rows.filter(|(row, _)| !left_out.contains(row)).map(|(_, row)| row).collect()
    }

    /// Cells that are not numbers.
    fn cells(&mut self) {
        let other_mark = if self.style.decimal_comma { "60.55" } else { "60,55" };
        let thousands = if self.style.decimal_comma { "1.060,55" } else { "1,060.55" };
        for (what, column, cell) in [
            ("a letter O for a zero", 1, "O"),
            ("a unit behind the number", 1, "0rad"),
            ("words", 1, "lost"),
            ("infinity", 1, "inf"),
            ("beyond all numbers", 1, "1e999"),
            ("two signs", 1, "--1"),
            ("hexadecimal", 0, "0x3C"),
            ("a time of day", 0, "00:01:00"),
            ("a date", 0, "2024-03-01"),
            ("the other decimal mark", 0, other_mark),
        ] {
            let (text, line) = (self.with_cell(column, cell), self.line());
            self.refuse(what, text, &[&line]);
        }
        for (what, column, cell) in [
            ("an error of a spreadsheet", 1, "#DIV/0!"),
            ("a mark of thousands", 0, thousands),
            ("an apostrophe for thousands", 0, "1'060"),
        ] {
            let (text, truth, line) = (self.with_cell(column, cell), self.truth_without(&[ROW]), self.line());
            match self.style.delimiter == "," && !self.style.quoted && cell.contains(',') {
                true => self.refuse(what, text, &[&line]),
                false => self.read(what, text, truth),
            }
        }
    }

    /// Rows with too few and too many cells, and other text between the rows.
    fn rows(&mut self) {
        let line = self.line();
        let short = self.with_rows(|rows| rows[ROW].truncate(1));
        self.refuse("a cell is missing", short, &[&line]);
        let long = self.with_rows(|rows| {
            let cell = rows[ROW][1].clone();
            rows[ROW].push(cell);
        });
        self.refuse("a cell too many", long, &[&line]);
        let cut = self.with_rows(|rows| {
            rows.truncate(ROW + 1);
            rows[ROW].truncate(1);
        });
        self.refuse("cut off in a row", cut.trim_end(), &[&line]);
        let header = self.style.header();
        let again = self.with_rows(|rows| rows.insert(ROW, vec![header]));
        self.read("the header again", again, self.style.truth());
        let remark = self.with_rows(|rows| rows.insert(ROW, vec!["here the door was opened".into()]));
        self.refuse("a remark between the rows", remark, &[&line]);
        let other = if self.style.delimiter == ";" { "|" } else { ";" };
        let swapped = self.with_rows(|rows| rows[ROW] = vec![rows[ROW].join(other)]);
        self.refuse("another delimiter in one row", swapped, &[&line]);
    }

    /// Rows out of order.
    fn order(&mut self) {
        let swapped = self.with_rows(|rows| rows.swap(ROW - 1, ROW));
        self.read("two rows exchanged", swapped, self.style.truth());
        let reversed = self.with_rows(|rows| rows.reverse());
        self.refuse("time runs back", reversed, &["time"]);
        let mixed = self.with_rows(|rows| (0..ROWS / 2).for_each(|pair| rows.swap(2 * pair, 2 * pair + 1)));
        self.refuse(
            "every pair of rows exchanged",
            mixed,
            &["time", &format!("line {}", self.style.line_of(1))],
        );
        let late = self.style.cell(900.0);
        let strange = self.with_rows(|rows| rows[ROW][0] = late);
        self.read("a time that belongs nowhere", strange, self.truth_without(&[ROW]));
        let twice = self.with_rows(|rows| rows.extend(rows.clone()));
        self.read("the same run twice", twice, self.style.truth());
        let doubled = self.with_rows(|rows| rows.insert(ROW, rows[ROW - 1].clone()));
        self.read("a row twice", doubled, self.style.truth());
    }

    /// Headers that do not describe the columns below them.
    fn headers(&mut self) {
        let (style, rows) = (self.style, self.style.rows());
        let with = |names: &[&str]| style.file(&names.join(style.delimiter), &rows);
        let [time, angle] = style.header;
        let first_line = format!("line {}", style.line_of(0) - 1);
        let has_header_words = !time.contains('"');
        self.refuse("no header", style.file("", &rows), &["not clear", "angle-unit=rad"]);
        match style.degrees {
            // No pendulum swings to and fro by several turns.
            true => self.read("no units", with(&["t", "theta"]), style.truth()),
            false => self.refuse("no units", with(&["t", "theta"]), &["not given", "angle-unit=rad"]),
        }
        self.refuse("an unknown unit", with(&["t/s", "theta/furlong"]), &["furlong"]);
        self.refuse(
            "an unknown unit of time",
            with(&["t/jiffies", "theta/rad"]),
            &["jiffies", "time-unit=s"],
        );
        self.refuse("units exchanged", with(&["t/rad", "theta/s"]), &["angle=2"]);
        self.refuse("two columns of time", with(&["t/s", "time/s"]), &["times", "time=1"]);
        self.refuse("names with numbers", with(&["1", "2"]), &[]);
        match style.is_spaced() {
            true => self.refuse("too many names", with(&[time, angle, "of", "it"]), &[&first_line]),
            false => self.read("too many names", with(&[time, angle, "height"]), style.truth()),
        }
        if has_header_words {
            let three: Vec<Vec<String>> =
                rows.iter().map(|row| [row.clone(), vec![row[1].clone()]].concat()).collect();
            let twice = style.file(&[time, angle, angle].join(style.delimiter), &three);
            self.refuse("two columns of angles", twice, &["angles", "angle=2"]);
            let unnamed = style.file(&style.header(), &three);
            self.refuse("a column without a name", unnamed, &[&first_line]);
        }
    }

    /// Missing values, and the texts that may stand in their place.
    fn blanks(&mut self) {
        for (what, cell) in [("not a number", "NaN"), ("a dash", "-"), ("not available", "n/a")] {
            let (text, truth) = (self.with_cell(1, cell), self.truth_without(&[ROW]));
            self.read(what, text, truth);
        }
        let (empty, truth) = (self.with_cell(1, ""), self.truth_without(&[ROW]));
        match self.style.is_spaced() {
            true => self.refuse("a blank", empty, &[&self.line()]),
            false => self.read("a blank", empty, truth),
        }
        let spaced = self.with_rows(|rows| rows.insert(ROW, vec![String::new()]));
        self.read("an empty line", spaced, self.style.truth());
        let remark = self.with_rows(|rows| rows.insert(ROW, vec!["# the door was opened".into()]));
        self.read("a comment", remark, self.style.truth());
        if !self.style.is_spaced() {
            let trailing = self.with_rows(|rows| rows.iter_mut().for_each(|row| row.push(String::new())));
            let header = self.style.header();
            let trailing = trailing.replacen(&header, &format!("{header}{}", self.style.delimiter), 1);
            self.read("a delimiter at the end", trailing, self.style.truth());
        }
    }

    /// Line ends and encodings.
    fn bytes(&mut self) {
        let whole = self.style.file(&self.style.header(), &self.style.rows());
        let truth = self.style.truth();
        let unix = whole.replace("\r\n", "\n");
        self.read("carriage returns", unix.replace('\n', "\r"), truth.clone());
        self.read("Windows line ends", unix.replace('\n', "\r\n"), truth.clone());
        self.read("no end of the last line", unix.trim_end(), truth.clone());
        let plain = unix.trim_start_matches('\u{feff}');
        let little: Vec<u8> = format!("\u{feff}{plain}").encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = format!("\u{feff}{plain}").encode_utf16().flat_map(u16::to_be_bytes).collect();
        self.refuse("half a letter of UTF-16", &little[..little.len() - 1], &["UTF-16"]);
        self.read("UTF-16, little end first", little, truth.clone());
        self.read("UTF-16, big end first", big, truth);
        self.refuse("a byte of zeros", plain.replacen("60", "6\0", 1), &["NUL"]);
        let mut broken = self.with_cell(1, "?").into_bytes();
        let at = broken.iter().rposition(|&byte| byte == b'?').unwrap();
        broken[at] = 0xff;
        self.refuse("a byte of no letter", broken, &[]);
    }
}
