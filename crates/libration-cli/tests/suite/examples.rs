//! Every example in the help and in the README, run in a shell as printed, from a copy of the clone.

use crate::command::{directory, run};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The width of the help.
const HELP_WIDTH: usize = 80;

/// A fresh copy of the tracked files, since examples use data and texts of the project.
pub(crate) fn clone_of_the_project(name: &str) -> PathBuf {
    let clone = directory(name);
    let root = root();
    for folder in
        [root.join("examples/class"), root.join("examples/phone"), root.join("examples"), root.clone()]
    {
        let inside = clone.join(folder.strip_prefix(&root).unwrap());
        fs::create_dir_all(&inside).unwrap();
        for entry in fs::read_dir(&folder).unwrap().map(Result::unwrap) {
            if entry.file_type().unwrap().is_file() {
                fs::copy(entry.path(), inside.join(entry.file_name())).unwrap();
            }
        }
    }
    clone
}

pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

/// Runs a line of shell with the command on the path.
pub(crate) fn in_shell(line: &str, folder: &Path) -> Output {
    let command = Path::new(env!("CARGO_BIN_EXE_libration")).parent().unwrap().to_owned();
    let path = std::env::var_os("PATH").unwrap();
    let paths = std::iter::once(command).chain(std::env::split_paths(&path));
    Command::new("bash")
        .args(["-euo", "pipefail", "-c", line])
        .current_dir(folder)
        .env("PATH", std::env::join_paths(paths).unwrap())
        .env_remove("COLUMNS")
        .output()
        .unwrap()
}

fn answer(line: &str, folder: &Path) -> String {
    let output = in_shell(line, folder);
    let (message, text) = (String::from_utf8_lossy(&output.stderr), String::from_utf8_lossy(&output.stdout));
    assert!(output.status.success(), "{line}\nends with {}: {message}", output.status);
    text.into_owned()
}

/// The commands, each as its words, including those that only group others.
pub(crate) fn commands() -> Vec<Vec<String>> {
    let mut queries = vec![vec![]];
    let mut next = 0;
    while let Some(words) = queries.get(next).cloned() {
        queries
            .extend(subcommands(&help(&words)).into_iter().map(|name| [words.clone(), vec![name]].concat()));
        next += 1;
    }
    queries
}

pub(crate) fn help(words: &[String]) -> String {
    let words: Vec<&str> = words.iter().map(String::as_str).chain(["--help"]).collect();
    let output = run(&words);
    assert!(output.status.success(), "{words:?}");
    String::from_utf8(output.stdout).unwrap()
}

fn subcommands(help: &str) -> Vec<String> {
    // The help of the program lists the commands in groups with titles.
    let is_list = |line: &&str| !line.is_empty() || !help.contains("\nCommands:\n");
    let begins = |line: &str| line == "Commands:" || line.starts_with("Usage: libration [OPTIONS] <COMMAND>");
    let list = help.lines().skip_while(|line| !begins(line)).skip(1);
    let list = list.take_while(|line| *line != "Options:").take_while(is_list);
    let names = list.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    names
        .filter_map(|line| line.split_whitespace().next())
        .filter(|name| *name != "help")
        .map(str::to_owned)
        .collect()
}

/// The examples of a help text; a line that ends in a backslash is joined with the next.
pub(crate) fn examples(help: &str) -> Vec<String> {
    let list = help.lines().skip_while(|line| !line.starts_with("Example")).skip(1);
    let mut examples: Vec<String> = vec![];
    let mut is_continued = false;
    for line in list.take_while(|line| line.starts_with("  ")) {
        match examples.last_mut().filter(|_| is_continued) {
            Some(example) => *example += &format!("\n{line}"),
            None => examples.push(line.trim_start().to_owned()),
        }
        is_continued = line.ends_with('\\');
    }
    examples
}

fn columns(line: &str) -> usize {
    line.chars().count()
}

#[test]
fn every_command_has_examples_and_its_help_fits_a_terminal() {
    let commands = commands();
    assert!(commands.len() > 25, "{commands:?}");
    for words in commands {
        let help = help(&words);
        assert!(!examples(&help).is_empty(), "{words:?} has no examples");
        for line in help.lines() {
            assert!(columns(line) <= HELP_WIDTH, "{words:?}: {line}");
        }
    }
}

/// Runs the examples of the commands whose index is `part` modulo `parts`; `page` exists only in commands built with it.
fn examples_run(part: usize, parts: usize) {
    let all = commands().into_iter().filter(|words| *words != ["page"]).enumerate();
    for (number, words) in all.filter(|(number, _)| number % parts == part) {
        let clone = clone_of_the_project(&format!("examples-{number}"));
        for example in examples(&help(&words)) {
            answer(&example, &clone);
        }
    }
}

#[test]
fn examples_of_the_help_run_as_printed_in_part_one() {
    examples_run(0, 2);
}

#[test]
fn examples_of_the_help_run_as_printed_in_part_two() {
    examples_run(1, 2);
}

/// A command with the output shown below it.
pub(crate) struct Shown {
    pub(crate) command: String,
    output: Vec<String>,
}

/// The console blocks of a document.
pub(crate) fn shown_in(text: &str) -> Vec<Shown> {
    let mut shown: Vec<Shown> = vec![];
    let mut is_inside = false;
    for line in text.lines() {
        match (is_inside, line.strip_prefix("$ ")) {
            (false, _) => is_inside = line == "```console",
            (true, _) if line == "```" => is_inside = false,
            (true, Some(command)) => shown.push(Shown { command: command.to_owned(), output: vec![] }),
            (true, None) => shown.last_mut().unwrap().output.push(line.to_owned()),
        }
    }
    shown
}

/// Returns `true` if the lines equal those shown, in which … stands for any number of lines. Blank lines at the end are ignored.
fn is_shown(lines: &[&str], shown: &[String]) -> bool {
    match shown.split_first() {
        None => lines.iter().all(|line| line.is_empty()),
        Some((first, rest)) if first == "…" => (0..=lines.len()).any(|from| is_shown(&lines[from..], rest)),
        Some((first, rest)) if first.is_empty() && rest.is_empty() => is_shown(lines, rest),
        Some((first, rest)) => {
            lines.split_first().is_some_and(|(line, lines)| line == first && is_shown(lines, rest))
        }
    }
}

#[test]
fn the_readme_shows_what_comes_out() {
    let text = fs::read_to_string(root().join("README.md")).unwrap();
    let clone = clone_of_the_project("readme-shown");
    let shown = shown_in(&text);
    assert!(shown.len() >= 3);
    for Shown { command, output } in shown {
        assert!(!output.is_empty(), "{command}");
        let answer = answer(&command, &clone);
        let lines: Vec<&str> = answer.lines().collect();
        assert!(is_shown(&lines, &output), "{command}\nshown:\n{}\n\nwritten:\n{answer}", output.join("\n"));
    }
}

/// The commands in backquotes in tables, in indented blocks and in shell blocks.
pub(crate) fn commands_in(text: &str) -> Vec<String> {
    let quoted =
        text.lines().filter(|line| line.starts_with('|')).flat_map(|line| line.split('`').skip(1).step_by(2));
    let indented = text.lines().filter_map(|line| line.strip_prefix("    "));
    let released = text.lines().filter_map(|line| line.strip_prefix("cargo run --release -- "));
    let released = released.map(|line| format!("libration {line}"));
    let commands = quoted.chain(indented).filter(|text| text.starts_with("libration ")).map(str::to_owned);
    // `libration COMMAND` stands for any command.
    commands.chain(released).filter(|line| !line.contains("COMMAND")).collect()
}

#[test]
fn the_commands_of_the_readmes_run_and_do_not_flood_the_screen() {
    for (name, least) in [("README.md", 20), ("examples/README.md", 4)] {
        let text = fs::read_to_string(root().join(name)).unwrap();
        let clone = clone_of_the_project("readme-commands");
        let commands = commands_in(&text);
        assert!(commands.len() >= least, "{name}: {commands:?}");
        for command in commands {
            let answer = answer(&command, &clone);
            // A completion script and a table requested as CSV may be long.
            let is_long = command.contains("completions") || command.contains("--csv");
            assert!(is_long || answer.lines().count() <= MOST_LINES, "{command}: {}", answer.lines().count());
        }
    }
}

/// Largest length of a text result: those of the catalogues and of the paper with its evidence.
const MOST_LINES: usize = 400;

#[test]
fn a_wrong_output_would_be_seen() {
    let shown = |texts: &[&str]| texts.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>();
    assert!(is_shown(&["a", "b", "c"], &shown(&["a", "…", "c"])));
    assert!(is_shown(&["a", "b"], &shown(&["a", "…"])));
    assert!(!is_shown(&["a", "b", "c"], &shown(&["a", "c"])));
    assert!(!is_shown(&["a", "b"], &shown(&["…", "c"])));
    assert!(!is_shown(&["a", "b"], &shown(&["a"])));
}
