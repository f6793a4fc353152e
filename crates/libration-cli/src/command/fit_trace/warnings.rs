//! What casts doubt on a fit, in sentences.

use super::answer::{Answer, Beta, Pendulum};
use super::sheet;
use crate::output;
use crate::output::number::{rounded, with_uncertainty};
use libration_lab::fit::cycles;
use libration_lab::fit::trace::{Comparison, TraceFit};

/// A difference of so many uncertainties is not chance.
pub(super) const SIGNIFICANT: f64 = 3.0;

/// A doubt, and what it is about in a word that stays.
pub(super) struct Warning {
    pub(super) kind: &'static str,
    pub(super) text: String,
}

/// The warnings, the gravest first.
pub(super) fn of(answer: &Answer<'_>) -> Vec<Warning> {
    let fit = &answer.fit;
    let (contradiction, of_budget) = match &answer.pendulum {
        Pendulum::Gravity { budget, .. } => (output::budget::contradiction(budget), budget.warnings()),
        Pendulum::Length { .. } => (None, vec![]),
    };
    let one = |text: Option<String>| -> Vec<String> { text.into_iter().collect() };
    let kinds = [
        ("not_converged", one(of_convergence(fit))),
        ("angles_are_radians", one(of_radians(answer))),
        ("gravity_contradicted", one(contradiction)),
        ("budget", of_budget),
        ("poor_fit", one(of_poor_fit(fit))),
        ("feeds_energy", one(of_energy(fit))),
        ("negative_damping", one(of_negative_damping(answer))),
        ("better_model_not_believed", of_better_models(answer)),
        ("damping_not_separated", one(of_rivals(answer))),
        ("residuals_not_noise", one(of_residuals(fit))),
        ("stated_uncertainties", one(of_stated_uncertainties(fit))),
        ("strong_damping", one(of_strong_damping(answer))),
        ("beta_not_one", one(of_beta(answer))),
        ("periods_disagree", one(of_periods(answer))),
        ("different_pendulums", one(of_different_pendulums(answer))),
        ("implausible_length", one(of_length(answer))),
        ("outliers", one(of_outliers(fit))),
        ("cycles", of_cycles(answer)),
    ];
    let all = kinds.into_iter().flat_map(|(kind, texts)| texts.into_iter().map(move |text| (kind, text)));
    all.map(|(kind, text)| Warning { kind, text }).collect()
}

fn of_convergence(fit: &TraceFit) -> Option<String> {
    (!fit.converged)
        .then(|| "the fit did not settle at a minimum: its numbers are not to be trusted".to_owned())
}

fn are_radians(answer: &Answer<'_>) -> bool {
    let cycles = answer.all_cycles().map(|(_, cycle)| cycle);
    answer.beta.as_ref().is_ok_and(|beta| cycles::are_radians(beta.value, cycles))
}

fn of_radians(answer: &Answer<'_>) -> Option<String> {
    let beta = answer.beta.as_ref().ok().filter(|_| are_radians(answer))?;
    Some(format!(
        "these angles are radians that were taken for degrees (--unit rad): β is {}, where (180/π)² = 3283 is what that mistake \
         makes of small angles, and with radians the periods follow the exact law. T₀ and all angles given here are wrong",
        rounded(beta.value, 4)
    ))
}

/// Whether what the motion leaves is so large that its numbers mean little.
pub(super) fn is_poor(fit: &TraceFit) -> bool {
    fit.unexplained.sqrt() > 0.1
}

fn of_poor_fit(fit: &TraceFit) -> Option<String> {
    let part = fit.unexplained.sqrt();
    is_poor(fit).then(|| {
        format!(
            "the residuals are {} % of the swing itself: the model does not describe what was seen, and its numbers mean \
             little. Leave out what is no free swing with --from and --to, or check columns and units",
            rounded(100.0 * part, 2)
        )
    })
}

fn of_energy(fit: &TraceFit) -> Option<String> {
    (!fit.takes_energy()).then(|| {
        format!("the model `{}` feeds energy to the pendulum at some speeds, which no friction does: choose another", fit.damping)
    })
}

/// Drag that pushes, which the data ask for strongly enough to believe in it, or which was asked for.
fn of_negative_damping(answer: &Answer<'_>) -> Option<String> {
    let negative = answer.fit.negative_terms();
    let told: Vec<String> = negative
        .iter()
        .filter_map(|term| {
            let parameter = answer.fit.parameter(term.name())?;
            Some(with_uncertainty(parameter.value, parameter.uncertainty, &sheet::unit(term.unit())))
        })
        .collect();
    let names: Vec<String> = negative.iter().map(|term| term.name().to_owned()).collect();
    (!negative.is_empty()).then(|| {
        format!(
            "the {} damping is negative, {}: no drag pushes. The friction may fall as the speed rises, or something else that \
             is not in the model is described by it",
            names.join(" and "),
            told.join(" and ")
        )
    })
}

fn of_better_models(answer: &Answer<'_>) -> Vec<String> {
    let better = answer.comparison.iter().flat_map(Comparison::better);
    let told = better.map(|(fit, by)| {
        let why = match fit.negative_terms().first() {
            Some(term) => format!("its {} damping is negative", term.name()),
            None => "it feeds energy to the pendulum at some speeds".to_owned(),
        };
        format!(
            "`{}` explains the data better (AICc lower by {}) and is not preferred, since {why}: the pendulum or the instrument does \
             something that is in no model",
            fit.damping,
            rounded(by, 3)
        )
    });
    told.collect()
}

fn of_rivals(answer: &Answer<'_>) -> Option<String> {
    let rivals = answer.rivals();
    let preferred = answer.fit.damping;
    (!rivals.is_empty()).then(|| {
        format!(
            "these data cannot separate the model {preferred} from {} for certain: T₀ is averaged over them, and the \
             coefficients differ from one to the other by more than their uncertainties may say",
            list(&rivals)
        )
    })
}

fn of_residuals(fit: &TraceFit) -> Option<String> {
    /// What repeats with the swing, or changes its sign from row to row, is alike over no more than one row.
    const ALIKE: f64 = 1.5;
    let inflation = fit.parameters[0].uncertainty / fit.parameters[0].formal_uncertainty;
    let how = match fit.autocorrelation.time {
        time if time < ALIKE => "they follow a pattern".to_owned(),
        time => format!("they are alike over about {} rows", rounded(time, 2)),
    };
    let heeded = match inflation {
        inflation if inflation < ALIKE => String::new(),
        inflation => format!(
            "For ω₀ that makes {} times the uncertainty it had if the rows were independent, which is heeded; ",
            rounded(inflation, 2)
        ),
    };
    let more = if heeded.is_empty() {
        "A systematic error may be larger than the uncertainties"
    } else {
        "a systematic error may be larger still"
    };
    (!fit.autocorrelation.is_noise()).then(|| {
        format!(
            "the residuals are not noise: {how}, so the pendulum does something the model does not, or the instrument does. \
             {heeded}{more}"
        )
    })
}

fn of_stated_uncertainties(fit: &TraceFit) -> Option<String> {
    let factor = fit.chi2_per_dof?.sqrt();
    let told = |how: &str| {
        format!(
            "the rows scatter {} times as much as their stated uncertainties: these are too {how}",
            rounded(factor, 2)
        )
    };
    match factor {
        factor if factor > 1.5 => Some(told("small")),
        factor if factor < 0.67 => Some(told("large")),
        _ => None,
    }
}

/// By which part the amplitude falls in a cycle, where that is so much that the period of single cycles, which the exact
/// law gives for a constant amplitude, says little.
fn strong_damping(answer: &Answer<'_>) -> Option<f64> {
    const STRONG: f64 = 0.1;
    answer.fall_in_a_cycle().filter(|&fall| fall > STRONG)
}

/// In place of what β and the periods of the cycles would say.
fn of_strong_damping(answer: &Answer<'_>) -> Option<String> {
    let fall = strong_damping(answer)?;
    let beta = answer.beta.as_ref().is_ok_and(|beta| beta.deviation() > SIGNIFICANT);
    (beta || other_period(answer).is_some()).then(|| {
        format!(
            "the amplitude falls by {} % in a cycle: with such strong damping the periods of single cycles follow the exact law \
             only roughly, so β means little; the fit of the whole motion is what counts",
            rounded(100.0 * fall, 2)
        )
    })
}

/// A β that the exact law does not explain, and neither strong damping, nor a scale that is fitted, nor radians
/// taken for degrees.
pub(super) fn doubtful_beta<'a>(answer: &'a Answer<'_>) -> Option<&'a Beta> {
    let beta = answer.beta.as_ref().ok().filter(|beta| beta.deviation() > SIGNIFICANT)?;
    let explained = answer.scale_is_fitted() || strong_damping(answer).is_some() || are_radians(answer);
    (!explained).then_some(beta)
}

fn of_beta(answer: &Answer<'_>) -> Option<String> {
    let beta = doubtful_beta(answer)?;
    let deviation = rounded(beta.deviation(), 2);
    let told = format!(
        "β is {deviation} standard uncertainties from 1: the period does not change with the amplitude as the exact law says"
    );
    Some(match beta.scale_error() {
        Some(part) => {
            let (percent, how) = (rounded(100.0 * part.abs(), 2), if part > 0.0 { "small" } else { "large" });
            format!("{told}. Angles measured {percent} % too {how} would do this")
        }
        None => {
            let (largest, smallest) = answer.amplitudes()?;
            let [largest, smallest] = [largest, smallest].map(|size| rounded(size.to_degrees(), 3));
            format!(
                "{told}. No scale of the angles is wrong by so much; with amplitudes from {largest}° to {smallest}° only, \
                 anything that changes the period in time looks like this"
            )
        }
    })
}

/// Whether single cycles and the whole motion agree about T0.
fn of_periods(answer: &Answer<'_>) -> Option<String> {
    let told = !answer.scale_is_fitted() && strong_damping(answer).is_none();
    let (t0, deviation) = other_period(answer).filter(|_| told)?;
    Some(format!(
        "T₀ by single cycles, {} s, is {} standard uncertainties from that of the whole motion, {} s",
        rounded(t0, 6),
        rounded(deviation, 2),
        rounded(answer.fit.small_angle_period().0, 6)
    ))
}

/// T0 by the cycles of a single trace, where it is not that of the whole motion, and by how many uncertainties.
fn other_period(answer: &Answer<'_>) -> Option<(f64, f64)> {
    /// Below this part the ways of measuring may differ.
    const WORTH_A_WORD: f64 = 1e-4;
    let [Ok(cycles)] = &answer.cycles[..] else { return None };
    let (period, uncertainty) = answer.fit.small_angle_period();
    let difference = (cycles.t0 - period).abs();
    let deviation = difference / cycles.t0_uncertainty.hypot(uncertainty);
    (deviation > SIGNIFICANT && difference > WORTH_A_WORD * period).then_some((cycles.t0, deviation))
}

/// Traces that are fitted as of one pendulum and are not.
fn of_different_pendulums(answer: &Answer<'_>) -> Option<String> {
    const APART: f64 = 0.01;
    let named = answer.measured.traces.iter().zip(&answer.cycles);
    let known: Vec<_> =
        named.filter_map(|(trace, found)| Some((trace.name(), found.as_ref().ok()?))).collect();
    let (name, short) = known.iter().min_by(|one, two| one.1.t0.total_cmp(&two.1.t0))?;
    let (other, long) = known.iter().max_by(|one, two| one.1.t0.total_cmp(&two.1.t0))?;
    let difference = long.t0 - short.t0;
    let apart = difference > SIGNIFICANT * short.t0_uncertainty.hypot(long.t0_uncertainty);
    (apart && difference > APART * short.t0).then(|| {
        format!(
            "the traces are not of one pendulum: by its cycles {name} has T₀ {} s, and {other} has {} s. Fit them one by one",
            rounded(short.t0, 5),
            rounded(long.t0, 5)
        )
    })
}

/// A pendulum that no one would build.
fn of_length(answer: &Answer<'_>) -> Option<String> {
    let Pendulum::Length { value, .. } = answer.pendulum else { return None };
    (!(0.01..=100.0).contains(&value)).then(|| {
        format!(
            "a simple pendulum with this period would be {} m long: check the unit of the times (--time-unit)",
            rounded(value, 2)
        )
    })
}

fn of_outliers(fit: &TraceFit) -> Option<String> {
    let outliers: usize = fit.traces.iter().map(|trace| trace.outliers.len()).sum();
    (outliers > 0).then(|| match outliers {
        1 => "1 row is an outlier, further than five robust standard deviations from the motion".to_owned(),
        many => {
            format!("{many} rows are outliers, further than five robust standard deviations from the motion")
        }
    })
}

fn of_cycles(answer: &Answer<'_>) -> Vec<String> {
    let alone = answer.cycles.len() == 1;
    let named = answer.measured.traces.iter().zip(&answer.cycles);
    let told = named.flat_map(|(trace, found)| {
        let words =
            found.as_ref().map_or_else(|error| vec![error.to_string()], |cycles| cycles.warnings.clone());
        let name = if alone { "cycles".to_owned() } else { format!("cycles of {}", trace.name()) };
        words.into_iter().map(move |text| format!("{name}: {text}"))
    });
    told.collect()
}

/// `dry`, `dry or linear`, `dry, linear or quadratic`.
pub(super) fn list(names: &[String]) -> String {
    match names {
        [all @ .., before, last] if !all.is_empty() => format!("{}, {before} or {last}", all.join(", ")),
        [before, last] => format!("{before} or {last}"),
        names => names.join(", "),
    }
}
