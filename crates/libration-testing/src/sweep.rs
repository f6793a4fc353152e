//! Extent of the sweep that a test runs: by default a fixed part with a fixed seed; in the full run every case, with fresh seeds too.
//!
//! | variable | does |
//! |---|---|
//! | `LIBRATION_SWEEP=full` | runs every case of every sweep |
//! | `LIBRATION_SEED=12345` | draws other random inputs; failures print the seed that repeats them |
//!
//! A test that uses either variable has `sweep` in its name, so that `cargo test sweep` selects it.

use core::ops::Range;

/// Returns `true` if all cases are run.
pub fn is_full() -> bool {
    std::env::var("LIBRATION_SWEEP").is_ok_and(|extent| extent == "full")
}

/// The number for the default run, or the number for the full run.
pub fn number<T>(usual: T, full: T) -> T {
    if is_full() { full } else { usual }
}

/// The seed of a test, mixed with `LIBRATION_SEED` if that is set. Prints to standard error, which is shown for a failed test, how to repeat the
/// run.
///
/// # Panics
/// `LIBRATION_SEED` is not a decimal number below 2⁶⁴.
pub fn seed(base: u64) -> u64 {
    let Ok(text) = std::env::var("LIBRATION_SEED") else {
        eprintln!("seed {base}, the test's own");
        return base;
    };
    let given: u64 = text.parse().expect("LIBRATION_SEED is a decimal number below 2^64");
    eprintln!("seed {base} mixed with LIBRATION_SEED={given}");
    mixed(base, given)
}

/// The two numbers mixed by the last steps of splitmix64, as in `random`: a change of any bit of either changes half of the bits.
fn mixed(base: u64, given: u64) -> u64 {
    let z = base.wrapping_add(given.wrapping_mul(0x9e37_79b9_7f4a_7c15)) ^ given.rotate_left(32);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The first case, every `step`-th one after it, and the last; all cases in the full run.
pub fn part<T>(cases: impl IntoIterator<Item = T>, step: usize) -> Vec<T> {
    part_and(cases, step, |_| false)
}

/// The cases of [`part`], and the cases at seams, where an error is likeliest.
pub fn part_and<T>(
    cases: impl IntoIterator<Item = T>,
    step: usize,
    is_at_seam: impl Fn(&T) -> bool,
) -> Vec<T> {
    let cases: Vec<T> = cases.into_iter().collect();
    let (full, count) = (is_full(), cases.len());
    let is_run = |(index, case): &(usize, T)| {
        full || index.is_multiple_of(step) || index + 1 == count || is_at_seam(case)
    };
    cases.into_iter().enumerate().filter(is_run).map(|(_, case)| case).collect()
}

/// Limits for a number that is computed from random draws.
#[derive(Clone, Debug)]
pub struct Limits {
    /// Limits for the sample of the default run with any seed.
    pub usual: Range<f64>,
    /// Limits for the full sample with any seed.
    pub full: Range<f64>,
    /// Limits for the full sample with the seed of the test. The sample is always the same, so that these limits may be narrower than
    /// chance requires.
    pub seeded: Range<f64>,
}

impl Limits {
    /// Asserts that the number is within the limits of this run.
    ///
    /// # Panics
    /// The number is outside the limits.
    pub fn check(&self, number: f64, what: &str) {
        let range = match (is_full(), std::env::var("LIBRATION_SEED").is_ok()) {
            (false, _) => &self.usual,
            (true, true) => &self.full,
            (true, false) => &self.seeded,
        };
        eprintln!("{what}: {number} in {range:?}");
        assert!(range.contains(&number), "{what}: {number} is not in {range:?}");
    }
}
