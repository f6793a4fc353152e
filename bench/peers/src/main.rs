//! The part of libration in the comparison: keeps the arrays that `run.py` sends and times one pass over them on request.
//!
//! Requests are lines on standard input; responses go to standard output.
//! - `amplitudes N`, `times N` or `parameters N`, followed by N binary `f64`, keeps an array (no response).
//! - `period`, `motion THETA0`, `prepared THETA0` and `varying`, and for the parameters `first` (K), `second` (E), `incomplete_first` (of the
//!   amplitudes), `incomplete_second` and `jacobi` (of the times), make one pass and print its nanoseconds in a line.
//! - `angles` returns the first output of the last pass (sn for `jacobi`), as binary `f64`.

mod elliptic;
mod work;

use std::io::{self, BufRead, Read, Write};
use work::{Failure, Work};

fn main() -> Result<(), Failure> {
    let (mut input, mut output) = (io::stdin().lock(), io::stdout().lock());
    let mut work = Work::default();
    let mut line = String::new();
    while input.read_line(&mut line)? > 0 {
        answer(line.trim(), &mut work, &mut input, &mut output)?;
        output.flush()?;
        line.clear();
    }
    Ok(())
}

fn answer(
    request: &str,
    work: &mut Work,
    input: &mut impl Read,
    output: &mut impl Write,
) -> Result<(), Failure> {
    let (verb, argument) = request.split_once(' ').unwrap_or((request, ""));
    match verb {
        "amplitudes" => work.amplitudes = numbers(argument, input)?,
        "times" => work.times = numbers(argument, input)?,
        "parameters" => work.parameters = numbers(argument, input)?,
        "period" => writeln!(output, "{}", work.period()?.as_nanos())?,
        "motion" => writeln!(output, "{}", work.motion(argument.parse()?)?.as_nanos())?,
        "prepared" => writeln!(output, "{}", work.prepared(argument.parse()?)?.as_nanos())?,
        "varying" => writeln!(output, "{}", work.varying()?.as_nanos())?,
        "first" => writeln!(output, "{}", work.complete_firsts()?.as_nanos())?,
        "second" => writeln!(output, "{}", work.complete_seconds()?.as_nanos())?,
        "incomplete_first" => writeln!(output, "{}", work.incomplete_firsts()?.as_nanos())?,
        "incomplete_second" => writeln!(output, "{}", work.incomplete_seconds()?.as_nanos())?,
        "jacobi" => writeln!(output, "{}", work.jacobi()?.as_nanos())?,
        "angles" => work.angles.iter().try_for_each(|angle| output.write_all(&angle.to_le_bytes()))?,
        _ => return Err(Failure::Request(request.to_owned())),
    }
    Ok(())
}

fn numbers(count: &str, input: &mut impl Read) -> Result<Vec<f64>, Failure> {
    let mut bytes = vec![0; 8 * count.parse::<usize>()?];
    input.read_exact(&mut bytes)?;
    Ok(bytes.as_chunks().0.iter().map(|chunk| f64::from_le_bytes(*chunk)).collect())
}
