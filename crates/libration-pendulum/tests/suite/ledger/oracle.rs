//! Records of `reference/oracle.cpp`, read from its standard output.

use libration_testing::ulp::Truth;
use std::env;
use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Stdio};

/// One random input with its true results.
pub(super) struct Record {
    pub(super) region: usize,
    pub(super) inputs: Vec<f64>,
    pub(super) truths: Vec<Truth>,
}

/// The records of one function, in the order in which the oracle writes them.
pub(super) struct Records {
    oracle: Child,
    stream: BufReader<ChildStdout>,
    inputs: usize,
    answers: usize,
}

/// Reads the records of one function, with this number of inputs and results.
pub(super) fn records(function: &str, inputs: usize, answers: usize) -> Records {
    let count = env::var("LIBRATION_LEDGER_COUNT").unwrap_or_else(|_| "1000000".to_owned());
    let seed = env::var("LIBRATION_LEDGER_SEED").unwrap_or_else(|_| "1".to_owned());
    let command = Command::new(binary()).args([function, &count, &seed]).stdout(Stdio::piped()).spawn();
    let mut oracle = command.expect("the oracle is built by scripts/ledger");
    let stream = BufReader::with_capacity(1 << 16, oracle.stdout.take().unwrap());
    Records { oracle, stream, inputs, answers }
}

impl Iterator for Records {
    type Item = Record;

    fn next(&mut self) -> Option<Record> {
        let words = read_words(&mut self.stream, 1 + self.inputs + 2 * self.answers);
        if words.is_none() {
            assert!(self.oracle.wait().unwrap().success(), "the oracle failed");
        }
        Some(record(&words?, self.inputs))
    }
}

fn binary() -> PathBuf {
    let built = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/oracle");
    env::var_os("LIBRATION_ORACLE").map_or_else(built, PathBuf::from)
}

/// Reads `count` numbers; `None` at the end of the stream.
fn read_words(stream: &mut impl Read, count: usize) -> Option<Vec<f64>> {
    let mut bytes = vec![0; 8 * count];
    stream.read_exact(&mut bytes).ok()?;
    Some(bytes.chunks_exact(8).map(|chunk| f64::from_le_bytes(chunk.try_into().unwrap())).collect())
}

fn record(words: &[f64], inputs: usize) -> Record {
    let (given, answers) = words[1..].split_at(inputs);
    let truths = answers.chunks_exact(2).map(|pair| Truth::from_words(pair[0], pair[1])).collect();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small whole number")]
    let region = words[0] as usize;
    Record { region, inputs: given.to_vec(), truths }
}
