//! Formulas of the state, to be evaluated along a motion.

use super::Model;
use crate::taylor::{Gradients, Moment};
use libration_numbers::algebra::Doubles;
use libration_numbers::{
    expression::{Expression, Symbol},
    internals::expression::{Jet, Tape},
};

/// Named formulas of coordinates, velocities, rates of change, parameters and the time t.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::systems::{Model, Observables};
/// let model = Model::by_key("pendulum", &[("omega0", "2".parse()?)], &[])?;
/// let energy = "theta'^2/2 - omega0^2*cos(theta)".parse()?;
/// let observables = Observables::new(&model, &[("energy", energy)])?;
/// assert_eq!(observables.values_at(&model.start(&[("theta'", 3.0)])?), [0.5]);
/// assert!(Observables::new(&model, &[("p", "m*theta'".parse()?)]).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Observables {
    names: Vec<String>,
    tape: Tape,
    /// Number of state components.
    components: usize,
}

/// The reason why formulas cannot be evaluated along a motion.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ObservableError {
    /// A symbol that is unknown in the system.
    #[error("{name}: the system has no `{symbol}`: it has {}, and the time t", known.join(", "))]
    Unknown {
        /// The formula's name.
        name: String,
        /// The symbol.
        symbol: String,
        /// State variables and parameters.
        known: Vec<String>,
    },
    /// Two formulas of one name, or one whose name is that of a state variable or the time.
    #[error("the name {0} is in use already: give each formula a new name, such as energy = x'^2/2")]
    NameTaken(String),
}

impl Observables {
    /// The formulas, compiled for the motions of a system.
    ///
    /// # Errors
    /// A symbol that is unknown in the system, or a name that is in use.
    pub fn new(model: &Model, formulas: &[(&str, Expression)]) -> Result<Self, ObservableError> {
        let states = model.state_names();
        let mut names: Vec<String> = vec![];
        let mut in_state = vec![];
        for (name, formula) in formulas {
            let taken = states.iter().chain(&names).any(|other| other == name);
            if taken || matches!(*name, "t" | "time" | "event") {
                return Err(ObservableError::NameTaken((*name).to_owned()));
            }
            names.push((*name).to_owned());
            in_state.push(in_numbers(model, name, formula)?);
        }
        let inputs = model.layout().symbols(model.equation().variables());
        let inputs: Vec<Symbol> = inputs.into_iter().chain([Symbol::plain("t")]).collect();
        let tape = Tape::new(&in_state.iter().collect::<Vec<_>>(), &inputs).map_err(|error| {
            ObservableError::Unknown { name: names.join(", "), symbol: error.0, known: states }
        })?;
        Ok(Self { names, tape, components: inputs.len() - 1 })
    }

    /// The names of the formulas.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The formulas with their derivatives, for the errors of their values: [`StateErrors::with_formulas`](crate::taylor::StateErrors::with_formulas).
    #[must_use]
    pub fn gradients(&self) -> Gradients {
        Gradients::new(&self.tape, self.names.len(), self.components)
    }

    /// The values of the formulas; NaN if a formula has none.
    #[must_use]
    pub fn values_at(&self, moment: &Moment) -> Vec<f64> {
        let inputs = [&moment.state[..], &[moment.time]].concat();
        match Jet::new(&Doubles, &self.tape, &inputs) {
            Ok(jet) => (0..self.names.len()).map(|formula| jet.result(formula)[0]).collect(),
            Err(_) => vec![f64::NAN; self.names.len()],
        }
    }
}

/// The formula with the values of the parameters substituted: a function of the state and the time alone.
fn in_numbers(model: &Model, name: &str, formula: &Expression) -> Result<Expression, ObservableError> {
    let put_in = |formula: Expression, (name, value): &(String, Expression)| {
        formula.substitute(&Symbol::plain(name), value)
    };
    let formula = model.values().iter().fold(formula.clone(), put_in);
    let rates = model.equation().own_derivatives().zip(model.equation().derivatives());
    let formula = rates.fold(formula, |formula, (derivative, rate)| formula.substitute(&derivative, rate));
    let states = model.state_names();
    let symbols = formula.symbols().into_iter().map(|symbol| symbol.to_string());
    match symbols.into_iter().find(|symbol| symbol != "t" && !states.contains(symbol)) {
        None => Ok(formula),
        Some(symbol) => {
            let parameters = model.values().iter().map(|(name, _)| name.clone());
            let names = states.into_iter().chain(parameters).collect();
            Err(ObservableError::Unknown { name: name.to_owned(), symbol, known: names })
        }
    }
}
