//! Styles of cells that show numbers as dates or times of day.

use std::collections::BTreeSet;

/// The number formats in the styles of a workbook, in order; `true` for those of dates.
#[derive(Clone, Debug, Default)]
pub(super) struct DateFormats {
    styles: Vec<u16>,
    dates: BTreeSet<u16>,
}

impl DateFormats {
    /// A format with its number, as the file writes it: `dd.mm.yyyy`.
    pub(super) fn add_format(&mut self, number: u16, format: &str) {
        if shows_date(format) {
            self.dates.insert(number);
        }
    }

    /// The next style, with the number of its format.
    pub(super) fn add_style(&mut self, format: u16) {
        self.styles.push(format);
    }

    /// Returns `true` if cells of this style show dates or times of day.
    pub(super) fn is_date(&self, style: u16) -> bool {
        let format = self.styles.get(usize::from(style)).copied().unwrap_or(0);
        // The formats that need not be written in the file.
        matches!(format, 14..=22 | 27..=36 | 45..=47 | 50..=58) || self.dates.contains(&format)
    }
}

/// A letter of years, months, days, hours or seconds outside quotes, colours and escapes.
pub fn shows_date(format: &str) -> bool {
    let mut letters = format.chars();
    while let Some(letter) = letters.next() {
        match letter {
            '"' => {
                let _ = letters.by_ref().find(|&end| end == '"');
            }
            '[' => {
                let inside: String = letters.by_ref().take_while(|&end| end != ']').collect();
                if ["h", "hh", "m", "mm", "s", "ss"].contains(&inside.to_lowercase().as_str()) {
                    return true;
                }
            }
            '\\' | '_' | '*' => {
                let _ = letters.next();
            }
            _ if "ymdhsYMDHS".contains(letter) => return true,
            _ => {}
        }
    }
    false
}
