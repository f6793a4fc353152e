//! Width of text, and positions at which long text is broken.

use super::advances::RUNS;

/// Height of the highest letters above the base line, as a fraction of the font size.
pub(crate) const ASCENT: f64 = 0.76;
/// Distance between base lines, as a fraction of the font size.
pub(crate) const LINE: f64 = 1.2;

/// The width of a text in `DejaVu Sans` of this size.
pub fn width(text: &str, size: f64) -> f64 {
    text.chars().map(|letter| size * advance(letter)).sum()
}

fn advance(letter: char) -> f64 {
    let code = u32::from(letter);
    let run = RUNS.iter().rfind(|(first, _)| *first <= code);
    let found = run.and_then(|(first, widths)| widths.get(usize::try_from(code - first).ok()?));
    // A character that the font lacks is drawn in another font, at most as wide as it is high.
    1e-3 * f64::from(found.copied().unwrap_or(1000))
}

/// The text in lines of at most this width. Lines are broken at spaces, except no-break spaces; within a word only if the word alone is too
/// wide.
pub fn wrapped(text: &str, size: f64, widest: f64) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    for word in text.split(' ').filter(|word| !word.is_empty()).flat_map(|word| pieces(word, size, widest)) {
        match lines.last_mut() {
            Some(line) if width(line, size) + size * advance(' ') + width(&word, size) <= widest => {
                line.push(' ');
                line.push_str(&word);
            }
            _ => lines.push(word),
        }
    }
    lines
}

/// The word, in as many pieces as its width requires.
fn pieces(word: &str, size: f64, widest: f64) -> Vec<String> {
    let mut pieces = vec![String::new()];
    let mut wide = 0.0;
    for letter in word.chars() {
        let more = size * advance(letter);
        if wide > 0.0 && wide + more > widest {
            pieces.push(String::new());
            wide = 0.0;
        }
        wide += more;
        pieces.last_mut().expect("there is a first piece").push(letter);
    }
    pieces
}
