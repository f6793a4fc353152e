//! Elliptic integrals and Jacobi's elliptic functions of a modulus and its complement.
//!
//! A [`Modulus`] holds k = √m and k′ = √(1 − m) in two words each. Next to k = 1 the results depend on the complement, so 1 − m is never formed
//! from a rounded m. The quantities of the modulus alone (K, E, K′, the nome) are prepared once; the Jacobi functions are then quotients of
//! theta series that converge in four terms.
//!
//! ```
//! # extern crate libration_kernels as libration;
//! use libration::elliptic::Modulus;
//! let modulus = Modulus::from_parameter(0.5)?;
//! let at = modulus.jacobi(1.0);
//! assert!((at.sn * at.sn + at.cn * at.cn - 1.0).abs() < 4e-16);
//! # Ok::<(), libration::elliptic::ModulusError>(())
//! ```

#[doc(hidden)]
pub(crate) mod complete;
mod carlson;
mod complete_stages;
#[doc(hidden)]
pub(crate) mod descent;
#[doc(hidden)]
pub(crate) mod incomplete;
mod incomplete_stages;
mod jacobi;
mod jacobi_stages;
mod moduli;
mod modulus_stages;
#[doc(hidden)]
pub(crate) mod nearer;
#[doc(hidden)]
pub(crate) mod precise;
#[doc(hidden)]
pub(crate) mod rounded;
#[doc(hidden)]
pub(crate) mod swing_stages;
#[doc(hidden)]
pub(crate) mod theta;

pub use complete_stages::{complete_firsts, complete_seconds, nomes};
pub use incomplete_stages::{incomplete_firsts, incomplete_seconds};
pub use jacobi::Jacobi;
pub use jacobi_stages::{JacobiSlices, jacobi_functions};
pub use moduli::{LengthMismatch, Moduli};

pub(crate) use incomplete::first_of_point;
pub(crate) use theta::{
    CircularSide, HyperbolicSide, Phase, PhaseClock, Side, ThetaSeries, ThetaValues, ThetaZero, ratio,
    scaled_by,
};

use crate::dispatch::{Kernel, dispatch};
use crate::double_double::DoubleDouble;
use crate::elementary::{exp, two_word};
use complete::Complete;
use descent::Descent;
use jacobi::Quotients;
use nearer::Nearer;

/// A modulus k with its complement k′ = √(1 − k²), its integrals and nome.
#[derive(Clone, Copy, Debug)]
pub struct Modulus {
    modulus: DoubleDouble,
    complementary: DoubleDouble,
    nearer: Nearer,
    integrals: Complete,
    complementary_first: DoubleDouble,
    nome: f64,
    quotients: Quotients,
}

/// The reason why a number is not a modulus, a parameter or a nome.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ModulusError {
    /// A nome so close to 1 that k′ is below the range kept.
    #[error("the nome is {0:?}: its complementary modulus is below 1e-300; give at most 0.9929, or 1")]
    NomeTooClose(f64),
    /// Outside [0, 1], or NaN.
    #[error("{name} is {value:?}: give a number from 0 to 1")]
    OutOfRange {
        /// Name of the number.
        name: &'static str,
        /// The value of the number.
        value: f64,
    },
}

/// Largest nome below 1: above it k′ is below 1e-300.
const LARGEST_NOME: f64 = 0.9929;

/// The choice of the smaller of the two nomes, which decides the expansion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(hidden)]
pub enum Expansion {
    /// Sines and cosines of the nome q, for k ≤ k′.
    Circular,
    /// Hyperbolic sines and cosines of the complementary nome, for k > k′.
    Hyperbolic,
}

impl Modulus {
    /// The modulus of the parameter m = k², exactly this `f64`.
    ///
    /// # Errors
    /// m outside [0, 1].
    pub fn from_parameter(m: f64) -> Result<Self, ModulusError> {
        unit("the parameter m", m)?;
        Ok(dispatch(OfParameter(m)))
    }

    /// The modulus whose complementary parameter 1 − m is exactly this `f64`.
    ///
    /// # Errors
    /// Outside [0, 1].
    pub fn from_complementary_parameter(complementary: f64) -> Result<Self, ModulusError> {
        unit("the complementary parameter 1 - m", complementary)?;
        Ok(dispatch(OfComplementaryParameter(complementary)))
    }

    /// The modulus k, exactly this `f64`.
    ///
    /// # Errors
    /// k outside [0, 1].
    pub fn from_modulus(k: f64) -> Result<Self, ModulusError> {
        unit("the modulus k", k)?;
        Ok(Self::from_words(DoubleDouble::from(k), leg(DoubleDouble::from(k))))
    }

    /// The modulus whose complement k′ is exactly this `f64`; full accuracy down to k′ = 1e-300.
    ///
    /// # Errors
    /// k′ outside [0, 1].
    pub fn from_complementary_modulus(complementary: f64) -> Result<Self, ModulusError> {
        unit("the complementary modulus k'", complementary)?;
        let complementary = DoubleDouble::from(complementary);
        Ok(Self::from_words(leg(complementary), complementary))
    }

    /// The modulus whose nome q = exp(−πK′/K) is exactly this `f64` (DLMF 22.2.2).
    ///
    /// # Accuracy
    /// k and k′ to 0.56 ulp, subnormal nomes included (ledger in `tests/suite/promises.rs`).
    ///
    /// # Errors
    /// q outside [0, 1], or above 0.9929 without being 1: k′ is then below 1e-300.
    pub fn from_nome(nome: f64) -> Result<Self, ModulusError> {
        unit("the nome q", nome)?;
        if nome > LARGEST_NOME && nome < 1.0 {
            return Err(ModulusError::NomeTooClose(nome));
        }
        Ok(modulus_of_nome(nome))
    }

    /// The modulus from k and k′ in two words, with k² + k′² = 1 within the second words.
    #[doc(hidden)]
    pub fn from_words(modulus: DoubleDouble, complementary: DoubleDouble) -> Self {
        dispatch(OfWords { modulus, complementary })
    }

    /// The modulus from k, k′ and the nearer side.
    #[inline(always)]
    fn from_nearer(modulus: DoubleDouble, complementary: DoubleDouble, nearer: &Nearer) -> Self {
        let descent = Descent::new(nearer);
        let log = descent.log_inverse_nome(nearer.raised);
        let near = descent.near_quarter();
        let complementary_first = if nearer.above { near } else { Descent::far_quarter(near, log) };
        Self {
            modulus,
            complementary,
            nearer: *nearer,
            integrals: Complete::new(nearer, &descent, log),
            complementary_first,
            nome: nome(nearer, &descent, log),
            quotients: Quotients::new(nearer, &descent, log),
        }
    }

    /// k.
    #[must_use]
    pub fn modulus(&self) -> f64 {
        self.modulus.to_f64()
    }

    /// k′ = √(1 − k²).
    #[must_use]
    pub fn complementary_modulus(&self) -> f64 {
        self.complementary.to_f64()
    }

    /// m = k²; rounds to 1 where 1 − m is below 2⁻⁵⁴, as for nomes above 0.7824.
    #[must_use]
    pub fn parameter(&self) -> f64 {
        self.modulus.square_to_f64()
    }

    /// 1 − m = k′²; underflows to zero for k′ below 1.5e-162.
    #[must_use]
    pub fn complementary_parameter(&self) -> f64 {
        self.complementary.square_to_f64()
    }

    /// The complete integral of the first kind K, the quarter period; ∞ for k = 1 (DLMF 19.2.8).
    ///
    /// # Accuracy
    /// 0.56 ulp, as for E and K′ (ledger in `tests/suite/promises.rs`).
    #[must_use]
    pub fn first(&self) -> f64 {
        rounded::first(&self.nearer)
    }

    /// The complete integral of the second kind E (DLMF 19.2.8), within 0.56 ulp.
    #[must_use]
    pub fn second(&self) -> f64 {
        rounded::second(&self.nearer)
    }

    /// K′ = K(k′), rounded from two words; ∞ for k = 0.
    #[must_use]
    pub fn complementary_first(&self) -> f64 {
        self.complementary_first.to_f64()
    }

    /// The nome q = exp(−πK′/K); 0 for k = 0, 1 for k = 1. Below k = 6.2e-162 the nome is smaller than the smallest `f64`, and zero is returned.
    ///
    /// # Accuracy
    /// 0.56 ulp (ledger in `tests/suite/promises.rs`).
    #[must_use]
    pub fn nome(&self) -> f64 {
        self.nome
    }

    /// sn, cn, dn and the amplitude am at u.
    ///
    /// # Domain
    /// Every finite u; NaN for others. For k < 1 sn, cn and dn are NaN from |u| = 2⁹⁹ K on (2⁹⁷ periods, 1e30 at k = 0), where
    /// the error bound is K/2 or more; am is known there too.
    /// # Accuracy
    /// 2.2 ulp of the value and 2⁻¹⁰⁰·|u| (ledger in `tests/suite/promises.rs`); sn, cn within [−1, 1]. Values below
    /// 2.2e-308 are within 2e-323; sn and am of a subnormal u are exact, and zeros keep their sign.
    #[must_use]
    pub fn jacobi(&self, u: f64) -> Jacobi {
        self.quotients.at(u)
    }

    /// Legendre's incomplete integral of the first kind F(φ, k) (DLMF 19.2.4), odd in φ; any finite φ. For
    /// k = 1 infinite from |φ| = π/2 on.
    ///
    /// # Accuracy
    /// 0.56 ulp for k′ ≥ 1e-300, next to every quarter turn too (ledger in `tests/suite/promises.rs`).
    #[must_use]
    pub fn incomplete_first(&self, phi: f64) -> f64 {
        incomplete::first(self, phi)
    }

    /// Legendre's incomplete integral of the second kind E(φ, k) (DLMF 19.2.5), odd in φ; any finite φ.
    ///
    /// # Accuracy
    /// As [`Self::incomplete_first`].
    #[must_use]
    pub fn incomplete_second(&self, phi: f64) -> f64 {
        incomplete::second(self, phi)
    }

    #[doc(hidden)]
    pub fn first_words(&self) -> DoubleDouble {
        self.integrals.first
    }

    #[doc(hidden)]
    pub fn complementary_first_words(&self) -> DoubleDouble {
        self.complementary_first
    }

    #[doc(hidden)]
    pub fn second_words(&self) -> DoubleDouble {
        self.integrals.second
    }

    /// (E − k′²K)/k².
    #[doc(hidden)]
    pub fn cosine_part(&self) -> DoubleDouble {
        self.integrals.cosine_part
    }

    #[doc(hidden)]
    pub fn modulus_words(&self) -> DoubleDouble {
        self.modulus
    }

    #[doc(hidden)]
    pub fn complementary_words(&self) -> DoubleDouble {
        self.complementary
    }

    #[doc(hidden)]
    pub fn expansion(&self) -> Expansion {
        self.nearer.expansion()
    }

    /// The square root of the smaller nome.
    #[doc(hidden)]
    pub fn root_of_smaller_nome(&self) -> DoubleDouble {
        Descent::new(&self.nearer).precise_root_of_nome(self.nearer.lowering())
    }

    /// z of the theta functions for one turn of 4K.
    #[doc(hidden)]
    pub fn turn_scale(&self) -> DoubleDouble {
        self.quotients.turn_scale()
    }
}

struct OfParameter(f64);

impl Kernel for OfParameter {
    type Output = Modulus;
    #[inline(always)]
    fn run(self) -> Modulus {
        let complementary = (DoubleDouble::ONE - DoubleDouble::from(self.0)).sqrt();
        Modulus::from_nearer(
            DoubleDouble::from(self.0).sqrt(),
            complementary,
            &Nearer::from_parameter(self.0),
        )
    }
}

struct OfComplementaryParameter(f64);

impl Kernel for OfComplementaryParameter {
    type Output = Modulus;
    #[inline(always)]
    fn run(self) -> Modulus {
        let modulus = (DoubleDouble::ONE - DoubleDouble::from(self.0)).sqrt();
        let complementary = DoubleDouble::from(self.0).sqrt();
        Modulus::from_nearer(modulus, complementary, &Nearer::from_complementary_parameter(self.0))
    }
}

struct OfWords {
    modulus: DoubleDouble,
    complementary: DoubleDouble,
}

impl Kernel for OfWords {
    type Output = Modulus;
    #[inline(always)]
    fn run(self) -> Modulus {
        let nearer = Nearer::from_words(self.modulus, self.complementary);
        Modulus::from_nearer(self.modulus, self.complementary, &nearer)
    }
}

/// The complete integrals and the nome of the modulus k with its complement k′.
#[doc(hidden)]
pub fn complete_and_nome(modulus: DoubleDouble, complementary: DoubleDouble) -> (Complete, f64) {
    dispatch(CompleteAndNome(modulus, complementary))
}

struct CompleteAndNome(DoubleDouble, DoubleDouble);

impl Kernel for CompleteAndNome {
    type Output = (Complete, f64);
    #[inline(always)]
    fn run(self) -> (Complete, f64) {
        let nearer = Nearer::from_words(self.0, self.1);
        let descent = Descent::new(&nearer);
        let log = descent.log_inverse_nome(nearer.raised);
        (Complete::new(&nearer, &descent, log), nome(&nearer, &descent, log))
    }
}

/// The nome of the modulus k with its complement k′.
#[doc(hidden)]
pub fn nome_of_words(modulus: DoubleDouble, complementary: DoubleDouble) -> f64 {
    dispatch(NomeOfWords(modulus, complementary))
}

struct NomeOfWords(DoubleDouble, DoubleDouble);

impl Kernel for NomeOfWords {
    type Output = f64;
    #[inline(always)]
    fn run(self) -> f64 {
        let nearer = Nearer::from_words(self.0, self.1);
        let descent = Descent::new(&nearer);
        nome(&nearer, &descent, descent.log_inverse_nome(nearer.raised))
    }
}

/// The nome of the modulus: the nome of the nearer side, or from it by ln q · ln q′ = π².
#[inline(always)]
fn nome(nearer: &Nearer, descent: &Descent, log: DoubleDouble) -> f64 {
    let near = descent.nome().to_f64() * nearer.lowering() * nearer.lowering();
    let far = exp(-DoubleDouble::PI.square().over(log)).to_f64();
    // One for an infinite logarithm.
    let far = if log.hi < f64::INFINITY { far } else { 1.0 };
    if nearer.above { far } else { near }
}

/// √(1 − x²) as √((1 − x)(1 + x)).
#[inline(always)]
#[doc(hidden)]
pub fn leg(x: DoubleDouble) -> DoubleDouble {
    ((DoubleDouble::ONE - x) * (DoubleDouble::ONE + x)).sqrt()
}

/// k = θ₂²/θ₃² and k′ = θ₄²/θ₃² of the nome q or, above e^−π, of the complementary nome (DLMF 20.9.1).
fn modulus_of_nome(nome: f64) -> Modulus {
    if nome <= 0.0 || nome >= 1.0 {
        let k = DoubleDouble::from(nome);
        return Modulus::from_words(k, DoubleDouble::ONE - k);
    }
    let log = two_word::ln(DoubleDouble::from(nome));
    let small = -log.hi >= std::f64::consts::PI;
    // ln q · ln q′ = π².
    let log = if small { log } else { DoubleDouble::PI.square() / log };
    let (modulus, complementary) = moduli_of_log_nome(log);
    if small {
        Modulus::from_words(modulus, complementary)
    } else {
        Modulus::from_words(complementary, modulus)
    }
}

/// k and k′ from ln q ≤ −π, in two words.
fn moduli_of_log_nome(log: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let root = two_word::exp(log.scaled(0.5));
    let ThetaZero { second, third, fourth } = ThetaZero::in_two_words(root.square());
    (root.scaled(4.0) * (second / third).square(), (fourth / third).square())
}

fn unit(name: &'static str, value: f64) -> Result<(), ModulusError> {
    if (0.0..=1.0).contains(&value) { Ok(()) } else { Err(ModulusError::OutOfRange { name, value }) }
}
