//! The number of least periods of equations in the common period of their sines and cosines of the time.
//!
//! # Method
//! cos(ωt)² has the period π/ω, and cos(ωt)·cos(3ωt) as well. Whether the right-hand sides F repeat after the n-th part of the common
//! period T is tested by values of F(t) and F(t + T/n) in floats of [`BITS`] bits, for one prime factor of n after the other. Most differ already in
//! the few bits that are computed first.
//!
//! An analytic function that vanishes at generic places vanishes everywhere, unless its values drown in rounding. So that few
//! places suffice, F is replaced by a function of its sines and cosines that is rational and depends on them in the same way: each part
//! without the time is an independent number, and an even function of a part with the time is an even polynomial in it, an odd function an
//! odd polynomial, every other function a polynomial that is neither. This keeps windows in which |…| differs from its argument,
//! and narrow pulses. Identities between such functions, as of cosh² − sinh², are not used: the period found is then a multiple of the least one.

use super::structure::TIME;
use libration_numbers::algebra::{BigFloat, Floats, Function, Rational, Ring};
use libration_numbers::expression::{Equation, Expression, Symbol};
use libration_numbers::internals::expression::{Jet, Tape};

/// Bits of the values that are compared, one after the other.
const BITS: [usize; 2] = [96, 256];
/// Bits in which they need not agree, which leaves room for the rounding errors of 2⁵⁶ times the last place.
const ROUNDING: isize = 56;
/// Number of generic places: each excludes all but a set of measure zero of the functions that differ.
const PLACES: u32 = 3;
/// The prime factors that are tried.
const PRIMES: [i32; 11] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31];
/// The golden ratio less one: its multiples are evenly distributed and avoid symmetric positions.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The number of least periods in the common period 2πn/ω of the sines and cosines, as far as it is found; 1 for
/// equations whose values do not depend on the time.
pub(super) fn repetitions(equation: &Equation, frequency: &Expression, times: i32) -> i32 {
    let Some(trials) = RationalTrials::new(equation, frequency, times) else { return 1 };
    if trials.hold(|ring, period| Some(ring.multiply(period, &BigFloat::from_f64(GOLDEN, ring.precision)?))) {
        return 1;
    }
    let repeats = |n: i32| trials.hold(|ring, period| ring.over_integer(period, u64::try_from(n).ok()?));
    PRIMES.iter().fold(1, |mut repetitions_so_far, prime| {
        while repetitions_so_far <= i32::MAX / prime && repeats(repetitions_so_far * prime) {
            repetitions_so_far *= prime;
        }
        repetitions_so_far
    })
}

/// The rational functions in place of the right-hand sides, with ω as the first.
struct RationalTrials {
    tape: Tape,
    symbols: usize,
    times: i32,
}

impl RationalTrials {
    fn new(equation: &Equation, frequency: &Expression, times: i32) -> Option<Self> {
        let mut rest = vec![];
        let rates: Vec<Expression> =
            equation.derivatives().iter().map(|derivative| rational(derivative, false, &mut rest)).collect();
        let formulas: Vec<&Expression> = [frequency].into_iter().chain(&rates).collect();
        let time = Symbol::plain(TIME);
        let others = formulas.iter().flat_map(|formula| formula.symbols()).filter(|symbol| *symbol != time);
        let mut inputs: Vec<Symbol> = others.collect();
        inputs.sort();
        inputs.dedup();
        let symbols = inputs.len();
        inputs.push(time);
        Some(Self { tape: Tape::new(&formulas, &inputs).ok()?, symbols, times })
    }

    /// Returns `true` if the values repeat after a time, a function of the common period, at all places that have values, of which there must be one.
    fn hold(&self, shift: impl Fn(Floats, &BigFloat) -> Option<BigFloat>) -> bool {
        let holds = |sample: u32| {
            let mut outcomes = BITS.iter().map(|&precision| self.holds(Floats { precision }, sample, &shift));
            outcomes.find(|outcome| *outcome != Some(true)).unwrap_or(Some(true))
        };
        let mut outcomes = (0..PLACES).filter_map(holds).peekable();
        outcomes.peek().is_some() && outcomes.all(|outcome| outcome)
    }

    fn holds(
        &self,
        ring: Floats,
        number: u32,
        shift: impl Fn(Floats, &BigFloat) -> Option<BigFloat>,
    ) -> Option<bool> {
        let bits = ring.precision;
        let same = isize::try_from(bits).ok()? - ROUNDING;
        let drawn = |k: usize| {
            let part = (f64::from(number + 1) * GOLDEN + f64::from(u32::try_from(k).ok()?).sqrt()).fract();
            BigFloat::from_f64(0.25 + part, bits)
        };
        let mut inputs: Vec<BigFloat> = (2..self.symbols + 2).map(drawn).collect::<Option<_>>()?;
        inputs.push(drawn(1)?);
        let (values, _) = self.values(ring, &inputs)?;
        let turn = ring.times_integer(&BigFloat::pi(bits), 2 * i64::from(self.times));
        let period = ring.divide(&turn, &values[0])?;
        let time = inputs.pop()?;
        inputs.push(ring.add(&time, &shift(ring, &period)?));
        let (later, largest) = self.values(ring, &inputs)?;
        let differs = |(a, b): (&BigFloat, &BigFloat)| {
            ring.subtract(a, b).exponent().is_some_and(|exponent| exponent > largest - same)
        };
        Some(!values.iter().zip(&later).any(differs))
    }

    /// The values of the functions, and the largest exponent of two on the tape.
    fn values(&self, ring: Floats, inputs: &[BigFloat]) -> Option<(Vec<BigFloat>, isize)> {
        let jet = Jet::new(&ring, &self.tape, inputs).ok()?;
        let largest = jet.values().filter_map(BigFloat::exponent).max().unwrap_or(0);
        let formulas = 0..self.tape.results().len();
        Some((formulas.map(|formula| jet.result(formula)[0].clone()).collect(), largest))
    }
}

/// A rational function in place of a formula (module documentation). `rest` are the parts without the time, by the number in their new
/// names; `inside` the argument of a sine or cosine of the time they stay as they are.
fn rational(formula: &Expression, inside: bool, rest: &mut Vec<Expression>) -> Expression {
    let time = Symbol::plain(TIME);
    if !formula.contains(&time) {
        let stays = formula.symbols().is_empty() || inside;
        return if stays { formula.clone() } else { independent(formula, rest) };
    }
    match formula {
        Expression::Call(Function::Sin | Function::Cos, argument) => {
            let is_wave = !argument.derivative(&time).contains(&time);
            formula.with_parts(|part| rational(part, is_wave, rest))
        }
        Expression::Call(function, argument) => {
            let powers = match function {
                Function::Abs | Function::Cosh => [2, 4],
                Function::Sign | Function::Tan | Function::Asin | Function::Atan => [1, 3],
                Function::Sinh | Function::Tanh => [1, 3],
                _ => [2, 3],
            };
            polynomial(&rational(argument, inside, rest), powers)
        }
        Expression::Power(base, exponent) => {
            let base = rational(base, inside, rest);
            match exponent.to_rational().filter(Rational::is_integer) {
                Some(number) if [2, 3, 4].iter().any(|integer| number == Rational::from(*integer)) => {
                    Expression::Power(Box::new(base), exponent.clone())
                }
                Some(number) => polynomial(&base, if is_even(&number) { [2, 4] } else { [1, 3] }),
                None => polynomial(&base, [2, 3]),
            }
        }
        _ => formula.with_parts(|part| rational(part, inside, rest)),
    }
}

fn is_even(number: &Rational) -> bool {
    number.checked_div(&Rational::from(2)).is_some_and(|half| half.is_integer())
}

/// The symbol for a part without the time.
fn independent(part: &Expression, rest: &mut Vec<Expression>) -> Expression {
    let number = rest.iter().position(|other| other == part).unwrap_or_else(|| {
        rest.push(part.clone());
        rest.len() - 1
    });
    Expression::symbol(&format!("part {number}"))
}

/// aᵐ + aⁿ/3.
fn polynomial(a: &Expression, [m, n]: [i64; 2]) -> Expression {
    let power = |n: i64| Box::new(Expression::Power(Box::new(a.clone()), Box::new(n.into())));
    let third = Expression::Divide(power(n), Box::new(3.into()));
    Expression::Add(power(m), Box::new(third))
}
