//! Foundation of all numerical code of `libration`, in double precision with proven or measured errors: two-word numbers, elementary functions
//! without branches, complete and incomplete elliptic integrals and Jacobi's functions, for single values and for slices. The crate does not
//! depend on big-number libraries and can be used alone. The crate `libration` re-exports [`elliptic`].
//!
//! Results have the same bits on every platform, since std's elementary functions, which differ between systems, are not used.
//!
//! ```
//! use libration_kernels::elliptic::Modulus;
//!
//! let modulus = Modulus::from_parameter(0.5)?;
//! assert!((modulus.first() - 1.854_074_677_301_372).abs() < 1e-15);
//! # Ok::<(), libration_kernels::elliptic::ModulusError>(())
//! ```

pub mod dispatch;
pub mod double_double;
pub mod elementary;
pub mod elliptic;
pub mod fused;

/// Internals that the other crates of this workspace and the tests use. They may change at any time.
#[doc(hidden)]
pub mod internals {
    pub mod elementary {
        pub use crate::elementary::logarithm::reciprocal;
    }
    pub mod elliptic {
        pub use crate::elliptic::{
            Expansion,
            complete::{Complete, complete},
            complete_and_nome,
            descent::Descent,
            incomplete::first_of_point,
            leg,
            nearer::Nearer,
            precise::PreciseQuotients,
            rounded::{first, second},
            swing_stages::SwingStages,
            theta::{
                CircularSide, HyperbolicSide, Phase, PhaseClock, Side, ThetaSeries, ThetaValues, ThetaZero,
                quotient, scaled_by,
            },
        };
    }
}
