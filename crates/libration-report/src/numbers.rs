//! Numbers as axes and descriptions print them.

/// Formats a value with the digits that distinguish multiples of the step; with a power of ten if `largest` is very large or small.
pub fn of_steps(value: f64, step: f64, largest: f64) -> String {
    if value.abs() < 1e-6 * step {
        return "0".to_owned();
    }
    let (top, last) = (exponent(largest), exponent(1.000_001 * step));
    if (-4..6).contains(&top) {
        return signed(&format!("{value:.*}", places(-last)));
    }
    let mantissa = value / 10f64.powi(top);
    let mantissa = signed(&format!("{mantissa:.*}", places(top - last)));
    format!("{mantissa}×{}", power_of_ten(top))
}

/// A number in a sentence.
pub fn short(value: f64) -> String {
    let step = 10f64.powi(exponent(value) - 3);
    let text = of_steps(value, step, value);
    match text.split_once('×') {
        Some((mantissa, power)) => format!("{}×{power}", trimmed(mantissa)),
        None => trimmed(&text).to_owned(),
    }
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// 10⁻⁴ for −4, 10⁰ for 0.
pub fn power_of_ten(exponent: i32) -> String {
    let raised = exponent
        .to_string()
        .chars()
        .map(|digit| match digit {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            digit => digit.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(digit),
        })
        .collect::<String>();
    format!("10{raised}")
}

fn signed(text: &str) -> String {
    text.replace('-', "−")
}

/// Largest number of decimal places of an `f64`.
fn places(count: i32) -> usize {
    const MOST: i32 = 17;
    usize::try_from(count.clamp(0, MOST)).unwrap_or(0)
}

#[expect(clippy::cast_possible_truncation, reason = "exponents of an f64 are below 400")]
fn exponent(value: f64) -> i32 {
    let power = value.abs().log10().floor();
    if power.is_finite() { power as i32 } else { 0 }
}
