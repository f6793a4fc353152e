//! Parts of the command line that a message repeats, shortened.

/// Longer words and quotations are cut in the middle; names of files are shorter.
const LONGEST_QUOTATION: usize = 300;
/// Longer lines are cut in the middle; lists of all keys are shorter.
pub const LONGEST_LINE: usize = 2000;

/// The beginning of a text, as a message may show it.
pub fn excerpt(text: &str) -> String {
    const SHOWN: usize = 60;
    cut(text, SHOWN)
}

/// The message without the blanks that keep negative values from being taken for options.
pub(super) fn unprotected(message: &str) -> String {
    message.replace("' -", "'-").replace("' −", "'−")
}

/// The message with whatever is very long in it cut: quotations, words, lines.
pub fn shortened(message: &str) -> String {
    message.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// Every second part between backquotes is a quotation.
fn line(line: &str) -> String {
    let parts = line.split('`').enumerate();
    let shown =
        parts.map(|(index, part)| if index % 2 == 1 { cut(part, LONGEST_QUOTATION) } else { words(part) });
    cut(&shown.collect::<Vec<_>>().join("`"), LONGEST_LINE)
}

/// A text with its long words cut.
fn words(text: &str) -> String {
    text.split(' ').map(|word| cut(word, LONGEST_QUOTATION)).collect::<Vec<_>>().join(" ")
}

/// The beginning and the end of a text, if it is longer than this number of characters by more than the length of the note on the cut.
fn cut(text: &str, longest: usize) -> String {
    const NOTE: usize = 20;
    let letters = text.chars().count();
    if letters <= longest + NOTE {
        return text.to_owned();
    }
    let kept = longest / 2;
    let (begin, end): (String, String) =
        (text.chars().take(kept).collect(), text.chars().skip(letters - kept).collect());
    format!("{begin}…({} characters)…{end}", letters - 2 * kept)
}
