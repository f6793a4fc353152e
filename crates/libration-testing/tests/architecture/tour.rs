//! The tours of the crates that users import: each `lib.rs` documents its modules in a table.

use super::source;
use std::collections::BTreeSet;

const IMPORTED: [&str; 4] = ["libration", "libration-lab", "libration-derivation", "libration-queries"];

/// Names of the public modules of a `lib.rs`: its own modules, and re-exported modules of other crates of the project.
fn public_modules(lib: &str) -> BTreeSet<&str> {
    let shown = lib.split("#[doc(hidden)]").next().unwrap();
    let declared = shown.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';'));
    let exports = shown.split("pub use libration_").skip(1);
    let exported =
        exports.filter_map(|export| export.split_once(';')?.0.split_once("::")).flat_map(|(_, names)| {
            let names = names.trim_start_matches('{').trim_end_matches('}').split(',').map(str::trim);
            names.filter(|name| name.starts_with(char::is_lowercase) && !name.contains("::"))
        });
    declared.chain(exported).collect()
}

#[test]
fn every_public_module_is_in_one_row_of_the_tour() {
    for name in IMPORTED {
        let lib = std::fs::read_to_string(source::folder(name).join("src/lib.rs")).unwrap();
        let modules = public_modules(&lib);
        let rows = lib.lines().filter_map(|line| line.strip_prefix("//! | [`")?.split('`').next());
        let mut listed: Vec<&str> = rows.filter(|row| modules.contains(row)).collect();
        listed.sort_unstable();
        assert_eq!(listed, modules.into_iter().collect::<Vec<_>>(), "{name}");
    }
}

#[test]
fn a_module_without_a_row_is_seen() {
    let lib = "pub mod fit;\npub use libration_a::{chaos, fused::rounds_once};\n#[doc(hidden)]\npub mod internals {}\n";
    assert_eq!(public_modules(lib), BTreeSet::from(["chaos", "fit"]));
}
