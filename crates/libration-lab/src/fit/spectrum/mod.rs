//! The harmonics of a measured swing, compared with those of theory.
//!
//! A swing that decays has no lines: its amplitude falls, and its frequency rises with that. So windows of a few swings are
//! fitted by least squares with cos nφ and sin nφ, where the phase φ is that of the measured first harmonic
//! (`window_fit.rs`): rows may be uneven, missing or wrong. No equation of motion is assumed. The amplitude is that of the
//! undamped pendulum with the same first harmonic, whose other harmonics are then known, whatever its length is.
//!
//! Uncertainties come from the noise about each harmonic: the part of the residuals at a distance of 2/5 of an order from it, in all windows, so
//! that they hold for noise that is not white as long as it is smooth over an order.
//!
//! # Method
//! A window has five swings by default. Its columns are a constant with a drift, cos φ and sin φ with quartics in time, and cos nφ and sin nφ with
//! the power of the amplitude that theory gives. The phase φ is a quartic in time that is corrected until the coefficient of sin φ vanishes
//! (`window_fit.rs`). Theory needs the first harmonic alone, from which amplitude and other harmonics follow (`theory.rs`). The noise of a harmonic
//! is the part of the residuals of all windows at a distance of 2/5 of an order, over the part that white noise would have there with the same
//! columns (`noise.rs`); its few degrees of freedom are reported with it.
//!
//! The odd harmonics of a damped swing are off in phase in the first order of the damping, and in amplitude in the second. The spectrum for display
//! (`tapered.rs`) weights rows by Hann's window and by the time for which they stand: with equal weights a gap of three rows would hide the third
//! harmonic.

mod error;
mod harmonic;
mod lomb_scargle;
mod measured;
mod noise;
mod remark;
mod tapered;
pub(crate) mod theory;
mod window_fit;
mod windows;

pub use error::SpectrumError;
pub use harmonic::{Harmonic, SpectrumWindow};
pub use lomb_scargle::{SpectrumPoint, lomb_scargle};
pub use measured::{Spectrum, SpectrumOptions, fit_spectrum};
pub use remark::SpectrumRemark;
