//! Phase functions and their numbers as formulas.

use super::super::formula::{Coefficient, Formula, cos, letter, sin, sum};
use super::{PhaseFunction, PiNumber, Wave};
use libration::algebra::Rational;

/// A number as a formula.
pub fn number(value: &PiNumber) -> Formula {
    let terms: Vec<Formula> =
        value.terms().map(|(power, coefficient)| term_with(coefficient, power, vec![])).collect();
    if terms.is_empty() { Formula::from(0) } else { sum(terms) }
}

impl Coefficient for PiNumber {
    fn is_absent(&self) -> bool {
        self.is_zero()
    }

    fn to_formula(&self) -> Formula {
        number(self)
    }

    fn times(&self, formula: Formula) -> Formula {
        let mut terms = self.terms();
        match (terms.next(), terms.next()) {
            (Some((power, factor)), None) => term_with(factor, power, vec![formula]),
            _ => number(self) * formula,
        }
    }
}

/// A phase function as a sum, lower powers of the phase and lower harmonics first.
pub fn series(function: &PhaseFunction, phase: &str) -> Formula {
    let of_key = |((power, k, wave), value): ((usize, usize, Wave), &PiNumber)| {
        let factors = factors(phase, power, k, wave);
        let terms = value.terms().map(|(pi, coefficient)| term_with(coefficient, pi, factors.clone()));
        terms.collect::<Vec<Formula>>()
    };
    let terms: Vec<Formula> = function.terms().flat_map(of_key).collect();
    if terms.is_empty() { Formula::from(0) } else { sum(terms) }
}

fn factors(phase: &str, power: usize, k: usize, wave: Wave) -> Vec<Formula> {
    let whole = |n: usize| i64::try_from(n).unwrap_or(i64::MAX);
    let powers = match power {
        0 => None,
        1 => Some(letter(phase)),
        n => Some(letter(phase).pow(whole(n))),
    };
    let angle = if k == 1 { letter(phase) } else { Formula::from(whole(k)) * letter(phase) };
    let harmonic = match (k, wave) {
        (0, _) => None,
        (_, Wave::Cosine) => Some(cos(angle)),
        (_, Wave::Sine) => Some(sin(angle)),
    };
    powers.into_iter().chain(harmonic).collect()
}

/// coefficient·πᵉ·factors, without factors of one; with π in the denominator all factors are in one fraction.
pub(crate) fn term_with(coefficient: &Rational, power_of_pi: i32, factors: Vec<Formula>) -> Formula {
    let pi = |power: i32| match power {
        1 => Formula::Pi,
        power => Formula::Pi.pow(i64::from(power)),
    };
    let size = coefficient.magnitude();
    let one = Rational::from(1);
    let term = if power_of_pi < 0 {
        let [over, under] = [size.numerator(), size.denominator()]
            .map(|digits| digits.parse::<Rational>().unwrap_or_else(|_| Rational::from(0)));
        let over = Some(over).filter(|number| *number != one || factors.is_empty());
        let over = over.into_iter().map(Formula::from).chain(factors);
        let under = Some(under).filter(|number| *number != one).into_iter().map(Formula::from);
        product(over.collect()) / product(under.chain([pi(-power_of_pi)]).collect())
    } else {
        let pi = (power_of_pi > 0).then(|| pi(power_of_pi));
        let rest: Vec<Formula> = pi.into_iter().chain(factors).collect();
        let size = Some(size).filter(|number| *number != one || rest.is_empty());
        product(size.into_iter().map(Formula::from).chain(rest).collect())
    };
    if coefficient.is_negative() { negative(term) } else { term }
}

/// The negative of a positive term; a leading number takes the sign.
fn negative(term: Formula) -> Formula {
    match term {
        Formula::Number(_) | Formula::Product(_) => match term.clone().negated() {
            Formula::Negate(_) => -term,
            signed => signed,
        },
        term => -term,
    }
}

fn product(mut factors: Vec<Formula>) -> Formula {
    if factors.len() == 1 { factors.remove(0) } else { Formula::Product(factors) }
}
