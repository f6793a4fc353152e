//! Names of options: one name has one meaning, and one meaning one name.

use libration_queries::{ParameterKind, questions};
use std::collections::{BTreeMap, BTreeSet};

/// Options whose help differs between queries, with the meaning that all have in common. Readers of tables have names of their own.
const SHARED: &[(&str, &str)] = &[
    ("about", "the equilibrium: a value of one variable, or of the coordinates of a system"),
    ("amplitude", "an amplitude"),
    ("amplitude-unit", "the unit of amplitudes in a table"),
    ("amplitudes", "a list or a range of amplitudes"),
    ("angle-scale", "the relative uncertainty of the scale of angles"),
    ("animate", "an animation in place of a picture"),
    ("at", "the point of a search: a value of the parameter, or the zero of a formula"),
    ("axes", "the two state variables of the picture"),
    ("bob-radius", "the radius of the bob"),
    ("clock", "the relative uncertainty of the clock"),
    ("columns", "columns: further ones of the output, or those of a table that is read"),
    ("damping-order", "the highest power of the small parameter"),
    ("delimiter", "the separator in a table that is read"),
    ("direction", "the direction of a zero crossing"),
    ("drive-periods", "periods of the drive in one period of the orbit"),
    ("figure", "the file of the picture of the result"),
    ("format", "the format of the text"),
    ("from", "the beginning of a range: times, or the horizontal axis of a picture"),
    ("gauge", "the meaning of the expansion parameter"),
    ("gravity", "the acceleration of free fall"),
    ("harmonics", "a limit of the harmonics: their number, or the highest"),
    ("header", "the line of names in a table that is read"),
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
    ("set", "the value of a parameter"),
    ("small", "the small parameter"),
    ("spectrum", "the spectrum: of a state variable, or of the recording"),
    ("time", "a duration; the column of times in a table that is read"),
    ("times", "a list or a range of times"),
    ("to", "the end of a range: times, or the horizontal axis of a picture"),
    ("tolerance", "the largest error: of a step, of a formula, or of omitted harmonics"),
    ("until", "the end of a motion: a time, or a condition"),
];

/// The options of all queries with their helps, without defaults and remarks.
fn helps() -> BTreeMap<String, BTreeSet<String>> {
    let mut helps = BTreeMap::<String, BTreeSet<String>>::new();
    let options = questions().into_iter().flat_map(|it| it.parameters);
    for option in options.filter(|it| it.kind != ParameterKind::Argument) {
        let help = option.meaning.split(" [default").next().unwrap().to_owned();
        helps.entry(option.name).or_default().insert(help);
    }
    helps
}

#[test]
fn an_option_has_one_meaning_in_all_queries() {
    let several = helps().into_iter().filter(|(_, helps)| helps.len() > 1);
    let found: Vec<String> = several.map(|(name, _)| name).collect();
    let expected: Vec<&str> = SHARED.iter().map(|(name, _)| *name).collect();
    assert_eq!(found, expected, "options with several helps, and those whose common meaning is stated");
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
