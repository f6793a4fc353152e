//! Two harmonics and the cube of the displacement as algebra: three equations for three
//! unknowns, solved by elimination, and the identification of the solution that is the motion.

use super::super::check::{
    Check, CheckedEquation, DerivationError, Given, TruncatedClaim, TruncatedFormula, failed,
    same_series_where,
};
use super::super::document::{Cells, DerivationStep, DerivationTable};
use super::super::formula::{Formula, Name, Statement, letter, monomial, number, order, sqrt, sum, tenths};
use super::super::prose::Prose;
use super::super::trials::Trials;
use super::amplitude::of_amplitude;
use super::few_harmonics::{DEGREE, HARMONICS};
use super::names::{cosine, harmonic_name};
use super::question::LindstedtQuestion;
use libration::algebra::{Polynomial, Rational, Variable};
use libration::perturbation::TruncatedSystem;

/// The conditions and their elimination, polynomials in a₁, a₃ and Δ.
#[derive(Debug)]
pub struct Elimination {
    /// The factor of u³.
    cube: Rational,
    /// The factors of cos τ, divided by a₁, and of cos 3τ.
    pub conditions: [Polynomial; 2],
    /// Δ² from the first condition.
    pub ratio_squared: Polynomial,
    /// The second condition with Δ² from the first condition.
    pub left: Polynomial,
}

/// The step; `None` for a force without a cube, or one that is not odd.
pub(super) fn step(question: &LindstedtQuestion) -> Result<Option<DerivationStep>, DerivationError> {
    let Some(elimination) = Elimination::new(question) else { return Ok(None) };
    elimination.check()?;
    let Elimination { cube, conditions, ratio_squared, left } = &elimination;
    let force = question.u() + monomial(cube, &question.u(), DEGREE);
    let step = DerivationStep::new("two-harmonics-algebra", "Two harmonics by hand")
        .say(
            "There is a shorter way to the first terms: to keep two harmonics alone, and of the force {}. The cube of the two is a sum of \
             cosines again, with the factors",
            [force],
        )
        .table(cube_of_two()?)
        .say(
            "So the equation of motion leaves the factors of {}, which can be divided by {}, and of {}. They must vanish:",
            [cosine(1), a(1), cosine(3)],
        )
        .show(elimination.checked(Statement::equal(in_ratio(&conditions[0]), 0), condition(1, true)))
        .show(elimination.checked(Statement::equal(in_ratio(&conditions[1]), 0), condition(3, false)))
        .say("The harmonics above are left out. Both together make up the largest displacement,", [])
        .show(CheckedEquation::premise(Statement::equal(question.amplitude(), a(1) + a(3))))
        .say("The first condition gives the frequency,", [])
        .show(elimination.checked(
            Statement::equal(letter("Δ").squared(), ratio_squared),
            TruncatedClaim::SquaredRatio,
        ))
        .say("and the second with that is one for the harmonics alone:", [])
        .show(elimination.checked(Statement::equal(left, 0), TruncatedClaim::Eliminated));
    let step = small_swing(question, &elimination, step)?;
    Ok(Some(others(&elimination, step)))
}

/// The solution that begins as the small swing, up to the cube of the amplitude.
fn small_swing(
    question: &LindstedtQuestion,
    elimination: &Elimination,
    step: DerivationStep,
) -> Result<DerivationStep, DerivationError> {
    let amplitude = Formula::from(question.amplitude());
    let exact = of_amplitude(question, &question.solution)?;
    let third = elimination.cubic_term().unwrap_or_else(|| Rational::from(0));
    let series = exact.harmonics.iter().find(|(k, _)| *k == 3).and_then(|(_, series)| series.get(3));
    if question.order >= 3 && series != Some(&Polynomial::constant(third.clone())) {
        let statement = Statement::equal(a(3), monomial(&third, &amplitude, 3));
        return Err(failed(&statement, "the series has another term".to_owned()));
    }
    let frequency = exact.frequency_ratio.get(2).cloned().unwrap_or_else(Polynomial::zero);
    let next = |n: i64| order(amplitude.clone().pow(n));
    let of_first = vec![amplitude.clone(), monomial(&-third.clone(), &amplitude, 3)];
    let of_third = monomial(&third, &amplitude, 3);
    let ratio = sqrt(&elimination.ratio_squared);
    let given = [
        Given::Value(harmonic_name(1), sum(of_first.clone())),
        Given::Value(harmonic_name(3), of_third.clone()),
        Given::Value(Name::new("Δ"), ratio.clone()),
    ];
    let put_in = Statement::equal(&elimination.left, next(5));
    let expanded = sum(vec![number(1), monomial(&frequency, &amplitude, 2), next(4)]);
    let expanded = Statement::equal(letter("Δ"), ratio).and_equal(expanded);
    let variable = question.amplitude();
    same_series_where(&variable, 5, &given, put_in)?;
    Ok(step
        .say(
            "In a small swing {} is much smaller than {}. Then the term with {} alone and the cube of {} are the largest, and in the cube \
             {} may stand for {}:",
            [a(3), a(1), a(3), a(1), amplitude.clone(), a(1)],
        )
        .show(elimination.in_amplitude(question, 3, vec![of_third, next(5)]))
        .show(elimination.in_amplitude(question, 1, [of_first, vec![next(5)]].concat()))
        .say("and the frequency is", [])
        .show(same_series_where(&variable, 4, &given, expanded)?)
        .say(
            "These are the first terms of the series found above. The next ones would not be, because the harmonic {} has its part in them, \
             and the next power of the force where there is one.",
            [cosine(5)],
        ))
}

/// The other solutions: their values at zero amplitude.
fn others(elimination: &Elimination, step: DerivationStep) -> DerivationStep {
    let third = harmonic(3);
    let opposite = Polynomial::variable(third.clone()).scaled(&Rational::from(-1));
    let at_zero = elimination.left.substitute(&harmonic(1), &opposite);
    let cubed = at_zero.coefficient(&third, 3).to_constant();
    let linear = at_zero.coefficient(&third, 1).to_constant();
    let step = step.say(
        "But the equations have three more solutions. One was lost when the factor of {} was divided by {}: {} alone, the same motion \
         again with three of its periods taken for one. The others are seen where the amplitude is zero, {} the opposite of {}:",
        [cosine(1), a(1), a(3), a(1), a(3)],
    );
    let step = step.show(elimination.checked(Statement::equal(&at_zero, 0), TruncatedClaim::AtZero));
    let is_real = linear.zip(cubed).is_some_and(|(linear, cubed)| {
        let zero = Rational::from(0);
        (linear < zero) != (cubed < zero)
    });
    match is_real {
        true => step.say(
            "Besides {} = 0 this has two solutions, real ones: two large harmonics that cancel at the turning point. They satisfy the three \
             equations and are not motions of the oscillator: the harmonics left out are as large.",
            [a(3)],
        ),
        false => step.say("Besides {} = 0 this has two solutions, which are not real.", [a(3)]),
    }
}

impl Elimination {
    /// Eliminates, unless the force has even powers or no cubic one.
    pub fn new(question: &LindstedtQuestion) -> Option<Self> {
        let cube = question.force.get(DEGREE - 1).filter(|cube| !cube.is_zero())?.clone();
        let system = TruncatedSystem::new(&question.force, HARMONICS, DEGREE).ok()?;
        let conditions = <[Polynomial; 2]>::try_from(system.conditions()).ok()?;
        let inertia = conditions[0].coefficient(&ratio(), 2).to_constant()?;
        let ratio_squared =
            conditions[0].coefficient(&ratio(), 0).scaled(&Rational::from(-1).checked_div(&inertia)?);
        let left = at_ratio(&conditions[1], &ratio_squared).primitive();
        Some(Self { cube, conditions, ratio_squared, left })
    }

    /// Compares the polynomials with the equation of motion after substitution of the printed cube of the two harmonics.
    pub fn check(&self) -> Result<(), DerivationError> {
        let minus = Rational::from(-1);
        let left: Vec<Polynomial> = factors(&self.cube).iter().map(|factor| factor.scaled(&minus)).collect();
        let solved = at_ratio(&left[0], &self.ratio_squared).is_zero();
        let rest = at_ratio(&left[1], &self.ratio_squared).primitive();
        let same = left.iter().zip(&self.conditions).all(|(left, condition)| left.primitive() == *condition);
        if same && solved && rest == self.left {
            return Ok(());
        }
        let statement = Statement::equal(&self.left, 0);
        Err(failed(&statement, "the equation of motion leaves something else".to_owned()))
    }

    fn checked(&self, statement: Statement, claim: TruncatedClaim) -> CheckedEquation {
        let force = vec![Rational::from(1), Rational::from(0), self.cube.clone()];
        let formula = TruncatedFormula { force, harmonics: vec![1, 3], claim };
        CheckedEquation::new(statement, Check::Truncated(Box::new(formula)))
    }

    /// A harmonic as a series in the amplitude.
    fn in_amplitude(
        &self,
        question: &LindstedtQuestion,
        harmonic: usize,
        terms: Vec<Formula>,
    ) -> CheckedEquation {
        let claim = TruncatedClaim::Series { amplitude: question.amplitude(), harmonic };
        self.checked(Statement::equal(a(harmonic), sum(terms)), claim)
    }

    /// The factor of A³ in a₃.
    fn cubic_term(&self) -> Option<Rational> {
        let first = self.left.coefficient(&harmonic(1), 3).to_constant()?;
        let third = self.left.coefficient(&harmonic(1), 0).coefficient(&harmonic(3), 1).to_constant()?;
        (-first).checked_div(&third)
    }
}

/// (a₁ cos τ + a₃ cos 3τ)³ as a sum of cosines: for each k the factors of a₁³, a₁²a₃, a₁a₃² and a₃³.
const CUBE: [(usize, [[i64; 2]; 4]); 5] = [
    (1, [[3, 4], [3, 4], [3, 2], [0, 1]]),
    (3, [[1, 4], [3, 2], [0, 1], [3, 4]]),
    (5, [[0, 1], [3, 4], [3, 4], [0, 1]]),
    (7, [[0, 1], [0, 1], [3, 4], [0, 1]]),
    (9, [[0, 1], [0, 1], [0, 1], [1, 4]]),
];

/// The factor of cos kτ in the cube.
fn in_cube(factors: [[i64; 2]; 4]) -> Polynomial {
    let [first, third] = [1, 3].map(|k| Polynomial::variable(harmonic(k)));
    let powers = (0..).zip(factors).map(|(n, [numerator, denominator])| {
        let factor = Rational::new(numerator, denominator).unwrap_or_else(|| Rational::from(0));
        (first.pow(3 - n) * third.pow(n)).scaled(&factor)
    });
    powers.fold(Polynomial::zero(), |sum, term| sum + term)
}

/// The factors of the cosines in the cube of two, checked against their sum.
fn cube_of_two() -> Result<DerivationTable, DerivationError> {
    let trials = Trials::new(None)?
        .with(&Name::new("τ"), tenths(7))?
        .with(&harmonic_name(1), tenths(13))?
        .with(&harmonic_name(3), tenths(-3))?;
    let terms = CUBE.map(|(k, factors)| (cosine(k), Formula::from(&in_cube(factors))));
    let cosines = terms.clone().map(|(cosine, factor)| factor * cosine);
    trials.compare_once(Statement::equal(two().pow(3), sum(cosines.to_vec())))?;
    Ok(DerivationTable {
        cells: Cells::Formulas,
        head: vec![Prose::text("cosine"), Prose::new("its factor in {}", [two().pow(3)])],
        rows: terms.map(|(cosine, factor)| vec![Prose::formula(cosine), Prose::formula(factor)]).to_vec(),
        note: Prose::text("checked: their sum is the cube, in 77 digits"),
    })
}

fn two() -> Formula {
    a(1) * cosine(1) + a(3) * cosine(3)
}

/// The factors of cos τ, over a₁, and of cos 3τ in Δ²u″ + u + cu³.
fn factors(cube: &Rational) -> [Polynomial; 2] {
    let first = Polynomial::variable(harmonic(1));
    let squared = Polynomial::variable(ratio()).pow(2);
    let factor = |k: usize, square: i64| {
        let inertia = Polynomial::constant(Rational::from(1)) + squared.scaled(&Rational::from(-square));
        let cubed =
            CUBE.iter().find(|entry| entry.0 == k).map_or_else(Polynomial::zero, |entry| in_cube(entry.1));
        inertia * Polynomial::variable(harmonic(k)) + cubed.scaled(cube)
    };
    [factor(1, 1).divide_exactly(&first).unwrap_or_else(Polynomial::zero), factor(3, 9)]
}

/// A polynomial in Δ² with this value substituted.
fn at_ratio(polynomial: &Polynomial, ratio_squared: &Polynomial) -> Polynomial {
    polynomial.coefficient(&ratio(), 0) + polynomial.coefficient(&ratio(), 2) * ratio_squared.clone()
}

/// A condition in printed form, with Δ² as a separate factor.
pub(super) fn in_ratio(condition: &Polynomial) -> Formula {
    let squared = Formula::from(&condition.coefficient(&ratio(), 2)) * letter("Δ").squared();
    let mut terms = match Formula::from(&condition.coefficient(&ratio(), 0)) {
        Formula::Sum(terms) => terms,
        term => vec![term],
    };
    terms.push(squared);
    sum(terms)
}

fn condition(harmonic: usize, over_first: bool) -> TruncatedClaim {
    TruncatedClaim::Condition { harmonic, over_first }
}

fn a(k: usize) -> Formula {
    harmonic_name(k).into()
}

pub(super) fn harmonic(k: usize) -> Variable {
    Variable::indexed("a", u32::try_from(k).unwrap_or(u32::MAX))
}

pub(super) fn ratio() -> Variable {
    "Delta".into()
}
