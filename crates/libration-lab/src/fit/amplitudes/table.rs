//! Measured amplitudes, checked once.

use super::AmplitudesError;
use super::sides::{FoundSides, Sides};
use libration::internals::InOrder;

/// The quantity that amplitudes are measured against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Position {
    /// Times in seconds.
    Time,
    /// Numbers of full swings.
    Swings,
}

/// The quantity that is measured as the amplitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AmplitudeReading {
    /// Angles in radians: the law of the pendulum at any amplitude.
    Angle,
    /// Displacements in metres or in any unit: the law of small swings.
    Displacement,
    /// Horizontal displacements in metres of a pendulum of this length, in metres: the law at any amplitude.
    Horizontal {
        /// Distance from the pivot to the point that is read, in metres.
        length: f64,
    },
}

/// Errors of all amplitudes where no uncertainties are stated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UnstatedErrors {
    /// The same error of all amplitudes.
    #[default]
    Absolute,
    /// The same relative error of all amplitudes.
    Relative,
}

/// Amplitudes or turning points against time or against the number of swings.
#[derive(Clone, Copy, Debug)]
pub struct AmplitudeColumns<'a> {
    /// Quantity of the positions.
    pub against: Position,
    /// Times or numbers of swings, in any order.
    pub positions: &'a [f64],
    /// Quantity of the values.
    pub reading: AmplitudeReading,
    /// Amplitudes or turning points.
    pub values: &'a [f64],
    /// Standard uncertainties of the positions, zero or more.
    pub position_uncertainties: Option<&'a [f64]>,
    /// Standard uncertainties of the values, above zero.
    pub value_uncertainties: Option<&'a [f64]>,
    /// Numbers of swings, where the positions are times: they determine the period.
    pub swing_numbers: Option<&'a [f64]>,
    /// Periods at the amplitudes of the rows, in seconds.
    pub periods: Option<&'a [f64]>,
    /// Sides of the values; inferred if `None`.
    pub sides: Option<Sides>,
    /// Errors where no uncertainties of the values are given.
    pub unstated_errors: UnstatedErrors,
}

impl<'a> AmplitudeColumns<'a> {
    /// Returns the columns of values against positions, without uncertainties.
    #[must_use]
    pub fn new(
        against: Position,
        positions: &'a [f64],
        reading: AmplitudeReading,
        values: &'a [f64],
    ) -> Self {
        Self {
            against,
            positions,
            reading,
            values,
            position_uncertainties: None,
            value_uncertainties: None,
            swing_numbers: None,
            periods: None,
            sides: None,
            unstated_errors: UnstatedErrors::Absolute,
        }
    }
}

/// A table of amplitudes that can be fitted, in the order of the positions.
#[derive(Clone, Debug, PartialEq)]
pub struct AmplitudeTable {
    pub(super) rows: Vec<AmplitudeRow>,
    pub(super) against: Position,
    pub(super) reading: AmplitudeReading,
    pub(super) sides: Sides,
    counts_half_swings: bool,
    pub(super) weighted: bool,
    pub(super) unstated_errors: UnstatedErrors,
}

/// A row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct AmplitudeRow {
    pub(super) position: f64,
    pub(super) value: f64,
    /// +1 or −1.
    pub(super) side: f64,
    pub(super) position_uncertainty: f64,
    /// 1 if it is not stated.
    pub(super) value_uncertainty: f64,
    pub(super) swing: Option<f64>,
    pub(super) period: Option<f64>,
}

impl AmplitudeTable {
    /// Checks these columns, and returns them as a table.
    ///
    /// # Errors
    /// Fails for columns of different lengths, numbers that are not finite, angles of π or more, displacements beyond the length, unusable
    /// uncertainties, turning points on one side only, and positions that are all the same.
    pub fn new(columns: &AmplitudeColumns<'_>) -> Result<Self, AmplitudesError> {
        check_lengths(columns)?;
        let weighted = columns.value_uncertainties.is_some();
        if let AmplitudeReading::Horizontal { length } = columns.reading
            && !(length > 0.0 && length.is_finite())
        {
            return Err(AmplitudesError::Length(length));
        }
        let rows = (0..columns.values.len()).map(|row| AmplitudeRow::new(columns, row));
        let mut rows: Vec<AmplitudeRow> = rows.collect::<Result<_, _>>()?;
        rows.put_in_order(|one, other| one.position.total_cmp(&other.position));
        let values: Vec<f64> = rows.iter().map(|row| row.value).collect();
        let detected = FoundSides::of(&values, columns.sides).ok_or(AmplitudesError::OneSide)?;
        for (row, sign) in rows.iter_mut().zip(&detected.signs) {
            row.side = *sign;
        }
        let counts_half_swings = detected.sides == Sides::Both && count_half_swings(&rows, columns.against);
        if counts_half_swings {
            rows.iter_mut().for_each(|row| row.halve(columns.against));
        }
        let table = Self {
            rows,
            against: columns.against,
            reading: columns.reading,
            sides: detected.sides,
            counts_half_swings,
            weighted,
            unstated_errors: columns.unstated_errors,
        };
        table.check()?;
        Ok(table)
    }

    fn check(&self) -> Result<(), AmplitudesError> {
        let ends = self.rows.first().zip(self.rows.last());
        if ends.is_some_and(|(first, last)| first.position.total_cmp(&last.position).is_eq()) {
            return Err(AmplitudesError::EqualPositions(match self.against {
                Position::Time => "time",
                Position::Swings => "number of swings",
            }));
        }
        let is_relative = !self.weighted && self.unstated_errors == UnstatedErrors::Relative;
        let has_none = self.rows.iter().any(|row| row.side * row.value <= 0.0);
        if is_relative && (self.sides == Sides::Both || has_none) {
            return Err(AmplitudesError::RelativeErrors);
        }
        Ok(())
    }

    /// The number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Returns `true` if there are no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Sides on which the rows were read.
    #[must_use]
    pub fn sides(&self) -> Sides {
        self.sides
    }

    /// Returns `true` if the numbers of swings were read as those of half swings: turning points of both sides are whole numbers apart.
    #[must_use]
    pub fn counts_half_swings(&self) -> bool {
        self.counts_half_swings
    }

    /// Quantity that the amplitudes are measured against.
    #[must_use]
    pub fn against(&self) -> Position {
        self.against
    }

    /// Returns `true` if the rows count by their uncertainties; otherwise their scatter is the uncertainty.
    #[must_use]
    pub fn is_weighted(&self) -> bool {
        self.weighted
    }

    /// Returns `true` if the table determines the period: by a column of periods, or by times with numbers of swings.
    #[must_use]
    pub fn has_period(&self) -> bool {
        let has_numbers = self.against == Position::Time && self.rows.iter().any(|row| row.swing.is_some());
        has_numbers || self.rows.iter().any(|row| row.period.is_some())
    }

    /// The positions in their order: seconds or swings.
    pub fn positions(&self) -> impl Iterator<Item = f64> + '_ {
        self.rows.iter().map(|row| row.position)
    }

    /// The values in the order of the positions, in radians, metres or counts.
    pub fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.rows.iter().map(|row| row.value)
    }

    /// Errors of the amplitudes where no uncertainties are stated.
    #[must_use]
    pub fn unstated_errors(&self) -> UnstatedErrors {
        self.unstated_errors
    }

    /// The positions with the amplitudes that the values give with this zero of the scale.
    pub fn amplitudes(&self, zero: f64) -> impl Iterator<Item = (f64, f64)> + '_ {
        let amplitude = move |row: &AmplitudeRow| self.reading.amplitude(row.side * (row.value - zero));
        self.rows.iter().map(move |row| (row.position, amplitude(row)))
    }

    /// Standard deviations of amplitudes by those of the values, row by row.
    pub fn amplitude_deviations(&self, amplitudes: &[f64], of_values: &[f64]) -> Vec<f64> {
        let rows = of_values.iter().zip(amplitudes);
        rows.map(|(deviation, &amplitude)| deviation / self.reading.slope(amplitude)).collect()
    }

    /// The last position less the first.
    pub(super) fn span(&self) -> f64 {
        let ends = self.rows.first().zip(self.rows.last());
        ends.map_or(0.0, |(first, last)| last.position - first.position)
    }
}

impl AmplitudeReading {
    /// The value that is read at an amplitude: in radians, or in the unit of the displacements.
    pub(super) fn of(self, amplitude: f64) -> f64 {
        match self {
            Self::Angle | Self::Displacement => amplitude,
            Self::Horizontal { length } => length * libm::sin(amplitude),
        }
    }

    /// The amplitude at which this value is read.
    pub(super) fn amplitude(self, value: f64) -> f64 {
        match self {
            Self::Angle | Self::Displacement => value,
            Self::Horizontal { length } => libm::asin((value / length).clamp(-1.0, 1.0)),
        }
    }

    /// Derivative of the value with respect to the amplitude.
    pub(super) fn slope(self, amplitude: f64) -> f64 {
        match self {
            Self::Angle | Self::Displacement => 1.0,
            Self::Horizontal { length } => length * libm::cos(amplitude),
        }
    }

    /// Returns `true` if amplitudes are angles, so that the law is that of any amplitude.
    #[must_use]
    pub fn is_of_angles(self) -> bool {
        self != Self::Displacement
    }
}

/// Returns `true` if opposite turning points, which are half a swing or an odd number of them apart, are whole numbers apart.
fn count_half_swings(rows: &[AmplitudeRow], against: Position) -> bool {
    let number = |row: &AmplitudeRow| match against {
        Position::Swings => Some(row.position),
        Position::Time => row.swing,
    };
    let opposite = rows.windows(2).filter(|pair| pair[0].side * pair[1].side < 0.0);
    let mut steps = opposite.map(|pair| Some(number(&pair[1])? - number(&pair[0])?));
    // A number of swings that is not whole differs by a few hundredths at least.
    let is_whole = |step: Option<f64>| step.is_some_and(|step| (step - step.round()).abs() < 1e-6);
    steps.next().is_some_and(is_whole) && steps.all(is_whole)
}

fn check_lengths(columns: &AmplitudeColumns<'_>) -> Result<(), AmplitudesError> {
    let expected = columns.values.len();
    let optional = |column: Option<&[f64]>| column.map_or(expected, <[f64]>::len);
    let lengths = [
        ("times or numbers of swings", columns.positions.len()),
        ("uncertainties of the times", optional(columns.position_uncertainties)),
        ("uncertainties of the amplitudes", optional(columns.value_uncertainties)),
        ("numbers of swings", optional(columns.swing_numbers)),
        ("periods", optional(columns.periods)),
    ];
    match lengths.into_iter().find(|(_, length)| *length != expected) {
        Some((column, length)) => Err(AmplitudesError::LengthMismatch { column, rows: length, expected }),
        None => Ok(()),
    }
}

fn positive_period(row: usize, value: f64) -> Result<f64, AmplitudesError> {
    match value > 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(AmplitudesError::PeriodOfRow { row, value }),
    }
}

impl AmplitudeRow {
    fn halve(&mut self, against: Position) {
        match against {
            Position::Swings => {
                self.position *= 0.5;
                self.position_uncertainty *= 0.5;
            }
            Position::Time => self.swing = self.swing.map(|swing| 0.5 * swing),
        }
    }

    fn new(columns: &AmplitudeColumns<'_>, index: usize) -> Result<Self, AmplitudesError> {
        let row = index + 1;
        let finite = |of: &'static str, value: f64| match value.is_finite() {
            true => Ok(value),
            false => Err(AmplitudesError::NotFinite { row, of, value }),
        };
        let usable = |of: &'static str, uncertainty: f64, is_usable: bool, hint: &'static str| match is_usable
        {
            true => Ok(uncertainty),
            false => Err(AmplitudesError::Uncertainty { row, of, uncertainty, hint }),
        };
        let value = finite("amplitude", columns.values[index])?;
        match columns.reading {
            AmplitudeReading::Angle if value.abs() >= std::f64::consts::PI => {
                return Err(AmplitudesError::Angle { row, value });
            }
            AmplitudeReading::Horizontal { length }
                if columns.sides != Some(Sides::Both) && value.abs() >= length =>
            {
                return Err(AmplitudesError::Displacement { row, value, length });
            }
            _ => {}
        }
        let spread = columns.value_uncertainties.map_or(1.0, |column| column[index]);
        let of_position = columns.position_uncertainties.map_or(0.0, |column| column[index]);
        Ok(Self {
            position: finite("position", columns.positions[index])?,
            value,
            side: 1.0,
            position_uncertainty: usable(
                "time",
                of_position,
                (0.0..f64::INFINITY).contains(&of_position),
                "give zero or a positive number",
            )?,
            value_uncertainty: usable(
                "amplitude",
                spread,
                spread > 0.0 && spread.is_finite(),
                "give a positive number in every row, or none in any",
            )?,
            period: columns.periods.map(|column| positive_period(row, column[index])).transpose()?,
            swing: columns
                .swing_numbers
                .map(|column| finite("number of swings", column[index]))
                .transpose()?,
        })
    }
}
