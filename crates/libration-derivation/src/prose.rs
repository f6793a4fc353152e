//! Sentences with formulas in them.

use super::formula::Formula;

/// Sentences with formulas in them. Equations that they assert are in a [`CheckedEquation`](super::CheckedEquation), where they are checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Prose(pub Vec<Span>);

/// A piece of a sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum Span {
    /// Words.
    Text(String),
    /// A formula.
    Formula(Formula),
}

impl Prose {
    /// Words alone.
    pub(super) fn text(text: impl Into<String>) -> Self {
        Self(vec![Span::Text(text.into())])
    }

    /// The template with each `{}` replaced by the next formula.
    pub(super) fn new<const N: usize>(template: &str, formulas: [Formula; N]) -> Self {
        debug_assert_eq!(template.matches("{}").count(), N, "{template}");
        let mut formulas = formulas.into_iter();
        let mut spans = Vec::new();
        for (n, text) in template.split("{}").enumerate() {
            if n > 0 {
                spans.extend(formulas.next().map(Span::Formula));
            }
            if !text.is_empty() {
                spans.push(Span::Text(text.to_owned()));
            }
        }
        Self(spans)
    }

    /// The formula alone.
    pub(super) fn formula(formula: Formula) -> Self {
        Self(vec![Span::Formula(formula)])
    }

    /// The text followed by more text.
    pub(super) fn and(mut self, more: Self) -> Self {
        self.0.extend(more.0);
        self
    }
}
