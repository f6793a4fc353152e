//! The map of the library's modules: which may use which. ARCHITECTURE.md draws it.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Every module of the library, in reading order, with the modules whose items it may use.
const MAP: &[(&str, &[&str])] = &[
    ("quantity", &[]),
    ("elliptic", &[]),
    ("pendulum", &["elliptic", "algebra"]),
    ("period_formulas", &["series", "algebra"]),
    ("algebra", &[]),
    ("series", &["algebra"]),
    ("linear", &["algebra"]),
    ("expression", &["series", "algebra"]),
    ("oscillator", &["expression", "algebra"]),
    ("perturbation", &["oscillator", "expression", "series", "algebra"]),
    ("comparison", &["perturbation", "oscillator", "pendulum", "orbit", "expression", "series", "algebra"]),
    ("taylor", &["expression", "series", "algebra"]),
    ("systems", &["taylor", "oscillator", "expression", "algebra"]),
    ("orbit", &["taylor", "expression", "linear", "algebra"]),
    ("normal_modes", &["expression", "linear", "algebra"]),
    ("decay", &["elliptic", "pendulum", "taylor"]),
    ("chaos", &["taylor", "expression", "algebra"]),
    (
        "derivation",
        &[
            "elliptic",
            "pendulum",
            "period_formulas",
            "algebra",
            "series",
            "expression",
            "oscillator",
            "perturbation",
            "comparison",
        ],
    ),
    ("measurement", &[]),
    ("fit", &["measurement", "pendulum", "taylor", "expression", "linear", "elliptic", "decay"]),
];

/// Private foundations, which every module may use; what they may use themselves.
const FOUNDATIONS: &[(&str, &[&str])] =
    &[("double_double", &[]), ("dispatch", &[]), ("elementary", &["double_double"])];

/// A module that all may use although it is public.
const COMMON: &str = "quantity";

fn source_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|it| it == "rs") {
            files.push(path);
        }
    }
    files
}

/// The first part of the path below `src`, without `.rs`.
fn module_of(file: &Path) -> String {
    let below = file.strip_prefix(source_folder()).unwrap();
    let first = below.iter().next().unwrap().to_str().unwrap();
    first.trim_end_matches(".rs").to_owned()
}

fn allowed(module: &str) -> Option<BTreeSet<&'static str>> {
    if let Some((_, uses)) = FOUNDATIONS.iter().find(|(name, _)| *name == module) {
        return Some(uses.iter().copied().collect());
    }
    let (_, uses) = MAP.iter().find(|(name, _)| *name == module)?;
    Some(uses.iter().copied().chain(FOUNDATIONS.iter().map(|(name, _)| *name)).chain([COMMON]).collect())
}

/// The modules named after `crate::` outside comments, also in a braced `use crate::{…}`.
fn modules_used(source: &str) -> BTreeSet<String> {
    let code: String =
        source.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n");
    let mut used = BTreeSet::new();
    for (_, rest) in code.match_indices("crate::").map(|(at, found)| (at, &code[at + found.len()..])) {
        match rest.strip_prefix('{') {
            Some(list) => used.extend(heads(list)),
            None => used.extend(heads(rest).into_iter().take(1)),
        }
    }
    used
}

/// The first identifier of each item of a `use` list, up to its closing brace.
fn heads(list: &str) -> Vec<String> {
    let (mut depth, mut found, mut word, mut fresh) = (0_usize, Vec::new(), String::new(), true);
    for letter in list.chars() {
        match letter {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            _ => {}
        }
        if fresh && (letter.is_alphanumeric() || letter == '_') {
            word.push(letter);
        } else if !word.is_empty() {
            found.push(core::mem::take(&mut word));
            fresh = false;
        }
        fresh = fresh || (depth == 0 && letter == ',');
        if letter == ';' {
            break;
        }
    }
    found.extend((!word.is_empty()).then_some(word));
    found
}

#[test]
fn every_module_uses_only_what_the_map_allows() {
    for file in rust_files(&source_folder()) {
        let module = module_of(&file);
        // Unit tests may compare with any module.
        if module == "lib" || file.ends_with("tests.rs") {
            continue;
        }
        let allowed = allowed(&module).unwrap_or_else(|| panic!("{module} is not on the map"));
        for used in modules_used(&fs::read_to_string(&file).unwrap()) {
            let fine = used == module || allowed.contains(used.as_str());
            assert!(fine, "{} uses crate::{used}, which {module} may not", file.display());
        }
    }
}

#[test]
fn the_map_names_no_module_that_is_missing() {
    let present: BTreeSet<String> = rust_files(&source_folder()).iter().map(|file| module_of(file)).collect();
    for (module, _) in MAP.iter().chain(FOUNDATIONS) {
        assert!(present.contains(*module), "{module} is on the map but not in src");
    }
}

#[test]
fn every_use_on_the_map_is_made() {
    for (module, uses) in MAP.iter().chain(FOUNDATIONS) {
        let files = rust_files(&source_folder()).into_iter();
        let files = files.filter(|file| module_of(file) == *module && !file.ends_with("tests.rs"));
        let used: BTreeSet<String> =
            files.flat_map(|file| modules_used(&fs::read_to_string(&file).unwrap())).collect();
        for other in *uses {
            assert!(used.contains(*other), "{module} does not use {other}, which the map allows it");
        }
    }
}

/// The names in backquotes.
fn quoted(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

#[test]
fn the_tables_of_the_architecture_are_the_map() {
    let text = include_str!("../../../../ARCHITECTURE.md");
    for (module, uses) in MAP.iter().chain(FOUNDATIONS) {
        let row = text.lines().find(|line| line.starts_with(&format!("| `{module}` |")));
        let cells: Vec<&str> = row.unwrap_or_else(|| panic!("{module} has no row")).split(" | ").collect();
        assert_eq!(quoted(cells.last().unwrap()), *uses, "{module}");
    }
}

#[test]
fn uses_are_found_in_every_spelling() {
    let source =
        "use crate::a::X;\n// crate::no\nuse crate::{b, c::{Y, Z}, d as e};\nfn f() { crate::g::h(); }";
    let expected = ["a", "b", "c", "d", "g"].map(str::to_owned);
    assert_eq!(modules_used(source), BTreeSet::from(expected));
}
