//! Numbers of things as floating-point numbers.

/// The nearest `f64`.
#[expect(clippy::cast_precision_loss, reason = "nothing in memory has 2^53 rows")]
pub fn count(things: usize) -> f64 {
    things as f64
}
