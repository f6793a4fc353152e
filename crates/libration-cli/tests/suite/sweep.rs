//! Sweeps: one query at all points of a grid, in chunks that survive failures of the command.

use crate::command::{directory, json, message, run, text};
use crate::fields::assert_described;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

/// Three parameters and five initial values, the last of which has no motion.
const QUESTION: &str = "section|driven_pendulum|--set|c=1/2|--points|1|--skip|2|--over|A=1:1.2:0.1\
                        |--over|theta=0.1,0.2,0.3,0.4,0.5|--keep|omega=points[-1].state[1]|--chunk|2";

fn sweep(question: &str, output: &Path, more: &[&str]) -> Output {
    let words = question.split('|').chain(["--output", output.to_str().unwrap()]).chain(more.iter().copied());
    run(&[&["sweep"], &words.collect::<Vec<_>>()[..]].concat())
}

fn succeeded(output: &Output) {
    assert!(output.status.success(), "{}", message(output));
}

/// The joined sweep of several directories.
fn joined(directories: &[&Path], ending: &str) -> String {
    let file = directories[0].with_extension(ending);
    let words = directories.iter().map(|directory| directory.to_str().unwrap());
    let words: Vec<&str> =
        ["sweep", "join"].into_iter().chain(words).chain(["--output", file.to_str().unwrap()]).collect();
    succeeded(&run(&words));
    fs::read_to_string(file).unwrap()
}

/// The files of chunks in a directory, by name. Files that are still written have other names and may vanish.
fn chunks(directory: &Path) -> BTreeMap<String, String> {
    let entries = fs::read_dir(directory).unwrap().map(Result::unwrap);
    let named = entries.map(|entry| (entry.file_name().into_string().unwrap(), entry.path()));
    let of_chunks = named.filter(|(name, _)| name.starts_with("chunk"));
    of_chunks.map(|(name, path)| (name, fs::read_to_string(path).unwrap())).collect()
}

#[test]
fn a_sweep_gives_what_each_question_gives() {
    let folder = directory("sweep-answers").join("d");
    succeeded(&sweep(QUESTION, &folder, &[]));
    let table = joined(&[&folder], "csv");
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("A,theta,omega,status,message"));
    let mut points = 0;
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let alone = json(&format!(
            "section driven_pendulum --set c=1/2,A={} --initial theta={} --points 1 --skip 2",
            cells[0], cells[1]
        ));
        assert_eq!(cells[2].parse::<f64>().ok(), alone["points"][0]["state"][1].as_f64(), "{line}");
        assert_eq!(cells[3..], ["0", ""]);
        points += 1;
    }
    assert_eq!(points, 15);
}

#[test]
fn shards_and_chunks_join_to_the_same_bytes() {
    let folder = directory("sweep-shards");
    let whole = folder.join("whole");
    succeeded(&sweep(QUESTION, &whole, &[]));
    let parts: Vec<_> = (1..=3).map(|number| folder.join(format!("part{number}"))).collect();
    for (number, part) in (1..).zip(&parts) {
        succeeded(&sweep(QUESTION, part, &["--shard", &format!("{number}/3")]));
    }
    let parts: Vec<&Path> = parts.iter().map(|part| part.as_path()).collect();
    for ending in ["csv", "json"] {
        assert_eq!(joined(&parts, ending), joined(&[&whole], ending));
    }
    let together = folder.join("together");
    for number in [3, 1, 2] {
        succeeded(&sweep(QUESTION, &together, &["--shard", &format!("{number}/3")]));
    }
    assert_eq!(joined(&[&together], "csv"), joined(&[&whole], "csv"));
    // Chunks of another directory contain the same lines.
    let other = folder.join("other");
    let seven = QUESTION.replace("--chunk|2", "--chunk|7");
    succeeded(&sweep(&seven, &other, &[]));
    assert_eq!(joined(&[&other], "csv"), joined(&[&whole], "csv"));
}

#[test]
fn missing_shards_are_named() {
    let folder = directory("sweep-missing");
    let part = folder.join("part");
    succeeded(&sweep(QUESTION, &part, &["--shard", "2/3"]));
    let join = |directory: &Path| {
        let output = run(&["sweep", "join", directory.to_str().unwrap(), "--output", "never.csv"]);
        assert_eq!(output.status.code(), Some(1));
        assert!(!Path::new("never.csv").exists());
        message(&output)
    };
    assert!(join(&part).contains("missing are the shards 1/3, 3/3"), "{}", join(&part));
    fs::remove_file(part.join("chunk-000004.csv")).unwrap();
    assert!(join(&part).contains("1/3, 1 of 3 chunks of 2/3, 3/3"), "{}", join(&part));
    let status = json(&format!("sweep status {}", part.display()));
    assert_eq!(
        (&status["chunks"], &status["chunks_whole"], &status["points_done"]),
        (&9.into(), &2.into(), &4.into())
    );
    assert!(status["missing"].as_str().unwrap().contains("3/3"));
    assert_eq!(status["kept"], serde_json::json!(["omega"]));
}

#[test]
fn where_nothing_stands_alone_it_has_to_be_chosen() {
    let folder = directory("sweep-lists").join("d");
    let question = "modes|double_pendulum|--over|m2=1,2";
    let output = sweep(question, &folder, &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        message(&output).contains("--keep")
            && message(&output).contains("modes[0].angular_frequency_rad_per_s")
    );
    assert!(!folder.exists());
    succeeded(&sweep(question, &folder, &["--keep", "omega=modes[0].angular_frequency_rad_per_s"]));
}

#[test]
fn words_that_are_missing_are_no_numbers() {
    // `system` is null here, and so is `note`.
    let folder = directory("sweep-words").join("d");
    succeeded(&sweep("lyapunov|x'' = -x - {c} x'|--initial|x=1|--over|c=1,2|--time|5", &folder, &[]));
    let status = json(&format!("sweep status {}", folder.display()));
    let kept: Vec<&str> =
        status["kept"].as_array().unwrap().iter().map(|field| field.as_str().unwrap()).collect();
    assert!(kept.contains(&"exponent_per_s") && !kept.contains(&"system"), "{kept:?}");
}

#[test]
fn points_without_an_answer_say_why() {
    let folder = directory("sweep-failures").join("d");
    let question = "period|--over|amplitude=60deg,190deg,90deg|--keep|results[0].ratio|--over|length=1m,-1m";
    succeeded(&sweep(question, &folder, &[]));
    let table: Value = serde_json::from_str(&joined(&[&folder], "json")).unwrap();
    assert_described("sweep join", &table);
    let points = table["points"].as_array().unwrap();
    let status: Vec<u64> = points.iter().map(|point| point["status"].as_u64().unwrap()).collect();
    assert_eq!(status, [0, 2, 1, 2, 0, 2]);
    for point in points {
        let has_answer = point["status"] == 0;
        assert_eq!(
            (point["message"].is_null(), point["values"]["ratio"].is_f64()),
            (has_answer, has_answer),
            "{point}"
        );
    }
    assert!(points[2]["message"].as_str().unwrap().contains("below pi"), "{}", points[2]);
    assert_eq!((&points[2]["at"]["amplitude"], &points[2]["at"]["length"]), (&190.0.into(), &1.0.into()));
    assert!(text(&format!("sweep status {}", folder.display())).contains("4"));
}

#[test]
fn all_numbers_that_stand_alone_are_kept_with_their_units() {
    let folder = directory("sweep-all").join("d");
    succeeded(&sweep("period|--formulas|bernoulli|--over|amplitude=60deg,90deg", &folder, &[]));
    let table: Value = serde_json::from_str(&joined(&[&folder], "json")).unwrap();
    let fields = table["fields"].as_array().unwrap();
    let of = |name: &str| {
        fields.iter().find(|field| field["name"] == name).unwrap_or_else(|| panic!("{name}: {fields:?}"))
    };
    assert_eq!(
        (&of("period_s")["path"], &of("period_s")["unit"]),
        (&"results[0].period_s".into(), &"s".into())
    );
    assert!(!of("nome")["meaning"].as_str().unwrap().is_empty());
    // The exact period and the formula's have the same name, so that both have their paths.
    assert_eq!(of("results[0].formulas[0].ratio")["path"], "results[0].formulas[0].ratio");
    assert!(fields.iter().all(|field| field["name"] != "schema"));
}

#[test]
fn another_sweep_is_refused() {
    let folder = directory("sweep-other").join("d");
    succeeded(&sweep(QUESTION, &folder, &[]));
    let before = chunks(&folder);
    let cases = [
        ("A=1:1.2:0.1", "A=1:1.3:0.1", "axis A has other values"),
        ("c=1/2", "c=1/3", "its command is"),
        ("state[1]", "state[0]", "it keeps"),
        ("--chunk|2", "--chunk|3", "its chunks have 2 points"),
        ("theta=", "theta'=", "its command is"),
    ];
    for (from, to, reason) in cases {
        let output = sweep(&QUESTION.replace(from, to), &folder, &[]);
        assert_eq!(output.status.code(), Some(1), "{to}");
        assert!(message(&output).contains(reason), "{to}: {}", message(&output));
    }
    let manifest = folder.join("sweep.json");
    let text = fs::read_to_string(&manifest).unwrap();
    let changed = [
        (text.replace("\"format\": 1", "\"format\": 2"), "its format is 2"),
        (text.replace("\"version\": \"", "\"version\": \"9."), "was begun by"),
        (text.replace("\"shape\"", "\"form\""), "not the plan of a sweep"),
        (text[..text.len() / 2].to_owned(), "sweep.json"),
    ];
    for (text, reason) in changed {
        fs::write(&manifest, text).unwrap();
        let output = sweep(QUESTION, &folder, &[]);
        assert_eq!(output.status.code(), Some(1), "{reason}");
        assert!(message(&output).contains(reason), "{}", message(&output));
    }
    assert_eq!(chunks(&folder), before);
    let full = directory("sweep-full");
    fs::write(full.join("letter.txt"), "dear").unwrap();
    assert!(message(&sweep(QUESTION, &full, &[])).contains("letter.txt"));
}

#[test]
fn questions_that_cannot_be_are_refused_before_anything_is_written() {
    let folder = directory("sweep-refused").join("d");
    let cases = [
        ("section|nonsense|--over|theta=1,2", "nonsense"),
        ("section|driven_pendulum|--over|B=1,2", "B"),
        ("period|--over|amplitude=190deg,200deg", "below pi"),
        ("period|60deg|--over|length=1:2", "give a step, too: length=1:2:STEP"),
        ("period|--over|amplitude=1,2|--keep|speed", "the results have no `speed`"),
        ("period|--over|amplitude=1,2|--over|amplitude=1,2", "each axis once"),
        ("period|{status}|--over|status=1,2", "every sweep"),
        ("derive|--over|road=elliptic", "not a query with numbers"),
        ("period 60deg|--over|length=1:2:1", "leave out the quotes"),
        ("period|--over|amplitude=1,2|--shard|3/2", "which of how many"),
    ];
    for (question, reason) in cases {
        let output = sweep(question, &folder, &[]);
        assert!([Some(1), Some(2)].contains(&output.status.code()), "{question}");
        assert!(message(&output).contains(reason), "{question}: {}", message(&output));
        assert!(!folder.exists(), "{question}");
    }
}

#[test]
fn a_damaged_chunk_is_made_again() {
    let folder = directory("sweep-damaged").join("d");
    succeeded(&sweep(QUESTION, &folder, &[]));
    let before = chunks(&folder);
    let path = folder.join("chunk-000003.csv");
    for damage in ["", "A,theta", &before["chunk-000003.csv"].replace('\n', "\n\n")] {
        fs::write(&path, damage).unwrap();
        succeeded(&sweep(QUESTION, &folder, &[]));
        assert_eq!(chunks(&folder), before);
    }
}

/// Killed at once, soon and later, again and again, until the sweep completes.
#[test]
fn a_killed_sweep_goes_on_where_it_was() {
    let folder = directory("sweep-killed");
    let question = QUESTION.replace("--skip|2", "--skip|300").replace("--chunk|2", "--chunk|1");
    let (undisturbed, killed) = (folder.join("undisturbed"), folder.join("killed"));
    succeeded(&sweep(&question, &undisturbed, &[]));
    let words: Vec<&str> = question.split('|').collect();
    for milliseconds in [1, 30, 60, 90, 120, 200] {
        let mut running = Command::new(env!("CARGO_BIN_EXE_libration"))
            .arg("sweep")
            .args(&words)
            .arg("--output")
            .arg(&killed)
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(milliseconds));
        running.kill().unwrap();
        running.wait().unwrap();
        let all = chunks(&undisturbed);
        if killed.exists() {
            assert!(chunks(&killed).iter().all(|(name, text)| all[name] == *text), "chunks are whole");
        }
    }
    succeeded(&sweep(&question, &killed, &[]));
    assert_eq!(chunks(&killed), chunks(&undisturbed));
    assert_eq!(joined(&[&killed], "json"), joined(&[&undisturbed], "json"));
}

/// A limit of the file size makes writes fail like a full disk.
#[cfg(unix)]
#[test]
fn a_full_disk_is_told_and_keeps_whole_chunks() {
    let folder = directory("sweep-full-disk").join("d");
    let question = "section|driven_pendulum|--set|c=1/2|--initial|theta=0.2|--points|40|--skip|1|--over|A=1:1.2:0.1\
                    |--keep|omega=points[0:40].state[1]|--chunk|1";
    // The first chunk exists already.
    succeeded(&sweep(question, &folder, &["--shard", "1/3"]));
    let words: Vec<&str> = question.split('|').collect();
    let output = Command::new("bash")
        .args([
            "-c",
            "trap '' XFSZ; ulimit -f 1; exec \"$@\"",
            "bash",
            env!("CARGO_BIN_EXE_libration"),
            "sweep",
        ])
        .args(&words)
        .arg("--output")
        .arg(&folder)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", message(&output));
    let said = message(&output);
    assert!(
        said.contains("cannot write") && said.contains("too large") && said.contains("continues"),
        "{said}"
    );
    assert_eq!(chunks(&folder).len(), 1);
    let names = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    assert!(names.into_iter().all(|name| !name.ends_with(".part")), "nothing half-written is left");
    succeeded(&sweep(question, &folder, &[]));
    assert_eq!(chunks(&folder).len(), 3);
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_keeps_the_chunks_that_are_done() {
    let folder = directory("sweep-interrupted").join("d");
    let question = "section|driven_pendulum|--set|c=1/2|--initial|theta=0.2|--points|1|--skip|500|--over|A=1:1.5:0.001\
                    |--keep|omega=points[0].state[1]|--chunk|1";
    let words: Vec<&str> = question.split('|').collect();
    let running = Command::new(env!("CARGO_BIN_EXE_libration"))
        .arg("sweep")
        .args(&words)
        .arg("--output")
        .arg(&folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    while !folder.exists() || chunks(&folder).is_empty() {
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(Command::new("kill").args(["-INT", &running.id().to_string()]).status().unwrap().success());
    let output = running.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{}", message(&output));
    assert!(message(&output).contains("continues from there"), "{}", message(&output));
    let done = chunks(&folder);
    assert!(!done.is_empty() && done.len() < 501, "{}", done.len());
    assert!(done.values().all(|text| text.ends_with(",0,\n")), "no result of an interrupted point is kept");
}

#[test]
fn what_behind_two_dashes_is_the_questions_own() {
    let folder = directory("sweep-dashes").join("d");
    let output = run(&[
        "sweep",
        "--over",
        "c=1/2,1/3",
        "--keep",
        "points[0].state[1]",
        "--output",
        folder.to_str().unwrap(),
        "--",
        "bifurcation",
        "driven_pendulum",
        "--over",
        "A=1",
        "--initial",
        "theta=0.2",
        "--points",
        "1",
        "--skip",
        "1",
    ]);
    succeeded(&output);
    assert_eq!(chunks(&folder).len(), 2);
}
