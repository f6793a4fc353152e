//! The tests stand in this suite and not in the library, so that the library is compiled once.

use std::fs;
use std::path::{Path, PathBuf};

/// The files below a folder, at any depth.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let within = |path: PathBuf| if path.is_dir() { files(&path) } else { vec![path] };
    entries.flat_map(within).collect()
}

#[test]
fn no_test_stands_in_the_source() {
    let files = files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"));
    let with_tests = |path: &&PathBuf| String::from_utf8_lossy(&fs::read(path).unwrap()).contains("#[test]");
    let offenders: Vec<_> = files.iter().filter(with_tests).collect();
    assert!(files.len() > 10 && offenders.is_empty(), "{offenders:?}");
}
