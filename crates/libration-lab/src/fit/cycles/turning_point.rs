//! Where the pendulum turns.

/// A turning point of the value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extreme {
    /// In seconds.
    pub(super) time: f64,
    /// From the centre, with its sign.
    pub(super) value: f64,
    /// From the noise.
    pub(super) uncertainty: f64,
}
