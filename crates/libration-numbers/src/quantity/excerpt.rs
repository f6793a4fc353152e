//! Foreign text in a form that is safe in messages.

/// At most 40 characters of foreign text, with control characters escaped.
pub fn excerpt(text: &str) -> String {
    const SHOWN: usize = 40;
    let mut shown = String::new();
    for c in text.chars().take(SHOWN) {
        if c.is_control() || is_bidirectional(c) {
            shown.extend(c.escape_default());
        } else {
            shown.push(c);
        }
    }
    if text.chars().nth(SHOWN).is_some() {
        shown.push('…');
    }
    shown
}

/// Returns `true` if a character changes the direction of the text after it, so that a terminal displays it in another order (Unicode Standard
/// Annex 9, section 2).
#[must_use]
pub fn is_bidirectional(c: char) -> bool {
    matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Text without control characters and characters that change its direction.
#[must_use]
pub fn printable(text: &str) -> String {
    text.chars().filter(|&c| !c.is_control() && !is_bidirectional(c)).collect()
}

/// The values of which each would do: `1`, `1 or 2`, `1, 2 or 3`.
///
/// # Examples
/// ```
/// assert_eq!(libration_numbers::quantity::alternatives(&["s", "ms", "min"]), "s, ms or min");
/// ```
#[must_use]
pub fn alternatives(values: &[impl AsRef<str>]) -> String {
    let values: Vec<&str> = values.iter().map(AsRef::as_ref).collect();
    match values.split_last() {
        Some((last, first)) if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        _ => values.concat(),
    }
}
