//! The slow flow as equations of the first order in the real and imaginary parts of the amplitudes.

use super::form::{NormalForm, SlowTerm};
use super::polynomials::{AmplitudePolynomials, Powers};
use crate::algebra::{Complex, Doubles, Quadratic, QuadraticField, Ring};
use crate::expression::Equation;

impl NormalForm {
    /// aⱼ′, of these amplitudes.
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

    /// The slow flow in u1, w1, u2, w2, …, with aⱼ = uⱼ + iwⱼ, to be integrated as any other equations.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn slow_flow(&self) -> Equation {
        let mut parts: Vec<[String; 2]> = self
            .modes
            .modes
            .iter()
            .enumerate()
            .map(|(j, mode)| {
                let frequency = mode.frequency();
                [format!("-{frequency:?}*w{}", j + 1), format!("{frequency:?}*u{}", j + 1)]
            })
            .collect();
        for term in &self.slow_terms {
            for (powers, value) in self.in_parts(term) {
                let product = product(&powers);
                let [real, imaginary] = &mut parts[term.mode];
                for (text, factor) in [(real, value.re), (imaginary, value.im)] {
                    if factor != 0.0 {
                        text.push_str(&format!(" + ({factor:?}){product}"));
                    }
                }
            }
        }
        let lines = parts.iter().enumerate().flat_map(|(j, [real, imaginary])| {
            [format!("u{}' = {real}", j + 1), format!("w{}' = {imaginary}", j + 1)]
        });
        let text = lines.collect::<Vec<_>>().join("; ");
        text.parse().expect("the text is made of sums of products")
    }
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

/// `*u1^2*w2`.
fn product(powers: &[u8]) -> String {
    let n = powers.len() / 2;
    let name = |k: usize| if k < n { format!("u{}", k + 1) } else { format!("w{}", k - n + 1) };
    let factors = powers.iter().enumerate().filter(|(_, power)| **power > 0);
    factors.map(|(k, power)| format!("*{}^{power}", name(k))).collect()
}
