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

/// The formula that vanishes where a condition holds: the condition itself, or the difference of the sides of an equation, `theta = 0.5`; where
/// the right one is zero, the left one.
///
/// # Errors
/// Text that is not a formula, or a side that is not one, which the complaint shows as it was written.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::systems::condition;
/// assert_eq!(condition("theta = 1/2")?.to_string(), "theta - 1/2");
/// assert_eq!(condition("theta = 0")?.to_string(), "theta");
/// assert!(condition("theta = 1 +").is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn condition(text: &str) -> Result<Expression, ParseError> {
    let Some((left, right)) = text.split_once('=') else { return text.parse() };
    let (left, right): (Expression, Expression) = (left.parse()?, right.parse()?);
    if right == Expression::from(0) {
        Ok(left)
    } else {
        Ok(Expression::Subtract(Box::new(left), Box::new(right)))
    }
}

impl Model {
    /// The formula that vanishes where a [`condition`] of coordinates, velocities, rates, parameters and the time t holds; parameters have their
    /// values, and those without one stay.
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
        let put_in = |formula: Expression, (name, value): &(String, Expression)| {
            formula.substitute(&Symbol::plain(name), value)
        };
        let formula = self.values().iter().fold(condition(text)?, put_in);
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
