//! The motions of a table as table, JSON and CSV.

use super::super::ending::Ending;
use super::super::fields::{EVENT, of_event_alone, of_sample_alone, of_time};
use super::super::precision::Precision;
use super::super::report::Summary;
use super::super::rows::SimulatedRow;
use super::super::sheet::{cells_of, drift, not_estimated, titles};
use super::SimulatedEach;
use super::fields::{NumberedMotion, of_answer, of_number, of_summary, of_values};
use super::follow::Followed;
use crate::arguments::Meaning;
use crate::output::table::{Column, Table, paragraph, sheet, write_text};
use crate::output::{Form, csv, json, number};
use std::io::{self, Write};

impl SimulatedEach<'_> {
    /// Writes the result in the given form; the table lists the samples only if requested.
    pub(super) fn write(&self, form: Form, listed: bool, out: &mut dyn Write) -> io::Result<()> {
        match form {
            Form::Json => self.write_json(out),
            Form::Csv => self.write_csv(out),
            Form::Table => self.write_table(listed, out),
        }
    }

    pub(super) fn column_names(&self) -> Vec<String> {
        self.motions.first().map_or(vec![], |(listed, _)| listed.motion.column_names())
    }

    fn has_names(&self) -> bool {
        self.table.columns.iter().any(|column| column.meaning == Meaning::Name)
    }

    fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        let motions = self.motions.iter().map(|(listed, followed)| {
            let numbered = NumberedMotion { answer: self, listed };
            let (mut samples, mut events) = (vec![], vec![]);
            for row in listed.motion.rows(&followed.solution, None) {
                match row {
                    SimulatedRow::Sample(sample) => samples.push(of_sample_alone().record(&sample)),
                    SimulatedRow::Event(event) => events.push(of_event_alone().record(&event)),
                }
            }
            let head = of_values().added_to(of_number().record(&numbered), &numbered);
            let head = head.with("samples", json::records(samples)).with("events", json::records(events));
            of_summary().added_to(head, &followed.summary())
        });
        json::document_with_list(out, of_answer().record(self), "motions", motions)
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let (of_number, of_time) = (of_number(), of_time());
        let columns = if self.has_names() { 2 } else { 1 };
        let names = of_number.csv_names().into_iter().take(columns).chain(of_time.csv_names());
        let names = names.chain(self.model.state_names()).chain(self.column_names());
        let event = self.with_events.then(|| EVENT.0.to_owned());
        csv::line(out, &names.chain(event).collect::<Vec<_>>())?;
        for (listed, followed) in &self.motions {
            let numbered = of_number.csv_cells(&NumberedMotion { answer: self, listed });
            for row in listed.motion.rows(&followed.solution, None) {
                let (time, numbers, kind) = row.parts();
                let mut cells = numbered[..columns].to_vec();
                cells.extend(of_time.csv_cells(&time));
                cells.extend(numbers.concat().into_iter().map(csv::number));
                cells.extend(self.with_events.then(|| kind.to_owned()));
                csv::line(out, &cells)?;
            }
        }
        Ok(())
    }

    fn write_table(&self, listed: bool, out: &mut dyn Write) -> io::Result<()> {
        let name = self.model.key().map_or(String::new(), |key| format!(" ({key})"));
        write_text(out, "", &format!("{}{name}", self.model.title()))?;
        writeln!(out, "{}", paragraph("  equations  ", &self.model.equation().to_string(), 120))?;
        let motions = format!("{}, of {}", self.motions.len(), self.path.display());
        writeln!(out, "{}", paragraph("  motions    ", &motions, 120))?;
        writeln!(out, "{}", paragraph("  tolerance  ", &self.tolerances.to_string(), 120))?;
        writeln!(out, "{}\n", paragraph("  errors     ", &not_estimated("--each"), 120))?;
        self.write_motions(out)?;
        if listed {
            self.write_rows(out)?;
        }
        Ok(())
    }

    /// Writes each motion, and its ending.
    fn write_motions(&self, out: &mut dyn Write) -> io::Result<()> {
        let titles_of_table = self.table.columns.iter().map(|column| match column.meaning {
            Meaning::Name => Column::words(&column.title),
            Meaning::Parameter | Meaning::Initial => Column::numbers(&column.title),
        });
        let ends = [Column::numbers("ends at t / s"), Column::words("by"), Column::numbers("energy drift")];
        let columns = [Column::numbers("motion")].into_iter().chain(titles_of_table).chain(ends);
        let mut table = Table::new(columns.chain([Column::numbers("steps")]).collect());
        for (listed, followed) in &self.motions {
            let cells = listed.row.cells.iter().cloned();
            let drift =
                followed.drift.as_ref().map_or(String::new(), |[drift, _]| number::rounded(*drift, 2));
            let solution = &followed.solution;
            let ends = [
                number::short(solution.end.time, 12),
                followed.ending_name(),
                drift,
                solution.steps.to_string(),
            ];
            table.row(out, [listed.number.to_string()].into_iter().chain(cells).chain(ends).collect())?;
        }
        table.finish(out)?;
        // They all have none for one reason.
        match self.motions.first().map(|(_, followed)| &followed.drift) {
            Some(Err(reason)) => {
                writeln!(out)?;
                sheet(out, &[("energy drift", drift(&Err(reason.clone())))])
            }
            _ => Ok(()),
        }
    }

    /// The samples and events of all motions.
    fn write_rows(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out)?;
        let of_motion =
            [Column::numbers("motion")].into_iter().chain(self.has_names().then(|| Column::words("name")));
        let numbers = titles(self.model, &self.column_names()).into_iter().map(Column::numbers);
        let event = self.with_events.then(|| Column::words("event"));
        let mut table = Table::new(of_motion.chain(numbers).chain(event).collect());
        for (listed, followed) in &self.motions {
            let name = self.has_names().then(|| listed.name(self.table).unwrap_or("").to_owned());
            let first: Vec<String> = [listed.number.to_string()].into_iter().chain(name).collect();
            for row in listed.motion.rows(&followed.solution, None) {
                let (time, numbers, kind) = row.parts();
                let kind = self.with_events.then(|| kind.to_owned());
                table.row(
                    out,
                    first.iter().cloned().chain(cells_of(time, numbers, None)).chain(kind).collect(),
                )?;
            }
        }
        table.finish(out)
    }
}

impl Followed<'_> {
    fn summary(&self) -> Summary {
        let (drift, ending) = (self.drift.clone(), self.ending.clone());
        let precision = Precision::NotEstimated("--each");
        Summary { steps: self.solution.steps, drift, precision, ending, state: None }
    }

    fn ending_name(&self) -> String {
        match &self.ending {
            Ending::Complete => "--times".to_owned(),
            Ending::Event(event) => event.name.clone(),
            Ending::NotReached(_) => "--times, before --until".to_owned(),
            Ending::Interrupted(_) => "Ctrl-C".to_owned(),
            Ending::Stopped(_) => "the equations".to_owned(),
        }
    }
}
