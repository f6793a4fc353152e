//! The same questions asked natively and on wasm32: `scripts/wasm32` compares the answers bit for bit.

mod answers;

use std::sync::OnceLock;

pub use answers::{Failure, answers};

static ANSWERS: OnceLock<Vec<f64>> = OnceLock::new();

fn kept() -> &'static [f64] {
    ANSWERS.get_or_init(|| answers().unwrap_or_default())
}

/// How many answers there are; none if one of the questions failed.
#[expect(unsafe_code, reason = "a name for the host")]
#[unsafe(no_mangle)]
pub extern "C" fn count() -> usize {
    kept().len()
}

/// The bits of an answer, zero behind the last.
#[expect(unsafe_code, reason = "a name for the host")]
#[unsafe(no_mangle)]
pub extern "C" fn bits(index: usize) -> u64 {
    kept().get(index).map_or(0, |answer| answer.to_bits())
}

/// The periods of so many amplitudes, summed: something to take the time of.
#[expect(unsafe_code, reason = "a name for the host")]
#[unsafe(no_mangle)]
pub extern "C" fn sum_of_periods(count: u32) -> f64 {
    answers::sum_of_periods(count)
}

/// The angles of one motion at so many times, summed.
#[expect(unsafe_code, reason = "a name for the host")]
#[unsafe(no_mangle)]
pub extern "C" fn sum_of_angles(count: u32) -> f64 {
    answers::sum_of_angles(count)
}

/// Whether this module keeps its promises on the processor that runs it.
#[expect(unsafe_code, reason = "a name for the host")]
#[unsafe(no_mangle)]
pub extern "C" fn rounds_once() -> bool {
    libration::rounds_once()
}
