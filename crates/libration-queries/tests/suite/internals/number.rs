//! Numbers with the digits they need.

use libration_queries::internals::number::{at_most, exact, to_its_error, write_exact};

#[test]
fn bounds_are_rounded_up() {
    let shown = [4.8e-13, 4.1e-13, 9.6e-16, 9.4e-16, 1e-3, 0.0, 1.01e-9].map(at_most);
    assert_eq!(shown, ["5e-13", "5e-13", "1e-15", "1e-15", "0.001", "0", "2e-9"]);
}

#[test]
fn digits_end_where_the_error_begins() {
    let period = 24.401_264_932_623_7;
    let shown = [0.3, 0.004, 1e-9, 3e-15, 4.0, f64::NAN].map(|error| to_its_error(period, error, 15));
    let expected = ["24.4", "24.401", "24.401264933", "24.4012649326237", "24", "24.4012649326237"];
    assert_eq!(shown, expected);
    let shown = [(-6e-16, 2e-15), (2e-5, 1e-9), (12345.0, 300.0), (-0.04, 0.3), (0.0, 1e-9), (9.99, 0.3)];
    let shown = shown.map(|(value, error)| to_its_error(value, error, 12));
    assert_eq!(shown, ["-1e-15", "0.000020000", "12300", "0", "0.000000000", "10"]);
}

#[test]
fn exact_numbers_read_back_as_themselves() {
    assert_eq!(exact(1e-300), "1e-300");
    assert_eq!(exact(0.1).parse(), Ok(0.1));
    for value in [1e-300, -0.0, 0.1, 3.0, 1e16, 1.5e300, 5e-324] {
        let mut text = b"x=".to_vec();
        write_exact(&mut text, value);
        assert_eq!(String::from_utf8(text).unwrap(), format!("x={}", exact(value)));
    }
}
