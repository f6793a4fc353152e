//! Zeros and extrema of a function on an interval, for functions that cost much to evaluate.

/// A zero of `f` between `a` and `b`, where it has the values `fa` and `fb` of opposite sign: to the spacing of
/// `f64` or to `tolerance`, whichever is larger. The method of Oliveira and Takahashi, ACM TOMS 47, 5 (2021):
/// interpolation, kept within a shrinking window about the middle, so never much slower than bisection.
pub(super) fn zero_between(
    f: &mut dyn FnMut(f64) -> f64,
    a: (f64, f64),
    b: (f64, f64),
    tolerance: f64,
) -> f64 {
    let (mut low, mut high) = (a, b);
    let mut window = 2.0 * (b.0 - a.0).abs();
    while (high.0 - low.0).abs() > tolerance && low.1 != 0.0 && high.1 != 0.0 {
        let x = itp_point(low, high, window, tolerance);
        if x <= low.0.min(high.0) || x >= low.0.max(high.0) {
            break;
        }
        let value = (x, f(x));
        if (value.1 > 0.0) == (low.1 > 0.0) {
            low = value;
        } else {
            high = value;
        }
        window /= 2.0;
    }
    if low.1.abs() < high.1.abs() { low.0 } else { high.0 }
}

/// Interpolation moved towards the middle, at most as far from it as bisection would still allow.
fn itp_point(low: (f64, f64), high: (f64, f64), window: f64, tolerance: f64) -> f64 {
    let middle = f64::midpoint(low.0, high.0);
    let width = high.0 - low.0;
    let interpolated = (high.1 * low.0 - low.1 * high.0) / (high.1 - low.1);
    if !interpolated.is_finite() {
        return middle;
    }
    let towards = (middle - interpolated).signum();
    let shift = (0.2 * width * width / window.abs().max(tolerance)).min((middle - interpolated).abs());
    let truncated = interpolated + towards * shift;
    let radius = (window - width.abs()).max(0.0) / 2.0 + tolerance;
    if (truncated - middle).abs() <= radius { truncated } else { middle - towards * radius }
}

/// The place and value of a maximum of `f` between `a` and `b` by golden section, the place to `tolerance`.
pub(super) fn maximum_between(f: &mut dyn FnMut(f64) -> f64, a: f64, b: f64, tolerance: f64) -> (f64, f64) {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_are_found_to_the_last_bit_in_few_evaluations() {
        let mut evaluations = 0;
        let mut f = |x: f64| {
            evaluations += 1;
            x * x * x - 2.0
        };
        let root = zero_between(&mut f, (0.0, -2.0), (3.0, 25.0), 0.0);
        assert!((root - 1.2599210498948732).abs() < 3e-16, "{root}");
        assert!(evaluations < 60, "{evaluations}");
    }

    #[test]
    fn a_jump_to_infinity_is_bracketed() {
        let mut f = |x: f64| if x < 1.0 { -1.0 } else { f64::INFINITY };
        let root = zero_between(&mut f, (0.0, -1.0), (5.0, f64::INFINITY), 1e-12);
        assert!((root - 1.0).abs() < 1e-11, "{root}");
    }

    #[test]
    fn maxima_are_found() {
        let (place, value) = maximum_between(&mut |x| -(x - 0.3) * (x - 0.3), -1.0, 2.0, 1e-9);
        assert!((place - 0.3).abs() < 1e-8 && value.abs() < 1e-16);
    }
}
