//! Text is measured and broken.

use libration_report::internals::letters::{width, wrapped};
use libration_report::runs;

#[test]
fn wide_letters_are_wider_than_narrow_ones() {
    assert!((width("mm", 1000.0) - 1948.0).abs() < 1e-9);
    assert!((width("il ~", 10.0) - 0.01 * (278.0 + 278.0 + 318.0 + 838.0)).abs() < 1e-9);
}

#[test]
fn long_text_is_broken_and_nothing_of_it_is_lost() {
    let text = "the error of an extraordinarilylongword and of others";
    let lines = wrapped(text, 10.0, 80.0);
    assert!(lines.len() > 3 && lines.iter().all(|line| width(line, 10.0) <= 80.0), "{lines:?}");
    let letters = |text: &str| text.replace(' ', "");
    assert_eq!(letters(&lines.concat()), letters(text));
    assert_eq!(wrapped("short", 10.0, 80.0), ["short"]);
}

#[test]
fn subscripts_and_superscripts_are_small_letters_on_lines_of_their_own() {
    let parts = |text: &str| -> Vec<String> { runs(text).into_iter().map(|run| run.letters).collect() };
    assert_eq!(parts("to θ₀¹² / s⁻¹"), ["to θ", "0", "12", " / s", "−1"]);
    assert_eq!(parts("|aₙ|"), ["|a", "n", "|"]);
    assert_eq!(parts("plain"), ["plain"]);
    let raised: Vec<bool> = runs("a₁²").iter().map(|run| run.rise > 0.0).collect();
    assert_eq!(raised, [false, false, true]);
    // 8.4 of 12 points.
    assert!(runs("₀⁹").iter().all(|run| (run.scale - 0.7).abs() < 1e-9));
    assert!((width("₀", 1.0) - 0.7 * width("0", 1.0)).abs() < 1e-9);
}
