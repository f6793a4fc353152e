//! The exact pendulum at any amplitude and in every regime, and the published formulas for its period, each with its exact error. The crate
//! `libration` re-exports the modules.

pub mod pendulum;
pub mod period_formulas;

// The modules of lower crates under the names that `libration` gives them, so that examples read as in users' code.
#[doc(hidden)]
pub use libration_kernels::elliptic;
#[doc(hidden)]
pub use libration_numbers::{algebra, catalogue, expression, progress, quadrature, quantity, roots, series};

/// Internals that the other crates of this workspace and the tests use. They may change at any time.
#[doc(hidden)]
pub mod internals {
    pub mod pendulum {
        pub use crate::pendulum::{
            approximate_motion::{FREQUENCY, HARMONICS},
            period::{
                Nearer, PeriodFunction, RatioNearTop, excess_below, log_inverse_nome, nearer_of_amplitude,
                ratio_above,
            },
            table::{DEGREE, ROWS, rows},
        };
    }
    pub mod period_formulas {
        pub use crate::period_formulas::{
            error::Exact,
            family::Family,
            quick::Quick,
            swing::{NEAREST_BOTTOM, NEAREST_TOP, Swing, SwingAmplitude},
        };
    }
}
