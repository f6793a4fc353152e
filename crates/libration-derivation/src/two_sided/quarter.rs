//! The quarter swing from a turning point to the equilibrium, power by power of the amplitude.

use super::super::check::DerivationError;
use super::super::phase::{PhaseFunction, PiNumber, Wave};
use libration::algebra::Rational;

/// The motion u = A·u₁ + A²·u₂ + … from the turning point at τ = 0 to zero at τ = π/2, and Δ = 1 + d₁A + d₂A² + ….
#[derive(Clone, Debug)]
pub struct Quarter {
    /// The factors of u, u², … in the restoring force over ω0², on the side of the turning point.
    pub force: Vec<Rational>,
    /// u₁, u₂, …, from a zero on.
    pub motion: Vec<PhaseFunction>,
    /// 1, d₁, d₂, ….
    pub ratio: Vec<PiNumber>,
    /// The powers from the second on.
    pub orders: Vec<QuarterOrder>,
}

/// The contributions to a power of the amplitude, and the solution without the correction of the frequency.
#[derive(Clone, Debug)]
pub struct QuarterOrder {
    /// The power n.
    pub(super) power: usize,
    /// The contributions to the right side of uₙ″ + uₙ = 2dₙ₋₁cos τ + …: those of Δ²u″, and of each power of u.
    pub(super) of_acceleration: PhaseFunction,
    pub(super) of_powers: Vec<PhaseFunction>,
    /// Their sum.
    pub(super) forcing: PhaseFunction,
    /// The solution for it that begins at rest in zero.
    pub(super) begun: PhaseFunction,
}

impl Quarter {
    /// Solves the powers up to this one.
    pub fn new(force: &[Rational], highest: usize) -> Self {
        let mut quarter = Self {
            force: force.to_vec(),
            motion: vec![PhaseFunction::default(), PhaseFunction::cosine()],
            ratio: vec![Rational::from(1).into()],
            orders: vec![],
        };
        for power in 2..=highest {
            let order = quarter.next(power);
            let at_end = order.begun.at_quarter_turn();
            // dτ·sin τ is dπ/2 at the end.
            let correction = at_end.scaled(&Rational::from(-2)).times_power_of_pi(-1);
            let of_correction = PhaseFunction::term(1, 1, Wave::Sine, correction.clone());
            quarter.motion.push(order.begun.plus(&of_correction));
            quarter.ratio.push(correction);
            quarter.orders.push(order);
        }
        quarter
    }

    fn next(&self, power: usize) -> QuarterOrder {
        let minus = PiNumber::from(Rational::from(-1));
        let of_acceleration = (1..power).fold(PhaseFunction::default(), |sum, m| {
            let square = self.squared_ratio(m, &self.ratio);
            sum.minus(&self.motion[power - m].slope().slope().scaled(&square))
        });
        let mut powers = self.motion.clone();
        let mut of_powers = vec![];
        for factor in self.force.iter().skip(1) {
            powers = product(&powers, &self.motion, power);
            let part = powers.get(power).cloned().unwrap_or_default();
            of_powers.push(part.scaled(&minus.scaled(factor)));
        }
        let forcing = of_powers.iter().fold(of_acceleration.clone(), |sum, part| sum.plus(part));
        let begun = forcing.begun_at_rest();
        QuarterOrder { power, of_acceleration, of_powers, forcing, begun }
    }

    /// The coefficient of Aᵐ in Δ², from these coefficients of Δ.
    fn squared_ratio(&self, m: usize, ratio: &[PiNumber]) -> PiNumber {
        let zero = PiNumber::default();
        let at = |n: usize| ratio.get(n).unwrap_or(&zero);
        (0..=m).fold(PiNumber::default(), |sum, n| sum.plus(&at(n).times(at(m - n))))
    }

    /// Puts the motion into the equation of motion, and compares its values at both ends.
    pub fn check(&self) -> Result<(), DerivationError> {
        let highest = self.motion.len() - 1;
        let mut powers = self.motion.clone();
        let mut rest: Vec<PhaseFunction> = self.motion.clone();
        for factor in self.force.iter().skip(1) {
            powers = product(&powers, &self.motion, highest);
            for (rest, part) in rest.iter_mut().zip(&powers) {
                *rest = rest.plus(&part.scaled(&factor.clone().into()));
            }
        }
        for (n, rest) in rest.iter_mut().enumerate() {
            for m in 0..n {
                let square = self.squared_ratio(m, &self.ratio);
                *rest = rest.plus(&self.motion[n - m].slope().slope().scaled(&square));
            }
        }
        let is_solved = rest.iter().all(PhaseFunction::is_zero);
        let begins = self.motion.iter().enumerate().all(|(n, part)| {
            let value = part.at_start().to_rational();
            value == Some(Rational::from(i64::from(n == 1))) && part.slope().at_start().is_zero()
        });
        let ends = self.motion.iter().all(|part| part.at_quarter_turn().is_zero());
        match is_solved && begins && ends {
            true => Ok(()),
            false => {
                Err(DerivationError::Disagreement { what: "the quarter swing and the equation of motion" })
            }
        }
    }

    /// The factor of cos kτ for an odd k, by powers of the amplitude: 4/π times the integral over the quarter.
    pub(super) fn harmonic(&self, k: usize) -> Vec<PiNumber> {
        let wave = PhaseFunction::term(0, k, Wave::Cosine, Rational::from(4).into());
        let whole =
            |part: &PhaseFunction| part.times(&wave).integral().at_quarter_turn().times_power_of_pi(-1);
        self.motion.iter().map(whole).collect()
    }
}

/// The coefficients of a product of series, up to a power.
fn product(a: &[PhaseFunction], b: &[PhaseFunction], highest: usize) -> Vec<PhaseFunction> {
    let each = |n: usize| {
        (0..=n)
            .filter_map(|m| Some(a.get(m)?.times(b.get(n - m)?)))
            .fold(PhaseFunction::default(), |sum, term| sum.plus(&term))
    };
    (0..=highest).map(each).collect()
}
