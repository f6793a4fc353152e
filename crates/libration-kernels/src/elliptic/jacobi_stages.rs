//! Jacobi's functions of many arguments and moduli, stage by stage.
//!
//! # Method
//! The nome enters the quotients with an error of 2⁻⁶⁹, which the quotients tolerate, and products are added without being normalised first
//! (`plus_product`). Together with the term-by-term logarithm (`fine_logarithm.rs`) this reduced the time for sn, cn, dn and am from 104 to 63
//! ns with AVX2.

use super::jacobi::{Copolar, Factors, Quotients, amplitude, hyperbolic_limit};
use super::moduli::{FEW, LengthMismatch, Moduli};
use super::modulus_stages::ModulusStages;
use super::{CircularSide, HyperbolicSide, Jacobi, Phase, PhaseClock, Side, ThetaSeries, ThetaValues};
use crate::dispatch::{Kernel, dispatch_slices};
use crate::double_double::block::{BLOCK, Words};
use crate::double_double::{DoubleDouble, pick};

/// Output slices for the functions of a batch.
#[derive(Debug)]
pub struct JacobiSlices<'a> {
    /// sn u.
    pub sn: &'a mut [f64],
    /// cn u.
    pub cn: &'a mut [f64],
    /// dn u.
    pub dn: &'a mut [f64],
    /// am u, unwrapped.
    pub am: &'a mut [f64],
}

/// sn, cn, dn and am of each pair of argument and modulus (DLMF 22.2, 22.16.1): [`Modulus::jacobi`](super::Modulus::jacobi), bit
/// for bit, many times as fast.
///
/// # Domain
/// Every finite argument, moduli from 0 to 1; NaN for others. sn, cn and dn are NaN from |u| = 2⁹⁹ K on, as for one argument.
/// # Accuracy
/// 2.2 ulp of the value and 2⁻¹⁰⁰·|u| (ledger in `tests/suite/promises.rs`).
/// # Errors
/// The slices have different lengths.
/// # Examples
/// ```
/// # extern crate libration_kernels as libration;
/// use libration::elliptic::{JacobiSlices, Moduli, Modulus, jacobi_functions};
/// let (arguments, parameters) = ([0.5, 1.0, -3.0], [0.1, 0.5, 0.999]);
/// let [mut sn, mut cn, mut dn, mut am] = [[0.0; 3]; 4];
/// let results = JacobiSlices { sn: &mut sn, cn: &mut cn, dn: &mut dn, am: &mut am };
/// jacobi_functions(&arguments, Moduli::Parameters(&parameters), results)?;
/// assert_eq!(sn[1], Modulus::from_parameter(0.5)?.jacobi(1.0).sn);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn jacobi_functions(
    arguments: &[f64],
    moduli: Moduli<'_>,
    results: JacobiSlices<'_>,
) -> Result<(), LengthMismatch> {
    for slice in [moduli.values(), results.sn, results.cn, results.dn, results.am] {
        LengthMismatch::check(arguments, slice)?;
    }
    if arguments.len() <= FEW {
        let JacobiSlices { sn, cn, dn, am } = results;
        moduli.one_by_one([sn, cn, dn, am], |i, modulus| {
            let Jacobi { sn, cn, dn, am } = modulus.jacobi(arguments[i]);
            [sn, cn, dn, am]
        });
    } else {
        dispatch_slices(Each { arguments, moduli, results });
    }
    Ok(())
}

struct Each<'a> {
    arguments: &'a [f64],
    moduli: Moduli<'a>,
    results: JacobiSlices<'a>,
}

impl Kernel for Each<'_> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let JacobiSlices { sn, cn, dn, am } = self.results;
        let mut stages = JacobiStages::new();
        let inputs = self.arguments.chunks(BLOCK).zip(self.moduli.values().chunks(BLOCK));
        let copolar = sn.chunks_mut(BLOCK).zip(cn.chunks_mut(BLOCK)).zip(dn.chunks_mut(BLOCK));
        for ((inputs, ((sn, cn), dn)), am) in inputs.zip(copolar).zip(am.chunks_mut(BLOCK)) {
            stages.block(inputs.0, inputs.1, &self.moduli);
            let count = sn.len();
            sn.copy_from_slice(&stages.sn[..count]);
            cn.copy_from_slice(&stages.cn[..count]);
            dn.copy_from_slice(&stages.dn[..count]);
            am.copy_from_slice(&stages.am[..count]);
        }
    }
}

/// Results of each stage for the next.
#[repr(align(64))]
struct JacobiStages {
    is_prepared: bool,
    /// The moduli as given.
    prepared: [f64; BLOCK],
    frequency: Words,
    modulus: ModulusStages,
    argument: [f64; BLOCK],
    turns: [f64; BLOCK],
    quarter: [f64; BLOCK],
    rest: Words,
    nome: [f64; BLOCK],
    factors: [Words; 4],
    theta: [Words; 4],
    sn: [f64; BLOCK],
    cn: [f64; BLOCK],
    dn: [f64; BLOCK],
    am: [f64; BLOCK],
}

impl JacobiStages {
    fn new() -> Self {
        Self {
            is_prepared: false,
            prepared: [0.5; BLOCK],
            frequency: Words::ZERO,
            modulus: ModulusStages::ZERO,
            argument: [0.0; BLOCK],
            turns: [0.0; BLOCK],
            quarter: [0.0; BLOCK],
            rest: Words::ZERO,
            nome: [0.0; BLOCK],
            factors: [Words::ZERO; 4],
            theta: [Words::ZERO; 4],
            sn: [0.0; BLOCK],
            cn: [0.0; BLOCK],
            dn: [0.0; BLOCK],
            am: [0.0; BLOCK],
        }
    }

    /// Computes up to a block of elements; the rest of the block is computed too and dropped.
    #[inline(always)]
    fn block(&mut self, arguments: &[f64], values: &[f64], moduli: &Moduli<'_>) {
        self.argument[..arguments.len()].copy_from_slice(arguments);
        // One modulus for many arguments is prepared only once.
        let same = |(value, prepared): (&f64, &f64)| value.to_bits() == prepared.to_bits();
        if !self.is_prepared || !values.iter().zip(&self.prepared).all(same) {
            self.is_prepared = true;
            self.prepared[..values.len()].copy_from_slice(values);
            self.modulus.load(moduli, &self.prepared);
            self.modulus.descend();
            self.modulus.logarithms();
            self.prepare();
        }
        self.places();
        self.values();
        self.quotients();
        self.limits();
    }

    /// Computes the quantities that depend on the moduli alone.
    #[inline(always)]
    fn prepare(&mut self) {
        for i in 0..BLOCK {
            let (nearer, descent) = (self.modulus.nearer(i), self.modulus.descent(i));
            self.frequency.set(i, Quotients::frequency(&nearer, &descent, self.modulus.log.get(i)));
        }
        for i in 0..BLOCK {
            let (nearer, descent) = (self.modulus.nearer(i), self.modulus.descent(i));
            let four_roots = Quotients::four_roots(&nearer, &descent);
            let nome = Quotients::nome(&nearer, &descent);
            let Factors { third, beside, other, odd_other, .. } =
                Factors::new(nearer.above, nome, four_roots);
            for (words, value) in self.factors.iter_mut().zip([third, beside, other, odd_other]) {
                words.set(i, value);
            }
            self.nome[i] = nome.to_f64();
        }
    }

    #[inline(always)]
    fn places(&mut self) {
        for i in 0..BLOCK {
            let frequency = self.frequency.get(i);
            let clock = PhaseClock { frequency, quarter: 0.0, offset: DoubleDouble::ZERO };
            let phase = clock.phase(self.argument[i]);
            (self.turns[i], self.quarter[i]) = (phase.turns, phase.quarter);
            self.rest.set(i, phase.rest);
        }
    }

    #[inline(always)]
    fn values(&mut self) {
        let above: usize = (0..BLOCK).map(|i| usize::from(self.modulus.above(i))).sum();
        if above > 0 {
            for i in 0..BLOCK {
                let scale = self.modulus.log.get(i).scaled(2.0);
                let (sine, cosine) = HyperbolicSide::sine_cosine(self.rest.get(i), scale);
                self.theta[0].set(i, sine);
                self.theta[1].set(i, cosine);
            }
        }
        if above < BLOCK {
            for i in 0..BLOCK {
                let above = self.modulus.above(i);
                let (sine, cosine) = CircularSide::sine_cosine(self.rest.get(i), DoubleDouble::ZERO);
                self.theta[0].set(i, pick(above, self.theta[0].get(i), sine));
                self.theta[1].set(i, pick(above, self.theta[1].get(i), cosine));
            }
        }
        for i in 0..BLOCK {
            let square = if self.modulus.above(i) { HyperbolicSide::SQUARE } else { CircularSide::SQUARE };
            let series = ThetaSeries::new(self.nome[i]);
            let values = series.at_square(self.theta[0].get(i), self.theta[1].get(i), square);
            let values = [values.first, values.second, values.third, values.fourth];
            for (words, value) in self.theta.iter_mut().zip(values) {
                words.set(i, value);
            }
        }
    }

    #[inline(always)]
    fn quotients(&mut self) {
        for i in 0..BLOCK {
            let Copolar { sn, cn, dn } = self.factors(i).copolar(&self.phase(i), &self.theta(i));
            (self.sn[i], self.cn[i], self.dn[i]) = (sn, cn, dn);
        }
        for i in 0..BLOCK {
            let (above, below) = self.factors(i).tangent(&self.phase(i), &self.theta(i));
            self.am[i] = amplitude(&self.phase(i), above, below);
        }
        for i in 0..BLOCK {
            let at = Jacobi { sn: self.sn[i], cn: self.cn[i], dn: self.dn[i], am: self.am[i] };
            let Jacobi { sn, cn, dn, am } = at.or_small(self.argument[i]);
            let inside = self.modulus.inside[i];
            (self.sn[i], self.cn[i], self.dn[i], self.am[i]) =
                (inside * sn, inside * cn, inside * dn, inside * am);
        }
    }

    /// The elements of k = 1.
    #[inline(always)]
    fn limits(&mut self) {
        let mut any = 0.0;
        for i in 0..BLOCK {
            any += if self.modulus.is_degenerate(i) { 1.0 } else { 0.0 };
        }
        if any > 0.0 {
            self.replace_limits();
        }
    }

    #[cold]
    fn replace_limits(&mut self) {
        for i in (0..BLOCK).filter(|&i| self.modulus.is_degenerate(i)) {
            let Jacobi { sn, cn, dn, am } = hyperbolic_limit(self.argument[i]);
            (self.sn[i], self.cn[i], self.dn[i], self.am[i]) = (sn, cn, dn, am);
        }
    }

    #[inline(always)]
    fn factors(&self, i: usize) -> Factors {
        let [third, beside, other, odd_other] = &self.factors;
        Factors {
            above: self.modulus.above(i),
            third: third.get(i),
            beside: beside.get(i),
            other: other.get(i),
            odd_other: odd_other.get(i),
        }
    }

    #[inline(always)]
    fn phase(&self, i: usize) -> Phase {
        Phase { turns: self.turns[i], quarter: self.quarter[i], rest: self.rest.get(i) }
    }

    #[inline(always)]
    fn theta(&self, i: usize) -> ThetaValues {
        let [first, second, third, fourth] = &self.theta;
        ThetaValues { first: first.get(i), second: second.get(i), third: third.get(i), fourth: fourth.get(i) }
    }
}
