//! Functions of many moduli, stage by stage: the complete integrals and the nome.

use super::complete::{second_far, second_near};
use super::descent::Descent;
use super::incomplete::{First, Second};
use super::moduli::{LengthMismatch, Moduli};
use super::modulus_stages::{ModulusStages, inside};
use super::nearer::Nearer;
use super::nome;
use super::rounded::{first_with, log_of_inverse, second_with};
use crate::dispatch::{Kernel, dispatch_slices};
use crate::double_double::block::{BLOCK, Words};
use crate::double_double::{DoubleDouble, pick};

/// A function of the modulus in two words.
pub(super) trait OfModulusWords {
    /// Its value, given ln(1/q) of the nearer side; `#[inline(always)]`.
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
        in_blocks(self.moduli, self.nomes, |block, nomes| {
            stages.load(&self.moduli, block);
            stages.descend();
            stages.logarithms();
            for (i, written) in nomes.iter_mut().enumerate() {
                let found = nome(&stages.nearer(i), &stages.descent(i), stages.log.get(i));
                *written = stages.inside[i] * found;
            }
        });
    }
}

/// A function of whether m is above one half, of the nearer parameter p and of ln(16/p).
struct Each<'a, F> {
    moduli: Moduli<'a>,
    results: &'a mut [f64],
    function: F,
}

impl<F: Fn(bool, DoubleDouble, DoubleDouble) -> f64> Kernel for Each<'_, F> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let (mut above, mut p, mut log) = ([0.0; BLOCK], Words::ZERO, Words::ZERO);
        in_blocks(self.moduli, self.results, |block, results| {
            Nearer::each(&self.moduli, block, |i, nearer| {
                above[i] = if nearer.above { 1.0 } else { 0.0 };
                p.set(i, nearer.plain_smaller());
                log.set(i, log_of_inverse(nearer.smaller, nearer.raised));
            });
            for (i, result) in results.iter_mut().enumerate() {
                *result = inside(&block[i]) * (self.function)(above[i] > 0.5, p.get(i), log.get(i));
            }
        });
    }
}

/// Block by block, the last one filled up.
#[inline(always)]
fn in_blocks(
    moduli: Moduli<'_>,
    results: &mut [f64],
    mut of_block: impl FnMut(&[f64; BLOCK], &mut [f64; BLOCK]),
) {
    let mut block = [0.5; BLOCK];
    let mut found = [0.0; BLOCK];
    for (values, written) in moduli.values().chunks(BLOCK).zip(results.chunks_mut(BLOCK)) {
        block[..values.len()].copy_from_slice(values);
        of_block(&block, &mut found);
        written.copy_from_slice(&found[..written.len()]);
    }
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
/// use libration::elliptic::{Moduli, complete_firsts};
/// let mut firsts = [0.0; 2];
/// complete_firsts(Moduli::Parameters(&[0.0, 0.5]), &mut firsts)?;
/// assert_eq!(firsts, [std::f64::consts::FRAC_PI_2, 1.8540746773013719]);
/// # Ok::<(), libration::elliptic::LengthMismatch>(())
/// ```
pub fn complete_firsts(moduli: Moduli<'_>, firsts: &mut [f64]) -> Result<(), LengthMismatch> {
    LengthMismatch::check(moduli.values(), firsts)?;
    dispatch_slices(Each { moduli, results: firsts, function: first_with });
    Ok(())
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
/// use libration::elliptic::{Moduli, complete_seconds};
/// let mut seconds = [0.0; 2];
/// complete_seconds(Moduli::Parameters(&[0.5, 1.0]), &mut seconds)?;
/// assert_eq!(seconds, [1.3506438810476755, 1.0]);
/// # Ok::<(), libration::elliptic::LengthMismatch>(())
/// ```
pub fn complete_seconds(moduli: Moduli<'_>, seconds: &mut [f64]) -> Result<(), LengthMismatch> {
    LengthMismatch::check(moduli.values(), seconds)?;
    dispatch_slices(Each { moduli, results: seconds, function: second_with });
    Ok(())
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
/// use libration::elliptic::{Moduli, nomes};
/// let mut found = [0.0; 2];
/// nomes(Moduli::Parameters(&[0.5, 1.0]), &mut found)?;
/// assert_eq!(found, [0.04321391826377225, 1.0]); // e^−π
/// # Ok::<(), libration::elliptic::LengthMismatch>(())
/// ```
pub fn nomes(moduli: Moduli<'_>, nomes: &mut [f64]) -> Result<(), LengthMismatch> {
    LengthMismatch::check(moduli.values(), nomes)?;
    dispatch_slices(Nomes { moduli, nomes });
    Ok(())
}
