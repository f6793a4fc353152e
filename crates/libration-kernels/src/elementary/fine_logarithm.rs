//! The natural logarithm in two words, without branches.
//!
//! # Method
//! In a batch the series is summed term by term over the block of 64 elements: a single chain of dependent operations, for four elements at a
//! time, would wait for its own results.

use super::logarithm::exponent_and_scale;
use super::polynomial;
use crate::double_double::block::{BLOCK, Words};
use crate::double_double::{DoubleDouble, two_sum};

/// (2 atanh q − 2q)/q³ in q² for |q| ≤ (√2−1)/(√2+1), relative error 3.4e-31 (of a term below 1 %); first the coefficients that need the second
/// word.
const LEADING: [DoubleDouble; 9] = [
    DoubleDouble::new(0.6666666666666666, 3.7007434154171673e-17),
    DoubleDouble::new(0.4, -2.2204460489647083e-17),
    DoubleDouble::new(0.2857142857142857, 1.5860322619057462e-17),
    DoubleDouble::new(0.2222222222222222, 1.2341290182548396e-17),
    DoubleDouble::new(0.18181818181818182, -7.530009580805913e-18),
    DoubleDouble::new(0.15384615384615452, -6.706121431762106e-19),
    DoubleDouble::new(0.1333333333332149, 1.319182283057908e-17),
    DoubleDouble::new(0.11764705883764007, 2.135908702224701e-18),
    DoubleDouble::new(0.10526315672433624, -1.7478591914477677e-18),
];
const TAIL: [f64; 5] =
    [0.09523816351945204, 0.08695373279771446, 0.08007793723245658, 0.07266003381007335, 0.08380425306818351];

/// ln x = exponent·ln 2 + fraction, |fraction| ≤ ln 2/2.
#[derive(Debug)]
pub struct FineLogarithm {
    /// An integer.
    pub exponent: f64,
    /// Relative error below 2⁻¹⁰⁰.
    pub fraction: DoubleDouble,
}

/// The parts of ln x for x from 2.3e-308 to 1e307; arbitrary values for other x.
#[inline(always)]
pub fn fine_logarithm(x: DoubleDouble) -> FineLogarithm {
    let ReducedArgument { exponent, q } = ReducedArgument::new(x);
    let square = q.square();
    let mut sum = tail(square);
    let mut i = LEADING.len();
    while i > 0 {
        i -= 1;
        sum = LEADING[i].plus_product(square, sum);
    }
    FineLogarithm { exponent, fraction: fraction(q, square, sum) }
}

/// x = 2ᵉ·(1 + q)/(1 − q), |q| ≤ (√2−1)/(√2+1).
struct ReducedArgument {
    exponent: f64,
    q: DoubleDouble,
}

impl ReducedArgument {
    #[inline(always)]
    fn new(x: DoubleDouble) -> Self {
        let (exponent, scale) = exponent_and_scale(x.hi);
        let x = x.scaled(scale);
        // The difference of the first words is exact.
        Self { exponent, q: two_sum(x.hi - 1.0, x.lo).over(x + 1.0) }
    }
}

/// The later terms of the series, in one word.
#[inline(always)]
fn tail(square: DoubleDouble) -> DoubleDouble {
    DoubleDouble::from(polynomial(square.hi, &TAIL))
}

/// 2 atanh q from q, its square and the sum of the series.
#[inline(always)]
fn fraction(q: DoubleDouble, square: DoubleDouble, sum: DoubleDouble) -> DoubleDouble {
    q.scaled(2.0).plus_smaller(q * square * sum)
}

/// [`fine_logarithm`] of a block, bit for bit. The series is summed term by term over the block, because the chain of dependent operations of
/// one element is longer than the processor can look ahead.
#[repr(align(64))]
#[derive(Debug)]
pub struct FineLogarithms {
    exponents: [f64; BLOCK],
    quotients: Words,
    squares: Words,
    sums: Words,
}

impl FineLogarithms {
    /// The logarithms of a block of positive numbers.
    #[inline(always)]
    pub fn new(numbers: &Words) -> Self {
        let mut logarithms =
            Self { exponents: [0.0; BLOCK], quotients: Words::ZERO, squares: Words::ZERO, sums: Words::ZERO };
        for i in 0..BLOCK {
            let ReducedArgument { exponent, q } = ReducedArgument::new(numbers.get(i));
            let square = q.square();
            logarithms.exponents[i] = exponent;
            logarithms.quotients.set(i, q);
            logarithms.squares.set(i, square);
            logarithms.sums.set(i, tail(square));
        }
        for leading in LEADING.iter().rev() {
            for i in 0..BLOCK {
                logarithms
                    .sums
                    .set(i, leading.plus_product(logarithms.squares.get(i), logarithms.sums.get(i)));
            }
        }
        logarithms
    }

    /// Returns the logarithm at index `i`.
    #[inline(always)]
    pub fn get(&self, i: usize) -> FineLogarithm {
        let fraction = fraction(self.quotients.get(i), self.squares.get(i), self.sums.get(i));
        FineLogarithm { exponent: self.exponents[i], fraction }
    }
}
