use libration::algebra::{Rational, Rationals, Ring};
use libration::series::{powers, powers_of_inverse, product, reciprocal, square_root_of_unit};

fn series(texts: &[&str]) -> Vec<Rational> {
    texts.iter().map(|text| text.parse().unwrap()).collect()
}

fn sine() -> Vec<Rational> {
    series(&["0", "1", "0", "-1/6", "0", "1/120", "0", "-1/5040"])
}

#[test]
fn the_square_root_of_a_square_is_the_series() {
    let a = series(&["1", "-3/2", "5", "7/9", "0", "2"]);
    let square = product(&Rationals, &a, &a, a.len());
    assert_eq!(square_root_of_unit(&Rationals, &square), Some(a.clone()));
    let one = product(&Rationals, &a, &reciprocal(&Rationals, &a).unwrap(), a.len());
    assert_eq!(one, series(&["1", "0", "0", "0", "0", "0"]));
}

#[test]
fn the_inverse_of_the_sine_is_the_arcsine() {
    let inverse = powers_of_inverse(&Rationals, &sine()).unwrap();
    assert_eq!(inverse.first(), series(&["0", "1", "0", "1/6", "0", "3/40", "0", "5/112"]));
    assert_eq!(inverse.composed(&Rationals, &sine()), series(&["0", "1", "0", "0", "0", "0", "0", "0"]));
    let sine_of = powers(&Rationals, &sine()).unwrap();
    assert_eq!(sine_of.composed(&Rationals, &inverse.first()), inverse.composed(&Rationals, &sine()));
}

#[test]
fn products_of_even_and_odd_series_are_dense_products() {
    let dense = series(&["2", "1", "1/3", "5", "-1"]);
    let odd = series(&["0", "4", "0", "-1/7"]);
    for (a, b) in [(&odd, &odd), (&odd, &dense), (&dense, &dense)] {
        for length in [1, 2, 5, 8] {
            let direct = Rationals.series_product(a, b, length);
            assert_eq!(product(&Rationals, a, b, length), direct);
        }
    }
}
