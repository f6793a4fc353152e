//! The slow flow as first-order equations for the real and imaginary parts of the amplitudes.

use super::form::{NormalForm, SlowTerm};
use super::polynomials::{AmplitudePolynomials, Powers};
use libration_numbers::expression::{Equation, Expression, Order};
use libration_numbers::{
    algebra::{Complex, Doubles, Ring},
    internals::algebra::{Quadratic, QuadraticField},
};

impl NormalForm {
    /// aⱼ′ at these amplitudes.
    #[must_use]
    pub fn rates(&self, amplitudes: &[Complex]) -> Vec<Complex> {
        let turning = self.modes.modes.iter().zip(amplitudes);
        let mut rates: Vec<Complex> =
            turning.map(|(mode, a)| *a * Complex::new(0.0, mode.frequency())).collect();
        for term in &self.slow_terms {
            let powers = term.powers.iter().zip(&term.conjugate_powers).zip(amplitudes);
            let product = powers.fold(term.coefficient, |product, ((p, q), a)| {
                product * a.powi(u32::from(*p)) * Complex::new(a.re, -a.im).powi(u32::from(*q))
            });
            rates[term.mode] = rates[term.mode] + product;
        }
        rates
    }

    /// The slow flow in u1, w1, u2, w2, …, with aⱼ = uⱼ + iwⱼ, for integration like other
    /// equations. For a high order it has more terms than the parser accepts as text.
    #[must_use]
    pub fn slow_flow(&self) -> Equation {
        let modes = || (1..).zip(&self.modes.modes);
        let mut terms: Vec<[Vec<String>; 2]> = modes()
            .map(|(j, mode)| (j, mode.frequency()))
            .map(|(j, frequency)| [vec![format!("-{frequency:?}*w{j}")], vec![format!("{frequency:?}*u{j}")]])
            .collect();
        for term in &self.slow_terms {
            for (powers, value) in self.in_parts(term) {
                let product = product(&powers);
                let [real, imaginary] = &mut terms[term.mode];
                for (terms, factor) in [(real, value.re), (imaginary, value.im)] {
                    if factor != 0.0 {
                        terms.push(format!("({factor:?}){product}"));
                    }
                }
            }
        }
        let variables: Vec<String> = modes().flat_map(|(j, _)| [format!("u{j}"), format!("w{j}")]).collect();
        let orders = vec![Order::First; variables.len()];
        Equation::of_derivatives(
            variables,
            orders,
            terms.as_flattened().iter().map(|parts| sum(parts)).collect(),
        )
    }
}

/// Sums of at most a hundred terms: a tree of all terms in a row would be as deep as their number.
fn sum(terms: &[String]) -> Expression {
    const TOGETHER: usize = 100;
    let parts = terms.chunks(TOGETHER).map(|terms| {
        terms
            .join(" + ")
            .parse::<Expression>()
            .expect("a hundred products are a formula of a few thousand letters")
    });
    parts.reduce(|a, b| Expression::Add(Box::new(a), Box::new(b))).unwrap_or_else(|| Expression::from(0))
}

impl NormalForm {
    /// A slow term as a sum of products of real and imaginary parts.
    fn in_parts(&self, term: &SlowTerm) -> Vec<(Powers, Complex)> {
        let n = self.modes.modes.len();
        let numbers = QuadraticField { base: Doubles, square: -1.0 };
        let ring = AmplitudePolynomials { numbers, generators: 2 * n };
        let element = |re: f64, im: f64| Quadratic { plain: re, root: im };
        let part = |j: usize, sign: f64| {
            ring.add(&ring.generator(j, element(1.0, 0.0)), &ring.generator(n + j, element(0.0, sign)))
        };
        let mut product = ring.constant(element(term.coefficient.re, term.coefficient.im));
        for j in 0..n {
            for (power, sign) in [(term.powers[j], 1.0), (term.conjugate_powers[j], -1.0)] {
                for _ in 0..power {
                    product = ring.multiply(&product, &part(j, sign));
                }
            }
        }
        product.into_iter().map(|(powers, z)| (powers, Complex::new(z.plain, z.root))).collect()
    }
}

/// A product such as `*u1^2*w2`.
fn product(powers: &[u8]) -> String {
    let n = powers.len() / 2;
    let name = |k: usize| if k < n { format!("u{}", k + 1) } else { format!("w{}", k - n + 1) };
    let factors = powers.iter().enumerate().filter(|(_, power)| **power > 0);
    factors.map(|(k, power)| format!("*{}^{power}", name(k))).collect()
}
