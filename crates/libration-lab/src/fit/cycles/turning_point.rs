//! Turning points of the pendulum.

/// A turning point of the value.
#[derive(Clone, Copy, Debug)]
pub struct Extreme {
    /// Time in seconds.
    pub time: f64,
    /// Distance from the centre, with its sign.
    pub value: f64,
    /// Standard uncertainty by the noise.
    pub uncertainty: f64,
}
