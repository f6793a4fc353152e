//! The map of the crates and their modules, which ARCHITECTURE.md draws, against the code.

mod circles;
mod map;
mod paths;
mod source;

use std::collections::{BTreeMap, BTreeSet};

use map::{CRATES, Map};
use source::Source;

/// Modules of `libration` that all others may use.
const COMMON: [&str; 5] = ["quantity", "double_double", "dispatch", "fused", "elementary"];

/// What the files of each top module use of other top modules, unit tests left out.
fn uses(source: &Source) -> BTreeMap<String, BTreeSet<String>> {
    let mut uses: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (from, to) in source.edges() {
        let (Some(module), Some(other)) = (from.first(), to.first()) else { continue };
        let used = uses.entry(module.clone()).or_default();
        if module != other {
            used.insert(other.clone());
        }
    }
    uses
}

#[test]
fn every_module_stands_in_the_architecture_once() {
    let map = Map::read();
    for name in CRATES {
        let rows: Vec<&str> = map.rows(name).map(|row| row.module.as_str()).collect();
        let listed: BTreeSet<&str> = rows.iter().copied().collect();
        assert_eq!(rows.len(), listed.len(), "{name} has a module in two rows: {rows:?}");
        let source = Source::of(name);
        let present: BTreeSet<&str> = source.top_modules().collect();
        assert_eq!(listed, present, "{name}");
    }
}

#[test]
fn every_module_uses_what_the_architecture_says() {
    let map = Map::read();
    for name in CRATES {
        let uses = uses(&Source::of(name));
        let common = |module: &str| name == "libration" && COMMON.contains(&module);
        for row in map.rows(name) {
            let used: BTreeSet<&str> =
                uses.get(&row.module).into_iter().flatten().map(String::as_str).collect();
            let told = |module: &&&str| row.uses.iter().any(|told| told == **module) || common(module);
            let secret: Vec<_> = used.iter().filter(|module| !told(module)).collect();
            assert!(
                secret.is_empty(),
                "{name}: {} uses {secret:?}, which the architecture does not say",
                row.module
            );
            let unused: Vec<_> = row.uses.iter().filter(|told| !used.contains(told.as_str())).collect();
            assert!(
                unused.is_empty(),
                "{name}: {} does not use {unused:?}, as the architecture says",
                row.module
            );
        }
    }
}

#[test]
fn files_beside_each_other_do_not_go_in_circles() {
    let mut found = BTreeSet::new();
    for name in CRATES {
        for (folder, circle) in circles::circles(&Source::of(name)) {
            found.insert(format!("{name}: {folder}: {}", circle.join(" ")));
        }
    }
    let known: BTreeSet<String> = circles::REMAINING.iter().map(|&circle| circle.to_owned()).collect();
    let new: Vec<_> = found.difference(&known).collect();
    assert!(new.is_empty(), "circles of files: {new:#?}");
    let gone: Vec<_> = known.difference(&found).collect();
    assert!(gone.is_empty(), "no longer circles, to be taken off the list: {gone:#?}");
}

#[test]
fn every_file_is_compiled() {
    for name in CRATES {
        let source = Source::of(name);
        let orphans: Vec<_> = source.orphans().map(|module| module.join("/")).collect();
        assert!(orphans.is_empty(), "{name} has files that no `mod` declares: {orphans:?}");
    }
}

#[test]
fn crates_depend_on_those_below_them() {
    for (place, name) in CRATES.iter().enumerate() {
        let manifest = std::fs::read_to_string(source::folder(name).join("Cargo.toml")).unwrap();
        for above in &CRATES[place..] {
            let dependency = format!("{above}.workspace");
            assert!(!manifest.lines().any(|line| line.starts_with(&dependency)), "{name} depends on {above}");
        }
    }
}
