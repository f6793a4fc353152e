//! Complex numbers in `f64`.

use libration_kernels::elementary::count;
use std::f64::consts::TAU;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The complex number re + i·im.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Complex {
    /// The real part.
    pub re: f64,
    /// The imaginary part.
    pub im: f64,
}

impl Complex {
    /// re + i·im.
    #[must_use]
    pub const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    /// e^{iφ}.
    #[must_use]
    pub fn unit(phase: f64) -> Self {
        Self::new(libm::cos(phase), libm::sin(phase))
    }

    /// |z|.
    #[must_use]
    pub fn abs(self) -> f64 {
        libm::hypot(self.re, self.im)
    }

    /// The angle φ of |z|·e^{iφ}, within −π … π.
    #[must_use]
    pub fn argument(self) -> f64 {
        libm::atan2(self.im, self.re)
    }

    /// z times a real number.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }

    /// zⁿ.
    #[must_use]
    pub fn powi(self, exponent: u32) -> Self {
        (0..exponent).fold(Self::from(1.0), |power, _| power * self)
    }

    /// Returns `true` if both parts are finite.
    #[must_use]
    pub const fn is_finite(self) -> bool {
        self.re.is_finite() && self.im.is_finite()
    }
}

impl From<f64> for Complex {
    fn from(re: f64) -> Self {
        Self { re, im: 0.0 }
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)
    }
}

/// Smith's algorithm, which overflows or underflows only if the quotient does.
impl Div for Complex {
    type Output = Self;
    fn div(self, by: Self) -> Self {
        if by.re.abs() < by.im.abs() {
            let turned = |z: Self| Self::new(z.im, -z.re);
            return turned(self) / turned(by);
        }
        let ratio = by.im / by.re;
        let denominator = by.re + by.im * ratio;
        Self::new((self.re + self.im * ratio) / denominator, (self.im - self.re * ratio) / denominator)
    }
}

impl Neg for Complex {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}

impl std::iter::Sum for Complex {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::default(), Add::add)
    }
}

/// Σ xⱼ·e^{−2πijk/N} for a power of two N, by recursive halving.
#[must_use]
pub fn fourier(samples: &[Complex]) -> Vec<Complex> {
    if samples.len() < 2 {
        return samples.to_vec();
    }
    let part = |first: usize| fourier(&samples.iter().skip(first).step_by(2).copied().collect::<Vec<_>>());
    let (even, odd) = (part(0), part(1));
    let turn = |k: usize| Complex::unit(-TAU * count(k) / count(samples.len()));
    let turned: Vec<Complex> = odd.iter().enumerate().map(|(k, value)| turn(k) * *value).collect();
    let sums = even.iter().zip(&turned).map(|(a, b)| *a + *b);
    sums.chain(even.iter().zip(&turned).map(|(a, b)| *a - *b)).collect()
}
