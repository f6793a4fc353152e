//! Quantities as text, exact numbers and the rings over them, truncated power series, roots, quadrature, small linear algebra, and expressions
//! with their tapes: the part of `libration` that contains no physics. The crate `libration` re-exports the modules.

pub mod algebra;
pub mod catalogue;
pub mod expression;
mod linear;
pub mod progress;
pub mod quadrature;
pub mod quantity;
pub mod roots;
pub mod series;

// The modules of lower crates under the names that `libration` gives them, so that examples read as in users' code.
#[doc(hidden)]
pub use libration_kernels::elliptic;

/// Internals that the other crates of this workspace and the tests use. They may change at any time.
#[doc(hidden)]
pub mod internals {
    pub mod algebra {
        pub use crate::algebra::{
            common_denominator::composition,
            complex::fourier,
            function::entry::{Domain, Growth, Parity, Slope},
            harmonics::{HarmonicPair, HarmonicSum, HarmonicSums, Number, PhaseRing},
            in_order::InOrder,
            integer_polynomial::product,
            lanes::{Lanes, prepared_reciprocal, sin_cos_in_lanes},
            lanewise::{Rounded, any, convolution, integral, lanes, quotient, square},
            mixed_radix::{CONFIRMING_PRIMES, MixedRadix},
            ordered_map::{ordered_map, ordered_map_of_all},
            pi_powers::{PiPolynomial, PiPowers},
            prime_field::PrimeField,
            prime_fields::{LANES, PrimeFields, Residues},
            primes::{is_prime, primes_with_roots},
            quadratic_field::{Quadratic, QuadraticField},
            reconstruction::{Images, Place, Stopped, reconstruct},
            sampled_harmonics::{SampledHarmonics, Symmetry},
            tower::Tower,
        };
        pub mod univariate {
            pub use crate::algebra::univariate::{divided, divided_exactly, square_free_factors, trimmed};
        }
    }
    pub mod catalogue {
        pub use crate::catalogue::{Named, by_key};
    }
    pub mod expression {
        pub use crate::expression::{
            decimal::{from_digits, to_decimal},
            instruction::{Evaluator, Instruction, Value, Weighted},
            jet::{Jet, SeriesError},
            side::Side,
            simplify::difference,
            tape::{Operation, Tape},
        };
    }
    pub mod linear {
        pub use crate::linear::{
            characteristic::characteristic_polynomial,
            eigenvalues::{balancing, eigenvalue_errors, eigenvalues},
            elimination::{determinant, null_space, solve, solve_complex},
            least_squares::least_squares,
        };
    }
    pub mod progress {
        pub use crate::progress::watch::Watch;
    }
    pub mod quadrature {
        pub use crate::quadrature::{
            equal_steps::equal_steps,
            kronrod::Rules,
            running::{POINTS, points, running_integrals},
        };
    }
    pub mod quantity {
        pub use crate::quantity::{decimal::Decimal, pi_combination::PiCombination};
    }
    pub mod roots {
        pub use crate::roots::{
            golden_section::{maximum_between, other_sign_between},
            newton::{NewtonError, Unsolved, correction, newton},
            polynomial::value_and_slope,
            sign_changes::sign_change,
        };
    }
    pub mod series {
        pub use crate::series::{
            even_reciprocal, exponential,
            online::{Convolution, Weight},
        };
        pub mod truncated {
            pub use crate::series::truncated::{
                SeriesPowers, composition, next_square_root, powers, powers_of_inverse, product, reciprocal,
            };
        }
    }
}
