//! What the fields of normal modes mean.

use crate::output::description::{Answers, Row, descriptions};

const JSON: &[Row] = &[
    ("system", "", "key of the system, null where its equations were typed"),
    ("equations[]", "", "equations of motion as they were understood"),
    ("parameters.NAME", "", "value of the parameter with this name, as text"),
    ("coordinates[]", "", "names of the coordinates"),
    ("equilibrium[]", "", "coordinates of the equilibrium, in the order of the names"),
    ("exact_equilibrium[]", "", "the same as fractions, or null"),
    ("modes[].behaviour", "", "oscillating, free, unstable or damped"),
    ("modes[].frequency", "rad/s", "angular frequency ω of small oscillations"),
    ("modes[].growth", "1/s", "rate of growth, negative where it decays"),
    ("modes[].frequency_squared", "", "ω² as a fraction or with a square root, or null"),
    ("modes[].exact_frequency", "", "ω with square roots, or null"),
    ("modes[].shape[]", "", "displacements of the coordinates, the largest 1, real part"),
    ("modes[].shape_imaginary[]", "", "their imaginary parts, of damped modes"),
    ("modes[].exact_shape[]", "", "displacements as fractions or with square roots, or null"),
    ("modes[].multiplicity", "1", "number of modes with this frequency"),
    ("modes[].resonances[].with_mode", "1", "number of the other mode, from 1"),
    ("modes[].resonances[].multiple", "1", "whole number that the faster frequency is of the slower one"),
    ("modes[].resonances[].other_is_faster", "", "whether the other mode is the faster one"),
    ("modes[].resonances[].exact", "", "whether the ratio is exact"),
    ("modes[].resonances[].detuning", "1", "faster frequency over the multiple of the slower one, minus 1"),
    ("modes[].shift", "", "κ in Ω = ω + κa², with a the amplitude of the largest displacement, or null"),
    ("modes[].exact_relative_shift", "", "κ/ω as a fraction or with square roots, or null"),
    ("modes[].no_shift", "", "why no κ is given, or null"),
];

const CSV: &[Row] = &[
    ("mode", "1", "number of the mode, from 1"),
    ("behaviour", "", "oscillating, free, unstable or damped"),
    ("frequency", "rad/s", "angular frequency ω of small oscillations"),
    ("growth", "1/s", "rate of growth, negative where it decays"),
    ("exact_frequency", "", "ω with square roots, or empty"),
    ("shape_NAME", "", "displacement of the coordinate with this name, the largest 1, real part"),
    ("shift", "", "κ in Ω = ω + κa², with a the amplitude of the largest displacement, or empty"),
];

pub(crate) fn answers() -> Vec<Answers> {
    let (json, csv) = (descriptions("", JSON), descriptions("", CSV));
    vec![Answers { command: "modes", option: "", json, csv }]
}
