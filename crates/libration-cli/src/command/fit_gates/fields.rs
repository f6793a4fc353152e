//! What the fields of a fit of gate times mean.

use crate::output::budget_fields;
use crate::output::description::{Answers, Row, descriptions};

const JSON: &[Row] = &[
    ("passages", "1", "passages of the bob"),
    ("edges", "", "whether the times are edges, two for each passage"),
    ("unpaired_edges", "1", "edges whose other one is missing"),
    ("double_triggers", "1", "passages too close to others, left out"),
    ("missed_passages", "1", "passages that should have been seen"),
    ("rows_incomplete", "1", "rows left out because a number is missing"),
    (
        "part_between_passages",
        "1",
        "part of a period from a passage of the first side to the other, 0.5 at the centre",
    ),
    ("timing_s", "s", "standard deviation of a time, by the scatter of the periods"),
    ("mean_period_s", "s", "mean of all periods"),
    ("mean_period_uncertainty_s", "s", "standard uncertainty of that mean"),
    ("t0_s", "s", "period of small swings T₀, or null"),
    ("t0_uncertainty_s", "s", "standard uncertainty of T₀, or null"),
    ("t0_by", "", "what amplitude T₀ was found by"),
    ("beta", "1", "measured rise of the period with the amplitude over that of the exact law, or null"),
    ("beta_uncertainty", "1", "standard uncertainty of β, or null"),
    ("gravity_m_per_s2", "m/s²", "acceleration of free fall, or null without a length"),
    ("gravity_uncertainty_m_per_s2", "m/s²", "standard uncertainty of gravity, or null"),
    ("cycles[].time_s", "s", "time of the middle of the cycle"),
    ("cycles[].period_s", "s", "time between passages of the same side"),
    ("cycles[].side", "1", "0 where the cycle begins like the first passage, else 1"),
    ("cycles[].amplitude_rad", "rad", "amplitude by the speed at the gate, or null"),
    ("told_from_file[]", "", "what was concluded from the file"),
    ("warnings[]", "", "what is doubtful"),
    ("warning_kinds[]", "", "kind of each warning, in the same order"),
];

const CSV: &[Row] = &[
    ("time_s", "s", "time of the middle of the cycle"),
    ("period_s", "s", "time between passages of the same side"),
    ("side", "1", "0 where the cycle begins like the first passage, else 1"),
    ("amplitude_rad", "rad", "amplitude by the speed at the gate, or empty"),
];

pub(crate) fn answers() -> Vec<Answers> {
    let json = [descriptions("", JSON), budget_fields::of_budget()].concat();
    vec![Answers { command: "fit gates", option: "", json, csv: descriptions("", CSV) }]
}
