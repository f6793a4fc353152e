//! Numbers as text: exact for machines, rounded for people.

use libration::quantity::Quantity;
pub(crate) use libration::quantity::{rounded, short, to_place, with_uncertainty};

/// A number of items as an `f64`.
#[expect(clippy::cast_precision_loss, reason = "nothing in memory has 2⁵³ parts")]
pub fn count(things: usize) -> f64 {
    things as f64
}

/// The shortest decimal that reads back as the same number; `nan`, `inf` and `-inf` otherwise.
pub fn exact(value: f64) -> String {
    serde_json::Number::from_f64(value).map_or_else(|| rounded(value, 1), |number| number.to_string())
}

/// [`exact`] of a finite number, appended to a text.
pub fn write_exact(text: &mut Vec<u8>, value: f64) {
    serde_json::to_writer(text, &value).expect("a number can be written to memory");
}

/// `1.637 ± 0.002 s`, or without an uncertainty if none is known.
pub(crate) fn quantity(quantity: impl Into<Quantity>, unit: &str) -> String {
    let quantity = quantity.into();
    with_uncertainty(quantity.value, quantity.uncertainty.unwrap_or(0.0), unit)
}

/// A time in seconds, rounded; `none` if there is no such time.
pub(crate) fn seconds(value: f64, digits: usize) -> String {
    if value.is_nan() { "none".to_owned() } else { format!("{} s", rounded(value, digits)) }
}

/// An uncertainty or a bound to one digit, which is not below it: `5e-13` for 4.1e-13.
pub fn at_most(value: f64) -> String {
    let nearest = format!("{value:.0e}");
    match (nearest.parse::<f64>(), nearest.split_once('e')) {
        (Ok(shown), Some((_, exponent))) if shown < value => {
            let last_digit = format!("1e{exponent}").parse().unwrap_or(0.0);
            rounded(shown + last_digit, 1)
        }
        _ => rounded(value, 1),
    }
}

/// A value rounded to the first digit of its error, with at most `most` digits: `24.4` for 24.40126 with an error of 0.3; `0` if the error is
/// larger than the value.
pub fn to_its_error(value: f64, error: f64, most: usize) -> String {
    let exponent =
        format!("{error:e}").split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    match exponent.filter(|_| error > 0.0) {
        Some(exponent) => to_place(value, exponent, most),
        None => rounded(value, most),
    }
}
