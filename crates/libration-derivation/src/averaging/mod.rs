//! Derivation of the decay of weakly damped oscillations, and of the growth of
//! self-excited ones: averaging by Krylov, Bogoliubov and Mitropolsky, power by power.
//!
//! # Method
//! The slow flow is found by undetermined coefficients, from products of lower results, which are shown. It
//! is checked by differentiating the whole motion twice along the flow. Each coefficient is then compared
//! with `perturbation::slow_flow`, which uses another algorithm. Notebooks compute it a third time.

mod ansatz;
mod cycle;
mod energy;
mod equation;
pub(crate) mod flow;
mod names;
mod orders;
pub(crate) mod put_back;
pub(crate) mod question;
mod result;
mod secular;
mod simple_law;
mod special;
mod tables;

use super::check::DerivationError;
use super::document::{Block, Derivation, DerivationStep};
use super::prose::Prose;
use flow::Flow;
use libration::expression::Equation;
use libration::internals::progress::Watch;
use libration::perturbation::SlowFlow;
use libration::progress::{Interrupted, Progress, Stage};

pub(super) use question::AveragingQuestion;
pub use question::{HIGHEST_AMPLITUDE_ORDER, HIGHEST_DAMPING_ORDER};
pub(super) use tables::in_terms;

/// The slow flow of amplitude and phase of an oscillator under a weak force that removes or supplies energy. The series in the amplitude, up to
/// and including the power `order`, and in the small parameter, up to and including the power `parameter_order`, are derived power by power. The
/// small parameter is the symbol without a value, or the named one; the amplitude is the displacement at which the motion turns.
///
/// A cancelled call returns the steps derived so far.
///
/// # Errors
/// An order that is not between 1 and [`HIGHEST_AMPLITUDE_ORDER`] or [`HIGHEST_DAMPING_ORDER`]; an equation
/// without a slow flow, or with irrational numbers; a formula that fails its check, which would be an error
/// of this program. [`DerivationError::Interrupted`] if the call is cancelled before the first step.
///
/// # Examples
/// ```
/// use libration::progress::Quiet;
/// use libration_derivation::{averaging, to_markdown};
/// let page = averaging(&"x'' + c*x'*abs(x') + x = 0".parse()?, None, 3, 1, &Quiet)?;
/// assert!(to_markdown(&page).contains(r"\frac{4cA^{2}}{3\pi "));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn averaging(
    equation: &Equation,
    parameter: Option<&str>,
    order: usize,
    parameter_order: usize,
    progress: &dyn Progress,
) -> Result<Derivation, DerivationError> {
    let watch = &Watch::new(progress);
    watch.begin(Stage::Whole, Some(PARTS.len()));
    let (question, renaming) =
        AveragingQuestion::renamed(equation, parameter, [order, parameter_order], &FURTHER)?;
    let flow = Flow::new(&question, watch)?;
    put_back::check(&question, &flow)?;
    let library = match put_back::agrees_with_library(&question, &flow, &watch.part()) {
        Err(_) if watch.is_stopped() => return Err(Interrupted.into()),
        outcome => outcome?,
    };
    let title = "An oscillator under a weak force, by averaging".to_owned();
    let mut derivation = Derivation { title, introduction: introduction(), steps: vec![], answers: vec![] };
    derivation.introduction.extend(renaming.told());
    for (done, part) in PARTS.iter().enumerate() {
        match watch.reached(done) {
            Err(interrupted) if done == 0 => return Err(interrupted.into()),
            Err(_) => break,
            Ok(()) => derivation.steps.extend(part(&question, &flow, &library)?),
        }
    }
    Ok(derivation)
}

/// Symbols of this derivation alone, with any subscript.
const FURTHER: [&str; 10] = ["F", "P", "R", "a", "r", "s", "y", "z", "β", "δ"];

/// A function that returns some steps of a derivation.
type AveragingPart = fn(&AveragingQuestion, &Flow, &SlowFlow) -> Result<Vec<DerivationStep>, DerivationError>;

/// All parts, in order.
const PARTS: [AveragingPart; 12] = [
    |question, _, _| Ok(vec![equation::step(question)?]),
    |question, flow, _| Ok(vec![ansatz::step(question, flow)]),
    |question, _, _| Ok(vec![ansatz::chain_rule(question)?, ansatz::gauge(question)]),
    |question, _, _| Ok(vec![secular::step(question)?]),
    |question, flow, _| orders::steps(question, flow),
    |question, flow, _| Ok(vec![result::step(question, flow)]),
    |question, flow, _| Ok(simple_law::step(question, flow)?.into_iter().collect()),
    |question, flow, _| Ok(energy::step(question, flow)?.into_iter().collect()),
    |question, flow, _| Ok(special::linear_spring(question, flow)?.into_iter().collect()),
    |question, flow, _| Ok(special::pendulum(question, flow)?.into_iter().collect()),
    |question, _, _| Ok(special::published(question)?.into_iter().collect()),
    |question, flow, library| Ok(cycle::step(question, flow, library)?.into_iter().collect()),
];

fn introduction() -> Vec<Block> {
    let what = Prose::text(
        "Under a weak force an oscillation remains nearly what it is, and its amplitude and phase change slowly. Their equations follow from the equation \
         of motion by the method of Krylov, Bogoliubov and Mitropolsky: amplitude, phase and form are expanded together, so that no other growth \
         than that of the amplitude occurs in them.",
    );
    let how = Prose::text(
        "Each formula is followed by the check made while this text was written. The whole motion was put back into the equation of motion with exact \
         fractions and powers of π, and every coefficient was compared with that of another algorithm, which goes to any order.",
    );
    vec![Block::Paragraph(what), Block::Paragraph(how)]
}
