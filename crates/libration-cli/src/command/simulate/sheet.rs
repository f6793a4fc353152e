//! The answer to read.

use super::report::{Report, Summary, name};
use super::run::Motion;
use crate::output::number;
use crate::output::table::{Column, Table, paragraph, sheet};
use libration::taylor::Moment;
use std::io::{self, Write};

/// What was asked, a table of samples, and what is to be said of the whole.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    table: Option<Table>,
}

impl Report for Sheet {
    fn begin(&mut self, motion: &Motion, out: &mut dyn Write) -> io::Result<()> {
        let model = motion.model;
        writeln!(out, "{} ({})", model.title(), name(motion))?;
        writeln!(out, "{}", paragraph("  equations  ", &model.equation().to_string(), 120))?;
        writeln!(out, "{}", paragraph("  begins at  ", &start(motion), 120))?;
        writeln!(out, "  tolerance  {:e} a step\n", motion.effort.relative)?;
        let numbers = model.state_names().into_iter().zip(model.state_units());
        let columns = numbers.map(|(name, unit)| labelled(&name, &unit));
        self.table =
            Some(Table::new(["t / s".to_owned()].into_iter().chain(columns).map(Column::numbers).collect()));
        Ok(())
    }

    fn sample(&mut self, moment: &Moment, out: &mut dyn Write) -> io::Result<()> {
        let mut cells = vec![number::short(moment.time, 12)];
        cells.extend(moment.state.iter().map(|&value| number::rounded(value, 12)));
        self.table.as_mut().map_or(Ok(()), |table| table.row(out, cells))
    }

    fn end(&mut self, summary: &Summary, out: &mut dyn Write) -> io::Result<()> {
        if let Some(table) = self.table.take() {
            table.finish(out)?;
        }
        let drift = match &summary.drift {
            Ok(drift) => format!("{} of the largest kinetic energy", number::rounded(*drift, 2)),
            Err(reason) => format!("none, as {reason}"),
        };
        writeln!(out)?;
        sheet(out, &[("energy drift", drift), ("steps", summary.steps.to_string())])
    }
}

/// A name with its unit: `theta' / (rad/s)`.
fn labelled(name: &str, unit: &str) -> String {
    match unit {
        "" => name.to_owned(),
        unit if unit.contains('/') => format!("{name} / ({unit})"),
        unit => format!("{name} / {unit}"),
    }
}

/// The state at the start, with what was not given.
fn start(motion: &Motion) -> String {
    let state =
        motion.model.state_names().into_iter().zip(motion.model.state_units()).zip(&motion.initial.state);
    let given: Vec<String> =
        state.map(|((name, unit), value)| format!("{name} = {} {unit}", number::short(*value, 12))).collect();
    let given = given.iter().map(|text| text.trim_end()).collect::<Vec<_>>().join(", ");
    let assumed: Vec<&str> = motion.initial.assumed.iter().map(|(name, _)| name.as_str()).collect();
    match assumed.as_slice() {
        [] => given,
        names => format!("{given} ({} not given and taken at rest)", names.join(", ")),
    }
}
