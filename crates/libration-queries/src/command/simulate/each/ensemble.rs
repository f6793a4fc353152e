//! The motions of a table, to be followed further and further.

use super::super::Simulate;
use super::{list, open_model, setting};
use crate::arguments::MotionTable;
use crate::query_error::{Parameter, QueryError, option};
use libration::systems::Model;
use libration::taylor::{Ensemble, Moment};

impl Simulate {
    /// The system with its values and the motions of the table at their start.
    pub(crate) fn ensemble(&self) -> Result<(Model, Ensemble), QueryError> {
        let usage = |about: Parameter, reason: &str| QueryError::usage(about, reason);
        let path = self
            .each
            .as_deref()
            .ok_or_else(|| usage(option("each"), "give a file with the initial states"))?;
        self.refuse_for_each()?;
        let system = self.system.given()?;
        let table = MotionTable::read(path, &system)?;
        open_model(&system, &table)?;
        let mut settings = vec![];
        let setting_indices = setting::places(self, path, &system, &table, &mut settings)?;
        if settings.len() > 1 {
            return Err(usage(
                option("each"),
                "the motions of an ensemble have the same parameters: give one value for each",
            ));
        }
        if !settings[0].watched.is_empty() {
            return Err(usage(option("events"), "events are not located in an ensemble"));
        }
        if !self.sensitivity.is_empty() {
            return Err(usage(option("sensitivity"), "derivatives are not computed for an ensemble"));
        }
        let listed = list::listed(self, path, &table, &setting_indices, &settings)?;
        let starts: Vec<Moment> = listed.iter().map(|listed| listed.motion.beginning()).collect();
        let (effort, setting) = (self.tolerance.effort(), &settings[0]);
        let ensemble = Ensemble::new(setting.system.clone(), &starts, &effort);
        let ensemble = ensemble.map_err(QueryError::failed)?;
        Ok((setting.model.clone(), ensemble))
    }
}
