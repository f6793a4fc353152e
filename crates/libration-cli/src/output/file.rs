//! Files are written beside their place and renamed into it: whole or not at all. Streams are written into.

use super::destination::{self, Destination, Stream};
use super::{leftover, standard};
use crate::failure::Failure;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes the file, replacing an older one only when all bytes are on the disk.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let mut file = NewFile::create(path)?;
    file.write_all(bytes).map_err(|error| cannot_write(path, error))?;
    file.finish()
}

/// A file that is written part by part, and takes its place when it is finished.
pub(crate) struct NewFile {
    writer: io::BufWriter<Box<dyn Write>>,
    /// `None` for streams.
    unfinished: Option<Unfinished>,
    path: PathBuf,
}

/// The bytes until they are in their place.
#[derive(Debug)]
struct Unfinished {
    file: fs::File,
    beside: PathBuf,
    place: PathBuf,
}

impl NewFile {
    pub(crate) fn create(path: &Path) -> Result<Self, Failure> {
        let fails = |error| cannot_write(path, error);
        let (target, unfinished) = match destination::resolved(path).map_err(fails)? {
            Destination::Stream(stream) => {
                if stream == Stream::Output {
                    standard::keep_for_files();
                }
                (stream.open().map_err(fails)?, None)
            }
            Destination::File(place) => {
                let unfinished = Unfinished::create(place)?;
                let file = unfinished.file.try_clone().map_err(fails)?;
                (Box::new(file) as Box<dyn Write>, Some(unfinished))
            }
        };
        let writer = io::BufWriter::with_capacity(1 << 16, target);
        Ok(Self { writer, unfinished, path: path.to_owned() })
    }

    /// The file that it will be, at the end of all links, and where it is until then; `None` for a stream.
    pub(crate) fn places(&self) -> Option<[PathBuf; 2]> {
        self.unfinished.as_ref().map(|it| [it.place.clone(), it.beside.clone()])
    }

    /// Puts the file in its place.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        let written = self.writer.flush();
        let placed = written.and_then(|()| self.unfinished.take().map_or(Ok(()), Unfinished::put_in_place));
        placed.map_err(|error| cannot_write(&self.path, error))
    }
}

impl Write for NewFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()
    }
}

impl Unfinished {
    /// A new name in the same directory, where a rename cannot cross file systems.
    fn create(place: PathBuf) -> Result<Self, Failure> {
        let name = place.file_name().ok_or_else(|| {
            Failure::Usage(format!("{} names no file: give a path that ends in a file name", place.display()))
        })?;
        leftover::remove(&place);
        let beside = place.with_file_name(leftover::name(name, std::process::id()));
        let file = fs::OpenOptions::new().write(true).create_new(true).open(&beside);
        let file = file.map_err(|error| cannot_write(&place, error))?;
        // Where files cannot be locked nobody takes one for left.
        let _ = file.try_lock();
        Ok(Self { file, beside, place })
    }

    fn put_in_place(self) -> io::Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.beside, &self.place)?;
        leftover::remove(&self.place);
        Ok(())
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        // What is not in its place now is half-written, or has gone there already.
        let _ = fs::remove_file(&self.beside);
    }
}

fn cannot_write(path: &Path, error: io::Error) -> Failure {
    match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::Output(error),
        _ => Failure::NoAnswer(format!("cannot write {}: {error}", path.display())),
    }
}
