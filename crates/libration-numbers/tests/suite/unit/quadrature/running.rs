use libration::internals::quadrature::{POINTS, points, running_integrals};
use libration_kernels::elementary::count;

#[test]
fn integrals_of_polynomials_are_exact() {
    for degree in 0..POINTS {
        let power = |x: f64, n: usize| (0..n).fold(1.0, |product, _| product * x);
        let (upto, all) = running_integrals(&points().map(|x| power(x, degree)));
        let exact = |x: f64| power(x, degree + 1) / count(degree + 1);
        assert!((all - exact(1.0)).abs() < 1e-15, "{degree}");
        for (x, computed) in points().into_iter().zip(upto) {
            assert!((computed - exact(x)).abs() < 1e-15, "{degree} {x}: {computed}");
        }
    }
}
