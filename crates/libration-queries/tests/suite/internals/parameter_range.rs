//! Ranges of a parameter.

use libration_queries::internals::parameter_range::parameter_range;

#[test]
fn ranges_hold_the_decimals_that_are_meant() {
    let range = parameter_range("A=0.9:1.2:0.1").unwrap();
    assert_eq!((range.name.as_str(), &range.values[..]), ("A", &[0.9, 1.0, 1.1, 1.2][..]));
    assert_eq!(parameter_range("mu=3:1:-1").unwrap().values, [3.0, 2.0, 1.0]);
    assert_eq!(parameter_range("mu=1,pi/2").unwrap().values, [1.0, std::f64::consts::FRAC_PI_2]);
}

#[test]
fn what_is_no_range_is_refused() {
    for text in ["A", "A=1:2", "A=1:2:0", "A=1:2:-0.1", "A=0:1:1e-9", "A=x:1:0.1", "A=1/0"] {
        assert!(parameter_range(text).is_err(), "{text}");
    }
}
