use dashu_ratio::RBig;
use libration::internals::quantity::Decimal;

#[test]
fn a_decimal_is_kept_exactly() {
    let number = Decimal::parse("-0.1").unwrap();
    assert_eq!(number.exact() * RBig::from(10), -RBig::ONE);
    assert_eq!(number.nearest().to_bits(), (-0.1f64).to_bits());
    assert_eq!(Decimal::parse("1.5e2").unwrap().exact(), RBig::from(150));
}

#[test]
fn a_number_is_read_quickly_if_it_is_read_at_all() {
    for text in [
        "0",
        "-0",
        "-0.0",
        "1.5",
        ".5",
        "5.",
        "-2.5e-3",
        "1E5",
        "1e+5",
        "1e-500",
        "1e-400",
        "1e308",
        "1e309",
        "1e500",
        "1e501",
        "1e-501",
        "1e99999999999",
        "",
        "-",
        ".",
        "e5",
        "1e",
        "1e+",
        "+1",
        "--1",
        "1 ",
        "1_0",
        "nan",
        "inf",
        "infinity",
        "0x1",
        "1.5rad",
        "1,5",
        "٣",
    ] {
        let exact = Decimal::parse(text).map(|number| number.nearest().to_bits());
        assert_eq!(Decimal::nearest_to(text).map(f64::to_bits), exact, "{text}");
    }
    assert_eq!(Decimal::nearest_to(&"9".repeat(129)), None);
    assert!(Decimal::nearest_to(&"9".repeat(128)).is_some());
}

#[test]
fn what_follows_the_number_is_left() {
    for (text, rest) in [("60deg", "deg"), ("1e", "e"), ("2e-x", "e-x"), ("1.e3m", "m"), (".5", "")] {
        assert_eq!(Decimal::split_from(text).unwrap().1, rest, "{text}");
    }
}

#[test]
fn texts_that_are_no_number_are_refused() {
    for text in
        ["", "-", ".", "e5", "+-1", "1e501", "1e400", "1e-999999999", "1e99999999999", "٣", "nan", "inf"]
    {
        assert_eq!(Decimal::parse(text), None, "{text}");
    }
    assert_eq!(Decimal::parse(&"9".repeat(1_000_000)), None);
}
