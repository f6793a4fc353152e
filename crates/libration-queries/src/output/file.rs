//! Files are written under a temporary name and renamed: completely or not at all. Streams are written directly.

use super::destination::{self, Destination, Stream};
use super::{leftover, standard};
use crate::call;
use crate::query_error::QueryError;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes the file, replacing an older one only when all bytes are on the disk.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), QueryError> {
    let mut file = NewFile::create(path)?;
    file.write_all(bytes).map_err(|error| cannot_write(path, error))?;
    file.finish()
}

/// Bytes that are written at a time.
const BUFFER: usize = 1 << 16;

/// A file that is written part by part, and renamed when it is complete.
pub(crate) struct NewFile {
    target: Target,
    path: PathBuf,
}

/// The target of the bytes.
enum Target {
    Stream(Box<dyn Write>),
    Disk(io::BufWriter<fs::File>, Unfinished),
    /// Bytes that are kept until the host of the run gets them.
    Kept(Vec<u8>),
}

/// The bytes until the file is complete.
#[derive(Debug)]
struct Unfinished {
    file: fs::File,
    beside: PathBuf,
    target: PathBuf,
}

impl NewFile {
    pub(crate) fn create(path: &Path) -> Result<Self, QueryError> {
        let fails = |error| cannot_write(path, error);
        let target = match destination::resolved(path).map_err(fails)? {
            Destination::Stream(stream) => {
                if stream == Stream::Output {
                    standard::keep_for_files();
                }
                let stream = stream.open().map_err(fails)?;
                Target::Stream(Box::new(io::BufWriter::with_capacity(BUFFER, stream)))
            }
            Destination::File(path) => {
                let unfinished = Unfinished::create(path)?;
                let file = unfinished.file.try_clone().map_err(fails)?;
                Target::Disk(io::BufWriter::with_capacity(BUFFER, file), unfinished)
            }
            Destination::Kept => Target::Kept(vec![]),
        };
        Ok(Self { target, path: path.to_owned() })
    }

    /// The path of the complete file, after all links, and the temporary one; `None` for streams.
    pub(crate) fn places(&self) -> Option<[PathBuf; 2]> {
        match &self.target {
            Target::Disk(_, disk) => Some([disk.target.clone(), disk.beside.clone()]),
            Target::Stream(_) | Target::Kept(_) => None,
        }
    }

    /// Renames the file to its final name.
    pub(crate) fn finish(mut self) -> Result<(), QueryError> {
        let flushed = self.flush();
        let placed = flushed.and_then(|()| match self.target {
            Target::Stream(_) => Ok(()),
            Target::Disk(_, unfinished) => unfinished.put_in_place(),
            Target::Kept(bytes) => call::current().host().keep(&self.path, &bytes),
        });
        placed.map_err(|error| cannot_write(&self.path, error))
    }
}

impl Write for NewFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.target.writer().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.target.writer().flush()
    }
}

impl Target {
    fn writer(&mut self) -> &mut dyn Write {
        match self {
            Self::Stream(stream) => stream,
            Self::Disk(file, _) => file,
            Self::Kept(bytes) => bytes,
        }
    }
}

impl Unfinished {
    /// A new name in the same directory, where a rename cannot cross file systems.
    fn create(path: PathBuf) -> Result<Self, QueryError> {
        let name = path.file_name().ok_or_else(|| {
            QueryError::misuse(format!(
                "{} names no file: give a path that ends in a file name",
                path.display()
            ))
        })?;
        leftover::remove(&path);
        let beside = path.with_file_name(leftover::name(name, std::process::id()));
        let file = fs::OpenOptions::new().write(true).create_new(true).open(&beside);
        let file = file.map_err(|error| cannot_write(&path, error))?;
        // Where files cannot be locked nobody takes one for left.
        let _ = file.try_lock();
        Ok(Self { file, beside, target: path })
    }

    fn put_in_place(self) -> io::Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.beside, &self.target)?;
        leftover::remove(&self.target);
        Ok(())
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        // What is not in its place now is half-written, or has gone there already.
        let _ = fs::remove_file(&self.beside);
    }
}

fn cannot_write(path: &Path, error: io::Error) -> QueryError {
    match error.kind() {
        io::ErrorKind::BrokenPipe => QueryError::from(error),
        _ => QueryError::failed(format!("cannot write {}: {error}", path.display())),
    }
}
