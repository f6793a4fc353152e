//! The list of all queries, in the groups of the help.
//!
//! A query is registered here and nowhere else: the help, the parameters as data, the fields and the run follow from its line.

use super::{
    backbone, bifurcation, decay, derive, expand, fields, figure, fit_amplitudes, fit_gates, fit_lengths,
    fit_periods, fit_response, fit_trace, formulas, fourier, inspect, list, lyapunov, melnikov, modes,
    motion, orbit, oscillators, page, paper, period, plan, resonance, response, section, simulate, stability,
    sweep, systems,
};
use crate::output::description::Answers;
use crate::query_error::QueryError;
use clap::{ArgMatches, Args, Command};
use std::io::Write;

/// A query: its words, its line in the help, its parameters, its run, its fields.
pub(crate) struct Query {
    pub(crate) words: &'static str,
    /// `HIDDEN` for queries that share their first word, whose line is in `FAMILIES`, and for former names.
    pub(crate) line: &'static str,
    pub(crate) with_parameters: fn(Command) -> Command,
    pub(crate) write: WriteResult,
    pub(crate) fields: fn() -> Vec<Answers>,
}

/// The line of a query that is not listed in the help.
pub(crate) const HIDDEN: &str = "";

/// Writes the result for parameters that were read.
type WriteResult = Box<dyn Fn(&ArgMatches, &mut dyn Write) -> Result<(), QueryError>>;

fn query<P: Args + 'static>(
    words: &'static str,
    line: &'static str,
    write: fn(&P, &mut dyn Write) -> Result<(), QueryError>,
    fields: fn() -> Vec<Answers>,
) -> Query {
    let write = move |matches: &ArgMatches, out: &mut dyn Write| {
        write(&P::from_arg_matches(matches).map_err(|error| QueryError::refused(&error))?, out)
    };
    Query { words, line, with_parameters: P::augment_args, write: Box::new(write), fields }
}

/// The titles of the help, each with its queries.
pub(crate) fn groups() -> [(&'static str, Vec<Query>); 6] {
    [
        (
            "Pendulum",
            vec![
                query(
                    "period",
                    "exact period, and every published formula with its error",
                    period::Period::answer,
                    period::answers,
                ),
                query("motion", "angle and velocity in time", motion::Motion::answer, motion::answers),
                query(
                    "fourier",
                    "Fourier coefficients of angle and velocity",
                    fourier::Fourier::answer,
                    fourier::answers,
                ),
                query(
                    "formulas",
                    "period formulas: sources, accuracy, domains",
                    formulas::Formulas::answer,
                    formulas::answers,
                ),
                query(
                    "decay",
                    "decay of damped swings, cycle by cycle",
                    decay::Decay::answer,
                    decay::answers,
                ),
            ],
        ),
        (
            "Oscillators and series",
            vec![
                query(
                    "expand",
                    "exact perturbation series of frequency and harmonics",
                    expand::Expand::answer,
                    expand::answers,
                ),
                query(
                    "backbone",
                    "frequency against amplitude: orbits, series, exact",
                    backbone::Backbone::answer,
                    backbone::answers,
                ),
                query(
                    "list",
                    "built-in oscillators and systems: equations, sources",
                    list::List::answer,
                    list::answers,
                ),
                query("oscillators", HIDDEN, oscillators::Oscillators::answer, oscillators::answers),
            ],
        ),
        (
            "Motion and dynamics",
            vec![
                query(
                    "simulate",
                    "motion of any system in time, each state with its error",
                    simulate::Simulate::answer,
                    simulate::answers,
                ),
                query(
                    "orbit",
                    "periodic orbit: period, harmonics, Floquet multipliers",
                    orbit::OrbitQuestion::answer,
                    orbit::answers,
                ),
                query(
                    "response",
                    "periodic response over a parameter: folds, stability",
                    response::ResponseQuestion::answer,
                    response::answers,
                ),
                query(
                    "stability",
                    "stability over two parameters",
                    stability::StabilityQuestion::answer,
                    stability::answers,
                ),
                query(
                    "modes",
                    "normal modes, and their change with the amplitude",
                    modes::Modes::answer,
                    modes::answers,
                ),
                query(
                    "resonance",
                    "slow exchange of energy between modes",
                    resonance::ResonanceQuestion::answer,
                    resonance::answers,
                ),
                query("section", "Poincaré section", section::PoincareQuestion::answer, section::answers),
                query(
                    "bifurcation",
                    "bifurcation diagram",
                    bifurcation::Bifurcation::answer,
                    bifurcation::answers,
                ),
                query("lyapunov", "largest Lyapunov exponent", lyapunov::Lyapunov::answer, lyapunov::answers),
                query(
                    "melnikov",
                    "Melnikov function: thresholds of chaos, resonances",
                    melnikov::MelnikovQuestion::answer,
                    melnikov::answers,
                ),
                query("systems", HIDDEN, systems::Systems::answer, systems::answers),
            ],
        ),
        (
            "Laboratory",
            vec![
                query(
                    "inspect",
                    "contents of a file of measurements: columns, units, faults",
                    inspect::Inspect::answer,
                    inspect::answers,
                ),
                query("fit periods", HIDDEN, fit_periods::FitPeriods::answer, fit_periods::answers),
                query("fit lengths", HIDDEN, fit_lengths::FitLengths::answer, fit_lengths::answers),
                query(
                    "fit amplitudes",
                    HIDDEN,
                    fit_amplitudes::FitAmplitudes::answer,
                    fit_amplitudes::answers,
                ),
                query("fit gates", HIDDEN, fit_gates::FitGates::answer, fit_gates::answers),
                query("fit trace", HIDDEN, fit_trace::FitTrace::answer, fit_trace::answers),
                query("fit response", HIDDEN, fit_response::FitResponse::answer, fit_response::answers),
                query("plan", "plan of a measurement of g", plan::PlanQuestion::answer, plan::answers),
            ],
        ),
        (
            "Derivations",
            vec![
                query("derive", "worked derivation, every formula checked", derive::Derive::answer, Vec::new),
                query(
                    "paper",
                    "equations of two published derivations, checked",
                    paper::Paper::answer,
                    paper::answers,
                ),
            ],
        ),
        (
            "Tools",
            vec![
                query("figure", "pictures: SVG, PDF, PNG or JSON", figure::Figure::answer, figure::answers),
                query("sweep", "any command over a parameter grid", sweep::Sweep::answer, sweep::answers),
                query(
                    "fields",
                    "meaning and unit of every field of JSON and CSV",
                    fields::FieldsQuestion::answer,
                    fields::answers,
                ),
                query("page", "page for browsers, in one file", page::Page::answer, Vec::new),
            ],
        ),
    ]
}

/// Queries that share their first word: the word, its line in the help, its description, examples.
pub(crate) static FAMILIES: [[&str; 4]; 1] = [[
    "fit",
    "fit of periods, lengths, amplitudes, gates, swings, responses",
    "Fit the exact law to measured data: periods, lengths, amplitudes, gate times, whole swings or the response to a drive",
    "Examples:
  libration fit periods examples/period_table_synthetic.csv
  libration fit lengths examples/lengths_synthetic.csv --amplitude 10deg
  libration fit amplitudes examples/amplitudes_synthetic.csv
  libration fit gates examples/gate_synthetic.csv --amplitude 0.9
  libration fit trace examples/swing_synthetic.csv --length 0.56m±0.002m
  libration fit response examples/response_synthetic.csv
  libration inspect examples/swing_synthetic.csv   # contents of a file",
]];
