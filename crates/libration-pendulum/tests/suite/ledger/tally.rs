//! The largest and the mean error by result and region, printed as a Markdown table.
#![expect(clippy::print_stdout, reason = "the report is what the ledger is run for")]

use super::heading;
use super::oracle::Record;
use crate::promises::Promise;
use libration_testing::ulp::Truth;
use std::collections::BTreeMap;

pub(super) struct Tally<'a> {
    promise: Promise,
    regions: &'a [&'a str],
    cells: BTreeMap<(&'static str, usize), Cell>,
}

#[derive(Default)]
struct Cell {
    count: u32,
    sum: f64,
    largest: f64,
    worst_input: Vec<f64>,
}

impl<'a> Tally<'a> {
    pub(super) fn new(promise: Promise, regions: &'a [&'a str]) -> Self {
        Self { promise, regions, cells: BTreeMap::new() }
    }

    /// Records the error of `got` in ulp beyond the absolute allowance.
    pub(super) fn add(
        &mut self,
        record: &Record,
        answer: &'static str,
        truth: Truth,
        got: f64,
        allowance: f64,
    ) {
        let error = truth.error_beyond(got, allowance);
        let cell = self.cells.entry((answer, record.region)).or_default();
        cell.count += 1;
        cell.sum += error;
        if error > cell.largest {
            cell.largest = error;
            cell.worst_input.clone_from(&record.inputs);
        }
    }

    /// Prints the table; fails if the bound is exceeded or nothing was recorded.
    pub(super) fn report(self) {
        self.print();
        self.enforce();
    }

    pub(super) fn print(&self) {
        println!("\n{}\n", heading(&self.promise));
        println!(
            "| answer | region | inputs | mean ulp | max ulp | worst input |\n|---|---|---|---|---|---|"
        );
        for ((answer, region), cell) in &self.cells {
            let (mean, largest) = (short(cell.sum / f64::from(cell.count)), short(cell.largest));
            let (region, worst) = (self.regions[*region], &cell.worst_input);
            println!("| {answer} | {region} | {} | {mean} | {largest} | {worst:?} |", cell.count);
        }
    }

    pub(super) fn enforce(&self) {
        assert!(!self.cells.is_empty(), "the oracle gave no records");
        let largest = self.cells.values().map(|cell| cell.largest).fold(0.0, f64::max);
        assert!(largest <= self.promise.ulp, "{}: {largest} ulp", heading(&self.promise));
    }
}

fn short(error: f64) -> String {
    if error < 1e4 { format!("{error:.3}") } else { format!("{error:.1e}") }
}
