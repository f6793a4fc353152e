//! Polynomials in θ′, sin θ, cos θ and harmonics of the drive, with complex coefficients in `f64`.

use libration_numbers::algebra::Complex;
use libration_numbers::expression::{Expression, Function, Symbol};
use libration_numbers::internals::algebra::ordered_map;
use std::collections::BTreeMap;

/// Maximum number of terms of a useful closed form.
const MOST_TERMS: usize = 4096;
/// The largest power that is expanded.
const MOST_FACTORS: u64 = 64;
/// Relative difference below which a frequency counts as a multiple of the drive frequency.
const SAME: f64 = 1e-12;

/// θ′ⁿ·sinˢθ·cosᵐθ·e^{ikΩt}, s = 0 or 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Monomial {
    pub(super) velocity: u32,
    pub(super) sines: u32,
    pub(super) cosines: u32,
    pub(super) harmonic: i32,
}

/// A sum of trigonometric terms.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Trigonometric {
    pub(super) terms: BTreeMap<Monomial, Complex>,
}

/// Names of the quantities in a formula.
#[derive(Clone, Debug)]
pub(super) struct Names {
    pub(super) angle: Symbol,
    pub(super) velocity: Symbol,
    pub(super) time: Symbol,
    /// Ω, zero if nothing depends on the time.
    pub(super) frequency: f64,
}

const ONE: Monomial = Monomial { velocity: 0, sines: 0, cosines: 0, harmonic: 0 };

impl Trigonometric {
    /// The formula as such a sum; `None` if it is not one, or has too many terms.
    pub(super) fn from_tree(formula: &Expression, names: &Names) -> Option<Self> {
        let of = |part: &Expression| Self::from_tree(part, names);
        let sum = match formula {
            _ if formula.symbols().is_empty() => Self::constant(formula.to_f64()?),
            Expression::Symbol(symbol) if *symbol == names.velocity => {
                Self::of(Monomial { velocity: 1, ..ONE }, 1.0.into())
            }
            Expression::Negate(a) => of(a)?.scaled((-1.0).into()),
            Expression::Add(a, b) => of(a)?.plus(&of(b)?),
            Expression::Subtract(a, b) => of(a)?.plus(&of(b)?.scaled((-1.0).into())),
            Expression::Multiply(a, b) => of(a)?.times(&of(b)?)?,
            Expression::Divide(a, b) if b.symbols().is_empty() => of(a)?.scaled((1.0 / b.to_f64()?).into()),
            Expression::Power(a, b) => {
                let power = b.to_rational()?.to_natural().filter(|power| *power <= MOST_FACTORS)?;
                let base = of(a)?;
                (0..power).try_fold(Self::constant(1.0), |product, _| product.times(&base))?
            }
            Expression::Call(Function::Sin, a) => {
                let wave = Self::wave(a, names)?;
                wave.parts([Complex::new(0.0, -0.5), Complex::new(0.0, 0.5)])
            }
            Expression::Call(Function::Cos, a) => Self::wave(a, names)?.parts([0.5.into(); 2]),
            _ => return None,
        };
        let finite = sum.terms.values().all(|coefficient| coefficient.is_finite());
        (finite && sum.terms.len() <= MOST_TERMS).then_some(sum)
    }

    fn constant(value: f64) -> Self {
        Self::of(ONE, value.into())
    }

    fn of(monomial: Monomial, coefficient: Complex) -> Self {
        Self { terms: ordered_map(std::iter::once((monomial, coefficient))) }
    }

    /// e^{i·argument} for an argument aθ + kΩt + c.
    fn wave(argument: &Expression, names: &Names) -> Option<Self> {
        let slope = |symbol: &Symbol| {
            let slope = argument.derivative(symbol).simplified();
            slope.symbols().is_empty().then(|| slope.to_f64()).flatten()
        };
        let of_angle = nearest_integer(slope(&names.angle)?)?;
        let of_time = match slope(&names.time)? {
            0.0 => 0,
            _ if names.frequency == 0.0 => return None,
            some => nearest_integer(some / names.frequency)?,
        };
        if argument.contains(&names.velocity) {
            return None;
        }
        let zero = Expression::from(0);
        let at_zero = argument.substitute(&names.angle, &zero).substitute(&names.time, &zero);
        let phase = at_zero.symbols().is_empty().then(|| at_zero.to_f64()).flatten()?;
        let turn = Self::of(Monomial { harmonic: of_time, ..ONE }, Complex::unit(phase));
        let sine = Complex::new(0.0, if of_angle < 0 { -1.0 } else { 1.0 });
        let along = Self::of(Monomial { cosines: 1, ..ONE }, 1.0.into())
            .plus(&Self::of(Monomial { sines: 1, ..ONE }, sine));
        if u64::from(of_angle.unsigned_abs()) > MOST_FACTORS {
            return None;
        }
        (0..of_angle.unsigned_abs()).try_fold(turn, |product, _| product.times(&along))
    }

    /// a·w + b·w̄, where w is this wave of the real θ and t.
    fn parts(&self, [factor, conjugate]: [Complex; 2]) -> Self {
        let other = self.terms.iter().map(|(monomial, coefficient)| {
            let monomial = Monomial { harmonic: -monomial.harmonic, ..*monomial };
            (monomial, Complex::new(coefficient.re, -coefficient.im))
        });
        self.scaled(factor).plus(&Self { terms: ordered_map(other) }.scaled(conjugate))
    }

    /// The sum in harmonics of the frequency nΩ; `None` if it has harmonics of Ω between these.
    pub(super) fn every(&self, n: i32) -> Option<Self> {
        let term = |(monomial, value): (&Monomial, &Complex)| {
            let harmonic = (monomial.harmonic % n == 0).then_some(monomial.harmonic / n)?;
            Some((Monomial { harmonic, ..*monomial }, *value))
        };
        Some(Self { terms: self.terms.iter().map(term).collect::<Option<_>>()? })
    }

    fn scaled(&self, factor: Complex) -> Self {
        Self { terms: ordered_map(self.terms.iter().map(|(monomial, value)| (*monomial, *value * factor))) }
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (monomial, value) in &other.terms {
            sum.add(*monomial, *value);
        }
        sum
    }

    fn add(&mut self, monomial: Monomial, value: Complex) {
        let entry = self.terms.entry(monomial).or_default();
        *entry = *entry + value;
        if *entry == Complex::default() {
            self.terms.remove(&monomial);
        }
    }

    fn times(&self, other: &Self) -> Option<Self> {
        let mut product = Self::default();
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                let value = *x * *y;
                let monomial = Monomial {
                    velocity: a.velocity + b.velocity,
                    sines: (a.sines + b.sines) % 2,
                    cosines: a.cosines + b.cosines,
                    harmonic: a.harmonic + b.harmonic,
                };
                product.add(monomial, value);
                if a.sines + b.sines == 2 {
                    product.add(Monomial { cosines: monomial.cosines + 2, ..monomial }, -value);
                }
            }
            if product.terms.len() > MOST_TERMS {
                return None;
            }
        }
        Some(product)
    }
}

/// The integer that a number equals up to rounding.
fn nearest_integer(number: f64) -> Option<i32> {
    let rounded = number.round();
    #[expect(clippy::cast_possible_truncation, reason = "below a thousand")]
    let integer = (rounded.abs() < 1e3).then_some(rounded as i32);
    integer.filter(|_| (number - rounded).abs() <= SAME * rounded.abs())
}
