//! Order by order: the rate of the complex amplitude, and the harmonics of the displacement.

use super::error::SymbolicSlowFlowError as Error;
use super::half_wave::first_harmonic;
use super::letters::{Column, Letters, Sum};
use libration_numbers::algebra::Rational;
use libration_numbers::internals::progress::Watch;

/// xⱼ″ + ωⱼ²·xⱼ = Σ of small terms, with the motion forced by a drive that is not small; ω0 is the frequency of the first coordinate.
pub(super) struct Forced<'a> {
    pub(super) letters: &'a Letters,
    pub(super) omega0: Sum,
    /// p of W = (p/q)·ω0, and 1 without drive.
    pub(super) drive_harmonic: i64,
    /// The frequencies of the coordinates in units of ω0/q; the first is q.
    pub(super) harmonics: Vec<i64>,
    /// W − (p/q)·ω0 with its order; zero without drive.
    pub(super) detuning: Sum,
    /// Waves of order zero in each equation, which do not contain the displacements.
    pub(super) drives: Vec<Sum>,
    /// The terms of each equation.
    pub(super) terms: Vec<Vec<SmallForceTerm>>,
}

/// A coefficient times Π xⱼᵃ·xⱼ′ᵇ, with the signs of the first coordinate and its velocity as possible factors.
#[derive(Clone, Debug)]
pub(super) struct SmallForceTerm {
    pub(super) coefficient: Sum,
    /// Powers of displacement and velocity of each coordinate.
    pub(super) powers: Vec<[usize; 2]>,
    pub(super) signs: [bool; 2],
    pub(super) order: i64,
}

impl SmallForceTerm {
    pub(super) const fn is_kinked(&self) -> bool {
        self.signs[0] || self.signs[1]
    }
}

/// x(s, z, z̄) and z′ of each coordinate, by orders.
pub(super) struct Solved {
    pub(super) displacements: Vec<Sum>,
    pub(super) rates: Vec<Sum>,
}

impl Forced<'_> {
    /// The solution to an order.
    pub(super) fn solve(&self, order: i64, watch: &Watch<'_>) -> Result<Solved, Error> {
        self.check_kinks(order)?;
        let letters = self.letters;
        let rates = vec![letters.zero(); self.harmonics.len()];
        let mut solved = Solved { displacements: self.unperturbed()?, rates };
        for n in 1..=order {
            watch.reached(usize::try_from(n).unwrap_or(0)).map_err(|_| Error::Interrupted)?;
            let mut residuals = self.residuals(&solved, n);
            residuals[0] = letters.add(&residuals[0], &self.kinked(n)?);
            if residuals.iter().any(Sum::is_beyond_limit) {
                return Err(Error::TooLarge(usize::try_from(n).unwrap_or(0)));
            }
            for (coordinate, residual) in residuals.iter().enumerate() {
                self.extend(&mut solved, coordinate, residual)?;
            }
        }
        Ok(solved)
    }

    /// The lowest order at which the slow flow is not zero without detuning.
    pub(super) fn first_order(&self, highest: i64, watch: &Watch<'_>) -> Result<i64, Error> {
        let highest = self.highest_order().unwrap_or(highest).min(highest);
        for order in 1..highest {
            if self.solve(order, watch)?.rates.iter().any(|rate| !rate.is_zero()) {
                return Ok(order);
            }
        }
        Ok(highest)
    }

    /// z·e^{iqs} with its conjugate, and the forced motion.
    fn unperturbed(&self) -> Result<Vec<Sum>, Error> {
        let letters = self.letters;
        let of_coordinate = |(coordinate, &harmonic): (usize, &i64)| {
            let phasor = letters.power_at(letters.index_of(Column::Phasor, coordinate), 1);
            let free = letters.times(&phasor, &letters.power(Column::Wave, harmonic));
            let free = letters.add(&free, &letters.conjugate(&free));
            let forced = self.response(&self.drives[coordinate], harmonic).ok_or(Error::DriveNotSmall)?;
            Ok(letters.add(&free, &forced))
        };
        self.harmonics.iter().enumerate().map(of_coordinate).collect()
    }

    /// The motion that a sum of waves forces in a coordinate; `None` if it contains the waves of the free motion.
    fn response(&self, waves: &Sum, harmonic: i64) -> Option<Sum> {
        let letters = self.letters;
        let (wave, q) = (letters.index(Column::Wave), self.harmonics[0]);
        let square = letters.inverse(&letters.times(&self.omega0, &self.omega0))?;
        if !letters.part(waves, |powers| powers[wave].abs() == 2 * harmonic).is_zero() {
            return None;
        }
        let forced = letters.changed(waves, |powers, factor| {
            let k = powers[wave] / 2;
            let stiffness = Rational::new(q * q, harmonic * harmonic - k * k);
            factor.clone() * stiffness.unwrap_or_else(|| Rational::from(0))
        });
        Some(letters.times(&forced, &square))
    }

    /// The natural frequency of a coordinate, without detuning.
    pub(super) fn natural_frequency(&self, coordinate: usize) -> Sum {
        let ratio = Rational::new(self.harmonics[coordinate], self.harmonics[0]);
        self.letters.scaled(&self.omega0, &ratio.unwrap_or_else(|| Rational::from(1)))
    }

    /// The residuals of order n of the equations for a solution to order n − 1.
    fn residuals(&self, solved: &Solved, n: i64) -> Vec<Sum> {
        let letters = self.letters;
        let rate_of_change = |of: &Sum| self.rate_of_change(of, &solved.rates, n);
        let velocities: Vec<Sum> = solved.displacements.iter().map(rate_of_change).collect();
        let powers = self.powers(&solved.displacements, &velocities, n);
        let residual = |coordinate: usize| {
            let omega = self.natural_frequency(coordinate);
            let stiffness = letters.times(&omega, &omega);
            let displacement = letters.to_order(&solved.displacements[coordinate], n);
            let spring = letters.product(&stiffness, &displacement, n);
            let acceleration = rate_of_change(&velocities[coordinate]);
            let force = self.force(coordinate, &powers, n);
            let residual = letters.subtract(&letters.subtract(&force, &acceleration), &spring);
            letters.of_order(&residual, n)
        };
        (0..velocities.len()).map(residual).collect()
    }

    /// Powers of displacement and velocity of each coordinate, as far as the forces without kinks contain them.
    pub(super) fn powers(&self, displacements: &[Sum], velocities: &[Sum], n: i64) -> Vec<[Vec<Sum>; 2]> {
        let letters = self.letters;
        let smooth = || self.terms.iter().flatten().filter(|term| !term.is_kinked());
        let list = |of: &Sum, coordinate: usize, which: usize| {
            let highest = smooth().map(|term| term.powers[coordinate][which]).max().unwrap_or(0);
            let mut powers = vec![letters.number(Rational::from(1))];
            for exponent in 0..highest {
                powers.push(letters.product(&powers[exponent], of, n - 1));
            }
            powers
        };
        let both = displacements.iter().zip(velocities).enumerate();
        both.map(|(coordinate, (x, v))| [list(x, coordinate, 0), list(v, coordinate, 1)]).collect()
    }

    /// The forces without kinks in an equation.
    fn force(&self, coordinate: usize, powers: &[[Vec<Sum>; 2]], n: i64) -> Sum {
        let letters = self.letters;
        let mut sum = self.drives[coordinate].clone();
        let smooth = self.terms[coordinate].iter().filter(|term| !term.is_kinked());
        for term in smooth.filter(|term| term.order <= n) {
            sum = letters.add(&sum, &self.product(term, powers, n));
        }
        sum
    }

    /// A force without kinks, to an order.
    pub(super) fn product(&self, term: &SmallForceTerm, powers: &[[Vec<Sum>; 2]], n: i64) -> Sum {
        let letters = self.letters;
        let factors = term.powers.iter().zip(powers).flat_map(|(exponents, [positions, velocities])| {
            [&positions[exponents[0]], &velocities[exponents[1]]]
        });
        // All but the order of the coefficient is left for the product.
        let one = letters.number(Rational::from(1));
        let product = factors.fold(one, |product, factor| letters.product(&product, factor, n - term.order));
        letters.product(&term.coefficient, &product, n)
    }

    /// A force of one coordinate along the motion of order zero, of a force with kinks its first harmonic.
    pub(super) fn along(&self, displacement: &Sum, term: &SmallForceTerm) -> Sum {
        let letters = self.letters;
        if term.is_kinked() {
            return self.first_wave(term);
        }
        let position = letters.of_order(displacement, 0);
        let velocity = self.velocity(&position);
        let order = term.order;
        self.product(term, &self.powers(&[position], &[velocity], order + 1), order)
    }

    /// The velocity of order zero of a motion of one coordinate.
    pub(super) fn velocity(&self, position: &Sum) -> Sum {
        let letters = self.letters;
        let per_turn = Rational::new(1, self.harmonics[0]).unwrap_or_else(|| Rational::from(0));
        let rate = letters.scaled(&letters.power(Column::Imaginary, 1), &per_turn);
        let rate = letters.times(&rate, &self.omega0);
        letters.times(&rate, &letters.scale_derivative(position, Column::Wave))
    }

    /// The time derivative of a function of s and all z and z̄, to an order.
    pub(super) fn rate_of_change(&self, of: &Sum, rates: &[Sum], n: i64) -> Sum {
        let letters = self.letters;
        let over = |sum: &Sum, by: i64| {
            letters.scaled(sum, &Rational::new(1, by).unwrap_or_else(|| Rational::from(0)))
        };
        let phase =
            letters.add(&over(&self.omega0, self.harmonics[0]), &over(&self.detuning, self.drive_harmonic));
        let phase = letters.times(&phase, &letters.power(Column::Imaginary, 1));
        let mut sum = letters.product(&phase, &letters.scale_derivative(of, Column::Wave), n);
        for (coordinate, rate) in rates.iter().enumerate().filter(|(_, rate)| !rate.is_zero()) {
            for (column, rate) in
                [(Column::Phasor, rate.clone()), (Column::Conjugate, letters.conjugate(rate))]
            {
                let slope = letters.derivative_at(of, letters.index_of(column, coordinate));
                sum = letters.add(&sum, &letters.product(&rate, &slope, n));
            }
        }
        sum
    }

    /// Adds the solution for the residual of one order in the equation of a coordinate.
    fn extend(&self, solved: &mut Solved, coordinate: usize, residual: &Sum) -> Result<(), Error> {
        let letters = self.letters;
        let (wave, harmonic) = (letters.index(Column::Wave), self.harmonics[coordinate]);
        let secular = letters.coefficient(residual, Column::Wave, harmonic);
        let double = letters.scaled(&letters.power(Column::Imaginary, 1), &Rational::from(2));
        let inverse = letters.inverse(&letters.times(&double, &self.natural_frequency(coordinate)));
        let rate = letters.times(&secular, &inverse.ok_or(Error::DriveNotSmall)?);
        solved.rates[coordinate] = letters.add(&solved.rates[coordinate], &rate);
        let rest = letters.part(residual, |powers| powers[wave].abs() != 2 * harmonic);
        let forced = self.response(&rest, harmonic).ok_or(Error::DriveNotSmall)?;
        solved.displacements[coordinate] = letters.add(&solved.displacements[coordinate], &forced);
        Ok(())
    }

    /// The first harmonic of the forces with kinks of order n, with its conjugate.
    fn kinked(&self, n: i64) -> Result<Sum, Error> {
        let letters = self.letters;
        let mut sum = letters.zero();
        for term in self.terms[0].iter().filter(|term| term.is_kinked() && term.order == n) {
            if !self.drives[0].is_zero() || letters.exponents(&term.coefficient, Column::Wave) != [0] {
                return Err(Error::KinkWithDrive);
            }
            sum = letters.add(&sum, &self.first_wave(term));
        }
        Ok(sum)
    }

    /// The first harmonic of a force with kinks, with its conjugate.
    fn first_wave(&self, term: &SmallForceTerm) -> Sum {
        let letters = self.letters;
        let harmonic = first_harmonic(letters, &self.omega0, term.powers[0], term.signs);
        let wave = letters.times(&letters.times(&term.coefficient, &harmonic), &self.amplitude_wave(term));
        letters.add(&wave, &letters.conjugate(&wave))
    }

    /// Aⁿ·e^{iψ} as (2√(z·z̄))ⁿ·√(z/z̄)·e^{iqs}.
    fn amplitude_wave(&self, term: &SmallForceTerm) -> Sum {
        let letters = self.letters;
        let n = i64::try_from(term.powers[0][0] + term.powers[0][1]).unwrap_or(0);
        let wave = letters.power(Column::Wave, self.harmonics[0]);
        let [z, conjugate] = [Column::Phasor, Column::Conjugate].map(|column| letters.index(column));
        let doubled = (0..n).fold(Rational::from(1), |product, _| product * Rational::from(2));
        letters.changed(&wave, |powers, _| {
            powers[z] = n + 1;
            powers[conjugate] = n - 1;
            doubled.clone()
        })
    }

    /// Refuses orders at which harmonics of a force with kinks, of which there are infinitely many, would act back.
    fn check_kinks(&self, order: i64) -> Result<(), Error> {
        match self.highest_order() {
            Some(highest) if order > highest => Err(Error::KinkOrder(usize::try_from(highest).unwrap_or(1))),
            _ => Ok(()),
        }
    }

    /// The highest order at which harmonics of forces with kinks do not act back; `None` without such forces.
    pub(super) fn highest_order(&self) -> Option<i64> {
        let terms = || self.terms.iter().flatten();
        let kink = terms().filter(|term| term.is_kinked()).map(|term| term.order).min()?;
        let detuning = self.letters.lowest_order(&self.detuning);
        let lowest = terms().map(|term| term.order).chain(detuning).min()?;
        Some(kink + lowest - 1)
    }
}
