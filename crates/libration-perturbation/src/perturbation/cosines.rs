//! Sums of cosines whose coefficients are polynomials in open symbols.

use libration_numbers::{
    algebra::{Polynomial, Polynomials, Ring},
    internals::algebra::{HarmonicPair, HarmonicSums, PhaseRing},
};

/// The ring of such sums.
pub(super) const COSINES: HarmonicSums<Polynomials> = HarmonicSums { numbers: Polynomials };

/// Σ cₖ cos kτ.
pub(super) type Cosines = <HarmonicSums<Polynomials> as Ring>::Element;

/// The sum of these terms (k, cₖ).
pub(super) fn cosines(terms: impl IntoIterator<Item = (u32, Polynomial)>) -> Cosines {
    let harmonic = |(k, cosine)| (k as usize, HarmonicPair { cosine, sine: Polynomial::zero() });
    COSINES.sum_of_harmonics(&terms.into_iter().map(harmonic).collect::<Vec<_>>())
}
