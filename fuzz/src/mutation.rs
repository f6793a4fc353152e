//! Random changes of inputs.

use libration_testing::random::Random;

/// Length limit of inputs in bytes.
const LONGEST: usize = 1 << 14;

/// An input from the corpus after one to eight changes.
pub fn mutated(random: &mut Random, corpus: &[Vec<u8>], dictionary: &[&str]) -> Vec<u8> {
    let mut input = corpus[below(random, corpus.len())].clone();
    for _ in 0..=below(random, 8) {
        change(random, &mut input, corpus, dictionary);
    }
    input.truncate(LONGEST);
    input
}

/// A number below a limit; 0 for the limit 0.
fn below(random: &mut Random, limit: usize) -> usize {
    let limit = u64::try_from(limit).unwrap_or(u64::MAX).max(1);
    usize::try_from(random.below(limit)).unwrap_or(0)
}

fn change(random: &mut Random, input: &mut Vec<u8>, corpus: &[Vec<u8>], dictionary: &[&str]) {
    let begin = below(random, input.len() + 1);
    let end = (begin + below(random, 16)).min(input.len());
    match below(random, 8) {
        0 if begin < input.len() => input[begin] ^= 1 << below(random, 8),
        1 => drop(input.drain(begin..end)),
        2 => {
            let token = dictionary[below(random, dictionary.len())];
            input.splice(begin..end, token.bytes());
        }
        3 => {
            let token = dictionary[below(random, dictionary.len())];
            input.splice(begin..begin, token.bytes());
        }
        4 => {
            let part = input[begin..end].to_vec();
            let times = [1, 2, 8, 300][below(random, 4)];
            input.splice(begin..begin, part.iter().copied().cycle().take(part.len() * times));
        }
        5 => {
            let other = &corpus[below(random, corpus.len())];
            let from = below(random, other.len() + 1);
            input.truncate(begin);
            input.extend(&other[from..]);
        }
        6 => input.truncate(begin),
        _ => {
            let byte = u8::try_from(below(random, 256)).unwrap_or(0);
            input.insert(begin, byte);
        }
    }
}
