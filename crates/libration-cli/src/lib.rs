//! The command `libration`, for programs that ask its questions themselves: arguments in, answers out.
//!
//! [`ask`] answers in the process that calls it and leaves its streams, signals and environment alone; [`program`] is the command.

mod arguments;
mod call;
mod command;
mod document;
mod figure;
mod host;
mod interrupt;
mod output;
mod parallel;
#[cfg(not(target_family = "wasm"))]
mod program;
mod query_error;
mod questions;
mod sweep;

pub use host::{Host, InputFile};
#[cfg(not(target_family = "wasm"))]
pub use program::program;
pub use query_error::parameter::Parameter as QueryParameter;
pub use query_error::text::Words;
pub use query_error::{Kind, QueryError};
pub use questions::{Parameter, ParameterKind, Question, questions};
pub use sweep::{AxisValues, SweepChunk, SweepPlan};

use call::Call;
use libration::systems::Model;
use libration::taylor::Ensemble;
use std::ffi::OsString;
use std::io::Write;
use std::sync::Arc;

/// Answers the question of a command line, which begins behind the name of the program, as the program does: the same bytes.
///
/// Questions may be asked on several threads at once.
///
/// # Errors
/// What the program says behind `error:`, with its exit status. Of an answer that fails on its way, or is ended early, the host has got
/// what was written until then.
///
/// # Examples
/// See [`Host`].
pub fn ask(arguments: impl IntoIterator<Item = OsString>, host: Arc<dyn Host>) -> Result<(), QueryError> {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let call = Call::new(arguments.clone(), Arc::clone(&host));
    let answered = call::within(&call, || match command::question(arguments.clone()) {
        Ok(question) => answer(&question),
        Err(help) if !help.use_stderr() => Ok(host.write(help.render().to_string().as_bytes())?),
        Err(error) => Err(QueryError::refused(&error)),
    });
    answered.map_err(|error| error.named(&|value| questions::argument_name(&arguments, value)))
}

/// The motions that `simulate … --each FILE` asks for, at their start, with their system: to be asked for their states at one time after the
/// other, as long as one likes. The question's own times are not looked at.
///
/// # Errors
/// As [`ask`]; another question, motions with different parameters, and events.
///
/// # Examples
/// ```
/// use libration::progress::Quiet;
/// use libration_cli::{Host, InputFile};
/// use std::path::Path;
/// use std::sync::Arc;
///
/// struct Starts;
///
/// impl Host for Starts {
///     fn write(&self, _: &[u8]) -> std::io::Result<()> {
///         Ok(())
///     }
///
///     fn open(&self, _: &Path) -> std::io::Result<InputFile<'_>> {
///         let bytes = b"theta1,theta2\n120deg,120deg\n120deg,120.001deg\n";
///         Ok(InputFile { size: bytes.len() as u64, bytes: Box::new(&bytes[..]) })
///     }
/// }
///
/// let words = "simulate double_pendulum --each starts.csv --times 0:10:1 --tolerance 1e-8";
/// let (model, mut ensemble) = libration_cli::ensemble(words.split(' ').map(Into::into), Arc::new(Starts))?;
/// assert_eq!((model.state_names()[1].as_str(), ensemble.len()), ("theta2", 2));
/// let states = ensemble.states_at(0.5, &Quiet)?;
/// assert!((states[1] - states[5]).abs() < 1e-3);
/// # Ok::<(), libration_cli::QueryError>(())
/// ```
pub fn ensemble(
    arguments: impl IntoIterator<Item = OsString>,
    host: Arc<dyn Host>,
) -> Result<(Model, Ensemble), QueryError> {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let call = Call::new(arguments.clone(), host);
    call::within(&call, || {
        command::question(arguments).map_err(|error| QueryError::refused(&error))?.ensemble()
    })
}

/// Writes the answer to the host of the call.
fn answer(question: &command::Libration) -> Result<(), QueryError> {
    let mut out = output::standard::StandardOutput::new();
    question.answer(&mut out)?;
    Ok(out.flush()?)
}

/// Internals that the suite tests; no promise of stability.
#[doc(hidden)]
pub mod internals {
    pub mod animation {
        pub use crate::figure::animation::{Playing, Sampled};
    }
    pub mod call {
        pub use crate::call::{Call, Nobody, current, within};
    }
    pub mod checksum {
        pub use crate::command::simulate::resume::checksum::Checksum;
    }
    pub mod csv {
        pub use crate::output::csv::{cells, line};
    }
    pub mod cusps {
        pub use crate::figure::cusps::sizes;
    }
    pub mod displacements {
        pub use crate::arguments::displacements::displacements;
    }
    pub mod document {
        pub use crate::document::{Block, Document, DocumentFigure, DocumentTable, Section};
    }
    pub mod query_error {
        pub use crate::query_error::parameter::option;
        pub use crate::query_error::text::CommandWords;
    }
    pub mod echo {
        pub use crate::query_error::echo::{LONGEST_LINE, excerpt, shortened};
    }
    pub mod field {
        pub use crate::output::description::Description;
        pub use crate::output::field::{Field, list::Fields};
    }
    pub mod figure_parameters {
        pub use crate::figure::parameters::{amplitude, said};
    }
    pub mod figure_size {
        pub use crate::figure::size::{Side, side};
    }
    #[cfg(not(target_family = "wasm"))]
    pub mod font {
        pub use crate::figure::font::Font;
    }
    pub mod html {
        pub use crate::document::html::{SCRIPT, STYLE, page, table};
    }
    pub mod json {
        pub use crate::output::json::{Record, document_with_list};
    }
    pub mod latex {
        pub use crate::document::latex::tabular;
    }
    pub mod markdown {
        pub use crate::document::markdown::{block, table};
    }
    pub mod mathml {
        pub use crate::output::mathml::name;
    }
    pub mod negative {
        pub use crate::arguments::negative::protect_negative_values;
    }
    pub mod number {
        pub use crate::output::number::{at_most, count, exact, to_its_error, write_exact};
    }
    pub mod page {
        pub use crate::command::page::write;
    }
    pub mod parallel {
        pub use crate::parallel::{in_order, map, map_unless_cancelled, unless_cancelled};
    }
    pub mod parameter_range {
        pub use crate::arguments::parameter_range::parameter_range;
    }
    pub mod provenance {
        pub use crate::document::provenance::{date, quoted};
    }
    pub mod screen_text {
        pub use crate::output::screen::{columns_of, folded, padded};
    }
    pub mod series {
        pub use crate::output::series::{Notation, Style, wrapped};
    }
    pub mod slow_flow_listing {
        pub use crate::command::expand::slow_flow::listing::in_letters;
    }
    pub mod sweep_axis {
        pub use crate::command::sweep::axis::{Axis, axis};
    }
    pub mod sweep_grid {
        pub use crate::command::sweep::grid::Grid;
    }
    pub mod sweep_kept {
        pub use crate::command::sweep::kept::{Kept, scalars};
    }
    pub mod sweep_options {
        pub use crate::arguments::sweep_options::sweep_options_first;
    }
    pub mod sweep_question {
        pub use crate::command::sweep::question::Template;
    }
    pub mod sweep_shard {
        pub use crate::command::sweep::shard::{Shard, shard};
    }
    pub mod table {
        pub use crate::output::table::{Column, HELD_BACK, Table, paragraph};
    }
    pub mod trace_curve {
        pub use crate::figure::trace::curve::smooth;
    }
    pub mod trace_report {
        pub use crate::command::fit_trace::report::sentence;
    }
    pub mod trace_thinned {
        pub use crate::figure::trace::thinned::{MOST, representative, thinned};
    }
    pub mod trajectories {
        pub use crate::command::figure::trajectories::common;
    }
}
