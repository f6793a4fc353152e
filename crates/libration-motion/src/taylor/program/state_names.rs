//! States given by the names of their numbers.

/// A name that is not one of the state.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum StateNameError {
    /// A name that the state does not have.
    #[error("the state has no variable `{name}`: it has {}", known.join(", "))]
    Unknown {
        /// The requested name.
        name: String,
        /// The names there are.
        known: Vec<String>,
    },
    /// A name with two values.
    #[error("{name} is given twice: give it one value")]
    Twice {
        /// The name.
        name: String,
    },
}

/// A state with some numbers in the place of others, by their names.
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
        let place = names.iter().position(|known| known == name).ok_or_else(unknown)?;
        state[place] = *value;
    }
    Ok(state)
}
