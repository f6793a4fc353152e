//! What the fields of a fit of periods mean.

use crate::output::budget_fields;
use crate::output::description::{Answers, Row, descriptions};

const JSON: &[Row] = &[
    ("rows", "1", "rows that were fitted"),
    ("rows_incomplete", "1", "rows left out because a number is missing"),
    ("told_from_file[]", "", "what was concluded from the file"),
    ("weighting", "", "what the rows are weighted by"),
    ("outlier_lines[]", "1", "lines of the file whose period is far from the exact law"),
    ("laws[].key", "", "law of the period: exact, constant, or a formula"),
    ("laws[].t0_s", "s", "period of small swings T₀ under this law"),
    ("laws[].t0_uncertainty_s", "s", "standard uncertainty of T₀"),
    ("laws[].chi2_per_dof", "1", "χ² per degree of freedom, or null"),
    ("laws[].rms_s", "s", "root mean square of the residuals"),
    ("warnings[]", "", "what is doubtful"),
    ("warning_kinds[]", "", "kind of each warning, in the same order"),
    ("beta", "1", "measured rise of the period with the amplitude over that of the exact law, 1 if it holds"),
    ("beta_uncertainty", "1", "standard uncertainty of β"),
    ("beta_uncertainty_scaled", "1", "that uncertainty enlarged by the scatter of the rows, or null"),
    ("gravity_m_per_s2", "m/s²", "acceleration of free fall, or null without a length"),
    ("gravity_uncertainty_m_per_s2", "m/s²", "standard uncertainty of gravity, or null"),
];

const CSV: &[Row] = &[
    ("key", "", "law of the period: exact, constant, or a formula"),
    ("t0_s", "s", "period of small swings T₀ under this law"),
    ("t0_uncertainty_s", "s", "standard uncertainty of T₀"),
    ("chi2_per_dof", "1", "χ² per degree of freedom"),
    ("rms_s", "s", "root mean square of the residuals"),
];

pub(crate) fn answers() -> Vec<Answers> {
    let json =
        [descriptions("", JSON), budget_fields::of_scatter("laws[]."), budget_fields::of_budget()].concat();
    vec![Answers { command: "fit periods", option: "", json, csv: descriptions("", CSV) }]
}
