use libration::algebra::{Rational, Rationals, Ring};
use libration::internals::algebra::univariate::square_free_factors;

fn polynomial(coefficients: &[i64]) -> Vec<Rational> {
    coefficients.iter().copied().map(Rational::from).collect()
}

#[test]
fn factors_are_found_with_their_multiplicity() {
    // (x − 1)³(x² + 2)²(x + 5), formed from its factors.
    let factors = [(vec![-1, 1], 3), (vec![2, 0, 1], 2), (vec![5, 1], 1)];
    let product = factors.iter().fold(polynomial(&[1]), |product, (factor, times)| {
        (0..*times).fold(product, |product, _| {
            let factor = polynomial(factor);
            let length = product.len() + factor.len() - 1;
            Rationals.series_product(&product, &factor, length)
        })
    });
    let mut computed = square_free_factors(&product);
    computed.sort_by_key(|(_, times)| std::cmp::Reverse(*times));
    let expected: Vec<_> = factors.iter().map(|(factor, times)| (polynomial(factor), *times)).collect();
    assert_eq!(computed, expected);
    assert!(square_free_factors(&polynomial(&[3])).is_empty());
}
