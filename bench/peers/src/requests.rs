//! Requests of `motion.py` to a program, and the responses.
//!
//! A request is a line `CASE TOLERANCE END COUNT`, then COUNT lines with the components of a state at t = 0: angles, then velocities. The
//! response is a line `SECONDS STEPS SET-UP` (processor seconds of the integrations, their number of steps, processor seconds spent beforehand),
//! then COUNT lines with the states at END.

use std::error::Error;
use std::io::{self, Write};
use std::str::SplitWhitespace;
use std::{fs, str::FromStr};

pub(crate) type Failure = Box<dyn Error>;

/// Motions of one system to be integrated.
#[derive(Debug)]
pub(crate) struct Request {
    pub(crate) case: String,
    pub(crate) tolerance: f64,
    pub(crate) end: f64,
    pub(crate) starts: Vec<Vec<f64>>,
}

/// Result of the integrations.
#[derive(Debug, Default)]
pub(crate) struct Answer {
    pub(crate) seconds: f64,
    pub(crate) set_up: f64,
    pub(crate) steps: usize,
    pub(crate) states: Vec<Vec<f64>>,
}

/// Serves requests until the input ends.
pub(crate) fn serve(mut answer: impl FnMut(&Request) -> Result<Answer, Failure>) -> Result<(), Failure> {
    while let Some(request) = next_request()? {
        let answer = answer(&request)?;
        let mut out = io::stdout().lock();
        writeln!(out, "{:?} {} {:?}", answer.seconds, answer.steps, answer.set_up)?;
        for state in &answer.states {
            let words: Vec<String> = state.iter().map(|value| format!("{value:?}")).collect();
            writeln!(out, "{}", words.join(" "))?;
        }
        out.flush()?;
    }
    Ok(())
}

fn next_request() -> Result<Option<Request>, Failure> {
    let line = next_line()?;
    if line.is_empty() {
        return Ok(None);
    }
    let mut words = line.split_whitespace();
    let case = next(&mut words)?;
    let (tolerance, end) = (next(&mut words)?, next(&mut words)?);
    let count = next(&mut words)?;
    let starts = (0..count).map(|_| numbers(&next_line()?)).collect::<Result<_, _>>()?;
    Ok(Some(Request { case, tolerance, end, starts }))
}

fn next_line() -> io::Result<String> {
    let mut line = String::new();
    io::stdin().read_line(&mut line)?;
    Ok(line)
}

fn next<T: FromStr>(words: &mut SplitWhitespace) -> Result<T, Failure>
where
    T::Err: Error + 'static,
{
    Ok(words.next().ok_or("a request is a line CASE TOLERANCE END COUNT")?.parse()?)
}

fn numbers(line: &str) -> Result<Vec<f64>, Failure> {
    Ok(line.split_whitespace().map(str::parse).collect::<Result<_, _>>()?)
}

/// Runs a task and adds to a sum the time that this process, which has one thread, has spent on it (Linux).
pub(crate) fn timed<T>(seconds: &mut f64, task: impl FnOnce() -> T) -> Result<T, Failure> {
    let start = processor_seconds()?;
    let result = task();
    *seconds += processor_seconds()? - start;
    Ok(result)
}

/// `yield_now` updates the count of processor time, which otherwise waits for the next clock tick.
fn processor_seconds() -> Result<f64, Failure> {
    std::thread::yield_now();
    let times = fs::read_to_string("/proc/self/schedstat")?;
    let nanoseconds: f64 = times.split_whitespace().next().ok_or("no time in schedstat")?.parse()?;
    Ok(nanoseconds * 1e-9)
}
