//! The period of many amplitudes, stage by stage.
//!
//! The computation for one amplitude is a long chain of dependent operations. A block of amplitudes passes through the chain in short loops,
//! which the compiler vectorises and the processor overlaps; the operations, and thus the bits, are those for one amplitude.
//!
//! # Method
//! A block holds 64 amplitudes; `swing_period_stages.rs` adds the period in seconds, the nome and the condition number. A sine in two words is
//! summed term by term over the block (`sin_cos_series_of_block`), since compilers do not vectorise a loop over terms inside a loop over elements.

use super::LengthMismatch;
use super::period::{
    EXCESS, Excess, LOG_NOME, Nearer, OfAmplitude, One, PeriodFunction, Ratio, RatioNearTop, excess_with,
    log_inverse_nome_with, nearer_of_amplitude, ratio_above,
};
use libration_kernels::dispatch::{Kernel, dispatch_slices, fetch_ahead};
use libration_kernels::double_double::DoubleDouble;
use libration_kernels::double_double::block::{BLOCK, Words};
use libration_kernels::elementary::{Logarithm, ReducedLogarithm, polynomial};

/// A function at many arguments, stage by stage.
pub(super) struct Each<'a, P>(pub(super) P, pub(super) &'a [f64], pub(super) &'a mut [f64]);

impl<P: PeriodFunction> Kernel for Each<'_, P> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let (arguments, rest) = self.1.as_chunks::<BLOCK>();
        let (values, rest_values) = self.2.as_chunks_mut::<BLOCK>();
        let mut stages = Stages::ZERO;
        for (x, y) in arguments.iter().zip(values) {
            fetch_ahead(x);
            fetch_ahead(y);
            stages.block::<P>(x, y);
        }
        for (x, y) in rest.iter().zip(rest_values) {
            *y = One(self.0, *x).run();
        }
    }
}

/// [`period_ratio`](super::period_ratio) of each amplitude, bit for bit.
///
/// # Errors
/// The slices have different lengths.
pub fn period_ratios(amplitudes: &[f64], ratios: &mut [f64]) -> Result<(), LengthMismatch> {
    LengthMismatch::check(amplitudes, ratios)?;
    dispatch_slices(Each(OfAmplitude(Ratio), amplitudes, ratios));
    Ok(())
}

/// [`period_excess`](super::period_excess) of each amplitude, bit for bit.
///
/// # Errors
/// The slices have different lengths.
pub fn period_excesses(amplitudes: &[f64], excesses: &mut [f64]) -> Result<(), LengthMismatch> {
    LengthMismatch::check(amplitudes, excesses)?;
    dispatch_slices(Each(OfAmplitude(Excess), amplitudes, excesses));
    Ok(())
}

/// [`period_ratio_near_top`](super::period_ratio_near_top) of each complement, bit for bit.
///
/// # Errors
/// The slices have different lengths.
pub fn period_ratios_near_top(complements: &[f64], ratios: &mut [f64]) -> Result<(), LengthMismatch> {
    LengthMismatch::check(complements, ratios)?;
    dispatch_slices(Each(RatioNearTop, complements, ratios));
    Ok(())
}

/// Results of each stage for the next, word by word, so that they are vectorised.
#[repr(align(64))]
pub(super) struct Stages {
    pub(super) s: Words,
    pub(super) u: Words,
    pub(super) excess: Words,
    pub(super) log: Words,
    exponent: [f64; BLOCK],
    tail: [f64; BLOCK],
}

impl Stages {
    pub(super) const ZERO: Self = Self {
        s: Words::ZERO,
        u: Words::ZERO,
        excess: Words::ZERO,
        log: Words::ZERO,
        exponent: [0.0; BLOCK],
        tail: [0.0; BLOCK],
    };

    #[inline(always)]
    fn block<P: PeriodFunction>(&mut self, arguments: &[f64; BLOCK], values: &mut [f64; BLOCK]) {
        self.load_by(arguments, P::nearer);
        for (i, (argument, value)) in arguments.iter().zip(values).enumerate() {
            let excess = self.excess.get(i);
            *value = P::value(*argument, excess, ratio_above(excess, self.log.get(i)));
        }
    }

    /// Computes the excess and the logarithm for these amplitudes.
    #[inline(always)]
    pub(super) fn load(&mut self, amplitudes: &[f64; BLOCK]) {
        self.load_by(amplitudes, nearer_of_amplitude);
    }

    #[inline(always)]
    fn load_by(&mut self, arguments: &[f64; BLOCK], nearer: impl Fn(f64) -> Nearer) {
        for (i, argument) in arguments.iter().enumerate() {
            let Nearer { s, u } = nearer(*argument);
            self.s.set(i, s);
            self.u.set(i, u);
        }
        self.excess();
        self.log();
    }

    #[inline(always)]
    pub(super) fn excess(&mut self) {
        for i in 0..BLOCK {
            self.excess.hi[i] = polynomial(self.u.hi[i], &EXCESS);
        }
        for i in 0..BLOCK {
            self.excess.set(i, excess_with(self.u.get(i), self.excess.hi[i]));
        }
    }

    #[inline(always)]
    pub(super) fn log(&mut self) {
        for i in 0..BLOCK {
            let reduced = ReducedLogarithm::from_number(self.s.get(i));
            self.exponent[i] = reduced.exponent;
            self.log.set(i, DoubleDouble::new(reduced.q, reduced.q_lo));
        }
        for i in 0..BLOCK {
            let DoubleDouble { hi: q, lo: q_lo } = self.log.get(i);
            let reduced = ReducedLogarithm { exponent: self.exponent[i], q, q_lo };
            (self.log.hi[i], self.tail[i]) = (reduced.leading(), reduced.tail());
        }
        for i in 0..BLOCK {
            self.log.lo[i] = polynomial(self.u.hi[i], &LOG_NOME);
        }
        for i in 0..BLOCK {
            let log = Logarithm { exponent: self.exponent[i], leading: self.log.hi[i], tail: self.tail[i] };
            self.log.set(i, log_inverse_nome_with(&log, self.u.get(i), self.log.lo[i]));
        }
    }
}
