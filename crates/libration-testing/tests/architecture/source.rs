//! The files of a crate as modules, and the uses between them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use super::paths::{Path as UsePath, inline_paths, use_items};

/// The path of a module from the root of the crate.
pub(crate) type Module = Vec<String>;

#[derive(Debug)]
pub(crate) struct Source {
    files: BTreeMap<Module, File>,
}

#[derive(Debug)]
struct File {
    /// Files that `mod` declarations name.
    declared: BTreeSet<String>,
    /// Origins of the names that `use` declarations import.
    imported: BTreeMap<String, UsePath>,
    /// Paths that are used, except names that are only re-exported.
    used: Vec<UsePath>,
}

/// The folder of a crate.
pub(crate) fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name)
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let files = files.into_iter().filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    files.chain(folders.iter().flat_map(|folder| rust_files(folder))).collect()
}

/// The code without comments and unit tests.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

/// The names after `mod`, and the files that a `path` attribute names.
fn declared(text: &str) -> BTreeSet<String> {
    let words: Vec<&str> = text.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    let modules = words.windows(2).filter(|pair| pair[0] == "mod").map(|pair| pair[1].to_owned());
    let paths = text.split("path = \"").skip(1).filter_map(|rest| rest.split_once(".rs\""));
    modules.chain(paths.map(|(name, _)| name.to_owned())).collect()
}

/// The module `m` of paths such as `libration_numbers::m::…` and `libration_numbers::internals::m::…`.
fn foreign_module(path: &UsePath) -> Option<&str> {
    const PARTS: [&str; 6] = ["kernels", "numbers", "pendulum", "motion", "perturbation", "branches"];
    let name = path.first()?.strip_prefix("libration_")?;
    let mut rest = path[1..].iter().map(String::as_str).skip_while(|&part| part == "internals");
    PARTS.contains(&name).then(|| rest.next()).flatten()
}

impl Source {
    pub(crate) fn of(name: &str) -> Self {
        let root = folder(name).join("src");
        let mut texts: BTreeMap<Module, String> = BTreeMap::new();
        for path in rust_files(&root) {
            let mut module: Module = path
                .strip_prefix(&root)
                .unwrap()
                .with_extension("")
                .iter()
                .map(|part| part.to_str().unwrap().to_owned())
                .collect();
            if module.iter().any(|part| part == "tests") {
                continue;
            }
            module.pop_if(|last| ["mod", "lib", "main"].contains(&last.as_str()));
            // The library and the program of one crate share the root.
            *texts.entry(module).or_default() += &code(&fs::read_to_string(&path).unwrap());
        }
        let modules: BTreeSet<Module> = texts.keys().cloned().collect();
        let files = texts.iter().map(|(module, text)| (module.clone(), File::read(module, text, &modules)));
        Self { files: files.collect() }
    }

    /// The modules at the root of the crate.
    pub(crate) fn top_modules(&self) -> impl Iterator<Item = &str> {
        self.files.keys().filter_map(|module| match &module[..] {
            [only] => Some(only.as_str()),
            _ => None,
        })
    }

    /// Files that no other file declares, so that the compiler does not read them.
    pub(crate) fn orphans(&self) -> impl Iterator<Item = &Module> {
        self.files.keys().filter(|module| {
            let declared = |(name, above): (&String, &[String])| {
                self.files.get(above).is_some_and(|file| file.declared.contains(name))
            };
            module.split_last().is_some_and(|child| !declared(child))
        })
    }

    /// Pairs of files in which the first uses an item of the second.
    pub(crate) fn edges(&self) -> BTreeSet<(Module, Module)> {
        let uses =
            self.files.iter().flat_map(|(module, file)| file.used.iter().map(move |path| (module, path)));
        let edges = uses.filter_map(|(module, path)| Some((module.clone(), self.resolve(module, path, 0)?)));
        edges.filter(|(from, to)| from != to).collect()
    }

    /// Pairs of a file and a module of another mathematics crate from which the file uses an item.
    pub(crate) fn foreign(&self) -> BTreeSet<(Module, String)> {
        let uses = self.files.iter().flat_map(|(from, file)| file.used.iter().map(move |path| (from, path)));
        uses.filter_map(|(from, path)| Some((from.clone(), foreign_module(path)?.to_owned()))).collect()
    }

    /// The file that defines the item at a path in a module; re-exports are followed.
    fn resolve(&self, from: &Module, path: &UsePath, depth: usize) -> Option<Module> {
        const DEEPEST: usize = 20;
        let (mut module, mut rest) = match path.first()?.as_str() {
            "crate" => (vec![], &path[1..]),
            "self" => (from.clone(), &path[1..]),
            "super" => (from.clone(), &path[..]),
            first => {
                let child: Module = from.iter().cloned().chain([first.to_owned()]).collect();
                self.files.contains_key(&child).then(|| (from.clone(), &path[..]))?
            }
        };
        while let Some(("super", after)) = rest.split_first().map(|(first, after)| (first.as_str(), after)) {
            module.pop()?;
            rest = after;
        }
        while let Some((first, after)) = rest.split_first() {
            let below: Module = module.iter().cloned().chain([first.clone()]).collect();
            if !self.files.contains_key(&below) {
                break;
            }
            (module, rest) = (below, after);
        }
        let origin = rest.first().and_then(|name| self.files.get(&module)?.imported.get(name));
        let further = origin.filter(|origin| depth < DEEPEST && *origin != path);
        let handed_on = further.and_then(|origin| self.resolve(&module, origin, depth + 1));
        Some(handed_on.unwrap_or(module))
    }
}

impl File {
    fn read(module: &Module, text: &str, modules: &BTreeSet<Module>) -> Self {
        let items = use_items(text);
        let imported = items.iter().map(|item| (item.name.clone(), item.path.clone())).collect();
        let is_child = |path: &UsePath| {
            let child: Module = module.iter().cloned().chain(path.first().cloned()).collect();
            modules.contains(&child)
        };
        // A re-export from a module's own folder is not a use.
        let taken =
            items.into_iter().filter(|item| !item.handed_on || !is_child(&item.path)).map(|item| item.path);
        let inline = inline_paths(text).into_iter().filter(|path| {
            let first = path[0].as_str();
            ["crate", "super", "self"].contains(&first) || is_child(path) || foreign_module(path).is_some()
        });
        Self { declared: declared(text), imported, used: taken.chain(inline).collect() }
    }
}
