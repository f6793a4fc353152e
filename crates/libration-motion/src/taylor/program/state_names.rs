//! States given by the names of their components.

/// The reason why names and values do not form a state.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum StateNameError {
    /// A name that is not a state component.
    #[error("the state has no variable `{name}`: it has {}", known.join(", "))]
    Unknown {
        /// The requested name.
        name: String,
        /// The names of all components.
        known: Vec<String>,
    },
    /// A name with two values.
    #[error("{name} is given twice: give it one value")]
    Twice {
        /// The name.
        name: String,
    },
}

/// A state in which some components are replaced by others, given by their names.
#[doc(hidden)]
pub fn named_state(
    names: &[String],
    mut state: Vec<f64>,
    values: &[(&str, f64)],
) -> Result<Vec<f64>, StateNameError> {
    for (number, (name, value)) in values.iter().enumerate() {
        if values[..number].iter().any(|(earlier, _)| earlier == name) {
            return Err(StateNameError::Twice { name: (*name).to_owned() });
        }
        let unknown = || StateNameError::Unknown { name: (*name).to_owned(), known: names.to_vec() };
        let index = names.iter().position(|other| other == name).ok_or_else(unknown)?;
        state[index] = *value;
    }
    Ok(state)
}
