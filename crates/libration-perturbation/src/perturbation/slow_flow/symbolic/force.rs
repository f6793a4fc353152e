//! The equation of motion as a polynomial in displacement, velocity and waves of the drive, each term with its order.

use super::error::SymbolicSlowFlowError as Error;
use super::letters::{Column, Letters, Sum};
use libration_numbers::algebra::{Rational, Rationals, Ring};
use libration_numbers::expression::{Expression, Function, Symbol};
use std::cell::Cell;

/// The reading of formulas.
pub(super) struct Reader<'a> {
    pub(super) letters: &'a Letters,
    /// The displacements.
    pub(super) variables: &'a [String],
    /// The equilibrium, which is added to a displacement; `None` for 0.
    pub(super) equilibrium: Option<Sum>,
    /// Symbols with their columns and their orders.
    pub(super) symbols: &'a [(String, usize, i64)],
    /// The drive frequency, whose wave is e^{is} here.
    pub(super) drive: Option<&'a DriveFrequency>,
    /// The order to which power series in small terms are taken.
    pub(super) order: i64,
    /// The highest degree of power series in the displacement.
    pub(super) degree: usize,
    /// `true` if a power series was cut off.
    pub(super) is_cut_off: Cell<bool>,
    /// `true` if a power series in small parameters was cut off.
    pub(super) is_series: Cell<bool>,
}

/// The frequency W of the drive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum DriveFrequency {
    Symbol(String),
    Number(Rational),
}

impl DriveFrequency {
    /// The frequency of which all rates are natural multiples: the symbol in them, or the smallest number.
    pub(super) fn of(formulas: &[Expression]) -> Result<Option<Self>, Error> {
        let mut rates = vec![];
        formulas.iter().try_for_each(|formula| collect_rates(formula, &mut rates))?;
        let mut numbers = vec![];
        let mut symbols = vec![];
        for rate in &rates {
            match rate.to_rational() {
                Some(number) => numbers.push(number.magnitude()),
                None => symbols.extend(rate.symbols().into_iter().map(|symbol| symbol.name)),
            }
        }
        symbols.sort();
        symbols.dedup();
        let Some(first) = rates.first() else { return Ok(None) };
        let drive = match (symbols.as_slice(), numbers.iter().min()) {
            ([one], None) => Some(Self::Symbol(one.clone())),
            ([], Some(smallest)) => Some(Self::Number(smallest.clone())),
            _ => None,
        };
        let opposite = Expression::Negate(Box::new(first.clone())).simplified();
        match drive.filter(|frequency| rates.iter().all(|rate| frequency.multiple(rate).is_some())) {
            Some(frequency) => Ok(Some(frequency)),
            None if rates.iter().all(|rate| rate == first || *rate == opposite) => {
                Err(Error::DriveFrequency(first.to_string()))
            }
            None => Err(Error::SeveralDrives),
        }
    }

    /// The whole number of times that a rate is this frequency.
    fn multiple(&self, rate: &Expression) -> Option<i64> {
        let quotient = match self {
            Self::Number(number) => rate.to_rational()?.checked_div(number)?,
            Self::Symbol(name) => {
                let symbol = Symbol::plain(name);
                let slope = rate.derivative(&symbol).simplified().to_rational()?;
                let zero = rate.substitute(&symbol, &Expression::from(0)).simplified().to_rational()?;
                zero.is_zero().then_some(slope)?
            }
        };
        let size = i64::try_from(quotient.magnitude().to_natural()?).ok()?;
        Some(if quotient.is_negative() { -size } else { size })
    }
}

/// The rates of change of the arguments in which the time occurs.
fn collect_rates(formula: &Expression, rates: &mut Vec<Expression>) -> Result<(), Error> {
    let time = Symbol::plain("t");
    match formula {
        Expression::Call(function, of) if of.contains(&time) => {
            let rate = of.derivative(&time).simplified();
            let at_zero = of.substitute(&time, &Expression::from(0)).simplified();
            if !matches!(function, Function::Sin | Function::Cos)
                || rate.contains(&time)
                || !at_zero.vanishes()
            {
                return Err(Error::Time(formula.to_string()));
            }
            rates.push(rate);
            Ok(())
        }
        Expression::Symbol(symbol) if *symbol == time => Err(Error::Time("t".to_owned())),
        _ => formula.parts().try_for_each(|part| collect_rates(part, rates)),
    }
}

impl Reader<'_> {
    /// The formula as a sum.
    pub(super) fn read(&self, formula: &Expression) -> Result<Sum, Error> {
        let letters = self.letters;
        Ok(match formula {
            Expression::Number(number) => letters.number(number.clone()),
            Expression::Pi => letters.power(Column::Pi, 1),
            Expression::Symbol(symbol) => self.symbol(symbol)?,
            Expression::Negate(a) => letters.scaled(&self.read(a)?, &Rational::from(-1)),
            Expression::Add(a, b) => letters.add(&self.read(a)?, &self.read(b)?),
            Expression::Subtract(a, b) => letters.subtract(&self.read(a)?, &self.read(b)?),
            Expression::Multiply(a, b) => letters.times(&self.read(a)?, &self.read(b)?),
            Expression::Divide(a, b) => {
                let inverse = self.fractional_power(&self.read(b)?, &Rational::from(-1));
                let inverse = inverse.ok_or_else(|| Error::NotPolynomial(formula.to_string()))?;
                letters.times(&self.read(a)?, &inverse)
            }
            Expression::Power(a, exponent) => self.raised(a, exponent)?,
            Expression::Call(function, of) => self.call(*function, of)?,
        })
    }

    fn symbol(&self, symbol: &Symbol) -> Result<Sum, Error> {
        if let Some(coordinate) = self.variables.iter().position(|name| *name == symbol.name) {
            let column = if symbol.primes == 0 { Column::Position } else { Column::Velocity };
            let moving = self.letters.power_at(self.letters.index_of(column, coordinate), 1);
            return Ok(match &self.equilibrium {
                Some(equilibrium) if symbol.primes == 0 => self.letters.add(equilibrium, &moving),
                _ => moving,
            });
        }
        let entry = self.symbols.iter().find(|(name, ..)| *name == symbol.name);
        if let (None, Some(DriveFrequency::Symbol(name))) = (entry, self.drive)
            && *name == symbol.name
        {
            return Ok(self.letters.power(Column::Drive, 1));
        }
        let (_, column, order) = entry.ok_or_else(|| Error::NotPolynomial(symbol.name.clone()))?;
        Ok(self.letters.times(&self.letters.power_at(*column, 1), &self.letters.power(Column::Order, *order)))
    }

    fn raised(&self, base: &Expression, exponent: &Expression) -> Result<Sum, Error> {
        let refused = || Error::NotPolynomial(format!("({base})^({exponent})"));
        let exponent = exponent.simplified().to_rational().ok_or_else(refused)?;
        let value = self.read(base)?;
        match exponent.to_natural().and_then(|natural| usize::try_from(natural).ok()) {
            Some(natural) if natural <= 64 => Ok(self.letters.raised(&value, natural, i64::from(i16::MAX))),
            _ => self.fractional_power(&value, &exponent).ok_or_else(refused),
        }
    }

    fn call(&self, function: Function, of: &Expression) -> Result<Sum, Error> {
        let refused = || Error::NotPolynomial(format!("{}({of})", function.name()));
        if of.contains(&Symbol::plain("t")) {
            return self.wave(function, of).ok_or_else(refused);
        }
        let argument = self.read(of)?;
        match function {
            Function::Abs | Function::Sign if self.variables.len() > 1 => Err(Error::SeveralKinks),
            Function::Abs | Function::Sign => self.kink(function, &argument).ok_or_else(refused),
            Function::Sqrt => {
                let half = Rational::new(1, 2).ok_or_else(refused)?;
                self.fractional_power(&argument, &half).ok_or_else(refused)
            }
            _ => self.power_series(function, &argument).ok_or_else(refused),
        }
    }

    /// cos or sin of a multiple of the drive's phase.
    fn wave(&self, function: Function, of: &Expression) -> Option<Sum> {
        let letters = self.letters;
        let k = self.drive?.multiple(&of.derivative(&Symbol::plain("t")).simplified())?;
        let [forward, backward] = [k, -k].map(|k| letters.power(Column::Wave, k));
        let half = Rational::new(1, 2)?;
        match function {
            Function::Cos => Some(letters.scaled(&letters.add(&forward, &backward), &half)),
            _ => {
                let sine = letters.scaled(&letters.subtract(&backward, &forward), &half);
                Some(letters.times(&sine, &letters.power(Column::Imaginary, 1)))
            }
        }
    }

    /// |x| as x times the sign of x, also for a positive multiple of x or of x′.
    fn kink(&self, function: Function, argument: &Sum) -> Option<Sum> {
        let letters = self.letters;
        let (powers, factor) = argument.as_single_term()?;
        let kinked = [Column::Position, Column::Velocity].map(|column| powers[letters.index(column)]);
        let sign = match kinked {
            [2, 0] => Column::PositionSign,
            [0, 2] => Column::VelocitySign,
            _ => return None,
        };
        if powers[letters.index(Column::Wave)] != 0 || powers[letters.index(Column::Imaginary)] != 0 {
            return None;
        }
        let size = Rational::from(if factor.is_negative() { -1 } else { 1 });
        let sign = letters.scaled(&letters.power(sign, 1), &size);
        Some(if function == Function::Abs { letters.times(argument, &sign) } else { sign })
    }

    /// A power that is not natural: of a constant product exactly, of its sum with small terms as the binomial series.
    fn fractional_power(&self, base: &Sum, exponent: &Rational) -> Option<Sum> {
        let letters = self.letters;
        let moving = self.moving();
        let order = letters.index(Column::Order);
        let is_still = |powers: &[i64]| moving.iter().all(|&column| powers[column] == 0);
        let still = letters.part(base, |powers| powers[order] == 0 && is_still(powers));
        // The order of a constant product is one of its powers.
        let constant = if still.is_zero() { base.clone() } else { still };
        let (powers, _) = constant.as_single_term()?;
        let power = match is_still(powers) {
            true => letters.ring.power(&constant, exponent)?,
            false => return None,
        };
        let rest = letters.subtract(base, &constant);
        if rest.is_zero() {
            return Some(power);
        }
        let relative = letters.times(&rest, &letters.inverse(&constant)?);
        let mut coefficient = Rational::from(1);
        let series = (0..=i64::try_from(self.degree).ok()?).map(|n| {
            let next = exponent.clone() - Rational::from(n);
            let following =
                coefficient.clone() * next * Rational::new(1, n + 1).unwrap_or_else(|| Rational::from(0));
            std::mem::replace(&mut coefficient, following)
        });
        Some(letters.times(&power, &self.small_series(series, &relative)?))
    }

    /// The power series of a function about zero.
    fn power_series(&self, function: Function, argument: &Sum) -> Option<Sum> {
        let symbol = Symbol::plain("u");
        let formula = Expression::Call(function, Box::new(Expression::Symbol(symbol.clone())));
        let series = formula.taylor_series(&Rationals, &symbol, &Rational::from(0), self.degree + 1)?;
        self.small_series(series.into_iter(), argument)
    }

    /// Σ cₙ·uⁿ of a sum whose terms are small, by their orders or as displacements or velocities.
    fn small_series(&self, series: impl Iterator<Item = Rational>, argument: &Sum) -> Option<Sum> {
        let letters = self.letters;
        let order = letters.index(Column::Order);
        let moving = [Column::Position, Column::Velocity].map(|column| letters.indices(column)).concat();
        let degree = |powers: &[i64]| moving.iter().map(|&column| powers[column]).sum::<i64>();
        let is_graded = argument.half_powers().all(|(powers, _)| powers[order] > 0);
        if argument.half_powers().any(|(powers, _)| powers[order] <= 0 && degree(powers) <= 0) {
            return None;
        }
        let cut_off = if is_graded { &self.is_series } else { &self.is_cut_off };
        cut_off.set(true);
        let highest = 2 * i64::try_from(self.degree).ok()?;
        let mut sum = letters.zero();
        let mut power = letters.number(Rational::from(1));
        for coefficient in series {
            sum = letters.add(&sum, &letters.scaled(&power, &coefficient));
            let next = letters.product(&power, argument, self.order);
            power = letters.part(&next, |powers| is_graded || degree(powers) <= highest);
        }
        Some(sum)
    }

    /// The columns of variables.
    fn moving(&self) -> Vec<usize> {
        let columns =
            [Column::Drive, Column::Wave, Column::Imaginary, Column::PositionSign, Column::VelocitySign];
        let mut all: Vec<usize> = columns.map(|column| self.letters.index(column)).to_vec();
        all.extend([Column::Position, Column::Velocity].map(|column| self.letters.indices(column)).concat());
        all
    }
}
