//! The map of the crates: `crates/modules.toml` states the uses that are allowed, the tables of ARCHITECTURE.md the content of each module.

use std::collections::{BTreeMap, BTreeSet};

const MODULES: &str = include_str!("../../../modules.toml");
const ARCHITECTURE: &str = include_str!("../../../../ARCHITECTURE.md");

/// The modules of one crate, each with the modules that it may use.
#[derive(Debug)]
pub(crate) struct Section {
    pub(crate) name: String,
    pub(crate) modules: Vec<(String, Vec<String>)>,
}

#[derive(Debug)]
pub(crate) struct Map {
    /// The crates from the bottom up.
    pub(crate) crates: Vec<Section>,
    /// The modules that every mathematics module may use.
    pub(crate) common: Vec<String>,
}

/// The texts between pairs of a quotation mark.
fn quoted(text: &str, mark: char) -> Vec<String> {
    text.split(mark).skip(1).step_by(2).map(str::to_owned).collect()
}

impl Map {
    pub(crate) fn read() -> Self {
        let (mut crates, mut common): (Vec<Section>, _) = (vec![], vec![]);
        for line in MODULES.lines().filter(|line| !line.starts_with('#') && !line.is_empty()) {
            if let Some(name) = line.strip_prefix('[') {
                crates.push(Section { name: name.trim_end_matches(']').to_owned(), modules: vec![] });
                continue;
            }
            let (module, uses) = line.split_once(" = ").unwrap();
            match crates.last_mut() {
                Some(section) => section.modules.push((module.to_owned(), quoted(uses, '"'))),
                None => common = quoted(uses, '"'),
            }
        }
        Self { crates, common }
    }

    /// Returns `true` for a mathematics crate, for which uses of modules of other crates are listed too.
    pub(crate) fn is_mathematics(&self, name: &str) -> bool {
        let index = |name: &str| self.crates.iter().position(|section| section.name == name).unwrap();
        (index("libration-kernels")..=index("libration-branches")).contains(&index(name))
    }
}

/// The modules that ARCHITECTURE.md describes, by crate: a heading with the name of the crate, then rows whose first cell names one or more modules.
pub(crate) fn described() -> BTreeMap<String, Vec<String>> {
    let names: BTreeSet<String> = Map::read().crates.into_iter().map(|section| section.name).collect();
    let (mut described, mut heading) = (BTreeMap::<String, Vec<String>>::new(), None);
    for line in ARCHITECTURE.lines() {
        if line.starts_with('#') {
            heading = quoted(line, '`').into_iter().find(|name| names.contains(name));
        }
        if let (Some(name), true) = (&heading, line.starts_with("| `")) {
            let cell = line.split(" | ").next().unwrap_or_default();
            described.entry(name.clone()).or_default().extend(quoted(cell, '`'));
        }
    }
    described
}
