//! Files are written beside their place and renamed into it: whole or not at all.

use crate::failure::Failure;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes the file, replacing an older one only when all bytes are on the disk.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let beside = beside(path)?;
    let written = write_new(&beside, bytes).and_then(|()| fs::rename(&beside, path));
    written.map_err(|error| {
        // The half-written file is ours; if it cannot be removed, the message below is what matters.
        let _ = fs::remove_file(&beside);
        cannot_write(path, &error)
    })
}

/// A file that is written part by part, and takes its place when it is finished.
#[derive(Debug)]
pub(crate) struct NewFile {
    writer: io::BufWriter<fs::File>,
    beside: PathBuf,
    path: PathBuf,
}

impl NewFile {
    pub(crate) fn create(path: &Path) -> Result<Self, Failure> {
        let beside = beside(path)?;
        let file = create(&beside).map_err(|error| cannot_write(path, &error))?;
        Ok(Self { writer: io::BufWriter::with_capacity(1 << 16, file), beside, path: path.to_owned() })
    }

    /// Puts the file in its place.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        let written = self.writer.flush().and_then(|()| self.writer.get_ref().sync_all());
        let placed = written.and_then(|()| fs::rename(&self.beside, &self.path));
        placed.map_err(|error| cannot_write(&self.path, &error))
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

impl Drop for NewFile {
    fn drop(&mut self) {
        // What is not in its place now is half-written, or has gone there already.
        let _ = fs::remove_file(&self.beside);
    }
}

fn cannot_write(path: &Path, error: &io::Error) -> Failure {
    Failure::NoAnswer(format!("cannot write {}: {error}", path.display()))
}

fn create(path: &Path) -> io::Result<fs::File> {
    fs::OpenOptions::new().write(true).create_new(true).open(path)
}

fn write_new(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = create(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

/// A new name in the same directory, where a rename cannot cross file systems.
fn beside(path: &Path) -> Result<PathBuf, Failure> {
    let name = path.file_name().ok_or_else(|| {
        Failure::Usage(format!("{} names no file: give a path that ends in a file name", path.display()))
    })?;
    let mut hidden = std::ffi::OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{}.part", std::process::id()));
    Ok(path.with_file_name(hidden))
}
