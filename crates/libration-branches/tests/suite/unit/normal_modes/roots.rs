use libration::algebra::Rational;
use libration::internals::normal_modes::{Root, roots};

fn written_roots(coefficients: &[i64]) -> Vec<String> {
    let polynomial: Vec<Rational> = coefficients.iter().copied().map(Rational::from).collect();
    let mut texts: Vec<String> = roots(&polynomial, &[])
        .unwrap()
        .iter()
        .map(|(root, times)| match root {
            Root::Exact(surd) => format!("{surd} ×{times}"),
            Root::Number(_) => format!("digits ×{times}"),
        })
        .collect();
    texts.sort();
    texts
}

#[test]
fn roots_are_exact_where_square_roots_suffice() {
    assert_eq!(written_roots(&[2, -4, 1]), ["2 + sqrt(2) ×1", "2 - sqrt(2) ×1"]);
    // (2x − 1)²(x² − 3).
    assert_eq!(written_roots(&[-3, 12, -11, -4, 4]), ["-sqrt(3) ×1", "1/2 ×2", "sqrt(3) ×1"]);
    // The chain of four masses: x⁴ − 8x³ + 21x² − 20x + 5 = (x² − 3x + 1)(x² − 5x + 5).
    let chain =
        ["3/2 + 1/2*sqrt(5) ×1", "3/2 - 1/2*sqrt(5) ×1", "5/2 + 1/2*sqrt(5) ×1", "5/2 - 1/2*sqrt(5) ×1"];
    assert_eq!(written_roots(&[5, -20, 21, -8, 1]), chain);
    assert_eq!(written_roots(&[-2, 0, 0, 1]), ["digits ×1"; 3]);
    assert_eq!(written_roots(&[0, 0, 1]), ["0 ×2"]);
}
