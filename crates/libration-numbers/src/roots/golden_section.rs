//! Golden section: the maximum of a function, and a search for the opposite sign next to a minimum.

/// A point and the value there.
type Point = (f64, f64);

/// The longer part of a unit interval divided by the golden section, (√5 − 1)/2.
const LONGER: f64 = 0.618_033_988_749_894_9;
/// The shorter part, (3 − √5)/2.
const SHORTER: f64 = 0.381_966_011_250_105_2;

/// Position and value of a maximum of `f` between `a` and `b`; the position is accurate to `tolerance`.
pub fn maximum_between(f: &mut dyn FnMut(f64) -> f64, a: f64, b: f64, tolerance: f64) -> Point {
    let mut at = |x: f64| (x, f(x));
    let (mut low, mut high) = (a, b);
    let mut left = at(high - LONGER * (high - low));
    let mut right = at(low + LONGER * (high - low));
    while high - low > tolerance {
        if left.1 > right.1 {
            high = right.0;
            right = left;
            left = at(high - LONGER * (high - low));
        } else {
            low = left.0;
            left = right;
            right = at(low + LONGER * (high - low));
        }
    }
    if left.1 > right.1 { left } else { right }
}

/// A point at which a function has the opposite sign, given three points at which it has the same sign and is nearest to zero at the middle one;
/// `None` if no such point is found between the outer ones.
pub fn other_sign_between(points: [Point; 3], f: impl Fn(f64) -> f64) -> Option<Point> {
    /// Golden sections after which the interval is 5e-7 of the first one.
    const ROUNDS: u32 = 30;
    let sign = points[1].1.signum();
    let [low, middle, high] = points.map(|(_, value)| sign * value);
    if !(low > middle && high >= middle && middle > 0.0) {
        return None;
    }
    let [mut a, mut b, mut c] = points.map(|(point, _)| point);
    let mut least = middle;
    for _ in 0..ROUNDS {
        let right = c - b > b - a;
        let there = if right { b + SHORTER * (c - b) } else { b - SHORTER * (b - a) };
        let here = sign * f(there);
        if here < 0.0 {
            return Some((there, sign * here));
        }
        if here < least {
            (a, c) = if right { (b, c) } else { (a, b) };
            (b, least) = (there, here);
        } else if right {
            c = there;
        } else {
            a = there;
        }
    }
    None
}
