//! The slow flow of coupled oscillators near an equilibrium: normal forms with their resonances, and the exchange of energy.
//!
//! ```
//! # extern crate libration_branches as libration;
//! use libration::normal_form::{DETUNING, NormalForm};
//! use libration::progress::Quiet;
//! // One coordinate, no resonance: Lindstedt's frequency, 1 − a²/16.
//! let pendulum = NormalForm::about(&"x'' = -sin(x)".parse()?, &[0.0], 3, DETUNING, &Quiet)?;
//! assert_eq!(pendulum.slow_terms[0].exact.as_deref(), Some("-1/16*i"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//! Coordinates are power series in an order parameter. Their coefficients are polynomials in the complex modal amplitudes
//! and their conjugates (`polynomials.rs`), over complex numbers over a tower of square roots (`algebra/tower.rs`), or
//! over floating-point numbers. The tape therefore gives the force of an order from the lower orders, as in Lindstedt's
//! expansion; each monomial is then divided by its divisor, or stays in the slow flow (`expansion.rs`). A tower adds a
//! root only if it does not contain it yet; otherwise products of non-zero elements could be zero.
//!
//! The frequency of energy exchange is the mean frequency with which amplitudes circulate (`exchange.rs`), by a weighted mean that converges
//! faster than any power. The full motion is analysed through the same normal form, which does not change mean frequencies.

mod error;
mod polynomials;
mod expansion;
mod linear_motion;
mod form;
mod exchange;
mod slow_flow;

pub use error::NormalFormError;
pub use exchange::{Exchange, ExchangeError, MeasuredExchange};
pub use form::{Divisor, NormalForm, SlowTerm};

/// The largest order in the amplitudes.
pub const LARGEST_ORDER: usize = 9;
/// Default of the largest divisor that counts as a resonance, relative to the lowest frequency.
pub const DETUNING: f64 = 0.1;
