//! The rows of all traces with the fitted motion.

use super::answer::Answer;
use crate::output::{csv, number};
use std::io::{self, Write};

/// One line for each row: trace, time, what was seen, what should have been seen, the difference.
pub(super) fn write(out: &mut dyn Write, answer: &Answer<'_>) -> io::Result<()> {
    csv::line(out, &["trace", "time_s", "value", "fitted", "residual"])?;
    for (trace, fitted) in answer.measured.traces.iter().zip(&answer.swings.fit.traces) {
        for row in 0..trace.len() {
            let numbers =
                [trace.times()[row], trace.values()[row], fitted.fitted[row], fitted.residuals[row]];
            let numbers = numbers.map(number::exact);
            csv::line(out, &[&[trace.name().to_owned()], &numbers[..]].concat())?;
        }
    }
    Ok(())
}
