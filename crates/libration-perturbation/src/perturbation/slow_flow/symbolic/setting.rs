//! The equation with names, orders and columns: what is small, what ω0 is, and how W differs from its resonance.

use super::SymbolicSlowFlowOptions;
use super::error::{LARGEST_RESONANCE, SymbolicSlowFlowError as Error};
use super::force::{DriveFrequency, Reader};
use super::letters::{Column, Letters, Sum};
use super::scales::{Forced, Term};
use libration_numbers::algebra::{Rational, Ring};
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use std::cell::Cell;

/// Names of the result that the symbols of the equation do not have.
#[derive(Clone, Debug)]
pub(super) struct Names {
    pub(super) amplitude: String,
    pub(super) phase: String,
    pub(super) detuning: String,
    pub(super) natural: String,
}

/// The equation as it is read.
pub(super) struct Setting {
    pub(super) names: Names,
    pub(super) letters: Letters,
    pub(super) drive: Option<DriveFrequency>,
    pub(super) resonance: (i64, i64),
    /// Parameters with columns and orders.
    symbols: Vec<(String, usize, i64)>,
    /// The one small parameter that multiplies the detuning as well.
    bookkeeping: Option<usize>,
    detuning_order: Option<i64>,
}

impl Setting {
    pub(super) fn new(equation: &Equation, options: &SymbolicSlowFlowOptions) -> Result<Self, Error> {
        equation.refuse_first_order()?;
        let [variable] = equation.variables() else {
            return Err(Error::SeveralEquations(equation.variables().len()));
        };
        let drive = DriveFrequency::of(&equation.accelerations()[0])?;
        let resonance = resonance(options.resonance, drive.is_some())?;
        let mut open: Vec<String> = equation.parameters().into_iter().collect();
        let names = Names::new(&open, variable, drive.as_ref());
        if let Some(DriveFrequency::Symbol(frequency)) = &drive {
            open.retain(|name| name != frequency);
        }
        let small = small(&open, options)?;
        open.sort_by_key(|name| small.iter().all(|(other, _)| other != name));
        if small.len() != 1 {
            open.sort();
        }
        let letters = Letters::new(&open, [&names.natural, &names.detuning, &names.amplitude]);
        let order = |name: &str| small.iter().find(|(other, _)| other == name).map_or(0, |(_, order)| *order);
        let symbols =
            open.iter().enumerate().map(|(place, name)| (name.clone(), place, order(name))).collect();
        let bookkeeping = (small.len() == 1).then_some(0);
        let stated = small.iter().find(|(name, _)| *name == names.detuning).map(|(_, order)| *order);
        let detuning_order = stated.or_else(|| bookkeeping.map(|place| order(&open[place])));
        Ok(Self { names, letters, drive, resonance, symbols, bookkeeping, detuning_order })
    }

    /// The highest order of a parameter.
    pub(super) fn highest_order(&self) -> Option<i64> {
        self.symbols.iter().map(|(.., order)| *order).filter(|order| *order > 0).max()
    }

    /// The terms of the equation, by orders.
    pub(super) fn forced(
        &self,
        equation: &Equation,
        order: i64,
        watch: &Watch<'_>,
    ) -> Result<(Forced<'_>, Found), Error> {
        let letters = &self.letters;
        let reader = Reader {
            letters,
            variable: &equation.variables()[0],
            symbols: &self.symbols,
            drive: self.drive.as_ref().map(|drive| (drive, self.resonance.0)),
            degree: usize::try_from(order).unwrap_or(0) + 1,
            is_cut_off: Cell::new(false),
        };
        let acceleration = reader.read(&equation.accelerations()[0])?;
        if acceleration.is_beyond_limit() {
            return Err(Error::TooLarge(0));
        }
        if !self.is_polynomial(&acceleration) {
            return Err(Error::NotPolynomial(equation.accelerations()[0].to_string()));
        }
        let natural = self.natural_frequency(&acceleration)?;
        let shift = |forced: &mut Forced<'_>, grade: i64| {
            let resonant =
                Rational::new(self.resonance.0, self.resonance.1).unwrap_or_else(|| Rational::from(1));
            let resonant = letters.scaled(&natural.omega0, &resonant);
            forced.detuning = self.detuning(grade);
            letters.substituted(
                &acceleration,
                Column::Drive,
                &letters.add(&resonant, &forced.detuning),
                i64::from(i16::MAX),
            )
        };
        let mut forced = Forced {
            letters,
            omega0: natural.omega0.clone(),
            resonance: self.resonance,
            detuning: letters.zero(),
            drive: letters.zero(),
            terms: vec![],
        };
        let grade = match (&self.drive, self.detuning_order) {
            (None, _) => None,
            (Some(_), Some(stated)) => Some(stated),
            (Some(_), None) => {
                let whole = shift(&mut forced, order);
                self.split(&mut forced, &whole, reader.is_cut_off.get())?;
                forced.detuning = letters.zero();
                Some(forced.first_order(order, watch)?)
            }
        };
        let whole = grade.map_or_else(|| acceleration.clone(), |grade| shift(&mut forced, grade));
        let drives = self.split(&mut forced, &whole, reader.is_cut_off.get())?;
        Ok((forced, Found { natural: natural.explained, drives }))
    }

    /// Natural powers of the drive frequency and of the small parameters.
    fn is_polynomial(&self, acceleration: &Sum) -> bool {
        let places = [Column::Drive, Column::Order].map(|column| self.letters.place(column));
        acceleration
            .half_powers()
            .all(|(powers, _)| places.iter().all(|&place| powers[place] >= 0 && powers[place] % 2 == 0))
    }

    /// W − (p/q)·ω0: σ, times the small parameter where there is one.
    fn detuning(&self, order: i64) -> Sum {
        let letters = &self.letters;
        let factor = self
            .bookkeeping
            .map_or_else(|| letters.number(Rational::from(1)), |place| letters.power_at(place, 1));
        let sigma = letters.times(&letters.power(Column::Detuning, 1), &letters.power(Column::Order, order));
        letters.times(&sigma, &factor)
    }

    fn natural_frequency(&self, acceleration: &Sum) -> Result<NaturalFrequency, Error> {
        let letters = &self.letters;
        let linear = [(Column::Position, 2)];
        let square = letters.scaled(&self.part(acceleration, &linear), &Rational::from(-1));
        let square = letters.times(&square, &letters.power(Column::Position, -1));
        let refused = || Error::NoOscillation(square.to_string());
        if let Some((_, factor)) = square.as_single_term() {
            if factor.is_negative() {
                return Err(refused());
            }
            let half = Rational::new(1, 2).ok_or_else(refused)?;
            if let Some(omega0) = letters.ring.power(&square, &half) {
                return Ok(NaturalFrequency { omega0, explained: None });
            }
        }
        if square.is_zero() {
            return Err(refused());
        }
        let omega0 = letters.power(Column::Natural, 1);
        Ok(NaturalFrequency { omega0, explained: Some(square) })
    }

    /// Terms of order zero with these powers, doubled, and no others of displacement, velocity and waves.
    fn part(&self, sum: &Sum, with: &[(Column, i64)]) -> Sum {
        let moving = [
            Column::Order,
            Column::Wave,
            Column::Position,
            Column::Velocity,
            Column::PositionSign,
            Column::VelocitySign,
        ];
        self.letters.part(sum, |powers| {
            moving.iter().all(|column| {
                let expected = with.iter().find(|(own, _)| own == column).map_or(0, |(_, power)| *power);
                powers[self.letters.place(*column)] == expected
            })
        })
    }

    /// Distributes the acceleration, and returns the symbols of the drive that does not contain the displacement.
    fn split(
        &self,
        forced: &mut Forced<'_>,
        acceleration: &Sum,
        is_cut_off: bool,
    ) -> Result<Vec<usize>, Error> {
        let letters = &self.letters;
        let linear = self.part(acceleration, &[(Column::Position, 2)]);
        let rest = letters.subtract(acceleration, &linear);
        let columns = [Column::Position, Column::Velocity, Column::PositionSign, Column::VelocitySign]
            .map(|column| letters.place(column));
        let (grade, wave) = (letters.place(Column::Order), letters.place(Column::Wave));
        let degree = |powers: &[i64]| (powers[columns[0]] + powers[columns[1]]) / 2;
        let kinked = |powers: &[i64]| powers[columns[2]] != 0 || powers[columns[3]] != 0;
        // Without a small factor a term is small because the amplitude is, and then powers of the amplitude count everywhere.
        let by_amplitude = rest.half_powers().any(|(powers, _)| powers[grade] == 0 && degree(powers) >= 2);
        if is_cut_off && !by_amplitude {
            return Err(Error::EndlessSeries);
        }
        let graded = letters.changed(&rest, |powers, factor| {
            if by_amplitude && degree(powers) >= 1 {
                powers[grade] += 2 * (degree(powers) - 1);
            }
            factor.clone()
        });
        let large = letters.of_order(&graded, 0);
        let waves =
            letters.part(&large, |powers| degree(powers) == 0 && powers[wave] != 0 && !kinked(powers));
        self.refuse_large(&letters.subtract(&large, &waves), degree)?;
        forced.drive = waves;
        forced.terms = terms(letters, &letters.subtract(&graded, &large), columns);
        if forced.terms.is_empty() && forced.detuning.is_zero() {
            return Err(Error::NothingSmall);
        }
        let driving = letters.part(&graded, |powers| degree(powers) == 0 && powers[wave] != 0);
        let is_present = |place: &usize| driving.half_powers().any(|(powers, _)| powers[*place] > 0);
        Ok((0..letters.given).filter(is_present).collect())
    }

    /// Refuses terms of order zero other than the spring and the drive.
    fn refuse_large(&self, large: &Sum, degree: impl Fn(&[i64]) -> i64) -> Result<(), Error> {
        let letters = &self.letters;
        let Some((powers, _)) = large.half_powers().next() else { return Ok(()) };
        let term = letters.part(large, |own| own == &powers[..]);
        let text = letters.changed(&term, |powers, factor| {
            powers[letters.place(Column::Order)..].fill(0);
            factor.clone()
        });
        Err(match (degree(powers), powers[letters.place(Column::Wave)]) {
            (0, _) => Error::Equilibrium(text.to_string()),
            (_, 0) => Error::NotSmall(text.to_string()),
            _ => Error::ParametricNotSmall(text.to_string()),
        })
    }
}

/// ω0, and its square where it has a name of its own.
struct NaturalFrequency {
    omega0: Sum,
    explained: Option<Sum>,
}

/// The terms of the equation by kind.
pub(super) struct Found {
    /// ω0², where ω0 has a name of its own.
    pub(super) natural: Option<Sum>,
    /// Columns of the amplitudes of drives.
    pub(super) drives: Vec<usize>,
}

/// The terms by powers of displacement and velocity, their signs, and their orders.
fn terms(letters: &Letters, sum: &Sum, columns: [usize; 4]) -> Vec<Term> {
    let grade = letters.place(Column::Order);
    let mut keys: Vec<[i64; 5]> = sum
        .half_powers()
        .map(|(powers, _)| {
            let [x, v, sx, sv] = columns.map(|place| powers[place] / 2);
            [x, v, sx, sv, powers[grade] / 2]
        })
        .collect();
    keys.sort_unstable();
    keys.dedup();
    let term = |key: [i64; 5]| {
        let [x, v, sx, sv, order] = key;
        let own = letters.part(sum, |powers| {
            columns.map(|place| powers[place] / 2) == [x, v, sx, sv] && powers[grade] / 2 == order
        });
        let coefficient = letters.changed(&own, |powers, factor| {
            for place in columns {
                powers[place] = 0;
            }
            factor.clone()
        });
        let powers = [x, v].map(|power| usize::try_from(power).unwrap_or(0));
        Term { coefficient, powers, signs: [sx != 0, sv != 0], order }
    };
    keys.into_iter().map(term).collect()
}

fn resonance(given: Option<(u32, u32)>, is_driven: bool) -> Result<(i64, i64), Error> {
    match (given, is_driven) {
        (None, false) => Ok((1, 1)),
        (None, true) => Err(Error::NoResonance),
        (Some(_), false) => Err(Error::NoDrive),
        (Some((p, q)), true) => {
            let range = 1..=LARGEST_RESONANCE;
            let common = (2..=p.min(q)).any(|divisor| p.is_multiple_of(divisor) && q.is_multiple_of(divisor));
            if !range.contains(&p) || !range.contains(&q) || common {
                return Err(Error::Resonance(p, q));
            }
            Ok((i64::from(p), i64::from(q)))
        }
    }
}

/// The small parameters with their orders: those named, or `eps`.
fn small(open: &[String], options: &SymbolicSlowFlowOptions) -> Result<Vec<(String, i64)>, Error> {
    let mut small = vec![];
    for (name, order) in &options.small {
        if !open.contains(name) && name != "sigma" {
            return Err(Error::UnknownParameter { name: name.clone(), open: open.to_vec() });
        }
        if *order == 0 || *order > super::MAX_SYMBOLIC_SLOW_ORDER {
            return Err(Error::Order(*order));
        }
        small.push((name.clone(), i64::try_from(*order).unwrap_or(1)));
    }
    if small.is_empty() && open.iter().any(|name| name == "eps") {
        small.push(("eps".to_owned(), 1));
    }
    Ok(small)
}

impl Names {
    fn new(open: &[String], variable: &str, drive: Option<&DriveFrequency>) -> Self {
        let is_taken = |name: &str| {
            let is_drive = matches!(drive, Some(DriveFrequency::Number(_))) && name == "W";
            is_drive || name == variable || open.iter().any(|other| other == name)
        };
        let free = |name: &str| {
            if !is_taken(name) {
                return name.to_owned();
            }
            let numbered = (1..).map(|number| format!("{name}_{number}"));
            numbered.into_iter().find(|name| !is_taken(name)).unwrap_or_default()
        };
        Self { amplitude: free("A"), phase: free("phi"), detuning: free("sigma"), natural: free("w0") }
    }
}
