//! The options of a sweep stand before its question.

use libration_queries::internals::sweep_options::sweep_options_first;
use std::ffi::OsString;

fn ordered(words: &str) -> String {
    let words = words.split(' ').map(OsString::from).collect();
    let ordered: Vec<String> =
        sweep_options_first(words).into_iter().map(|word| word.into_string().unwrap()).collect();
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
