//! A table of many amplitudes: one row each, with the errors of the formulas requested.

use super::fields::{self, DIGITS, Estimate, SMALL_ANGLE_PERIOD, Swing};
use super::{Period, estimates};
use crate::arguments::{Amplitudes, PendulumOptions};
use crate::figure::chart::{Picture, Point};
use crate::figure::{parameters, swing_periods};
use crate::output::json::{self, Record};
use crate::output::progress::{ProgressLine, counted};
use crate::output::table::{self, Column, Table};
use crate::output::{csv, number};
use crate::parallel;
use libration::pendulum::{Amplitude, Pendulum};
use libration::period_formulas::{PeriodFormula, fractional_errors};
use std::io::{self, Write};

/// The result for many amplitudes.
pub(super) struct SwingsTable<'a> {
    pub(super) question: &'a Period,
    pub(super) amplitudes: &'a Amplitudes,
    pub(super) pendulum: &'a Pendulum,
}

/// Number of amplitudes that one core computes at a time: with every formula in half a second at worst, next to zero. With 128 a fifth of the
/// time went into handing over.
const PIECE: usize = 512;

impl SwingsTable<'_> {
    pub(super) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let Self { question, amplitudes, pendulum } = *self;
        let period = (SMALL_ANGLE_PERIOD, number::seconds(pendulum.small_angle_period(), DIGITS));
        table::sheet(out, &[question.pendulum.lines(), vec![period]].concat())?;
        writeln!(out)?;
        let formulas = question.formulas.chosen();
        let exact = fields::of_swing(self.question.amplitudes.are_of_periods());
        let errors = formulas.iter().map(|formula| Column::numbers(format!("error of {}", formula.key())));
        let mut table = Table::new(exact.columns().into_iter().chain(errors).collect());
        for given in counted(amplitudes.iter(), amplitudes.len(), "amplitudes") {
            let errors = fractional_errors(formulas, &[given.0.angle()]);
            let errors = errors.into_iter().map(|error| number::rounded(error, 3));
            let swing = Swing::new(given, pendulum);
            table.row(out, exact.cells(&swing).into_iter().chain(errors).collect())?;
        }
        table.finish(out)
    }

    pub(super) fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let formulas = self.question.formulas.chosen_or_all();
        let (exact, of_formula) =
            (fields::of_swing(self.question.amplitudes.are_of_periods()), fields::of_formula());
        let more = formulas.iter().flat_map(|formula| of_formula.csv_names_for(formula.key()));
        csv::line(out, &exact.csv_names().into_iter().chain(more).collect::<Vec<_>>())?;
        let row = |text: &mut Vec<u8>, swing: &Swing, estimates: Vec<_>| {
            exact.write_csv_cells(text, swing);
            for estimate in estimates {
                text.push(b',');
                of_formula.write_csv_cells(text, &estimate);
            }
        };
        self.in_pieces(formulas, b"\n", row, |text| {
            out.write_all(text)?;
            out.write_all(b"\n")
        })
    }

    pub(super) fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        let question = self.question;
        let formulas = question.formulas.chosen_or_all();
        let (of_swing, of_formula) =
            (fields::of_swing(self.question.amplitudes.are_of_periods()), fields::of_formula());
        let item = |text: &mut Vec<u8>, swing: &Swing, estimates: Vec<_>| {
            let estimates = question.sorted(estimates);
            let record = of_swing.record(swing).with("formulas", of_formula.records(&estimates));
            json::write_item(text, record);
        };
        json::begin_document(out, question.pendulum.record())?;
        let mut list = json::ListWriter::default();
        list.begin(out, "results")?;
        self.in_pieces(formulas, json::BETWEEN_ITEMS, item, |text| list.items(out, text))?;
        list.end(out)?;
        json::end_document(out, Record::new())
    }

    /// Passes on the texts of the amplitudes, several at a time with a separator, in their order.
    fn in_pieces<'a>(
        &self,
        formulas: &'a [PeriodFormula],
        between: &[u8],
        write: impl Fn(&mut Vec<u8>, &Swing, Vec<Estimate<'a>>) + Sync,
        mut hand_on: impl FnMut(&[u8]) -> io::Result<()>,
    ) -> io::Result<()> {
        let Self { amplitudes, pendulum, .. } = *self;
        let all = amplitudes.len();
        let texts = |piece: usize| {
            let indices = piece * PIECE..all.min((piece + 1) * PIECE);
            let amplitudes_of_piece: Vec<(Amplitude, Option<f64>)> =
                indices.filter_map(|index| amplitudes.get(index)).collect();
            let swings = Swing::all(&amplitudes_of_piece, pendulum);
            let estimates = estimates(&swings, formulas);
            swings.iter().zip(estimates).fold(vec![], |mut text, (swing, estimates)| {
                text.extend_from_slice(if text.is_empty() { b"" } else { between });
                write(&mut text, swing, estimates);
                text
            })
        };
        let mut progress = ProgressLine::new();
        parallel::in_order(all.div_ceil(PIECE), texts, |piece, text| {
            progress.show(|| format!("{} of {all} amplitudes", piece * PIECE));
            hand_on(&text)
        })
    }
}

/// The exact period against the amplitude.
pub(super) fn picture(amplitudes: &Amplitudes, pendulum: &Pendulum, options: PendulumOptions) -> Picture {
    let given: Vec<_> = amplitudes.iter().collect();
    let point = |swing: &Swing| Point {
        x_uncertainty: swing.uncertainty.map(f64::to_degrees),
        ..Point::new(swing.amplitude.angle().degrees(), swing.exact.period)
    };
    let points = Swing::all(&given, pendulum).iter().map(point).collect();
    swing_periods::swing_periods(pendulum, points)
        .with_parameters(parameters::of_pendulum(options.length(), options.gravity()))
}
