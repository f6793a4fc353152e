//! What the fields of a fit of lengths mean.

use crate::output::budget_fields;
use crate::output::description::{Answers, Row, descriptions};

const JSON: &[Row] = &[
    ("rows", "1", "rows that were fitted"),
    ("rows_incomplete", "1", "rows left out because a number is missing"),
    ("told_from_file[]", "", "what was concluded from the file"),
    ("weighting", "", "what the rows are weighted by"),
    ("law", "", "law that the data prefer, which gravity is from"),
    ("gravity_m_per_s2", "m/s²", "acceleration of free fall"),
    ("gravity_uncertainty_m_per_s2", "m/s²", "standard uncertainty of gravity"),
    ("offset_m", "m", "length to be added to all measured ones, or null"),
    ("offset_uncertainty_m", "m", "standard uncertainty of that length, or null"),
    ("laws[].law", "", "what is free in this law beside gravity"),
    ("laws[].g_m_per_s2", "m/s²", "acceleration of free fall under this law"),
    ("laws[].g_uncertainty_m_per_s2", "m/s²", "standard uncertainty of that"),
    ("laws[].offset_m", "m", "length to be added to all measured ones, or null"),
    ("laws[].offset_uncertainty_m", "m", "standard uncertainty of that length, or null"),
    ("laws[].gyration_m2", "m²", "square of the radius of gyration of the bob, or null"),
    ("laws[].gyration_uncertainty_m2", "m²", "standard uncertainty of that, or null"),
    ("laws[].correlation_of_g_and_offset", "1", "correlation coefficient of gravity and offset, or null"),
    ("laws[].chi2_per_dof", "1", "χ² per degree of freedom, or null"),
    ("laws[].dof", "1", "degrees of freedom"),
    ("laws[].aicc", "1", "Akaike's criterion, corrected for few rows, or null"),
    (
        "laws[].chance_of_last_parameter",
        "1",
        "probability that chance makes the last free parameter as large if it is zero, or null",
    ),
    ("warnings[]", "", "what is doubtful"),
    ("warning_kinds[]", "", "kind of each warning, in the same order"),
];

const CSV: &[Row] = &[
    ("law", "", "what is free in this law beside gravity"),
    ("g_m_per_s2", "m/s²", "acceleration of free fall under this law"),
    ("g_uncertainty_m_per_s2", "m/s²", "standard uncertainty of that"),
    ("offset_m", "m", "length to be added to all measured ones"),
    ("offset_uncertainty_m", "m", "standard uncertainty of that length"),
    ("chi2_per_dof", "1", "χ² per degree of freedom"),
    ("aicc", "1", "Akaike's criterion, corrected for few rows"),
];

pub(crate) fn answers() -> Vec<Answers> {
    let json = [
        descriptions("", JSON),
        budget_fields::of_scatter("laws[]."),
        budget_fields::of_scatter(""),
        budget_fields::of_independent_inputs(),
    ];
    vec![Answers { command: "fit lengths", option: "", json: json.concat(), csv: descriptions("", CSV) }]
}
