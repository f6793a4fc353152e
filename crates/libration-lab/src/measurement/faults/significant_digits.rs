//! Times written with a number of significant digits, as tables on a screen show them: 0.0333, 0.0667, …, 10.0, 10.1.

/// Largest number of digits that may be a rounding: more digits resolve the frames of a video, since 99.999 has steps of a thousandth. With 4 and 8
/// nothing changed in 106 recordings (`clock.rs`); with 3 times of four digits were not equally spaced.
const MOST: usize = 5;

/// Number of significant digits that all times have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SignificantDigits {
    /// Number of digits.
    pub count: usize,
    /// Power of ten of the first digit of the smallest time that is not zero.
    smallest: i32,
}

impl SignificantDigits {
    /// The smallest number of digits that represents all times, if it gives the largest time a coarser step than their common decimal step.
    pub fn detect(times: &[f64], resolution: Option<f64>) -> Option<Self> {
        let sizes = || times.iter().map(|time| time.abs()).filter(|&time| time > 0.0);
        let (smallest, largest) = (sizes().reduce(f64::min)?, sizes().reduce(f64::max)?);
        let count = (1..=MOST).find(|&count| times.iter().all(|&time| is_written_with(count, time)))?;
        let digits = Self { count, smallest: exponent(smallest) };
        (digits.step_at(largest) > 1.5 * resolution.unwrap_or(0.0)).then_some(digits)
    }

    /// The step of the last digit of this time; for zero, that of the smallest other time.
    pub fn step_at(self, time: f64) -> f64 {
        let first = if time == 0.0 { self.smallest } else { exponent(time.abs()) };
        let digits_after = i32::try_from(self.count - 1).unwrap_or(i32::MAX);
        libm::exp10(f64::from(first - digits_after))
    }
}

fn is_written_with(digits: usize, time: f64) -> bool {
    let rounded = format!("{time:.*e}", digits - 1).parse::<f64>().unwrap_or(f64::NAN);
    // The last bits of a time may come from a change of units.
    (rounded - time).abs() <= 1e-12 * time.abs()
}

/// Power of ten of the first digit.
fn exponent(size: f64) -> i32 {
    let text = format!("{size:e}");
    text.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0)
}
