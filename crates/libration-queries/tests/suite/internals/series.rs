//! Series as they are written.

use libration::algebra::Rational;
use libration::perturbation::Precision;
use libration::progress::Quiet;
use libration_queries::internals::series::{Notation, Style, wrapped};

fn list(texts: &[&str]) -> Vec<Rational> {
    texts.iter().map(|text| text.parse().unwrap()).collect()
}

#[test]
fn series_read_as_they_are_written_by_hand() {
    let text = Notation { precision: Precision::Exact, style: Style::Text };
    assert_eq!(text.series(&list(&["1", "0", "-1/16", "0", "11/3072"]), "ε"), "1 - 1/16 ε² + 11/3072 ε⁴");
    assert_eq!(text.series(&list(&["0", "-1", "2"]), "μ"), "-μ + 2 μ²");
    assert_eq!(text.series(&list(&["0", "0"]), "ε"), "0");
    let latex = Notation { style: Style::Latex, ..text };
    assert_eq!(
        latex.series(&list(&["0", "1", "-1/192"]), r"\epsilon"),
        r"\epsilon - \frac{1}{192} \epsilon^{2}"
    );
}

#[test]
fn coefficients_of_letters_stand_in_brackets_where_they_are_sums() {
    let equation: libration::expression::Equation = "x'' + w^2*x + a*x^2 + b*x^3 = 0".parse().unwrap();
    let oscillator = libration::oscillator::SymbolicOscillator::new(&equation).unwrap();
    let gauge = libration::perturbation::Gauge::Fundamental;
    let expansion = libration::perturbation::expand_symbolically(&oscillator, 3, &gauge, &Quiet).unwrap();
    let text = Notation { precision: Precision::Exact, style: Style::Text };
    let frequency = &expansion.series.frequency_ratio;
    assert_eq!(text.series(frequency, "ε"), "1 + (3*b/(8*w^2) - 5*a^2/(12*w^4)) ε²");
    let latex = Notation { style: Style::Latex, ..text };
    assert_eq!(
        latex.series(frequency, "A"),
        r"1 + \left(\frac{3 b}{8 w^{2}} - \frac{5 a^{2}}{12 w^{4}}\right) A^{2}"
    );
    let mean = &expansion.series.harmonic(0).unwrap().cos[..3];
    assert_eq!(latex.series(mean, "A"), r"-\frac{a}{2 w^{2}} A^{2}");
}

#[test]
fn long_series_are_broken_between_terms() {
    assert_eq!(wrapped("x = ", "1 - 1/16 ε² + 11/3072 ε⁴", 18), "x = 1 - 1/16 ε²\n    + 11/3072 ε⁴");
}
