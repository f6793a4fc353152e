//! The same computations natively and on wasm32: `scripts/wasm32` compares the results bit for bit.

mod answers;

use std::sync::OnceLock;

pub use answers::{Failure, answers};

static ANSWERS: OnceLock<Vec<f64>> = OnceLock::new();

fn kept() -> &'static [f64] {
    ANSWERS.get_or_init(|| answers().unwrap_or_default())
}

/// Number of results; 0 if one of the computations failed.
#[expect(unsafe_code, reason = "a name for the host")]
#[unsafe(no_mangle)]
pub extern "C" fn count() -> usize {
    kept().len()
}

/// The bits of a result, zero after the last.
#[expect(unsafe_code, reason = "a name for the host")]
#[unsafe(no_mangle)]
pub extern "C" fn bits(index: usize) -> u64 {
    kept().get(index).map_or(0, |answer| answer.to_bits())
}

/// The periods of `count` amplitudes, summed, for measurements of time.
#[expect(unsafe_code, reason = "a name for the host")]
#[unsafe(no_mangle)]
pub extern "C" fn sum_of_periods(count: u32) -> f64 {
    answers::sum_of_periods(count)
}

/// The angles of one motion at `count` times, summed.
#[expect(unsafe_code, reason = "a name for the host")]
#[unsafe(no_mangle)]
pub extern "C" fn sum_of_angles(count: u32) -> f64 {
    answers::sum_of_angles(count)
}

/// Returns `true` if this module keeps its promises on the processor that runs it.
#[expect(unsafe_code, reason = "a name for the host")]
#[unsafe(no_mangle)]
pub extern "C" fn rounds_once() -> bool {
    libration::internals::rounds_once()
}
