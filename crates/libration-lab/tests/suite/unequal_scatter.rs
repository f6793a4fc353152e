//! Intervals and warnings of tables whose repeated readings scatter differently from row to row. The truth is that of the generator.

use libration_lab::fit::{
    LengthColumns, LengthTable, LengthsOptions, PeriodTable, PeriodsOptions, RepeatedReadings,
    ScatterVerdict, Uncertainties, fit_lengths, fit_periods,
};
use libration_lab::internals::statistics::count as number;
use libration_lab::internals::statistics::student::quantile;

use libration_testing::sweep;

use crate::random::Random;
use crate::synthetic_trace::normal;

const G: f64 = 9.81;

/// The differences of the variances of the rows.
#[derive(Clone, Copy, Debug)]
enum Variances {
    Equal,
    /// Variances with uniform logarithms between 1 and this.
    Random(f64),
    /// 1 or this.
    Two(f64),
    /// Variances from 1 in the first row to this in the last one.
    Rising(f64),
}

impl Variances {
    fn deviation(self, row: usize, rows: usize, random: &mut Random) -> f64 {
        let exponent = |factor: f64, part: f64| libm::pow(factor, 0.5 * part);
        match self {
            Self::Equal => 1.0,
            Self::Random(factor) => exponent(factor, random.between(0.0, 1.0)),
            Self::Two(factor) => exponent(factor, random.between(0.0, 2.0).floor()),
            Self::Rising(factor) => exponent(factor, number(row) / number(rows - 1)),
        }
    }
}

/// Numbers of tables whose interval of 95 % contains the truth, of tables with a warning that the rows scatter more, and of all.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    within: usize,
    warned: usize,
    all: usize,
}

impl Tally {
    fn add(&mut self, error: f64, reach: f64, verdict: Option<ScatterVerdict>) {
        self.within += usize::from(error.abs() <= reach);
        self.warned += usize::from(verdict == Some(ScatterVerdict::More));
        self.all += 1;
    }

    fn coverage(self) -> f64 {
        number(self.within) / number(self.all)
    }

    fn warnings(self) -> f64 {
        number(self.warned) / number(self.all)
    }
}

fn table(periods: &[f64], of_each: usize, variances: Variances, random: &mut Random) -> RepeatedReadings {
    let reading =
        |period: f64, deviation: f64, random: &mut Random| period + 0.01 * deviation * normal(random);
    let mut row = |(row, period): (usize, &f64)| {
        let deviation = variances.deviation(row, periods.len(), random);
        (0..of_each).map(|_| reading(*period, deviation, random)).collect::<Vec<f64>>()
    };
    RepeatedReadings::new(&periods.iter().enumerate().map(&mut row).collect::<Vec<_>>(), 1e-6).unwrap()
}

/// T0 of a table at small amplitudes.
fn of_periods(readings: &RepeatedReadings, tally: &mut Tally) {
    let [means, uncertainties] = columns(readings);
    let uncertainties = Uncertainties { amplitudes: None, periods: Some(&uncertainties) };
    let amplitudes = vec![1e-3; means.len()];
    let table = PeriodTable::new(&amplitudes, &means, uncertainties).unwrap().with_readings(readings.clone());
    let fit = fit_periods(&table, &[], &PeriodsOptions::default()).unwrap().exact;
    let reach = quantile(0.05, fit.uncertainty_degrees_of_freedom()) * fit.t0.uncertainty;
    tally.add(fit.t0.value - 2.0, reach, fit.scatter().map(libration_lab::fit::Scatter::verdict));
}

/// g of a table with an offset of the lengths.
fn of_lengths(readings: &RepeatedReadings, lengths_of: &[f64], tally: &mut Tally) {
    let [means, uncertainties] = columns(readings);
    let table = LengthTable::new(&LengthColumns {
        lengths: lengths_of,
        periods: &means,
        period_uncertainties: Some(&uncertainties),
        ..LengthColumns::default()
    });
    let table = table.unwrap().with_readings(readings.clone());
    let fit = fit_lengths(&table, &LengthsOptions::default()).unwrap();
    let reach = quantile(0.05, fit.combined.degrees_of_freedom) * fit.gravity().uncertainty;
    tally.add(fit.gravity().value - G, reach, fit.best().scatter().map(libration_lab::fit::Scatter::verdict));
}

fn columns(readings: &RepeatedReadings) -> [Vec<f64>; 2] {
    [
        readings.rows.iter().map(|row| row.mean).collect(),
        readings.rows.iter().map(|row| row.uncertainty).collect(),
    ]
}

/// Tables of T0 and of g with a number of rows and of readings of each.
fn tallies(rows: usize, of_each: usize, variances: Variances, random: &mut Random) -> [Tally; 2] {
    let mut tallies = [Tally::default(); 2];
    let lengths_of: Vec<f64> = (0..rows).map(|row| 0.4 + number(row) / number(rows - 1)).collect();
    let law: Vec<f64> = lengths_of.iter().map(|length| std::f64::consts::TAU * (length / G).sqrt()).collect();
    for _ in 0..sweep::number(100, 1000) {
        of_periods(&table(&vec![2.0; rows], of_each, variances, random), &mut tallies[0]);
        of_lengths(&table(&law, of_each, variances, random), &lengths_of, &mut tallies[1]);
    }
    tallies
}

/// Coverages of 1000 tables were 0.931 to 0.975, and warnings at most 0.035. The limits are five standard errors beyond them.
#[test]
fn intervals_and_warnings_hold_where_readings_scatter_differently_in_a_sweep() {
    let variances = [
        Variances::Equal,
        Variances::Random(4.0),
        Variances::Random(25.0),
        Variances::Two(25.0),
        Variances::Rising(25.0),
    ];
    let mut random = Random::seeded(sweep::seed(7));
    let error = |part: f64| 5.0 * (part * (1.0 - part) / number(sweep::number(100, 1000))).sqrt();
    let mut outside = vec![];
    for variances in variances {
        for (rows, of_each) in [(5, 3), (8, 3), (12, 3), (8, 4), (5, 6), (12, 6)] {
            for (of, tally) in ["t0", "g"].iter().zip(tallies(rows, of_each, variances, &mut random)) {
                let [coverage, warnings] = [tally.coverage(), tally.warnings()];
                let case =
                    format!("{variances:?} {of} {rows} rows of {of_each}: {coverage:.3} {warnings:.3}");
                let expected = 0.931 - error(0.931)..=0.975 + error(0.975);
                if !expected.contains(&coverage) || warnings > 0.035 + error(0.035) {
                    outside.push(case);
                }
            }
        }
    }
    assert!(outside.is_empty(), "{outside:#?}");
}
