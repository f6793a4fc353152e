//! Times written with a number of significant digits, as tables on a screen show them: 0.0333, 0.0667, …, 10.0, 10.1.

use libration_lab::internals::measurement::faults::significant_digits::SignificantDigits;

#[test]
fn steps_grow_with_the_decade() {
    let times = [0.0, 0.0333, 0.0667, 0.1, 9.97, 10.0, 10.1, 100.0];
    let digits = SignificantDigits::detect(&times, Some(1e-4)).unwrap();
    assert_eq!(digits.count, 3);
    for (time, step) in [(0.0, 1e-4), (0.0333, 1e-4), (0.1, 1e-3), (0.999, 1e-3), (1.0, 0.01), (-10.0, 0.1)] {
        assert!((digits.step_at(time) / step - 1.0).abs() < 1e-12, "{time}");
    }
}

#[test]
fn a_decimal_step_is_no_number_of_digits() {
    assert_eq!(SignificantDigits::detect(&[0.05, 0.1, 9.95], Some(0.01)), None);
    assert_eq!(SignificantDigits::detect(&[0.0, 0.0], Some(1.0)), None);
    assert_eq!(SignificantDigits::detect(&[0.033333333, 1.5], None), None);
}
