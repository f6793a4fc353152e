//! Expansions with named constants, compared with decimal ones and with published coefficients.

use crate::typed::{equation, oscillator};
use libration::expression::Expression;
use libration::oscillator::SymbolicOscillator;
use libration::perturbation::{
    Certificate, Expansion, Gauge, SymbolicExpansion, expand, expand_symbolically, expand_with_constants,
};
use libration::progress::Quiet;

fn named(text: &str, order: usize) -> Option<SymbolicExpansion> {
    expand_with_constants(&oscillator(text), order, &Gauge::Fundamental, &Quiet).unwrap()
}

fn constants(of: &SymbolicExpansion) -> Vec<(&str, String)> {
    of.constants.iter().map(|(name, formula)| (name.as_str(), formula.to_string())).collect()
}

fn all<C: Clone>(of: &Expansion<C>) -> Vec<C> {
    let harmonics = of.harmonics.iter().flat_map(|harmonic| harmonic.cos.iter().chain(&harmonic.sin));
    of.frequency_ratio.iter().chain(harmonics).chain(&of.x_max).chain(&of.x_min).cloned().collect()
}

/// Duffing's 1 + 3bA²/(8k) − 21b²A⁴/(256k²) (Nayfeh and Mook, section 2.3), with irrational stiffness; x″ + w²x + xx′ = 0 has the second
/// sine 1/(6w), of which w = √2 makes √2/12.
#[test]
fn roots_and_pi_stay_exact() {
    let duffing = named("x'' + sqrt(2)*x + x^3 = 0", 5).unwrap();
    let by_amplitude = duffing.series.of_amplitude.as_ref().unwrap();
    assert_eq!(by_amplitude.frequency_ratio[4].to_string(), "-21/(256*c1^2)");
    assert_eq!(constants(&duffing), [("c1", "sqrt(2)".to_owned())]);
    let mirrored = named("x'' + 2*x + x*x' = 0", 4).unwrap();
    assert_eq!(mirrored.series.harmonic(2).unwrap().sin[2].to_string(), "omega0/12");
    assert_eq!(constants(&mirrored), [("omega0", "sqrt(2)".to_owned())]);
    assert_eq!(mirrored.series.certificate, Certificate::Digits);
    let two_sided = named("x'' + x + x*abs(x) = 0", 2).unwrap();
    assert_eq!(two_sided.series.frequency_ratio[1].to_string(), "4/(3*pi)");
    assert_eq!(constants(&two_sided), [("pi", "pi".to_owned())]);
}

#[test]
fn with_the_values_of_the_constants_they_are_those_in_digits() {
    for text in [
        "x'' + sqrt(2)*x + x^3 = 0",
        "x'' + 2*x + x*x' = 0",
        "x'' + 3*x/2 + x*x' - x^3 = 0",
        "x'' + pi^2*x + exp(1)*x^2 = 0",
        "x'' + sqrt(3)*sin(x) + sqrt(2)*x*x' = 0",
        "x'' + 2*x + x*abs(x) = 0",
    ] {
        let exact = named(text, 6).unwrap_or_else(|| panic!("{text}"));
        let digits = expand(&oscillator(text), 6, &Gauge::Fundamental, &Quiet).unwrap();
        let (exact_coefficients, in_digits) = (all(&exact.series), all(&digits));
        assert_eq!(exact_coefficients.len(), in_digits.len(), "{text}");
        for (coefficient, digits) in exact_coefficients.iter().zip(&in_digits) {
            let formula: Expression = coefficient.to_string().parse().unwrap();
            let put = |formula: Expression, (name, value): &(String, Expression)| {
                formula.substitute(&libration::expression::Symbol::plain(name), value)
            };
            let value = exact.constants.iter().fold(formula, put).to_f64().unwrap();
            let gap = (value - digits.to_f64()).abs();
            // Terms of some tens cancel where powers of π have opposite signs.
            assert!(gap < 1e-13 * digits.to_f64().abs().max(1.0), "{text}: {coefficient} is off by {gap:e}");
        }
    }
}

#[test]
fn fractions_and_long_sums_have_no_names() {
    assert_eq!(named("x'' + 2*x + x^3 = 0", 5), None);
    assert_eq!(named("x'' + sqrt(2)*x + x^3 = 0", 16), None);
    let many = "x'' + sqrt(2)*x + sqrt(3)*x^3 + sqrt(5)*x^5 + sqrt(7)*x^7 = 0";
    assert_eq!(named(many, 3), None);
    assert_eq!(named("x'' + sin(x) - cos(x) = 0", 3), None);
}

/// With symbols ω0 = √2 is to the first power at most, under its name; there is no fraction for it, so no check modulo primes, which would not
/// end.
#[test]
fn an_irrational_frequency_has_a_name_among_symbols() {
    let text = "x'' + 2*x + a*b*x*x' = 0";
    let oscillator = SymbolicOscillator::new(&equation(text)).unwrap();
    let expansion = expand_symbolically(&oscillator, 4, &Gauge::Fundamental, &Quiet).unwrap();
    assert_eq!(constants(&expansion), [("omega0", "sqrt(2)".to_owned())]);
    let second = &expansion.series.harmonic(2).unwrap().sin;
    assert_eq!(second[2].to_string(), "a*b*omega0/12");
    // ω0³ is 2·ω0: a³b³ω0³/6912.
    assert_eq!(second[4].to_string(), "a^3*b^3*omega0/3456");
    assert_eq!(expansion.series.certificate, Certificate::Unchecked);
}
