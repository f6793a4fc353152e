//! Perturbation series of any oscillator in exact numbers (Lindstedt and Poincaré's method with a free gauge, slow flows, limit cycles), and
//! their comparison with exact values. The crate `libration` re-exports its modules.

pub mod comparison;
pub mod perturbation;

// The modules of the crates below under the names that `libration` gives them, so that examples read as its users write them.
#[doc(hidden)]
pub use libration_kernels::elliptic;
#[doc(hidden)]
pub use libration_motion::{chaos, decay, orbit, oscillator, spectrum, systems, taylor};
#[doc(hidden)]
pub use libration_numbers::{algebra, catalogue, expression, progress, quadrature, quantity, roots, series};
#[doc(hidden)]
pub use libration_pendulum::{pendulum, period_formulas};

/// Internals that the other crates of this workspace and the tests use. They may change at any time.
#[doc(hidden)]
pub mod internals {
    pub mod comparison {
        pub use crate::comparison::{enclosed::other_equilibrium, work::WorkOverOrbits};
    }
    pub mod perturbation {
        pub use crate::perturbation::{
            certificate::agrees_with_the_potential,
            model::{Model, Motion, values_at},
            modular::exact_series,
            series_set::SeriesSet,
            shape::Shape,
            slow_flow::{
                half_swing::{HalfSwings, Sums},
                phase_functions::{PhaseFunctions, Response},
            },
        };
    }
}
