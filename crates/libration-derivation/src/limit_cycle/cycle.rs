//! The motion and the frequency of a limit cycle, by powers of the excitation;
//! the amplitude at each power stays undetermined until the next power fixes it.

use super::super::averaging::AveragingQuestion;
use super::super::check::DerivationError;
use super::super::phase::{PhaseFunction, PiNumber, Wave};
use super::open::Open;
use libration::algebra::{Polynomial, Rational, Variable};
use libration::perturbation::Expansion;

/// The result at one power.
pub(super) struct CycleOrder {
    /// The parts of the equation of motion with their contributions to the right side: the index of the term, or `None` for the acceleration.
    pub(super) parts: Vec<(Option<usize>, Polynomial, Open)>,
    /// The sum of the contributions, as a function of the undetermined amplitude one power below.
    pub(super) forcing: Open,
    /// The amplitude one power below.
    pub(super) amplitude_below: Rational,
    /// Ωₙ.
    pub(super) frequency: Rational,
    /// The motion without its first cosine.
    pub(super) forced: PhaseFunction,
}

/// A limit cycle up to some power of the excitation.
pub(super) struct Cycle {
    pub(super) orders: Vec<CycleOrder>,
}

/// Functions of the phase by the power of the excitation, one of them with an undetermined amplitude.
struct LowerOrders {
    motion: Vec<Open>,
    velocity: Vec<Open>,
    frequency: Vec<Rational>,
}

impl Cycle {
    /// Computes the cycle from an initial amplitude, found by another computation, which must satisfy the first condition.
    pub(super) fn new(
        question: &AveragingQuestion,
        order: usize,
        begin: &Rational,
    ) -> Result<Self, DerivationError> {
        let mut orders: Vec<CycleOrder> = vec![];
        for n in 1..=order {
            let next = next(question, &orders, n, begin)?;
            orders.push(next);
        }
        Ok(Self { orders })
    }

    /// The motion at a power, with its amplitude; the amplitude of the last power is not known yet.
    pub(super) fn motion(&self, n: usize) -> Option<PhaseFunction> {
        let amplitude = &self.orders.get(n)?.amplitude_below;
        let wave = PhaseFunction::cosine().scaled(&amplitude.clone().into());
        match n.checked_sub(1) {
            None => Some(wave),
            Some(below) => Some(self.orders.get(below)?.forced.plus(&wave)),
        }
    }

    pub(super) fn frequency(&self, question: &AveragingQuestion, n: usize) -> Rational {
        match n.checked_sub(1) {
            None => question.omega0().clone(),
            Some(below) => {
                self.orders.get(below).map_or_else(|| Rational::from(0), |order| order.frequency.clone())
            }
        }
    }

    /// Returns `true` if the whole cycle equals this expansion.
    pub(super) fn is(&self, question: &AveragingQuestion, expansion: &Expansion) -> bool {
        let omega0 = question.omega0();
        let frequencies = (0..=self.orders.len()).all(|n| {
            let ratio = self.frequency(question, n).checked_div(omega0);
            ratio.as_ref() == expansion.frequency_ratio.get(n)
        });
        let motions = (0..self.orders.len()).all(|n| {
            let Some(motion) = self.motion(n) else { return false };
            let other = expansion.harmonics.iter().fold(PhaseFunction::default(), |sum, harmonic| {
                let part = |series: &[Rational], wave| {
                    let value = series.get(n).cloned().unwrap_or_else(|| Rational::from(0));
                    PhaseFunction::term(0, harmonic.k, wave, PiNumber::from(value))
                };
                sum.plus(&part(&harmonic.cos, Wave::Cosine)).plus(&part(&harmonic.sin, Wave::Sine))
            });
            motion == other
        });
        frequencies && motions
    }
}

fn next(
    question: &AveragingQuestion,
    orders: &[CycleOrder],
    n: usize,
    begin: &Rational,
) -> Result<CycleOrder, DerivationError> {
    let lower = LowerOrders::new(question, orders, n);
    let parts = lower.parts(question, n);
    let forcing = parts.iter().fold(Open::default(), |sum, (_, _, value)| sum.plus(value));
    let sine = forcing.first_harmonic(Wave::Sine);
    let amplitude_below = match n {
        1 => begin.clone(),
        _ => {
            let zero = Rational::from(0);
            let (fixed, factor) = (sine.first().unwrap_or(&zero), sine.get(1).unwrap_or(&zero));
            (-fixed.clone()).checked_div(factor).ok_or(DerivationError::NoCycle)?
        }
    };
    let right = forcing.at(&amplitude_below);
    if !right.coefficient(0, 1, Wave::Sine).is_zero() {
        return Err(DerivationError::NoCycle);
    }
    let omega0 = question.omega0();
    let twice = Rational::from(-2) * omega0.clone() * begin.clone();
    let cosine = right.coefficient(0, 1, Wave::Cosine).to_rational().ok_or(DerivationError::NoCycle)?;
    let frequency = cosine.checked_div(&twice).ok_or(DerivationError::NoCycle)?;
    let mut forced = PhaseFunction::default();
    for ((_, k, wave), value) in right.terms().filter(|((_, k, _), _)| *k != 1) {
        let k_squared = i64::try_from(k * k).unwrap_or(i64::MAX);
        let stiffness = omega0.clone() * omega0.clone() * Rational::from(1 - k_squared);
        let factor = Rational::from(1).checked_div(&stiffness).ok_or(DerivationError::NoCycle)?;
        forced = forced.plus(&PhaseFunction::term(0, k, wave, value.scaled(&factor)));
    }
    Ok(CycleOrder { parts, forcing, amplitude_below, frequency, forced })
}

impl LowerOrders {
    /// The quantities known when a power is solved; the amplitude one power below is undetermined.
    fn new(question: &AveragingQuestion, orders: &[CycleOrder], n: usize) -> Self {
        let cycle = |m: usize| -> Open {
            let forced =
                m.checked_sub(1).and_then(|below| orders.get(below)).map(|order| order.forced.clone());
            let forced = Open::from(forced.unwrap_or_default());
            match orders.get(m) {
                None => forced.plus(&Open::wave()),
                Some(above) => {
                    let wave = PhaseFunction::cosine().scaled(&above.amplitude_below.clone().into());
                    forced.plus(&wave.into())
                }
            }
        };
        let motion: Vec<Open> = (0..n).map(cycle).collect();
        let first = [question.omega0().clone()];
        let frequency: Vec<Rational> =
            first.into_iter().chain(orders.iter().map(|order| order.frequency.clone())).collect();
        let velocity = (0..n).map(|m| {
            let terms = (0..=m).map(|i| motion[i].slope().scaled(&frequency[m - i]));
            terms.fold(Open::default(), |sum, term| sum.plus(&term))
        });
        let velocity = velocity.collect();
        Self { motion, velocity, frequency }
    }

    fn parts(&self, question: &AveragingQuestion, n: usize) -> Vec<(Option<usize>, Polynomial, Open)> {
        let names = |letters: &str, present: &dyn Fn(usize) -> bool| -> Vec<Polynomial> {
            let of = |m: usize| match present(m) {
                true => Polynomial::variable(variable(letters, m)),
                false => Polynomial::zero(),
            };
            (0..n).map(of).collect()
        };
        let not_zero = |list: &[Open]| {
            let list: Vec<bool> = list.iter().map(|value| *value != Open::default()).collect();
            move |m: usize| list.get(m).copied().unwrap_or(false)
        };
        let frequencies: Vec<bool> = self.frequency.iter().map(|value| !value.is_zero()).collect();
        let mut w = names("w", &|m| frequencies.get(m).copied().unwrap_or(false));
        if let Some(first) = w.first_mut() {
            *first = Polynomial::constant(question.omega0().clone());
        }
        let (is_moving, is_fast) = (not_zero(&self.motion), not_zero(&self.velocity));
        let [x, curved] = ["x", "x''"].map(|letters| names(letters, &is_moving));
        let v = names("v", &is_fast);
        let one = vec![Polynomial::constant(Rational::from(1))];
        let product = |factors: &[&Vec<Polynomial>], shift: usize| {
            let whole = factors.iter().fold(one.clone(), |whole, factor| times(&whole, factor, n));
            n.checked_sub(shift).and_then(|power| whole.get(power).cloned()).unwrap_or_default()
        };
        let mut parts = vec![(None, product(&[&w, &w, &curved], 0))];
        for (number, term) in question.flow.terms.iter().enumerate() {
            let powers = std::iter::repeat_n(&x, term.position).chain(std::iter::repeat_n(&v, term.velocity));
            let factors: Vec<&Vec<Polynomial>> = powers.collect();
            parts.push((Some(number), product(&factors, term.parameter).scaled(&term.factor)));
        }
        let moved = parts.into_iter().map(|(part, products)| {
            let products = -products;
            let value = self.value(&products);
            (part, products, value)
        });
        moved.filter(|(_, products, _)| !products.is_zero()).collect()
    }

    fn value(&self, products: &Polynomial) -> Open {
        let constant = |value: Rational| Open::from(PhaseFunction::constant(value.into()));
        products.terms().fold(Open::default(), |sum, (monomial, factor)| {
            let one = constant(Rational::from(1));
            let product = monomial.factors().iter().fold(one, |product, (variable, exponent)| {
                let index = usize::try_from(variable.index().unwrap_or(0)).unwrap_or(usize::MAX);
                let of = |list: &[Open]| list.get(index).cloned().unwrap_or_default();
                let value = match variable.letters() {
                    "x" => of(&self.motion),
                    "x''" => of(&self.motion).slope().slope(),
                    "v" => of(&self.velocity),
                    _ => constant(self.frequency.get(index).cloned().unwrap_or_else(|| Rational::from(0))),
                };
                (0..*exponent).fold(product, |product, _| product.times(&value))
            });
            sum.plus(&product.scaled(factor))
        })
    }
}

fn variable(letters: &str, n: usize) -> Variable {
    Variable::indexed(letters, u32::try_from(n).unwrap_or(u32::MAX))
}

/// The product of two series, up to a power.
fn times(a: &[Polynomial], b: &[Polynomial], last: usize) -> Vec<Polynomial> {
    let term = |n: usize| {
        let pairs = (0..=n).filter_map(|i| Some(a.get(i)?.clone() * b.get(n - i)?.clone()));
        pairs.fold(Polynomial::zero(), |sum, term| sum + term)
    };
    (0..=last).map(term).collect()
}
