//! The maximum of a function on an interval.

/// The place and value of a maximum of `f` between `a` and `b` by golden section, the place to `tolerance`.
pub fn maximum_between(f: &mut dyn FnMut(f64) -> f64, a: f64, b: f64, tolerance: f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut low, mut high) = (a, b);
    let mut left = at(f, high - GOLDEN * (high - low));
    let mut right = at(f, low + GOLDEN * (high - low));
    while high - low > tolerance {
        if left.1 > right.1 {
            high = right.0;
            right = left;
            left = at(f, high - GOLDEN * (high - low));
        } else {
            low = left.0;
            left = right;
            right = at(f, low + GOLDEN * (high - low));
        }
    }
    if left.1 > right.1 { left } else { right }
}

fn at(f: &mut dyn FnMut(f64) -> f64, x: f64) -> (f64, f64) {
    (x, f(x))
}
