//! Lists with commas between their items, which may be formulas: `max(x, 0), y`.

/// The parts between commas that stand in no brackets.
pub(crate) fn at_commas(text: &str) -> Vec<&str> {
    let mut open = 0_i32;
    let outside = |letter: char| {
        open += i32::from("([{".contains(letter)) - i32::from(")]}".contains(letter));
        letter == ',' && open <= 0
    };
    text.split(outside).collect()
}
