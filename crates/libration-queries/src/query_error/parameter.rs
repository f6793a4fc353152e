//! The parameters of queries that errors are about.

use std::borrow::Cow;
use std::fmt::{Display, Formatter};

/// A parameter of a query.
///
/// Its text is a mark, which a message in the words of a front end replaces by the parameter's name there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Name in the help of the command, without dashes: `over`, `OSCILLATOR|EQUATION`.
    shown: Cow<'static, str>,
    is_option: bool,
    /// The name of an argument among the parameters of its query, when that is known.
    name: Option<String>,
}

/// The option of this name, which is without dashes.
pub const fn option(name: &'static str) -> Parameter {
    Parameter { shown: Cow::Borrowed(name), is_option: true, name: None }
}

/// The argument whose value has this name in the help.
pub(crate) const fn argument(value: &'static str) -> Parameter {
    Parameter { shown: Cow::Borrowed(value), is_option: false, name: None }
}

impl Parameter {
    /// The parameter that clap writes in a usage line: `--over <NAME=FROM:TO>`, `[AMPLITUDE]...`.
    pub(crate) fn of_usage(usage: &str) -> Option<Self> {
        let of = |name: &str, is_option| Self { shown: Cow::Owned(name.to_owned()), is_option, name: None };
        match usage.strip_prefix("--") {
            Some(long) => long.split([' ', '=', '[']).next().map(|name| of(name, true)),
            None if usage.starts_with(['<', '[']) => {
                let name = usage.trim_start_matches(['<', '[']).split(['>', ']']).next();
                name.map(|name| of(name, false))
            }
            None => None,
        }
    }

    /// The parameters of a group in a usage line: `<AMPLITUDE|--from-file <FILE>>`.
    pub(super) fn all_of_usage(usage: &str) -> Vec<Self> {
        if !usage.contains("|--") {
            return Self::of_usage(usage).into_iter().collect();
        }
        let alternatives = usage.trim_matches(['<', '>']).split('|');
        alternatives
            .filter_map(|alternative| {
                Self::of_usage(alternative).or_else(|| Self::of_usage(&format!("<{alternative}>")))
            })
            .collect()
    }

    /// The name in the help of the command: `--over`, `OSCILLATOR|EQUATION`.
    #[must_use]
    pub fn in_help(&self) -> String {
        if self.is_option { format!("--{}", self.shown) } else { self.shown.to_string() }
    }

    /// The name among the parameters of the query in [`crate::questions()`]: `over`, `oscillator`.
    #[must_use]
    pub fn name(&self) -> String {
        self.name.clone().unwrap_or_else(|| self.shown.to_string())
    }

    /// The parameter with the name that a query has for an argument whose value has this name in the help.
    pub(super) fn named(self, name_of: &dyn Fn(&str) -> Option<String>) -> Self {
        let name = if self.is_option { None } else { name_of(&self.shown) };
        Self { name, ..self }
    }
}

impl Display for Parameter {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        write!(f, "<{}>", self.in_help())
    }
}
