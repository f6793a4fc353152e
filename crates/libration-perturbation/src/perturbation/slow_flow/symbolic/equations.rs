//! The equations of motion as sums: ω0, small terms, and the detuning of the frequencies from their resonance.

use super::error::{LARGEST_RESONANCE, SymbolicSlowFlowError as Error};
use super::force::Reader;
use super::letters::{Column, Letters, Sum};
use super::scales::{Forced, SmallForceTerm};
use super::setting::Setting;
use super::steady::greatest_common_divisor;
use libration_numbers::algebra::{Rational, Ring};
use libration_numbers::expression::{Equation, Expression};
use libration_numbers::internals::progress::Watch;
use std::cell::Cell;

impl Setting {
    /// The terms of the equations, by orders.
    pub(super) fn forced(
        &self,
        equation: &Equation,
        order: i64,
        watch: &Watch<'_>,
    ) -> Result<(Forced<'_>, Found), Error> {
        let letters = &self.letters;
        let mut reader = self.reader(equation, order);
        let mut accelerations = self.accelerations(&mut reader, equation)?;
        let springs = self.springs(&accelerations)?;
        let (harmonics, drive_harmonic) = self.harmonics(&springs)?;
        let wave = letters.index(Column::Wave);
        for acceleration in &mut accelerations {
            *acceleration = letters.changed(acceleration, |powers, factor| {
                powers[wave] *= drive_harmonic;
                factor.clone()
            });
        }
        let natural = self.natural_frequency(&springs[0])?;
        let zeros = || vec![letters.zero(); springs.len()];
        let mut forced = Forced {
            letters,
            omega0: natural.omega0.clone(),
            drive_harmonic,
            harmonics,
            detuning: letters.zero(),
            drives: zeros(),
            terms: vec![],
        };
        let is_detuned = self.is_detuned(&forced, &springs);
        let degree = reader.is_cut_off.get().then_some(reader.degree);
        let is_series = reader.is_series.get();
        let equations = Equations { accelerations, springs, is_detuned, known_degree: degree, is_series };
        let grade = match (equations.has_detuning(self.drive.is_some()), self.detuning_order) {
            (false, _) => None,
            (true, Some(stated)) => Some(stated),
            (true, None) => {
                self.split(&mut forced, &equations, order)?;
                // No detuning enters: it has the highest order, and those below are tried.
                Some(forced.first_order(order, watch)?)
            }
        };
        let drives = self.split(&mut forced, &equations, grade.unwrap_or(0))?;
        let frequencies = equations.springs.iter().zip(&equations.is_detuned);
        let natural_squares = frequencies.map(|(spring, is)| is.then(|| spring.clone())).collect();
        let acting_order = self.acting_order(&equations);
        let stated_order = self.stated_order(&equations);
        let variables = deviations(&reader);
        let left_out = self.left_out(&equations, &forced, &variables, order);
        let natural = natural.explained;
        let equilibrium = reader.equilibrium;
        Ok((
            forced,
            Found { natural, equilibrium, drives, natural_squares, acting_order, stated_order, left_out },
        ))
    }

    fn reader<'a>(&'a self, equation: &'a Equation, order: i64) -> Reader<'a> {
        Reader {
            letters: &self.letters,
            variables: equation.variables(),
            equilibrium: None,
            symbols: &self.symbols,
            drive: self.drive.as_ref(),
            order,
            // The cubic term of a power series tells whether the amplitude is small.
            degree: usize::try_from(order.max(2)).unwrap_or(0) + 1,
            is_cut_off: Cell::new(false),
            is_series: Cell::new(false),
        }
    }

    /// The equilibrium; `None` for 0.
    fn equilibrium(&self, reader: &Reader<'_>) -> Result<Option<Sum>, Error> {
        self.about.as_ref().map(|about| reader.read(about)).transpose()
    }

    fn accelerations(&self, reader: &mut Reader<'_>, equation: &Equation) -> Result<Vec<Sum>, Error> {
        reader.equilibrium = self.equilibrium(reader)?;
        let reader = &*reader;
        equation.accelerations().iter().map(|formula| self.checked(reader, formula)).collect()
    }

    /// Returns `true` if the symbol of the drive frequency is also one of the natural frequencies.
    pub(super) fn is_drive_natural(&self, equation: &Equation) -> Result<bool, Error> {
        let accelerations = self.accelerations(&mut self.reader(equation, 1), equation)?;
        let drive = self.letters.index(Column::Drive);
        let mut linear =
            accelerations.iter().enumerate().map(|(coordinate, sum)| self.linear(sum, coordinate));
        Ok(linear.any(|spring| spring.half_powers().any(|(powers, _)| powers[drive] != 0)))
    }

    fn checked(&self, reader: &Reader<'_>, formula: &Expression) -> Result<Sum, Error> {
        let acceleration = reader.read(formula)?;
        match () {
            () if acceleration.is_beyond_limit() => Err(Error::TooLarge(0)),
            () if !self.is_polynomial(&acceleration) => Err(Error::NotPolynomial(formula.to_string())),
            () => Ok(acceleration),
        }
    }

    /// The frequencies of the coordinates and the drive in units of ω0/q.
    fn harmonics(&self, springs: &[Sum]) -> Result<(Vec<i64>, i64), Error> {
        let whole = if self.ratios.is_empty() { self.ratios_of(springs)? } else { self.ratios.clone() };
        let (p, q) = self.resonance;
        let scale = q / greatest_common_divisor(q, whole[0]);
        let harmonics: Vec<i64> = whole.iter().map(|ratio| ratio * scale).collect();
        let drive = p * harmonics[0] / q;
        Ok((harmonics, drive))
    }

    /// The natural frequencies as whole numbers, if the ratios of their squares are those of whole numbers.
    fn ratios_of(&self, springs: &[Sum]) -> Result<Vec<i64>, Error> {
        let letters = &self.letters;
        let half = Rational::new(1, 2).unwrap_or_else(|| Rational::from(1));
        let ratio = |spring: &Sum| {
            let (leading, first) = springs[0].half_powers().next()?;
            let (_, mine) = spring.half_powers().find(|(powers, _)| *powers == leading)?;
            let square = mine.checked_div(first).filter(|square| !square.is_negative())?;
            let is_multiple = letters.subtract(spring, &letters.scaled(&springs[0], &square)).is_zero();
            let root = letters.ring.power(&letters.number(square), &half).filter(|_| is_multiple)?;
            let (powers, factor) = root.as_single_term()?;
            powers.iter().all(|power| *power == 0).then(|| factor.clone())
        };
        let mut ratios = vec![Rational::from(1)];
        for (coordinate, spring) in springs.iter().enumerate().skip(1) {
            ratios.push(ratio(spring).ok_or(Error::UnknownRatio(coordinate + 1))?);
        }
        whole_numbers(&ratios).ok_or(Error::UnknownRatio(2))
    }

    /// The springs of the equations by coordinates: ω², which must not be zero.
    fn springs(&self, accelerations: &[Sum]) -> Result<Vec<Sum>, Error> {
        let letters = &self.letters;
        let spring = |(coordinate, acceleration): (usize, &Sum)| {
            let position = letters.index_of(Column::Position, coordinate);
            let linear = letters.scaled(&self.linear(acceleration, coordinate), &Rational::from(-1));
            let square = letters.times(&linear, &letters.power_at(position, -1));
            let is_negative = square.as_single_term().is_some_and(|(_, factor)| factor.is_negative());
            if square.is_zero() || is_negative {
                Err(Error::NoOscillation(square.to_string()))
            } else {
                Ok(square)
            }
        };
        accelerations.iter().enumerate().map(spring).collect()
    }

    /// Returns for each coordinate `true` if its natural frequency differs from its multiple of ω0.
    fn is_detuned(&self, forced: &Forced<'_>, springs: &[Sum]) -> Vec<bool> {
        let letters = &self.letters;
        let differs = |(coordinate, spring): (usize, &Sum)| {
            let ratio = Rational::new(forced.harmonics[coordinate], forced.harmonics[0]);
            let ratio = ratio.unwrap_or_else(|| Rational::from(1));
            let square = letters.scaled(&springs[0], &(ratio.clone() * ratio));
            !letters.subtract(spring, &square).is_zero()
        };
        springs.iter().enumerate().map(differs).collect()
    }

    /// Natural powers of the drive frequency and of the small parameters.
    fn is_polynomial(&self, acceleration: &Sum) -> bool {
        let columns = [Column::Drive, Column::Order].map(|column| self.letters.index(column));
        acceleration
            .half_powers()
            .all(|(powers, _)| columns.iter().all(|&column| powers[column] >= 0 && powers[column] % 2 == 0))
    }

    /// W − (p/q)·ω0 for the first coordinate, the detuning of the natural frequency for another: σ, times the small parameter if there is one.
    pub(super) fn detuning(&self, coordinate: usize, order: i64) -> Sum {
        let letters = &self.letters;
        let factor = self
            .bookkeeping
            .map_or_else(|| letters.number(Rational::from(1)), |column| letters.power_at(column, 1));
        let sigma = letters.power_at(letters.index_of(Column::Detuning, coordinate), 1);
        letters.times(&letters.times(&sigma, &letters.power(Column::Order, order)), &factor)
    }

    fn natural_frequency(&self, square: &Sum) -> Result<NaturalFrequency, Error> {
        let letters = &self.letters;
        let half = Rational::new(1, 2).ok_or_else(|| Error::NoOscillation(square.to_string()))?;
        let root = square.as_single_term().and_then(|_| letters.ring.power(square, &half));
        Ok(match root {
            Some(omega0) => NaturalFrequency { omega0, explained: None },
            None => NaturalFrequency {
                omega0: letters.power(Column::Natural, 1),
                explained: Some(square.clone()),
            },
        })
    }

    /// The terms of order zero that are linear in a displacement, without others, velocities and waves.
    fn linear(&self, sum: &Sum, coordinate: usize) -> Sum {
        let letters = &self.letters;
        let position = letters.index_of(Column::Position, coordinate);
        let mut moving = [Column::Order, Column::Wave, Column::PositionSign, Column::VelocitySign]
            .map(|column| letters.index(column))
            .to_vec();
        moving.extend([Column::Position, Column::Velocity].map(|column| letters.indices(column)).concat());
        letters.part(sum, |powers| {
            moving.iter().all(|&column| powers[column] == if column == position { 2 } else { 0 })
        })
    }

    /// Distributes the accelerations with detunings of this order, and returns the symbols of the drive that does not contain displacements.
    fn split(&self, forced: &mut Forced<'_>, equations: &Equations, grade: i64) -> Result<Vec<usize>, Error> {
        let letters = &self.letters;
        if self.drive.is_some() {
            forced.detuning = self.detuning(0, grade);
        }
        let rests: Vec<Sum> = (0..equations.springs.len())
            .map(|coordinate| self.rest(forced, equations, coordinate, grade))
            .collect();
        let degree = self.degree();
        let order = letters.index(Column::Order);
        // Without a small factor a term is small because the amplitude is, and then powers of the amplitude count everywhere.
        let by_amplitude = self.large_degrees(equations).next().is_some();
        if equations.known_degree.is_some() && !by_amplitude {
            return Err(Error::EndlessSeries);
        }
        let (wave, signs) = (letters.index(Column::Wave), self.signs());
        let mut drives = vec![];
        forced.terms.clear();
        for (coordinate, rest) in rests.iter().enumerate() {
            let graded = letters.changed(rest, |powers, factor| {
                if by_amplitude && degree(powers) >= 1 {
                    powers[order] += 2 * (degree(powers) - 1);
                }
                factor.clone()
            });
            let large = letters.of_order(&graded, 0);
            let is_still =
                |powers: &[i64]| degree(powers) == 0 && signs.iter().all(|&column| powers[column] == 0);
            let waves = letters.part(&large, |powers| is_still(powers) && powers[wave] != 0);
            self.refuse_large(&letters.subtract(&large, &waves), &degree)?;
            forced.drives[coordinate] = waves;
            forced.terms.push(terms(letters, &letters.subtract(&graded, &large)));
            let driving = letters.part(&graded, |powers| degree(powers) == 0 && powers[wave] != 0);
            drives.extend(
                (0..letters.given)
                    .filter(|&column| driving.half_powers().any(|(powers, _)| powers[column] > 0)),
            );
        }
        if forced.terms.iter().all(Vec::is_empty) && forced.detuning.is_zero() {
            return Err(Error::NothingSmall);
        }
        drives.sort_unstable();
        drives.dedup();
        Ok(drives)
    }

    /// The acceleration of a coordinate without its spring, which is (h·ω0/q)²; W and the natural frequency have their detunings.
    fn rest(&self, forced: &Forced<'_>, equations: &Equations, coordinate: usize, grade: i64) -> Sum {
        let letters = &self.letters;
        let acceleration = &equations.accelerations[coordinate];
        let rest = letters.subtract(acceleration, &self.linear(acceleration, coordinate));
        let (p, q) = self.resonance;
        let resonant =
            letters.scaled(&forced.omega0, &Rational::new(p, q).unwrap_or_else(|| Rational::from(1)));
        let drive = letters.add(&resonant, &forced.detuning);
        let rest = letters.substituted(&rest, Column::Drive, &drive, i64::from(i16::MAX));
        if !equations.is_detuned[coordinate] {
            return rest;
        }
        let detuning = self.detuning(coordinate, grade);
        let twice = letters.scaled(&forced.natural_frequency(coordinate), &Rational::from(2));
        let excess = letters.times(&letters.add(&twice, &detuning), &detuning);
        let position = letters.power_at(letters.index_of(Column::Position, coordinate), 1);
        letters.subtract(&rest, &letters.times(&excess, &position))
    }

    /// The degree of a term in displacements and velocities.
    fn degree(&self) -> impl Fn(&[i64]) -> i64 + use<> {
        let columns =
            [Column::Position, Column::Velocity].map(|column| self.letters.indices(column)).concat();
        move |powers| columns.iter().map(|&column| powers[column]).sum::<i64>() / 2
    }

    /// The degrees of nonlinear terms without a small parameter, each with `true` if the sign of a displacement or velocity is a factor.
    pub(super) fn large_degrees<'a>(
        &self,
        equations: &'a Equations,
    ) -> impl Iterator<Item = (i64, bool)> + use<'a> {
        let (degree, order, signs) = (self.degree(), self.letters.index(Column::Order), self.signs());
        let terms =
            equations.accelerations.iter().flat_map(|sum| sum.half_powers().map(|(powers, _)| &powers[..]));
        terms.filter(move |powers| powers[order] == 0).filter_map(move |powers| {
            let is_kinked = signs.iter().any(|&column| powers[column] != 0);
            Some((degree(powers), is_kinked)).filter(|(degree, _)| *degree >= 2)
        })
    }

    /// The degrees of nonlinear terms, as far as power series are known.
    pub(super) fn known_degrees<'a>(
        &self,
        equations: &'a Equations,
    ) -> impl Iterator<Item = (i64, bool)> + use<'a> {
        let limit = equations.known_degree.and_then(|degree| i64::try_from(degree).ok());
        let is_known = move |degree: i64| limit.is_none_or(|highest| degree <= highest);
        self.large_degrees(equations).filter(move |(degree, _)| is_known(*degree))
    }

    /// The order at which all nonlinear terms without a small parameter act on amplitude or phase: one of odd degree d, or with a sign, at its own
    /// order d − 1, one of even degree at the square of that.
    fn acting_order(&self, equations: &Equations) -> Option<i64> {
        let order_of = |(degree, is_kinked): (i64, bool)| match is_kinked || degree % 2 == 1 {
            true => degree - 1,
            false => 2 * (degree - 1),
        };
        self.known_degrees(equations).map(order_of).max()
    }

    fn signs(&self) -> [usize; 2] {
        [Column::PositionSign, Column::VelocitySign].map(|column| self.letters.index(column))
    }

    /// Refuses terms of order zero other than the spring and the drive.
    fn refuse_large(&self, large: &Sum, degree: &impl Fn(&[i64]) -> i64) -> Result<(), Error> {
        let letters = &self.letters;
        let Some((powers, _)) = large.half_powers().next() else { return Ok(()) };
        let term = letters.part(large, |other| other == &powers[..]);
        let text = letters.changed(&term, |powers, factor| {
            powers[letters.index(Column::Order)..].fill(0);
            factor.clone()
        });
        Err(match (degree(powers), powers[letters.index(Column::Wave)]) {
            (0, _) => Error::Equilibrium(text.to_string()),
            (_, 0) => Error::NotSmall(text.to_string()),
            _ => Error::ParametricNotSmall(text.to_string()),
        })
    }
}

/// The names of the moving variables: the coordinates, or their deviations from an equilibrium.
fn deviations(reader: &Reader<'_>) -> Vec<String> {
    let of = |name: &String| match &reader.equilibrium {
        Some(equilibrium) => format!("({name} - ({equilibrium}))"),
        None => name.clone(),
    };
    reader.variables.iter().map(of).collect()
}

/// The equations of motion as sums.
pub(super) struct Equations {
    pub(super) accelerations: Vec<Sum>,
    springs: Vec<Sum>,
    is_detuned: Vec<bool>,
    /// The degree to which power series of displacements are known; `None` without such series.
    known_degree: Option<usize>,
    /// `true` with power series in small parameters.
    pub(super) is_series: bool,
}

impl Equations {
    fn has_detuning(&self, is_driven: bool) -> bool {
        is_driven || self.is_detuned.contains(&true)
    }
}

/// ω0, and its square if it has a name.
struct NaturalFrequency {
    omega0: Sum,
    explained: Option<Sum>,
}

/// The terms of the equation by kind.
pub(super) struct Found {
    /// ω0², if ω0 has a name.
    pub(super) natural: Option<Sum>,
    /// The equilibrium; `None` for 0.
    pub(super) equilibrium: Option<Sum>,
    /// Columns of the amplitudes of drives.
    pub(super) drives: Vec<usize>,
    /// The squares of the natural frequencies that differ from their multiples of ω0, by coordinates.
    pub(super) natural_squares: Vec<Option<Sum>>,
    /// The order at which all nonlinear terms without a small parameter act on amplitude or phase.
    pub(super) acting_order: Option<i64>,
    /// The highest order that small parameters give a term, with their powers and products.
    pub(super) stated_order: Option<i64>,
    /// A note on terms whose order is above the highest.
    pub(super) left_out: Option<String>,
}

/// The terms by powers of displacements and velocities, the signs of the first, and their orders.
pub(super) fn terms(letters: &Letters, sum: &Sum) -> Vec<SmallForceTerm> {
    let grade = letters.index(Column::Order);
    let signs = [Column::PositionSign, Column::VelocitySign].map(|column| letters.index(column));
    let mut columns: Vec<usize> = (0..letters.coordinates)
        .flat_map(|coordinate| {
            [Column::Position, Column::Velocity].map(|column| letters.index_of(column, coordinate))
        })
        .collect();
    let moving = columns.len();
    columns.extend(signs);
    let key = |powers: &[i64]| columns.iter().chain([&grade]).map(|&column| powers[column] / 2).collect();
    let mut keys: Vec<Vec<i64>> = sum.half_powers().map(|(powers, _)| key(powers)).collect();
    keys.sort_unstable();
    keys.dedup();
    let term = |wanted: Vec<i64>| {
        let part = letters.part(sum, |powers| key(powers) == wanted);
        let coefficient = letters.changed(&part, |powers, factor| {
            for &column in &columns {
                powers[column] = 0;
            }
            factor.clone()
        });
        let exponents = wanted[..moving].chunks_exact(2);
        let powers = exponents
            .map(|pair| [pair[0], pair[1]].map(|exponent| usize::try_from(exponent).unwrap_or(0)))
            .collect();
        SmallForceTerm {
            coefficient,
            powers,
            signs: [wanted[moving] != 0, wanted[moving + 1] != 0],
            order: wanted[moving + 2],
        }
    };
    keys.into_iter().map(term).collect()
}

/// Fractions times their common denominator.
fn whole_numbers(fractions: &[Rational]) -> Option<Vec<i64>> {
    let largest = i64::from(LARGEST_RESONANCE);
    let whole = |by: i64| {
        let products = fractions.iter().map(|fraction| {
            let number = (fraction.clone() * Rational::from(by)).to_natural()?;
            i64::try_from(number).ok().filter(|multiple| *multiple <= largest)
        });
        products.collect::<Option<Vec<i64>>>()
    };
    (1..=largest).find_map(whole)
}
