//! The exact pendulum at any amplitude and in every regime, and the published formulas for its period, each with its exact error. The crate
//! `libration` re-exports its modules.

pub mod pendulum;
pub mod period_formulas;

// The modules of the crates below under the names that `libration` gives them, so that examples read as its users write them.
#[doc(hidden)]
pub use libration_kernels::elliptic;
#[doc(hidden)]
pub use libration_numbers::{algebra, catalogue, expression, quadrature, quantity, roots, series, watch};
