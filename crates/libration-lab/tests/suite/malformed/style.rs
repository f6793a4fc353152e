//! One table of a swing as several instruments would write it.

use super::Case;

/// Style in which a table is written.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    pub(crate) name: &'static str,
    pub(crate) delimiter: &'static str,
    pub(crate) decimal_comma: bool,
    /// `true` for quotes around every cell.
    pub(crate) quoted: bool,
    /// Text above the header, line ends included.
    pub(crate) before: &'static str,
    pub(crate) header: [&'static str; 2],
    pub(crate) line_end: &'static str,
    pub(crate) degrees: bool,
}

const PLAIN: Style = Style {
    name: "comma",
    delimiter: ",",
    decimal_comma: false,
    quoted: false,
    before: "",
    header: ["Time (s)", "Angle (rad)"],
    line_end: "\n",
    degrees: false,
};

pub(crate) const STYLES: [Style; 13] = [
    PLAIN,
    Style {
        name: "quoted header in degrees",
        header: ["\"Time (s)\"", "\"Angle (deg)\""],
        degrees: true,
        ..PLAIN
    },
    Style { name: "semicolon", delimiter: ";", header: ["t [s]", "θ / rad"], ..PLAIN },
    Style {
        name: "semicolon, decimal comma",
        delimiter: ";",
        decimal_comma: true,
        header: ["t/s", "Winkel/rad"],
        ..PLAIN
    },
    Style {
        name: "byte order mark",
        delimiter: ";",
        decimal_comma: true,
        before: "\u{feff}",
        line_end: "\r\n",
        ..PLAIN
    },
    Style { name: "tab", delimiter: "\t", header: ["Latest: Time (s)", "Latest: Angle (rad)"], ..PLAIN },
    Style {
        name: "tab, decimal comma",
        delimiter: "\t",
        decimal_comma: true,
        degrees: true,
        header: ["t / s", "θ / °"],
        ..PLAIN
    },
    Style {
        name: "Tracker",
        delimiter: "\t",
        before: "mass_A\r\n",
        line_end: "\r\n",
        header: ["t (s)", "θ (deg)"],
        degrees: true,
        ..PLAIN
    },
    Style { name: "space", delimiter: " ", header: ["t/s", "theta/rad"], ..PLAIN },
    Style { name: "numbered symbols", delimiter: ";", header: ["t1", "theta1 (rad)"], ..PLAIN },
    Style {
        name: "LaTeX",
        delimiter: "\t",
        header: ["$t_{1}$ (s)", "$\\theta_{1}$ (deg)"],
        degrees: true,
        ..PLAIN
    },
    Style {
        name: "names of several words between wide blanks",
        delimiter: "   ",
        header: ["elapsed time (s)", "angular position (rad)"],
        ..PLAIN
    },
    Style { name: "comma, quoted decimal commas", decimal_comma: true, quoted: true, ..PLAIN },
];

/// Number of rows.
pub(crate) const ROWS: usize = 40;

impl Style {
    /// Returns `true` if only blanks stand between cells, so that no cell can be empty.
    pub(crate) fn is_spaced(&self) -> bool {
        self.delimiter.chars().all(|letter| letter == ' ')
    }

    /// A number with four decimals, as the style writes it.
    pub(crate) fn cell(&self, number: f64) -> String {
        let text = format!("{number:.4}");
        let text = if self.decimal_comma { text.replace('.', ",") } else { text };
        if self.quoted { format!("\"{text}\"") } else { text }
    }

    /// The rows of a swing from 0.4 rad, a minute after the clock was started.
    pub(crate) fn rows(&self) -> Vec<Vec<String>> {
        self.numbers().into_iter().map(|(time, angle)| vec![self.cell(time), self.cell(angle)]).collect()
    }

    fn numbers(&self) -> Vec<(f64, f64)> {
        let row = |row: usize| {
            let time = 0.05 * f64::from(u16::try_from(row).unwrap());
            let angle = 0.4 * libm::cos(4.43 * time);
            (60.0 + time, if self.degrees { angle.to_degrees() } else { angle })
        };
        (0..ROWS).map(row).collect()
    }

    /// Expected rows: the decimals as they are written, degrees in radians.
    pub(crate) fn truth(&self) -> Vec<(f64, f64)> {
        let written = |number: f64| format!("{number:.4}").parse::<f64>().unwrap();
        let radians = |angle: f64| if self.degrees { degrees_of_command_line(angle) } else { angle };
        self.numbers().into_iter().map(|(time, angle)| (written(time), radians(written(angle)))).collect()
    }

    pub(crate) fn header(&self) -> String {
        self.header.join(self.delimiter)
    }

    /// The file of a header and rows.
    pub(crate) fn file(&self, header: &str, rows: &[Vec<String>]) -> String {
        let lines = rows.iter().map(|row| row.join(self.delimiter));
        let lines: Vec<String> =
            [header.to_owned()].into_iter().filter(|line| !line.is_empty()).chain(lines).collect();
        self.text(&lines)
    }

    pub(crate) fn text(&self, lines: &[String]) -> String {
        let lines: String = lines.iter().flat_map(|line| [line, self.line_end]).collect();
        format!("{}{lines}", self.before)
    }

    /// The line of a row, both counted as people do and as the file does.
    pub(crate) fn line_of(&self, row: usize) -> usize {
        self.before.matches('\n').count() + 2 + row
    }
}

/// The table in every style, undamaged.
pub(crate) fn whole_files() -> Vec<Case> {
    let whole =
        |style: &Style| Case::read(style.name, style.file(&style.header(), &style.rows()), style.truth());
    STYLES.iter().map(whole).collect()
}

/// The angle in radians that the command line reads from a number of degrees.
fn degrees_of_command_line(angle: f64) -> f64 {
    format!("{angle}deg").parse::<libration::quantity::Angle>().unwrap().radians()
}
