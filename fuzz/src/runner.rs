//! The loop over inputs of one target.

use crate::mutation::mutated;
use libration_testing::random::Random;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Time limit for one input.
const LONGEST: Duration = Duration::from_secs(10);
/// The number of inputs if no time is given.
const INPUTS: usize = 2000;
/// The seed if no time is given.
const SEED: u64 = 2026;

/// A parser under test.
pub struct Target {
    /// The name of the parser.
    pub name: &'static str,
    /// Initial inputs, past failures among them; all are run unchanged.
    pub corpus: Vec<Vec<u8>>,
    /// Tokens of its notation.
    pub dictionary: &'static [&'static str],
    /// The parser with its properties; the error names the property that does not hold.
    pub run: fn(&[u8]) -> Result<(), String>,
}

impl std::fmt::Debug for Target {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Target").field("name", &self.name).finish_non_exhaustive()
    }
}

/// Runs the corpus, then mutations of it; the error names the failing input.
///
/// # Errors
/// The failing input, the seed, and the panic, the violated property or the exceeded time.
pub fn run(target: &Target) -> Result<usize, String> {
    let seconds = std::env::var("LIBRATION_FUZZ_SECONDS").ok().and_then(|it| it.parse().ok());
    let time = seconds.map(Duration::from_secs);
    let seed = std::env::var("LIBRATION_SEED").ok().and_then(|it| it.parse().ok());
    let seed = seed.unwrap_or_else(|| if time.is_some() { clock() } else { SEED });
    eprintln!("{}: LIBRATION_SEED={seed}", target.name);
    let watched = Watched::begin(target.name, seed);
    let begun = Instant::now();
    for input in &target.corpus {
        watched.run(target, input, seed)?;
    }
    let mut random = Random::seeded(seed);
    let mut inputs = 0;
    while time.map_or(inputs < INPUTS, |time| begun.elapsed() < time) {
        let input = mutated(&mut random, &target.corpus, target.dictionary);
        watched.run(target, &input, seed)?;
        inputs += 1;
    }
    Ok(inputs)
}

fn clock() -> u64 {
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap_or_default();
    u64::from(now.subsec_nanos()) ^ now.as_secs()
}

/// The current input with its start time.
type Current = Arc<Mutex<Option<(Instant, Vec<u8>)>>>;

/// The current input, watched by another thread, since a parser that does not return cannot be stopped from its own thread.
struct Watched(Current);

impl Watched {
    fn begin(name: &'static str, seed: u64) -> Self {
        let current: Current = Arc::default();
        let seen = Arc::downgrade(&current);
        std::thread::spawn(move || {
            while let Some(current) = seen.upgrade() {
                let current = current.lock().unwrap_or_else(PoisonError::into_inner).clone();
                if let Some((begun, input)) = current.filter(|it| it.0.elapsed() > LONGEST) {
                    eprintln!("{name}, seed {seed}: longer than {:?}: {}", begun.elapsed(), shown(&input));
                    std::process::exit(101);
                }
                std::thread::sleep(Duration::from_millis(500));
            }
        });
        Self(current)
    }

    fn run(&self, target: &Target, input: &[u8], seed: u64) -> Result<(), String> {
        let set = |to| *self.0.lock().unwrap_or_else(PoisonError::into_inner) = to;
        set(Some((Instant::now(), input.to_vec())));
        let outcome = catch_unwind(AssertUnwindSafe(|| (target.run)(input)));
        set(None);
        let reason = match outcome {
            Ok(Ok(())) => return Ok(()),
            Ok(Err(property)) => property,
            Err(_) => "it panics".to_owned(),
        };
        Err(format!("{}, seed {seed}: {reason}: {}", target.name, shown(input)))
    }
}

/// An input as a Rust literal, for a test.
fn shown(input: &[u8]) -> String {
    format!("b\"{}\"", input.escape_ascii())
}
