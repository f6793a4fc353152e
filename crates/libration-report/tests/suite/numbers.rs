//! The numbers of ticks and sentences.

use libration_report::internals::numbers::{of_steps, power_of_ten, short};

#[test]
fn ticks_have_the_digits_of_their_step() {
    assert_eq!(of_steps(0.5, 0.25, 1.0), "0.5".to_owned());
    assert_eq!(of_steps(10.000_012, 2e-6, 10.00002), "10.000012");
    assert_eq!(of_steps(-3e-7, 1e-7, 5e-7), "−3×10⁻⁷");
    assert_eq!(of_steps(1.5e9, 5e8, 2e9), "1.5×10⁹");
    assert_eq!(of_steps(1e-20, 1.0, 3.0), "0");
    assert_eq!(of_steps(150.0, 50.0, 200.0), "150");
}

#[test]
fn powers_of_ten_have_one_notation() {
    assert_eq!([-12, 0, 1].map(power_of_ten), ["10⁻¹²", "10⁰", "10¹"]);
}

#[test]
fn numbers_of_sentences_have_no_zeros_to_spare() {
    assert_eq!([180.0, 1e-8, 0.25, 0.0].map(short), ["180", "1×10⁻⁸", "0.25", "0"]);
}
