//! Derivation of a slow flow with symbols, several small terms and a drive, to the lowest order at which amplitude and phase change.
//!
//! # Method
//! The expansion hands over its steps as formulas: the small terms along the motion of order zero, their resonant parts, the slow flow, the
//! elimination of the phase and the properties of the response curve. Each formula is evaluated as printed, to 77 digits, for several choices of
//! the symbols: products against the motion itself, the slow flow against integrals over a period of the force, formulas of steady states at
//! amplitudes and phases at which both rates are zero.

mod in_time;
mod motion;
mod response;
mod small_terms;
mod steady;
mod subject;

use super::check::DerivationError;
use super::document::{Block, Derivation};
use super::prose::Prose;
use libration::expression::Equation;
use libration::perturbation::SymbolicSlowFlowOptions;
use libration::progress::Progress;
use subject::SlowFlowSubject;

/// The slow flow of amplitude and phase of an oscillator with symbols for its parameters, free or driven, and its steady states, to the lowest
/// order in the small parameters.
///
/// # Errors
/// An equation without such a slow flow, or one whose lowest order needs products of several orders; a formula that fails its check, which would be
/// an error of this program.
///
/// # Examples
/// ```
/// use libration::perturbation::SymbolicSlowFlowOptions;
/// use libration::progress::Quiet;
/// use libration_derivation::{slow_flow, to_markdown};
/// let equation = "x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)".parse()?;
/// let options = SymbolicSlowFlowOptions { resonance: Some((1, 1)), ..Default::default() };
/// let page = to_markdown(&slow_flow(&equation, &options, &Quiet)?);
/// assert!(page.contains(r"A_{\mathrm{max}}:=\frac{F}{2\mu w_{0}}"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn slow_flow(
    equation: &Equation,
    options: &SymbolicSlowFlowOptions,
    progress: &dyn Progress,
) -> Result<Derivation, DerivationError> {
    let subject = SlowFlowSubject::new(equation, options, progress)?;
    let mut steps = vec![
        motion::equation_of_motion(&subject)?,
        motion::ansatz(&subject)?,
        motion::derivatives(&subject)?,
        small_terms::step(&subject)?,
        small_terms::averaged(&subject)?,
    ];
    steps.extend(steady::free(&subject)?);
    steps.extend(in_time::step(&subject)?);
    if let Some(trials) = subject.steady_trials()? {
        steps.extend(steady::driven(&subject, &trials)?);
        steps.extend(response::curve(&subject)?);
        steps.extend(steady::stability(&subject, &trials)?);
    }
    let title = match subject.flow().resonance {
        Some((p, q)) => format!("A weakly nonlinear oscillator near its resonance {p}:{q}"),
        None => "A weakly nonlinear oscillator with damping or excitation".to_owned(),
    };
    Ok(Derivation { title, introduction: introduction(), steps, answers: vec![] })
}

fn introduction() -> Vec<Block> {
    let what = Prose::text(
        "Weak forces change the amplitude and the phase of an oscillation slowly. Their rates are found by the method of averaging: the motion without the weak forces is put into them, and the parts \
         that have the frequency of the oscillation decide. All parameters stay symbols, and only the lowest order in what is small is kept.",
    );
    let how = Prose::text(
        "Each formula is followed by the check made while this text was written. It was evaluated as it stands here, with many digits, for several choices of all symbols.",
    );
    vec![Block::Paragraph(what), Block::Paragraph(how)]
}
