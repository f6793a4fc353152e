//! Where the phase of a motion begins.

/// What a motion does where its phase Ωt is zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhaseOrigin {
    /// It turns at its largest displacement; all harmonics are cosines.
    TurningPoint,
    /// It passes the equilibrium; all harmonics are sines.
    Passage,
    /// Its first harmonic has a maximum; the others are cosines and sines.
    FirstHarmonic,
}
