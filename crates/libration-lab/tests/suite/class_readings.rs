//! Intervals of 800 tables of a class's readings contain the truth as often as they say (`reference/class_readings.py`).

use libration_lab::fit::{
    GroupMean, GroupResult, LengthColumns, LengthTable, LengthsOptions, PeriodTable, PeriodsOptions,
    RepeatedReadings, Uncertain, Uncertainties, fit_lengths, fit_periods,
};
use libration_lab::internals::statistics::count as number;
use libration_lab::internals::statistics::student::quantile;

const DATA: &str = include_str!("../data/class_readings.csv");

/// A row of a table.
struct Row<'a> {
    group: &'a str,
    x: f64,
    readings: Vec<f64>,
}

/// A table of the file.
struct Table<'a> {
    quantity: &'a str,
    design: &'a str,
    truth: f64,
    step: f64,
    clock: f64,
    swings: f64,
    rows: Vec<Row<'a>>,
}

fn tables() -> Vec<Table<'static>> {
    let mut tables: Vec<Table<'_>> = vec![];
    for line in DATA.lines().filter(|line| !line.starts_with('#')) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |index: usize| cells[index].parse::<f64>().unwrap();
        match cells[..] {
            [quantity, design, ..] if cells.len() == 6 => {
                let [truth, step, clock, swings] = [2, 3, 4, 5].map(number);
                tables.push(Table { quantity, design, truth, step, clock, swings, rows: vec![] });
            }
            [group, _, readings] => {
                let readings = readings.split(' ').map(|cell| cell.parse().unwrap()).collect();
                tables.last_mut().unwrap().rows.push(Row { group, x: number(1), readings });
            }
            _ => panic!("{line}"),
        }
    }
    tables
}

/// The result of rows, with the degrees of freedom of its uncertainty.
fn fitted(table: &Table<'_>, rows: &[Row<'_>], readings: Option<&RepeatedReadings>) -> (Uncertain, f64) {
    let x: Vec<f64> = rows.iter().map(|row| row.x).collect();
    let of = |part: fn(&libration_lab::fit::MeanReading) -> f64| {
        readings.map(|readings| readings.rows.iter().map(part).collect::<Vec<f64>>())
    };
    let single = || rows.iter().map(|row| row.readings[0] / table.swings).collect();
    let (means, uncertainties) = (of(|row| row.mean).unwrap_or_else(single), of(|row| row.uncertainty));
    if table.quantity == "t0" {
        let uncertainties = Uncertainties { amplitudes: None, periods: uncertainties.as_deref() };
        let periods_of = PeriodTable::new(&x, &means, uncertainties).unwrap();
        let periods_of = match readings {
            Some(readings) => periods_of.with_readings(readings.clone()),
            None => periods_of,
        };
        let fit = fit_periods(&periods_of, &[], &PeriodsOptions::default()).unwrap();
        return (fit.exact.t0, fit.exact.uncertainty_degrees_of_freedom());
    }
    let columns = LengthColumns {
        lengths: &x,
        periods: &means,
        period_uncertainties: uncertainties.as_deref(),
        ..LengthColumns::default()
    };
    let table = LengthTable::new(&columns).unwrap();
    let table = match readings {
        Some(readings) => table.with_readings(readings.clone()),
        None => table,
    };
    let fit = fit_lengths(&table, &LengthsOptions::default()).unwrap();
    (fit.gravity(), fit.combined.degrees_of_freedom)
}

fn repeated(table: &Table<'_>, rows: &[Row<'_>]) -> Option<RepeatedReadings> {
    let all: Vec<Vec<f64>> = rows.iter().map(|row| row.readings.clone()).collect();
    let mut readings = RepeatedReadings::new(&all, table.step)?;
    for mean in &mut readings.rows {
        *mean = mean.times(1.0 / table.swings);
    }
    Some(readings)
}

/// The result of a table: of its groups the mean, with the clock that they share.
fn result(table: &Table<'_>) -> (Uncertain, f64) {
    let of_rows = |rows: &[Row<'_>]| fitted(table, rows, repeated(table, rows).as_ref());
    if table.design != "groups" {
        return of_rows(&table.rows);
    }
    let group = |rows: &[Row<'_>]| {
        let (value, degrees_of_freedom) = of_rows(rows);
        GroupResult { name: rows[0].group.into(), rows: rows.len(), value, degrees_of_freedom }
    };
    let groups: Vec<GroupResult> = table.rows.chunk_by(|a, b| a.group == b.group).map(group).collect();
    // T is proportional to the rate of the clock, g to its square.
    let power = if table.quantity == "t0" { 1.0 } else { 2.0 };
    let mean = GroupMean::new(&groups, power * table.clock * groups[0].value.value).unwrap();
    (mean.total(), mean.degrees_of_freedom)
}

/// Number of tables, and the fractions of their intervals of 95 % and of 68.27 % that contain the truth.
fn coverage(quantity: &str, design: &str) -> (usize, f64, f64) {
    let (mut all, mut within) = (0, [0, 0]);
    for table in tables().iter().filter(|table| table.quantity == quantity && table.design == design) {
        let (computed, freedom) = result(table);
        all += 1;
        for (count, probability) in within.iter_mut().zip([0.95, 0.6827]) {
            let reach = quantile(1.0 - probability, freedom) * computed.uncertainty;
            *count += usize::from((computed.value - table.truth).abs() <= reach);
        }
    }
    let part = |count: usize| number(count) / number(all);
    (all, part(within[0]), part(within[1]))
}

/// All tables with normal errors together.
#[test]
fn intervals_of_normal_readings_hold_as_often_as_they_say() {
    for quantity in ["t0", "gravity"] {
        let designs = ["readings", "single", "groups"].map(|design| coverage(quantity, design));
        let all: usize = designs.iter().map(|design| design.0).sum();
        let part = |of: fn(&(usize, f64, f64)) -> f64| {
            designs.iter().map(|design| number(design.0) * of(design)).sum::<f64>() / number(all)
        };
        let (wide, narrow) = (part(|counts| counts.1), part(|counts| counts.2));
        assert!((0.92..=0.98).contains(&wide), "{quantity}: {wide} {designs:?}");
        assert!((0.62..=0.74).contains(&narrow), "{quantity}: {narrow} {designs:?}");
    }
}

/// Rounding is rectangular and makes most of the variance.
#[test]
fn intervals_of_coarse_readings_hold_at_least_as_often_as_they_say() {
    for quantity in ["t0", "gravity"] {
        let (_, wide, _) = coverage(quantity, "coarse");
        assert!(wide >= 0.94, "{quantity}: {wide}");
    }
}

/// A blunder enlarges the uncertainty of its row, so that the intervals hold.
#[test]
fn intervals_hold_with_a_blunder_among_the_readings() {
    for quantity in ["t0", "gravity"] {
        let (_, wide, _) = coverage(quantity, "outlier");
        assert!(wide >= 0.92, "{quantity}: {wide}");
    }
}

/// A reading that is off by 1 s or more is named; of right ones, at most one in a hundred is.
#[test]
fn blunders_are_named_and_few_other_readings() {
    let (mut named, mut wrong, mut false_alarms, mut right) = (0, 0, 0, 0);
    for table in tables() {
        let Some(readings) = repeated(&table, &table.rows) else { continue };
        let has_blunder = table.design == "outlier";
        (wrong, right) = (wrong + usize::from(has_blunder), right + usize::from(!has_blunder));
        named += usize::from(has_blunder && readings.outliers.iter().any(|(_, reading)| *reading == 0));
        false_alarms += usize::from(!has_blunder && !readings.outliers.is_empty());
    }
    assert!(number(named) > 0.98 * number(wrong), "{named} of {wrong}");
    // One in a hundred tables by chance; three times as many have a probability of 1e-6.
    assert!(number(false_alarms) < 0.03 * number(right), "{false_alarms} of {right}");
}
