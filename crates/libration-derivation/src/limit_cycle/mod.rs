//! The derivation of a limit cycle: Lindstedt and Poincaré's method with two conditions at each power, for amplitude and frequency.

mod cycle;
mod library_cycle;
mod open;
mod steps;

use super::averaging::AveragingQuestion;
use super::check::DerivationError;
use super::document::{Block, Derivation};
use super::prose::Prose;
use cycle::Cycle;
use library_cycle::LibraryCycle;
use libration::expression::Equation;
use libration::internals::progress::Watch;
use libration::progress::{Interrupted, Progress, Stage};

/// The highest power of the excitation that is derived step by step.
pub const HIGHEST_CYCLE_ORDER: usize = 9;
/// The highest power of displacement and velocity that the force may have.
const HIGHEST_DEGREE: usize = 9;

/// The limit cycle of a self-excited oscillator as series in the strength of the excitation,
/// derived power by power. The strength is the symbol without a value, or the named one.
///
/// # Errors
/// An order that is not between 1 and [`HIGHEST_CYCLE_ORDER`]; an equation without a limit cycle, or
/// with an irrational amplitude or other irrational numbers; a formula that fails its check, which
/// would be an error of this program. [`DerivationError::Interrupted`] if the call is cancelled.
///
/// # Examples
/// ```
/// use libration::progress::Quiet;
/// use libration_derivation::{limit_cycle, to_markdown};
/// let page = limit_cycle(&"x'' - mu*(1 - x^2)*x' + x = 0".parse()?, None, 2, &Quiet)?;
/// assert!(to_markdown(&page).contains(r"\Omega =1-\frac{1}{16}\mu ^{2}"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn limit_cycle(
    equation: &Equation,
    parameter: Option<&str>,
    order: usize,
    progress: &dyn Progress,
) -> Result<Derivation, DerivationError> {
    let watch = &Watch::new(progress);
    watch.begin(Stage::Whole, Some(order));
    if !(1..=HIGHEST_CYCLE_ORDER).contains(&order) {
        return Err(DerivationError::CycleOrder { order });
    }
    let (question, renaming) = AveragingQuestion::renamed(equation, parameter, [HIGHEST_DEGREE, 1], &[])?;
    let is_linear = question.restoring_terms().next().is_none() && question.is_whole;
    if !is_linear || question.flow.kinked || question.flow.lift > 0 {
        return Err(DerivationError::NoPolynomial);
    }
    let library = match LibraryCycle::new(&question, order, &watch.part()) {
        Err(_) if watch.is_stopped() => return Err(Interrupted.into()),
        outcome => outcome?,
    };
    let cycle = Cycle::new(&question, order, &library.beginning()?)?;
    if !library.is(&question, &cycle) {
        return Err(DerivationError::Disagreement { what: "two computations of the limit cycle" });
    }
    let title = "A limit cycle, by powers of its excitation".to_owned();
    let mut derivation = Derivation { title, introduction: introduction(), steps: vec![], answers: vec![] };
    derivation.introduction.extend(renaming.told());
    derivation.steps.push(steps::equation(&question));
    derivation.steps.push(steps::ansatz(&question));
    for n in 1..=order {
        watch.reached(n)?;
        derivation.steps.push(steps::one_power(&question, &cycle, n));
    }
    derivation.steps.push(steps::result(&question, &cycle));
    Ok(derivation)
}

fn introduction() -> Vec<Block> {
    let what = Prose::text(
        "An oscillator that feeds small swings and limits large ones settles to one amplitude, whatever it began with. That amplitude, the frequency and the form of \
         this motion follow from the equation of motion by the method of Lindstedt and Poincaré, as power series in the strength of the excitation.",
    );
    let how = Prose::text(
        "Each formula is followed by the check made while this text was written, with exact fractions; every coefficient was compared with that of another algorithm, \
         which goes to any order.",
    );
    vec![Block::Paragraph(what), Block::Paragraph(how)]
}
