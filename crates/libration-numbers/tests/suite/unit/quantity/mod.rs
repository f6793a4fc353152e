//! Angles compared with values computed by mpmath at 3000 bits, and their internal consistency.

#![expect(clippy::approx_constant, reason = "golden numbers stand as mpmath printed them")]

mod bare_radians;
mod decimal;
mod digits;

use libration::internals::quantity::PiCombination;
use libration::quantity::{Angle, Displacement, QuantityError, RangeError, exact_angles, exact_numbers};
use libration_kernels::double_double::DoubleDouble;

/// Text, turns, and two words each for the angle in the turn and for the complement (mpmath 1.4.1).
const FROM_TEXT: [(&str, i64, f64, f64, f64, f64); 17] = [
    ("60deg", 0, 1.0471975511965979, -1.072081766451091e-16, 2.0943951023931957, -2.144163532902182e-16),
    (
        "179.999999deg",
        0,
        3.1415926361365005,
        1.9147505689367385e-16,
        1.7453292519943295e-08,
        1.1984376235705418e-24,
    ),
    (
        "180.5deg",
        1,
        -3.1328660073298216,
        -2.3438009170513805e-17,
        0.008726646259971648,
        1.4743261354350843e-19,
    ),
    ("540deg", 1, 3.141592653589793, 1.2246467991473532e-16, 0.0, 0.0),
    ("-180deg", 0, -3.141592653589793, -1.2246467991473532e-16, 0.0, 0.0),
    ("180deg", 0, 3.141592653589793, 1.2246467991473532e-16, 0.0, 0.0),
    ("-60deg", 0, -1.0471975511965979, 1.072081766451091e-16, 2.0943951023931957, -2.144163532902182e-16),
    ("1e-9deg", 0, 1.7453292519943295e-11, 1.0174918645745669e-27, 3.14159265357234, -2.0018946070155844e-17),
    (
        "1000000000.25deg",
        2777778,
        -1.3919000784654778,
        -2.958703402610842e-17,
        1.7496925751243153,
        9.28776458886269e-17,
    ),
    (
        "179.99999999999999999999deg",
        0,
        3.141592653589793,
        1.224645053818101e-16,
        1.7453292519943296e-22,
        1.9362482335013525e-39,
    ),
    ("pi-1e-6", 0, 3.1415916535897934, -1.818465629566004e-16, 1e-06, 4.525188817411374e-23),
    ("pi-1e-300", 0, 3.141592653589793, 1.2246467991473532e-16, 1e-300, -2.5059094e-317),
    (
        "180deg-1e-9deg",
        0,
        3.14159265357234,
        -2.0018946070155844e-17,
        1.7453292519943295e-11,
        1.0174918645745669e-27,
    ),
    ("-pi/3", 0, -1.0471975511965979, 1.072081766451091e-16, 2.0943951023931957, -2.144163532902182e-16),
    ("2pi-1e-3", 1, -0.001, 2.0816681711721686e-20, 3.1405926535897932, 1.233055587191979e-17),
    ("pi+0.1", 1, -3.041592653589793, -2.1128252188474785e-16, 0.1, -5.551115123125783e-18),
    ("180deg-1e-9rad", 0, 3.141592652589793, 2.0520505091382568e-16, 1e-09, -6.228159145777985e-26),
];

/// The same values for the nearest `f64` of the text.
const FROM_RADIANS: [(&str, i64, f64, f64, f64, f64); 10] = [
    ("3.141592653589793", 0, 3.141592653589793, 0.0, 1.2246467991473532e-16, -2.9947698097183397e-33),
    (
        "3.1415926535897936",
        1,
        -3.141592653589793,
        1.9915985002059197e-16,
        3.216245299353273e-16,
        -2.165713347843828e-32,
    ),
    ("-3.5", -1, 2.7831853071795867, -1.9915985002059197e-16, 0.3584073464102068, -1.1442377452219664e-17),
    ("1.2", 0, 1.2, 0.0, 1.9415926535897934, -9.957992501029599e-17),
    ("1e-300", 0, 1e-300, 0.0, 3.141592653589793, 1.2246467991473532e-16),
    (
        "6.283185307179586",
        1,
        -2.4492935982947064e-16,
        5.989539619436679e-33,
        3.141592653589793,
        -1.2246467991473532e-16,
    ),
    (
        "9007199254740992.0",
        1433540284805665,
        -2.1276428765770463,
        -1.3415010681967913e-16,
        1.0139497770127468,
        -1.1685426904943816e-17,
    ),
    (
        "5000000000000001.0",
        795774715459477,
        -1.0178800290086099,
        -1.0977644429625856e-16,
        2.1237126245811835,
        -2.0935636930655456e-16,
    ),
    (
        "411557987.0",
        65501488,
        2.5367160519636766e-09,
        -1.2971677943552668e-25,
        3.1415926510530774,
        -2.031345052930539e-16,
    ),
    (
        "2549491779.0",
        405764219,
        4.474494938161497e-10,
        -1.4034431208799226e-26,
        3.141592653142344,
        -1.8253968160231227e-16,
    ),
];

const TWO_WORDS: f64 = 1e-31;

/// Returns `true` if two words agree to 1e-31, which leaves a small margin for the correctly rounded sums of the fast path; below 1e-290 the low
/// word is subnormal.
fn same_words(ours: DoubleDouble, hi: f64, lo: f64) -> bool {
    let difference = (ours - DoubleDouble::new(hi, lo)).to_f64().abs();
    difference <= hi.abs() * TWO_WORDS || difference <= f64::MIN_POSITIVE * 1e-12
}

#[test]
fn text_means_the_decimal_to_two_words() {
    for (text, turns, hi, lo, complement_hi, complement_lo) in FROM_TEXT {
        let angle: Angle = text.parse().unwrap();
        assert_eq!(angle.turns(), turns, "{text}");
        assert!(same_words(angle.in_turn_words(), hi, lo), "{text}: {angle:?}");
        assert!(same_words(angle.complement_words(), complement_hi, complement_lo), "{text}: {angle:?}");
    }
}

#[test]
fn radians_are_reduced_to_two_words() {
    for (text, turns, hi, lo, complement_hi, complement_lo) in FROM_RADIANS {
        let angle = Angle::from_radians(text.parse().unwrap()).unwrap();
        assert_eq!(angle.turns(), turns, "{text}");
        assert!(same_words(angle.in_turn_words(), hi, lo), "{text}: {angle:?}");
        assert!(same_words(angle.complement_words(), complement_hi, complement_lo), "{text}: {angle:?}");
    }
}

#[test]
fn the_fast_road_and_the_exact_road_agree() {
    for k in 0..=3000 {
        let x = DoubleDouble::PI.hi * f64::from(k) / 3000.0;
        for x in [x, -x, x * 1e-9, DoubleDouble::PI.hi - x * 1e-12] {
            let (fast, exact) = (Angle::from_radians(x).unwrap(), PiCombination::radians(x).to_angle());
            assert_eq!(fast.in_turn_words(), exact.in_turn_words(), "{x:e}");
            let complement = exact.complement_words();
            assert!(same_words(fast.complement_words(), complement.hi, complement.lo), "{x:e}");
        }
    }
}

#[test]
fn radians_come_back_unchanged() {
    for x in [1e-310, 0.1, 3.141592653589793, 3.2, -17.0, 355.0, 1e10 + 0.3, 9007199254740992.0] {
        for x in [x, -x] {
            assert_eq!(Angle::from_radians(x).unwrap().radians().to_bits(), x.to_bits(), "{x}");
        }
    }
}

#[test]
fn what_is_shown_reads_back_as_the_same_radians_and_complement() {
    for text in ["60deg", "-1.2", "pi-1e-300", "179.99999deg", "-180deg", "pi+1e-6", "540deg", "0"] {
        let angle: Angle = text.parse().unwrap();
        let again: Angle = angle.to_string().parse().unwrap();
        assert_eq!(again.radians().to_bits(), angle.radians().to_bits(), "{text} shown as {angle}");
        if angle.turns() == 0 && angle.complement() < 1e-3 {
            assert_eq!(again.complement().to_bits(), angle.complement().to_bits(), "{text} shown as {angle}");
        }
    }
}

#[test]
fn spellings_of_one_angle_agree() {
    let groups: [&[&str]; 5] = [
        &["60deg", "60°", "60 deg", " +60 degrees ", "pi/3", "π/3", "6e1deg", "60DEG"],
        &["1.2", "1.2rad", "1.2 radians", "+1.20"],
        &["pi-1e-6", "π-1e-6", "pi - 1e-6", "pi-1e-6rad", "π − 0.000001", "180deg-1e-6rad", "1pi-1e-6"],
        &["180deg-1e-9deg", "180°-1e-9°", "pi-1e-9deg"],
        &["-pi/2", "-90deg", "−90°", "-0.5pi", "-0.5*pi", "-90°"],
    ];
    for group in groups {
        let first: Angle = group[0].parse().unwrap();
        for text in group {
            assert_eq!(text.parse::<Angle>().unwrap(), first, "{text}");
        }
    }
}

#[test]
fn the_top_is_an_exact_zero_of_the_complement() {
    for text in ["pi", "180deg", "-180deg", "3pi", "pi-0", "179deg+1deg", "-540deg"] {
        let angle: Angle = text.parse().unwrap();
        assert_eq!(angle.complement().to_bits(), 0, "{text}");
        assert_eq!(angle.in_turn().abs().to_bits(), DoubleDouble::PI.hi.to_bits(), "{text}");
    }
    assert_eq!("-540deg".parse::<Angle>().unwrap().turns(), -1);
}

#[test]
fn a_complement_is_kept_however_small() {
    for complement in [5e-324, 1e-300, 1e-9, 1.0, 3.141592653589793] {
        let angle = Angle::from_complement(complement).unwrap();
        assert_eq!(angle.complement().to_bits(), complement.to_bits());
    }
    assert!(Angle::from_complement(-1e-9).is_err() && Angle::from_complement(3.15).is_err());
}

#[test]
fn degrees_are_radians_times_180_over_pi() {
    for degrees in [0.1, 60.0, 179.999999, -1234.5] {
        let back = Angle::from_degrees(degrees).unwrap().degrees();
        assert!((back - degrees).abs() <= f64::EPSILON * degrees.abs(), "{degrees} came back as {back}");
    }
}

#[test]
fn hostile_texts_are_refused_with_a_hint() {
    let long = "9".repeat(1 << 20);
    let nested = format!("pi-{}", "0".repeat(1 << 20));
    for text in [
        "",
        " ",
        "deg",
        "60dge",
        "60degrees-",
        "pi-",
        "--1",
        "1-1",
        "1,2rad",
        "180deg-1e-9",
        "pi/0",
        "pi/-3",
        "1e-999999999",
        "pi-1e-999999999",
        "1e400",
        "1e400deg",
        "1e300deg",
        "1e17",
        "nan",
        "inf",
        "-inf",
        "6\0deg",
        "٦٠deg",
        "pi-1e-301",
        "1e-310deg",
        "pi-1-1",
        "1e",
        "π°",
        "0x10",
        "1_000",
        &long,
        &nested,
    ] {
        let message = text.parse::<Angle>().unwrap_err().to_string();
        assert!(message.len() < 250 && !message.contains('\0'), "{message}");
    }
    assert_eq!(
        "60dge".parse::<Angle>().unwrap_err().to_string(),
        "cannot read `60dge` as an angle: write 60deg, 1.2rad, pi-1e-6 or 180deg-1e-9deg"
    );
    assert!("1,2rad".parse::<Angle>().unwrap_err().to_string().contains("point"));
    assert_eq!(Angle::from_radians(f64::INFINITY), Err(QuantityError::NotAnAngle(f64::INFINITY)));
}

#[test]
fn displacements_are_the_decimals_that_are_written() {
    let number = |text: &str| Displacement::from_number_text(text).unwrap();
    assert_eq!(number(" +1e-3 "), number("0.001"));
    assert_ne!(Some(number("0.001")), Displacement::from_f64(0.001));
    assert_eq!(Some(number("-0.5")), Displacement::from_f64(-0.5));
    assert_eq!((number("0.1").to_f64(), number("0.1").to_string()), (0.1, "0.1".to_owned()));
    assert_eq!(Displacement::from_f64(f64::INFINITY), None);
    for text in ["", "1,5", "40deg", "1e999", "nan"] {
        assert!(Displacement::from_number_text(text).is_err(), "{text}");
    }
    let angle = |text: &str| Displacement::from_angle_text(text).unwrap();
    assert_eq!(angle("180deg"), angle("pi"));
    let complement = angle("pi-1e-12").to_angle().unwrap().complement();
    assert_eq!(complement.to_bits(), 1e-12_f64.to_bits());
    assert_eq!(angle("pi-1e-12").fraction(), None);
    assert!(number("0.25").fraction().is_some());
}

#[test]
fn ranges_and_lists_of_displacements_are_exact() {
    let texts = ["0.1", "0.2", "0.3"].map(|text| Displacement::from_number_text(text).unwrap());
    assert_eq!(exact_numbers("0.1:0.3:0.1").unwrap(), texts);
    assert_eq!(exact_numbers("0.1, 0.2,0.3").unwrap(), texts);
    let angles = ["60deg", "120deg", "180deg"].map(|text| Displacement::from_angle_text(text).unwrap());
    assert_eq!(exact_angles("60deg:180deg:60deg").unwrap(), angles);
    assert_eq!(exact_angles("60deg, 120deg,pi").unwrap(), angles);
    assert!(matches!(exact_angles("60,5deg"), Err(RangeError::MixedUnits(_))));
    assert!(exact_numbers("1deg").is_err() && exact_numbers("1:2").is_err());
}
