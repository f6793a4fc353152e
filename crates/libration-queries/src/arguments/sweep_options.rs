//! The options of a sweep among the words of its question: `sweep period --over amplitude=1,2 --length 2m --output DIR`.

use std::ffi::OsString;

/// The options of a sweep that take a value.
const OPTIONS: [&str; 6] = ["--over", "--output", "-o", "--keep", "--shard", "--chunk"];

/// Moves the options of a sweep before its query, which then begins after `--`; everything after an existing `--` belongs to the query.
pub fn sweep_options_first(arguments: Vec<OsString>) -> Vec<OsString> {
    let word =
        |index: usize| arguments.get(index).and_then(|word: &OsString| word.to_str()).unwrap_or_default();
    if word(0) != "sweep" || ["join", "status", "help"].contains(&word(1)) {
        return arguments;
    }
    let (mut options, mut question) = (vec![], vec![]);
    let mut words = arguments.into_iter().skip(1);
    while let Some(word) = words.next() {
        let text = word.to_str().unwrap_or_default();
        match text {
            "--" => question.extend(words.by_ref()),
            "--help" | "-h" => options.push(word),
            _ if OPTIONS.contains(&text) => options.extend([Some(word), words.next()].into_iter().flatten()),
            _ if OPTIONS.iter().any(|option| is_given_by(text, option)) => options.push(word),
            _ => question.push(word),
        }
    }
    let separator = (!question.is_empty()).then(|| "--".into());
    std::iter::once("sweep".into()).chain(options).chain(separator).chain(question).collect()
}

/// Returns `true` if a word is the option with its value, `--output=DIR`.
fn is_given_by(word: &str, option: &str) -> bool {
    word.strip_prefix(option).is_some_and(|rest| rest.starts_with('='))
}
