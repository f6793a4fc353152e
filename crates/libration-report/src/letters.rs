//! Width of text, positions at which long text is broken, and the size of subscripts and superscripts.

use super::advances::RUNS;

/// Height of the highest letters above the base line, as a fraction of the font size.
pub(crate) const ASCENT: f64 = 0.76;
/// Distance between base lines, as a fraction of the font size.
pub(crate) const LINE: f64 = 1.2;

/// The size of subscripts and superscripts as a fraction of the letter size: 8.4 of 12 points. The font's own `₀` is two fifths as high as a
/// letter, which is too small in print.
const SMALL: f64 = 0.7;
/// Heights of the base lines of superscripts and subscripts above that of the text, as fractions of the letter size.
const RAISED: f64 = 0.33;
const LOWERED: f64 = -0.17;
/// The characters that are drawn small, in the order of those that are drawn.
const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ";
const RAISED_LETTERS: &str = "0123456789+−n";
const SUBSCRIPTS: &str = "₀₁₂₃₄₅₆₇₈₉₊₋ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ";
const LOWERED_LETTERS: &str = "0123456789+−aehijklmnoprstuvx";

/// A part of a text whose letters have one size and one base line.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The letters to draw.
    pub letters: String,
    /// The size of the letters as a fraction of that of the text.
    pub scale: f64,
    /// The height of the base line above that of the text, as a fraction of the size of the text.
    pub rise: f64,
}

/// The text in parts of one size: subscripts and superscripts are parts of their own.
pub fn runs(text: &str) -> Vec<Run> {
    let mut runs: Vec<Run> = vec![];
    for letter in text.chars() {
        let (letter, scale, rise) = drawn(letter);
        match runs.last_mut() {
            Some(run) if run.rise.total_cmp(&rise).is_eq() => run.letters.push(letter),
            _ => runs.push(Run { letters: letter.to_string(), scale, rise }),
        }
    }
    runs
}

/// The character that is drawn, its size and its height.
fn drawn(letter: char) -> (char, f64, f64) {
    let counterpart = |written: &str, letters: &str| {
        written
            .chars()
            .zip(letters.chars())
            .find(|(character, _)| *character == letter)
            .map(|(_, drawn)| drawn)
    };
    if letter.is_ascii() {
        return (letter, 1.0, 0.0);
    }
    let raised = counterpart(SUPERSCRIPTS, RAISED_LETTERS).map(|drawn| (drawn, SMALL, RAISED));
    let lowered = || counterpart(SUBSCRIPTS, LOWERED_LETTERS).map(|drawn| (drawn, SMALL, LOWERED));
    raised.or_else(lowered).unwrap_or((letter, 1.0, 0.0))
}

/// The width of a text in `DejaVu Sans` of this size.
pub fn width(text: &str, size: f64) -> f64 {
    text.chars().map(|letter| size * advance(letter)).sum()
}

fn advance(letter: char) -> f64 {
    let (letter, scale, _) = drawn(letter);
    scale * of_full_size(letter)
}

fn of_full_size(letter: char) -> f64 {
    let code = u32::from(letter);
    let run = RUNS.iter().rfind(|(first, _)| *first <= code);
    let thousandths = run.and_then(|(first, widths)| widths.get(usize::try_from(code - first).ok()?));
    // A character that the font lacks is drawn in another font, at most as wide as it is high.
    1e-3 * f64::from(thousandths.copied().unwrap_or(1000))
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
