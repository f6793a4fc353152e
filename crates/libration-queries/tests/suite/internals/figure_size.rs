//! The sides of a picture.

use libration_queries::internals::figure_size::{PictureSide, side};

#[test]
fn lengths_have_units() {
    let units = |text| side(text).map(PictureSide::in_units);
    assert_eq!(units("600"), Ok(600.0));
    assert_eq!(units("600px"), Ok(600.0));
    assert!(
        (units("25.4mm").unwrap() - 96.0).abs() < 1e-9 && (units("2.54 cm").unwrap() - 96.0).abs() < 1e-9
    );
    for text in ["", "mm", "0", "-3", "nan", "inf", "wide", "4001", "2m", "1059mm"] {
        assert!(side(text).is_err(), "{text}");
    }
}
