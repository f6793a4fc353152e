//! How wide text is: the letters of `DejaVu Sans`, the font the pictures are drawn with.

/// Advance widths of the characters from U+0020 to U+007E in thousandths of the size of the font: the table `hmtx` of
/// `DejaVu Sans` 2.37, rounded.
const ADVANCES: [u16; 95] = [
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337, 636, 636, 636, 636, 636,
    636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632, 575, 775, 752, 295,
    295, 656, 557, 863, 748, 787, 603, 787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838,
    500, 500, 613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612, 635, 635, 411, 521,
    392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838,
];

/// The widest of the Greek letters and signs of the pictures: − and × are so wide.
const OTHERS: u16 = 838;

/// The width of a text in a font of this size, or a little more.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    text.chars().map(|letter| size * advance(letter)).sum()
}

fn advance(letter: char) -> f64 {
    let thousandths = match letter {
        ' '..='~' => ADVANCES[letter as usize - ' ' as usize],
        '⁰'..='⁹' | '¹' | '²' | '³' | '₀'..='₉' => 401,
        '⁻' => 528,
        '′' => 227,
        '°' => 500,
        _ => OTHERS,
    };
    1e-3 * f64::from(thousandths)
}

/// The text, or as much of its beginning as is no wider than this, with dots for the rest.
pub(super) fn shortened(text: &str, size: f64, widest: f64) -> String {
    if width(text, size) <= widest {
        return text.to_owned();
    }
    let mut kept: String = text.to_owned();
    while width(&kept, size) + size > widest && kept.pop().is_some() {}
    format!("{}…", kept.trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wide_letters_are_wider_than_narrow_ones() {
        assert!((width("mm", 1000.0) - 1948.0).abs() < 1e-9);
        assert!((width("il ~", 10.0) - 0.01 * (278.0 + 278.0 + 318.0 + 838.0)).abs() < 1e-9);
    }

    #[test]
    fn what_is_too_wide_ends_in_dots() {
        assert_eq!(shortened("short", 10.0, 100.0), "short");
        let text = shortened(&"long ".repeat(20), 10.0, 100.0);
        assert!(text.ends_with('…') && width(&text, 10.0) <= 100.0 + 10.0, "{text}");
    }
}
