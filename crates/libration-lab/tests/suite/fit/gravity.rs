//! The gravity that can be anywhere on the earth.

use libration_lab::fit::{GRAVITY_ON_EARTH, Uncertain, is_nowhere_on_earth};

#[test]
fn three_uncertainties_beyond_the_earth_are_too_much() {
    let gravity = |value: f64, uncertainty: f64| Uncertain { value, uncertainty };
    let [least, greatest] = GRAVITY_ON_EARTH;
    for edge in [least, greatest] {
        assert!(!is_nowhere_on_earth(gravity(edge, 0.0), f64::INFINITY));
    }
    assert!(is_nowhere_on_earth(gravity(least.next_down(), 0.0), f64::INFINITY));
    assert!(is_nowhere_on_earth(gravity(greatest.next_up(), 0.0), f64::INFINITY));
    assert!(!is_nowhere_on_earth(gravity(greatest + 0.299, 0.1), f64::INFINITY));
    assert!(is_nowhere_on_earth(gravity(greatest + 0.301, 0.1), f64::INFINITY));
    assert!(!is_nowhere_on_earth(gravity(least - 0.299, 0.1), f64::INFINITY));
    assert!(is_nowhere_on_earth(gravity(least - 0.301, 0.1), f64::INFINITY));
}
