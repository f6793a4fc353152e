use libration::internals::pendulum::{DEGREE, ROWS, rows};

/// The sums of powers of y for the angle and the velocity, from the rows of a segment.
fn sums(rows: &[[f64; 4]; ROWS], y: f64) -> [f64; 2] {
    let value = |lane: usize| rows.iter().fold(0.0, |sum, row| sum * (y * y) + row[lane]);
    [value(0) + y * value(1), value(2) + y * value(3)]
}

/// The twelfth power alone with a coefficient as large as the others, so that an error in it exceeds their rounding.
#[test]
fn the_last_term_is_spread_over_lower_ones() {
    let mut x = [0.0; DEGREE + 1];
    x[DEGREE] = 4096.0;
    let rows = rows(&x, 1.0, [0.0, 0.0]);
    for i in -100..=100 {
        let z = f64::from(i) / 100.0;
        let [angle, velocity] = sums(&rows, 0.5 * z);
        let chebyshev = libm::cos(12.0 * libm::acos(z)) / 2048.0;
        assert!((angle - (libm::pow(z, 12.0) - chebyshev)).abs() < 1e-14, "{z}: {angle}");
        // The velocity contains the eleventh power.
        assert!((velocity - 12.0 * 2.0 * libm::pow(z, 11.0)).abs() < 1e-13, "{z}: {velocity}");
    }
}
