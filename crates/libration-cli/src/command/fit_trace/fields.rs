//! What the fields of a fit of swings mean.

use crate::output::budget_fields;
use crate::output::description::{Answers, Description, Row, descriptions};

const FIT: &[Row] = &[
    ("files[]", "", "names of the files"),
    ("model", "", "damping that was fitted"),
    ("chi2_per_dof", "1", "χ² per degree of freedom, or null without uncertainties of the rows"),
    ("rms_residual_rad", "rad", "root mean square of the residuals, where angles were measured"),
    ("rms_residual_rad_per_s", "rad/s", "the same where angular velocities were measured"),
    ("rows", "1", "rows that were fitted"),
    ("converged", "", "whether the least sum of squares was reached"),
    ("small_angle_period_s", "s", "period of small swings T₀"),
    ("small_angle_period_uncertainty_s", "s", "standard uncertainty of T₀"),
    ("cycles[].time_s", "s", "time of the middle of the cycle"),
    ("cycles[].period_s", "s", "period of the cycle"),
    ("cycles[].amplitude_rad", "rad", "amplitude in its middle"),
    ("cycles[].period_uncertainty_s", "s", "standard uncertainty of the period"),
    ("cycles[].amplitude_uncertainty_rad", "rad", "standard uncertainty of the amplitude"),
    ("cycles[].outlier", "", "whether the period is far from the law"),
    ("cycles[].trace", "1", "number of the trace, from 0, where there are several"),
    ("beta", "1", "measured rise of the period with the amplitude over that of the exact law, or null"),
    ("beta_uncertainty", "1", "standard uncertainty of β, or null"),
    ("length_m", "m", "length of the pendulum that was given"),
    ("length_uncertainty_m", "m", "standard uncertainty of that length, or null"),
    ("gravity_m_per_s2", "m/s²", "acceleration of free fall, with a length"),
    ("gravity_uncertainty_m_per_s2", "m/s²", "standard uncertainty of gravity"),
    ("length_in_standard_gravity_m", "m", "length that the period has in standard gravity, without a length"),
    ("length_in_standard_gravity_uncertainty_m", "m", "standard uncertainty of that length"),
    ("warnings[]", "", "what is doubtful"),
    ("warning_kinds[]", "", "kind of each warning, in the same order"),
    ("advice[]", "", "what would make the answer better"),
    ("advice_kinds[]", "", "kind of each piece of advice, in the same order"),
    ("traces[].name", "", "name of the run"),
    ("traces[].rows", "1", "its rows"),
    ("traces[].first_s", "s", "time of its first row"),
    ("traces[].last_s", "s", "time of its last row"),
    ("traces[].rms_residual", "", "root mean square of its residuals, in rad or rad/s"),
    ("traces[].outlier_rows[]", "1", "rows beyond five robust standard deviations, numbered from 0"),
    ("traces[].t0_by_cycles_s", "s", "T₀ by the periods of its cycles, or null"),
    ("traces[].t0_by_cycles_uncertainty_s", "s", "standard uncertainty of that, or null"),
    ("traces[].beta", "1", "β of this trace, or null"),
    ("traces[].beta_uncertainty", "1", "standard uncertainty of that, or null"),
    ("findings[].file", "", "name of the file"),
    ("findings[].findings[]", "", "what was concluded from it"),
    ("correlations[][]", "1", "correlation coefficients of the parameters, in their order"),
    ("autocorrelation.is_noise", "", "whether the residuals look like white noise"),
    ("autocorrelation.correlation_time_rows", "1", "rows after which residuals are independent"),
    (
        "autocorrelation.excess",
        "1",
        "Ljung and Box's statistic less its mean for noise, over its standard deviation",
    ),
    (
        "autocorrelation.bootstrap_block_rows",
        "1",
        "rows of a block of the bootstrap, null where none was needed",
    ),
];

const PARAMETER: &[Row] = &[
    ("name", "", "name of the parameter"),
    ("value", "", "its value, in its unit"),
    ("uncertainty", "", "its standard uncertainty, in its unit"),
    ("unit", "", "its unit"),
    ("formal_uncertainty", "", "standard uncertainty as if residuals were independent, in its unit"),
    ("degrees_of_freedom", "1", "degrees of freedom of the uncertainty"),
    ("interval_68[]", "", "ends of the interval of 68 % confidence"),
    ("interval_95[]", "", "ends of the interval of 95 % confidence"),
];

const MODEL: &[Row] = &[
    ("model", "", "damping of the model"),
    ("standing", "", "preferred, tied, possible, negative, feeds_energy or excluded"),
    ("rms_residual", "", "root mean square of the residuals, in rad or rad/s"),
    ("excess_aicc", "1", "Akaike's criterion less the least of all models"),
    ("weight", "1", "weight in the averages"),
    ("independent_rows", "1", "rows that were counted as independent"),
    ("small_angle_period_s", "s", "period of small swings T₀ by this model"),
    ("small_angle_period_uncertainty_s", "s", "standard uncertainty of that"),
    (
        "takes_energy",
        "",
        "whether its damping takes energy at all speeds of the data, within two standard uncertainties",
    ),
    ("negative_terms[]", "", "damping terms with a negative coefficient"),
];

const AVERAGED: &[Row] = &[
    ("small_angle_period_s", "s", "T₀ over the models by their weights"),
    ("small_angle_period_s_uncertainty", "s", "its standard uncertainty, the spread of the models included"),
    ("small_angle_period_s_spread", "s", "spread of the models alone, as a standard deviation"),
    ("NAME", "", "parameter with this name over the models by their weights, in its unit"),
    ("NAME_uncertainty", "", "its standard uncertainty, the spread of the models included"),
    ("NAME_spread", "", "spread of the models alone, as a standard deviation"),
];

const CSV: &[Row] = &[
    ("trace", "", "name of the run"),
    ("time_s", "s", "time of the row"),
    ("value", "", "measured value, in rad or rad/s"),
    ("fitted", "", "value of the fitted motion"),
    ("residual", "", "measured minus fitted"),
];

pub(crate) fn answers() -> Vec<Answers> {
    let json = [
        descriptions("", FIT),
        descriptions("parameters[].", PARAMETER),
        vec![Description::new(
            "parameters[].trace",
            "1",
            "number of the trace it belongs to, from 0, if to one",
        )],
        descriptions("comparison[].", MODEL),
        descriptions("comparison[].coefficients[].", PARAMETER),
        descriptions("averaged.", AVERAGED),
        budget_fields::of_budget(),
    ];
    vec![Answers { command: "fit trace", option: "", json: json.concat(), csv: descriptions("", CSV) }]
}
