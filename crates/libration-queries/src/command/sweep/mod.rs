//! `libration sweep`: one question at all points of a grid.
//!
//! # Method
//! A `Plan` is data: the words of a command line in which `{NAME}` stands for the value of an axis, the values, the paths to the kept fields, and
//! the grid in chunks. It is all that a chunk needs, so that threads, machines and repetitions change no byte. A chunk is both a block of the grid
//! and a run of its points. The kept fields follow from the first of a few scattered points that has a result, before anything is written; if none
//! has, the sweep is refused. Each point is a `Call` of its own.
//!
//! In a directory `sweep.json` holds the plan. A chunk is a file that is complete or absent; no other state is kept. In Python (`sweeps.py`) the
//! same chunks are those of a Zarr store, written by `_zarr.py` without compression, with sorted metadata and no date, so that no library's version
//! shows in the bytes. Drafts are kept outside the store, and `status` is the last file of a chunk to be written. Threads (`_workers.py`) and the
//! tasks of a cluster need only the plan and a number.

pub(crate) mod axis;
mod chunk;
pub(crate) mod grid;
mod join;
pub(crate) mod kept;
mod plan;
mod point;
mod progress;
pub(crate) mod question;
mod run;
pub(crate) mod shard;
mod status;
mod store;

use crate::arguments::count;
use crate::interrupt;
use crate::output::Form;
use crate::output::description::Answers;
use crate::query_error::QueryError;
pub(crate) use axis::{Axis, axis};
pub(crate) use chunk::outcomes;
pub(crate) use plan::{Plan, SweepRequest};

use shard::{Shard, shard};
use std::io::Write;
use std::path::PathBuf;
use store::Store;

/// More points than this are never requested in one chunk.
const MOST_POINTS: usize = 1_000_000_000;

/// Run a command over a parameter grid, in chunks that survive interruptions
///
/// Each --over is an axis. Its values replace {NAME} in the command, or go to its option or argument of this name, or they are initial values or parameters of its system.
#[derive(Debug, clap::Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true, override_usage = USAGE)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration sweep lyapunov driven_pendulum --over A=1:1.4:0.1 \\
    --over theta=0,0.2 --set c=1/2 --intervals 10 --output exponents
  libration sweep join exponents --output exponents.csv
  libration sweep period --over amplitude=10deg:170deg:10deg --output periods
  libration sweep section driven_pendulum --over A=1:1.2:0.05 \\
    --set c=1/2 --initial theta=0.2 --points 20 \\
    --keep 'omega=points[0:20].state[1]' --output diagram
  libration sweep simulate \"x'' = -x - {k} x^3\" --over k=0:1:0.1 \\
    --initial x=1 --times 10 --keep 'x=samples[-1].state[0]' --output ends

Points without a result have empty cells, and the reason in `message`. Finished
chunks are kept when the command is interrupted or killed; the same command then
continues. With --shard several machines share the work. Options of the sweep
may stand anywhere before --; what follows -- belongs to the command alone, such
as its own --output or --over.")
)]
pub(crate) struct Sweep {
    #[command(subcommand)]
    about: Option<SweepTarget>,
    #[command(flatten)]
    run: Option<SweepRun>,
}

const USAGE: &str = "libration sweep COMMAND… --over NAME=VALUES… --output DIR
       libration sweep join DIR… --output FILE
       libration sweep status DIR…";

#[derive(Debug, clap::Subcommand)]
enum SweepTarget {
    Join(join::Join),
    Status(status::Status),
}

#[derive(Debug, clap::Args)]
struct SweepRun {
    /// The command and its options, as after `libration`; --json is implied
    #[arg(value_name = "COMMAND", required = true)]
    question: Vec<String>,
    /// An axis and its values: A=1:1.5:0.01, theta=1deg:9deg:1deg or n=1,2,5; separated by semicolons if values contain commas
    #[arg(long, value_name = "NAME=VALUES", value_parser = axis, required = true)]
    over: Vec<Axis>,
    /// The directory for the chunks; a sweep begun there is continued
    #[arg(long, short, value_name = "DIR")]
    output: PathBuf,
    /// Keep this number of the result, by its path in JSON: exponent, results[0].ratio, samples[-1].state[0], points[0:100].state[1],
    /// with a name as in angle=samples[-1].state[0] [default: all numbers outside lists]
    #[arg(long, value_name = "[NAME=]PATH")]
    keep: Vec<String>,
    /// Compute this part of the sweep only, such as 3/64
    #[arg(long, value_name = "K/N", value_parser = shard)]
    shard: Option<Shard>,
    /// Largest number of points in a chunk [default: about 256 chunks]
    #[arg(long, value_name = "N", value_parser = count::<MOST_POINTS>)]
    chunk: Option<usize>,
}

impl Sweep {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        match (&self.about, &self.run) {
            (Some(SweepTarget::Join(join)), _) => join.answer(out),
            (Some(SweepTarget::Status(status)), _) => status.answer(out),
            (None, Some(run)) => run.answer(out),
            (None, None) => Err(QueryError::misuse("COMMAND: give the command of the sweep")),
        }
    }
}

impl SweepRun {
    fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        interrupt::listen()?;
        let (axes, keep) = (self.over.clone(), &self.keep);
        let plan = Plan::new(SweepRequest { question: &self.question, axes, keep, chunk: self.chunk })?;
        let store = Store::create(&self.output, plan)?;
        run::run(&store, self.shard.unwrap_or(Shard::WHOLE))?;
        status::write(out, Form::Table, &[store])
    }
}

pub(crate) fn answers() -> Vec<Answers> {
    [join::answers(), status::answers()].concat()
}
