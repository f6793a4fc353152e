//! What the fields mean that all fits of gravity have: the budget, the inputs, the scatter.

use super::description::{Description, Row, descriptions};

const BUDGET: &[Row] = &[
    ("name", "", "effect"),
    ("formula", "", "formula of the correction"),
    ("correction", "1", "fractional correction of gravity that was applied, or null"),
    ("usual_size", "1", "size that the correction usually has, where it was not applied, or null"),
    ("uncertainty_m_per_s2", "m/s²", "standard uncertainty of gravity by this effect, or null"),
    ("type", "", "A where it comes from the scatter of measurements, B from what is known otherwise"),
    ("with", "", "values that the correction was computed with"),
];

const COMBINED: &[Row] = &[
    ("gravity_expanded_uncertainty_m_per_s2", "m/s²", "expanded uncertainty of gravity"),
    ("coverage_probability", "1", "probability that gravity is within the expanded uncertainty"),
    ("coverage_factor", "1", "expanded uncertainty over the standard one"),
    (
        "effective_degrees_of_freedom",
        "1",
        "degrees of freedom of the standard uncertainty, null where they are infinite",
    ),
    ("share_of_correlations", "1", "share of the variance of gravity that correlations make"),
    ("budget_inputs[].input", "", "name of the input quantity x"),
    ("budget_inputs[].value", "", "value of the input, in its unit"),
    ("budget_inputs[].unit", "", "unit of the input"),
    ("budget_inputs[].uncertainty", "", "standard uncertainty u(x), in the same unit, or null"),
    ("budget_inputs[].sensitivity", "", "sensitivity coefficient ∂g/∂x"),
    ("budget_inputs[].sensitivity_unit", "", "unit of the sensitivity coefficient"),
    (
        "budget_inputs[].contribution_m_per_s2",
        "m/s²",
        "change of gravity by one standard uncertainty of the input",
    ),
    ("budget_inputs[].share", "1", "share of the variance of gravity that the input makes by itself"),
    (
        "budget_inputs[].type",
        "",
        "A where its uncertainty comes from the scatter of measurements, B from what is known otherwise",
    ),
    ("budget_inputs[].degrees_of_freedom", "1", "degrees of freedom of u(x), null where they are infinite"),
];

const CORRELATIONS: &[Row] = &[
    ("budget_correlations[].between[]", "", "names of two inputs that are correlated"),
    ("budget_correlations[].coefficient", "1", "their correlation coefficient"),
];

const SCATTER: &[Row] = &[
    ("birge_ratio", "1", "√(χ²/dof): the scatter of the rows over what was stated, or null"),
    ("uncertainties_enlarged_by", "1", "factor by which the scatter enlarged the uncertainties"),
];

/// The effects, their inputs, and which of these are correlated.
pub(crate) fn of_budget() -> Vec<Description> {
    let effects = descriptions("budget[].", BUDGET);
    [effects, descriptions("", COMBINED), descriptions("", CORRELATIONS)].concat()
}

/// The inputs alone, none of which are correlated.
pub(crate) fn of_independent_inputs() -> Vec<Description> {
    const NONE: Row = ("budget_correlations[]", "", "empty, as the inputs are independent");
    [descriptions("", COMBINED), descriptions("", &[NONE])].concat()
}

/// At `place`, such as `laws[].` or nothing.
pub(crate) fn of_scatter(place: &str) -> Vec<Description> {
    descriptions(place, SCATTER)
}
