//! Prints the results of this machine, one number of 16 hexadecimal digits on each line.

use libration_wasm32::{Failure, answers, sum_of_angles, sum_of_periods};
use std::io::Write;
use std::time::Instant;

fn main() -> Result<(), Failure> {
    let mut output = std::io::stdout().lock();
    if std::env::args().nth(1).as_deref() == Some("--times") {
        for (name, sum) in
            [("periods", sum_of_periods as extern "C" fn(u32) -> f64), ("angles", sum_of_angles)]
        {
            let begin = Instant::now();
            let sum = sum(1_000_000);
            writeln!(output, "{name} {} {:016x}", begin.elapsed().as_secs_f64() * 1e3, sum.to_bits())?;
        }
        return Ok(());
    }
    for answer in answers()? {
        writeln!(output, "{:016x}", answer.to_bits())?;
    }
    Ok(())
}
