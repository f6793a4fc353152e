//! Slow flows with symbols, step by step.

use libration::perturbation::SymbolicSlowFlowOptions;
use libration::progress::Quiet;
use libration_derivation::{Derivation, DerivationError, slow_flow, to_markdown};

fn derived(
    text: &str,
    resonance: Option<(u32, u32)>,
    small: &[(&str, usize)],
) -> Result<Derivation, DerivationError> {
    let small = small.iter().map(|(name, order)| ((*name).to_owned(), *order)).collect();
    let options = SymbolicSlowFlowOptions { resonance, small, ..SymbolicSlowFlowOptions::default() };
    slow_flow(&text.parse().unwrap(), &options, &Quiet)
}

#[test]
fn try_all() {
    let all: &[(&str, Option<(u32, u32)>, &[(&str, usize)])] = &[
        ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)", Some((1, 1)), &[]),
        ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = F*cos(W*t)", Some((1, 3)), &[]),
        ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = F*cos(W*t)", Some((3, 1)), &[]),
        ("x'' + 2*eps*mu*x' + w0^2*x + eps*h*x*cos(W*t) + eps*a*x^3 = 0", Some((2, 1)), &[]),
        ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = 0", None, &[]),
        ("x'' + x = eps*(m*(1 - x^2)*x' - b*x^3)", None, &[]),
        ("x'' + eps*c*x'*abs(x') + w^2*x = 0", None, &[]),
        ("x'' + eps*R*sign(x') + w0^2*x = eps*F*cos(W*t)", Some((1, 1)), &[]),
        ("x'' - eps*m*(1 - x^2)*x' + w0^2*x = eps*F*cos(W*t)", Some((1, 1)), &[]),
        ("x'' + c*x' + sin(x) = F*cos(W*t)", Some((1, 1)), &[("c", 2), ("F", 2)]),
        ("m*x'' + c*x' + k*x + b*x^3 = F*cos(W*t)", Some((1, 1)), &[("c", 1), ("b", 1), ("F", 1)]),
    ];
    for (place, (text, resonance, small)) in all.iter().enumerate() {
        match derived(text, *resonance, small) {
            Ok(it) => std::fs::write(format!("/tmp/derive-{place}.md"), to_markdown(&it)).unwrap(),
            Err(error) => panic!("{text}: {error}"),
        }
    }
}
