//! Comparison of the code with the map of crates and modules in `crates/modules.toml` and ARCHITECTURE.md.
#![expect(clippy::unwrap_used, reason = "a test that cannot read the sources should stop there")]

mod circles;
mod map;
mod paths;
mod source;
mod tour;

use std::collections::{BTreeMap, BTreeSet};

use map::{Map, described};
use source::Source;

/// The modules that the files of each top-level module use, of the same crate and of other mathematics crates.
fn uses(source: &Source) -> BTreeMap<String, BTreeSet<String>> {
    let mut uses: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (from, to) in source.edges() {
        let (Some(module), Some(other)) = (from.first(), to.first()) else { continue };
        let used = uses.entry(module.clone()).or_default();
        if module != other {
            used.insert(other.clone());
        }
    }
    for (from, other) in source.foreign() {
        if let Some(module) = from.first() {
            uses.entry(module.clone()).or_default().insert(other);
        }
    }
    uses
}

#[test]
fn every_module_is_on_the_map_and_described_once() {
    let described = described();
    for section in Map::read().crates {
        let source = Source::of(&section.name);
        let present: BTreeSet<&str> = source.top_modules().collect();
        let on_map: Vec<&str> = section.modules.iter().map(|(module, _)| module.as_str()).collect();
        let in_words: Vec<&str> = described[&section.name].iter().map(String::as_str).collect();
        for (listed, by) in [(on_map, "crates/modules.toml"), (in_words, "ARCHITECTURE.md")] {
            let once: BTreeSet<&str> = listed.iter().copied().collect();
            assert_eq!(
                listed.len(),
                once.len(),
                "{by}: {} has a module in two rows: {listed:?}",
                section.name
            );
            assert_eq!(once, present, "{by}: {}", section.name);
        }
    }
}

#[test]
fn every_module_uses_what_the_map_allows() {
    let map = Map::read();
    for section in &map.crates {
        let (name, uses) = (&section.name, uses(&Source::of(&section.name)));
        for (module, allowed) in &section.modules {
            let used = uses.get(module).cloned().unwrap_or_default();
            let is_common = |other: &&String| map.is_mathematics(name) && map.common.contains(other);
            let secret: Vec<_> =
                used.iter().filter(|module| !allowed.contains(module) && !is_common(module)).collect();
            assert!(
                secret.is_empty(),
                "{name}: {module} uses {secret:?}, which crates/modules.toml does not allow"
            );
            let unused: Vec<_> = allowed.iter().filter(|other| !used.contains(*other)).collect();
            assert!(
                unused.is_empty(),
                "{name}: {module} does not use {unused:?}, which crates/modules.toml allows"
            );
        }
    }
}

#[test]
fn files_beside_each_other_do_not_go_in_circles() {
    let mut circles = BTreeSet::new();
    for section in Map::read().crates {
        for (folder, circle) in circles::circles(&Source::of(&section.name)) {
            circles.insert(format!("{}: {folder}: {}", section.name, circle.join(" ")));
        }
    }
    let remaining: BTreeSet<String> = circles::REMAINING.iter().map(|&circle| circle.to_owned()).collect();
    let new: Vec<_> = circles.difference(&remaining).collect();
    assert!(new.is_empty(), "circles of files: {new:#?}");
    let gone: Vec<_> = remaining.difference(&circles).collect();
    assert!(gone.is_empty(), "no longer circles, to be taken off the list: {gone:#?}");
}

#[test]
fn every_file_is_compiled() {
    for section in Map::read().crates {
        let source = Source::of(&section.name);
        let orphans: Vec<_> = source.orphans().map(|module| module.join("/")).collect();
        assert!(orphans.is_empty(), "{} has files that no `mod` declares: {orphans:?}", section.name);
    }
}

/// The dependencies, except those of tests, lead downwards: the graph of the crates has no cycle.
#[test]
fn crates_depend_on_those_below_them() {
    let map = Map::read();
    for (index, section) in map.crates.iter().enumerate() {
        let manifest = std::fs::read_to_string(source::folder(&section.name).join("Cargo.toml")).unwrap();
        let dependencies = manifest.split("[dev-dependencies]").next().unwrap();
        for above in &map.crates[index..] {
            let dependency = format!("{}.workspace", above.name);
            assert!(
                !dependencies.lines().any(|line| line.starts_with(&dependency)),
                "{} depends on {}",
                section.name,
                above.name
            );
        }
    }
}
