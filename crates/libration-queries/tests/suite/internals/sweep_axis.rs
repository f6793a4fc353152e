//! The axes of a sweep are read.

use libration_queries::internals::sweep_axis::axis;

fn values(text: &str) -> Vec<String> {
    axis(text).unwrap().values
}

#[test]
fn ranges_keep_their_decimals_and_their_unit() {
    assert_eq!(values("A=1:1.3:0.1"), ["1.0", "1.1", "1.2", "1.3"]);
    assert_eq!(values("theta=-10deg:10deg:10deg"), ["-10.0deg", "0.0deg", "10.0deg"]);
    let axis = axis("length=0.5m:0.6m:0.1m").unwrap();
    assert_eq!((axis.numbers, axis.unit.as_str()), (Some(vec![0.5, 0.6]), "m"));
    assert_eq!(values("A=0:pi:pi/2"), ["0.0", "1.5707963267948966", "3.141592653589793"]);
}

#[test]
fn lists_are_given_as_they_are_typed() {
    let numbers = axis("mu=1, pi/2").unwrap();
    assert_eq!(numbers.values, ["1", "pi/2"]);
    assert_eq!(numbers.numbers, Some(vec![1.0, std::f64::consts::FRAC_PI_2]));
    let words = axis("file=a.csv,b.csv").unwrap();
    assert_eq!((words.numbers, words.values), (None, vec!["a.csv".to_owned(), "b.csv".to_owned()]));
    assert_eq!(values("initial=x=1,y=2;x=2,y=1"), ["x=1,y=2", "x=2,y=1"]);
    assert_eq!(axis("theta=1deg,1rad").unwrap().numbers, None, "two units");
    assert_eq!(axis("A=1\n,2").unwrap().values, ["1", "2"], "blanks around values do not count");
    assert_eq!(axis("e=1e-3,2e-3").unwrap().numbers, Some(vec![1e-3, 2e-3]));
}

#[test]
fn what_is_no_axis_is_refused() {
    for text in [
        "A",
        "=1:2:1",
        "A=",
        "A=1,,2",
        "A=1:2",
        "A=1:2:0",
        "A=1:2deg:1deg",
        "A=x:1:0.1",
        "{A}=1,2",
        "A=1\n0,2",
    ] {
        assert!(axis(text).is_err(), "{text}");
    }
}
