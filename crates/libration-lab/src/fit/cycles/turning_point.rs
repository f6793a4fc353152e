//! Where the pendulum turns.

/// A turning point of the value.
#[derive(Clone, Copy, Debug)]
pub struct Extreme {
    /// In seconds.
    pub time: f64,
    /// From the centre, with its sign.
    pub value: f64,
    /// From the noise.
    pub uncertainty: f64,
}
