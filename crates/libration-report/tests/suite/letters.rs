//! Text is measured and broken.

use libration_report::internals::letters::{width, wrapped};

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
