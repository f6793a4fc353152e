use crate::typed::equation;
use libration::chaos::{Theorem, angles, turning_groups};
use libration::expression::Expression;
use libration::internals::chaos::{has_jumps, theorem};

#[test]
fn an_angle_is_left_alone_by_a_turn() {
    assert_eq!(
        angles(&equation("a'' = -sin(a - b) + cos(2t - a); b'' = sin(a - b)*exp(cos(b))")),
        [true, true]
    );
    assert_eq!(angles(&equation("x'' = -sin(x/2)")), [false]);
    assert_eq!(angles(&equation("x'' = -x*cos(x)")), [false]);
    assert_eq!(angles(&equation("x'' = -2*sin(x/2)*cos(x/2) + tan(x/2)")), [true]);
    assert_eq!(angles(&equation("x'' = -sin(x/2)^2 - sin(3*x/2)*sin(x/2)")), [true]);
    assert_eq!(angles(&equation("x'' = -2*sin(x/2)*cos(x/2) - cos(x/2)")), [false]);
    assert_eq!(angles(&equation("x'' = -sin(x/2)*cos(x)")), [false]);
    assert_eq!(angles(&equation("x'' = -x'")), [false]);
}

#[test]
fn coordinates_turn_together_where_only_their_differences_are_outside_of_sines() {
    let groups = |text: &str| turning_groups(&equation(text));
    let springs = "x'' = -sin(x) - 0.2*x + y/5 + z; y'' = -sin(2*y) - 0.1*abs(y - x); z'' = -z + tan(x - y)";
    assert_eq!(groups(springs), [[0, 1]]);
    assert_eq!(groups("x'' = -sin(x) + sign(x - y); y'' = -sin(y)*sqrt(2 + (x - y)^2)"), [[0, 1]]);
    // The spring does not pull at differences; a coordinate alone is in a sign; a shift by any length changes nothing.
    assert!(groups("x'' = -sin(x) + 2*y - x; y'' = -sin(y) + x - y").is_empty());
    assert!(groups("x'' = -sin(x) + sign(x) - sign(y); y'' = -sin(y)*(x - y)").is_empty());
    assert!(groups("x'' = y - x; y'' = x - y").is_empty());
}

#[test]
fn jumps_are_found_where_they_remain() {
    let friction = equation("x'' = -x - c*sign(x') - x'*abs(x')");
    assert!(has_jumps(&friction));
    assert!(has_jumps(&equation("x'' = -x - 0.3*x'/abs(x')")));
    assert!(!has_jumps(&friction.with(&[("c", Expression::from(0))]).unwrap()));
}

#[test]
fn theorems_are_found_where_they_hold() {
    let cases = [
        ("x'' = x - x^3 - x'/3", Some(Theorem::Plane)),
        ("x'' = -sin(x); y'' = -y*y'^2", Some(Theorem::Plane)),
        ("x' = x - x*y; y' = x*y - y", Some(Theorem::Plane)),
        ("x' = x - x*y; y' = x*y - y*cos(t)", None),
        ("x' = -y - z; y' = x + y/5; z' = 1 + z*(x - 6)", None),
        ("x'' = -x*q; q' = -q", None),
        ("x' = -y - z*sin(t); y' = x + y/5; z' = 1 + z", Some(Theorem::Linear)),
        ("x'' = -2x + y*cos(t); y'' = x - y' + exp(t)", Some(Theorem::Linear)),
        ("x'' = -sin(x) + cos(t)", None),
        ("x'' = -sin(x); y'' = x - y", None),
        ("x'' = (1 + x)^2 - x^2 - x/(2 + t)", Some(Theorem::Linear)),
    ];
    for (text, expected) in cases {
        assert_eq!(theorem(&equation(text)), expected, "{text}");
    }
}
