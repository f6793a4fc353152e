//! The queries of libration, for front ends: the words of a command line in, results out.
//!
//! # Terms
//! A **query** is a command of the program, such as `period` or `fit trace`; a **run** executes one with its words. The **host**
//! is the environment of a run: the front end that receives its output and notes, provides its files, and may cancel it.
//!
//! # Tasks
//!
//! | item | task |
//! |---|---|
//! | [`ask`] | run a query; the bytes are those of the program |
//! | [`Host`] | receive output, notes and progress, provide files, cancel |
//! | [`questions()`] | list the queries with their parameters, as data |
//! | [`Run`], [`command()`] | run a query whose words the front end parses with clap |
//! | [`ensemble`] | the motions of `simulate --each`, to be advanced by the caller |
//! | [`SweepPlan`] | the chunks of a sweep, to be computed on any machine |
//!
//! ```
//! use libration_queries::Host;
//! use std::io;
//! use std::sync::{Arc, Mutex};
//!
//! #[derive(Default)]
//! struct Memory(Mutex<Vec<u8>>);
//!
//! impl Host for Memory {
//!     fn write(&self, bytes: &[u8]) -> io::Result<()> {
//!         self.0.lock().map_err(|_| io::ErrorKind::Other)?.extend_from_slice(bytes);
//!         Ok(())
//!     }
//! }
//!
//! let memory = Arc::new(Memory::default());
//! libration_queries::ask(["fourier", "60deg", "--json"].map(Into::into), memory.clone())?;
//! let output = memory.0.lock().map_err(|_| "a thread has failed")?;
//! assert!(output.starts_with(b"{"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Errors
//! A [`QueryError`] has a kind (no result, usage error, cancelled) with the exit status of the program, the parameters that it is
//! about, its message, and where known a hint: a value or another query that would work. A run touches no streams, signals or
//! environment of its process, only the files that its words name.

mod arguments;
mod call;
mod command;
mod document;
mod figure;
mod host;
mod interrupt;
mod output;
mod parallel;
mod query_error;
mod questions;
mod run;
mod sweep;

pub use command::command;
pub use command::parameter_type::ParameterType;
pub use host::{Host, InputFile};
pub use query_error::parameter::Parameter as QueryParameter;
pub use query_error::text::{MarkedWords, Words};
pub use query_error::{Kind, QueryError, hint_to, refusal};
pub use questions::{ParameterDescription, ParameterKind, Question, questions};
pub use run::{Run, ask, ensemble};
pub use sweep::{AxisValues, SweepChunk, SweepPlan};

/// Internals that the suite tests; no promise of stability.
#[doc(hidden)]
pub mod internals {
    pub mod animation {
        pub use crate::figure::animation::{Playing, SampledCoordinates};
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
        pub use crate::figure::layout::{PictureSide, side};
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
    pub mod fit_report {
        pub use crate::command::fit_report::sentence;
    }
    pub mod trace_thinned {
        pub use crate::figure::trace::thinned::{MOST, representative, thinned};
    }
    pub mod trajectories {
        pub use crate::command::figure::trajectories::common;
    }
}
