//! The product of polynomials with integer coefficients, as one product of two large integers.

use dashu_base::{BitTest, Sign, UnsignedAbs};
use dashu_int::{IBig, UBig};

/// The product of two polynomials with integer coefficients, constant term first, by Kronecker substitution: both polynomials are evaluated at a
/// power of two that is large enough to keep the coefficients of the product apart.
///
/// Reference: D. Harvey, *Faster polynomial multiplication via multipoint Kronecker substitution*, J. Symbolic
/// Comput. 44, 1502 (2009), section 2.
pub fn product(a: &[IBig], b: &[IBig]) -> Vec<IBig> {
    if a.is_empty() || b.is_empty() {
        return Vec::new();
    }
    let slot = slot_bits(a, b);
    unpack(&(pack(a, slot) * pack(b, slot)), slot, a.len() + b.len() - 1)
}

/// Bits for the largest possible coefficient of the product and its sign, rounded up to whole 64-bit words.
fn slot_bits(a: &[IBig], b: &[IBig]) -> usize {
    let summands = a.len().min(b.len());
    let carry_bits = (usize::BITS - summands.leading_zeros()) as usize;
    (largest_bits(a) + largest_bits(b) + carry_bits + 1).next_multiple_of(64)
}

fn largest_bits(coefficients: &[IBig]) -> usize {
    coefficients.iter().map(BitTest::bit_len).max().unwrap_or(0)
}

/// The value of the polynomial at 2^slot; slot is a whole number of bytes.
fn pack(coefficients: &[IBig], slot: usize) -> IBig {
    let part = |sign: Sign| {
        let mut bytes = vec![0; coefficients.len() * slot / 8];
        for (part_of_bytes, coefficient) in bytes.chunks_mut(slot / 8).zip(coefficients) {
            if coefficient.sign() == sign {
                let magnitude = coefficient.unsigned_abs().to_le_bytes();
                part_of_bytes[..magnitude.len()].copy_from_slice(&magnitude);
            }
        }
        IBig::from(UBig::from_le_bytes(&bytes))
    };
    part(Sign::Positive) - part(Sign::Negative)
}

/// The first `length` coefficients of the polynomial with this value at 2^slot, as digits in balanced form.
fn unpack(value: &IBig, slot: usize, length: usize) -> Vec<IBig> {
    let (sign, magnitude) = value.clone().into_parts();
    let base = IBig::ONE << slot;
    let mut digits = magnitude.to_chunks(slot).into_vec().into_iter();
    let mut borrowed = false;
    (0..length)
        .map(|_| {
            let digit = IBig::from(digits.next().unwrap_or_default()) + IBig::from(u8::from(borrowed));
            borrowed = digit.bit_len() >= slot;
            let balanced = if borrowed { digit - &base } else { digit };
            sign * balanced
        })
        .collect()
}
