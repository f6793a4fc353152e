//! The shortcut: a few harmonics and a truncated force, and a direct solution of the remaining equations.

use super::super::check::DerivationError;
use super::super::document::{DerivationStep, DerivationTable};
use super::super::formula::{DecimalUnit, letter, rounded};
use super::super::prose::Prose;
use super::Released;
use super::accuracy::{amplitude_of, as_given};
use super::names::harmonic_name;
use super::question::LindstedtQuestion;
use libration::algebra::Complex;
use libration::internals::progress::Watch;
use libration::perturbation::{SolutionVerdict, TruncatedSolution, TruncatedSystem};

/// Number of harmonics, cos Ωt and cos 3Ωt, with the cube of the displacement.
pub(super) const HARMONICS: u32 = 2;
pub(super) const DEGREE: usize = 3;

/// All solutions for two harmonics, each with a verdict; `None` for a force without
/// a cube, for one that is not odd, and at an amplitude at which solutions coincide.
pub fn step(
    question: &LindstedtQuestion,
    released: Option<&Released>,
    watch: &Watch<'_>,
) -> Result<Option<DerivationStep>, DerivationError> {
    let exactly = amplitude_of(released)?;
    let amplitude = exactly.to_f64();
    let system = TruncatedSystem::new(&question.force, HARMONICS, DEGREE);
    let Some(solutions) = system.ok().and_then(|system| system.solutions(amplitude, watch).ok()) else {
        return Ok(None);
    };
    let step = DerivationStep::new("two-harmonics", "All solutions for two harmonics")
        .say(
            "At the amplitude {} the three equations for {}, {} and {} have the solutions",
            [
                as_given(question, &exactly),
                harmonic_name(1).into(),
                harmonic_name(3).into(),
                letter("Δ").squared(),
            ],
        )
        .table(table(&solutions))
        .say(outcome(&solutions), []);
    Ok(Some(step))
}

/// The conclusion from the verdicts.
fn outcome(solutions: &[TruncatedSolution]) -> &'static str {
    if solutions.iter().any(|solution| solution.verdict == SolutionVerdict::Accepted) {
        "Only one of them is a motion that becomes a small swing as the amplitude falls. With the series there is nothing \
         to choose: they begin at the small swing and stay with it."
    } else {
        "None of them is a motion that becomes a small swing as the amplitude falls: so far out the force cut off after \
         the cube has lost it."
    }
}

fn table(solutions: &[TruncatedSolution]) -> DerivationTable {
    let row = |solution: &TruncatedSolution| {
        let numbers = solution.amplitudes.iter().chain([&solution.frequency_ratio_squared]);
        let mut row: Vec<Prose> = numbers.map(|number| complex(*number, size(solution))).collect();
        row.push(Prose::formula(rounded(solution.residual, 2, DecimalUnit::One)));
        row.push(Prose::text(word(solution.verdict)));
        row
    };
    let head = [harmonic_name(1).into(), harmonic_name(3).into(), letter("Δ").squared()].map(Prose::formula);
    let head = head.into_iter().chain(["rest", "verdict"].map(Prose::text)).collect();
    let note = Prose::text(
        "rest: what the equation of motion with the force to the order derived leaves, its root mean square over a period; \
         not a small swing: real, but not connected with one; nothing oscillates: the square of the frequency is not positive",
    );
    DerivationTable::numbers(head, solutions.iter().map(row).collect(), note)
}

const fn word(verdict: SolutionVerdict) -> &'static str {
    match verdict {
        SolutionVerdict::Accepted => "accepted",
        SolutionVerdict::Overtone => "no first harmonic",
        SolutionVerdict::OtherBranch => "not a small swing",
        SolutionVerdict::NoOscillation => "nothing oscillates",
        SolutionVerdict::Complex => "complex",
    }
}

/// The largest amplitude.
fn size(solution: &TruncatedSolution) -> f64 {
    solution.amplitudes.iter().map(|a| a.abs()).fold(0.0, f64::max)
}

/// A complex number, whose parts are zero if they are rounding errors of numbers of this size.
fn complex(number: Complex, size: f64) -> Prose {
    const DIGITS: usize = 5;
    /// The limit of `SolutionVerdict`, above which a solution is called complex.
    const ROUNDING: f64 = 1e-9;
    let part = |part: f64| if part.abs() <= ROUNDING * size { 0.0 } else { part };
    let (re, im) = (part(number.re), part(number.im));
    let formula = |part| Prose::formula(rounded(part, DIGITS, DecimalUnit::One));
    if im == 0.0 {
        return formula(re);
    }
    let sign = if im < 0.0 { " − " } else { " + " };
    formula(re).and(Prose::text(sign)).and(formula(im.abs())).and(Prose::text("i"))
}
