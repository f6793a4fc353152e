use libration::algebra::Rational;

fn rational(text: &str) -> Rational {
    text.parse().unwrap()
}

#[test]
fn fractions_are_read_reduced_and_written_back() {
    for (text, written) in [("-23/737280", "-23/737280"), ("6/4", "3/2"), ("-8/4", "-2"), ("0/7", "0")] {
        assert_eq!(rational(text).to_string(), written);
    }
    assert_eq!(rational("-46/10").numerator(), "-23");
    assert_eq!(rational("-46/10").denominator(), "5");
    assert_eq!(Rational::new(3, -6), Rational::new(-1, 2));
}

#[test]
fn texts_that_are_no_fractions_are_refused() {
    for text in ["", "/", "1/0", "1/-2", "1.5", "a/2", "1/2/3"] {
        assert!(text.parse::<Rational>().is_err(), "{text}");
    }
    assert_eq!(Rational::new(1, 0), None);
    assert_eq!(rational("1/2").checked_div(&rational("0")), None);
}

#[test]
fn arithmetic_keeps_the_field_laws() {
    let (a, b, c) = (rational("3/7"), rational("-5/11"), rational("22/9"));
    assert_eq!(a.clone() * (b.clone() + c.clone()), a.clone() * b.clone() + a.clone() * c);
    assert_eq!((a.clone() - b.clone()) + b.clone(), a);
    assert_eq!(a.checked_div(&b).unwrap() * b, a);
    assert_eq!(a.clone() + -a, Rational::from(0));
}

#[test]
fn conversion_rounds_to_nearest_even() {
    assert_eq!(rational("1/3").to_f64().to_bits(), (1.0_f64 / 3.0).to_bits());
    // Halfway between 1 and its successor, then just above halfway.
    assert_eq!(rational("9007199254740993/9007199254740992").to_f64().to_bits(), 1.0_f64.to_bits());
    assert_eq!(
        rational("90071992547409930001/90071992547409920000").to_f64().to_bits(),
        1.0_f64.next_up().to_bits()
    );
}

#[test]
fn signs_and_whole_numbers_are_told() {
    for (text, negative, whole) in [
        ("-7/3", true, false),
        ("-4/2", true, true),
        ("0", false, true),
        ("1/2", false, false),
        ("6/3", false, true),
    ] {
        assert_eq!((rational(text).is_negative(), rational(text).is_integer()), (negative, whole), "{text}");
    }
}
