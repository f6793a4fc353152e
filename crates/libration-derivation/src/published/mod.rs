//! The derivation of the published formulas: the origin and the range of each.

mod limits;
mod means;
mod report;
mod separatrix;
mod series;

use super::check::DerivationError;
use super::document::{Block, Derivation};
use super::prose::Prose;
use super::trials::{Swing, Trials};
use super::words::{period, period_ratio, theta_0};

/// Derivations of the published formulas for the period, each with its leading
/// error, and with its error at the amplitude of a swing if one is given.
///
/// # Errors
/// An amplitude below 0.01° or above 179.9°; a formula that fails its check, which would be an error of this program.
pub fn formulas(swing: Option<&Swing>) -> Result<Derivation, DerivationError> {
    let mut trials = Trials::new(swing)?;
    let steps = vec![
        limits::exact_ratio(&trials)?,
        limits::small_angle_and_bernoulli(&trials)?,
        limits::molina(&trials)?,
        means::kidd_fogg_and_carvalhaes_suppes(&mut trials)?,
        means::errors_of_means(&mut trials)?,
        means::belendez(&mut trials)?,
        separatrix::butikov(&trials)?,
        separatrix::error_near_the_top(&trials)?,
        series::black_vel(&trials)?,
        series::three_terms(&trials)?,
        report::all_at_one_amplitude(&trials)?,
    ];
    Ok(Derivation {
        title: "Origin of the formulas for the period".to_owned(),
        introduction: introduction(),
        steps,
        answers: vec![],
    })
}

fn introduction() -> Vec<Block> {
    let what = Prose::new(
        "Many formulas give the period {} of a pendulum at large amplitudes without an integral. Nearly all of them come from \
         three places: the power series in the amplitude, the arithmetic–geometric mean, and the slow motion near the \
         upright position. The derivations here are ours and show why the formulas are good where they are good; their \
         authors may have used other derivations.",
        [period()],
    );
    let how = Prose::new(
        "The error of a formula is what it says over the exact period, less one. Each formula is followed by the check \
         made while this text was written: series in {} with exact fractions, values with 77 digits. Amplitudes in \
         series are in radians. All formulas are for {}, the period over that of very small swings.",
        [theta_0(), period_ratio()],
    );
    vec![Block::Paragraph(what), Block::Paragraph(how)]
}
