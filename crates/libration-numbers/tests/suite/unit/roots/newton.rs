use libration::algebra::{BigFloat, Doubles, Floats};
use libration::expression::{Expression, Symbol};
use libration::internals::expression::Tape;
use libration::internals::roots::{NewtonError, Unsolved, correction, newton};

fn tape(formulas: &[&str], names: &[&str]) -> Tape {
    let formulas: Vec<Expression> = formulas.iter().map(|formula| formula.parse().unwrap()).collect();
    let names: Vec<Symbol> = names.iter().map(|name| Symbol::plain(name)).collect();
    Tape::new(&formulas.iter().collect::<Vec<_>>(), &names).unwrap()
}

fn in_doubles(tape: &Tape, guess: &[f64]) -> Result<Vec<f64>, Unsolved<f64>> {
    let size = |x: &f64| x.abs();
    newton(
        &Doubles,
        guess,
        50,
        |at| correction(&Doubles, size, tape, at),
        |change, _| change.iter().all(|x| x.abs() < 1e-12),
    )
}

#[test]
fn a_circle_and_a_line_cross_at_the_corner_of_a_triangle() {
    let corner = in_doubles(&tape(&["x^2 + y^2 - 25", "4*x - 3*y"], &["x", "y"]), &[2.0, 5.0]).unwrap();
    assert!((corner[0] - 3.0).abs() < 1e-14 && (corner[1] - 4.0).abs() < 1e-14, "{corner:?}");
}

/// √2 to 60 digits, as in OEIS A002193.
#[test]
fn zeros_are_found_to_the_digits_of_the_field() {
    let (ring, tape) = (Floats { precision: 240 }, tape(&["x^2 - 2"], &["x"]));
    let root = newton(
        &ring,
        &[BigFloat::from_f64(1.4, 240).unwrap()],
        20,
        |at| correction(&ring, |x| x.to_f64().abs(), &tape, at),
        |change, _| change[0].exponent().is_none_or(|size| size < -200),
    );
    let digits = root.unwrap()[0].to_rational().to_decimal(60);
    assert_eq!(digits, "1.41421356237309504880168872420969807856967187537694807317668");
}

#[test]
fn each_reason_for_no_zero_is_told_apart() {
    let reason =
        |formula: &str, guess: f64| in_doubles(&tape(&[formula], &["x"]), &[guess]).unwrap_err().reason;
    assert_eq!(reason("x^2 + 1", 0.0), NewtonError::NoSlope);
    assert_eq!(reason("1/x", 0.0), NewtonError::NoValue);
    assert_eq!(reason("x^2 + 1", 0.3), NewtonError::Unsettled);
    assert_eq!(in_doubles(&tape(&["x^2"], &["x"]), &[0.0]), Ok(vec![0.0]));
}
