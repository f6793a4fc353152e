//! Fields of the times of a photogate, and of each cycle.

use crate::call::in_words;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::normal_gravity::{self, NormalGravity};
use crate::output::warnings::{self, NamedWarning};
use crate::output::{budget, json};
use libration::quantity::Quantity;
use libration_lab::fit::Budget;
use libration_lab::fit::gates::{GateCycle, GatesFit, T0Source};

/// The result for the times.
pub(super) struct FitGatesResult<'a> {
    pub(super) fit: &'a GatesFit,
    /// Budget with the length.
    pub(super) budget: Option<(&'a Budget, Quantity)>,
    pub(super) normal: Option<NormalGravity>,
    pub(super) findings: Vec<String>,
    pub(super) incomplete: usize,
}

impl FitGatesResult<'_> {
    /// The warnings with their stable names.
    pub(super) fn warnings(&self) -> Vec<NamedWarning> {
        let of_times = self.fit.warnings.iter().map(|warning| (warning.name(), warning.to_string()));
        of_times.chain(self.budget.into_iter().flat_map(|(budget, _)| budget::warnings(budget))).collect()
    }

    pub(super) fn source(&self) -> &'static str {
        match self.fit.t0_source {
            Some(T0Source::Speeds) => "the speeds at the gate",
            Some(T0Source::FirstAmplitude) => "the amplitude of the release",
            None => "nothing",
        }
    }
}

/// The fields before the budget.
pub(super) fn of_answer<'a>() -> Fields<FitGatesResult<'a>> {
    type Of<'a> = Field<FitGatesResult<'a>>;
    Fields::from([
        Of::value("passages", "1", "passages of the bob", |result| result.fit.passages.into()),
        Of::value("edges", "", "true if the times are edges, two for each passage", |result| {
            result.fit.edges.into()
        }),
        Of::value("unpaired_edges", "1", "edges without a partner", |result| result.fit.unpaired.into()),
        Of::value("double_triggers", "1", "passages too close to others, left out", |result| {
            result.fit.double_triggers.into()
        }),
        Of::value("missed_passages", "1", "passages that were not recorded", |result| {
            result.fit.missed.into()
        }),
        Of::value("rows_incomplete", "1", "rows left out because a number is missing", |result| {
            result.incomplete.into()
        }),
        Of::number(
            "part_between_passages",
            "1",
            "fraction of a period from a passage of the first side to one of the other, 0.5 at the centre",
            |result| result.fit.part_between,
        ),
        Of::known(
            "timing_s",
            "s",
            "standard deviation of a time, by the scatter of the times, or null",
            |result| result.fit.timing.ok_or_else(|| "more passages are needed".to_owned()),
        ),
        Of::number("mean_period_s", "s", "mean of all periods", |result| result.fit.mean_period.value),
        Of::number("mean_period_uncertainty_s", "s", "standard uncertainty of that mean", |result| {
            result.fit.mean_period.uncertainty
        }),
        Of::known("t0_s", "s", "period of small swings T₀, or null", |result| {
            result.fit.t0.map(|t0| t0.value).ok_or_else(no_t0)
        }),
        Of::known("t0_uncertainty_s", "s", "standard uncertainty of T₀, or null", |result| {
            result.fit.t0.map(|t0| t0.uncertainty).ok_or_else(no_t0)
        }),
        Of::value("t0_by", "", "source of the amplitude used for T₀", |result| result.source().into()),
        Of::known(
            "beta",
            "1",
            "measured rise of the period with the amplitude over that of the exact law, or null",
            |result| result.fit.beta.map(|beta| beta.factor.value).ok_or_else(no_beta),
        ),
        Of::known("beta_uncertainty", "1", "standard uncertainty of β, or null", |result| {
            result.fit.beta.map(|beta| beta.factor.uncertainty).ok_or_else(no_beta)
        }),
        Of::known(
            "gravity_m_per_s2",
            "m/s²",
            "acceleration of free fall, or null without a length",
            |result| result.budget.map(|(budget, _)| budget.g).ok_or_else(no_gravity),
        ),
        Of::known(
            "gravity_uncertainty_m_per_s2",
            "m/s²",
            "standard uncertainty of gravity, or null",
            |result| result.budget.map(|(budget, _)| budget.uncertainty).ok_or_else(no_gravity),
        ),
    ])
}

fn no_t0() -> String {
    "give the amplitude of the first swing, or the length and the diameter of the bob".to_owned()
}

fn no_beta() -> String {
    "amplitudes by the speed at the gate are needed, which fall".to_owned()
}

fn no_gravity() -> String {
    in_words("give <--length>, and what determines T0, to obtain gravity")
}

/// The fields after the budget.
pub(super) fn of_cycles<'a>() -> Fields<FitGatesResult<'a>> {
    type Of<'a> = Field<FitGatesResult<'a>>;
    let warnings = warnings::fields(
        |result: &FitGatesResult<'a>| warnings::texts(result.warnings()),
        |result| warnings::names(result.warnings()),
    );
    Fields::from([
        Of::nested("cycles[].", &of_cycle(), |result| of_cycle().records(&result.fit.cycles)),
        Of::value("told_from_file[]", "", "settings inferred from the file", |result| {
            json::list(result.findings.clone())
        }),
    ])
    .and(warnings)
}

pub(super) fn of_cycle() -> Fields<GateCycle> {
    type Of = Field<GateCycle>;
    Fields::from([
        Of::number("time_s", "s", "time of the middle of the cycle", |cycle| cycle.time),
        Of::number("period_s", "s", "time between passages of the same side", |cycle| cycle.period),
        Of::value("side", "1", "0 where the cycle begins like the first passage, else 1", |cycle| {
            cycle.side.into()
        }),
        Of::nullable("amplitude_rad", "rad", "amplitude by the speed at the gate, or null", |cycle| {
            cycle.amplitude
        }),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [
        of_answer().described(""),
        normal_gravity::fields().described(""),
        budget::described(),
        of_cycles().described(""),
    ]
    .concat();
    vec![Answers { command: "fit gates", option: "", json, csv: of_cycle().described_in_csv() }]
}
