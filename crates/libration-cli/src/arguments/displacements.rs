//! Amplitudes of any coordinate: `0.1:3:0.1` or `0.5,1`, and with units where the coordinate is an angle.

use crate::failure::Failure;
use crate::output::number;
use libration::quantity::{AngleRange, Dimension, RangeError, angles, numbers};

/// Reads a list or a range of amplitudes above zero.
pub(crate) fn displacements(argument: &str, text: &str, is_angle: bool) -> Result<Vec<f64>, Failure> {
    let refusal = |reason: String| Failure::usage(argument, reason);
    if !is_angle
        && text.contains(|letter: char| letter.is_alphabetic() && !"eE".contains(letter) || letter == '°')
    {
        return Err(refusal(format!(
            "`{}`: give numbers, such as 0.5,1 or 0.1:3:0.1; units of angles are for variables named as angles are, such as theta",
            text.trim()
        )));
    }
    let values = match is_angle {
        true => read(text).map_err(|error| refusal(error.to_string()))?,
        // Units having been refused, any dimension will do.
        false => numbers(text, Dimension::Length)
            .map_err(|_| refusal(format!("`{}`: give numbers, such as 0.5,1 or 0.1:3:0.1", text.trim())))?,
    };
    match values.iter().find(|value| **value <= 0.0) {
        Some(value) => {
            Err(refusal(format!("{} is no amplitude: give numbers above zero", number::exact(*value))))
        }
        None => Ok(values),
    }
}

/// A bare number is a number of radians.
fn read(text: &str) -> Result<Vec<f64>, RangeError> {
    let radians = |angle: libration::quantity::Angle| angle.radians();
    let read = match text.contains(':') {
        true => AngleRange::parse(text)?.iter().map(radians).collect(),
        false => angles(text)?.into_iter().map(radians).collect(),
    };
    super::bare::say(text);
    Ok(read)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_and_ranges_are_read() {
        assert_eq!(displacements("", "0.1:0.3:0.1", false).unwrap(), [0.1, 0.2, 0.3]);
        assert_eq!(displacements("", "90deg,2rad", true).unwrap(), [std::f64::consts::FRAC_PI_2, 2.0]);
        assert_eq!(displacements("", "1e-3, 1e8", false).unwrap(), [1e-3, 1e8]);
        for text in ["1deg", "0:1:0.1", "-1", "a", ""] {
            assert!(displacements("--amplitudes", text, false).is_err(), "{text}");
        }
    }
}
