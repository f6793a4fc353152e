//! The sets of parameter values of the motions in a table, each set once.

use super::super::Simulate;
use super::super::events::Watched;
use super::super::run::system_of;
use crate::arguments::{self, GivenSystem, Meaning, MotionTable, at_line};
use crate::query_error::{QueryError, option};
use libration::expression::Expression;
use libration::systems::{Energy, Model, Observables};
use libration::taylor::{Sensitivities, System};
use std::collections::HashMap;
use std::path::Path;

/// A system with values for all parameters, and the quantities observed in its motions.
pub(super) struct Setting {
    pub(super) model: Model,
    /// The system with its derivatives and events.
    pub(super) system: System,
    pub(super) sensitivities: Option<Sensitivities>,
    pub(super) watched: Watched,
    pub(super) observables: Option<Observables>,
    /// Conserved energy, or the reason why it is unknown.
    pub(super) energy: Result<Energy, String>,
}

/// The position of the setting of each row of a table; new settings are added.
pub(super) fn places(
    question: &Simulate,
    path: &Path,
    system: &GivenSystem<'_>,
    table: &MotionTable,
    settings: &mut Vec<Setting>,
) -> Result<Vec<usize>, QueryError> {
    let mut indices: HashMap<Vec<&str>, usize> = HashMap::new();
    let mut setting_indices = vec![];
    for row in &table.rows {
        let cells: Vec<(&str, &str)> = table.cells_of(row, Meaning::Parameter).collect();
        let texts = cells.iter().map(|(_, text)| *text).collect();
        let index = match indices.get(&texts) {
            Some(index) => *index,
            None => {
                let model = model(system, &cells).map_err(|reason| at_line(path, row.line, &reason))?;
                settings.push(Setting::new(question, system, model)?);
                indices.insert(texts, settings.len() - 1);
                settings.len() - 1
            }
        };
        setting_indices.push(index);
    }
    Ok(setting_indices)
}

fn model(system: &GivenSystem<'_>, cells: &[(&str, &str)]) -> Result<Model, String> {
    let value = |(name, text): &(&str, &str)| {
        let value: Expression = text.parse().map_err(|error| format!("{name}: {error}"))?;
        Ok(((*name).to_owned(), value))
    };
    let values = cells.iter().map(value).collect::<Result<Vec<_>, String>>()?;
    system.model_with(&values).map_err(|error| error.to_string())
}

impl Setting {
    fn new(question: &Simulate, given: &GivenSystem<'_>, model: Model) -> Result<Self, QueryError> {
        let watched = Watched::read(&question.events, &question.until, &model)?;
        let observables = question.columns.as_deref();
        let observables =
            observables.map(|text| arguments::columns(&option("columns"), text, &model)).transpose()?;
        let sensitivities = arguments::sensitivities(&question.sensitivity, given, &model)?;
        let system =
            system_of(&model, sensitivities.as_ref(), &question.tolerance, &watched, &option("each"))?;
        let energy = model.energy().map_err(|reason| reason.to_string());
        Ok(Self { model, system, sensitivities, watched, observables, energy })
    }
}
