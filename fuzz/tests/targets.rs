//! Each target on its corpus and on mutations of it.

use libration_fuzz::runner::run;
use libration_fuzz::targets::all;
use libration_testing::zip_archive::checksum;

fn target(name: &str) {
    let target = all().into_iter().find(|it| it.name == name).expect("a target of this name");
    match run(&target) {
        Ok(inputs) => eprintln!("{name}: {inputs} inputs"),
        Err(failure) => panic!("{failure}"),
    }
}

#[test]
fn equations() {
    target("equation");
}

#[test]
fn angles() {
    target("angle");
}

#[test]
fn quantities() {
    target("quantity");
}

#[test]
fn tables() {
    target("table");
}

#[test]
fn archives() {
    target("archive");
}

#[test]
fn resumed_runs() {
    target("resume");
}

/// The standard check value of CRC-32, for the digits 1 to 9.
#[test]
fn the_checksum_of_archives_is_the_usual_one() {
    assert_eq!(checksum(b"123456789"), 0xcbf4_3926);
}
