//! What the fields of a backbone mean.

use crate::output::description::{Answers, Row, descriptions};

const JSON: &[Row] = &[
    ("oscillator", "", "key of the oscillator, null where its equation was typed"),
    ("equation", "", "equation of motion"),
    ("parameters.NAME", "", "value of the parameter with this name, as text"),
    ("order", "1", "order of the perturbation series"),
    ("centre", "", "equilibrium that amplitudes are measured from"),
    (
        "centre_is_equilibrium",
        "",
        "whether it is one that the force drives back to; else amplitudes count from 0",
    ),
    ("omega0", "rad/s", "angular frequency of small oscillations, or null"),
    ("no_series", "", "why there is no series, or null"),
    ("series_radius", "", "amplitude below which the series converges"),
    ("series_radius_is", "", "proven or estimated"),
    ("interrupted", "", "true where Ctrl-C ended the work before the last amplitude, else left out"),
    ("points[].amplitude", "", "amplitude, in rad for angles"),
    ("points[].frequency", "rad/s", "angular frequency by the orbit, or null"),
    ("points[].uncertainty", "rad/s", "bound on the error of that frequency"),
    ("points[].other_turning_point", "", "displacement from the centre at the other turning point"),
    ("points[].encloses", "", "another equilibrium that the orbit goes around, or null"),
    ("points[].no_orbit", "", "why there is no orbit"),
    ("points[].series", "rad/s", "angular frequency by the perturbation series, or null"),
    (
        "points[].series_remainder",
        "rad/s",
        "bound on what the series leaves out, or an estimate of it; or null",
    ),
    ("points[].series_remainder_is", "", "proven or estimated"),
    ("points[].exact", "rad/s", "angular frequency of the pendulum by elliptic integrals, else null"),
    ("points[].exact_uncertainty", "rad/s", "bound on the error of that frequency"),
];

const CSV: &[Row] = &[
    ("amplitude", "", "amplitude, in rad for angles"),
    ("frequency", "rad/s", "angular frequency by the orbit"),
    ("uncertainty", "rad/s", "bound on the error of that frequency"),
    ("other_turning_point", "", "displacement from the centre at the other turning point"),
    ("series", "rad/s", "angular frequency by the perturbation series"),
    ("exact", "rad/s", "angular frequency of the pendulum by elliptic integrals"),
    ("exact_uncertainty", "rad/s", "bound on the error of that frequency"),
];

pub(crate) fn answers() -> Vec<Answers> {
    let (json, csv) = (descriptions("", JSON), descriptions("", CSV));
    vec![Answers { command: "backbone", option: "", json, csv }]
}
