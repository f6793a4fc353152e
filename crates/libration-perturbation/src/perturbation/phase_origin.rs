//! The origin of the phase of a motion.

/// The state of a motion at which its phase Ωt is zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhaseOrigin {
    /// The motion turns at its largest displacement; all harmonics are cosines.
    TurningPoint,
    /// The motion passes the equilibrium; all harmonics are sines.
    Passage,
    /// A maximum of the first harmonic; the others are cosines and sines.
    FirstHarmonic,
}
