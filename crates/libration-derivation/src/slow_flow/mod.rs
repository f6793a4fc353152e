//! Derivation of a slow flow with symbols, several small terms and a drive, to the lowest order at which amplitude and phase change, or to the order
//! of products of two small terms.
//!
//! # Method
//! The expansion hands over its steps as formulas: the small terms along the motion of order zero, their resonant parts, the slow flow, the
//! elimination of the phase and the properties of the response curve. Each formula is evaluated as printed, to 77 digits, for several choices of
//! the symbols: products against the motion itself, the slow flow against integrals over a period of the force, formulas of steady states at
//! amplitudes and phases at which both rates are zero.

mod in_time;
mod motion;
mod response;
mod second_order;
mod small_terms;
mod steady;
mod subject;

use super::check::DerivationError;
use super::document::{Block, Derivation, DerivationStep};
use super::prose::Prose;
use libration::expression::Equation;
use libration::perturbation::{EarlierOrder, SmallTerm, SymbolicSlowFlowOptions};
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
    ];
    let own: Vec<&SmallTerm> = subject.steps.terms.iter().collect();
    match &subject.steps.before {
        None => {
            steps.push(small_terms::step(&subject, &subject.steps.terms)?);
            steps.push(small_terms::averaged(&subject, &own)?);
        }
        Some(before) => steps.extend(second_order(&subject, before, (equation, options, progress))?),
    }
    if subject.steps.has_one_order {
        steps.extend(steady::free(&subject)?);
        steps.extend(in_time::step(&subject)?);
    }
    if let Some(trials) = subject.steady_trials()?.filter(|_| subject.steps.has_one_order) {
        steps.extend(steady::driven(&subject, &trials)?);
        steps.extend(response::curve(&subject)?);
        steps.extend(steady::stability(&subject, &trials)?);
    }
    let title = match subject.flow().resonance {
        Some((p, q)) => format!("A weakly nonlinear oscillator near its resonance {p}:{q}"),
        None => "A weakly nonlinear oscillator with damping or excitation".to_owned(),
    };
    let introduction = introduction(&subject);
    Ok(Derivation { title, introduction, steps, answers: vec![] })
}

/// The steps of two orders to the slow flow.
fn second_order(
    subject: &SlowFlowSubject,
    before: &EarlierOrder,
    (equation, options, progress): (&Equation, &SymbolicSlowFlowOptions, &dyn Progress),
) -> Result<Vec<DerivationStep>, DerivationError> {
    let mut steps = vec![small_terms::step(subject, &before.terms)?];
    let changes = before.changes.iter().chain(&subject.steps.terms);
    let Some(products) = &before.products else {
        let last = steps.pop().map(|step| {
            step.say("None of these waves has the frequency of the oscillation: in this order amplitude and phase do not change.", [])
        });
        steps.extend(last);
        steps.extend(second_order::forced_waves(subject, before)?);
        steps.push(second_order::changed_terms(subject, before)?);
        let acting: Vec<&SmallTerm> = changes.collect();
        steps.push(small_terms::averaged(subject, &acting)?);
        return Ok(steps);
    };
    let options = SymbolicSlowFlowOptions { order: Some(before.order), ..options.clone() };
    let first = SlowFlowSubject::new(equation, &options, progress)?;
    let own: Vec<&SmallTerm> = first.steps.terms.iter().collect();
    steps.push(small_terms::averaged(&first, &own)?);
    steps.extend(second_order::forced_waves(subject, before)?);
    steps.push(second_order::rate_products(subject, &first, (before, products))?);
    steps.push(second_order::changed_terms(subject, before)?);
    let acting: Vec<&SmallTerm> = before.terms.iter().chain(changes).collect();
    steps.push(second_order::averaged(subject, &acting, products)?);
    Ok(steps)
}

fn introduction(subject: &SlowFlowSubject) -> Vec<Block> {
    let kept = match (&subject.steps.before, subject.steps.has_one_order) {
        (Some(_), _) => "products of two small terms are kept, but not of three",
        (None, true) => "only the lowest order in what is small is kept",
        (None, false) => "no products of small terms are kept",
    };
    let what = Prose::text(format!(
        "Weak forces change the amplitude and the phase of an oscillation slowly. Their rates are found by the method of averaging: the motion without the weak forces is put into them, and the parts \
         that have the frequency of the oscillation decide. All parameters stay symbols, and {kept}.",
    ));
    let how = Prose::text(
        "Each formula is followed by the check made while this text was written. It was evaluated as it stands here, with many digits, for several choices of all symbols.",
    );
    vec![Block::Paragraph(what), Block::Paragraph(how)]
}
