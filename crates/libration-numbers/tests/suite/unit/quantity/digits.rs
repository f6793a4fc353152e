use libration::quantity::{rounded, short, to_place, with_uncertainty};

#[test]
fn rounding_keeps_the_significant_digits() {
    assert_eq!(rounded(2.006409292589, 5), "2.0064");
    assert_eq!(rounded(99999.96, 6), "100000");
    assert_eq!(rounded(1e-300, 3), "1.00e-300");
    assert_eq!(rounded(0.0, 3), "0.00");
    assert_eq!(rounded(f64::INFINITY, 3), "inf");
}

#[test]
fn short_numbers_lose_their_last_zeros() {
    assert_eq!(short(60.0, 12), "60");
    assert_eq!(short(-0.25, 12), "-0.25");
    assert_eq!(short(1.5e-9, 12), "1.5e-9");
    assert_eq!(short(200.0, 2), "200");
}

#[test]
fn values_end_where_their_uncertainty_does() {
    assert_eq!(with_uncertainty(1.63712, 0.00234, "s"), "1.6371 ± 0.0023 s");
    assert_eq!(with_uncertainty(0.003122450913, 4.4e-6, ""), "0.0031225 ± 0.0000044");
    assert_eq!(with_uncertainty(1234.5, 67.8, "m"), "1234 ± 68 m");
    assert_eq!(with_uncertainty(0.56, 0.0, "m"), "0.56 m");
    assert_eq!(with_uncertainty(9.8577686, f64::NAN, "m"), "9.85777 ± nan m");
    assert_eq!(with_uncertainty(1.5e-20, 2e-21, "s"), "1.50e-20 ± 2.0e-21 s");
    // No digit beyond the error is printed, however large the error is.
    assert_eq!(with_uncertainty(309009000.778, 3.3e22, "s"), "0 ± 3.3e+22 s".replace('+', ""));
    assert_eq!(with_uncertainty(123456.0, 1234.0, ""), "123500 ± 1200");
    assert_eq!(with_uncertainty(1.234e12, 5.6e9, ""), "1.2340e12 ± 5.6e9");
    assert_eq!(with_uncertainty(2.0, 1e-13, ""), "2.00000000000 ± 1.0e-13");
}

#[test]
fn numbers_are_rounded_to_a_place() {
    for (value, place, text) in [
        (24.40126, -1, "24.4"),
        (138.9, 14, "0"),
        (138.9, 2, "100"),
        (138.9, 3, "0"),
        (738.9, 3, "1000"),
        (-0.04, -1, "0"),
        (-0.06, -1, "-0.1"),
        (0.0, -3, "0.000"),
        (f64::NAN, 0, "nan"),
    ] {
        assert_eq!(to_place(value, place, 15), text, "{value} {place}");
    }
}
