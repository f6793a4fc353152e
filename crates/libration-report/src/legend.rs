//! The legend of a panel, in rows above the axes, where it takes no width and hides no data.

use crate::chart::{Mark, Panel, Series};
use crate::letters::{LINE, width, wrapped};
use crate::marks;
use crate::scene::{Anchor, Form, Place, Shape, ShapeRole, Text};
use crate::style::INK;

/// Length of a sample, enough to show the dashes.
const SAMPLE: f64 = 2.6;
const MARKER_SAMPLE: f64 = 1.0;
/// Gap between a sample and its name.
const GAP: f64 = 0.4;
/// Gap between an entry and the next one.
const APART: f64 = 1.2;

/// The layout of a panel's legend, in units of the letter size.
#[derive(Clone, Debug)]
pub(crate) struct Legend {
    entries: Vec<Entry>,
    /// Height from the top of the first row to the end of the last.
    pub(crate) height: f64,
}

#[derive(Clone, Debug)]
struct Entry {
    series: usize,
    left: f64,
    top: f64,
    sample: f64,
    lines: Vec<String>,
}

impl Legend {
    /// The legend in rows of at most this width.
    pub(crate) fn new(panel: &Panel, across: f64) -> Self {
        let named = panel.series.iter().enumerate().filter(|(_, series)| !series.label.is_empty());
        let named: Vec<(usize, f64, f64)> =
            named.map(|(number, series)| (number, sample(series), width(&series.label, 1.0))).collect();
        let whole = |&(_, sample, name): &(usize, f64, f64)| sample + GAP + name + APART;
        let in_one_row = named.iter().map(whole).sum::<f64>() - APART <= across;
        let widest = named.iter().map(whole).fold(0.0, f64::max);
        let columns = ((across + APART) / widest).floor().max(1.0);
        let column = (across + APART) / columns;
        let mut legend = Self { entries: vec![], height: 0.0 };
        let (mut left, mut top, mut row) = (0.0, 0.0, 0.0);
        for entry in &named {
            let advance = if in_one_row { whole(entry) } else { column };
            // The last entry of a row may fill it exactly, but for rounding.
            if left + advance - APART > across + 1e-9 {
                (left, top) = (0.0, top + row);
                row = 0.0;
            }
            let (series, sample, _) = *entry;
            let lines = wrapped(&panel.series[series].label, 1.0, across - sample - GAP);
            row = f64::max(row, lines.iter().map(|_| LINE).sum::<f64>() + 0.1);
            legend.entries.push(Entry { series, left, top, sample, lines });
            left += advance;
        }
        legend.height = top + row;
        legend
    }

    /// The samples and names, for this upper left corner and this letter size.
    pub(crate) fn shapes(&self, panel: &Panel, (left, top): Place, em: f64) -> Vec<Shape> {
        let entry = |entry: &Entry| {
            let (left, top) = (left + entry.left * em, top + entry.top * em);
            let middle = top + 0.5 * LINE * em;
            let sample = marks::sample(&panel.series[entry.series], (left, middle), entry.sample * em, em);
            let names = (0_u32..).zip(&entry.lines).map(move |(line, words)| {
                let base = top + (0.5 * LINE + 0.36 + LINE * f64::from(line)) * em;
                name(words, (left + (entry.sample + GAP) * em, base), em)
            });
            sample.into_iter().chain(names).collect::<Vec<Shape>>()
        };
        self.entries.iter().flat_map(entry).collect()
    }
}

fn sample(series: &Series) -> f64 {
    match series.look.mark {
        Mark::Line(_) | Mark::Band => SAMPLE,
        Mark::Markers(_) => MARKER_SAMPLE,
    }
}

fn name(words: &str, at: Place, em: f64) -> Shape {
    let text = Text { content: words.to_owned(), at, anchor: Anchor::Start, size: em, is_turned: false };
    Shape { role: ShapeRole::Name, form: Form::Text(text), colour: INK, opacity: 1.0 }
}
