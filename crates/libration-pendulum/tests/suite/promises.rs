//! The accuracy ledger: the error bound of each result and its domain. `accuracy.rs` enforces it on the golden tables, `ledger/` on random
//! inputs.

/// An error bound in ulp of the true value, in addition to an absolute allowance that `beyond` describes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Promise {
    pub(crate) what: &'static str,
    pub(crate) domain: &'static str,
    pub(crate) ulp: f64,
    pub(crate) beyond: &'static str,
}

impl Promise {
    /// Fails, naming the input, if `error` (in ulp) exceeds the bound.
    pub(crate) fn holds(&self, error: f64, input: &dyn core::fmt::Debug) {
        assert!(
            error <= self.ulp,
            "{}: {error} ulp at {input:?}, promised {} for {}",
            self.what,
            self.ulp,
            self.domain
        );
    }
}

const fn promise(what: &'static str, domain: &'static str, ulp: f64, beyond: &'static str) -> Promise {
    Promise { what, domain, ulp, beyond }
}

pub(crate) const RATIO: Promise = promise("T/T0", "θ0 in [0, π), or π − θ0 ≥ 1e-300", 0.56, "");
pub(crate) const EXCESS: Promise = promise("T/T0 − 1", "θ0 ≥ 1e-150", 0.9, "");
pub(crate) const COMPLETE: Promise = promise("K, E, K′", "0 ≤ m ≤ 1, k′ ≥ 1e-300", 0.56, "");
pub(crate) const NOME: Promise = promise("nome q", "0 ≤ m ≤ 1, k′ ≥ 1e-300", 0.56, "");
pub(crate) const OF_NOME: Promise = promise("k, k′ of a nome", "0 ≤ q ≤ 0.9929", 0.56, "");
pub(crate) const INCOMPLETE: Promise = promise("F(φ), E(φ)", "any φ, 0 ≤ m ≤ 1, k′ ≥ 1e-300", 0.56, "");
pub(crate) const JACOBI: Promise =
    promise("sn, cn, dn, am", "0 ≤ m ≤ 1, k′ ≥ 1e-300, |u| ≤ 1e6 K", 2.2, "2⁻¹⁰⁰·|u| + 2e-323");
pub(crate) const STATE: Promise = promise(
    "θ(t), θ′(t)",
    "any initial state, |t| ≤ 1e6 periods",
    2.2,
    "2⁻⁵¹·|θ′t|, for θ′ 2⁻⁵¹·|θ″t|, and 2e-323",
);
pub(crate) const COMPLEMENT: Promise =
    promise("π − |θ(t)| in the turn", "any initial state, |t| ≤ 1e6 periods", 2.5, "2⁻⁵¹·|θ′t| + 2e-323");
pub(crate) const HARMONICS: Promise = promise("harmonics a_n", "|a_n| ≥ 2.3e-308 rad", 0.56, "");
/// The bound for action and energy, which are rounded from two words.
pub(crate) const ACTION: Promise = promise("action, energy", "any motion", 0.56, "2e-323");

/// 2⁻⁵¹, four times the unit roundoff: the relative error allowed for a time or a velocity.
pub(crate) const FOUR_ROUNDOFFS: f64 = 2.0 * f64::EPSILON;

/// Four of the smallest numbers: the absolute error allowed for results below 2.2e-308.
pub(crate) const SUBNORMAL: f64 = 2e-323;

/// The allowance of Jacobi functions for the error of the quarter period in two words.
pub(crate) fn jacobi_allowance(u: f64) -> f64 {
    f64::EPSILON * f64::EPSILON * 16.0 * u.abs() + SUBNORMAL
}
