//! The value of a formula: in digits, as a power series, or in any other ring.

use std::collections::BTreeMap;

use super::formula::{Formula, Name, Subscript};
use libration::algebra::{Function, Rational, Ring};

/// A ring with infinite sums, integrals, derivatives and means.
pub trait Analysis: Ring {
    /// Returns `true` if an infinite sum may end at this term.
    fn is_negligible(&self, term: &Self::Element, sum: &Self::Element) -> bool;
    /// Maximum number of terms of an infinite sum.
    fn most_terms(&self) -> usize;
    /// ∫ over the interval.
    fn integral(
        &self,
        from: &Self::Element,
        to: &Self::Element,
        integrand: &mut dyn FnMut(Self::Element) -> Result<Self::Element, EvaluationError>,
    ) -> Result<Self::Element, EvaluationError>;
    /// The derivative at 0 of a function of one variable.
    fn slope(
        &self,
        function: &mut dyn FnMut(Self::Element) -> Result<Self::Element, EvaluationError>,
    ) -> Result<Self::Element, EvaluationError>;
    /// The arithmetic–geometric mean.
    fn agm(&self, a: &Self::Element, b: &Self::Element) -> Option<Self::Element>;
    /// The value of omitted terms.
    fn left_out(&self, order: &Self::Element) -> Result<Self::Element, EvaluationError>;
}

/// The reason why a formula has no value.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum EvaluationError {
    /// A symbol without a value.
    #[error("`{0}` has no value here")]
    Unknown(String),
    /// An operation whose result is outside the ring.
    #[error("{0} cannot be formed here")]
    NotInRing(&'static str),
    /// An infinite sum or an integral that does not converge.
    #[error("{0} does not converge fast enough to be checked")]
    Divergent(&'static str),
}

/// The values of symbols and functions.
#[derive(Clone, Debug)]
pub struct Values<E> {
    numbers: BTreeMap<String, E>,
    indices: BTreeMap<String, i64>,
    functions: BTreeMap<String, (Vec<Name>, Formula)>,
    /// Names that depend on the time, and their rates of change.
    rates: Vec<(Name, Formula)>,
}

impl<E> Default for Values<E> {
    fn default() -> Self {
        Self {
            numbers: BTreeMap::new(),
            indices: BTreeMap::new(),
            functions: BTreeMap::new(),
            rates: Vec::new(),
        }
    }
}

/// The name of a function, its parameters, and its body.
pub(super) type FunctionOf = (Name, Vec<Name>, Formula);

/// The symbol of time.
pub(super) const TIME: &str = "t";

impl<E: Clone> Values<E> {
    /// Assigns a number to a symbol.
    pub fn set(&mut self, name: &Name, value: E) {
        let key = self.key(name);
        self.indices.remove(&key);
        self.numbers.insert(key, value);
    }

    /// Assigns an integer to a symbol.
    pub(super) fn set_index(&mut self, name: &Name, value: i64) {
        self.indices.insert(self.key(name), value);
    }

    /// Defines a function.
    pub(super) fn define(&mut self, name: &Name, parameters: &[&str], body: Formula) {
        let parameters = parameters.iter().map(|parameter| Name::new(parameter)).collect();
        self.functions.insert(self.key(name), (parameters, body));
    }

    /// Declares the rate at which a symbol changes with time.
    pub(super) fn set_rate(&mut self, name: &Name, rate: Formula) {
        self.rates.push((name.clone(), rate));
    }

    /// The values of the names in formulas, and the functions that they apply, directly or indirectly.
    pub(super) fn used_in(&self, formulas: &[&Formula]) -> (Vec<(Name, E)>, Vec<FunctionOf>) {
        let (mut numbers, mut functions) = (BTreeMap::new(), BTreeMap::new());
        let mut open: Vec<Formula> = formulas.iter().map(|formula| (*formula).clone()).collect();
        while let Some(formula) = open.pop() {
            for name in formula.applied() {
                let key = self.key(&name);
                if let (Some((parameters, body)), false) =
                    (self.functions.get(&key), functions.contains_key(&key))
                {
                    open.push(body.clone());
                    functions.insert(key, (name, parameters.clone(), body.clone()));
                }
            }
            for name in formula.free_names() {
                if name.letter == TIME {
                    let moving =
                        self.rates.iter().flat_map(|(name, rate)| [Formula::from(name), rate.clone()]);
                    open.extend(moving);
                }
                let key = self.key(&name);
                if let Some(value) = self.numbers.get(&key) {
                    numbers.insert(key, (name, value.clone()));
                }
            }
        }
        (numbers.into_values().collect(), functions.into_values().collect())
    }

    /// The key of a name, with the values of its indices.
    fn key(&self, name: &Name) -> String {
        let primes = "'".repeat(usize::from(name.primes));
        let below = match &name.subscript {
            None => String::new(),
            Some(Subscript::Word(word)) => format!("_{word}"),
            Some(Subscript::Index(index)) => match self.constant(index) {
                Some(value) => format!("_{value}"),
                None => format!("_{index:?}"),
            },
        };
        format!("{}{below}{primes}", name.letter)
    }

    /// The value of a formula that contains only numbers and indices.
    pub(super) fn constant(&self, formula: &Formula) -> Option<Rational> {
        match formula {
            Formula::Number(value) => Some(value.clone()),
            Formula::Decimal(value) => value.value(),
            Formula::Name(name) => self.indices.get(&self.key(name)).map(|&index| Rational::from(index)),
            Formula::Negate(operand) => Some(-self.constant(operand)?),
            Formula::Sum(terms) => {
                terms.iter().try_fold(Rational::from(0), |sum, term| Some(sum + self.constant(term)?))
            }
            Formula::Product(factors) => factors
                .iter()
                .try_fold(Rational::from(1), |product, factor| Some(product * self.constant(factor)?)),
            Formula::Fraction(over, under) => self.constant(over)?.checked_div(&self.constant(under)?),
            Formula::Power(base, exponent) => {
                self.constant(base)?.integer_power(isize::try_from(self.integer(exponent)?).ok()?)
            }
            _ => None,
        }
    }

    fn integer(&self, formula: &Formula) -> Option<i64> {
        let value = self.constant(formula)?;
        (value.denominator() == "1").then(|| value.numerator().parse().ok()).flatten()
    }
}

/// Evaluates the formula.
pub fn evaluate<R: Analysis>(
    formula: &Formula,
    ring: &R,
    values: &Values<R::Element>,
) -> Result<R::Element, EvaluationError> {
    let of = |formula: &Formula| evaluate(formula, ring, values);
    let rational = |value: &Rational| ring.rational(value).ok_or(EvaluationError::NotInRing("a fraction"));
    match formula {
        Formula::Number(value) => rational(value),
        Formula::Decimal(value) => {
            let plain = rational(&value.value().ok_or(EvaluationError::NotInRing("a decimal"))?)?;
            if value.unit == super::formula::DecimalUnit::Degree { degrees(ring, &plain) } else { Ok(plain) }
        }
        Formula::Pi => ring.pi().ok_or(EvaluationError::NotInRing("π")),
        Formula::Name(name) => of_name(name, ring, values),
        Formula::Negate(operand) => Ok(ring.negate(&of(operand)?)),
        Formula::Sum(terms) => terms.iter().try_fold(ring.zero(), |sum, term| Ok(ring.add(&sum, &of(term)?))),
        Formula::Product(factors) => {
            let one = rational(&Rational::from(1))?;
            factors.iter().try_fold(one, |product, factor| Ok(ring.multiply(&product, &of(factor)?)))
        }
        Formula::Fraction(over, under) => {
            ring.divide(&of(over)?, &of(under)?).ok_or(EvaluationError::NotInRing("a quotient"))
        }
        Formula::Power(base, exponent) => power(base, exponent, ring, values),
        Formula::Call(function, argument) => {
            ring.value(*function, &of(argument)?).ok_or(EvaluationError::NotInRing(function.name()))
        }
        Formula::Apply(name, arguments) => apply(name, arguments, ring, values),
        Formula::Agm(a, b) => ring.agm(&of(a)?, &of(b)?).ok_or(EvaluationError::NotInRing("agm")),
        Formula::Series { index, from, to, term } => series(index, from, to.as_deref(), term, ring, values),
        Formula::Integral { variable, from, to, integrand } => {
            let mut inner = values.clone();
            ring.integral(&of(from)?, &of(to)?, &mut |x| {
                inner.set(variable, x);
                evaluate(integrand, ring, &inner)
            })
        }
        Formula::Derivative { of, by } => derivative(of, by, ring, values),
        Formula::DoubleFactorial(argument) => {
            let last =
                values.integer(argument).ok_or(EvaluationError::NotInRing("!! of what is not an integer"))?;
            rational(&double_factorial(last))
        }
        Formula::Order(argument) => ring.left_out(&of(argument)?),
    }
}

fn degrees<R: Ring>(ring: &R, value: &R::Element) -> Result<R::Element, EvaluationError> {
    let pi = ring.pi().ok_or(EvaluationError::NotInRing("π"))?;
    ring.over_integer(&ring.multiply(value, &pi), 180).ok_or(EvaluationError::NotInRing("an angle"))
}

fn of_name<R: Analysis>(
    name: &Name,
    ring: &R,
    values: &Values<R::Element>,
) -> Result<R::Element, EvaluationError> {
    let key = values.key(name);
    if let Some(&index) = values.indices.get(&key) {
        return ring.rational(&Rational::from(index)).ok_or(EvaluationError::NotInRing("an index"));
    }
    values.numbers.get(&key).cloned().ok_or(EvaluationError::Unknown(key))
}

fn power<R: Analysis>(
    base: &Formula,
    exponent: &Formula,
    ring: &R,
    values: &Values<R::Element>,
) -> Result<R::Element, EvaluationError> {
    let value = evaluate(base, ring, values)?;
    if let Some(whole) = values.integer(exponent) {
        return whole_power(ring, &value, whole);
    }
    if let Some(constant) = values.constant(exponent) {
        return ring.power(&value, &constant).ok_or(EvaluationError::NotInRing("a power"));
    }
    let logarithm = ring.value(Function::Ln, &value).ok_or(EvaluationError::NotInRing("a logarithm"))?;
    let product = ring.multiply(&evaluate(exponent, ring, values)?, &logarithm);
    ring.value(Function::Exp, &product).ok_or(EvaluationError::NotInRing("a power"))
}

/// aⁿ by repeated squaring.
fn whole_power<R: Ring>(ring: &R, base: &R::Element, exponent: i64) -> Result<R::Element, EvaluationError> {
    let one = ring.rational(&Rational::from(1)).ok_or(EvaluationError::NotInRing("a power"))?;
    let (mut power, mut square, mut rest) = (one.clone(), base.clone(), exponent.unsigned_abs());
    while rest > 0 {
        if rest % 2 == 1 {
            power = ring.multiply(&power, &square);
        }
        rest /= 2;
        if rest > 0 {
            square = ring.multiply(&square, &square);
        }
    }
    if exponent < 0 {
        ring.divide(&one, &power).ok_or(EvaluationError::NotInRing("a power"))
    } else {
        Ok(power)
    }
}

fn apply<R: Analysis>(
    name: &Name,
    arguments: &[Formula],
    ring: &R,
    values: &Values<R::Element>,
) -> Result<R::Element, EvaluationError> {
    let key = values.key(name);
    let (parameters, body) = values.functions.get(&key).ok_or(EvaluationError::Unknown(key))?;
    let mut inner = values.clone();
    for (parameter, argument) in parameters.iter().zip(arguments) {
        match values.integer(argument) {
            Some(index) => inner.set_index(parameter, index),
            None => inner.set(parameter, evaluate(argument, ring, values)?),
        }
    }
    evaluate(body, ring, &inner)
}

fn series<R: Analysis>(
    index: &Name,
    from: &Formula,
    to: Option<&Formula>,
    term: &Formula,
    ring: &R,
    values: &Values<R::Element>,
) -> Result<R::Element, EvaluationError> {
    let integer =
        |formula| values.integer(formula).ok_or(EvaluationError::NotInRing("a sum without integer limits"));
    let first = integer(from)?;
    let last = to.map(integer).transpose()?;
    let most = i64::try_from(ring.most_terms()).unwrap_or(i64::MAX);
    let mut inner = values.clone();
    let mut sum = ring.zero();
    for n in first..=last.unwrap_or(first.saturating_add(most)) {
        inner.set_index(index, n);
        let term = evaluate(term, ring, &inner)?;
        sum = ring.add(&sum, &term);
        if last.is_none() && ring.is_negligible(&term, &sum) {
            return Ok(sum);
        }
    }
    if last.is_some() { Ok(sum) } else { Err(EvaluationError::Divergent("the sum")) }
}

/// The derivative; only the variable varies, except for the time, with which every name with a rate varies as well.
fn derivative<R: Analysis>(
    of: &Formula,
    by: &Name,
    ring: &R,
    values: &Values<R::Element>,
) -> Result<R::Element, EvaluationError> {
    let mut movements = vec![];
    if by.letter == TIME {
        for (name, rate) in &values.rates {
            movements.push((name, of_name(name, ring, values)?, evaluate(rate, ring, values)?));
        }
    }
    let at = match of_name(by, ring, values) {
        // Without a value the time is in rates alone.
        Err(_) if by.letter == TIME => None,
        value => Some(value?),
    };
    ring.slope(&mut |small| {
        let mut inner = values.clone();
        if let Some(at) = &at {
            inner.set(by, ring.add(at, &small));
        }
        for (name, start, rate) in &movements {
            inner.set(name, ring.add(start, &ring.multiply(rate, &small)));
        }
        evaluate(of, ring, &inner)
    })
}

/// n!!, and 1 for n = 0 and n = −1.
fn double_factorial(last: i64) -> Rational {
    (1..=last).rev().step_by(2).fold(Rational::from(1), |product, factor| product * Rational::from(factor))
}
