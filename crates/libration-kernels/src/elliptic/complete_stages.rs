//! Complete integrals and nome of many moduli, stage by stage.

use super::complete::{second_far, second_near};
use super::descent::Descent;
use super::incomplete::{First, Second};
use super::moduli::{FEW, LengthMismatch, Moduli};
use super::modulus_stages::ModulusStages;
use super::nearer::Nearer;
use super::nome;
use super::rounded::{Rounded, log_of_inverse};
use crate::dispatch::{Kernel, dispatch_slices};
use crate::double_double::block::BLOCK;
use crate::double_double::{DoubleDouble, pick};
use std::marker::PhantomData;

/// A function of the modulus, computed in two words.
pub(super) trait OfModulusWords {
    /// The value of the function, given ln(1/q) of the nearer side; `#[inline(always)]`.
    fn words(nearer: &Nearer, descent: &Descent, log: DoubleDouble) -> DoubleDouble;
}

impl OfModulusWords for First {
    #[inline(always)]
    fn words(nearer: &Nearer, descent: &Descent, log: DoubleDouble) -> DoubleDouble {
        let near = descent.near_quarter();
        pick(nearer.above, Descent::far_quarter(near, log), near)
    }
}

impl OfModulusWords for Second {
    #[inline(always)]
    fn words(nearer: &Nearer, descent: &Descent, log: DoubleDouble) -> DoubleDouble {
        let (near, later) = (descent.near_quarter(), descent.later_differences(nearer));
        pick(nearer.above, second_far(nearer, near, later, log), second_near(nearer, near, later))
    }
}

struct Nomes<'a> {
    moduli: Moduli<'a>,
    nomes: &'a mut [f64],
}

impl Kernel for Nomes<'_> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let mut stages = ModulusStages::ZERO;
        let mut block = [0.5; BLOCK];
        let mut nomes = [0.0; BLOCK];
        for (values, written) in self.moduli.values().chunks(BLOCK).zip(self.nomes.chunks_mut(BLOCK)) {
            block[..values.len()].copy_from_slice(values);
            stages.load(&self.moduli, &block);
            stages.descend();
            stages.logarithms();
            for (i, result) in nomes.iter_mut().enumerate() {
                let nome = nome(&stages.nearer(i), &stages.descent(i), stages.log.get(i));
                *result = stages.inside[i] * nome;
            }
            written.copy_from_slice(&nomes[..written.len()]);
        }
    }
}

struct Each<'a, F> {
    moduli: Moduli<'a>,
    results: &'a mut [f64],
    function: PhantomData<F>,
}

impl<F: Rounded> Kernel for Each<'_, F> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        if self.results.len() <= FEW {
            return self.one_by_one();
        }
        let mut stages = ModulusStages::ZERO;
        let mut block = [0.5; BLOCK];
        let mut results = [0.0; BLOCK];
        for (values, written) in self.moduli.values().chunks(BLOCK).zip(self.results.chunks_mut(BLOCK)) {
            block[..values.len()].copy_from_slice(values);
            stages.load(&self.moduli, &block);
            for i in 0..BLOCK {
                let nearer = stages.nearer(i);
                stages.log.set(i, log_of_inverse(nearer.smaller, nearer.raised));
            }
            for (i, result) in results.iter_mut().enumerate() {
                let nearer = stages.nearer(i);
                let value = F::value(nearer.above, nearer.plain_smaller(), stages.log.get(i));
                *result = stages.inside[i] * value;
            }
            written.copy_from_slice(&results[..written.len()]);
        }
    }
}

impl<F: Rounded> Each<'_, F> {
    #[inline(always)]
    fn one_by_one(self) {
        for (value, result) in self.moduli.values().iter().zip(self.results) {
            let nearer = self.moduli.nearer(*value);
            let log = log_of_inverse(nearer.smaller, nearer.raised);
            let value_inside = F::value(nearer.above, nearer.plain_smaller(), log);
            *result = if (0.0..=1.0).contains(value) { value_inside } else { f64::NAN };
        }
    }
}

fn each<F: Rounded>(moduli: Moduli<'_>, results: &mut [f64]) -> Result<(), LengthMismatch> {
    LengthMismatch::check(moduli.values(), results)?;
    dispatch_slices(Each { moduli, results, function: PhantomData::<F> });
    Ok(())
}

/// The complete integral of the first kind K of each modulus (DLMF 19.2.8): [`Modulus::first`](super::Modulus::first), bit for bit.
///
/// # Domain
/// Moduli from 0 to 1, for which K is infinite; NaN for others.
/// # Accuracy
/// 0.56 ulp (ledger in `tests/suite/promises.rs`).
/// # Errors
/// The slices have different lengths.
/// # Examples
/// ```
/// # extern crate libration_kernels as libration;
/// use libration::elliptic::{Moduli, complete_firsts};
/// let mut firsts = [0.0; 2];
/// complete_firsts(Moduli::Parameters(&[0.0, 0.5]), &mut firsts)?;
/// assert_eq!(firsts, [std::f64::consts::FRAC_PI_2, 1.8540746773013719]);
/// # Ok::<(), libration::elliptic::LengthMismatch>(())
/// ```
pub fn complete_firsts(moduli: Moduli<'_>, firsts: &mut [f64]) -> Result<(), LengthMismatch> {
    each::<First>(moduli, firsts)
}

/// The complete integral of the second kind E of each modulus (DLMF 19.2.8): [`Modulus::second`](super::Modulus::second), bit for
/// bit.
///
/// # Domain
/// Moduli from 0 to 1; NaN for others.
/// # Accuracy
/// 0.56 ulp (ledger in `tests/suite/promises.rs`).
/// # Errors
/// The slices have different lengths.
/// # Examples
/// ```
/// # extern crate libration_kernels as libration;
/// use libration::elliptic::{Moduli, complete_seconds};
/// let mut seconds = [0.0; 2];
/// complete_seconds(Moduli::Parameters(&[0.5, 1.0]), &mut seconds)?;
/// assert_eq!(seconds, [1.3506438810476755, 1.0]);
/// # Ok::<(), libration::elliptic::LengthMismatch>(())
/// ```
pub fn complete_seconds(moduli: Moduli<'_>, seconds: &mut [f64]) -> Result<(), LengthMismatch> {
    each::<Second>(moduli, seconds)
}

/// The nome q = exp(−πK′/K) of each modulus (DLMF 22.2.1): [`Modulus::nome`](super::Modulus::nome), bit for bit.
///
/// # Domain
/// Moduli from 0 to 1; NaN for others.
/// # Accuracy
/// 0.56 ulp (ledger in `tests/suite/promises.rs`).
/// # Errors
/// The slices have different lengths.
/// # Examples
/// ```
/// # extern crate libration_kernels as libration;
/// use libration::elliptic::{Moduli, nomes};
/// let mut values = [0.0; 2];
/// nomes(Moduli::Parameters(&[0.5, 1.0]), &mut values)?;
/// assert_eq!(values, [0.04321391826377225, 1.0]); // e^−π
/// # Ok::<(), libration::elliptic::LengthMismatch>(())
/// ```
pub fn nomes(moduli: Moduli<'_>, nomes: &mut [f64]) -> Result<(), LengthMismatch> {
    LengthMismatch::check(moduli.values(), nomes)?;
    if nomes.len() <= FEW {
        moduli.one_by_one([nomes], |_, modulus| [modulus.nome()]);
    } else {
        dispatch_slices(Nomes { moduli, nomes });
    }
    Ok(())
}
