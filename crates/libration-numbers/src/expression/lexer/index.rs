//! Members of indexed families, `x[i + 1]`, and the range of the index, `, i = 1..32`.

use super::Lexer;
use crate::expression::Function;

/// The range of an index; an equation is written for each number in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::expression) struct IndexRange {
    pub(in crate::expression) letter: String,
    pub(in crate::expression) first: u32,
    pub(in crate::expression) last: u32,
}

impl Lexer<'_> {
    /// Text in square brackets directly after a name, without spaces and including the brackets; `None` if it is not an index.
    pub(super) fn index_in_brackets(&mut self, name: &str) -> Option<String> {
        let inside = self.rest().strip_prefix('[')?.split_once(']')?.0;
        let belongs = |c: char| c.is_ascii_alphanumeric() || matches!(c, ' ' | '+' | '-' | '*' | '/');
        let is_index = !inside.trim().is_empty() && inside.chars().all(belongs);
        let is_function = Function::by_name(name).is_some();
        if !is_index || is_function {
            return None;
        }
        let index: String = inside.chars().filter(|c| *c != ' ').collect();
        self.at += inside.len() + 2;
        Some(format!("[{index}]"))
    }

    /// The range after a comma; `None` if something else follows.
    pub(super) fn range(&mut self) -> Option<IndexRange> {
        let rest = self.rest().strip_prefix(',')?;
        let (letter, rest) = rest.split_once('=')?;
        let (first, rest) = rest.split_once("..").or_else(|| rest.split_once('…'))?;
        let rest = rest.strip_prefix('.').unwrap_or(rest).trim_start();
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        let (letter, last) = (letter.trim(), &rest[..digits]);
        let is_letter = !letter.is_empty() && letter.bytes().all(|byte| byte.is_ascii_alphabetic());
        let range = IndexRange {
            letter: is_letter.then(|| letter.to_owned())?,
            first: first.trim().parse().ok()?,
            last: last.parse().ok()?,
        };
        self.at = self.text.len() - rest.len() + digits;
        Some(range)
    }
}
