//! The ring of power series in one variable with exact coefficients, kept to a number of terms.

use crate::algebra::{Function, Rational, Ring};

/// Series are their first coefficients, the constant term first. A quotient in which powers cancel keeps fewer.
#[derive(Clone, Copy, Debug)]
pub(super) struct PowerSeries {
    /// How many coefficients are kept.
    pub(super) terms: usize,
}

impl PowerSeries {
    /// The variable itself.
    pub(super) fn variable(self) -> Vec<Rational> {
        let one_at = |n: usize| Rational::from(i64::from(n == 1));
        (0..self.terms).map(one_at).collect()
    }

    /// aᵖ for a₀ = 1, from n·bₙ = Σ (p·k − (n − k))·a_k·b_{n−k}.
    fn power_of_monic(a: &[Rational], exponent: &Rational) -> Option<Vec<Rational>> {
        if *a.first()? != Rational::from(1) {
            return None;
        }
        let mut b = vec![Rational::from(1)];
        for n in 1..a.len() {
            let term = |k: usize| Some((exponent.clone() * whole(k)? - whole(n - k)?) * a[k].clone() * b[n - k].clone());
            let sum = (1..=n).try_fold(Rational::from(0), |sum, k| Some(sum + term(k)?))?;
            b.push(sum.checked_div(&whole(n)?)?);
        }
        Some(b)
    }

    /// The solution of b′ = a′·c and c′ = sign·a′·b with b₀ = 0, c₀ = 1.
    fn sine_and_cosine(a: &[Rational], sign: i64) -> Option<(Vec<Rational>, Vec<Rational>)> {
        if !a.first()?.is_zero() {
            return None;
        }
        let (mut sine, mut cosine) = (vec![Rational::from(0)], vec![Rational::from(1)]);
        for n in 1..a.len() {
            let weighted = |other: &[Rational]| {
                let term = |k: usize| Some(whole(k)? * a[k].clone() * other[n - k].clone());
                (1..=n).try_fold(Rational::from(0), |sum, k| Some(sum + term(k)?))?.checked_div(&whole(n)?)
            };
            let (s, c) = (weighted(&cosine)?, weighted(&sine)?);
            sine.push(s);
            cosine.push(Rational::from(sign) * c);
        }
        Some((sine, cosine))
    }
}

fn whole(n: usize) -> Option<Rational> {
    i64::try_from(n).ok().map(Rational::from)
}

impl Ring for PowerSeries {
    type Element = Vec<Rational>;

    fn zero(&self) -> Vec<Rational> {
        vec![Rational::from(0); self.terms]
    }

    fn is_zero(&self, a: &Vec<Rational>) -> bool {
        a.iter().all(Rational::is_zero)
    }

    fn rational(&self, value: &Rational) -> Option<Vec<Rational>> {
        let mut constant = self.zero();
        *constant.first_mut()? = value.clone();
        Some(constant)
    }

    fn add(&self, a: &Vec<Rational>, b: &Vec<Rational>) -> Vec<Rational> {
        a.iter().zip(b).map(|(a, b)| a.clone() + b.clone()).collect()
    }

    fn subtract(&self, a: &Vec<Rational>, b: &Vec<Rational>) -> Vec<Rational> {
        a.iter().zip(b).map(|(a, b)| a.clone() - b.clone()).collect()
    }

    fn negate(&self, a: &Vec<Rational>) -> Vec<Rational> {
        a.iter().map(|a| -a.clone()).collect()
    }

    fn multiply(&self, a: &Vec<Rational>, b: &Vec<Rational>) -> Vec<Rational> {
        let terms = a.len().min(b.len());
        let coefficient = |n: usize| {
            let pairs = a[..=n].iter().zip(b[..=n].iter().rev()).filter(|(a, b)| !a.is_zero() && !b.is_zero());
            pairs.fold(Rational::from(0), |sum, (a, b)| sum + a.clone() * b.clone())
        };
        (0..terms).map(coefficient).collect()
    }

    fn times_integer(&self, a: &Vec<Rational>, factor: i64) -> Vec<Rational> {
        a.iter().map(|a| a.clone() * Rational::from(factor)).collect()
    }

    fn divide(&self, a: &Vec<Rational>, divisor: &Vec<Rational>) -> Option<Vec<Rational>> {
        let shift = divisor.iter().position(|coefficient| !coefficient.is_zero())?;
        if a.iter().take(shift).any(|coefficient| !coefficient.is_zero()) {
            return None;
        }
        let (a, divisor) = (a.get(shift..)?, &divisor[shift..]);
        let mut quotient: Vec<Rational> = Vec::new();
        for n in 0..a.len().min(divisor.len()) {
            let known = (1..=n).fold(Rational::from(0), |sum, k| sum + divisor[k].clone() * quotient[n - k].clone());
            quotient.push((a[n].clone() - known).checked_div(&divisor[0])?);
        }
        Some(quotient)
    }

    fn over_integer(&self, a: &Vec<Rational>, divisor: u64) -> Option<Vec<Rational>> {
        let divisor = Rational::from(i64::try_from(divisor).ok()?);
        a.iter().map(|a| a.checked_div(&divisor)).collect()
    }

    /// Where the coefficients stay rational: the root at 1, the others at 0.
    fn value(&self, function: Function, at: &Vec<Rational>) -> Option<Vec<Rational>> {
        match function {
            Function::Sqrt => self.power(at, &Rational::new(1, 2)?),
            Function::Sin => Self::sine_and_cosine(at, -1).map(|(sine, _)| sine),
            Function::Cos => Self::sine_and_cosine(at, -1).map(|(_, cosine)| cosine),
            Function::Sinh => Self::sine_and_cosine(at, 1).map(|(sine, _)| sine),
            Function::Cosh => Self::sine_and_cosine(at, 1).map(|(_, cosine)| cosine),
            Function::Exp => Self::sine_and_cosine(at, 1).map(|(sine, cosine)| self.add(&sine, &cosine)),
            _ => None,
        }
    }

    fn power(&self, a: &Vec<Rational>, exponent: &Rational) -> Option<Vec<Rational>> {
        Self::power_of_monic(a, exponent)
    }

    fn pi(&self) -> Option<Vec<Rational>> {
        None
    }
}
