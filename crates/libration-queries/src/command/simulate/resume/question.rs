//! Parameters of a run, which show whether an earlier result has the same motion.

use crate::output::field::{Field, Fields};
use crate::output::json;
use serde_json::Value;

/// The parameters that decide the numbers of a motion, except the times.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RunParameters {
    /// The key of the system; `None` for equations as typed.
    pub(crate) system: Option<String>,
    /// Equations with the values of all parameters.
    pub(crate) equations: String,
    /// The names of the numbers of a state.
    pub(crate) state: Vec<String>,
    /// The state at t = 0.
    pub(crate) initial: Vec<f64>,
    pub(crate) tolerance: f64,
    /// Separate tolerances of coordinates.
    pub(crate) own_tolerances: Vec<(String, f64)>,
    /// Events.
    pub(crate) events: Vec<String>,
    /// `true` if errors of the states are estimated.
    pub(crate) errors: bool,
    /// Formulas whose values are listed in addition to the state.
    pub(crate) columns: Vec<String>,
}

/// Two questions that are not the same.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum Difference {
    #[error(
        "its equations are `{earlier}`, not `{asked}`: give the system and the parameter values of that run"
    )]
    Equations { earlier: String, asked: String },
    #[error("it was computed to the tolerance {earlier:e}, not {asked:e}: give <--tolerance> {earlier:e}")]
    Tolerance { earlier: f64, asked: f64 },
    #[error("coordinates had other individual tolerances: give the <--tolerance> of that run")]
    OwnTolerances,
    #[error("{}: give the same <--events>", events(.earlier, .asked))]
    Events { earlier: Vec<String>, asked: Vec<String> },
    #[error("it has errors of its states: leave out <--no-errors>")]
    Errors,
    #[error("it has no errors of its states: give <--no-errors>")]
    NoErrors,
    #[error("its columns are {}, not {}: give the same <--columns>", listed(.earlier), listed(.asked))]
    Columns { earlier: Vec<String>, asked: Vec<String> },
}

fn events(earlier: &[String], asked: &[String]) -> String {
    format!("its events are {}, not {}", listed(earlier), listed(asked))
}

fn listed(names: &[String]) -> String {
    if names.is_empty() { "none".to_owned() } else { names.join(", ") }
}

impl RunParameters {
    /// Checks that an earlier result is the beginning of the result of this run, apart from the initial state.
    pub(crate) fn check(&self, earlier: &Self) -> Result<(), Difference> {
        if earlier.equations != self.equations || earlier.state != self.state {
            let (earlier, asked) = (earlier.equations.clone(), self.equations.clone());
            return Err(Difference::Equations { earlier, asked });
        }
        if earlier.tolerance.to_bits() != self.tolerance.to_bits() {
            return Err(Difference::Tolerance { earlier: earlier.tolerance, asked: self.tolerance });
        }
        if earlier.own_tolerances != self.own_tolerances {
            return Err(Difference::OwnTolerances);
        }
        if earlier.events != self.events {
            return Err(Difference::Events { earlier: earlier.events.clone(), asked: self.events.clone() });
        }
        if earlier.errors != self.errors {
            return Err(if earlier.errors { Difference::Errors } else { Difference::NoErrors });
        }
        if earlier.columns != self.columns {
            return Err(Difference::Columns {
                earlier: earlier.columns.clone(),
                asked: self.columns.clone(),
            });
        }
        Ok(())
    }

    pub(super) fn fields() -> Fields<Self> {
        type Of = Field<RunParameters>;
        Fields::from([
            Of::value("system", "", "compared by --resume: key of the system, or null", |parameters| {
                parameters.system.clone().into()
            }),
            Of::value(
                "equations",
                "",
                "equations of motion with the values of all parameters",
                |parameters| parameters.equations.as_str().into(),
            ),
            Of::value("state[]", "", "names of the state variables", |parameters| {
                json::list(parameters.state.clone())
            }),
            Of::value("initial[]", "", "state at t = 0", |parameters| json::numbers(&parameters.initial)),
            Of::value("tolerance", "1", "relative error allowed in each step", |parameters| {
                json::number(parameters.tolerance)
            }),
            Of::present_value(
                "own_tolerances.NAME",
                "1",
                "that in the coordinate of this name; left out where none has its own",
                |parameters| {
                    let tolerances = parameters
                        .own_tolerances
                        .iter()
                        .map(|(name, tolerance)| (name.clone(), json::number(*tolerance)));
                    (!parameters.own_tolerances.is_empty()).then(|| json::object(tolerances))
                },
            ),
            Of::value("events[]", "", "events that are located", |parameters| {
                json::list(parameters.events.clone())
            }),
            Of::value("errors", "", "true if errors of the states are estimated", |parameters| {
                parameters.errors.into()
            }),
            Of::value("columns[]", "", "formulas in addition to the state", |parameters| {
                json::list(parameters.columns.clone())
            }),
        ])
    }

    pub(super) fn from_json(value: &Value) -> Option<Self> {
        let texts = |name: &str| -> Option<Vec<String>> {
            value[name].as_array()?.iter().map(|text| text.as_str().map(str::to_owned)).collect()
        };
        let tolerance_of = |(name, number): (&String, &Value)| Some((name.clone(), number.as_f64()?));
        let own_tolerances = match value["own_tolerances"].as_object() {
            Some(all) => all.iter().map(tolerance_of).collect::<Option<_>>()?,
            None => vec![],
        };
        Some(Self {
            system: value["system"].as_str().map(str::to_owned),
            equations: value["equations"].as_str()?.to_owned(),
            state: texts("state")?,
            initial: value["initial"].as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?,
            tolerance: value["tolerance"].as_f64()?,
            own_tolerances,
            events: texts("events")?,
            errors: value["errors"].as_bool().unwrap_or(false),
            columns: texts("columns").unwrap_or_default(),
        })
    }
}
