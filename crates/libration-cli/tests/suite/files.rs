//! Files are written whole or not at all.

use crate::command::{directory, libration, message};
use std::fs;

#[test]
fn a_file_of_amplitudes_that_is_no_list_is_refused_with_its_line() {
    let directory = directory("files");
    let cases: [(&str, &[u8], &str); 4] = [
        ("words.txt", b"60deg\nsixty\n", "line 2"),
        ("empty.txt", b"# nothing\n\n", "no value"),
        ("binary.bin", b"\xff\xfe\x00\x01", "not a text file"),
        ("beyond.txt", b"60deg\n190deg\n", "below pi"),
    ];
    for (name, bytes, expected) in cases {
        let path = directory.join(name);
        fs::write(&path, bytes).unwrap();
        let output = libration(&format!("period --csv --from-file {}", path.display()));
        assert_eq!(output.status.code(), Some(1), "{name}");
        assert!(message(&output).contains(expected), "{name}: {}", message(&output));
        assert!(output.stdout.is_empty(), "{name}");
    }
}

#[test]
fn an_older_picture_outlives_a_bad_question() {
    let picture = directory("older").join("picture.svg");
    fs::write(&picture, "older").unwrap();
    for arguments in ["figure motion --amplitudes 0deg,190deg", "figure errors --from 90deg --to 30deg"] {
        let output = libration(&format!("{arguments} --output {}", picture.display()));
        assert_eq!(output.status.code(), Some(1));
        assert_eq!(fs::read_to_string(&picture).unwrap(), "older");
    }
}

#[test]
fn nothing_is_left_beside_a_picture() {
    let directory = directory("beside");
    let output = libration(&format!("figure spectrum --output {}", directory.join("spectrum.svg").display()));
    assert!(output.status.success(), "{}", message(&output));
    assert_eq!(fs::read_dir(&directory).unwrap().count(), 1);
}

#[test]
fn a_place_that_cannot_be_written_is_named() {
    let output = libration("figure spectrum --output /nonexistent/directory/spectrum.svg");
    assert_eq!(output.status.code(), Some(1));
    assert!(message(&output).contains("/nonexistent/directory/spectrum.svg"));
}

/// A device that never ends, a file of a gigabyte without a byte on the disk, and the device as the standard input.
#[cfg(unix)]
#[test]
fn no_file_is_read_beyond_the_limit_which_is_named() {
    let sparse = directory("sparse").join("swing.csv");
    fs::File::create(&sparse).unwrap().set_len(1 << 30).unwrap();
    let sparse = sparse.display().to_string();
    for command in ["inspect", "fit trace", "fit gates", "fit periods", "fit lengths", "period --from-file"] {
        let output = libration(&format!("{command} /dev/zero"));
        assert_eq!(output.status.code(), Some(1), "{command}");
        let said = message(&output);
        assert!(said.contains("/dev/zero") && said.contains("67108864 bytes"), "{command}: {said}");
        let said = message(&libration(&format!("{command} {sparse}")));
        assert!(said.contains("has 1073741824 bytes") && said.contains("67108864"), "{command}: {said}");
    }
    let zeros = fs::File::open("/dev/zero").unwrap();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_libration"));
    let output = command.args(["inspect", "-"]).stdin(zeros).output().unwrap();
    assert!(message(&output).contains("67108864 bytes"), "{}", message(&output));
}
