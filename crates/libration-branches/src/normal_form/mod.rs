//! The slow flow of coupled oscillators near rest: normal forms with their resonances, and the exchange of energy.
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
//! Coordinates are power series in an order counter whose coefficients are polynomials in the complex amplitudes of the modes and their conjugates,
//! a ring of its own (`polynomials.rs`), over complex numbers over a tower of square roots (`algebra/tower.rs`), or over digits. The tape therefore
//! gives the force of an order from the orders below, as in Lindstedt's expansion; each monomial is then divided by its divisor, or stays in the
//! slow flow (`expansion.rs`). A tower takes a root in only if the root is not there already; otherwise products of non-zero roots would be zero.
//!
//! The exchange of energy is the mean frequency with which amplitudes circulate (`exchange.rs`), by a weighted mean that converges faster than any
//! power. The whole motion is analysed through the same normal form, which changes no mean frequency.

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
/// Divisors that are smaller than this part of the least frequency are taken for resonances, where nothing else is wanted.
pub const DETUNING: f64 = 0.1;
