//! Power series in one variable with rational coefficients, each with as many coefficients as are certain.

use crate::algebra::{Function, Rational, Rationals, Ring};
use crate::derivation::evaluate::{Analysis, NoValue};

/// Series of this many coefficients.
#[derive(Clone, Copy, Debug)]
pub(in crate::derivation) struct PowerSeries {
    pub(in crate::derivation) length: usize,
}

/// The coefficients that are certain, constant term first.
pub(in crate::derivation) type Coefficients = Vec<Rational>;

impl PowerSeries {
    /// The variable itself.
    pub(in crate::derivation) fn variable(self) -> Coefficients {
        self.monomial(1)
    }

    fn monomial(self, power: usize) -> Coefficients {
        let one_at = |n| Rational::from(i64::from(n == power));
        (0..self.length).map(one_at).collect()
    }

    /// Σ cₙ·xⁿ for a series x that begins with its first power.
    fn compose(self, x: &Coefficients, coefficient: impl Fn(i64) -> Rational) -> Option<Coefficients> {
        if !x.first()?.is_zero() {
            return None;
        }
        let powers = (0..i64::try_from(x.len()).ok()?).rev();
        Some(powers.fold(self.zero(), |sum, n| {
            let product = self.multiply(&sum, x);
            self.add(&product, &constant(coefficient(n), x.len()))
        }))
    }
}

fn constant(value: Rational, length: usize) -> Coefficients {
    let mut coefficients = vec![Rational::from(0); length];
    if let Some(first) = coefficients.first_mut() {
        *first = value;
    }
    coefficients
}

fn zip(a: &Coefficients, b: &Coefficients, f: impl Fn(Rational, Rational) -> Rational) -> Coefficients {
    a.iter().zip(b).map(|(a, b)| f(a.clone(), b.clone())).collect()
}

impl Ring for PowerSeries {
    type Element = Coefficients;

    fn zero(&self) -> Coefficients {
        vec![Rational::from(0); self.length]
    }

    fn is_zero(&self, a: &Coefficients) -> bool {
        a.iter().all(Rational::is_zero)
    }

    fn rational(&self, value: &Rational) -> Option<Coefficients> {
        Some(constant(value.clone(), self.length))
    }

    fn add(&self, a: &Coefficients, b: &Coefficients) -> Coefficients {
        zip(a, b, |a, b| a + b)
    }

    fn subtract(&self, a: &Coefficients, b: &Coefficients) -> Coefficients {
        zip(a, b, |a, b| a - b)
    }

    fn negate(&self, a: &Coefficients) -> Coefficients {
        a.iter().map(|a| -a.clone()).collect()
    }

    fn multiply(&self, a: &Coefficients, b: &Coefficients) -> Coefficients {
        let length = a.len().min(b.len());
        let coefficient = |n: usize| {
            let terms = (0..=n).filter(|&i| !a[i].is_zero() && !b[n - i].is_zero());
            terms.fold(Rational::from(0), |sum, i| sum + a[i].clone() * b[n - i].clone())
        };
        (0..length).map(coefficient).collect()
    }

    fn times_integer(&self, a: &Coefficients, factor: i64) -> Coefficients {
        a.iter().map(|a| a.clone() * Rational::from(factor)).collect()
    }

    /// Both are first divided by the power of the variable that the divisor begins with, which costs that many
    /// coefficients.
    fn divide(&self, a: &Coefficients, divisor: &Coefficients) -> Option<Coefficients> {
        let shift = divisor.iter().position(|c| !c.is_zero())?;
        if !a.iter().take(shift).all(Rational::is_zero) {
            return None;
        }
        let (a, b) = (a.get(shift..)?, &divisor[shift..]);
        let mut quotient: Coefficients = Vec::with_capacity(a.len());
        for n in 0..a.len().min(b.len()) {
            let known =
                (1..=n).fold(Rational::from(0), |sum, i| sum + b[i].clone() * quotient[n - i].clone());
            quotient.push((a[n].clone() - known).checked_div(&b[0])?);
        }
        Some(quotient)
    }

    fn over_integer(&self, a: &Coefficients, divisor: u64) -> Option<Coefficients> {
        let divisor = Rational::from(i64::try_from(divisor).ok()?);
        a.iter().map(|a| a.checked_div(&divisor)).collect()
    }

    /// By the series of the function at zero; other places have no rational values.
    fn value(&self, function: Function, at: &Coefficients) -> Option<Coefficients> {
        let odd = |n: i64| n % 2 == 1;
        let alternating = |n: i64| if n % 4 < 2 { 1 } else { -1 };
        let over = |n: i64, sign: i64| inverse_factorial(n) * Rational::from(sign);
        match function {
            Function::Sqrt => self.power(at, &Rational::new(1, 2)?),
            Function::Sin => self.compose(at, |n| over(n, if odd(n) { alternating(n) } else { 0 })),
            Function::Cos => self.compose(at, |n| over(n, if odd(n) { 0 } else { alternating(n) })),
            Function::Exp => self.compose(at, |n| over(n, 1)),
            Function::Sinh => self.compose(at, |n| over(n, i64::from(odd(n)))),
            Function::Cosh => self.compose(at, |n| over(n, i64::from(!odd(n)))),
            Function::Tanh => self.divide(&self.value(Function::Sinh, at)?, &self.value(Function::Cosh, at)?),
            Function::Tan => self.divide(&self.value(Function::Sin, at)?, &self.value(Function::Cos, at)?),
            Function::Ln => {
                let one = Rational::from(1);
                let excess = self.subtract(at, &constant(one, at.len()));
                let sign = |n: i64| if odd(n) { 1 } else { -1 };
                self.compose(&excess, |n| Rational::new(sign(n), n).unwrap_or_else(|| Rational::from(0)))
            }
            _ => None,
        }
    }

    /// Of series whose first coefficient has a power that is a fraction.
    fn power(&self, a: &Coefficients, exponent: &Rational) -> Option<Coefficients> {
        let first = a.first()?;
        let scale = Rationals.power(first, exponent)?;
        let unit: Option<Coefficients> = a.iter().map(|c| c.checked_div(first)).collect();
        let excess = self.subtract(&unit?, &constant(Rational::from(1), a.len()));
        let power = self.compose(&excess, |n| binomial(exponent, n))?;
        Some(power.into_iter().map(|c| c * scale.clone()).collect())
    }

    fn pi(&self) -> Option<Coefficients> {
        None
    }
}

fn inverse_factorial(n: i64) -> Rational {
    (2..=n).fold(Rational::from(1), |product, i| {
        product * Rational::new(1, i).unwrap_or_else(|| Rational::from(0))
    })
}

/// The generalised binomial coefficient: p(p − 1)…(p − n + 1)/n!.
fn binomial(p: &Rational, n: i64) -> Rational {
    (0..n).fold(inverse_factorial(n), |product, i| product * (p.clone() - Rational::from(i)))
}

impl Analysis for PowerSeries {
    fn is_negligible(&self, term: &Coefficients, _sum: &Coefficients) -> bool {
        self.is_zero(term)
    }

    fn most_terms(&self) -> usize {
        self.length
    }

    fn integral(
        &self,
        _from: &Coefficients,
        _to: &Coefficients,
        _integrand: &mut dyn FnMut(Coefficients) -> Result<Coefficients, NoValue>,
    ) -> Result<Coefficients, NoValue> {
        Err(NoValue::NotInRing("an integral of series"))
    }

    fn slope(
        &self,
        _function: &mut dyn FnMut(Coefficients) -> Result<Coefficients, NoValue>,
    ) -> Result<Coefficients, NoValue> {
        Err(NoValue::NotInRing("a derivative of series"))
    }

    /// Each step doubles the coefficients that agree.
    fn agm(&self, a: &Coefficients, b: &Coefficients) -> Option<Coefficients> {
        let (mut a, mut b) = (a.clone(), b.clone());
        for _ in 0..=self.length {
            if self.is_zero(&self.subtract(&a, &b)) {
                return Some(a);
            }
            let mean = self.over_integer(&self.add(&a, &b), 2)?;
            b = self.value(Function::Sqrt, &self.multiply(&a, &b))?;
            a = mean;
        }
        None
    }

    /// Nothing, if the order lies beyond what is compared.
    fn left_out(&self, order: &Coefficients) -> Result<Coefficients, NoValue> {
        let begins = order.iter().position(|c| !c.is_zero()).unwrap_or(order.len());
        Ok(vec![Rational::from(0); begins])
    }
}
