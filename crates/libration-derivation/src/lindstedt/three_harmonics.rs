//! Three harmonics as algebra: the equations, and why the method ends there.

use super::super::check::{
    Check, CheckedEquation, DerivationError, TruncatedClaim, TruncatedFormula, failed,
};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Statement, number};
use super::names::{cosine, harmonic_name};
use super::orders::{CHOICES, fraction_for};
use super::question::LindstedtQuestion;
use super::truncated::{harmonic, in_ratio, ratio};
use libration::algebra::{Polynomial, Rational, Variable};
use libration::perturbation::TruncatedSystem;

const HARMONICS: [usize; 3] = [1, 3, 5];
/// The last power of the force that is kept.
const DEGREE: usize = 5;

/// Appends the equations to those for two harmonics; unchanged if these do not exist.
pub(super) fn after(
    question: &LindstedtQuestion,
    step: DerivationStep,
) -> Result<DerivationStep, DerivationError> {
    let count = u32::try_from(HARMONICS.len()).unwrap_or(u32::MAX);
    let Ok(system) = TruncatedSystem::new(&question.force, count, DEGREE) else { return Ok(step) };
    let conditions = system.conditions();
    check(question, &conditions)?;
    let solutions = i64::try_from(system.number_of_solutions()).unwrap_or(i64::MAX);
    let force: Vec<Rational> = question.force.iter().take(DEGREE).cloned().collect();
    let equations = conditions.iter().zip(HARMONICS).map(|(condition, harmonic)| {
        let claim = TruncatedClaim::Condition { harmonic, over_first: false };
        let formula = TruncatedFormula { force: force.clone(), harmonics: HARMONICS.to_vec(), claim };
        let statement = Statement::equal(in_ratio(condition), 0);
        CheckedEquation::new(statement, Check::Truncated(Box::new(formula)))
    });
    let equations: Vec<CheckedEquation> = equations.collect();
    let step = step.say(
        "With {} too, and the force to its power {}, there are four equations for four unknowns, and {} solutions. Their elimination is \
         no longer done by hand, while the series needs one more division for each further coefficient.",
        [harmonic_name(5).into(), number(i64::try_from(DEGREE).unwrap_or(i64::MAX)), number(solutions)],
    );
    Ok(step.fold("The equations for three harmonics", |step| {
        let step = step.say("The factors of {}, {} and {}, in whole numbers:", HARMONICS.map(cosine));
        step.show_all(equations)
    }))
}

/// Substitutes fractions for the symbols in the equation of motion, and compares the factors of its cosines with the conditions.
pub fn check(question: &LindstedtQuestion, conditions: &[Polynomial]) -> Result<(), DerivationError> {
    for choice in 0..CHOICES {
        let value = |name: &Variable| Some(fraction_for(name, choice));
        let amplitudes = HARMONICS.map(|k| fraction_for(&harmonic(k), choice));
        let ratio_value = fraction_for(&ratio(), choice);
        let left = left_in_cosines(question, &amplitudes, &(ratio_value.clone() * ratio_value));
        for (condition, (k, amplitude)) in conditions.iter().zip(HARMONICS.iter().zip(&amplitudes)) {
            // The term k²Δ²aₖ shows the factor by which the condition was multiplied.
            let inertia = condition.coefficient(&ratio(), 2).value(value);
            let square = Rational::from(i64::try_from(k * k).unwrap_or(i64::MAX)) * amplitude.clone();
            let unit = inertia.and_then(|inertia| inertia.checked_div(&square));
            let expected = unit.map(|unit| -(unit * left[*k].clone()));
            if expected.is_none() || condition.value(value) != expected {
                let statement = Statement::equal(Formula::from(condition), 0);
                return Err(failed(&statement, "the equation of motion leaves something else".to_owned()));
            }
        }
    }
    Ok(())
}

/// Δ²u″ + u + …, up to the last power, as the factors of the cosines.
fn left_in_cosines(
    question: &LindstedtQuestion,
    amplitudes: &[Rational; 3],
    ratio_squared: &Rational,
) -> Vec<Rational> {
    let highest = DEGREE * HARMONICS[2];
    let mut displacement = vec![Rational::from(0); highest + 1];
    for (k, amplitude) in HARMONICS.iter().zip(amplitudes) {
        displacement[*k] = amplitude.clone();
    }
    let mut left: Vec<Rational> = (0_i64..)
        .zip(&displacement)
        .map(|(k, amplitude)| -(Rational::from(k * k) * ratio_squared.clone() * amplitude.clone()))
        .collect();
    let mut power = displacement.clone();
    for (exponent, factor) in question.force.iter().take(DEGREE).enumerate() {
        if exponent > 0 {
            power = product(&power, &displacement);
        }
        for (left, term) in left.iter_mut().zip(&power) {
            *left = left.clone() + factor.clone() * term.clone();
        }
    }
    left
}

/// The product of two sums of cosines.
fn product(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    let half = Rational::new(1, 2).unwrap_or_else(|| Rational::from(0));
    let mut sum = vec![Rational::from(0); a.len()];
    for (j, left) in a.iter().enumerate().filter(|(_, value)| !value.is_zero()) {
        for (k, right) in b.iter().enumerate().filter(|(_, value)| !value.is_zero()) {
            let each = half.clone() * left.clone() * right.clone();
            for harmonic in [j.abs_diff(k), j + k] {
                if let Some(sum) = sum.get_mut(harmonic) {
                    *sum = sum.clone() + each.clone();
                }
            }
        }
    }
    sum
}
