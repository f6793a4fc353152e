//! Order by order: the rate of the complex amplitude, and the harmonics of the displacement.

use super::error::SymbolicSlowFlowError as Error;
use super::half_wave::first_harmonic;
use super::letters::{Column, Letters, Sum};
use libration_numbers::algebra::Rational;
use libration_numbers::internals::progress::Watch;

/// x″ + ω0²·x = Σ of the terms, all of them small, with the forced motion that a drive causes that is not small.
pub(super) struct Forced<'a> {
    pub(super) letters: &'a Letters,
    pub(super) omega0: Sum,
    /// (p, q) of W = (p/q)·ω0, and 1/1 without drive.
    pub(super) resonance: (i64, i64),
    /// W − (p/q)·ω0 with its order; zero without drive.
    pub(super) detuning: Sum,
    /// Waves of order zero, which do not contain the displacement.
    pub(super) drive: Sum,
    pub(super) terms: Vec<Term>,
}

/// A coefficient times xᵃ·x′ᵇ, and the signs of x and x′ where they are factors.
#[derive(Clone, Debug)]
pub(super) struct Term {
    pub(super) coefficient: Sum,
    pub(super) powers: [usize; 2],
    pub(super) signs: [bool; 2],
    pub(super) order: i64,
}

impl Term {
    pub(super) const fn is_kinked(&self) -> bool {
        self.signs[0] || self.signs[1]
    }
}

/// x(s, z, z̄) and z′, by orders.
pub(super) struct Solved {
    pub(super) displacement: Sum,
    pub(super) rate: Sum,
}

impl Forced<'_> {
    /// The solution to an order.
    pub(super) fn solve(&self, order: i64, watch: &Watch<'_>) -> Result<Solved, Error> {
        self.check_kinks(order)?;
        let letters = self.letters;
        let mut solved = Solved { displacement: self.unperturbed()?, rate: letters.zero() };
        for n in 1..=order {
            watch.reached(usize::try_from(n).unwrap_or(0)).map_err(|_| Error::Interrupted)?;
            let residual = letters.of_order(&self.residual(&solved, n), n);
            let residual = letters.add(&residual, &self.kinked(n)?);
            if residual.is_beyond_limit() {
                return Err(Error::TooLarge(usize::try_from(n).unwrap_or(0)));
            }
            self.extend(&mut solved, &residual)?;
        }
        Ok(solved)
    }

    /// The lowest order at which the slow flow is not zero without detuning.
    pub(super) fn first_order(&self, highest: i64, watch: &Watch<'_>) -> Result<i64, Error> {
        let highest = self.highest_order().unwrap_or(highest).min(highest);
        for order in 1..highest {
            if !self.solve(order, watch)?.rate.is_zero() {
                return Ok(order);
            }
        }
        Ok(highest)
    }

    /// z·e^{iqs} with its conjugate, and the forced motion.
    fn unperturbed(&self) -> Result<Sum, Error> {
        let letters = self.letters;
        let free =
            letters.times(&letters.power(Column::Phasor, 1), &letters.power(Column::Wave, self.resonance.1));
        let free = letters.add(&free, &letters.conjugate(&free));
        Ok(letters.add(&free, &self.response(&self.drive).ok_or(Error::DriveNotSmall)?))
    }

    /// The motion that a sum of waves forces; `None` where it contains the waves of the free motion.
    fn response(&self, waves: &Sum) -> Option<Sum> {
        let letters = self.letters;
        let (place, q) = (letters.place(Column::Wave), self.resonance.1);
        let square = letters.inverse(&letters.times(&self.omega0, &self.omega0))?;
        if !letters.part(waves, |powers| powers[place].abs() == 2 * q).is_zero() {
            return None;
        }
        let forced = letters.changed(waves, |powers, factor| {
            let k = powers[place] / 2;
            let stiffness = Rational::new(q * q, q * q - k * k).unwrap_or_else(|| Rational::from(0));
            factor.clone() * stiffness
        });
        Some(letters.times(&forced, &square))
    }

    /// The residual of the equation for a solution to order n − 1.
    fn residual(&self, solved: &Solved, n: i64) -> Sum {
        let letters = self.letters;
        let velocity = self.rate_of_change(&solved.displacement, &solved.rate, n);
        let acceleration = self.rate_of_change(&velocity, &solved.rate, n);
        let stiffness = letters.times(&self.omega0, &self.omega0);
        let spring = letters.product(&stiffness, &letters.to_order(&solved.displacement, n), n);
        let force = self.force(&solved.displacement, &velocity, n);
        letters.subtract(&letters.subtract(&force, &acceleration), &spring)
    }

    /// The forces without kinks.
    fn force(&self, displacement: &Sum, velocity: &Sum, n: i64) -> Sum {
        let letters = self.letters;
        let smooth = || self.terms.iter().filter(|term| !term.is_kinked());
        let powers = |of: &Sum, which: usize| {
            let highest = smooth().map(|term| term.powers[which]).max().unwrap_or(0);
            let mut powers = vec![letters.number(Rational::from(1))];
            for exponent in 0..highest {
                powers.push(letters.product(&powers[exponent], of, n - 1));
            }
            powers
        };
        let [positions, velocities] = [powers(displacement, 0), powers(velocity, 1)];
        let mut sum = self.drive.clone();
        for term in smooth().filter(|term| term.order <= n) {
            let rest = n - term.order;
            let power = letters.product(&positions[term.powers[0]], &velocities[term.powers[1]], rest);
            sum = letters.add(&sum, &letters.product(&term.coefficient, &power, n));
        }
        sum
    }

    /// The time derivative of a function of s, z and z̄, to an order.
    fn rate_of_change(&self, of: &Sum, rate: &Sum, n: i64) -> Sum {
        let letters = self.letters;
        let (p, q) = self.resonance;
        let over = |sum: &Sum, by: i64| {
            letters.scaled(sum, &Rational::new(1, by).unwrap_or_else(|| Rational::from(0)))
        };
        let phase = letters.add(&over(&self.omega0, q), &over(&self.detuning, p));
        let phase = letters.times(&phase, &letters.power(Column::Imaginary, 1));
        let mut sum = letters.product(&phase, &letters.scale_derivative(of, Column::Wave), n);
        for (column, rate) in [(Column::Phasor, rate.clone()), (Column::Conjugate, letters.conjugate(rate))] {
            sum = letters.add(&sum, &letters.product(&rate, &letters.derivative(of, column), n));
        }
        sum
    }

    /// Adds what one order's residual determines.
    fn extend(&self, solved: &mut Solved, residual: &Sum) -> Result<(), Error> {
        let letters = self.letters;
        let (place, q) = (letters.place(Column::Wave), self.resonance.1);
        let secular = letters.coefficient(residual, Column::Wave, q);
        let double = letters.scaled(&letters.power(Column::Imaginary, 1), &Rational::from(2));
        let inverse = letters.inverse(&letters.times(&double, &self.omega0)).ok_or(Error::DriveNotSmall)?;
        solved.rate = letters.add(&solved.rate, &letters.times(&secular, &inverse));
        let rest = letters.part(residual, |powers| powers[place].abs() != 2 * q);
        let forced = self.response(&rest).ok_or(Error::DriveNotSmall)?;
        solved.displacement = letters.add(&solved.displacement, &forced);
        Ok(())
    }

    /// The first harmonic of the forces with kinks of order n, with its conjugate.
    fn kinked(&self, n: i64) -> Result<Sum, Error> {
        let letters = self.letters;
        let mut sum = letters.zero();
        for term in self.terms.iter().filter(|term| term.is_kinked() && term.order == n) {
            if !self.drive.is_zero() || letters.exponents(&term.coefficient, Column::Wave) != [0] {
                return Err(Error::KinkWithDrive);
            }
            let harmonic = first_harmonic(letters, &self.omega0, term.powers, term.signs);
            let wave =
                letters.times(&letters.times(&term.coefficient, &harmonic), &self.amplitude_wave(term));
            sum = letters.add(&sum, &letters.add(&wave, &letters.conjugate(&wave)));
        }
        Ok(sum)
    }

    /// Aⁿ·e^{iψ} as (2√(z·z̄))ⁿ·√(z/z̄)·e^{iqs}.
    fn amplitude_wave(&self, term: &Term) -> Sum {
        let letters = self.letters;
        let n = i64::try_from(term.powers[0] + term.powers[1]).unwrap_or(0);
        let wave = letters.power(Column::Wave, self.resonance.1);
        let [z, conjugate] = [Column::Phasor, Column::Conjugate].map(|column| letters.place(column));
        let doubled = (0..n).fold(Rational::from(1), |product, _| product * Rational::from(2));
        letters.changed(&wave, |powers, _| {
            powers[z] = n + 1;
            powers[conjugate] = n - 1;
            doubled.clone()
        })
    }

    /// Refuses orders at which harmonics of a force with kinks would act back, of which there are infinitely many.
    fn check_kinks(&self, order: i64) -> Result<(), Error> {
        match self.highest_order() {
            Some(highest) if order > highest => Err(Error::KinkOrder(usize::try_from(highest).unwrap_or(1))),
            _ => Ok(()),
        }
    }

    /// The highest order at which harmonics of forces with kinks do not act back; `None` without such forces.
    pub(super) fn highest_order(&self) -> Option<i64> {
        let kink = self.terms.iter().filter(|term| term.is_kinked()).map(|term| term.order).min()?;
        let detuning = self.letters.lowest_order(&self.detuning);
        let lowest = self.terms.iter().map(|term| term.order).chain(detuning).min()?;
        Some(kink + lowest - 1)
    }
}
