//! The questions that can be asked, one file each.

mod backbone;
mod bifurcation;
mod decay;
mod derive;
pub(crate) mod expand;
mod fields;
pub(crate) mod figure;
mod fit_gates;
mod fit_lengths;
mod fit_periods;
mod fit_response;
pub(crate) mod fit_trace;
mod formulas;
mod fourier;
mod inspect;
mod list;
mod lyapunov;
mod melnikov;
mod modes;
mod motion;
mod orbit;
mod oscillators;
pub(crate) mod page;
mod paper;
pub(crate) mod parameter_type;
mod period;
mod plan;
mod resonance;
pub(crate) mod response;
mod section;
pub(crate) mod simulate;
mod stability;
pub(crate) mod sweep;
mod systems;

pub(crate) use sweep::{
    Asked as SweepAsked, Axis as SweepAxis, Plan as SweepPlanned, axis as sweep_axis,
    outcomes as sweep_outcomes,
};

use crate::arguments::{protect_negative_values, sweep_options_first};
use crate::query_error::QueryError;
use clap::{ArgMatches, Command, CommandFactory, FromArgMatches};
use libration::systems::Model;
use libration::taylor::Ensemble;
use std::cell::RefCell;
use std::ffi::OsString;
use std::io::Write;

/// The pendulum at any amplitude, and the oscillators and systems beyond it: exact answers, each with its error.
#[derive(Debug, clap::Parser)]
#[command(name = "libration", version, arg_required_else_help = true, term_width = HELP_WIDTH, after_help = EXAMPLES)]
pub(crate) struct Libration {
    #[command(subcommand)]
    question: Question,
}

/// The width of every help, whatever the terminal, so that examples can be copied as they are printed.
const HELP_WIDTH: usize = 80;

const EXAMPLES: &str = "\
Examples:
  libration period 60deg                     # exact, and by every formula
  libration expand duffing --order 9         # exact perturbation series
  libration simulate pendulum --initial theta=179deg --times 0:20:1
  libration fit trace examples/swing_synthetic.csv --length 0.56m±0.002m

Angles: 60deg, 60°, 1.2rad, 1.2 (radians), pi-1e-6, 180deg-1e-9deg. Tables are
as wide as the terminal, or as COLUMNS says; files and pipes get 80 columns.
Exit status: 0 success, 1 no result, 2 usage error, 130 interrupted.";

/// The commands in groups, each with a line.
const GROUPS: &[(&str, &[(&str, &str)])] = &[
    (
        "Pendulum",
        &[
            ("period", "exact period, and every published formula with its error"),
            ("motion", "angle and velocity in time"),
            ("fourier", "Fourier coefficients of angle and velocity"),
            ("formulas", "period formulas: sources, accuracy, where each holds"),
            ("decay", "decay of damped swings, cycle by cycle"),
        ],
    ),
    (
        "Oscillators and series",
        &[
            ("expand", "exact perturbation series of frequency and harmonics"),
            ("backbone", "frequency against amplitude: orbits, series, exact"),
            ("list", "built-in oscillators and systems: equations, sources"),
        ],
    ),
    (
        "Motion and dynamics",
        &[
            ("simulate", "motion of any system in time, each state with its error"),
            ("orbit", "periodic orbit: period, harmonics, Floquet multipliers"),
            ("response", "periodic response over a parameter: folds, stability"),
            ("stability", "stability over two parameters"),
            ("modes", "normal modes, and how they change with the amplitude"),
            ("resonance", "slow exchange of energy between modes"),
            ("section", "Poincaré section"),
            ("bifurcation", "bifurcation diagram"),
            ("lyapunov", "largest Lyapunov exponent"),
            ("melnikov", "Melnikov function: thresholds of chaos, resonances"),
        ],
    ),
    (
        "Laboratory",
        &[
            ("inspect", "contents of a file of measurements: columns, units, faults"),
            ("fit", "fit of periods, lengths, gate times, swings, responses"),
            ("plan", "plan of a measurement of g"),
        ],
    ),
    (
        "Derivations",
        &[
            ("derive", "worked derivation, every formula checked"),
            ("paper", "equations of two published derivations, checked"),
        ],
    ),
    (
        "Tools",
        &[
            ("figure", "pictures: SVG or PNG"),
            ("sweep", "any command at all points of a grid"),
            ("fields", "meaning and unit of every field of JSON and CSV"),
            ("page", "page for browsers, in one file"),
        ],
    ),
];

/// The groups of commands as clap's template of the help, with the commands of a front end among the tools.
fn help_template(further: &[Command]) -> String {
    let mut template = "{about}\n\n{usage-heading} {usage}\n".to_owned();
    for (title, commands) in GROUPS {
        template += &format!("\n{title}:\n");
        commands.iter().for_each(|(name, line)| template += &help_line(name, line));
    }
    for command in further {
        let about = command.get_about().map(ToString::to_string).unwrap_or_default();
        template += &help_line(command.get_name(), &lower_case_first(&about));
    }
    template += &help_line("help", "help of a command");
    template + "\nOptions:\n{options}{after-help}"
}

fn help_line(name: &str, line: &str) -> String {
    format!("  {name:<12} {line}\n")
}

fn lower_case_first(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_ascii_lowercase()).into_iter().chain(letters).collect()
}

/// The command line of all queries, with further commands of a front end.
///
/// # Examples
/// ```
/// let command = libration_queries::command([clap::Command::new("completions")]);
/// assert!(command.find_subcommand("period").is_some() && command.find_subcommand("completions").is_some());
/// ```
#[must_use]
pub fn command(further: impl IntoIterator<Item = Command>) -> Command {
    let further: Vec<Command> = further.into_iter().collect();
    Libration::command().help_template(help_template(&further)).subcommands(further)
}

/// The words of a command line, which begin after the name of the program, as `command` reads them.
pub(crate) fn matches(command: &mut Command, arguments: Vec<OsString>) -> Result<ArgMatches, clap::Error> {
    let named = std::iter::once(OsString::from("libration")).chain(sweep_options_first(arguments));
    command.try_get_matches_from_mut(protect_negative_values(named))
}

/// The query of a command line.
pub(crate) fn query(arguments: Vec<OsString>) -> Result<Libration, QueryError> {
    let matches = with_command(|command| matches(command, arguments));
    matches.and_then(|it| Libration::from_arg_matches(&it)).map_err(|error| QueryError::refused(&error))
}

/// Gives the command line of all queries to `work`; it is built once on each thread.
pub(crate) fn with_command<R>(work: impl FnOnce(&mut Command) -> R) -> R {
    COMMAND.with(|shared| match shared.try_borrow_mut() {
        Ok(mut shared) => work(&mut shared),
        // A host that runs a query while it receives a note on how another was read.
        Err(_) => work(&mut command([])),
    })
}

/// The plan of a sweep.
pub(crate) fn sweep_plan(asked: SweepAsked<'_>) -> Result<SweepPlanned, QueryError> {
    SweepPlanned::new(asked, fields::of_question)
}

thread_local! {
    // To build it takes longer than many an answer.
    static COMMAND: RefCell<Command> = RefCell::new(command([]));
}

#[derive(Debug, clap::Subcommand)]
enum Question {
    Period(period::Period),
    Motion(motion::Motion),
    Fourier(fourier::Fourier),
    Formulas(formulas::Formulas),
    Decay(decay::Decay),
    Expand(expand::Expand),
    List(list::List),
    #[command(hide = true)]
    Oscillators(oscillators::Oscillators),
    Backbone(backbone::Backbone),
    Simulate(Box<simulate::Simulate>),
    #[command(hide = true)]
    Systems(systems::Systems),
    Modes(modes::Modes),
    Orbit(orbit::OrbitQuestion),
    Response(Box<response::ResponseQuestion>),
    Resonance(Box<resonance::ResonanceQuestion>),
    Melnikov(Box<melnikov::MelnikovQuestion>),
    Stability(Box<stability::StabilityQuestion>),
    Section(section::PoincareQuestion),
    Bifurcation(bifurcation::Bifurcation),
    Lyapunov(lyapunov::Lyapunov),
    Sweep(Box<sweep::Sweep>),
    Paper(paper::Paper),
    Derive(derive::Derive),
    Figure(figure::Figure),
    Inspect(Box<inspect::Inspect>),
    Plan(plan::PlanQuestion),
    Fit(FitQuestion),
    Fields(fields::FieldsQuestion),
    Page(page::Page),
}

/// Fit measured data by the exact law: periods, lengths, gate times, whole swings or the response to a drive
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration fit periods examples/period_table_synthetic.csv
  libration fit lengths examples/lengths_synthetic.csv --amplitude 10deg
  libration fit gates examples/gate_synthetic.csv --amplitude 0.9
  libration fit trace examples/swing_synthetic.csv --length 0.56m±0.002m
  libration fit response examples/response_synthetic.csv
  libration inspect examples/swing_synthetic.csv   # what a file holds")]
struct FitQuestion {
    #[command(subcommand)]
    fit: Fit,
}

#[derive(Debug, clap::Subcommand)]
enum Fit {
    Periods(Box<fit_periods::FitPeriods>),
    Lengths(Box<fit_lengths::FitLengths>),
    Gates(Box<fit_gates::FitGates>),
    Trace(Box<fit_trace::FitTrace>),
    Response(Box<fit_response::FitResponse>),
}

impl Libration {
    /// The ensemble of `simulate --each`, to be followed further and further.
    pub(crate) fn ensemble(&self) -> Result<(Model, Ensemble), QueryError> {
        match &self.question {
            Question::Simulate(question) => question.ensemble(),
            _ => Err(QueryError::misuse(
                "only <libration simulate> with <--each> has motions that go on together",
            )),
        }
    }

    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        match &self.question {
            Question::Period(question) => question.answer(out),
            Question::Motion(question) => question.answer(out),
            Question::Fourier(question) => question.answer(out),
            Question::Decay(question) => question.answer(out),
            Question::Expand(question) => question.answer(out),
            Question::Formulas(question) => question.answer(out),
            Question::List(question) => question.answer(out),
            Question::Oscillators(question) => question.answer(out),
            Question::Backbone(question) => question.answer(out),
            Question::Simulate(question) => question.answer(out),
            Question::Systems(question) => question.answer(out),
            Question::Modes(question) => question.answer(out),
            Question::Orbit(question) => question.answer(out),
            Question::Response(question) => question.answer(out),
            Question::Resonance(question) => question.answer(out),
            Question::Melnikov(question) => question.answer(out),
            Question::Stability(question) => question.answer(out),
            Question::Section(question) => question.answer(out),
            Question::Bifurcation(question) => question.answer(out),
            Question::Lyapunov(question) => question.answer(out),
            Question::Sweep(question) => question.answer(out, fields::of_question),
            Question::Paper(question) => question.answer(out),
            Question::Derive(question) => question.answer(out),
            Question::Figure(question) => question.answer(out),
            Question::Inspect(question) => question.answer(out),
            Question::Plan(question) => question.answer(out),
            Question::Fit(FitQuestion { fit: Fit::Periods(question) }) => question.answer(out),
            Question::Fit(FitQuestion { fit: Fit::Lengths(question) }) => question.answer(out),
            Question::Fit(FitQuestion { fit: Fit::Gates(question) }) => question.answer(out),
            Question::Fit(FitQuestion { fit: Fit::Trace(question) }) => question.answer(out),
            Question::Fit(FitQuestion { fit: Fit::Response(question) }) => question.answer(out),
            Question::Fields(question) => question.answer(out),
            Question::Page(question) => question.answer(),
        }
    }
}
