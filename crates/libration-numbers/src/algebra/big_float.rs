//! Binary floats of any precision, for cases in which two words do not suffice.

use std::f64::consts::LN_2;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::LazyLock;

use dashu_base::{BitTest, Sign};
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use dashu_int::{IBig, UBig};

use super::Rational;
use libration_kernels::double_double::DoubleDouble;
use libration_kernels::elementary::count;

type Float = FBig<HalfEven, 2>;

/// A binary float of a chosen precision. Every operation rounds to nearest, and its result has the larger precision of its operands; products and
/// quotients too large for an exponent are an eighth of the largest exponent. The caller avoids division by zero, and roots and logarithms
/// outside their domain.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct BigFloat(Float);

impl BigFloat {
    /// A whole number, rounded to a precision in bits.
    #[must_use]
    pub fn from_integer(integer: i64, precision: usize) -> Self {
        Self(rounded(Float::from(integer), precision))
    }

    /// An `f64`, rounded to a precision in bits; `None` for values that are not finite.
    #[must_use]
    pub fn from_f64(value: f64, precision: usize) -> Option<Self> {
        let value = Float::try_from(value).ok().filter(|_| value.is_finite())?;
        Some(Self(rounded(value, precision)))
    }

    /// A fraction, rounded to a precision in bits.
    #[must_use]
    pub fn from_rational(value: &Rational, precision: usize) -> Self {
        let (numerator, denominator) = value.parts();
        Self::from_big(numerator.clone(), precision)
            / Self::from_big(IBig::from(denominator.clone()), precision)
    }

    /// `hi + lo`, exact if `precision` reaches from the first bit of `hi` to the last bit of `lo`; zero if a word is not finite.
    #[doc(hidden)]
    pub fn from_words(words: DoubleDouble, precision: usize) -> Self {
        let word = |x: f64| match Float::try_from(x) {
            Ok(word) if x.is_finite() => rounded(word, precision),
            _ => Float::default(),
        };
        Self(word(words.hi) + word(words.lo))
    }

    /// π; up to 1280 bits it is computed only once.
    #[must_use]
    pub fn pi(precision: usize) -> Self {
        const KEPT: usize = 1280;
        static PI: LazyLock<Float> = LazyLock::new(|| Float::pi(KEPT));
        if precision < KEPT { Self(rounded(PI.clone(), precision)) } else { Self(Float::pi(precision)) }
    }

    /// Bits of the significand.
    #[must_use]
    pub fn precision(&self) -> usize {
        self.0.precision()
    }

    /// The nearest `f64`, ties to even; the result may be subnormal or infinite.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.0.to_f64().value()
    }

    /// Returns `true` if the number is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0.repr().significand().is_zero()
    }

    /// The exponent e with 2^(e−1) ≤ |x| < 2^e; `None` for zero.
    #[must_use]
    pub fn exponent(&self) -> Option<isize> {
        let repr = self.0.repr();
        let bits = isize::try_from(repr.significand().bit_len()).ok()?;
        (bits > 0).then(|| repr.exponent() + bits)
    }

    /// ln |x| to a few 10⁻¹⁶ of the larger of 1 and |ln x|, hundreds of times faster than [`BigFloat::ln`]; −∞ for zero.
    #[must_use]
    pub fn ln_magnitude(&self) -> f64 {
        let Some(exponent) = self.exponent() else { return f64::NEG_INFINITY };
        let mantissa = (self.0.clone() >> exponent).to_f64().value();
        let size = count(exponent.unsigned_abs()) * LN_2;
        libm::log(mantissa.abs()) + if exponent < 0 { -size } else { size }
    }

    /// √x.
    #[must_use]
    pub fn sqrt(&self) -> Self {
        if self.is_zero() { self.clone() } else { Self(self.0.sqrt()) }
    }

    /// ln x.
    #[must_use]
    pub fn ln(&self) -> Self {
        Self(self.0.ln())
    }

    /// ln(1 + x) with full relative accuracy at small x.
    #[must_use]
    pub fn ln_1p(&self) -> Self {
        Self(self.0.ln_1p())
    }

    /// eˣ.
    #[must_use]
    pub fn exp(&self) -> Self {
        Self(self.0.exp())
    }

    /// sin x.
    #[must_use]
    pub fn sin(&self) -> Self {
        self.advanced_sine(0).unwrap_or_else(|| Self(self.0.sin()))
    }

    /// cos x.
    #[must_use]
    pub fn cos(&self) -> Self {
        self.advanced_sine(1).unwrap_or_else(|| Self(self.0.cos()))
    }

    /// arcsin x.
    #[must_use]
    pub fn asin(&self) -> Self {
        Self(self.0.asin())
    }

    /// arccos x.
    #[must_use]
    pub fn acos(&self) -> Self {
        Self(self.0.acos())
    }

    /// arctan x.
    #[must_use]
    pub fn atan(&self) -> Self {
        Self(self.0.atan())
    }

    /// The number rounded to a precision in bits.
    #[must_use]
    pub fn rounded_to(&self, precision: usize) -> Self {
        Self(rounded(self.0.clone(), precision))
    }

    /// The same number as a fraction.
    #[must_use]
    pub fn to_rational(&self) -> Rational {
        let repr = self.0.repr();
        let (significand, exponent) = (repr.significand().clone(), repr.exponent());
        let scale = UBig::ONE << exponent.unsigned_abs();
        if exponent < 0 {
            Rational::from_parts(significand, scale)
        } else {
            Rational::from_parts(significand * IBig::from(scale), UBig::ONE)
        }
    }

    /// The arithmetic-geometric mean of two positive numbers, to a few units in the last place (DLMF 19.8(i)). Each step doubles the digits that
    /// agree, so one more step suffices once half of the digits agree.
    #[must_use]
    pub fn agm(&self, other: &Self) -> Self {
        let half_the_bits = isize::try_from(self.precision() / 2 + 2).unwrap_or(isize::MAX);
        let (mut a, mut b) = (self.clone(), other.clone());
        loop {
            let gap = (a.clone() - b.clone()).exponent();
            let close = gap.is_none_or(|gap| a.exponent().is_some_and(|size| size - gap >= half_the_bits));
            let mean = (a.clone() + b.clone()).halved();
            if close {
                return mean;
            }
            b = (a * b).sqrt();
            a = mean;
        }
    }

    /// Half of the number, exactly.
    #[must_use]
    pub fn halved(self) -> Self {
        Self(self.0 >> 1)
    }

    /// ⌊x·2^bits⌋.
    pub(super) fn in_units_of(&self, bits: usize) -> IBig {
        let repr = self.0.repr();
        let shift = repr.exponent().saturating_add(bits.cast_signed());
        match usize::try_from(shift) {
            Ok(left) => repr.significand() << left,
            Err(_) => repr.significand() >> shift.unsigned_abs(),
        }
    }

    /// n/2^bits, rounded to a precision.
    pub(super) fn from_units(units: IBig, bits: usize, precision: usize) -> Self {
        Self(rounded(Float::from(units) >> bits.cast_signed(), precision))
    }

    fn from_big(integer: IBig, precision: usize) -> Self {
        Self(rounded(Float::from(integer), precision))
    }
}

/// A value, in place of infinity a number that can be used on: powers of powers exceed all exponents.
fn finite(value: Float) -> BigFloat {
    const LARGEST: isize = isize::MAX / 8;
    let repr = value.repr();
    if !repr.is_infinite() {
        return BigFloat(value);
    }
    let sign = if repr.sign() == Sign::Negative { IBig::NEG_ONE } else { IBig::ONE };
    BigFloat(rounded(Float::from_parts(sign, LARGEST), value.precision()))
}

fn rounded(value: Float, precision: usize) -> Float {
    value.with_precision(precision).value()
}

impl Add for BigFloat {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for BigFloat {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for BigFloat {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        finite(self.0 * other.0)
    }
}

impl Div for BigFloat {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        finite(self.0 / other.0)
    }
}

impl Neg for BigFloat {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}
