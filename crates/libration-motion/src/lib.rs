//! Motion in time for any equations: Taylor integration with events, named systems, oscillators about an equilibrium, periodic orbits, decay
//! under damping, chaos, spectra. The crate `libration` re-exports the modules.

pub mod chaos;
pub mod decay;
pub mod orbit;
pub mod oscillator;
mod periodic;
pub mod spectrum;
pub mod systems;
pub mod taylor;

// The modules of lower crates under the names that `libration` gives them, so that examples read as in users' code.
#[doc(hidden)]
pub use libration_kernels::elliptic;
#[doc(hidden)]
pub use libration_numbers::{algebra, catalogue, expression, progress, quadrature, quantity, roots, series};
#[doc(hidden)]
pub use libration_pendulum::{pendulum, period_formulas};

/// Internals that the other crates of this workspace and the tests use. They may change at any time.
#[doc(hidden)]
pub mod internals {
    pub mod chaos {
        pub use crate::chaos::{
            drive::WrittenDrive,
            lyapunov::{record::Record, verdict::Evidence},
            structure::{has_jumps, theorem},
        };
    }
    pub mod decay {
        pub use crate::decay::half_swing::{EFFORT, GrowingCoordinate, HalfSwing};
    }
    pub mod orbit {
        pub use crate::orbit::{
            acceleration::Acceleration, least_period::over_least_period, precise::Motion,
            release_place::ReleasePlace,
        };
    }
    pub mod oscillator {
        pub use crate::oscillator::roots::zeros;
    }
    pub mod periodic {
        pub use crate::periodic::{
            CLOSED, Checked, Extrema, Flow, Frame, LOST, NewtonStep, Nodes, Piece, Variations, extrema,
            multiplier_errors, norm, norm_of_map, precise_series, precise_step, precise_sum, turns_in,
        };
    }
    pub mod spectrum {
        pub use crate::spectrum::{
            fourier::{part, transform},
            window::bessel_i0,
        };
    }
    pub mod taylor {
        pub use crate::taylor::{
            program::expander::{Expander, Surroundings},
            program::state_names::named_state,
            step::largest_change::{largest_change, largest_changes},
            step::sign_change::{first_sign_change, scaled, sign_changes},
        };
    }
}
