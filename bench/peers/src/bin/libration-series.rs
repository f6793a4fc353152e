//! The part of libration in `bench/peers/series`. `libration-series CASE ORDER` times one case at one order and prints `{"case", "order",
//! "seconds": [passes], "check": [last coefficients]}`, with `null` seconds for a case that the library does not offer alone.

use libration::algebra::{LaurentPolynomial, Rational};
use libration::oscillator::{NamedOscillator, SymbolicOscillator};
use libration::period_formulas::period_in_amplitude;
use libration::perturbation::{Gauge, expand, expand_symbolically};
use libration::progress::Quiet;
use std::error::Error;
use std::io::{self, Write};
use std::{env, fs};

/// Least duration of a pass.
const PASS_SECONDS: f64 = 0.02;
const PASSES: usize = 7;
/// A task slower than this is timed once.
const SLOW_SECONDS: f64 = 2.0;

type Task = Box<dyn Fn() -> Result<Vec<String>, Box<dyn Error>>>;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let case = arguments.next().unwrap_or_default();
    let order = arguments.next().unwrap_or_default().parse()?;
    let (seconds, check) = match task(&case, order)? {
        Some(task) => passes(&task)?,
        None => (None, vec![]),
    };
    let seconds = seconds.map_or_else(|| "null".to_owned(), |seconds| format!("{seconds:?}"));
    writeln!(
        io::stdout(),
        r#"{{"case": "{case}", "order": {order}, "seconds": {seconds}, "check": {check:?}}}"#
    )?;
    Ok(())
}

/// The task of a case; its output is the last coefficients, which are compared with the other tools.
fn task(case: &str, order: usize) -> Result<Option<Task>, Box<dyn Error>> {
    Ok(match case {
        "pendulum, full answer" => Some(of_amplitude("pendulum", order)?),
        "duffing, full answer" => Some(of_amplitude("duffing", order)?),
        "van_der_pol" => {
            let oscillator = NamedOscillator::by_key("van_der_pol")?.oscillator(&[])?;
            Some(Box::new(move || {
                let cycle = expand(&oscillator, order, &Gauge::Fundamental, &Quiet)?;
                let amplitude = cycle.harmonic(1).ok_or("there is no first harmonic")?;
                Ok(texts([&cycle.frequency_ratio[order], &amplitude.cos[order - 2]]))
            }))
        }
        "period" => Some(Box::new(move || Ok(texts(period_in_amplitude(order / 2).last())))),
        "mixed, letters" => {
            let equation = "x'' + w^2*x + a*x^2 + b*x^3 = 0".parse()?;
            Some(Box::new(move || {
                let oscillator = SymbolicOscillator::new(&equation)?;
                let expansion = expand_symbolically(&oscillator, order, &Gauge::Fundamental, &Quiet)?.series;
                let frequency = ("frequency".to_owned(), &expansion.frequency_ratio);
                let harmonics = expansion.harmonics.iter().map(|it| (format!("cos {}", it.k), &it.cos));
                Ok(std::iter::once(frequency)
                    .chain(harmonics)
                    .flat_map(|(name, series)| all(&name, series))
                    .collect())
            }))
        }
        _ => None,
    })
}

fn texts<'a>(numbers: impl IntoIterator<Item = &'a Rational>) -> Vec<String> {
    numbers.into_iter().map(Rational::to_string).collect()
}

/// All nonzero coefficients of a series; each term as the powers of a, b and w with its factor.
fn all(name: &str, series: &[LaurentPolynomial]) -> Vec<String> {
    let present = series.iter().enumerate().filter(|(_, coefficient)| !coefficient.is_zero());
    present.map(|(n, coefficient)| format!("{name} {n}: {}", terms(coefficient))).collect()
}

fn terms(coefficient: &LaurentPolynomial) -> String {
    let mut terms: Vec<_> = coefficient.terms().collect();
    let power = |powers: &[libration::algebra::LetterPower<'_>], letter: &str| {
        powers.iter().find(|it| it.letter == letter).map_or(0.0, |it| it.exponent.to_f64())
    };
    terms.sort_by(|(_, one), (_, other)| {
        let differences = ["a", "b"].map(|letter| power(one, letter).total_cmp(&power(other, letter)));
        differences[0].then(differences[1])
    });
    let term = |(factor, powers): (&Rational, Vec<_>)| {
        let powers = ["a", "b", "w"].map(|letter| power(&powers, letter).to_string());
        format!("{} {factor}", powers.join(" "))
    };
    terms.into_iter().map(term).collect::<Vec<_>>().join(", ")
}

/// Ω at A^(N − 1) and a₃ at A^N, for odd N.
fn of_amplitude(key: &str, order: usize) -> Result<Task, Box<dyn Error>> {
    let oscillator = NamedOscillator::by_key(key)?.oscillator(&[])?;
    let order = order - 1 + order % 2;
    Ok(Box::new(move || {
        let expansion = expand(&oscillator, order, &Gauge::Fundamental, &Quiet)?;
        let of = expansion.of_amplitude.ok_or("there is no amplitude")?;
        let third = of.harmonics.iter().find(|(k, _)| *k == 3).ok_or("there is no third harmonic")?;
        Ok(texts([&of.frequency_ratio[order - 1], &third.1[order]]))
    }))
}

/// The seconds of the passes and the last coefficients.
type Timed = (Option<Vec<f64>>, Vec<String>);

/// Processor seconds of the passes, each a mean over runs, after one pass to warm up; for a slow task that pass alone.
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

/// Number of runs that take at least [`PASS_SECONDS`].
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
