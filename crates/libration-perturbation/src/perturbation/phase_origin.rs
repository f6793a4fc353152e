//! The origin of the phase of a motion.

/// The state of a motion at which its phase Ωt is zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhaseOrigin {
    /// The motion turns at its largest displacement; all harmonics are cosines.
    TurningPoint,
    /// The motion passes the equilibrium; all harmonics are sines.
    Passage,
    /// Its first harmonic has a maximum; the others are cosines and sines.
    FirstHarmonic,
}
