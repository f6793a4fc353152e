//! The exact series of the period: published tables, an independent recurrence, and identities.

use libration::algebra::Rational;
use libration::period_formulas::{frequency_in_amplitude, period_in_amplitude, period_in_sine_squared};

fn rational(text: &str) -> Rational {
    text.parse().unwrap()
}

fn fraction(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator, denominator).unwrap()
}

fn index(n: usize) -> i64 {
    i64::try_from(n).unwrap()
}

fn rows(text: &str) -> impl Iterator<Item = Vec<&str>> {
    text.lines().filter(|line| !line.starts_with('#')).skip(1).map(|line| line.split(',').collect())
}

#[test]
fn period_series_is_the_one_in_the_encyclopedia_of_integer_sequences() {
    let series = period_in_amplitude(14);
    for row in rows(include_str!("../../../libration-testing/data/formulas_oeis_series.csv")) {
        let coefficient = &series[row[1].parse::<usize>().unwrap()];
        assert_eq!(coefficient.numerator(), row[2]);
        assert!(row[3].is_empty() || coefficient.denominator() == row[3]);
    }
}

#[test]
fn series_equal_the_ones_of_an_independent_composition() {
    for row in rows(include_str!("../../../libration-testing/data/formulas_series.csv")) {
        let n: usize = row[1].parse().unwrap();
        let series = match row[0] {
            "period_in_amplitude" => period_in_amplitude(n),
            "frequency_in_amplitude" => frequency_in_amplitude(n),
            _ => period_in_sine_squared(n),
        };
        assert_eq!(series[n], rational(row[2]), "{} {n}", row[0]);
    }
}

/// The numbers cⱼ of θ·cot θ = Σ cⱼθ²ʲ, from cos θ = (θ cot θ)·(sin θ/θ).
fn cotangent_series(length: usize) -> Vec<Rational> {
    let mut inverse_factorials = vec![Rational::from(1)];
    for k in 1..=2 * length + 1 {
        let next = inverse_factorials[k - 1].clone() * fraction(1, index(k));
        inverse_factorials.push(next);
    }
    let signed = |n: usize, k: usize| {
        if n.is_multiple_of(2) { inverse_factorials[k].clone() } else { -inverse_factorials[k].clone() }
    };
    let mut series: Vec<Rational> = Vec::new();
    for n in 0..length {
        let terms = (0..n).map(|j| series[j].clone() * signed(n - j, 2 * (n - j) + 1));
        series.push(terms.fold(signed(n, 2 * n), |rest, term| rest - term));
    }
    series
}

#[test]
fn period_series_satisfies_the_legendre_equation_to_the_200th_correction() {
    // R″ + cot θ0·R′ − R/4 = 0: 4n²tₙ = tₙ₋₁/4 − Σ 2(n−j)cⱼtₙ₋ⱼ over 1 ≤ j < n.
    let corrections = 200;
    let series = period_in_amplitude(corrections);
    let cotangent = cotangent_series(corrections);
    for n in 1..=corrections {
        let terms =
            (1..n).map(|j| fraction(2 * index(n - j), 1) * cotangent[j].clone() * series[n - j].clone());
        let right = terms.fold(fraction(1, 4) * series[n - 1].clone(), |rest, term| rest - term);
        assert_eq!(fraction(4 * index(n) * index(n), 1) * series[n].clone(), right, "n = {n}");
    }
}

#[test]
fn period_and_frequency_series_multiply_to_one() {
    let corrections = 300;
    let (period, frequency) = (period_in_amplitude(corrections), frequency_in_amplitude(corrections));
    for n in [1, 2, 17, 130, 255, corrections] {
        let products = (0..=n).map(|j| period[j].clone() * frequency[n - j].clone());
        assert!(products.fold(Rational::from(0), |sum, term| sum + term).is_zero(), "n = {n}");
    }
}

#[test]
fn a_longer_series_begins_with_the_shorter_one() {
    assert_eq!(period_in_amplitude(400)[..=150], period_in_amplitude(150)[..]);
    assert_eq!(period_in_amplitude(0), [Rational::from(1)]);
}
