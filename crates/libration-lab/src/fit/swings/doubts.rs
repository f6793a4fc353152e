//! Conditions of the warnings about swings.

use super::{FittedPendulum, SwingsFit, Warning};
use crate::fit::angle_unit::MistakenUnit;
use crate::fit::budget::BudgetWarning;
use crate::fit::contradiction::Contradiction;
use crate::fit::cycles::{Coefficient, Cycles, CyclesError};
use crate::fit::significance::combined_degrees_of_freedom;
use crate::fit::significance::{SIGNIFICANT, limit_of_chance};
use crate::fit::trace::{Comparison, DampingKind, TraceFit};
use crate::measurement::{FittedPivot, Trace};

/// The warnings, the gravest first.
pub(super) fn warnings(analysis: &SwingsFit, traces: &[Trace]) -> Vec<Warning> {
    let fit = &analysis.fit;
    let budget: Vec<BudgetWarning> = match &analysis.pendulum {
        FittedPendulum::Gravity { budget, .. } => budget.warnings(),
        FittedPendulum::Length(_) => vec![],
    };
    let mut warnings: Vec<Warning> = (!fit.converged).then_some(Warning::NotConverged).into_iter().collect();
    warnings.extend(mistaken_unit(analysis));
    warnings.extend(refuted(analysis));
    warnings.extend(pivot(traces));
    warnings.extend(budget.into_iter().map(Warning::Budget));
    warnings.extend(analysis.is_poor().then(|| Warning::PoorFit { part: fit.unexplained.sqrt() }));
    warnings.extend((!fit.dissipates()).then_some(Warning::FeedsEnergy { damping: fit.damping }));
    warnings.extend(negative_damping(fit));
    warnings.extend(analysis.comparison.iter().flat_map(better_models));
    warnings.extend(rivals(analysis));
    warnings.extend(residuals(fit));
    warnings.extend(stated_uncertainties(fit));
    warnings.extend(strong_damping(analysis));
    warnings.extend(beta(analysis));
    warnings.extend(periods(analysis));
    warnings.extend(different_pendulums(analysis, traces));
    warnings.extend(implausible_length(&analysis.pendulum));
    warnings.extend(outliers(fit));
    warnings.extend(cycles(analysis, traces));
    warnings
}

fn mistaken_unit(analysis: &SwingsFit) -> Option<Warning> {
    let beta = analysis.beta.as_ref().ok()?.factor.value;
    Some(match analysis.mistaken_unit()? {
        MistakenUnit::Radians => Warning::AnglesAreRadians { beta },
        MistakenUnit::Degrees => Warning::AnglesAreDegrees { beta },
    })
}

/// Warns of a refuted model, where a strong damping does not explain the contradiction.
fn refuted(analysis: &SwingsFit) -> Option<Warning> {
    analysis.contradiction.clone().filter(Contradiction::refutes).map(Warning::ModelRefuted)
}

/// Warns of the first pivot that contradicts the positions.
fn pivot(traces: &[Trace]) -> Option<Warning> {
    let mut pivots = traces.iter().filter_map(Trace::fitted_pivot);
    let contradicted = |pivot: &FittedPivot| {
        Some(Warning::PivotContradicted { given: pivot.position, fitted: pivot.contradicted_by? })
    };
    pivots.find_map(contradicted)
}

fn negative_damping(fit: &TraceFit) -> Option<Warning> {
    let coefficient =
        |term: DampingKind| Some(Coefficient { term, estimate: fit.damping_coefficient(term)?.estimate });
    let coefficients: Vec<Coefficient> = fit.negative_terms().into_iter().filter_map(coefficient).collect();
    (!coefficients.is_empty()).then_some(Warning::NegativeDamping { coefficients })
}

fn better_models(comparison: &Comparison) -> Vec<Warning> {
    let doubt = |(fit, excess): (&TraceFit, f64)| Warning::BetterModelNotBelieved {
        damping: fit.damping,
        excess,
        negative: fit.negative_terms().first().copied(),
    };
    comparison.better().map(doubt).collect()
}

fn rivals(analysis: &SwingsFit) -> Option<Warning> {
    let rivals = analysis.rivals();
    let preferred = analysis.fit.damping;
    (!rivals.is_empty()).then_some(Warning::DampingNotSeparated { preferred, rivals })
}

fn residuals(fit: &TraceFit) -> Option<Warning> {
    let omega0 = &fit.parameters[0];
    (!fit.autocorrelation.is_noise()).then(|| Warning::ResidualsNotNoise {
        rows: fit.autocorrelation.time,
        inflation: omega0.estimate.uncertainty / omega0.formal_uncertainty,
    })
}

fn stated_uncertainties(fit: &TraceFit) -> Option<Warning> {
    /// Half as much again, and two thirds: with fifty rows the ratio varies by a tenth.
    const AS_STATED: std::ops::RangeInclusive<f64> = 0.67..=1.5;
    let ratio = fit.chi2_per_dof?.sqrt();
    (!AS_STATED.contains(&ratio)).then_some(Warning::StatedUncertainties { ratio })
}

fn strong_damping(analysis: &SwingsFit) -> Option<Warning> {
    let fall = analysis.strong_damping()?;
    let beta = analysis.beta.as_ref().is_ok_and(|beta| beta.differs_from_one());
    (beta || analysis.other_period().is_some()).then_some(Warning::StrongDamping { fall })
}

fn beta(analysis: &SwingsFit) -> Option<Warning> {
    let beta = analysis.doubtful_beta()?;
    let (deviation, scale_error) = (beta.deviation(), beta.scale_error());
    Some(Warning::BetaNotOne { deviation, scale_error, amplitudes: analysis.amplitudes()? })
}

fn periods(analysis: &SwingsFit) -> Option<Warning> {
    let is_meant = !analysis.scale_is_fitted() && analysis.strong_damping().is_none();
    let (by_cycles, deviation) = analysis.other_period().filter(|_| is_meant)?;
    let by_motion = analysis.fit.small_angle_period().value;
    Some(Warning::PeriodsDisagree { by_cycles, by_motion, deviation })
}

/// Warns of traces that are fitted as those of one pendulum but belong to several.
fn different_pendulums(analysis: &SwingsFit, traces: &[Trace]) -> Option<Warning> {
    /// Relative difference of T0, for the reason in [`Warning::DifferentPendulums`].
    const APART: f64 = 0.01;
    let measured: Vec<(&Trace, &Cycles)> = traces
        .iter()
        .zip(&analysis.cycles)
        .filter_map(|(trace, cycles)| Some((trace, cycles.as_ref().ok()?)))
        .collect();
    let (one, short) = measured.iter().min_by(|a, b| a.1.t0.value.total_cmp(&b.1.t0.value))?;
    let (other, long) = measured.iter().max_by(|a, b| a.1.t0.value.total_cmp(&b.1.t0.value))?;
    let difference = long.t0.value - short.t0.value;
    let errors = [short, long].map(|fit| (fit.t0.uncertainty, fit.t0_degrees_of_freedom));
    let limit = limit_of_chance(SIGNIFICANT, combined_degrees_of_freedom(&errors));
    let by_chance = limit * libm::hypot(short.t0.uncertainty, long.t0.uncertainty);
    (difference > by_chance && difference > APART * short.t0.value).then(|| Warning::DifferentPendulums {
        shortest: (one.name().to_owned(), short.t0.value),
        longest: (other.name().to_owned(), long.t0.value),
    })
}

fn implausible_length(pendulum: &FittedPendulum) -> Option<Warning> {
    /// Plausible lengths in m, for the reason in [`Warning::ImplausibleLength`].
    const BUILT: std::ops::RangeInclusive<f64> = 0.01..=100.0;
    let FittedPendulum::Length(length) = pendulum else { return None };
    (!BUILT.contains(&length.value)).then_some(Warning::ImplausibleLength { length: length.value })
}

fn outliers(fit: &TraceFit) -> Option<Warning> {
    let rows = fit.traces.iter().map(|trace| trace.outliers.len()).sum();
    (rows > 0).then_some(Warning::Outliers { rows })
}

fn cycles(analysis: &SwingsFit, traces: &[Trace]) -> Vec<Warning> {
    let several = traces.len() > 1;
    let name = |trace: &Trace| several.then(|| trace.name().to_owned());
    let of_trace = |(trace, cycles): (&Trace, &Result<Cycles, CyclesError>)| match cycles {
        Ok(cycles) => {
            let doubt = |&warning| Warning::Cycles { trace: name(trace), warning };
            cycles.warnings.iter().map(doubt).collect()
        }
        Err(error) => vec![Warning::NoCycles { trace: name(trace), error: error.clone() }],
    };
    traces.iter().zip(&analysis.cycles).flat_map(of_trace).collect::<Vec<_>>()
}
