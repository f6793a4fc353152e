//! The units of the columns of a table, by their headings.

use super::wanted::refusal;
use super::{ChosenColumns, CountedOptions, Wanted};
use crate::call::in_words;
use libration_lab::fit::swings_of_numbered_time;
use libration_lab::measurement::{Column, Readings, Role, Table, Unit};
use std::f64::consts::PI;

/// The units of the columns, and the inferences from the header.
#[derive(Clone, Debug)]
pub(super) struct ColumnUnits<const N: usize> {
    pub(super) units: [Unit; N],
    /// Number of periods that each time lasts; one for columns that do not hold times.
    pub(super) counts: [f64; N],
    /// `true` where a header states the unit.
    pub(super) are_stated: [bool; N],
    /// Fractions of the values to which 1 corresponds in columns of relative uncertainties.
    pub(super) fractions: [Option<f64>; N],
    pub(super) inferences: Vec<String>,
}

impl<const N: usize> ColumnUnits<N> {
    /// The units of the chosen columns; uncertainties without a unit have that of their values.
    pub(super) fn from_headings(
        table: &Table,
        chosen: &ChosenColumns<N>,
        wanted: &[Wanted; N],
        read: &Readings,
    ) -> Result<Self, String> {
        let (mut units, mut counts, mut inferences) = (wanted.map(Wanted::usual), [1.0; N], Vec::new());
        let (mut are_stated, mut fractions, all) = ([false; N], [None; N], wanted);
        for (index, (columns, wanted)) in chosen.columns.iter().zip(wanted).enumerate() {
            let usual = wanted.uncertainties_of.map_or(units[index], |of| units[of]);
            for (number, column) in columns.iter().enumerate() {
                if chosen.are_squares[index] {
                    continue;
                }
                fractions[index] = wanted.fraction(table, column)?;
                let (unit, of_unit) = match fractions[index] {
                    Some(fraction) => (usual, Some(parts(table, column, fraction)?)),
                    None => wanted.unit(table, column, usual, chosen.is_said)?,
                };
                let (unit, of_unit) = match largest(read, index) {
                    number if wanted.may_be_degrees(of_unit.is_some()) && number >= PI => {
                        (Unit::Degree, Some(degrees(table, column, number)?))
                    }
                    _ => (unit, of_unit),
                };
                let by_quotient = chosen.swings[index].unwrap_or(1.0);
                let usual = wanted.uncertainties_of.map_or(by_quotient, |of| counts[of]);
                // Numbers of swings in a column win over the header.
                let is_open =
                    |counted: &CountedOptions| chosen.column_of_swings.is_none() || counted.said().is_some();
                let counted = wanted.counted.filter(is_open);
                let by_lengths = |number: f64| {
                    // `T2` without a unit may be a square.
                    let may_be_square = number < 3.0 && of_unit.is_none();
                    let lengths = lengths(all, read, &units, &are_stated).filter(|_| !may_be_square)?;
                    let times = read.quantities[index].iter().map(|reading| unit.to_si(reading[0]));
                    swings_of_numbered_time(number, &lengths.into_iter().zip(times).collect::<Vec<_>>())
                };
                let counted =
                    counted.map(|counted| counted.count(table, column, usual, by_lengths)).transpose()?;
                let (count, of_count) = counted.unwrap_or((1.0, None));
                let is_as_before = unit == units[index] && count.total_cmp(&counts[index]).is_eq();
                if number > 0 && !is_as_before {
                    let column = table.describe(column).map_err(refusal)?;
                    return Err(format!(
                        "{column} has another unit or number of swings than the other readings: use <--columns> or <--role>"
                    ));
                }
                (units[index], counts[index]) = (unit, count);
                if number == 0 {
                    are_stated[index] = of_unit.is_some() && fractions[index].is_none();
                    inferences
                        .extend(of_unit.into_iter().chain(of_count).map(|sentence| in_words(&sentence)));
                }
            }
        }
        Ok(Self { units, counts, are_stated, fractions, inferences })
    }
}

/// The largest magnitude of the readings at a place.
fn largest(read: &Readings, index: usize) -> f64 {
    read.quantities[index].iter().flatten().fold(0.0, |largest, reading| largest.max(reading.abs()))
}

/// A sentence about angles without a unit that are too large for radians. Other amplitudes may be lengths.
fn degrees(table: &Table, column: &Column, largest: f64) -> Result<String, String> {
    let name = table.describe(column).map_err(refusal)?;
    if !table.names_angles(column) {
        return Err(format!(
            "{name} has no unit, and its numbers, up to {largest}, are too large for radians: give the unit by <--amplitude-unit>, or convert \
             lengths to angles"
        ));
    }
    Ok(format!(
        "{name} has no unit and is read in degrees: its numbers are up to {largest}, and amplitudes are below π radians (<--amplitude-unit>)"
    ))
}

/// The lengths of the rows in metres, where a table has them: with a stated unit, or so short that they may be metres.
fn lengths<const N: usize>(
    wanted: &[Wanted; N],
    read: &Readings,
    units: &[Unit; N],
    are_stated: &[bool; N],
) -> Option<Vec<f64>> {
    /// Longest pendulum of a table without a unit of its lengths, in metres: shorter than those of most tables in centimetres.
    const LONGEST: f64 = 5.0;
    let is_length = |wanted: &Wanted| wanted.role == Role::Lengths && wanted.uncertainties_of.is_none();
    let index = wanted.iter().position(is_length)?;
    let first = |readings: &Vec<f64>| Some(units[index].to_si(*readings.first()?));
    let lengths: Option<Vec<f64>> = read.quantities[index].iter().map(first).collect();
    let is_stated = are_stated[index] || wanted[index].states_unit();
    lengths.filter(|lengths| is_stated || lengths.iter().all(|length| *length < LONGEST))
}

/// A sentence about a column of relative uncertainties.
fn parts(table: &Table, column: &Column, fraction: f64) -> Result<String, String> {
    let name = table.describe(column).map_err(refusal)?;
    let of_what = if fraction < 1e-2 { format!("{fraction} of") } else { "per cent of".to_owned() };
    Ok(format!("{name} is in {of_what} the values"))
}
