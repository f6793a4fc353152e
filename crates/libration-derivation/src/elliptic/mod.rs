//! The derivation by elliptic integrals: from the energy to the period as an integral, a series and a mean.

mod energy;
mod mean;
mod rigid_body;
mod series;
mod substitution;

pub(super) use mean::theta_series;

use super::check::DerivationError;
use super::document::{Block, Derivation};
use super::prose::Prose;
use super::trials::{Swing, Trials};

/// Derives the period at any amplitude from the conservation of energy, with the numbers of a swing if one is given.
///
/// # Errors
/// An amplitude below 0.01° or above 179.9°; a formula that fails its check, which would be an error of this program.
pub fn elliptic(swing: Option<&Swing>) -> Result<Derivation, DerivationError> {
    let mut trials = Trials::new(swing)?;
    let steps = vec![
        energy::equation_of_motion(&mut trials)?,
        energy::conservation(&trials)?,
        energy::quarter_period(&trials)?,
        substitution::half_angles(&mut trials)?,
        substitution::new_variable(&mut trials)?,
        substitution::complete_integral(&mut trials)?,
        series::binomial(&trials)?,
        series::powers_of_the_sine(&mut trials)?,
        series::period(&trials)?,
        series::in_the_amplitude()?,
        mean::invariance(&mut trials)?,
        mean::iteration(&trials)?,
        rigid_body::step(&trials)?,
    ];
    Ok(Derivation {
        title: "The period of a pendulum at any amplitude".to_owned(),
        introduction: introduction(),
        steps,
        answers: vec![],
    })
}

fn introduction() -> Vec<Block> {
    let what = Prose::text(
        "A pendulum released at rest from a large angle swings more slowly than one that swings little. How much more \
         slowly follows from the conservation of energy alone: as an integral, as a series, and as a mean of two numbers \
         that a pocket calculator finds in three steps.",
    );
    let how = Prose::text(
        "Each formula is followed by the check made while this text was written: it was evaluated as it is printed, \
         integrals and infinite sums included, with 77 digits unless something else is said. Where a formula speaks \
         of an angle during the swing, it is the one at 0.86 of a period after the release.",
    );
    vec![Block::Paragraph(what), Block::Paragraph(how)]
}
