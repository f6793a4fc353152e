//! The comparison of an answer with the result of an exercise.

use super::super::evaluate::{Values, evaluate};
use super::super::formula::{DecimalUnit, Formula, Name, number, rounded, sum};
use super::super::numbers::{DIGITS, PRECISION};
use super::super::prose::Prose;
use super::super::typeset::formula_latex;
use super::terms::{Term, Terms, as_in, coefficient, is_multiple, terms};
use super::{Judgement, Question, Symbols, key};
use libration::algebra::{BigFloat, Function, Rational, Ring};
use std::cell::RefCell;

/// Bits in which equal formulas agree, half of those of [`PRECISION`]: cancellations of a sum lose up to as many bits as its terms exceed it.
const CLOSE: isize = 130;
/// Draws at which two formulas are compared, and the largest number of those tried.
const DRAWS: usize = 3;
const MOST_DRAWS: u64 = 60;
/// Number of terms named in a sentence.
const NAMED: usize = 4;
/// Number of digits of a value in a sentence.
const SHOWN: usize = 5;

/// An answer and the exercise.
pub(super) struct Comparison<'a> {
    pub(super) question: Question<'a>,
    pub(super) formula: Formula,
    pub(super) symbols: &'a Symbols,
    /// Symbols with formulas for them, in order.
    pub(super) established: Vec<(&'a Name, Formula)>,
}

/// The answer and the result at a draw.
pub(super) struct Sample {
    /// The values of the symbols, in their order.
    draw: Vec<BigFloat>,
    answer: BigFloat,
    result: BigFloat,
}

impl Comparison<'_> {
    /// Values at draws where both formulas have one.
    pub(super) fn samples(&self) -> Vec<Sample> {
        (0..MOST_DRAWS).filter_map(|n| self.sample(n)).take(DRAWS).collect()
    }

    /// Values at the draw with this number, where both formulas have one.
    fn sample(&self, number: u64) -> Option<Sample> {
        // Hundredths from 0.10 to 0.89 by the congruences of Knuth's MMIX.
        let mut state = number;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let hundredths = Rational::new(10 + (state >> 33).cast_signed() % 80, 100)?;
            Some(BigFloat::from_rational(&hundredths, PRECISION))
        };
        let mut values = Values::default();
        let mut draw = vec![];
        for (_, name) in self.symbols {
            let value = next()?;
            values.set(name, value.clone());
            draw.push(value);
        }
        for (name, formula) in &self.established {
            let wanted = key(name);
            let index = self.symbols.iter().position(|(key, _)| *key == wanted)?;
            if let Ok(value) = evaluate(&without_order(formula), &DIGITS, &values) {
                values.set(name, value.clone());
                draw[index] = value;
            }
        }
        let result = evaluate(&without_order(self.question.result), &DIGITS, &values).ok()?;
        for name in self.formula.free_names() {
            let wanted = key(&name);
            let index = self.symbols.iter().position(|(key, _)| *key == wanted)?;
            values.set(&name, draw[index].clone());
        }
        let answer =
            evaluate(&self.formula, &DIGITS, &values).ok().filter(|value| value.to_f64().is_finite())?;
        Some(Sample { draw, answer, result })
    }

    /// The judgement from samples, one at least.
    pub(super) fn judge(&self, samples: &[Sample]) -> Judgement {
        let Question { is_zero, result, .. } = self.question;
        let atoms = Atoms { waves: has_wave_power(result), formulas: RefCell::default() };
        let [of_result, of_answer] =
            [result, &self.formula].map(|side| terms(side, &|part| atoms.number(part)));
        let is_right = match (is_zero, &of_answer, &of_result) {
            (false, ..) => samples.iter().all(|sample| are_close(&sample.answer, &sample.result)),
            (true, Some(given), Some(expected)) => is_multiple(given, expected),
            (true, ..) => is_constant_factor(samples),
        };
        if is_right {
            let is_long = 5 * operations(&self.formula) > 6 * operations(result) + 5;
            let is_product = has_wave_power(&self.formula) && !has_wave_power(result);
            let is_simplified = !(self.is_asked() || is_long || is_product);
            return if is_simplified { Judgement::Right } else { Judgement::NotSimplified };
        }
        if self.is_asked() {
            return Judgement::NotSimplified;
        }
        let reason = of_answer.zip(of_result).and_then(|(given, expected)| {
            let comparable = if is_zero { as_in(&given, &expected) } else { given };
            wrong_terms(&comparable, &expected, &atoms)
        });
        Judgement::Wrong(reason.unwrap_or_else(|| self.values(&samples[0])))
    }

    /// Returns `true` if the answer is the formula whose value is to be found.
    fn is_asked(&self) -> bool {
        let Question { asked, result, .. } = self.question;
        let written = formula_latex(&self.formula);
        asked.is_some_and(|asked| {
            formula_latex(asked) == written && formula_latex(&without_order(result)) != written
        })
    }

    /// The values of both at a draw.
    fn values(&self, sample: &Sample) -> Prose {
        let decimal = |value: &BigFloat| Prose::formula(rounded(value.to_f64(), SHOWN, DecimalUnit::One));
        let mut names = self.formula.free_names();
        names.extend(self.question.result.free_names());
        let keys: Vec<String> = names.iter().map(key).collect();
        let given = self.symbols.iter().zip(&sample.draw).filter(|((key, _), _)| keys.contains(key));
        let given = given.map(|((_, name), value)| {
            Prose::formula(name.into()).and(Prose::text(" = ")).and(decimal(value))
        });
        let given = given.reduce(|text, next| text.and(Prose::text(", ")).and(next));
        let given = given
            .map_or_else(|| Prose::text(""), |given| Prose::text("with ").and(given).and(Prose::text(" ")));
        given
            .and(Prose::text("it is "))
            .and(decimal(&sample.answer))
            .and(Prose::text(", not "))
            .and(decimal(&sample.result))
    }
}

/// The terms that differ; `None` if there are none.
fn wrong_terms(given: &Terms, expected: &Terms, atoms: &Atoms) -> Option<Prose> {
    let symbol = |number: usize| {
        atoms.formulas.borrow().get(number).map_or(Formula::Pi, |(_, formula)| formula.clone())
    };
    let sentence = |term: &Term| {
        let [before, after] = match (coefficient(given, term), coefficient(expected, term)) {
            (Some(one), Some(other)) if one == other => return None,
            (Some(_), Some(_)) => ["the term in ", " has another coefficient"],
            (Some(_), None) => ["there is no term in ", ""],
            (None, _) => ["a term in ", " is missing"],
        };
        Some(match term.to_formula(&symbol) {
            Some(product) => Prose::text(before).and(Prose::formula(product)).and(Prose::text(after)),
            None => Prose::text(before.replace(" in ", " without symbols")).and(Prose::text(after)),
        })
    };
    let added = given.iter().filter(|(term, _)| coefficient(expected, term).is_none());
    let mut sentences: Vec<Prose> =
        expected.iter().chain(added).filter_map(|(term, _)| sentence(term)).collect();
    let more = sentences.len().saturating_sub(NAMED);
    sentences.truncate(NAMED);
    if more > 0 {
        sentences.push(Prose::text(format!("{more} more differ")));
    }
    sentences.into_iter().reduce(|text, next| text.and(Prose::text("; ")).and(next))
}

/// Parts of formulas that are treated as symbols: names, π, and, where powers of them are in the result, sines and cosines.
struct Atoms {
    waves: bool,
    formulas: RefCell<Vec<(String, Formula)>>,
}

impl Atoms {
    fn number(&self, formula: &Formula) -> Option<usize> {
        let key = match formula {
            Formula::Name(name) => key(name),
            Formula::Pi => "π".to_owned(),
            Formula::Call(Function::Sin | Function::Cos, _) if self.waves => formula_latex(formula),
            _ => return None,
        };
        let mut formulas = self.formulas.borrow_mut();
        let index = formulas.iter().position(|(other, _)| *other == key);
        if index.is_none() {
            formulas.push((key, formula.clone()));
        }
        Some(index.unwrap_or(formulas.len() - 1))
    }
}

fn are_close(a: &BigFloat, b: &BigFloat) -> bool {
    let size = a.exponent().max(b.exponent());
    match ((a.clone() - b.clone()).exponent(), size) {
        (None, _) => true,
        (Some(difference), Some(size)) => difference + CLOSE <= size,
        (Some(_), None) => false,
    }
}

/// Returns `true` if the answer is the result times a number.
fn is_constant_factor(samples: &[Sample]) -> bool {
    let ratios: Option<Vec<BigFloat>> =
        samples.iter().map(|sample| DIGITS.divide(&sample.answer, &sample.result)).collect();
    let Some(ratios) = ratios else { return false };
    ratios.windows(2).all(|pair| are_close(&pair[0], &pair[1])) && ratios.iter().all(|ratio| !ratio.is_zero())
}

/// The formula without O(…).
fn without_order(formula: &Formula) -> Formula {
    let each = |parts: &[Formula]| parts.iter().map(without_order).collect();
    match formula {
        Formula::Order(_) => number(0),
        Formula::Sum(parts) => {
            let is_kept = |part: &&Formula| !matches!(part, Formula::Order(_));
            sum(parts.iter().filter(is_kept).map(without_order).collect())
        }
        Formula::Product(parts) => Formula::Product(each(parts)),
        Formula::Fraction(over, under) => without_order(over) / without_order(under),
        other => other.clone(),
    }
}

/// Number of operations in a formula; a fraction of numbers and a sign before it are one each.
fn operations(formula: &Formula) -> usize {
    let count = match formula {
        Formula::Order(_) => return 0,
        Formula::Number(value) => usize::from(!value.is_integer()) + usize::from(value.is_negative()),
        Formula::Sum(parts) => {
            // A difference is one operation.
            let is_minus = |part: &&Formula| {
                matches!(part, Formula::Negate(_))
                    || matches!(part, Formula::Number(value) if value.is_negative())
            };
            parts.len().saturating_sub(1 + parts.iter().skip(1).filter(is_minus).count())
        }
        Formula::Product(parts) => parts.len().saturating_sub(1),
        Formula::Decimal(_) | Formula::Pi | Formula::Name(_) => 0,
        _ => 1,
    };
    count + formula.parts().into_iter().map(operations).sum::<usize>()
}

/// Returns `true` if a formula has powers of sines or cosines.
fn has_wave_power(formula: &Formula) -> bool {
    let is_wave = |formula: &Formula| matches!(formula, Formula::Call(Function::Sin | Function::Cos, _));
    matches!(formula, Formula::Power(base, _) if is_wave(base))
        || formula.parts().into_iter().any(has_wave_power)
}
