//! The perturbation series of the pendulum with an open gauge, by the shortest method: order by order, with the Taylor series of the sine and
//! products of polynomials in cos(Ωt) and in the constants A1, A2, … of the fundamental.

use libration::algebra::{Polynomial, Polynomials, Rational};
use libration::series::{product, square_root_of_unit};

use super::cosines::{cosine, projection, second_derivative};

/// θ = Σ εⁿ Σ b_{n,k} cos(kΩt) and Ω/ω0 = Σ dₙεⁿ; every coefficient is a polynomial in the constants of the gauge.
#[derive(Clone, Debug)]
pub struct Expansion {
    /// The motion at each order, as a polynomial in cos(Ωt); order 0 is zero.
    motion: Vec<Polynomial>,
    /// (Ω/ω0)² at each order.
    square: Vec<Polynomial>,
}

/// The letters of the coefficients of cos Ωt, cos 3Ωt, cos 5Ωt, cos 7Ωt.
const LETTERS: [(&str, u32); 4] = [("A", 1), ("B", 3), ("C", 5), ("D", 7)];

impl Expansion {
    /// The solution of (Ω/ω0)²θ″ + sin θ = 0 whose fundamental is Σ Aₙεⁿ, A₁ first; it has as many
    /// orders as there are gauge constants. `None` if a division by A₁ is impossible, as for A₁ = 0.
    pub(super) fn of_gauge(gauge: &[Polynomial]) -> Option<Self> {
        let one = Polynomial::constant(Rational::from(1));
        let mut expansion = Self { motion: vec![Polynomial::zero()], square: vec![one] };
        for (order, fundamental) in (1..).zip(gauge) {
            expansion.solve(order, fundamental, gauge.first()?)?;
        }
        Some(expansion)
    }

    /// The expansion for these values of A₁, A₂, ….
    pub(super) fn of_numbers(gauge: &[Rational]) -> Option<Self> {
        Self::of_gauge(&gauge.iter().cloned().map(Polynomial::constant).collect::<Vec<_>>())
    }

    /// The expansion up to this order, with A₁, A₃, A₅, … undetermined and no even coefficients.
    pub fn odd_gauge(order: u32) -> Option<Self> {
        let constant = |n: u32| {
            if n.is_multiple_of(2) {
                Polynomial::zero()
            } else {
                Polynomial::variable(format!("A{n}").as_str())
            }
        };
        Self::of_gauge(&(1..=order).map(constant).collect::<Vec<_>>())
    }

    /// The expansion up to this order, with every Aₙ undetermined.
    pub(super) fn every_gauge(order: u32) -> Option<Self> {
        let constant = |n: u32| Polynomial::variable(format!("A{n}").as_str());
        Self::of_gauge(&(1..=order).map(constant).collect::<Vec<_>>())
    }

    /// The motion at each order.
    pub(super) fn motion(&self) -> &[Polynomial] {
        &self.motion
    }

    /// Solves the equation at an order: the fundamental gives (Ω/ω0)² one order below, every other harmonic its own coefficient.
    fn solve(&mut self, order: usize, fundamental: &Polynomial, first: &Polynomial) -> Option<()> {
        self.motion.push(Polynomial::zero());
        let residual = self.residual(order);
        let on_fundamental = projection(&residual, 1);
        if order > 1 {
            self.square.push(on_fundamental.divide_exactly(first)?);
        }
        let mut motion = fundamental.clone() * cosine(1);
        for k in 2..=u32::try_from(order).ok()? {
            let inertia = Rational::new(-1, 1 - i64::from(k) * i64::from(k))?;
            motion = motion + cosine(k) * projection(&residual, k).scaled(&inertia);
        }
        *self.motion.get_mut(order)? = motion;
        Some(())
    }

    /// (Ω/ω0)²θ″ + sin θ at an order, from the known part of the orders up to it.
    fn residual(&self, order: usize) -> Polynomial {
        let inertia = (0..order).filter_map(|j| Some((self.square.get(j)?, self.motion.get(order - j)?)));
        let inertia = inertia.fold(Polynomial::zero(), |sum, (square, motion)| {
            sum + square.clone() * second_derivative(motion)
        });
        inertia + self.sine(order)
    }

    /// sin θ at an order: θ − θ³/3! + θ⁵/5! − ….
    fn sine(&self, order: usize) -> Polynomial {
        let square = product(&Polynomials, &self.motion, &self.motion, self.motion.len());
        let (mut power, mut factor) = (self.motion.clone(), Rational::from(1));
        let mut sum = Polynomial::zero();
        for n in (1..=order).step_by(2) {
            sum = sum + power[order].scaled(&factor);
            let next = i64::try_from((n + 1) * (n + 2)).ok().and_then(|n| Rational::new(-1, n));
            factor = factor * next.unwrap_or_else(|| Rational::from(0));
            power = product(&Polynomials, &power, &square, power.len());
        }
        sum
    }

    /// A coefficient by its name: `A3`, `B5`, `C7`, `D7`, or `d4` of the frequency.
    pub fn named(&self, name: &str) -> Option<Polynomial> {
        let (letter, order) = name.split_at_checked(1)?;
        let order: usize = order.parse().ok()?;
        if letter == "d" {
            return self.frequency()?.get(order).cloned();
        }
        let (_, harmonic) = LETTERS.iter().find(|(symbol, _)| *symbol == letter)?;
        Some(projection(self.motion.get(order)?, *harmonic))
    }

    /// Ω/ω0 at each order, the root of its square.
    pub(super) fn frequency(&self) -> Option<Vec<Polynomial>> {
        square_root_of_unit(&Polynomials, &self.square)
    }

    /// The coefficient of cos(kΩt) at each order.
    pub(super) fn harmonic(&self, k: u32) -> Vec<Polynomial> {
        self.motion.iter().map(|motion| projection(motion, k)).collect()
    }

    /// The displacement at Ωt = 0 at each order: the sum of the harmonics.
    pub(super) fn amplitude(&self) -> Vec<Polynomial> {
        let one = Polynomial::constant(Rational::from(1));
        self.motion.iter().map(|motion| motion.substitute(&"c".into(), &one)).collect()
    }
}

/// The coefficients as numbers; `None` if a symbol remains.
pub(super) fn numbers(coefficients: &[Polynomial]) -> Option<Vec<Rational>> {
    coefficients.iter().map(Polynomial::to_constant).collect()
}
