//! How likely chance is to give a coefficient as far from zero as this.

use std::f64::consts::FRAC_2_PI;

/// The probability that |t| of Student's distribution is at least this large; whole degrees of freedom, one or more.
///
/// The finite sums 26.7.3 and 26.7.4 of Abramowitz and Stegun.
///
/// # Accuracy
/// 1e-14 absolute.
pub(super) fn probability_beyond(t: f64, dof: usize) -> f64 {
    let angle = libm::atan(t.abs() / super::small_angle_period::count(dof).sqrt());
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    let odd = dof % 2 == 1;
    let mut term = if odd { cosine } else { 1.0 };
    let mut sum = 0.0;
    for k in (if odd { 2 } else { 1 }..dof).step_by(2) {
        sum += term;
        let k = super::small_angle_period::count(k);
        term *= cosine * cosine * k / (k + 1.0);
    }
    let inside = if odd { FRAC_2_PI * (angle + sine * sum) } else { sine * sum };
    (1.0 - inside).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// SciPy 1.17: `2*scipy.stats.t.sf(t, dof)`.
    #[test]
    fn the_tails_are_those_of_the_tables() {
        for (t, dof, expected) in [
            (1.0, 1, 0.5),
            (2.0, 2, 0.18350341907227397),
            (2.5, 3, 0.08770664700806556),
            (-3.0, 10, 0.01334365502256957),
            (4.0, 55, 0.00019078887405470378),
        ] {
            let found = probability_beyond(t, dof);
            assert!((found - expected).abs() < 1e-14, "{t} {dof}: {found}");
        }
    }
}
