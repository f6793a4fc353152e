//! Assignment of columns to runs.

use super::super::choices::Choices;
use super::super::sheet::Sheet;
use super::super::{MeasurementError, QuantityKind};

/// The columns that may belong to a run.
pub(super) struct Group<'a> {
    pub(super) sheet: &'a Sheet,
    pub(super) run: Option<String>,
    pub(super) members: Vec<usize>,
}

impl<'a> Group<'a> {
    /// One group for each run named by the header, or the chosen one, each with the columns that belong to no run.
    pub(super) fn all(sheet: &'a Sheet, choices: &Choices) -> Result<Vec<Self>, MeasurementError> {
        let mut runs = named_runs(sheet);
        let explicit = [&choices.angle, &choices.angular_velocity, &choices.x, &choices.y, &choices.time];
        if let Some(column) = explicit.into_iter().flatten().next() {
            let run = &sheet.channels[sheet.index_of(column)?].heading.run;
            runs.retain(|other| other == run);
        }
        let is_numbered = sheet.channels.iter().any(|channel| channel.heading.is(QuantityKind::Run));
        // Where nothing names runs they may be recognised by a clock that is set back, which is seen later.
        if let Some(asked) = choices.run.as_deref().filter(|_| !is_numbered && !runs.is_empty()) {
            let available: Vec<String> = runs.iter().flatten().map(|run| format!("`{run}`")).collect();
            let is_there = |asked: &str| runs.iter().flatten().any(|run| is_run(run, asked));
            if let Some(missing) = asked.split(',').find(|asked| !is_there(asked)) {
                let asked = missing.trim().into();
                let available = available.join(", ");
                return Err(MeasurementError::NoSuch { what: "run", asked, available });
            }
            let is_asked = |run: &str| asked.split(',').any(|asked| is_run(run, asked));
            runs.retain(|run| run.as_deref().is_some_and(is_asked));
        }
        if runs.is_empty() {
            runs.push(None);
        }
        Ok(runs.into_iter().map(|run| Self::of_run(sheet, run)).collect())
    }

    fn of_run(sheet: &'a Sheet, run: Option<String>) -> Self {
        let belongs = |column: &usize| {
            let heading = &sheet.channels[*column].heading;
            run.is_none() || heading.run.is_none() || heading.run == run
        };
        Self { sheet, members: (0..sheet.channels.len()).filter(belongs).collect(), run }
    }
}

fn named_runs(sheet: &Sheet) -> Vec<Option<String>> {
    let mut runs: Vec<Option<String>> = Vec::new();
    for channel in &sheet.channels {
        if channel.heading.run.is_some() && !runs.contains(&channel.heading.run) {
            runs.push(channel.heading.run.clone());
        }
    }
    runs
}

/// Returns `true` if a run is requested by its name, or by the number or the word at its end: `Run #3` by 3, `Group B` by B.
#[must_use]
pub fn is_run(run: &str, asked: &str) -> bool {
    let asked = asked.trim().to_lowercase();
    let run = run.to_lowercase();
    let number = run.rsplit(|letter: char| !letter.is_ascii_digit()).next().unwrap_or("");
    let last = run.split_whitespace().next_back().unwrap_or("");
    !asked.is_empty() && [run.as_str(), number, last].contains(&asked.as_str())
}
