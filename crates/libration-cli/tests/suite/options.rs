//! Each option name has one meaning and each meaning one name; parameters have types.

use libration_queries::{ParameterKind, ParameterType, questions};
use std::collections::{BTreeMap, BTreeSet};

/// Options whose help differs between queries, with the common meaning. The options of commands that read tables are listed separately.
const SHARED: &[(&str, &str)] = &[
    ("about", "the equilibrium: a value of one variable, or of the coordinates of a system"),
    ("amplitude", "an amplitude"),
    ("amplitude-unit", "the unit of amplitudes in a table"),
    ("amplitudes", "a list or a range of amplitudes"),
    ("angle-scale", "the relative uncertainty of the scale of angles"),
    ("animate", "an animation in place of a picture"),
    ("at", "the point of a search: a value of the parameter, or the zero of a formula"),
    ("axes", "the two state variables of the picture"),
    ("clock", "the relative uncertainty of the clock"),
    ("columns", "columns: further ones of the output, or those of a table that is read"),
    ("damping-order", "the highest power of the small parameter"),
    ("direction", "the direction of a zero crossing"),
    ("drive-periods", "periods of the drive in one period of the orbit"),
    ("figure", "the file of the picture of the result"),
    ("format", "the format of the text"),
    (
        "from",
        "the beginning of a range: times, the first quantity of a table, or the horizontal axis of a picture",
    ),
    ("gauge", "the meaning of the expansion parameter"),
    ("gravity", "the acceleration of free fall"),
    ("harmonics", "a limit of the harmonics: their number, or the highest"),
    ("initial", "the state at the start; several times for several motions"),
    ("length", "the length of the pendulum"),
    ("linear", "the coefficient of linear damping"),
    ("lowest", "the lower end of the vertical axis of a picture"),
    ("model", "the model of a fit"),
    ("order", "the order of an expansion"),
    ("output", "the file or directory of the result"),
    ("over", "a parameter with its range or values"),
    ("period", "a period"),
    ("quantity", "the quantity that is expanded"),
    ("resonance", "drive frequency over a natural frequency"),
    ("run", "the run of a recording, or the group of a table"),
    ("set", "the value of a parameter"),
    ("small", "the small parameter"),
    ("spectrum", "the spectrum: of a state variable, or of the recording"),
    ("time", "a duration; the column of times in a table that is read"),
    ("times", "a list or a range of times"),
    ("to", "the end of a range: times, the first quantity of a table, or the horizontal axis of a picture"),
    ("tolerance", "the largest error: of a step, of a formula, or of omitted harmonics"),
    ("until", "the end of a motion: a time, or a condition"),
];

/// The options of all queries with their help texts, without defaults and remarks.
fn helps() -> BTreeMap<String, BTreeSet<String>> {
    let mut helps = BTreeMap::<String, BTreeSet<String>>::new();
    let options = questions().into_iter().flat_map(|question| question.parameters);
    for option in options.filter(|option| option.kind != ParameterKind::Argument) {
        let help = option.meaning.split(" [default").next().unwrap().to_owned();
        helps.entry(option.name).or_default().insert(help);
    }
    helps
}

#[test]
fn an_option_has_one_meaning_in_all_queries() {
    let several = helps().into_iter().filter(|(_, helps)| helps.len() > 1);
    let names: Vec<String> = several.map(|(name, _)| name).collect();
    let expected: Vec<&str> = SHARED.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, expected, "options with several helps, and those whose common meaning is stated");
}

#[test]
fn a_meaning_has_one_option() {
    let mut names = BTreeMap::<String, Vec<String>>::new();
    for (name, helps) in helps() {
        helps.into_iter().for_each(|help| names.entry(help).or_default().push(name.clone()));
    }
    names.retain(|_, names| names.len() > 1);
    assert!(names.is_empty(), "{names:?}");
}

/// Parameters that are read as text, with the notation that a type would imply.
const TEXTS: &[(&str, &str)] = &[
    ("about", "a number or an angle; coordinates with values"),
    ("amplitudes", "a list or range of numbers or of angles, as the variable of the equation has it"),
    ("answer", "the number of a formula with a formula"),
    ("axes", "two coordinates"),
    ("columns", "columns of a table; formulas with names"),
    ("command", "words of a command"),
    ("entries", "catalogues or keys"),
    ("evaluate", "a number or an angle, as the variable of the equation has it"),
    ("events", "kinds of events or formulas"),
    ("initial", "coordinates with values"),
    ("keep", "a path in JSON"),
    ("label", "part of a label"),
    ("letters", "names of parameters"),
    ("question", "words of a command"),
    ("ratios", "whole numbers with colons"),
    ("resonance", "a quotient of whole numbers"),
    ("role", "a column with its role"),
    ("run", "a run by its name or number, or several"),
    ("sensitivity", "names of parameters and coordinates"),
    ("set", "parameters with values"),
    ("small", "the name of a parameter"),
    ("to", "a number or an angle, as the variable of the equation has it"),
    ("until", "an equation or a formula"),
];

#[test]
fn parameters_have_types() {
    let parameters = questions().into_iter().flat_map(|question| question.parameters);
    let texts: BTreeSet<String> = parameters
        .filter(|parameter| parameter.value_type == ParameterType::Text)
        .map(|parameter| parameter.name)
        .collect();
    let expected: BTreeSet<String> = TEXTS.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(texts, expected, "parameters without a type, and those that are known to be text");
}

#[test]
fn types_are_those_of_the_values() {
    let questions = questions();
    let of = |words: &str, name: &str| {
        let query = questions.iter().find(|question| question.words == words).unwrap();
        query.parameters.iter().find(|parameter| parameter.name == name).unwrap().value_type
    };
    for (words, name, expected) in [
        ("motion", "angle", ParameterType::Angle),
        ("motion", "velocity", ParameterType::Number),
        ("motion", "times", ParameterType::Numbers),
        ("motion", "animate", ParameterType::Flag),
        ("motion", "figure", ParameterType::File),
        ("motion", "size", ParameterType::Choice),
        ("period", "length", ParameterType::Quantity),
        ("period", "formulas", ParameterType::Key),
        ("orbit", "system", ParameterType::Equation),
        ("orbit", "hold", ParameterType::Coordinate),
        ("orbit", "drive-periods", ParameterType::Integer),
        ("section", "at", ParameterType::Formula),
        ("response", "over", ParameterType::Range),
        ("inspect", "angle", ParameterType::Column),
    ] {
        assert_eq!(of(words, name), expected, "{words} {name}");
    }
}

#[test]
fn former_names_of_options_are_hidden_and_accepted() {
    let command = libration_queries::command([]);
    for (words, former, now) in [
        ("fit periods", "linear-damping", "linear"),
        ("fit gates", "linear-damping", "linear"),
        ("plan", "linear-damping", "linear"),
        ("fit trace", "unit", "angle-unit"),
        ("fit gates", "unit", "angle-unit"),
        ("inspect", "unit", "angle-unit"),
        ("figure trajectories", "until", "to"),
        ("figure trajectories", "show", "axis"),
        ("figure spectrum", "highest", "harmonics"),
        ("melnikov", "orders", "max-drive-periods"),
    ] {
        let query = words.split(' ').fold(&command, |of, word| of.find_subcommand(word).unwrap());
        let option = query.get_arguments().find(|argument| argument.get_long() == Some(now)).unwrap();
        assert_eq!(option.get_all_aliases(), Some(vec![former]), "{words}");
        assert!(option.get_visible_aliases().unwrap_or_default().is_empty(), "{words}");
    }
}
