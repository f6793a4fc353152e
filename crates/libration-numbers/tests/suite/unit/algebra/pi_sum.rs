use libration::algebra::{PiSum, Rational, Surd};
use std::f64::consts::PI;

fn sum(terms: &[(i32, &str, &str)]) -> PiSum {
    let surd = |a: &str, b: &str| Surd::new(a.parse().unwrap(), b.parse().unwrap(), Rational::from(2));
    PiSum::new(terms.iter().map(|&(power, a, b)| (power, surd(a, b))).collect())
}

#[test]
fn sums_are_written_as_formulas_that_mean_them() {
    for (terms, text) in [
        (&[][..], "0"),
        (&[(0, "-2/3", "0")], "-2/3"),
        (&[(-1, "-4/3", "0")], "-4/(3*pi)"),
        (&[(-2, "5", "0"), (0, "1/2", "0")], "1/2 + 5/pi^2"),
        (&[(1, "-1", "0"), (2, "3/4", "0")], "3/4*pi^2 - pi"),
        (&[(-1, "1", "-1")], "(1 - sqrt(2))/pi"),
        (&[(-1, "0", "-1/2"), (1, "0", "1")], "sqrt(2)*pi - 1/2*sqrt(2)/pi"),
    ] {
        assert_eq!(sum(terms).to_string(), text);
    }
}

#[test]
fn the_value_is_that_of_the_formula() {
    let value = sum(&[(-2, "5", "0"), (0, "1/2", "0"), (1, "0", "1")]).to_f64();
    assert!((value - (0.5 + 5.0 / (PI * PI) + 2.0_f64.sqrt() * PI)).abs() < 1e-15);
    assert_eq!(sum(&[(0, "3/7", "0")]).to_rational(), Rational::new(3, 7));
    assert_eq!(sum(&[(1, "3/7", "0")]).to_rational(), None);
}
