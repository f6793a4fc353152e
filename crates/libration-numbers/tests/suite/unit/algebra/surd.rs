use libration::algebra::{Rational, Surd};

fn surd(a: &str, b: &str, d: &str) -> Surd {
    Surd::new(a.parse().unwrap(), b.parse().unwrap(), d.parse().unwrap())
}

#[test]
fn roots_lose_the_squares_in_them() {
    for ((a, b, d), text) in [
        (("0", "1", "12"), "2*sqrt(3)"),
        (("3/2", "-1/2", "5"), "3/2 - 1/2*sqrt(5)"),
        (("1", "1", "4/9"), "5/3"),
        (("0", "-1", "1/2"), "-1/2*sqrt(2)"),
        (("7", "0", "5"), "7"),
        (("7", "3", "0"), "7"),
    ] {
        assert_eq!(surd(a, b, d).to_string(), text);
    }
    assert_eq!(surd("2", "-1", "2").square_root_text(), "sqrt(2 - sqrt(2))");
    assert_eq!(surd("9/4", "0", "2").square_root_text(), "3/2");
}

#[test]
fn nearly_equal_terms_do_not_cancel() {
    // 665857² − 2·470832² = 1.
    let value = surd("665857", "-470832", "2").to_f64();
    assert!((value * 1_331_714.0 - 1.0).abs() < 1e-11, "{value:e}");
    let other = surd("665857", "470832", "2").to_f64();
    assert!((value * other - 1.0).abs() < 1e-15);
}

#[test]
fn the_radicand_has_no_square_in_it() {
    assert_eq!(*surd("2", "-1", "8").radicand(), Rational::from(2));
    assert_eq!(*surd("0", "1", "1/12").radicand(), Rational::from(3));
    assert!(surd("1", "1", "9/4").root().is_zero());
}
