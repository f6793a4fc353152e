//! The options of a sweep among the words of its question: `sweep period --over amplitude=1,2 --length 2m --output DIR`.

use std::ffi::OsString;

/// Those that take a value.
const OPTIONS: [&str; 5] = ["--over", "--output", "--keep", "--shard", "--chunk"];

/// Brings the options of a sweep before its question, which begins behind `--` then; all that stands behind a `--` is the question's.
pub(crate) fn sweep_options_first(arguments: Vec<OsString>) -> Vec<OsString> {
    let word =
        |place: usize| arguments.get(place).and_then(|word: &OsString| word.to_str()).unwrap_or_default();
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

/// Whether a word is the option with its value, `--output=DIR`.
fn is_given_by(word: &str, option: &str) -> bool {
    word.strip_prefix(option).is_some_and(|rest| rest.starts_with('='))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ordered(words: &str) -> String {
        let words = words.split(' ').map(OsString::from).collect();
        let ordered: Vec<String> =
            sweep_options_first(words).into_iter().map(|it| it.into_string().unwrap()).collect();
        ordered.join(" ")
    }

    #[test]
    fn options_of_the_sweep_stand_anywhere_before_two_dashes() {
        let expected = "sweep --over a=1,2 --output=d -- period {a} --length 2m";
        assert_eq!(ordered("sweep --over a=1,2 --output=d period {a} --length 2m"), expected);
        assert_eq!(ordered("sweep period --over a=1,2 {a} --length 2m --output=d"), expected);
        assert_eq!(
            ordered("sweep --over a=1 --output d -- bifurcation x --over b=1"),
            "sweep --over a=1 --output d -- bifurcation x --over b=1"
        );
        assert_eq!(ordered("sweep period --help"), "sweep --help -- period");
    }

    #[test]
    fn other_commands_are_left_as_they_are() {
        for words in
            ["sweep join a --output b", "sweep status a", "bifurcation x --over a=1", "sweep", "sweep --help"]
        {
            assert_eq!(ordered(words), words);
        }
    }
}
