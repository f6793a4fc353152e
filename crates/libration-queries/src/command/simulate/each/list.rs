//! The motions of a table.

use super::super::Simulate;
use super::super::motion::SimulatedMotion;
use super::setting::Setting;
use crate::arguments::{Meaning, MotionRow, MotionTable, at_line};
use crate::query_error::QueryError;
use std::path::Path;

/// A row of a table and its motion.
pub(super) struct Listed<'a> {
    /// Number of the motion from 1, in the order of the rows.
    pub(super) number: usize,
    pub(super) row: &'a MotionRow,
    pub(super) setting: &'a Setting,
    pub(super) motion: SimulatedMotion<'a>,
}

/// All motions; `setting_indices` has the index of the setting of each row.
pub(super) fn listed<'a>(
    question: &'a Simulate,
    path: &Path,
    table: &'a MotionTable,
    setting_indices: &[usize],
    settings: &'a [Setting],
) -> Result<Vec<Listed<'a>>, QueryError> {
    let motions = (1..).zip(&table.rows).zip(setting_indices).map(|((number, row), setting_index)| {
        let setting = &settings[*setting_index];
        let cells: Vec<(&str, &str)> = table.cells_of(row, Meaning::Initial).collect();
        let initial = question.initial.read_with(&cells, &setting.model)?;
        let initial = initial.map_err(|reason| at_line(path, row.line, &reason))?;
        let motion = SimulatedMotion {
            model: &setting.model,
            question: question.question(&setting.model, &setting.watched, initial.state.clone()),
            initial,
            times: &question.times,
            tolerances: &question.tolerance,
            watched: &setting.watched,
            observables: setting.observables.as_ref(),
            sensitivities: setting.sensitivities.as_ref(),
            earlier: None,
            no_errors: question.reason_for_no_errors(),
        };
        if number == 1 {
            motion.check_times(question.animate)?;
        }
        Ok(Listed { number, row, setting, motion })
    });
    motions.collect()
}

impl Listed<'_> {
    /// The name of the motion, if it has one.
    pub(super) fn name<'t>(&'t self, table: &'t MotionTable) -> Option<&'t str> {
        table.cells_of(self.row, Meaning::Name).next().map(|(_, name)| name).filter(|name| !name.is_empty())
    }

    /// The number, and the name if there is one.
    pub(super) fn title(&self, table: &MotionTable) -> String {
        match self.name(table) {
            Some(name) => format!("{} ({name})", self.number),
            None => self.number.to_string(),
        }
    }

    /// The name, or else the values that distinguish it from the others.
    pub(super) fn label(&self, table: &MotionTable) -> String {
        let cells = |meaning| table.cells_of(self.row, meaning);
        let said = cells(Meaning::Parameter).chain(cells(Meaning::Initial));
        let said = || said.map(|(title, cell)| format!("{title} = {cell}")).collect::<Vec<_>>().join(", ");
        self.name(table).map_or_else(said, str::to_owned)
    }
}
