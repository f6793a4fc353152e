//! The paths in a Rust file, as far as they are needed to distinguish files.

/// The names between the `::`.
pub(crate) type Path = Vec<String>;

/// One name that a `use` declaration imports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Item {
    pub(crate) path: Path,
    /// The name in the importing file.
    pub(crate) name: String,
    /// `true` if the name is re-exported.
    pub(crate) handed_on: bool,
}

/// All names that the `use` declarations of a file import.
pub(crate) fn use_items(code: &str) -> Vec<Item> {
    let mut items = vec![];
    for (start, declaration) in declarations(code) {
        let before = code[..start].rsplit(['\n', ';', '}']).next().unwrap_or_default();
        for (path, name) in tree(&[], declaration) {
            items.push(Item { path, name, handed_on: before.trim_start().starts_with("pub") });
        }
    }
    items
}

/// The position of each `use`, and the text after it up to the semicolon.
fn declarations(code: &str) -> impl Iterator<Item = (usize, &str)> {
    code.match_indices("use ").filter_map(|(start, word)| {
        let alone = code[..start].chars().next_back().is_none_or(char::is_whitespace);
        let rest = &code[start + word.len()..];
        let declaration = &rest[..rest.find(';')?];
        // In a sentence, other characters stand before the next semicolon.
        let is_path =
            |letter: char| letter.is_alphanumeric() || letter.is_whitespace() || "_:{},*".contains(letter);
        Some((start, declaration)).filter(|_| alone && declaration.chars().all(is_path))
    })
}

/// The paths of a tree such as `a::{b, c::{d, e as f}}`, with the names that they get.
fn tree(prefix: &[String], text: &str) -> Vec<(Path, String)> {
    let (head, list) = match text.split_once('{') {
        Some((head, list)) => (head, Some(list.rsplit_once('}').map_or(list, |(inner, _)| inner))),
        None => (text, None),
    };
    let (head, alias) =
        head.split_once(" as ").map_or((head, None), |(head, alias)| (head, Some(alias.trim())));
    let names = head.split("::").map(|name| name.trim().to_owned()).filter(|name| !name.is_empty());
    let path: Path = prefix.iter().cloned().chain(names).collect();
    match list {
        Some(list) => items(list).iter().flat_map(|item| tree(&path, item)).collect(),
        None => {
            let path: Path = path.into_iter().filter(|name| name != "self" || prefix.is_empty()).collect();
            let name = alias.map(str::to_owned).or_else(|| path.last().cloned()).unwrap_or_default();
            vec![(path, name)]
        }
    }
}

/// The items of a list, separated by commas outside braces.
fn items(list: &str) -> Vec<String> {
    let (mut depth, mut items) = (0_usize, vec![String::new()]);
    for letter in list.chars() {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                items.push(String::new());
                continue;
            }
            _ => {}
        }
        items.last_mut().unwrap().push(letter);
    }
    items.retain(|item| !item.trim().is_empty());
    items
}

/// Paths of at least two names outside `use` declarations.
pub(crate) fn inline_paths(code: &str) -> Vec<Path> {
    let mut rest = code.to_owned();
    for (start, declaration) in declarations(code).collect::<Vec<_>>() {
        rest.replace_range(
            start..start + "use ".len() + declaration.len(),
            &" ".repeat("use ".len() + declaration.len()),
        );
    }
    let is_part = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == ':';
    let words = rest.split(|letter| !is_part(letter)).filter(|word| word.contains("::"));
    let paths = words.map(|word| word.split("::").map(str::to_owned).collect::<Path>());
    paths.filter(|path| path.iter().all(|name| !name.is_empty() && !name.contains(':'))).collect()
}

#[test]
fn paths_are_found_in_every_spelling() {
    let code = "use crate::a::X;\npub(crate) use b::{c::{Y, Z as W}, self};\nfn f() { super::g::h(); plain::<T>(); }";
    let named = |path: &str, name: &str, handed_on| Item {
        path: path.split("::").map(str::to_owned).collect(),
        name: name.to_owned(),
        handed_on,
    };
    let expected = [
        named("crate::a::X", "X", false),
        named("b::c::Y", "Y", true),
        named("b::c::Z", "W", true),
        named("b", "b", true),
    ];
    assert_eq!(use_items(code), expected);
    assert_eq!(inline_paths(code), [["super", "g", "h"].map(str::to_owned)]);
}
