//! Our side of `bench/peers/series`: `libration-series CASE ORDER` times one case at one order and prints
//! `{"case", "order", "seconds": [passes], "check": [last coefficients]}`, with `null` seconds for a case that the
//! library does not offer alone.

use libration::algebra::Rational;
use libration::oscillator::NamedOscillator;
use libration::period_formulas::period_in_amplitude;
use libration::perturbation::{Gauge, expand};
use std::error::Error;
use std::io::{self, Write};
use std::{env, fs};

/// A pass lasts at least this long.
const PASS_SECONDS: f64 = 0.02;
const PASSES: usize = 7;
/// A task slower than this is timed once.
const SLOW_SECONDS: f64 = 2.0;

type Task = Box<dyn Fn() -> Result<Vec<Rational>, Box<dyn Error>>>;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let case = arguments.next().unwrap_or_default();
    let order = arguments.next().unwrap_or_default().parse()?;
    let (seconds, check) = match task(&case, order)? {
        Some(task) => passes(&task)?,
        None => (None, vec![]),
    };
    let seconds = seconds.map_or_else(|| "null".to_owned(), |seconds| format!("{seconds:?}"));
    let check: Vec<String> = check.iter().map(Rational::to_string).collect();
    writeln!(
        io::stdout(),
        r#"{{"case": "{case}", "order": {order}, "seconds": {seconds}, "check": {check:?}}}"#
    )?;
    Ok(())
}

/// The task of a case, which ends in the last coefficients that the other tools give.
fn task(case: &str, order: usize) -> Result<Option<Task>, Box<dyn Error>> {
    Ok(match case {
        "pendulum, full answer" => Some(of_amplitude("pendulum", order)?),
        "duffing, full answer" => Some(of_amplitude("duffing", order)?),
        "van_der_pol" => {
            let oscillator = NamedOscillator::by_key("van_der_pol")?.oscillator(&[])?;
            Some(Box::new(move || {
                let cycle = expand(&oscillator, order, &Gauge::Fundamental)?;
                let amplitude = cycle.harmonic(1).ok_or("there is no first harmonic")?;
                Ok(vec![cycle.frequency_ratio[order].clone(), amplitude.cos[order - 2].clone()])
            }))
        }
        "period" => Some(Box::new(move || Ok(period_in_amplitude(order / 2).pop().into_iter().collect()))),
        _ => None,
    })
}

/// Ω at A^(N − 1) and a₃ at A^N, for odd N.
fn of_amplitude(key: &str, order: usize) -> Result<Task, Box<dyn Error>> {
    let oscillator = NamedOscillator::by_key(key)?.oscillator(&[])?;
    let order = order - 1 + order % 2;
    Ok(Box::new(move || {
        let expansion = expand(&oscillator, order, &Gauge::Fundamental)?;
        let of = expansion.of_amplitude.ok_or("there is no amplitude")?;
        let third = of.harmonics.iter().find(|(k, _)| *k == 3).ok_or("there is no third harmonic")?;
        Ok(vec![of.frequency_ratio[order - 1].clone(), third.1[order].clone()])
    }))
}

/// The seconds of the passes and the last coefficients.
type Timed = (Option<Vec<f64>>, Vec<Rational>);

/// Processor seconds of the passes, each a mean over runs, after one pass for warming up; of a slow task that pass.
fn passes(task: &Task) -> Result<Timed, Box<dyn Error>> {
    let start = processor_seconds()?;
    let check = task()?;
    let once = processor_seconds()? - start;
    if once > SLOW_SECONDS {
        return Ok((Some(vec![once]), check));
    }
    let runs = runs_per_pass(task)?;
    let mut seconds = vec![];
    for _ in 0..PASSES {
        let start = processor_seconds()?;
        for _ in 0..runs {
            std::hint::black_box(task()?);
        }
        seconds.push((processor_seconds()? - start) / f64::from(runs));
    }
    Ok((Some(seconds), check))
}

/// As many runs as make [`PASS_SECONDS`].
fn runs_per_pass(task: &Task) -> Result<u32, Box<dyn Error>> {
    let mut runs = 1;
    loop {
        let start = processor_seconds()?;
        for _ in 0..runs {
            std::hint::black_box(task()?);
        }
        if processor_seconds()? - start >= PASS_SECONDS {
            return Ok(runs);
        }
        runs *= 2;
    }
}

/// Time that this process, which has one thread, has spent on a processor (Linux).
fn processor_seconds() -> Result<f64, Box<dyn Error>> {
    let times = fs::read_to_string("/proc/self/schedstat")?;
    let nanoseconds: f64 = times.split_whitespace().next().ok_or("no time in schedstat")?.parse()?;
    Ok(nanoseconds * 1e-9)
}
