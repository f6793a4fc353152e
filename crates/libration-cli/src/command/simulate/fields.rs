//! What the fields of a simulated motion mean.

use crate::output::description::{Answers, Row, descriptions};

const JSON: &[Row] = &[
    ("system", "", "key of the system, or its equations as they were understood"),
    ("equations", "", "equations of motion with the values of all parameters"),
    ("parameters.NAME", "", "value of the parameter with this name, in its unit"),
    ("state[]", "", "names of the numbers of the state"),
    ("samples[].time", "s", "time of the sample"),
    ("samples[].state[]", "", "state then, in the order of the names"),
    ("events[].time", "s", "time of the event"),
    ("events[].kind", "", "event that was asked for, and how it touched zero if not by passing it"),
    ("events[].state[]", "", "state then, in the order of the names"),
    ("energy_drift", "1", "largest change of a conserved energy over the largest kinetic energy, or null"),
    ("energy_drift_uncertainty", "1", "how well the drift is known, by the work of the forces, or null"),
    ("steps", "1", "steps of the integration"),
    ("interrupted", "", "true where Ctrl-C ended the run early, else left out"),
    ("stopped", "", "why the integration ended before the last time, else left out"),
    ("resume.question.system", "", "what --resume compares: key of the system, or null"),
    ("resume.question.equations", "", "equations of motion with the values of all parameters"),
    ("resume.question.state[]", "", "names of the numbers of the state"),
    ("resume.question.initial[]", "", "state at t = 0"),
    ("resume.question.tolerance", "1", "relative error allowed in each step"),
    ("resume.question.events[]", "", "events that are looked for"),
    ("resume.known.time", "s", "time of the checkpoint that --resume goes on from"),
    ("resume.known.state[][]", "", "state there, each number as the sum of two"),
    ("resume.known.unit", "s", "unit of time of the series of the next step"),
    ("resume.known.absolute_values[][]", "", "sign, sticking and leading zeros of each absolute value"),
    ("resume.known.event_formulas[][]", "", "side of zero, last zero and nearness to zero of each event"),
    ("resume.known.steps", "1", "steps until there"),
    ("resume.known.samples", "1", "samples until there"),
    ("resume.known.events", "1", "events until there"),
    ("resume.known.bytes", "1", "bytes of the CSV file until there"),
    ("resume.known.checksum", "", "checksum of those bytes, in hexadecimal digits"),
    ("resume.known.energy.start[]", "", "state where the account of the energy begins"),
    ("resume.known.energy.last[]", "", "state where it stands"),
    ("resume.known.energy.potential[]", "", "potential energy gained until there, as the sum of two numbers"),
    ("resume.known.energy.missed", "", "bound on the error of that potential energy beyond roundings"),
    ("resume.known.energy.largest_change", "", "largest change of the energy since the start"),
    ("resume.known.energy.largest_kinetic", "", "largest kinetic energy"),
];

const CSV: &[Row] = &[
    ("time", "s", "time of the sample or event"),
    ("NAME", "", "number of the state with this name"),
    ("event", "", "kind of the event, empty in samples; only with --events"),
];

pub(crate) fn answers() -> Vec<Answers> {
    let (json, csv) = (descriptions("", JSON), descriptions("", CSV));
    vec![Answers { command: "simulate", option: "", json, csv }]
}
