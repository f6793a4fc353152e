//! Conditions that are searched for along a motion, from text.

use super::Model;
use libration_numbers::expression::{Expression, ParseError, Symbol};

/// The reason why a text is not a condition that can be searched for.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConditionError {
    /// The text is not a formula.
    #[error(transparent)]
    Formula(#[from] ParseError),
    /// A name that is unknown in the system.
    #[error("the system has no state variable `{name}`: it has {}, and the time t", known.join(", "))]
    Unknown {
        /// The name.
        name: String,
        /// The names of the state variables.
        known: Vec<String>,
    },
}

impl Model {
    /// The formula that vanishes where a condition holds. The condition is a formula of coordinates, velocities, rates, parameters and the time
    /// t, or an equation, `theta = 0.5`; parameters have their values, and those without one stay.
    ///
    /// # Errors
    /// Text that is not a formula; a name that is unknown in the system.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::systems::Model;
    /// let model = Model::typed("x'' + k*x = 0", &[("k", "4".parse()?)], &[])?;
    /// assert_eq!(model.zero_of("x = k/8")?.to_string(), model.zero_of("x - 4/8")?.to_string());
    /// assert!(model.zero_of("y").is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn zero_of(&self, text: &str) -> Result<Expression, ConditionError> {
        // An equation side by side, so that a complaint shows what was written.
        let written = match text.split_once('=') {
            Some((left, right)) => Expression::Subtract(Box::new(left.parse()?), Box::new(right.parse()?)),
            None => text.parse()?,
        };
        let put_in = |formula: Expression, (name, value): &(String, Expression)| {
            formula.substitute(&Symbol::plain(name), value)
        };
        let formula = self.values().iter().fold(written, put_in);
        let names = self.state_names();
        let open = self.equation().parameters();
        let in_state = self.equation().with_rates(&formula);
        let unknown = in_state.symbols().into_iter().map(|symbol| symbol.to_string());
        match unknown.into_iter().find(|name| name != "t" && !names.contains(name) && !open.contains(name)) {
            Some(name) => Err(ConditionError::Unknown { name, known: names }),
            None => Ok(formula),
        }
    }
}
