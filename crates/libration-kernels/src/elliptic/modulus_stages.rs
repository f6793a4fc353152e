//! A block of moduli on the way to its quarter periods and nomes, stage by stage.
//!
//! # Method
//! The computation of quarter periods and nomes depends on the modulus only through selections. A block of 64 moduli therefore passes through
//! the same operations, stage by stage, as one modulus does (`modulus_stages.rs`, `jacobi_stages.rs`, `complete_stages.rs`), with the same bits.
//! K has an error of 2⁻¹⁰², and so has the phase, in periods, of any u up to 1e6 K.

use super::descent::Descent;
use super::moduli::Moduli;
use super::nearer::Nearer;
use crate::double_double::block::{BLOCK, Words};
use crate::elementary::FineLogarithms;

/// Results of each stage for the next.
#[repr(align(64))]
#[derive(Debug)]
pub(super) struct ModulusStages {
    /// One, or NaN if the value is not a modulus.
    pub(super) inside: [f64; BLOCK],
    above: [f64; BLOCK],
    raised: [f64; BLOCK],
    smaller: Words,
    root: Words,
    mean: Words,
    epsilon: Words,
    fourth: Words,
    pub(super) log: Words,
}

impl ModulusStages {
    pub(super) const ZERO: Self = Self {
        inside: [0.0; BLOCK],
        above: [0.0; BLOCK],
        raised: [0.0; BLOCK],
        smaller: Words::ZERO,
        root: Words::ZERO,
        mean: Words::ZERO,
        epsilon: Words::ZERO,
        fourth: Words::ZERO,
        log: Words::ZERO,
    };

    /// Loads the nearer sides of the moduli; the values are one block of `moduli`.
    #[inline(always)]
    pub(super) fn load(&mut self, moduli: &Moduli<'_>, values: &[f64; BLOCK]) {
        match moduli {
            Moduli::Parameters(_) => self.load_by(values, Nearer::from_parameter),
            Moduli::ComplementaryParameters(_) => self.load_by(values, Nearer::from_complementary_parameter),
            Moduli::Moduli(_) => self.load_by(values, Nearer::from_modulus),
            Moduli::ComplementaryModuli(_) => self.load_by(values, Nearer::from_complementary_modulus),
        }
        for (inside, value) in self.inside.iter_mut().zip(values) {
            *inside = if *value >= 0.0 && *value <= 1.0 { 1.0 } else { f64::NAN };
        }
    }

    #[inline(always)]
    fn load_by(&mut self, values: &[f64; BLOCK], nearer: impl Fn(f64) -> Nearer) {
        for (i, value) in values.iter().enumerate() {
            self.set(i, nearer(*value));
        }
    }

    #[inline(always)]
    pub(super) fn set(&mut self, i: usize, Nearer { above, smaller, raised, root }: Nearer) {
        self.above[i] = if above { 1.0 } else { 0.0 };
        self.raised[i] = if raised { 1.0 } else { 0.0 };
        self.smaller.set(i, smaller);
        self.root.set(i, root);
    }

    #[inline(always)]
    pub(super) fn descend(&mut self) {
        for i in 0..BLOCK {
            let [mean, epsilon, fourth] = Descent::new(&self.nearer(i)).parts();
            self.mean.set(i, mean);
            self.epsilon.set(i, epsilon);
            self.fourth.set(i, fourth);
        }
    }

    /// The stage after [`Self::descend`].
    #[inline(always)]
    pub(super) fn logarithms(&mut self) {
        let logs = FineLogarithms::new(&self.epsilon);
        for i in 0..BLOCK {
            let log = self.descent(i).log_from(&logs.get(i), self.raised[i] > 0.5);
            self.log.set(i, log);
        }
    }

    #[inline(always)]
    pub(super) fn above(&self, i: usize) -> bool {
        self.above[i] > 0.5
    }

    /// Returns `true` if k = 1.
    #[inline(always)]
    pub(super) fn is_degenerate(&self, i: usize) -> bool {
        self.above(i) && self.smaller.hi[i] == 0.0
    }

    #[inline(always)]
    pub(super) fn nearer(&self, i: usize) -> Nearer {
        Nearer {
            above: self.above(i),
            smaller: self.smaller.get(i),
            raised: self.raised[i] > 0.5,
            root: self.root.get(i),
        }
    }

    #[inline(always)]
    pub(super) fn descent(&self, i: usize) -> Descent {
        Descent::from_parts(self.mean.get(i), self.epsilon.get(i), self.fourth.get(i))
    }
}
