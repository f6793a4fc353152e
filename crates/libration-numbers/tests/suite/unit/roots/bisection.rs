use libration::roots::{Tolerance, bisect};

fn counted(bracket: [f64; 2], tolerance: Tolerance, holds: impl Fn(f64) -> bool) -> ([f64; 2], u32) {
    let mut count = 0;
    let ends = bisect(bracket, tolerance, |x| {
        count += 1;
        holds(x)
    });
    (ends, count)
}

#[test]
fn neighbours_enclose_the_end_of_a_condition() {
    for end in [-3.25, 0.0, 5e-324, 1e-300, 1.0, 1.5_f64.next_down(), f64::MAX] {
        let ([below, above], count) = counted([-f64::MAX, f64::MAX], Tolerance::LAST_BIT, |x| x < end);
        assert!(below < end && above >= end && below.next_up() >= above, "{end:e}");
        assert!(count <= 2100, "{end:e}: {count}");
        let ([above, below], _) = counted([f64::MAX, -f64::MAX], Tolerance::LAST_BIT, |x| x >= end);
        assert!(below < end && above >= end, "{end:e}");
    }
}

#[test]
fn the_steps_are_as_many_as_the_tolerance_asks_for() {
    let (_, count) = counted([0.0, 1.0], Tolerance::absolute(0.25), |x| x < 0.3);
    assert_eq!(count, 2);
    let ([below, above], count) = counted([0.0, 1e6], Tolerance::relative(1e-10), |x| x < 2.0);
    assert!(above - below <= 1e-10 * above && count < 55, "{count}");
    assert_eq!(counted([1.0, 2.0], Tolerance::absolute(1.0), |_| true).1, 0);
}

#[test]
fn without_a_change_an_end_is_left() {
    let [_, end] = bisect([0.0, 1.0], Tolerance::LAST_BIT, |_| true);
    assert_eq!(end.to_bits(), 1.0_f64.to_bits());
    for start in [0.5, 1.0] {
        let [left, next] = bisect([0.5, start], Tolerance::LAST_BIT, |_| false);
        assert!(left.to_bits() == 0.5_f64.to_bits() && next <= left.next_up(), "{next}");
    }
}

#[test]
fn what_is_not_finite_ends_at_once() {
    assert!(bisect([0.0, f64::INFINITY], Tolerance::relative(1e-3), |_| true)[0].abs() == 0.0);
    assert!(bisect([0.0, f64::NAN], Tolerance::LAST_BIT, |_| true)[1].is_nan());
}
