//! Scatter of amplitudes and phases where no uncertainties are stated: each kind by its own residuals, amplitudes all by the same
//! amount or all by the same part.
//!
//! A kind of data with the residuals r, in standard deviations, is enlarged by √(Σr²/(n − Σh)): h, the leverage of a datum, is the part of it that
//! the parameters take up, so that the degrees of freedom which both kinds lose to them are shared as they were used. Once nothing changes any more
//! the likelihood of the residuals is the greatest: H. D. Patterson and R. Thompson, Biometrika 58, 545 (1971), doi:10.1093/biomet/58.3.545.
//!
//! All phases count alike. Those of sines through a noisy trace scatter by one over the amplitude, so that their uncertainties are rather too
//! large; few rows do not decide between the two: where the likelihood chose, of 120 sweeps of 25 rows whose phases scattered alike about ten were
//! taken for the other kind, and ω0 was off by 1.28 times as much as stated.

use super::found_row::FoundRow;
use super::table::{AmplitudeErrors, ResponseRow, ResponseTable};
use crate::statistics::count;

/// Least scatter, relative to the largest amplitude, and in radians: with less, rounding errors of required drives at a quality of a thousand move
/// parameters by a hundredth of their standard deviations.
const LEAST: f64 = 1e-10;
/// Initial scatter, relative to the largest amplitude.
const FIRST: f64 = 0.01;
/// Fewest rows beyond the number of parameters; with fewer, the two kinds have the weights of the fit of one sine to a noisy trace.
const FEWEST_SPARE: usize = 3;

/// Dependence of the scatter of phases on the amplitude of their rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum PhaseLaw {
    /// Inversely proportional to the amplitude, as for phases of sines through a noisy trace.
    OverAmplitude,
    /// Equal for all rows, as for phases that are read off.
    Alike,
}

impl PhaseLaw {
    fn factor(self, row: &ResponseRow) -> f64 {
        match self {
            Self::OverAmplitude => 1.0 / row.amplitude,
            Self::Alike => 1.0,
        }
    }
}

/// Standard deviations of amplitudes and phases, divided by those of the rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scatters {
    amplitude: f64,
    phase: f64,
    law: PhaseLaw,
    errors: AmplitudeErrors,
}

/// Residuals of a kind of data after a round of the search.
#[derive(Clone, Copy, Debug, Default)]
struct Left {
    squares: f64,
    degrees_of_freedom: f64,
}

impl Left {
    fn of(residuals: impl Iterator<Item = (f64, f64)>) -> Self {
        residuals.fold(Self::default(), |sum, (residual, leverage)| Self {
            squares: sum.squares + residual * residual,
            degrees_of_freedom: sum.degrees_of_freedom + 1.0 - leverage,
        })
    }

    fn and(self, other: Self) -> Self {
        let degrees_of_freedom = self.degrees_of_freedom + other.degrees_of_freedom;
        Self { squares: self.squares + other.squares, degrees_of_freedom }
    }

    fn deviation(self) -> f64 {
        (self.squares / self.degrees_of_freedom.max(1.0)).sqrt()
    }
}

impl Scatters {
    /// Initial scatters of a search.
    pub(super) fn first(table: &ResponseTable) -> Self {
        let errors = table.amplitude_errors();
        let (size, law) = match errors {
            AmplitudeErrors::Stated => (1.0, PhaseLaw::OverAmplitude),
            AmplitudeErrors::Absolute => (FIRST * table.largest_amplitude(), PhaseLaw::OverAmplitude),
            AmplitudeErrors::Relative => (FIRST, PhaseLaw::Alike),
        };
        Self { amplitude: size, phase: size, law, errors }
    }

    /// The standard deviation of the amplitude of a row that has this amplitude without its error: relative errors as parts of measured
    /// amplitudes would give rows that are too small by chance too much weight.
    pub(super) fn of_amplitude(&self, row: &ResponseRow, without_error: f64) -> f64 {
        match self.errors {
            AmplitudeErrors::Relative => self.amplitude * without_error,
            AmplitudeErrors::Absolute | AmplitudeErrors::Stated => self.amplitude * row.amplitude_uncertainty,
        }
    }

    pub(super) fn of_phase(&self, row: &ResponseRow) -> f64 {
        match self.errors {
            AmplitudeErrors::Stated => row.phase_uncertainty,
            AmplitudeErrors::Absolute | AmplitudeErrors::Relative => self.phase * self.law.factor(row),
        }
    }

    /// Scatter of the amplitudes, where no uncertainties are stated.
    pub(super) fn unstated(&self) -> Option<f64> {
        (self.errors != AmplitudeErrors::Stated).then_some(self.amplitude)
    }

    /// Computes the scatters after a round of a search with this number of parameters.
    pub(super) fn renewed(self, table: &ResponseTable, rows: &[FoundRow], parameters: usize) -> Self {
        if self.errors == AmplitudeErrors::Stated {
            return self;
        }
        let of_kind = |kind: usize| {
            let data =
                rows.iter().filter_map(move |row| row.residuals.get(kind).zip(row.leverages.get(kind)));
            Left::of(data.map(|(residual, leverage)| (*residual, *leverage)))
        };
        let [amplitudes, phases] = [of_kind(0), of_kind(1)];
        if !table.has_phases() || table.len() < parameters + FEWEST_SPARE {
            let size = self.amplitude * amplitudes.and(phases).deviation();
            return self.of_sizes(size, size, table);
        }
        let amplitude = self.amplitude * amplitudes.deviation();
        let law = PhaseLaw::Alike;
        let size = |(row, estimate): (&ResponseRow, &FoundRow)| {
            let part = self.of_phase(row) / law.factor(row);
            Some((part * estimate.residuals.get(1)?, *estimate.leverages.get(1)?))
        };
        let phase = Left::of(table.rows.iter().zip(rows).filter_map(size)).deviation();
        Self { law, ..self }.of_sizes(amplitude, phase, table)
    }

    fn of_sizes(self, amplitude: f64, phase: f64, table: &ResponseTable) -> Self {
        let largest = table.largest_amplitude();
        let least = if self.errors == AmplitudeErrors::Relative { LEAST } else { LEAST * largest };
        let least_phase = if self.law == PhaseLaw::Alike { LEAST } else { LEAST * largest };
        Self { amplitude: amplitude.max(least), phase: phase.max(least_phase), ..self }
    }

    /// Returns `true` if another scatter is equal within this fraction.
    pub(super) fn is_near(&self, other: &Self, part: f64) -> bool {
        let near = |one: f64, other: f64| (one / other - 1.0).abs() <= part;
        self.law == other.law && near(self.amplitude, other.amplitude) && near(self.phase, other.phase)
    }

    /// The misfit that is minimised where the scatters are unknown: −2 times the logarithm of the likelihood, up to a constant.
    pub(super) fn misfit(&self, table: &ResponseTable, rows: &[FoundRow]) -> f64 {
        let kind = |kind: usize, deviation: &dyn Fn(&ResponseRow, &FoundRow) -> f64| {
            let data = || table.rows.iter().zip(rows).filter(|(_, estimate)| estimate.residuals.len() > kind);
            let n = count(data().count());
            let squares: f64 =
                data().map(|(_, estimate)| estimate.residuals[kind] * estimate.residuals[kind]).sum();
            let sizes: f64 = data().map(|(row, estimate)| 2.0 * libm::log(deviation(row, estimate))).sum();
            if n > 0.0 { sizes + n * libm::log((squares / n).max(f64::MIN_POSITIVE)) } else { 0.0 }
        };
        kind(0, &|row, estimate| self.of_amplitude(row, estimate.amplitude))
            + kind(1, &|row, _| self.of_phase(row))
    }
}
