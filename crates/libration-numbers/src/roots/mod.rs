//! Root finding between two points that enclose a zero of a function or the end of a condition; and all roots of a polynomial.
//!
//! The first two methods keep the bracket: their result lies between the given points, whatever the function is. They end when the bracket is as
//! narrow as the [`Tolerance`] requires, or when no `f64` is left inside it.
//!
//! | method | wants | evaluations |
//! |---|---|---|
//! | [`bisect`] | a condition that holds at one end | log2(width/tolerance), at most 2100 |
//! | [`zero_between`] | the values at both ends, of opposite sign | few for smooth functions, at most ten more than bisection |
//! | [`polynomial_roots`] | the coefficients | some ten per root |
//! | [`polynomial_sign_changes`] | the coefficients | some sixty per real zero of the polynomial and its derivatives |
//!
//! ```
//! # extern crate libration_numbers as libration;
//! use libration::roots::{Tolerance, bisect, zero_between};
//!
//! // The angle that equals its cosine.
//! let missing = |x: f64| x.cos() - x;
//! let [below, above] = bisect([0.0, 1.0], Tolerance::LAST_BIT, |x| missing(x) > 0.0);
//! assert_eq!(above, below.next_up());
//! let ends = [(0.0, missing(0.0)), (1.0, missing(1.0))];
//! let zero = zero_between(ends, Tolerance::absolute(1e-12), missing).ok_or("the same sign at both ends")?;
//! assert!((zero - below).abs() < 1e-12 && (zero - 0.7390851332151607).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bisection;
#[doc(hidden)]
pub(crate) mod golden_section;
mod interpolation;
#[doc(hidden)]
pub(crate) mod newton;
#[doc(hidden)]
pub(crate) mod polynomial;
#[doc(hidden)]
pub(crate) mod sign_changes;

pub use bisection::bisect;
pub use interpolation::zero_between;
pub use polynomial::{PolynomialRoot, polynomial_roots};
pub use sign_changes::polynomial_sign_changes;

/// Largest width of the final bracket: the sum of both parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Width in the units of the points.
    pub absolute: f64,
    /// Width relative to the end that is farther from zero.
    pub relative: f64,
}

impl Tolerance {
    /// Zero width: until no `f64` is left between the ends.
    pub const LAST_BIT: Self = Self { absolute: 0.0, relative: 0.0 };

    /// A width in the units of the points.
    #[must_use]
    pub const fn absolute(width: f64) -> Self {
        Self { absolute: width, relative: 0.0 }
    }

    /// A width relative to the end that is farther from zero.
    #[must_use]
    pub const fn relative(part: f64) -> Self {
        Self { absolute: 0.0, relative: part }
    }

    fn width(self, [a, b]: [f64; 2]) -> f64 {
        self.absolute + self.relative * a.abs().max(b.abs())
    }
}
