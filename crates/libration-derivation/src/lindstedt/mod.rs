//! The derivation by perturbation: Lindstedt and Poincaré's method with the gauge left open, step by step.

pub(crate) mod accuracy;
mod amplitude;
pub(crate) mod ansatz;
pub(crate) mod contributions;
pub(crate) mod few_harmonics;
mod letters;
pub(crate) mod motion;
mod names;
pub(crate) mod orders;
mod parity;
mod products;
pub(crate) mod question;
mod reduced;
mod second_gauge;
mod small_swings;
mod solution;
pub(crate) mod substitution;
mod taken;
pub(crate) mod three_harmonics;
pub(crate) mod truncated;

use super::check::DerivationError;
use super::document::{Block, Derivation, DerivationStep};
use super::prose::Prose;
use super::two_sided::two_sided;
use libration::internals::progress::Watch;
use libration::oscillator::{Kind, NumbersOrLetters};
use libration::perturbation::Gauge;
use libration::progress::{Interrupted, Progress, Stage};
use libration::quantity::Displacement;
use question::LindstedtQuestion;

/// The oscillation whose numbers a derivation shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Released {
    /// The largest displacement from the equilibrium, in radians for a pendulum.
    pub amplitude: Displacement,
    /// ω0 in rad/s, if times are to be printed in seconds.
    pub angular_frequency: Option<f64>,
}

/// The highest order that is derived step by step.
pub const HIGHEST_ORDER: usize = 9;

/// The motion and the period of an oscillator as series in the amplitude: derived order by order with an open gauge, then in the
/// requested gauge and in a second one, with the numbers of an oscillation if one is given.
///
/// Of an odd force with another power series on either side, such as x + x|x|, a quarter swing is derived, by powers of the largest displacement.
///
/// A cancelled call returns the steps derived so far.
///
/// # Errors
/// An order that is not between 2 and [`HIGHEST_ORDER`]; an oscillator whose motion does not retrace its path, or whose equilibrium is not a
/// fraction or a formula of the symbols; a gauge that the oscillator does not have; an amplitude that is not positive and finite, or given for an
/// oscillator with symbols; a formula that fails its check, which would be an error of this program. [`DerivationError::Interrupted`] if the call is cancelled before the first step.
pub fn perturbation(
    oscillator: impl Into<NumbersOrLetters>,
    order: usize,
    gauge: &Gauge,
    released: Option<&Released>,
    progress: &dyn Progress,
) -> Result<Derivation, DerivationError> {
    let watch = &Watch::new(progress);
    let oscillator = oscillator.into();
    if let NumbersOrLetters::Numbers(oscillator) = &oscillator
        && *oscillator.kind() == Kind::TwoSided
    {
        let amplitude = released.map(|released| &released.amplitude);
        return match (2..=HIGHEST_ORDER).contains(&order) {
            true => two_sided(oscillator, order, gauge, amplitude, watch),
            false => Err(DerivationError::Order { order }),
        };
    }
    let (oscillator, renaming) = taken::renamed(oscillator)?;
    watch.begin(Stage::Whole, Some(PARTS.len()));
    let title = "Perturbation theory of an oscillator, order by order".to_owned();
    let mut derivation = Derivation { title, introduction: introduction(), steps: vec![], answers: vec![] };
    derivation.introduction.extend(renaming.told());
    let question = match LindstedtQuestion::of(&oscillator, order, gauge, &watch.part()) {
        Err(_) if watch.is_stopped() => return Err(Interrupted.into()),
        question => question?,
    };
    for (done, part) in PARTS.iter().enumerate() {
        match watch.reached(done) {
            Err(interrupted) if done == 0 => return Err(interrupted.into()),
            Err(_) => break,
            Ok(()) => {}
        }
        match part(&question, released, &watch.part()) {
            Err(_) if watch.is_stopped() && done > 0 => break,
            steps => derivation.steps.extend(steps?),
        }
    }
    Ok(derivation)
}

/// A function that returns some steps of a derivation.
type LindstedtPart =
    fn(&LindstedtQuestion, Option<&Released>, &Watch<'_>) -> Result<Vec<DerivationStep>, DerivationError>;

/// All parts, in order.
const PARTS: [LindstedtPart; 12] = [
    |question, _, _| Ok(vec![small_swings::equation_of_motion(question)?, small_swings::taylor(question)?]),
    |question, _, _| Ok(vec![ansatz::fundamental_and_harmonics(question), ansatz::projection(question)?]),
    |question, _, watch| Ok(parity::step(question, watch)?.into_iter().collect()),
    |question, _, _| Ok(vec![orders::secular_terms(question)?]),
    |question, _, _| orders::conditions(question),
    |question, _, _| Ok(vec![motion::gauge(question)?, motion::solution(question)?]),
    |question, _, _| Ok(vec![amplitude::iteration(question)?, amplitude::physical_relations(question)?]),
    |question, _, watch| Ok(letters::step(question, watch)?.into_iter().collect()),
    |question, _, _| Ok(vec![second_gauge::comparison(question)?]),
    |question, _, _| {
        let step = truncated::step(question)?;
        let step = step.map(|step| three_harmonics::after(question, step)).transpose()?;
        Ok(step.into_iter().collect())
    },
    |question, released, watch| Ok(few_harmonics::step(question, released, watch)?.into_iter().collect()),
    |question, released, watch| Ok(accuracy::step(question, released, watch)?.into_iter().collect()),
];

fn introduction() -> Vec<Block> {
    let what = Prose::text(
        "An oscillator with a force that is not exactly linear has a period that depends on its amplitude, and overtones. \
         Both follow from its equation of motion alone, as power series, by the method of Lindstedt and Poincaré: \
         the motion and its frequency are expanded together, so that no term grows with time.",
    );
    let how = Prose::text(
        "Each formula is followed by the check made while this text was written. Nearly all of it is arithmetic with \
         fractions and checked exactly: the solutions are put back into the equation of motion, not compared with a table.",
    );
    vec![Block::Paragraph(what), Block::Paragraph(how)]
}
