//! Text denotes the exact decimal: quantities, ranges and lists.

use libration::quantity::{
    Angle, AngleRange, Dimension, NumberRange, QuantityError, RangeError, angles, in_si, numbers, parse,
};

#[test]
fn units_are_exact_factors() {
    for (text, dimension, value) in [
        ("1m", Dimension::Length, 1.0),
        ("1.2 m", Dimension::Length, 1.2),
        ("120 cm", Dimension::Length, 1.2),
        ("35 in", Dimension::Length, 0.889),
        ("34.25in", Dimension::Length, 0.86995),
        ("9.81m/s^2", Dimension::Acceleration, 9.81),
        ("9.81 m/s²", Dimension::Acceleration, 9.81),
        ("1 g", Dimension::Acceleration, 9.80665),
        ("0.3rad/s", Dimension::AngularVelocity, 0.3),
        ("-180deg/s", Dimension::AngularVelocity, -std::f64::consts::PI),
        ("30 rpm", Dimension::AngularVelocity, std::f64::consts::PI),
        ("36 km/h", Dimension::Velocity, 10.0),
        ("-5cm/s", Dimension::Velocity, -0.05),
        ("2s", Dimension::Time, 2.0),
        ("500ms", Dimension::Time, 0.5),
        ("−0.7", Dimension::Time, -0.7),
        ("20 N/mm", Dimension::Stiffness, 2e4),
        ("-1.5K", Dimension::TemperatureDifference, -1.5),
        ("11.5ppm/K", Dimension::Expansion, 1.15e-5),
    ] {
        let quantity = parse(text, dimension).unwrap();
        assert_eq!((quantity.value.to_bits(), quantity.uncertainty), (f64::to_bits(value), None), "{text}");
    }
}

/// JCGM 100:2008, 4.3.7: a rectangular distribution of half-width a has the standard uncertainty a/√3.
#[test]
fn half_widths_are_over_the_root_of_three() {
    for text in ["1.000 ± 0.003 m rectangular", "1.000m+-3mm rect", "1.000(3) m rect", "1.000m±3mmrect "] {
        let length = parse(text, Dimension::Length).unwrap();
        let uncertainty = length.uncertainty.unwrap();
        assert!(
            (length.value, (uncertainty / 1.732_050_807_568_877_2e-3 - 1.0).abs() < 1e-15) == (1.0, true)
        );
    }
    for text in ["1 m rect", "rect", "1 ± 0.1 m rectangle"] {
        assert!(parse(text, Dimension::Length).is_err(), "{text}");
    }
}

#[test]
fn uncertainties_are_read_in_every_notation() {
    for (text, value, uncertainty) in [
        ("1.200(3) m", 1.2, 0.003),
        ("120.0(12) cm", 1.2, 0.012),
        ("1.20(3)e-1 m", 0.12, 0.003),
        ("1.200 ± 0.003 m", 1.2, 0.003),
        ("1.200+-0.003 m", 1.2, 0.003),
        ("1.200 +/- 0.003", 1.2, 0.003),
        ("0.57m±0.004m", 0.57, 0.004),
        ("57 cm ± 4 mm", 0.57, 0.004),
        ("57 cm ± 0.4", 0.57, 0.004),
        ("(57 ± 0.4) cm", 0.57, 0.004),
        ("35 ± 0.25 in", 0.889, 0.00635),
        ("2 m ± 1%", 2.0, 0.02),
    ] {
        let quantity = parse(text, Dimension::Length).unwrap();
        assert_eq!((quantity.value, quantity.uncertainty), (value, Some(uncertainty)), "{text}");
    }
}

#[test]
fn a_quantity_of_another_kind_is_told_apart() {
    let message = parse("1 s", Dimension::Length).unwrap_err().to_string();
    assert!(message.starts_with("`1 s` is a time, not a length: write 1m, 120 cm, 35 in"), "{message}");
    let unknown = parse("1 parsec", Dimension::Length).unwrap_err();
    assert!(matches!(unknown, QuantityError::UnknownUnit { .. }), "{unknown}");
}

#[test]
fn unreadable_quantities_are_refused_quickly() {
    let long = "1".repeat(1 << 20);
    for text in [
        "",
        "m",
        "1..2 m",
        "--1 m",
        "+-1 m",
        "1.2(3 m",
        "1.2(x) m",
        "1.2(99999999999) m",
        "1.2(3)±1 m",
        "1 m ± 1 s",
        "1 ± -0.1 m",
        "1±",
        "nan",
        "inf m",
        "1e999 m",
        "1e400",
        "1e308 km",
        "1e-999999999 m",
        "1 m\0",
        "1 m 2",
        "±1 m",
        &long,
    ] {
        let message = parse(text, Dimension::Length).unwrap_err().to_string();
        assert!(message.contains("write 1m") && message.len() < 300, "{text}: {message}");
    }
}

#[test]
fn a_decimal_comma_is_refused_with_the_point_in_its_place() {
    for (text, with_point) in [("1,2 m", "1.2 m"), ("0,5", "0.5"), ("1,25 ± 0,01 m", "1.25 ± 0.01 m")] {
        let message = parse(text, Dimension::Length).unwrap_err().to_string();
        let told =
            message.contains("has a comma: write it with a decimal point") && message.contains(with_point);
        assert!(told, "{text}: {message}");
    }
    // Two numbers are no decimal, nor is one with a mark of thousands.
    for text in ["1,m", "0.5,0.001", "1,5m ± 1,2,3", "1.234,5"] {
        let message = parse(text, Dimension::Length).unwrap_err().to_string();
        assert!(message.contains("write 1m") && !message.contains("decimal point"), "{text}: {message}");
    }
}

#[test]
fn the_elements_of_a_range_are_decimals_not_sums() {
    let range = AngleRange::parse("0.1deg:179.9deg:0.1deg").unwrap();
    assert_eq!(range.len(), 1799);
    for (k, angle) in range.iter().enumerate() {
        let tenths = k + 1;
        let decimal: Angle = format!("{}.{}deg", tenths / 10, tenths % 10).parse().unwrap();
        assert_eq!(angle, decimal, "{tenths} tenths of a degree");
    }
    let radians = AngleRange::parse("0.1:3.1:0.1").unwrap();
    assert_eq!(radians.get(2).unwrap(), Angle::from_radians(0.3).unwrap());
    assert_eq!(radians.get(31), None);
    let times: Vec<f64> = NumberRange::parse("0s:1s:100ms", Dimension::Time).unwrap().iter().collect();
    assert_eq!(times, [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]);
}

#[test]
fn ranges_may_run_downwards_and_up_to_the_top() {
    assert_eq!(AngleRange::parse("10deg:-10deg:-5deg").unwrap().len(), 5);
    let upwards = AngleRange::parse("pi-1e-6:pi:1e-7").unwrap();
    assert_eq!((upwards.len(), upwards.get(9).unwrap().complement()), (11, 1e-7));
    assert_eq!(upwards.get(10).unwrap().complement().to_bits(), 0);
    assert_eq!(AngleRange::parse("0:180deg:60deg").unwrap().get(3), Some("180deg".parse().unwrap()));
    assert_eq!(AngleRange::parse("1deg:1deg:1deg").unwrap().len(), 1);
    assert_eq!(NumberRange::parse("0:1:0.3", Dimension::Time).unwrap().iter().last(), Some(0.9));
}

#[test]
fn ranges_without_an_answer_are_refused() {
    for (text, fits) in [
        ("0:1:1e-12", (|e| matches!(e, RangeError::TooMany(_))) as fn(&RangeError) -> bool),
        ("0:1e300:1e-300", |e| matches!(e, RangeError::TooMany(_))),
        ("0:1:0", |e| matches!(e, RangeError::ZeroStep(_))),
        ("0:1:-1", |e| matches!(e, RangeError::WrongSign(_))),
        ("0:1", |e| matches!(e, RangeError::NotThreeParts(..))),
        ("0:1:1:1", |e| matches!(e, RangeError::NotThreeParts(..))),
        ("0:x:1", |e| matches!(e, RangeError::Part(_))),
    ] {
        let error = NumberRange::parse(text, Dimension::Time).unwrap_err();
        assert!(fits(&error), "{text}: {error}");
    }
    assert!(matches!(AngleRange::parse("1:179:1deg"), Err(RangeError::MixedUnits(_))));
    assert!(matches!(angles("60,5deg"), Err(RangeError::MixedUnits(_))));
    assert!(matches!(AngleRange::parse("1deg:179deg:1e-12deg"), Err(RangeError::TooMany(_))));
}

#[test]
fn lists_are_read_element_by_element() {
    assert_eq!(numbers("0, 500ms ,2", Dimension::Time).unwrap(), [0.0, 0.5, 2.0]);
    assert_eq!(angles("60deg, pi-1e-9").unwrap().len(), 2);
    assert_eq!(angles("1deg:3deg:1deg").unwrap().len(), 3);
    assert!(numbers("1,,2", Dimension::Time).is_err());
}

/// Texts of random pieces that the grammars contain.
fn scrambled(count: usize) -> impl Iterator<Item = String> {
    const PIECES: [&str; 30] = [
        "1", "2.5", "0", "9e9", "1e-300", "e", "-", "+", "±", "(", ")", ":", ",", ".", " ", "deg", "°",
        "rad", "pi", "π", "/", "*", "m", "cm", "s", "m/s^2", "%", "−", "\0", "五",
    ];
    let mut seed = 1u64;
    let mut next = move |below: usize| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        usize::try_from(seed >> 33).unwrap() % below
    };
    (0..count).map(move |_| {
        let length = next(9);
        (0..length).map(|_| PIECES[next(PIECES.len())]).collect()
    })
}

#[test]
fn no_text_makes_the_readers_panic() {
    let mut read = 0;
    for text in scrambled(50_000) {
        read += usize::from(text.parse::<Angle>().is_ok());
        read += usize::from(parse(&text, Dimension::Length).is_ok());
        if text.matches(':').count() == 2 {
            read += usize::from(AngleRange::parse(&text).is_ok());
            read += usize::from(NumberRange::parse(&text, Dimension::Time).is_ok());
        }
    }
    assert!(read > 1000, "only {read} of the texts were read at all");
}

#[test]
fn rates_are_one_over_a_time() {
    for (text, value, uncertainty) in [
        ("0.03/s", 0.03, None),
        ("0.030(1) /s", 0.03, Some(0.001)),
        ("0.03±0.03 1/s", 0.03, Some(0.03)),
        ("1.8 /min ± 100%", 0.03, Some(0.03)),
        ("0.03", 0.03, None),
    ] {
        let rate = parse(text, Dimension::Rate).unwrap();
        assert_eq!((rate.value, rate.uncertainty), (value, uncertainty), "{text}");
    }
    assert!(parse("0.03 s", Dimension::Rate).unwrap_err().to_string().contains("a rate"));
}

#[test]
fn uncertainties_may_be_zero_and_larger_than_the_value() {
    let uncertainty = |text: &str| parse(text, Dimension::Length).unwrap().uncertainty;
    assert_eq!(uncertainty("1m±1m"), Some(1.0));
    assert_eq!(uncertainty("1m±150%"), Some(1.5));
    assert_eq!(uncertainty("1(3)m"), Some(3.0));
    assert_eq!(uncertainty("1m±0m"), Some(0.0));
    assert_eq!(uncertainty("1m"), None);
    assert!(parse("1m±-1m", Dimension::Length).is_err());
}

#[test]
fn numbers_in_a_unit_are_what_their_text_is() {
    let units = [
        ("deg", Dimension::Angle),
        ("turn", Dimension::Angle),
        ("mrad", Dimension::Angle),
        ("deg/s", Dimension::AngularVelocity),
        ("ms", Dimension::Time),
        ("ns", Dimension::Time),
        ("min", Dimension::Time),
        ("cm", Dimension::Length),
        ("in", Dimension::Length),
    ];
    // Few digits and many, also at the limit beyond which two words no longer decide the rounding, and at the ends of the range.
    let tenths = (-1800..=1800).map(|n| f64::from(n) / 10.0);
    let others = (1..400_i32).map(|n| libm::sin(f64::from(n)) * libm::pow(10.0, f64::from(n % 60 - 30)));
    let ends = [f64::MIN_POSITIVE, 5e-324, 1e-310, 1e300, f64::EPSILON, 9_007_199_254_740_993.0, 1e22, 1e23];
    for number in tenths.chain(others).chain(ends) {
        for (unit, dimension) in units {
            let written = parse(&format!("{number:e} {unit}"), dimension).unwrap().value;
            let computed = in_si(number, unit, dimension).unwrap();
            assert_eq!(computed.to_bits(), (written + 0.0 * number).to_bits(), "{number:e} {unit}");
        }
    }
    assert_eq!(in_si(1.0, "s", Dimension::Length), None);
    assert_eq!(in_si(1.0, "parsec", Dimension::Length), None);
    assert_eq!(in_si(f64::MAX, "min", Dimension::Time), None);
    assert!(in_si(f64::NAN, "deg", Dimension::Angle).is_some_and(f64::is_nan));
}

#[test]
fn an_angle_is_a_quantity_too() {
    let angle = parse("17.0(5) deg", Dimension::Angle).unwrap();
    assert_eq!(angle.value.to_bits(), "17deg".parse::<Angle>().unwrap().radians().to_bits());
    assert!((angle.uncertainty.unwrap().to_degrees() - 0.5).abs() < 1e-15);
    assert!(parse("17deg", Dimension::Length).unwrap_err().to_string().contains("an angle"));
}
