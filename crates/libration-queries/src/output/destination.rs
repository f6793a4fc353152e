//! Destination of an output path: a file that is replaced as a whole, or a stream that is written into.

use crate::call::{self, Output};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The destination of an output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Destination {
    /// A file that exists or is to be created, after all symbolic links.
    File(PathBuf),
    /// A file that the host of the run keeps.
    Kept,
    /// A stream that takes bytes one after the other: the standard output, a FIFO, a device.
    Stream(Stream),
}

/// A stream.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Stream {
    Output,
    Error,
    Opened(PathBuf),
}

/// More links than this lead in a circle.
const MOST_LINKS: usize = 40;

/// The destination of the path; `-` is the output of the run.
pub(crate) fn resolved(path: &Path) -> io::Result<Destination> {
    if path == Path::new("-") {
        return Ok(Destination::Stream(Stream::Output));
    }
    if call::current().host().keeps_files() {
        return Ok(Destination::Kept);
    }
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        if let Some(stream) = open_already(&path) {
            return Ok(Destination::Stream(stream));
        }
        let kind = match fs::symlink_metadata(&path) {
            Ok(metadata) => metadata.file_type(),
            // What is not there yet is made.
            Err(_) => return Ok(Destination::File(path)),
        };
        if !kind.is_symlink() {
            let whole = kind.is_file() || kind.is_dir();
            return Ok(if whole {
                Destination::File(path)
            } else {
                Destination::Stream(Stream::Opened(path))
            });
        }
        // Relative targets are relative to where the link is.
        let target = fs::read_link(&path)?;
        path = path.parent().unwrap_or(Path::new("")).join(target);
    }
    Err(io::Error::other("its symbolic links lead in a circle"))
}

/// The open stream of the process that has this name on the system.
fn open_already(path: &Path) -> Option<Stream> {
    const OUTPUT: [&str; 3] = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];
    const ERROR: [&str; 3] = ["/dev/stderr", "/dev/fd/2", "/proc/self/fd/2"];
    const OTHERS: [&str; 2] = ["/dev/fd/", "/proc/self/fd/"];
    let is = |names: &[&str]| names.iter().any(|name| path == Path::new(name));
    if is(&OUTPUT) {
        return Some(Stream::Output);
    }
    if is(&ERROR) {
        return Some(Stream::Error);
    }
    OTHERS.iter().any(|name| path.starts_with(name)).then(|| Stream::Opened(path.to_owned()))
}

impl Stream {
    pub(crate) fn open(&self) -> io::Result<Box<dyn Write>> {
        Ok(match self {
            Self::Output => Box::new(Output::new()),
            Self::Error => Box::new(io::stderr()),
            Self::Opened(path) => Box::new(fs::OpenOptions::new().append(true).open(path)?),
        })
    }
}
