//! The tables of ARCHITECTURE.md: a heading with the name of a crate, then rows of modules.

/// From the bottom up.
pub(crate) const CRATES: [&str; 9] = [
    "libration-jit",
    "libration",
    "libration-lab",
    "libration-derivation",
    "libration-report",
    "libration-cli",
    "libration-py",
    "libration-web",
    "libration-web-questions",
];

#[derive(Debug)]
pub(crate) struct Row {
    pub(crate) module: String,
    pub(crate) uses: Vec<String>,
}

#[derive(Debug)]
pub(crate) struct Map {
    rows: Vec<(String, Row)>,
}

/// The names in backquotes.
fn quoted(text: &str) -> Vec<String> {
    text.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

impl Map {
    pub(crate) fn read() -> Self {
        let text = include_str!("../../../../../ARCHITECTURE.md");
        let (mut rows, mut heading) = (vec![], None);
        for line in text.lines() {
            if line.starts_with('#') {
                heading = quoted(line).into_iter().find(|name| CRATES.contains(&name.as_str()));
            }
            let (Some(name), true) = (&heading, line.starts_with("| `")) else { continue };
            let cells: Vec<&str> = line.trim_matches('|').split(" | ").collect();
            let [module, _, uses] = cells[..] else { panic!("a row of three cells was expected: {line}") };
            rows.push((name.clone(), Row { module: quoted(module).remove(0), uses: quoted(uses) }));
        }
        Self { rows }
    }

    pub(crate) fn rows(&self, name: &str) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |(of, _)| of == name).map(|(_, row)| row)
    }
}
