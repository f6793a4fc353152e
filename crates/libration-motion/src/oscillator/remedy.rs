//! Computations that have a result where another has none.

/// A computation that has a result where the one that failed has none.
///
/// Messages of errors do not name functions or commands; a front end names what it calls the remedy.
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
