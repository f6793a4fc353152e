//! Amplitudes of any coordinate: `0.1:3:0.1` or `0.5,1`, and with units where the coordinate is an angle.

use crate::output::number;
use crate::query_error::{Parameter, QueryError};
use libration::quantity::{Displacement, RangeError, exact_angles, exact_numbers};

/// Reads a list or a range of amplitudes above zero.
pub fn displacements(
    argument: &Parameter,
    text: &str,
    is_angle: bool,
) -> Result<Vec<Displacement>, QueryError> {
    let refusal = |reason: String| QueryError::usage(argument, reason);
    if !is_angle
        && text.contains(|letter: char| letter.is_alphabetic() && !"eE".contains(letter) || letter == '°')
    {
        return Err(refusal(format!(
            "`{}`: give plain numbers, such as 0.5,1 or 0.1:3:0.1; angle units are for variables with the name of an angle, such as theta",
            text.trim()
        )));
    }
    let values = match is_angle {
        true => read(text).map_err(|error| refusal(error.to_string()))?,
        false => exact_numbers(text)
            .map_err(|_| refusal(format!("`{}`: give numbers, such as 0.5,1 or 0.1:3:0.1", text.trim())))?,
    };
    match values.iter().map(Displacement::to_f64).find(|value| *value <= 0.0) {
        Some(value) => {
            Err(refusal(format!("the amplitude is {}: give numbers above zero", number::exact(value))))
        }
        None => Ok(values),
    }
}

/// A bare number is a number of radians.
fn read(text: &str) -> Result<Vec<Displacement>, RangeError> {
    let read = exact_angles(text)?;
    super::bare::say(text);
    Ok(read)
}
