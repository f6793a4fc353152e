//! A sheet for each formula: the formula, its derivation and source, its error at some amplitudes, the amplitudes up to which it holds.

use super::entry::Entry;
use crate::output::field::{Field, Fields};
use crate::output::number;
use crate::output::table::{Table, sheet};
use libration::period_formulas::{ABBREVIATIONS, PeriodFormula, fractional_errors};
use libration::quantity::Angle;
use std::io::{self, Write};

/// The amplitudes of the error curve, in degrees.
const AMPLITUDES: [f64; 13] =
    [5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0, 120.0, 135.0, 150.0, 170.0];
/// The tolerances whose ranges are shown.
const TOLERANCES: [f64; 4] = [0.01, 1e-3, 1e-4, 1e-6];

/// A point of the error curve of a formula.
struct ErrorCurvePoint {
    amplitude: Angle,
    ratio: f64,
    error: f64,
}

/// The range of amplitudes in which a formula keeps a tolerance from the smallest on.
struct Range {
    tolerance: f64,
    to: f64,
}

fn points(formula: &PeriodFormula) -> Vec<ErrorCurvePoint> {
    let amplitudes: Vec<Angle> =
        AMPLITUDES.iter().filter_map(|degrees| Angle::from_degrees(*degrees).ok()).collect();
    let errors = fractional_errors(std::slice::from_ref(formula), &amplitudes);
    let point = |(amplitude, error): (&Angle, f64)| ErrorCurvePoint {
        amplitude: *amplitude,
        ratio: formula.period_ratio(amplitude),
        error,
    };
    amplitudes.iter().zip(errors).map(point).collect()
}

fn ranges(formula: &PeriodFormula) -> Vec<Range> {
    TOLERANCES.map(|tolerance| Range { tolerance, to: formula.holds_to(tolerance) }).into()
}

fn of_point() -> Fields<ErrorCurvePoint> {
    type Of = Field<ErrorCurvePoint>;
    Fields::from([
        Of::number("amplitude_rad", "rad", "amplitude", |point| point.amplitude.radians())
            .numeral("amplitude / °", |point| number::rounded(point.amplitude.degrees(), 4)),
        Of::number("ratio", "1", "T/T0 by the formula", |point| point.ratio).rounded("T/T0", 10),
        Of::number("fractional_error", "1", "formula over exact period, minus 1", |point| point.error)
            .rounded("error", 3),
    ])
}

fn of_range() -> Fields<Range> {
    type Of = Field<Range>;
    Fields::from([
        Of::number("tolerance", "1", "fractional error that is not exceeded", |range| range.tolerance)
            .numeral("error at most", |range| format!("{:?}", range.tolerance)),
        Of::number("holds_to_rad", "rad", "amplitude up to which it is not exceeded", |range| range.to)
            .degrees("to / °", 6),
    ])
}

/// The error curve and the ranges, in JSON.
pub(super) fn of_curve() -> [Field<Entry>; 2] {
    type Of = Field<Entry>;
    [
        Of::present_nested("errors[].", &of_point(), |entry| {
            entry.is_sheet.then(|| of_point().records(&points(&entry.formula)))
        }),
        Of::present_nested("holds[].", &of_range(), |entry| {
            entry.is_sheet.then(|| of_range().records(&ranges(&entry.formula)))
        }),
    ]
}

pub(super) fn write(out: &mut dyn Write, entries: &[Entry]) -> io::Result<()> {
    entries.iter().enumerate().try_for_each(|(index, entry)| {
        if index > 0 {
            writeln!(out)?;
        }
        write_sheet(out, &entry.formula)
    })
}

fn write_sheet(out: &mut dyn Write, formula: &PeriodFormula) -> io::Result<()> {
    let year = formula.year().map_or_else(String::new, |year| format!(" ({year})"));
    let error = formula.leading_error().map(|term| format!("{term} at small amplitude"));
    let lines = [
        ("key", formula.key().to_owned()),
        ("name", format!("{}{year}", formula.name())),
        ("T/T0", formula.text().to_owned()),
        ("", ABBREVIATIONS.to_owned()),
        ("LaTeX", formula.latex().to_owned()),
        ("derivation", formula.derivation().to_owned()),
        ("source", formula.source().to_owned()),
        ("good", formula.domain().to_owned()),
        ("error", error.unwrap_or_default()),
    ];
    sheet(out, &lines.into_iter().filter(|(_, text)| !text.is_empty()).collect::<Vec<_>>())?;
    writeln!(out)?;
    let (of_point, of_range) = (of_point(), of_range());
    let mut table = Table::new(of_point.columns());
    points(formula).iter().try_for_each(|point| table.row(out, of_point.cells(point)))?;
    table.finish(out)?;
    writeln!(out)?;
    let mut table = Table::new(of_range.columns());
    ranges(formula).iter().try_for_each(|range| table.row(out, of_range.cells(range)))?;
    table.finish(out)
}
