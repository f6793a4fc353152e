//! The complete slow flow.

use super::super::check::AveragedClaim;
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement};
use super::flow::Flow;
use super::names::law;
use super::orders::averaged;
use super::question::AveragingQuestion;

pub(super) fn step(question: &AveragingQuestion, flow: &Flow) -> DerivationStep {
    let parameter = || question.parameter.clone();
    let amplitude = Statement::equal(Name::new("A").prime(), law(question, &flow.growth));
    let phase = Statement::equal(Name::new("ψ").prime(), law(question, &flow.frequency));
    let step = DerivationStep::new("slow-flow", "The slow flow of amplitude and phase")
        .say("Collected, the equations of amplitude and phase are", [])
        .show(averaged(question, amplitude, AveragedClaim::AmplitudeLaw { parameter: parameter() }))
        .show(averaged(question, phase, AveragedClaim::PhaseLaw { parameter: parameter() }));
    let step = match flow.growth.is_empty() {
        true => step.say(
            "The amplitude stays as it is: what the force takes in one part of a swing it gives back in another. Only the frequency depends on {}.",
            [question.small()],
        ),
        false => step.say(
            "The terms with the first power of {} in {} are what the force takes or gives in a swing; those of {} are how it changes the frequency, which a \
             force against the velocity does in its second power only.",
            [question.small(), Formula::from(Name::new("A").prime()), Formula::from(Name::new("ψ").prime())],
        ),
    };
    match question.flow.lift {
        0 => step,
        _ => step.remark(
            "A force that does not vanish with the amplitude stops the motion in the end, where the amplitude is no longer large beside {}. Of \
             that the series know nothing.",
            [question.small()],
        ),
    }
}
