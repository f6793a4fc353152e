//! Numbers in the notation of printed results.

/// The number rounded to this many significant digits; with a power of ten if very small or very large; `nan`, `inf` or `-inf` if not finite.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::rounded;
/// assert_eq!(rounded(2.006409292589, 5), "2.0064");
/// ```
#[must_use]
pub fn rounded(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return non_finite(value).to_owned();
    }
    // Adding zero turns minus zero into zero.
    let value = value + 0.0;
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let exponent: i32 = scientific.split_once('e').and_then(|(_, text)| text.parse().ok()).unwrap_or(0);
    if value != 0.0 && !(-5..=8).contains(&exponent) {
        return scientific;
    }
    let last_place = i32::try_from(digits).unwrap_or(i32::MAX).saturating_sub(1).saturating_sub(exponent);
    format!("{value:.*}", usize::try_from(last_place).unwrap_or(0))
}

/// The number rounded to this many significant digits, without trailing zeros: `60` rather than `60.0000`.
#[must_use]
pub fn short(value: f64, digits: usize) -> String {
    let text = rounded(value, digits);
    let (mantissa, exponent) =
        text.split_once('e').map_or((text.as_str(), ""), |(m, _)| (m, &text[m.len()..]));
    if !mantissa.contains('.') {
        return text;
    }
    format!("{}{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
}

/// `1.637 ± 0.002 s`, to two digits of the uncertainty; an uncertainty that is not finite is reported as such.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::with_uncertainty;
/// assert_eq!(with_uncertainty(1.63712, 0.00234, "s"), "1.6371 ± 0.0023 s");
/// ```
#[must_use]
pub fn with_uncertainty(value: f64, uncertainty: f64, unit: &str) -> String {
    let text = match places(uncertainty) {
        _ if !uncertainty.is_finite() => format!("{} ± {} {unit}", short(value, 6), non_finite(uncertainty)),
        Some(decimals) => format!("{value:.decimals$} ± {uncertainty:.decimals$} {unit}"),
        None if uncertainty > 0.0 => {
            let decimal_place = exponent(uncertainty) - 1;
            format!(
                "{} ± {} {unit}",
                to_place(value, decimal_place, 12),
                to_place(uncertainty, decimal_place, 2)
            )
        }
        None => format!("{} {unit}", short(value, 12)),
    };
    text.trim_end().to_owned()
}

/// The number rounded to the decimal place 10ᵏ, and to at most this many significant digits; 0 if the number is less than half of 10ᵏ.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::to_place;
/// assert_eq!(to_place(24.40126, -1, 15), "24.4");
/// assert_eq!(to_place(138.9, 14, 15), "0");
/// ```
#[must_use]
pub fn to_place(value: f64, power: i32, most: usize) -> String {
    if !value.is_finite() {
        return non_finite(value).to_owned();
    }
    let first = format!("{value:e}").split_once('e').and_then(|(_, text)| text.parse().ok()).unwrap_or(0);
    let digits = usize::try_from(i64::from(first) - i64::from(power) + 1);
    let nearest = match digits {
        Ok(digits @ 1..) => format!("{value:.*e}", digits.min(most) - 1),
        // The first digit is one place below 10ᵏ: from 5 on it rounds up to 10ᵏ.
        Ok(_) if format!("{:e}", value.abs()).as_str() >= "5" => {
            format!("{}1e{power}", if value < 0.0 { "-" } else { "" })
        }
        _ => return "0".to_owned(),
    };
    rounded(nearest.parse().unwrap_or(value), digits.unwrap_or(1).clamp(1, most))
}

/// The power of ten of the first of two digits.
fn exponent(value: f64) -> i32 {
    format!("{value:.1e}").split_once('e').and_then(|(_, text)| text.parse().ok()).unwrap_or(0)
}

/// The decimal places for two digits of an uncertainty; `None` if these would be too many, or if digits before the decimal point would be
/// rounded.
fn places(uncertainty: f64) -> Option<usize> {
    const MOST: usize = 10;
    let decimals = usize::try_from(1 - exponent(uncertainty)).ok()?;
    (uncertainty > 0.0 && decimals <= MOST).then_some(decimals)
}

fn non_finite(value: f64) -> &'static str {
    match value {
        value if value.is_nan() => "nan",
        value if value > 0.0 => "inf",
        _ => "-inf",
    }
}
