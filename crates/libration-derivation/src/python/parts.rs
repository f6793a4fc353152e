//! The functions that a notebook carries: those of `prelude.py` that its cells use.

use std::collections::BTreeSet;

/// All functions for computing the expressions, with Python's fractions and floats.
const PRELUDE: &str = include_str!("prelude.py");

/// The imports, and the functions and classes that these cells need.
pub(crate) fn prelude_for(cells: &[String]) -> String {
    let mut parts = PRELUDE.trim_end().split("\n\n\n");
    let head = parts.next().unwrap_or_default();
    let parts: Vec<&str> = parts.collect();
    let mut used: Vec<bool> = vec![false; parts.len()];
    let mut wanted: BTreeSet<&str> = cells.iter().flat_map(|cell| words(cell)).collect();
    while let Some(index) = (0..parts.len())
        .find(|index| !used[*index] && names(parts[*index]).iter().any(|name| wanted.contains(name)))
    {
        used[index] = true;
        wanted.extend(words(parts[index]));
    }
    let used = parts.iter().zip(&used).filter(|(_, is_used)| **is_used).map(|(part, _)| *part);
    std::iter::once(head).chain(used).collect::<Vec<_>>().join("\n\n\n")
}

/// The names that a part defines.
fn names(part: &str) -> Vec<&str> {
    let head = part.lines().find(|line| !line.starts_with('#')).unwrap_or_default();
    match head.strip_prefix("def ").or(head.strip_prefix("class ")) {
        Some(rest) => words(rest).take(1).collect(),
        None => head.split(" = ").take(1).flat_map(|names| names.split(", ")).collect(),
    }
}

fn words(code: &str) -> impl Iterator<Item = &str> {
    code.split(|letter: char| !letter.is_alphanumeric() && letter != '_')
}
