//! Sums of harmonics of the phase φ with real coefficients.

use super::letters::{Column, Letters, Sum};
use libration_numbers::algebra::Rational;
use libration_numbers::internals::algebra::ordered_map;
use std::collections::BTreeMap;

/// Σ cₖ·cos kφ + sₖ·sin kφ.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PhaseSum {
    pub(super) harmonics: BTreeMap<i64, [Sum; 2]>,
}

impl PhaseSum {
    /// The real and the imaginary part of a sum of powers of e^{iφ} in the column of waves.
    pub(super) fn parts(letters: &Letters, sum: &Sum) -> [Self; 2] {
        let mut parts = [BTreeMap::new(), BTreeMap::new()];
        for k in letters.exponents(sum, Column::Wave) {
            let of_wave = letters.coefficient(sum, Column::Wave, k);
            let [real, imaginary] = real_and_imaginary(letters, &of_wave);
            let sign = Rational::from(k.signum());
            let turned = |a: &Sum, factor: &Rational| letters.scaled(a, factor);
            let opposite = Rational::from(-k.signum());
            let add = |part: &mut BTreeMap<i64, [Sum; 2]>, cosine: Sum, sine: Sum| {
                let pair = part.entry(k.abs()).or_insert_with(|| [letters.zero(), letters.zero()]);
                pair[0] = letters.add(&pair[0], &cosine);
                pair[1] = letters.add(&pair[1], &sine);
            };
            add(&mut parts[0], real.clone(), turned(&imaginary, &opposite));
            add(&mut parts[1], imaginary, turned(&real, &sign));
        }
        parts.map(|mut harmonics| {
            harmonics.retain(|_, [cosine, sine]| !cosine.is_zero() || !sine.is_zero());
            Self { harmonics }
        })
    }

    /// The first sum with the second as imaginary part, in powers of e^{iφ}.
    pub(super) fn joined(letters: &Letters, parts: &[Self; 2]) -> Sum {
        let mut sum = letters.zero();
        let half = Rational::new(1, 2).unwrap_or_else(|| Rational::from(0));
        for (power, part) in [0, 1].into_iter().zip(parts) {
            let unit = letters.scaled(&letters.power(Column::Imaginary, power), &half);
            for (&k, [cosine, sine]) in &part.harmonics {
                // c·cos kφ + s·sin kφ is (c − is)/2·e^{ikφ} with its conjugate.
                let turned = letters.times(sine, &letters.power(Column::Imaginary, 1));
                let forward =
                    letters.times(&letters.subtract(cosine, &turned), &letters.power(Column::Wave, k));
                let backward = letters.times(&letters.add(cosine, &turned), &letters.power(Column::Wave, -k));
                sum = letters.add(&sum, &letters.times(&letters.add(&forward, &backward), &unit));
            }
        }
        sum
    }

    /// The sum with each coefficient times the same.
    pub(super) fn times(&self, letters: &Letters, factor: &Sum) -> Self {
        let each = self
            .harmonics
            .iter()
            .map(|(&k, parts)| (k, parts.each_ref().map(|part| letters.times(part, factor))));
        Self { harmonics: ordered_map(each) }
    }

    /// The formula; `angle` writes the argument of a harmonic.
    pub(super) fn text(&self, letters: &Letters, angle: impl Fn(i64) -> String) -> String {
        let mut text = String::new();
        for (&k, [cosine, sine]) in &self.harmonics {
            if k == 0 {
                append(&mut text, &letters.text(cosine), None);
                continue;
            }
            for (name, coefficient) in [("cos", cosine), ("sin", sine)] {
                append(&mut text, &letters.text(coefficient), Some(format!("{name}({})", angle(k))));
            }
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    /// The sum as a polynomial in cos mφ and sin mφ, where all harmonics are multiples of m.
    pub(super) fn in_cosine_and_sine(&self, letters: &Letters, m: i64) -> Sum {
        let imaginary = letters.power(Column::Imaginary, 1);
        let wave = letters.times(&imaginary, &letters.power(Column::Sine, 1));
        let wave = letters.add(&letters.power(Column::Cosine, 1), &wave);
        let mut sum = letters.zero();
        for (k, [cosine, sine]) in &self.harmonics {
            let power = letters.raised(&wave, usize::try_from(k / m).unwrap_or(0), 0);
            for (part, coefficient) in [cosine, sine].into_iter().enumerate() {
                let part = i64::try_from(part).unwrap_or(0);
                let part = letters.coefficient(&power, Column::Imaginary, part);
                sum = letters.add(&sum, &letters.times(&part, coefficient));
            }
        }
        sum
    }
}

/// The parts without and with i.
pub(super) fn real_and_imaginary(letters: &Letters, sum: &Sum) -> [Sum; 2] {
    [0, 1].map(|power| letters.coefficient(sum, Column::Imaginary, power))
}

/// Appends a coefficient and its factor.
pub(super) fn append(text: &mut String, coefficient: &str, function: Option<String>) {
    if coefficient == "0" {
        return;
    }
    let is_single = !coefficient.contains(' ');
    let term = match function {
        None => coefficient.to_owned(),
        Some(function) => match coefficient {
            "1" => function,
            "-1" => format!("-{function}"),
            _ if is_single => format!("{coefficient}*{function}"),
            _ => format!("({coefficient})*{function}"),
        },
    };
    append_term(text, &term);
}

/// Appends a term that may have a sign, or be empty.
pub(super) fn append_term(text: &mut String, term: &str) {
    if term.is_empty() {
        return;
    }
    let joined = match (text.is_empty(), term.strip_prefix('-')) {
        (true, _) => term.to_owned(),
        (false, Some(size)) => format!(" - {size}"),
        (false, None) => format!(" + {term}"),
    };
    text.push_str(&joined);
}
