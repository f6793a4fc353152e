//! Computations that succeed where another one has failed.

/// A computation that has a result for a problem in which another one has failed.
///
/// Error messages do not name functions or commands; each front end inserts its own name of the remedy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Remedy {
    /// The motion in time, by integration.
    Simulation,
    /// The slow flow: the rates at which amplitude and phase change.
    SlowFlow,
    /// The frequency at any amplitude, from periodic orbits.
    Backbone,
    /// Normal modes of several coordinates.
    NormalModes,
    /// The perturbation series, without its derivation.
    Expansion,
    /// The exact period of the pendulum, at any amplitude.
    Period,
}
