//! Elementary functions in two words, relative error about 2⁻¹⁰⁰. Slow: for what is prepared once.

use crate::double_double::{DoubleDouble, fast_two_sum};

/// sin x and cos x for |x| ≤ π/2 or a little more, each relatively accurate except next to its far zero.
pub(crate) fn sin_cos(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    if x.hi.abs() > std::f64::consts::FRAC_PI_4 {
        let rest = if x.hi > 0.0 { DoubleDouble::FRAC_PI_2 - x } else { DoubleDouble::FRAC_PI_2 + x };
        let (c, s) = sin_cos_series(rest);
        return (if x.hi > 0.0 { s } else { -s }, c);
    }
    sin_cos_series(x)
}

/// Taylor's series in nested form for |x| ≤ π/4.
fn sin_cos_series(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let y = x.square();
    let (mut sine, mut cosine) = (DoubleDouble::ONE, DoubleDouble::ONE);
    for n in (1..=14_u32).rev() {
        let even = f64::from(2 * n);
        cosine = DoubleDouble::ONE - y * cosine / (even * (even - 1.0));
        sine = DoubleDouble::ONE - y * sine / (even * (even + 1.0));
    }
    (x * sine, cosine)
}

/// eˣ for −745.2 ≤ x ≤ 709; below −700 the second word begins to underflow, which costs nothing once rounded.
pub(crate) fn exp(x: DoubleDouble) -> DoubleDouble {
    let n = (x.hi * std::f64::consts::LOG2_E).round();
    let r = x - DoubleDouble::LN_2 * n;
    let mut sum = DoubleDouble::ONE;
    for i in (1..=24_u32).rev() {
        sum = DoubleDouble::ONE + r * sum / f64::from(i);
    }
    // Two factors, so that neither overflows nor falls below the normal numbers.
    let half = (n / 2.0).round();
    sum.scaled(libm::exp2(half)).scaled(libm::exp2(n - half))
}

/// ln x for a positive x, however small.
pub(crate) fn ln(x: DoubleDouble) -> DoubleDouble {
    let (half_to_one, above) = libm::frexp(x.hi);
    // Within [√½, √2): near one nothing cancels, and the power below keeps its second word.
    let exponent = if half_to_one < std::f64::consts::FRAC_1_SQRT_2 { above - 1 } else { above };
    let fraction = x.times_power_of_two(-exponent);
    let first = DoubleDouble::from(libm::log(fraction.hi));
    // With y the first guess, ln x = y + 2 artanh((x − eʸ)/(x + eʸ)), and the argument is of order 2⁻⁵³.
    let guess = exp(first);
    let missing = ((fraction - guess) / (fraction + guess)).scaled(2.0);
    DoubleDouble::LN_2 * f64::from(exponent) + (first + missing)
}

/// The angle of the point (x, y), within [−π, π].
pub(crate) fn atan2(y: DoubleDouble, x: DoubleDouble) -> DoubleDouble {
    let size = if y.hi.abs() > x.hi.abs() { y.abs() } else { x.abs() };
    if size.hi == 0.0 || !size.is_finite() {
        return DoubleDouble::from(libm::atan2(y.hi, x.hi));
    }
    let (y, x) = (y / size, x / size);
    let (ay, ax) = (y.abs(), x.abs());
    let small = ay.hi <= ax.hi;
    let acute = if small { atan_unit(ay, ax) } else { DoubleDouble::FRAC_PI_2 - atan_unit(ax, ay) };
    let angle = if x.hi < 0.0 { DoubleDouble::PI - acute } else { acute };
    if y.hi < 0.0 { -angle } else { angle }
}

/// atan(y/x) for 0 ≤ y ≤ x.
fn atan_unit(y: DoubleDouble, x: DoubleDouble) -> DoubleDouble {
    let first = DoubleDouble::from(libm::atan2(y.hi, x.hi));
    let (s, c) = sin_cos(first);
    // The tangent of what is missing, so small that it is the angle.
    let correction = (y * c - x * s) / (x * c + y * s);
    let sum = first + correction;
    fast_two_sum(sum.hi, sum.lo)
}
