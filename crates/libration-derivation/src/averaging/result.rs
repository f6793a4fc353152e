//! The slow flow that was found, as a whole.

use super::super::check::AveragedClaim;
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement};
use super::flow::Flow;
use super::names::law;
use super::orders::averaged;
use super::question::Question;

pub(super) fn step(question: &Question, flow: &Flow) -> DerivationStep {
    let parameter = || question.parameter.clone();
    let amplitude = Statement::equal(Name::new("A").prime(), law(question, &flow.growth));
    let phase = Statement::equal(Name::new("ψ").prime(), law(question, &flow.frequency));
    let step = DerivationStep::new("slow-flow", "How amplitude and phase go")
        .say("Collected, amplitude and phase go as", [])
        .show(averaged(question, amplitude, AveragedClaim::AmplitudeLaw { parameter: parameter() }))
        .show(averaged(question, phase, AveragedClaim::PhaseLaw { parameter: parameter() }))
        .say(
            "The first terms with {} have a meaning each: that of {} is what the force takes or gives in a swing, that of {} how it changes the \
             frequency. Often it does not do so in its first power.",
            [question.small(), Formula::from(Name::new("A").prime()), Formula::from(Name::new("ψ").prime())],
        );
    match question.flow.lift {
        0 => step,
        _ => step.remark(
            "A force that does not vanish with the amplitude stops the motion in the end, where the amplitude is no longer large beside {}. Of \
             that the series know nothing.",
            [question.small()],
        ),
    }
}
