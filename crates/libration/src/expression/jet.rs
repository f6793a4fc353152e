//! A tape evaluated on power series, one power of the variable after the other.

use super::Function;
use super::tape::{Operation, Tape};
use crate::algebra::{Ring, Slope};
use crate::series::recurrences::{
    Both, quotient, weighted_integral, weighted_integral_of_quotient, weighted_power,
};

/// Why a formula has no series: an operation has no value in the ring, or is not analytic where it is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NoSeries {
    /// The operation on the tape.
    pub(crate) place: usize,
}

/// The first coefficients of every result on a tape.
#[derive(Debug)]
pub(crate) struct Jet<'a, R: Ring> {
    ring: &'a R,
    tape: &'a Tape,
    places: Vec<Series<R::Element>>,
}

/// The coefficients of one result, and n times them where a later operation needs that.
#[derive(Clone, Debug)]
struct Series<E> {
    plain: Vec<E>,
    weighted: Vec<E>,
}

impl<E> Series<E> {
    fn both(&self) -> Both<'_, E> {
        Both { plain: &self.plain, weighted: &self.weighted }
    }
}

impl<'a, R: Ring> Jet<'a, R> {
    /// The values at the inputs' zeroth coefficients.
    pub(crate) fn new(ring: &'a R, tape: &'a Tape, inputs: &[R::Element]) -> Result<Self, NoSeries> {
        let mut jet = Self::empty(ring, tape);
        jet.restart(inputs)?;
        Ok(jet)
    }

    /// Begins again with other zeroth coefficients, in the memory it has.
    pub(crate) fn restart(&mut self, inputs: &[R::Element]) -> Result<(), NoSeries> {
        for place in 0..self.places.len() {
            let keep = usize::from(self.tape.is_constant(place));
            self.places[place].plain.truncate(keep);
            self.places[place].weighted.truncate(keep);
            if self.places[place].plain.is_empty() {
                let value = self.value(place, inputs).ok_or(NoSeries { place })?;
                self.push(place, value);
            }
        }
        Ok(())
    }

    /// The jet whose zeroth coefficients were found elsewhere, one for each place of the tape.
    pub(crate) fn with_values(ring: &'a R, tape: &'a Tape, values: Vec<R::Element>) -> Self {
        let mut jet = Self::empty(ring, tape);
        for (place, value) in values.into_iter().enumerate() {
            jet.push(place, value);
        }
        jet
    }

    fn empty(ring: &'a R, tape: &'a Tape) -> Self {
        let none = Series { plain: vec![], weighted: vec![] };
        Self { ring, tape, places: vec![none; tape.operations().len()] }
    }

    /// The coefficients of a formula, by its number.
    pub(crate) fn result(&self, formula: usize) -> &[R::Element] {
        &self.places[self.tape.results()[formula]].plain
    }

    /// The coefficients of a place on the tape.
    pub(crate) fn series(&self, place: usize) -> &[R::Element] {
        &self.places[place].plain
    }

    /// The zeroth coefficients of all places.
    pub(crate) fn values(&self) -> impl Iterator<Item = &R::Element> {
        self.places.iter().map(|series| &series.plain[0])
    }

    /// Appends the next coefficient of every place, given those of the inputs.
    pub(crate) fn extend(&mut self, inputs: &[R::Element]) -> Result<(), NoSeries> {
        for place in 0..self.places.len() {
            let value = self.coefficient(place, inputs).ok_or(NoSeries { place })?;
            self.push(place, value);
        }
        Ok(())
    }

    /// Takes the last coefficients back.
    pub(crate) fn shorten(&mut self) {
        for series in &mut self.places {
            series.plain.pop();
            series.weighted.pop();
        }
    }

    /// How the coefficients of all places change with those of one input, from the first on, where they are linear.
    pub(crate) fn gains(&self, input: usize) -> Result<Vec<R::Element>, NoSeries> {
        let values = self.values().cloned().collect();
        let mut jet = Self::with_values(self.ring, self.tape, values);
        let one = self.ring.rational(&1.into()).ok_or(NoSeries { place: 0 })?;
        let seed = |n: usize| if n == input { one.clone() } else { self.ring.zero() };
        jet.extend(&(0..self.tape.inputs()).map(seed).collect::<Vec<_>>())?;
        Ok(jet.places.into_iter().map(|mut series| series.plain.swap_remove(1)).collect())
    }

    /// Adds to the last coefficient of an input, and what follows from that to every place.
    pub(crate) fn amend(&mut self, gains: &[R::Element], change: &R::Element) {
        if self.ring.is_zero(change) {
            return;
        }
        for (place, gain) in gains.iter().enumerate().filter(|(_, gain)| !self.ring.is_zero(gain)) {
            let last = self.places[place].plain.pop().expect("a jet has its zeroth coefficients");
            self.places[place].weighted.pop();
            let amended = self.ring.add(&last, &self.ring.multiply(gain, change));
            self.push(place, amended);
        }
    }

    fn push(&mut self, place: usize, value: R::Element) {
        let series = &mut self.places[place];
        if self.tape.is_weighted(place) {
            let order = i64::try_from(series.plain.len()).unwrap_or(i64::MAX);
            series.weighted.push(self.ring.times_integer(&value, order));
        }
        series.plain.push(value);
    }

    fn zeroth(&self, place: usize) -> &R::Element {
        &self.places[place].plain[0]
    }

    fn value(&self, place: usize, inputs: &[R::Element]) -> Option<R::Element> {
        let ring = self.ring;
        match self.tape.operations()[place] {
            Operation::Input(number) => inputs.get(number).cloned(),
            Operation::Number(ref value) => ring.rational(value),
            Operation::Pi => ring.pi(),
            Operation::Negate(a) => Some(ring.negate(self.zeroth(a))),
            Operation::Add(a, b) => Some(ring.add(self.zeroth(a), self.zeroth(b))),
            Operation::Subtract(a, b) => Some(ring.subtract(self.zeroth(a), self.zeroth(b))),
            Operation::Multiply(a, b) => Some(ring.multiply(self.zeroth(a), self.zeroth(b))),
            Operation::Divide(a, b) => ring.divide(self.zeroth(a), self.zeroth(b)),
            Operation::Power(a, ref exponent) => ring.power(self.zeroth(a), exponent),
            Operation::Exp(a) => ring.value(Function::Exp, self.zeroth(a)),
            Operation::Abs(a) => ring.value(Function::Abs, self.zeroth(a)),
            Operation::Sign(a) => ring.value(Function::Sign, self.zeroth(a)),
            Operation::Paired { function, of, .. }
            | Operation::Tangent { function, of }
            | Operation::Inverse { function, of, .. } => ring.value(function, self.zeroth(of)),
        }
    }

    /// The next coefficient, those of the operands being known.
    fn coefficient(&self, place: usize, inputs: &[R::Element]) -> Option<R::Element> {
        let ring = self.ring;
        if self.tape.is_constant(place) {
            return Some(ring.zero());
        }
        let n = self.places[place].plain.len();
        let at = |place: usize| &self.places[place];
        let over_n = |weighted: R::Element| ring.over_integer(&weighted, u64::try_from(n).ok()?);
        match self.tape.operations()[place] {
            Operation::Input(number) => inputs.get(number).cloned(),
            Operation::Number(_) | Operation::Pi => Some(ring.zero()),
            Operation::Negate(a) => Some(ring.negate(&at(a).plain[n])),
            Operation::Add(a, b) => Some(ring.add(&at(a).plain[n], &at(b).plain[n])),
            Operation::Subtract(a, b) => Some(ring.subtract(&at(a).plain[n], &at(b).plain[n])),
            Operation::Multiply(a, b) if self.tape.is_constant(a) => {
                Some(ring.multiply(self.zeroth(a), &at(b).plain[n]))
            }
            Operation::Multiply(a, b) if self.tape.is_constant(b) => {
                Some(ring.multiply(&at(a).plain[n], self.zeroth(b)))
            }
            Operation::Multiply(a, b) => Some(ring.convolution(&at(a).plain[..=n], &at(b).plain[..=n])),
            Operation::Divide(a, b) => quotient(ring, &at(a).plain[n], &at(place).plain, &at(b).plain),
            // A whole power of what begins with zero begins beyond that power; other powers have no series there.
            Operation::Power(a, ref exponent) if ring.is_zero(self.zeroth(a)) => {
                let begins = exponent.to_natural()?;
                (u64::try_from(n).ok()? < begins).then(|| ring.zero())
            }
            Operation::Power(a, ref exponent) => {
                let exponent = ring.rational(exponent)?;
                let weighted = weighted_power(ring, &exponent, at(a).both(), at(place).both());
                over_n(ring.divide(&weighted, self.zeroth(a))?)
            }
            Operation::Exp(a) => over_n(weighted_integral(ring, &at(a).weighted[1..], &at(place).plain)),
            Operation::Paired { of, other, slope, .. } => {
                let weighted = weighted_integral(ring, &at(of).weighted[1..=n], &at(other).plain[..n]);
                over_n(if slope == Slope::Plus { weighted } else { ring.negate(&weighted) })
            }
            Operation::Tangent { function, of } => self.tangent(function, of, place).and_then(over_n),
            Operation::Inverse { of, divisor, .. } => {
                let weighted = &at(place).weighted[1..];
                let r = &at(divisor).plain[..n];
                over_n(weighted_integral_of_quotient(ring, &at(of).weighted[n], weighted, r)?)
            }
            Operation::Abs(a) => {
                let sign = ring.divide(self.zeroth(place), self.zeroth(a))?;
                Some(ring.multiply(&sign, &at(a).plain[n]))
            }
            // Constant on either side of zero, where it has no series.
            Operation::Sign(a) => (!ring.is_zero(self.zeroth(a))).then(|| ring.zero()),
        }
    }

    /// n·cₙ for c = tan a or tanh a: c′ = (1 ± c²)·a′, with c² in the next place.
    fn tangent(&self, function: Function, of: usize, place: usize) -> Option<R::Element> {
        let (ring, n) = (self.ring, self.places[place].plain.len());
        let inner = &self.places[of].weighted[1..];
        let driven = weighted_integral(ring, inner, &self.places[place + 1].plain[..n]);
        let own = inner.last()?;
        Some(if function == Function::Tan { ring.add(own, &driven) } else { ring.subtract(own, &driven) })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Expression, Symbol};
    use super::*;
    use crate::algebra::{Rational, Rationals};

    fn x() -> Expression {
        Expression::Symbol(Symbol { name: "x".to_owned(), primes: 0 })
    }

    fn call(function: Function, of: Expression) -> Expression {
        Expression::Call(function, Box::new(of))
    }

    fn number(value: &str) -> Box<Expression> {
        Box::new(Expression::Number(value.parse().unwrap()))
    }

    /// The Taylor coefficients of a formula of x at a place.
    fn taylor(formula: &Expression, at: i64, length: usize) -> Vec<String> {
        let tape = Tape::new(&[formula], &[Symbol { name: "x".to_owned(), primes: 0 }]).unwrap();
        let mut jet = Jet::new(&Rationals, &tape, &[Rational::from(at)]).unwrap();
        for n in 1..length {
            jet.extend(&[Rational::from(i64::from(n == 1))]).unwrap();
        }
        jet.result(0).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn elementary_functions_have_their_taylor_series() {
        let known: [(Function, i64, [&str; 6]); 13] = [
            (Function::Sin, 0, ["0", "1", "0", "-1/6", "0", "1/120"]),
            (Function::Cos, 0, ["1", "0", "-1/2", "0", "1/24", "0"]),
            (Function::Tan, 0, ["0", "1", "0", "1/3", "0", "2/15"]),
            (Function::Asin, 0, ["0", "1", "0", "1/6", "0", "3/40"]),
            (Function::Atan, 0, ["0", "1", "0", "-1/3", "0", "1/5"]),
            (Function::Sinh, 0, ["0", "1", "0", "1/6", "0", "1/120"]),
            (Function::Cosh, 0, ["1", "0", "1/2", "0", "1/24", "0"]),
            (Function::Tanh, 0, ["0", "1", "0", "-1/3", "0", "2/15"]),
            (Function::Exp, 0, ["1", "1", "1/2", "1/6", "1/24", "1/120"]),
            (Function::Ln, 1, ["0", "1", "-1/2", "1/3", "-1/4", "1/5"]),
            (Function::Sqrt, 4, ["2", "1/4", "-1/64", "1/512", "-5/16384", "7/131072"]),
            (Function::Abs, -3, ["3", "-1", "0", "0", "0", "0"]),
            (Function::Sign, -3, ["-1", "0", "0", "0", "0", "0"]),
        ];
        for (function, at, coefficients) in known {
            assert_eq!(taylor(&call(function, x()), at, 6), coefficients, "{function:?}");
        }
    }

    #[test]
    fn powers_and_quotients_agree_with_the_binomial_series() {
        let one_plus = || Box::new(Expression::Add(number("1"), Box::new(x())));
        let power = |exponent: &str| Expression::Power(one_plus(), number(exponent));
        assert_eq!(taylor(&power("-1"), 0, 5), ["1", "-1", "1", "-1", "1"]);
        assert_eq!(taylor(&power("5"), 0, 7), ["1", "5", "10", "10", "5", "1", "0"]);
        assert_eq!(taylor(&power("-3/2"), 0, 4), ["1", "-3/2", "15/8", "-35/16"]);
        let quotient = Expression::Divide(Box::new(x()), one_plus());
        assert_eq!(taylor(&quotient, 1, 4), ["1/2", "1/4", "-1/8", "1/16"]);
        // (1 + x)ˣ at zero, by exponential and logarithm.
        let tower = Expression::Power(one_plus(), Box::new(x()));
        assert_eq!(taylor(&tower, 0, 5), ["1", "0", "1", "-1/2", "5/6"]);
    }

    #[test]
    fn amending_a_coefficient_is_the_same_as_knowing_it_before() {
        let formula = Expression::Multiply(
            Box::new(call(Function::Sin, x())),
            Box::new(Expression::Divide(
                Box::new(call(Function::Exp, x())),
                Box::new(Expression::Power(
                    Box::new(Expression::Add(number("3"), Box::new(x()))),
                    number("2"),
                )),
            )),
        );
        let tape = Tape::new(&[&formula], &[Symbol { name: "x".to_owned(), primes: 0 }]).unwrap();
        let zero = [Rational::from(0)];
        let mut known = Jet::new(&Rationals, &tape, &zero).unwrap();
        let mut amended = Jet::new(&Rationals, &tape, &zero).unwrap();
        let gains = amended.gains(0).unwrap();
        for n in 1..8 {
            let value = Rational::new(n * n - 5, n).unwrap();
            known.extend(std::slice::from_ref(&value)).unwrap();
            amended.extend(&zero).unwrap();
            amended.amend(&gains, &value);
        }
        assert_eq!(known.result(0), amended.result(0));
    }
}
