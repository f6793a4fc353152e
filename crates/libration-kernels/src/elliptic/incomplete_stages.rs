//! Incomplete integrals of many angles and moduli, stage by stage.

use super::Modulus;
use super::carlson::{Closeness, Duplication};
use super::complete_stages::OfModulusWords;
use super::incomplete::{
    First, OfAngle, Reduced, Second, duplication, in_first_quarter, is_extreme, is_in_first_quarter,
    of_extreme, whole,
};
use super::moduli::{FEW, LengthMismatch, Moduli};
use super::modulus_stages::ModulusStages;
use crate::dispatch::{Kernel, dispatch_slices};
use crate::double_double::block::{BLOCK, Words};
use crate::double_double::pick;
use std::marker::PhantomData;

/// Legendre's incomplete integral of the first kind F(φ, k) of each pair of angle (rad) and modulus (DLMF 19.2.4):
/// [`Modulus::incomplete_first`](super::Modulus::incomplete_first), bit for bit.
///
/// # Domain
/// Every finite φ, moduli from 0 to 1; NaN for others. For k = 1 infinite from |φ| = π/2 on.
/// # Accuracy
/// 0.56 ulp for k′ ≥ 1e-300 (ledger in `tests/suite/promises.rs`).
/// # Errors
/// The slices have different lengths.
/// # Examples
/// ```
/// # extern crate libration_kernels as libration;
/// use libration::elliptic::{Moduli, incomplete_firsts};
/// let mut integrals = [0.0; 2];
/// incomplete_firsts(&[1.0, 1.0], Moduli::Parameters(&[0.0, 0.5]), &mut integrals)?;
/// assert_eq!(integrals, [1.0, 1.0832167728451687]);
/// # Ok::<(), libration::elliptic::LengthMismatch>(())
/// ```
pub fn incomplete_firsts(
    angles: &[f64],
    moduli: Moduli<'_>,
    firsts: &mut [f64],
) -> Result<(), LengthMismatch> {
    each::<First>(angles, moduli, firsts, Modulus::incomplete_first)
}

/// Legendre's incomplete integral of the second kind E(φ, k) of each pair of angle (rad) and modulus (DLMF 19.2.5):
/// [`Modulus::incomplete_second`](super::Modulus::incomplete_second), bit for bit.
///
/// # Domain
/// Every finite φ, moduli from 0 to 1; NaN for others.
/// # Accuracy
/// 0.56 ulp for k′ ≥ 1e-300 (ledger in `tests/suite/promises.rs`).
/// # Errors
/// The slices have different lengths.
/// # Examples
/// ```
/// # extern crate libration_kernels as libration;
/// use libration::elliptic::{Moduli, incomplete_seconds};
/// let mut integrals = [0.0; 2];
/// incomplete_seconds(&[1.0, 1.0], Moduli::Parameters(&[0.0, 0.5]), &mut integrals)?;
/// assert_eq!(integrals, [1.0, 0.92732988362444]);
/// # Ok::<(), libration::elliptic::LengthMismatch>(())
/// ```
pub fn incomplete_seconds(
    angles: &[f64],
    moduli: Moduli<'_>,
    seconds: &mut [f64],
) -> Result<(), LengthMismatch> {
    each::<Second>(angles, moduli, seconds, Modulus::incomplete_second)
}

fn each<F: OfAngle + OfModulusWords>(
    angles: &[f64],
    moduli: Moduli<'_>,
    results: &mut [f64],
    one: fn(&Modulus, f64) -> f64,
) -> Result<(), LengthMismatch> {
    LengthMismatch::check(angles, moduli.values())?;
    LengthMismatch::check(angles, results)?;
    if angles.len() <= FEW {
        for (i, result) in results.iter_mut().enumerate() {
            *result = match moduli.inside(i).filter(|_| is_in_first_quarter(angles[i])) {
                Some(nearer) => in_first_quarter::<F>(&nearer, angles[i]),
                None => moduli.modulus(i).map_or(f64::NAN, |modulus| one(&modulus, angles[i])),
            };
        }
        return Ok(());
    }
    dispatch_slices(Each { angles, moduli, results, function: PhantomData::<F> });
    Ok(())
}

struct Each<'a, F> {
    angles: &'a [f64],
    moduli: Moduli<'a>,
    results: &'a mut [f64],
    function: PhantomData<F>,
}

impl<F: OfAngle + OfModulusWords> Kernel for Each<'_, F> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let mut stages = IncompleteStages::new();
        let inputs = self.angles.chunks(BLOCK).zip(self.moduli.values().chunks(BLOCK));
        for ((angles, values), written) in inputs.zip(self.results.chunks_mut(BLOCK)) {
            stages.block::<F>(angles, values, &self.moduli);
            written.copy_from_slice(&stages.results[..written.len()]);
        }
    }
}

/// Results of each stage for the next.
#[repr(align(64))]
struct IncompleteStages {
    modulus: ModulusStages,
    angle: [f64; BLOCK],
    half_turns: Words,
    sine: Words,
    cosine: Words,
    /// One for elements whose duplication continues.
    going: [f64; BLOCK],
    roots: [Words; 3],
    arguments: [Words; 3],
    sum: Words,
    power: [f64; BLOCK],
    quarter: Words,
    results: [f64; BLOCK],
}

impl IncompleteStages {
    fn new() -> Self {
        Self {
            modulus: ModulusStages::ZERO,
            angle: [0.5; BLOCK],
            half_turns: Words::ZERO,
            sine: Words::ZERO,
            cosine: Words::ZERO,
            going: [0.0; BLOCK],
            roots: [Words::ZERO; 3],
            arguments: [Words::ZERO; 3],
            sum: Words::ZERO,
            power: [0.0; BLOCK],
            quarter: Words::ZERO,
            results: [0.0; BLOCK],
        }
    }

    /// Computes up to a block of elements; the rest of the block is computed too and dropped.
    #[inline(always)]
    fn block<F: OfAngle + OfModulusWords>(&mut self, angles: &[f64], values: &[f64], moduli: &Moduli<'_>) {
        let mut block = [0.5; BLOCK];
        block[..values.len()].copy_from_slice(values);
        self.angle[..angles.len()].copy_from_slice(angles);
        self.modulus.load(moduli, &block);
        self.reduce();
        self.duplicate::<F>();
        self.quarters::<F>();
        for i in 0..BLOCK {
            let partial = F::partial(&self.modulus.nearer(i), &self.reduced(i), &self.duplication(i));
            let value = whole(self.half_turns.get(i), self.quarter.get(i), partial);
            self.results[i] = self.modulus.inside[i] * value;
        }
        for i in 0..angles.len() {
            if is_extreme(self.angle[i]) {
                self.results[i] = self.modulus.inside[i] * of_extreme(self.angle[i], self.quarter.get(i));
            }
        }
    }

    #[inline(always)]
    fn reduce(&mut self) {
        for i in 0..BLOCK {
            let reduced = Reduced::new(self.angle[i]);
            self.half_turns.set(i, reduced.half_turns);
            self.sine.set(i, reduced.sine);
            self.cosine.set(i, reduced.cosine);
        }
        for i in 0..BLOCK {
            let duplication = duplication(&self.modulus.nearer(i), &self.reduced(i));
            self.set_duplication(i, &duplication);
            self.going[i] = 1.0;
        }
    }

    /// Repeats the duplication until every element of the block has converged; those that have converged are unchanged.
    #[inline(always)]
    fn duplicate<F: OfAngle>(&mut self) {
        loop {
            let mut going = 0.0;
            for i in 0..BLOCK {
                let close = self.duplication(i).is_close(Closeness::Rounding);
                self.going[i] = if close { 0.0 } else { 1.0 };
                going += self.going[i];
            }
            if going == 0.0 {
                return;
            }
            for i in 0..BLOCK {
                let before = self.duplication(i);
                let mut after = before;
                if F::SECOND {
                    after.step::<true>();
                } else {
                    after.step::<false>();
                }
                self.set_duplication(i, &chosen(self.going[i] > 0.5, &after, &before));
            }
        }
    }

    /// The integrals over a quarter turn, if some angle is beyond it.
    #[inline(always)]
    fn quarters<F: OfModulusWords>(&mut self) {
        let mut beyond = 0.0;
        for i in 0..BLOCK {
            beyond += if self.half_turns.hi[i] == 0.0 { 0.0 } else { 1.0 };
        }
        if beyond > 0.0 {
            self.modulus.descend();
            self.modulus.logarithms();
            for i in 0..BLOCK {
                let (nearer, descent) = (self.modulus.nearer(i), self.modulus.descent(i));
                self.quarter.set(i, F::words(&nearer, &descent, self.modulus.log.get(i)));
            }
        }
    }

    #[inline(always)]
    fn reduced(&self, i: usize) -> Reduced {
        Reduced { half_turns: self.half_turns.get(i), sine: self.sine.get(i), cosine: self.cosine.get(i) }
    }

    #[inline(always)]
    fn duplication(&self, i: usize) -> Duplication {
        let [[x, y, z], [xx, yy, zz]] = [&self.roots, &self.arguments];
        Duplication {
            roots: [x.get(i), y.get(i), z.get(i)],
            arguments: [xx.get(i), yy.get(i), zz.get(i)],
            sum: self.sum.get(i),
            power: self.power[i],
        }
    }

    #[inline(always)]
    fn set_duplication(&mut self, i: usize, duplication: &Duplication) {
        for j in 0..3 {
            self.roots[j].set(i, duplication.roots[j]);
            self.arguments[j].set(i, duplication.arguments[j]);
        }
        self.sum.set(i, duplication.sum);
        self.power[i] = duplication.power;
    }
}

#[inline(always)]
fn chosen(condition: bool, yes: &Duplication, no: &Duplication) -> Duplication {
    let three = |yes: &[_; 3], no: &[_; 3]| [0, 1, 2].map(|j| pick(condition, yes[j], no[j]));
    Duplication {
        roots: three(&yes.roots, &no.roots),
        arguments: three(&yes.arguments, &no.arguments),
        sum: pick(condition, yes.sum, no.sum),
        power: if condition { yes.power } else { no.power },
    }
}
