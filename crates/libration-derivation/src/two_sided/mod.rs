//! The derivation for an odd force with another power series on either side, such as x + x|x|: a quarter swing, power by power of the amplitude.
//!
//! # Method
//! On one side the force is smooth. The motion from the turning point is found power by power with two initial conditions; that it passes
//! through zero after a quarter of the period fixes the frequency. Integrals over the quarter give powers of π. The motion is put into the
//! equation of motion, and frequency and harmonics are compared with the library's, which follow from the potential.

mod accuracy;
mod quarter;
mod steps;
mod subject;

use super::check::DerivationError;
use super::document::{Block, Derivation};
use super::prose::Prose;
use libration::internals::progress::Watch;
use libration::oscillator::Oscillator;
use libration::perturbation::Gauge;
use libration::progress::Interrupted;
use libration::quantity::Displacement;
use subject::TwoSidedSubject;

pub use quarter::Quarter;

/// The steps for such an oscillator, with the numbers at an amplitude if one is given.
pub(super) fn two_sided(
    oscillator: &Oscillator,
    order: usize,
    gauge: &Gauge,
    amplitude: Option<&Displacement>,
    watch: &Watch<'_>,
) -> Result<Derivation, DerivationError> {
    if !matches!(gauge, Gauge::Fundamental | Gauge::XMax) {
        return Err(DerivationError::GaugeOfTwoSided);
    }
    let subject = TwoSidedSubject::new(oscillator, order)?;
    match subject.agrees_with_library(&watch.part()) {
        Err(_) if watch.is_stopped() => return Err(Interrupted.into()),
        outcome => outcome?,
    }
    let title = "An oscillator with a force of two sides, power by power".to_owned();
    let mut steps = vec![
        steps::equation_of_motion(&subject)?,
        steps::taylor(&subject)?,
        steps::ansatz(&subject),
        steps::solutions()?,
    ];
    steps.extend(subject.quarter.orders.iter().map(|solved| steps::one_power(&subject, solved)));
    steps.push(steps::result(&subject)?);
    if let Some(amplitude) = amplitude {
        steps.push(accuracy::step(&subject, amplitude, watch)?);
    }
    Ok(Derivation { title, introduction: introduction(), steps, answers: vec![] })
}

fn introduction() -> Vec<Block> {
    let what = Prose::text(
        "A force that has one power series at positive displacements and another at negative ones cannot be expanded about its equilibrium. But half of a swing takes place on each side, where \
         the force is smooth. Period and harmonics follow from one quarter of the swing, as power series in the amplitude whose coefficients have powers of π.",
    );
    let how = Prose::text(
        "Each formula is followed by the check made while this text was written. The motion was put back into the equation of motion with exact fractions and powers of π, and frequency and harmonics \
         were compared with those of another algorithm, which begins with the potential.",
    );
    vec![Block::Paragraph(what), Block::Paragraph(how)]
}
