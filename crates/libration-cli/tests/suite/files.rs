//! Files are written completely or not at all.

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

/// More lines than one core reads at a time.
#[test]
fn of_a_long_file_the_first_wrong_line_is_named() {
    let path = directory("files").join("long.txt");
    let lines: Vec<String> = (1..=20_000).map(|line| format!("{line}e-5")).collect();
    fs::write(&path, lines.join("\n")).unwrap();
    let question = format!("period --csv --formulas molina --from-file {}", path.display());
    let rows = crate::command::text(&question);
    let radians: Vec<f64> =
        rows.lines().skip(1).map(|row| row.split(',').next().unwrap().parse().unwrap()).collect();
    assert!(
        radians
            .iter()
            .zip(&lines)
            .all(|(read, line)| read.to_bits() == line.parse::<f64>().unwrap().to_bits())
    );
    assert_eq!(radians.len(), lines.len());
    let wrong = |line: usize| if line == 9000 || line == 15_000 { "sixty" } else { &lines[line] };
    fs::write(&path, (0..lines.len()).map(wrong).collect::<Vec<_>>().join("\n")).unwrap();
    let output = libration(&question);
    assert!(message(&output).contains("line 9001:"), "{}", message(&output));
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

/// A device that never ends, a sparse file of a gigabyte, and the device as standard input.
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

#[cfg(unix)]
#[test]
fn symbolic_links_stay_and_their_target_is_replaced() {
    use std::os::unix::fs::symlink;
    let directory = directory("links");
    let [real, link, far] = ["real.csv", "link.csv", "far.csv"].map(|name| directory.join(name));
    symlink("real.csv", &link).unwrap();
    symlink(&link, &far).unwrap();
    let question = "simulate pendulum --initial theta=1 --times 0:2:1";
    // At first the target does not exist yet.
    for path in [&link, &far, &link] {
        let output = libration(&format!("{question} --output {}", path.display()));
        assert!(output.status.success(), "{}", message(&output));
        assert!(
            fs::symlink_metadata(&link).unwrap().is_symlink()
                && fs::symlink_metadata(&far).unwrap().is_symlink()
        );
        assert_eq!(fs::read_to_string(&real).unwrap().lines().count(), 4);
    }
    let output = libration(&format!("simulate pendulum --times 0:3:1 --resume {} --output -", far.display()));
    assert!(output.status.success(), "{}", message(&output));
    let circle = directory.join("circle.svg");
    symlink("circle.svg", &circle).unwrap();
    let output = libration(&format!("figure spectrum --output {}", circle.display()));
    assert_eq!(output.status.code(), Some(1));
    assert!(message(&output).contains("circle"), "{}", message(&output));
}

#[cfg(unix)]
#[test]
fn streams_are_written_into() {
    let directory = directory("streams");
    let fifo = directory.join("fifo.svg");
    assert!(std::process::Command::new("mkfifo").arg(&fifo).status().unwrap().success());
    let reader = std::thread::spawn({
        let fifo = fifo.clone();
        move || fs::read_to_string(fifo).unwrap()
    });
    let output = libration(&format!("figure spectrum --output {}", fifo.display()));
    assert!(output.status.success(), "{}", message(&output));
    assert!(
        reader.join().unwrap().trim_end().ends_with("</svg>")
            && fs::read_dir(&directory).unwrap().count() == 1
    );
    let plain = libration("simulate pendulum --initial theta=1 --times 0:2:1 --csv").stdout;
    for target in ["-", "/dev/stdout", "/dev/fd/1"] {
        let output =
            libration(&format!("simulate pendulum --initial theta=1 --times 0:2:1 --csv --output {target}"));
        assert!(output.status.success() && output.stdout == plain, "{target}: {}", message(&output));
    }
    let picture = libration("figure spectrum --output -");
    assert!(
        picture.status.success() && picture.stdout.trim_ascii_end().ends_with(b"</svg>"),
        "{}",
        message(&picture)
    );
    let answers = libration("simulate pendulum --initial theta=1 --times 0:2:1 --figure -");
    assert!(
        answers.stdout.starts_with(b"<svg") || answers.stdout.starts_with(b"<?xml"),
        "{}",
        message(&answers)
    );
    assert!(answers.stdout.trim_ascii_end().ends_with(b"</svg>"));
}
