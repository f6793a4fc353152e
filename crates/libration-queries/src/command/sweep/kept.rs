//! The numbers that a sweep keeps of each result, by their paths in JSON.

use serde_json::Value;

/// A number of a result, or a range of a list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kept {
    pub(crate) name: String,
    /// Path such as `results[0].ratio`, `state[-1]`, or `points[0:100].state[1]` for a hundred numbers.
    pub(crate) path: String,
    steps: Vec<Step>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Step {
    Key(String),
    /// An entry, counted from the end if it is negative.
    Entry(i64),
    Entries(usize, usize),
}

/// More numbers of a result than this are never kept.
const MOST: usize = 1_000_000;

impl Kept {
    /// Reads a path, or `NAME=PATH`; without a name, the name is the last key with what follows it.
    pub fn read(text: &str) -> Result<Self, String> {
        let (name, path) = match text.split_once('=') {
            Some((name, path)) => (Some(name.trim()), path.trim()),
            None => (None, text.trim()),
        };
        let steps = steps(path)?;
        if steps.iter().filter(|step| matches!(step, Step::Entries(..))).count() > 1 {
            return Err(format!("`{path}` has two ranges: give one"));
        }
        let name = name.map_or_else(|| last_key(path), str::to_owned);
        if name.is_empty() {
            return Err(format!("`{text}` has no name: give NAME=PATH, such as angle=samples[-1].state[0]"));
        }
        Ok(Self { name, path: path.to_owned(), steps })
    }

    /// The kept number with a name made of its path.
    pub(crate) fn named(self, name: impl Fn(&str) -> String) -> Self {
        Self { name: name(&self.path), ..self }
    }

    /// Number of entries if it is a list.
    pub(crate) fn length(&self) -> Option<usize> {
        self.steps.iter().find_map(|step| match step {
            Step::Entries(from, to) => Some(to - from),
            _ => None,
        })
    }

    /// The names of its columns: `angle`, or `angle[0]`, `angle[1]`, …
    pub fn columns(&self) -> Vec<String> {
        match self.length() {
            None => vec![self.name.clone()],
            Some(length) => (0..length).map(|index| format!("{}[{index}]", self.name)).collect(),
        }
    }

    /// Its numbers in a result, NaN for missing ones; `true` is 1, `false` 0.
    pub fn numbers(&self, answer: &Value) -> Vec<f64> {
        let mut numbers = vec![];
        follow(Some(answer), &self.steps, &mut numbers);
        numbers
    }

    /// Returns `true` if a result has numbers there, or may have them: lists may be longer in other results.
    pub fn is_in(&self, answer: &Value) -> bool {
        let mut value = answer;
        for step in &self.steps {
            let next = match step {
                Step::Key(key) => value.get(key),
                Step::Entry(index) => entry(value, *index),
                Step::Entries(from, _) => value.get(from),
            };
            match next {
                Some(next) => value = next,
                None => return value.is_array() && !matches!(step, Step::Key(_)),
            }
        }
        value.is_number() || value.is_boolean() || value.is_null()
    }

    /// The path as in `libration fields`: `points[].state[]`.
    pub fn described_as(&self) -> String {
        let mut text = String::new();
        for step in &self.steps {
            match step {
                Step::Key(key) if text.is_empty() => text.push_str(key),
                Step::Key(key) => text.extend([".", key]),
                Step::Entry(_) | Step::Entries(..) => text.push_str("[]"),
            }
        }
        text
    }
}

/// The paths to all numbers of a result outside lists, or in lists of one entry. Fields about the schema and the continuation of the result are not
/// included.
pub fn scalars(answer: &Value) -> Vec<String> {
    let mut paths = vec![];
    collect(answer, String::new(), &mut paths);
    paths.retain(|way| way != "schema" && !way.starts_with("resume."));
    paths
}

fn collect(value: &Value, path: String, paths: &mut Vec<String>) {
    match value {
        Value::Number(_) | Value::Bool(_) | Value::Null => paths.push(path),
        Value::Object(fields) => {
            for (key, value) in fields {
                let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
                collect(value, path, paths);
            }
        }
        Value::Array(entries) if entries.len() == 1 => collect(&entries[0], format!("{path}[0]"), paths),
        Value::Array(_) | Value::String(_) => {}
    }
}

fn follow(value: Option<&Value>, steps: &[Step], numbers: &mut Vec<f64>) {
    let Some((step, rest)) = steps.split_first() else {
        let number = |value: &Value| {
            value.as_f64().or_else(|| value.as_bool().map(|truth| f64::from(u8::from(truth))))
        };
        numbers.push(value.and_then(number).unwrap_or(f64::NAN));
        return;
    };
    match step {
        Step::Key(key) => follow(value.and_then(|value| value.get(key)), rest, numbers),
        Step::Entry(index) => follow(value.and_then(|value| entry(value, *index)), rest, numbers),
        Step::Entries(from, to) => {
            (*from..*to).for_each(|index| follow(value.and_then(|value| value.get(index)), rest, numbers));
        }
    }
}

fn entry(list: &Value, number: i64) -> Option<&Value> {
    let list = list.as_array()?;
    let index = if number < 0 { i64::try_from(list.len()).ok()? + number } else { number };
    list.get(usize::try_from(index).ok()?)
}

fn last_key(path: &str) -> String {
    let last = path.rsplit('.').next().unwrap_or(path);
    // A range does not belong to the name: its position does.
    last.split_once('[').map_or(last, |(key, entry)| if entry.contains(':') { key } else { last }).to_owned()
}

fn steps(path: &str) -> Result<Vec<Step>, String> {
    let mut steps = vec![];
    for part in path.split('.') {
        let (key, entries) = part.find('[').map_or((part, ""), |bracket| part.split_at(bracket));
        if key.is_empty() {
            return Err(format!("`{path}` is not a path to a number: give one such as results[0].ratio"));
        }
        steps.push(Step::Key(key.to_owned()));
        for entry in entries.split_terminator(']') {
            let entry = entry.strip_prefix('[').and_then(step_into);
            steps.push(entry.ok_or_else(|| {
                format!("`{path}`: give [K] for an entry of a list, [-1] for its last, [0:100] for the first hundred")
            })?);
        }
    }
    Ok(steps)
}

fn step_into(text: &str) -> Option<Step> {
    match text.split_once(':') {
        None => text.trim().parse().ok().map(Step::Entry),
        Some((from, to)) => {
            let (from, to) = (from.trim().parse().ok()?, to.trim().parse().ok()?);
            (from < to && to - from <= MOST).then_some(Step::Entries(from, to))
        }
    }
}
