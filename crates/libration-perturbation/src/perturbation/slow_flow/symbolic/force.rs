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
    /// Symbols with their columns and their orders.
    pub(super) symbols: &'a [(String, usize, i64)],
    /// The drive frequency, whose wave is e^{is} here.
    pub(super) drive: Option<&'a DriveFrequency>,
    /// The highest degree of power series in the displacement.
    pub(super) degree: usize,
    /// `true` if a power series was cut off.
    pub(super) is_cut_off: Cell<bool>,
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
        let found = match (symbols.as_slice(), numbers.iter().min()) {
            ([one], None) => Some(Self::Symbol(one.clone())),
            ([], Some(smallest)) => Some(Self::Number(smallest.clone())),
            _ => None,
        };
        let opposite = Expression::Negate(Box::new(first.clone())).simplified();
        match found.filter(|found| rates.iter().all(|rate| found.multiple(rate).is_some())) {
            Some(found) => Ok(Some(found)),
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
                let below = self.constant(b).ok_or_else(|| Error::NotPolynomial(formula.to_string()))?;
                let inverse = letters.inverse(&below);
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
            return Ok(self.letters.power_at(self.letters.place_of(column, coordinate), 1));
        }
        if let Some(DriveFrequency::Symbol(name)) = self.drive
            && *name == symbol.name
        {
            return Ok(self.letters.power(Column::Drive, 1));
        }
        let known = self.symbols.iter().find(|(name, ..)| *name == symbol.name);
        let (_, place, order) = known.ok_or_else(|| Error::NotPolynomial(symbol.name.clone()))?;
        Ok(self.letters.times(&self.letters.power_at(*place, 1), &self.letters.power(Column::Order, *order)))
    }

    /// A formula without displacement, velocity and time.
    fn constant(&self, formula: &Expression) -> Option<Sum> {
        let moving = |symbol: &Symbol| self.variables.contains(&symbol.name) || symbol.name == "t";
        if formula.symbols().iter().any(moving) { None } else { self.read(formula).ok() }
    }

    fn raised(&self, base: &Expression, exponent: &Expression) -> Result<Sum, Error> {
        let refused = || Error::NotPolynomial(format!("({base})^({exponent})"));
        let exponent = exponent.simplified().to_rational().ok_or_else(refused)?;
        let value = self.read(base)?;
        match exponent.to_natural().and_then(|natural| usize::try_from(natural).ok()) {
            Some(natural) if natural <= 64 => Ok(self.letters.raised(&value, natural, i64::from(i16::MAX))),
            _ => {
                let value = self.constant(base).ok_or_else(refused)?;
                self.letters.ring.power(&value, &exponent).ok_or_else(refused)
            }
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
            Function::Sqrt if self.constant(of).is_some() => {
                self.letters.ring.value(Function::Sqrt, &argument).ok_or_else(refused)
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
        let kinked = [Column::Position, Column::Velocity].map(|it| powers[letters.place(it)]);
        let sign = match kinked {
            [2, 0] => Column::PositionSign,
            [0, 2] => Column::VelocitySign,
            _ => return None,
        };
        if powers[letters.place(Column::Wave)] != 0 || powers[letters.place(Column::Imaginary)] != 0 {
            return None;
        }
        let size = Rational::from(if factor.is_negative() { -1 } else { 1 });
        let sign = letters.scaled(&letters.power(sign, 1), &size);
        Some(if function == Function::Abs { letters.times(argument, &sign) } else { sign })
    }

    /// The power series of a function about zero.
    fn power_series(&self, function: Function, argument: &Sum) -> Option<Sum> {
        let letters = self.letters;
        let moving = [Column::Position, Column::Velocity].map(|column| letters.places(column)).concat();
        let still = letters.part(argument, |powers| moving.iter().all(|&place| powers[place] == 0));
        if !still.is_zero() {
            return None;
        }
        self.is_cut_off.set(true);
        let symbol = Symbol::plain("u");
        let formula = Expression::Call(function, Box::new(Expression::Symbol(symbol.clone())));
        let series = formula.taylor_series(&Rationals, &symbol, &Rational::from(0), self.degree + 1)?;
        let mut sum = letters.zero();
        let mut power = letters.number(Rational::from(1));
        for coefficient in series {
            sum = letters.add(&sum, &letters.scaled(&power, &coefficient));
            let next = letters.times(&power, argument);
            power = letters.part(&next, |powers| {
                moving.iter().map(|&place| powers[place]).sum::<i64>()
                    <= 2 * i64::try_from(self.degree).unwrap_or(0)
            });
        }
        Some(sum)
    }
}
