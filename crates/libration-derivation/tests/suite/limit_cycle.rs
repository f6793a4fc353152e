//! Limit cycles are derived, with their known coefficients.

use libration::progress::Quiet;
use libration_derivation::{DerivationError, limit_cycle, to_markdown};

fn page(equation: &str, order: usize) -> Result<String, DerivationError> {
    limit_cycle(&equation.parse().unwrap(), None, order, &Quiet).map(|page| to_markdown(&page))
}

/// Van der Pol's frequency up to the fourth power, and the first harmonic (A. Dadfar, J. Geer, C. Andersen, SIAM J. Appl. Math. 44, 881 (1984)).
#[test]
fn van_der_pols_frequency_has_its_known_coefficients() {
    let page = page("x'' - mu*(1 - x^2)*x' + x = 0", 4).unwrap();
    assert!(page.contains(r"\Omega =1-\frac{1}{16}\mu ^{2}+\frac{17}{3072}\mu ^{4}+O"), "{page}");
    assert!(page.contains(r"A=2+\frac{1}{64}\mu ^{2}+O"));
    assert!(page.contains(r"-A_{0}+\frac{1}{4}A_{0}^{3}=0"), "{page}");
}

#[test]
fn excitations_with_springs_and_even_powers_are_derived() {
    for (equation, frequency) in [
        ("x'' - mu*(x' - x'^3/3) + x = 0", r"\Omega =1-\frac{1}{16}\mu ^{2}"),
        ("x'' + x = e*((1 - x^2)*x' - x^3)", r"\Omega =1+\frac{3}{2}e-\frac{"),
        ("x'' + 4*x = e*(1 - x^2)*x'", r"\Omega =2-\frac{1}{32}e^{2}"),
        ("x'' + x = e*(1 - x^4/2)*x'", r"\Omega =1-"),
    ] {
        let page = page(equation, 3).unwrap();
        assert!(page.contains(frequency), "{page}");
    }
}

#[test]
fn what_is_no_limit_cycle_or_no_fraction_is_refused() {
    assert!(matches!(page("x'' + c*x' + x = 0", 3), Err(DerivationError::Expansion(_))));
    assert!(matches!(page("x'' + c*(x' + x^3) + x = 0", 3), Err(DerivationError::NoExcitation)));
    assert!(matches!(page("x'' + c*(x^2 - 1)*x' + x + x^3 = 0", 3), Err(DerivationError::NoPolynomial)));
    assert!(matches!(
        page("x'' - mu*(1 - x^2)*x' + x = 0", 10),
        Err(DerivationError::CycleOrder { order: 10 })
    ));
    assert!(matches!(page("x'' - mu*(x' - x'^3) + x = 0", 3), Err(DerivationError::NoCycle)));
}
