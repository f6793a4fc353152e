//! Quadrature: integrals from zero to one, each with an estimate of the truncation error.
//!
//! | rule | for functions that are | evaluations |
//! |---|---|---|
//! | [`gauss`] | analytic, well beyond the ends | 16 |
//! | [`gauss_kronrod`] | unknown; kinks and roots are searched | 15 to 1905 |
//! | [`double_exponential`] | analytic between the ends, at which they may be powers | 113 |
//!
//! ```
//! # extern crate libration_numbers as libration;
//! use libration::quadrature::{double_exponential, gauss, gauss_kronrod};
//!
//! let smooth = |x: f64| 1.0 / (1.0 + x);
//! for integral in [gauss(smooth), gauss_kronrod(smooth), double_exponential(smooth)] {
//!     assert!((integral.value - 2.0_f64.ln()).abs() < 1e-15 && integral.error < 1e-14);
//! }
//! // A square root has no Taylor series at zero, as the error of Gauss's rule shows.
//! let root = |x: f64| x.sqrt();
//! assert!((double_exponential(root).value - 2.0 / 3.0).abs() < 1e-15);
//! assert!(gauss(root).error > (gauss(root).value - 2.0 / 3.0).abs());
//! ```

mod double_exponential;
#[doc(hidden)]
pub(crate) mod equal_steps;
mod gauss;
pub(crate) mod kronrod;
#[doc(hidden)]
pub(crate) mod running;

pub use double_exponential::double_exponential;
pub(crate) use equal_steps::equal_steps;
pub use gauss::gauss;
pub use kronrod::gauss_kronrod;

/// The integral of a function, with its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integral {
    /// The value; NaN if the integral does not converge.
    pub value: f64,
    /// An estimate of the truncation error; the rounding errors of a sum are not included.
    pub error: f64,
}
