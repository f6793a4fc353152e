//! What the fields of an expansion mean, and those of a series in numbers.

use crate::output::description::{Answers, Row, descriptions};

const SERIES: &[Row] = &[
    ("oscillator", "", "key of the oscillator, null where its equation was typed"),
    ("equation", "", "equation of motion"),
    ("parameters.NAME", "", "value of the parameter with this name, as text"),
    ("order", "1", "highest power of the expansion"),
    ("gauge", "", "what the expansion parameter means, null for the strength of a self-excited oscillator"),
    ("variable", "", "name of the expansion parameter"),
    ("precision", "", "`exact`, or to how many digits the coefficients are known"),
    ("equilibrium", "", "equilibrium x₀ about which it oscillates"),
    ("omega0_squared", "", "square of the angular frequency ω0 of small oscillations"),
    ("frequency_ratio[]", "", "coefficients of the frequency over ω0, by powers of the expansion parameter"),
    (
        "harmonics.K.cos[]",
        "",
        "coefficients of cos Kτ in the displacement, by powers of the expansion parameter; τ = Ωt",
    ),
    ("harmonics.K.sin[]", "", "those of sin Kτ"),
    ("unit_squared", "", "square of the unit that harmonics and turning points are measured in"),
    ("x_max[]", "", "coefficients of the upper turning point"),
    ("x_min[]", "", "coefficients of the lower turning point"),
    ("of_amplitude.frequency_ratio[]", "", "coefficients of the frequency over ω0, by powers of x_max"),
    ("of_amplitude.period_ratio[]", "", "coefficients of the period times ω0/2π, by powers of x_max"),
    ("of_amplitude.epsilon[]", "", "coefficients of the expansion parameter, by powers of x_max"),
    ("of_amplitude.harmonics.K.cos[]", "", "coefficients of cos Kτ in the displacement, by powers of x_max"),
    ("of_amplitude.harmonics.K.sin[]", "", "those of sin Kτ"),
    (
        "of_half_swing.frequency_ratio[]",
        "",
        "coefficients of the frequency over ω0, by powers of half the swing",
    ),
    (
        "of_half_swing.period_ratio[]",
        "",
        "coefficients of the period times ω0/2π, by powers of half the swing",
    ),
    ("of_half_swing.epsilon[]", "", "coefficients of the expansion parameter, by powers of half the swing"),
    (
        "of_half_swing.harmonics.K.cos[]",
        "",
        "coefficients of cos Kτ in the displacement, by powers of half the swing",
    ),
    ("of_half_swing.harmonics.K.sin[]", "", "those of sin Kτ"),
    ("certified", "", "whether an independent exact computation proves the coefficients"),
    ("certificate", "", "the check that was made"),
    ("interrupted", "", "true where Ctrl-C ended the work before the order asked for, else left out"),
];

const SERIES_CSV: &[Row] = &[
    ("quantity", "", "what is expanded"),
    ("variable", "", "in powers of what"),
    ("power", "1", "power"),
    ("coefficient", "", "coefficient of that power, a fraction or a decimal"),
];

const NUMBERS: &[Row] = &[
    ("oscillator", "", "key of the oscillator, null where its equation was typed"),
    ("equation", "", "equation of motion"),
    ("order", "1", "highest power of the expansion"),
    ("quantity", "", "quantity whose series is evaluated"),
    ("amplitude_is", "", "what the series is in powers of"),
    ("amplitude", "", "its value, in rad for angles"),
    ("exact", "", "value of the quantity by another road, or null"),
    ("exact_uncertainty", "", "bound on the error of that value"),
    ("exact_by", "", "the other road: elliptic integrals, or integration of the equation of motion"),
    ("encloses", "", "another equilibrium that the orbit goes around, or null"),
    ("radius", "", "radius of convergence, or null"),
    ("radius_is", "", "proven or estimated, or null"),
    ("smallest_term_power", "1", "power of the smallest term, where a divergent series is best cut off"),
    ("steps[].power", "1", "power of the term"),
    ("steps[].coefficient", "", "its coefficient, a fraction or a decimal"),
    ("steps[].term", "", "the term"),
    ("steps[].sum", "", "sum up to it"),
    ("steps[].error", "", "that sum minus the exact value, or null"),
    ("steps[].bound", "", "bound on what is left out, or an estimate of it"),
    ("steps[].bound_is", "", "proven or estimated"),
    ("pade[].degrees[]", "1", "degrees of numerator and denominator of the Padé approximant"),
    ("pade[].value", "", "its value"),
    ("pade[].error", "", "its value minus the exact one, or null"),
    (
        "pade[].pole_before",
        "",
        "place of a pole between zero and the amplitude, which makes the value worthless, or null",
    ),
    (
        "terms_needed.TOLERANCE",
        "1",
        "terms beyond the first until the remainder stays below this fraction of the sum, or null",
    ),
    ("interrupted", "", "true where Ctrl-C ended the work before all was known, else left out"),
];

const NUMBERS_CSV: &[Row] = &[
    ("power", "1", "power of the term"),
    ("coefficient", "", "its coefficient, a fraction or a decimal"),
    ("term", "", "the term"),
    ("sum", "", "sum up to it"),
    ("error", "", "that sum minus the exact value"),
    ("bound", "", "bound on what is left out, or an estimate of it"),
    ("bound_is", "", "proven or estimated"),
];

pub(crate) fn answers() -> Vec<Answers> {
    let kind = |option, json, csv| Answers {
        command: "expand",
        option,
        json: descriptions("", json),
        csv: descriptions("", csv),
    };
    vec![kind("", SERIES, SERIES_CSV), kind("--evaluate", NUMBERS, NUMBERS_CSV)]
}
