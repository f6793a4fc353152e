//! Lists separated by commas, whose items may be formulas: `max(x, 0), y`.

/// The parts between commas outside brackets.
pub(crate) fn at_commas(text: &str) -> Vec<&str> {
    let mut open = 0_i32;
    let outside = |letter: char| {
        open += i32::from("([{".contains(letter)) - i32::from(")]}".contains(letter));
        letter == ',' && open <= 0
    };
    text.split(outside).collect()
}
