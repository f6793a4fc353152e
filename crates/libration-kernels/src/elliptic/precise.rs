//! sn, cn and dn in two words, for tables that are prepared once.

use super::{Expansion, Modulus, ThetaZero};
use crate::double_double::DoubleDouble;
use crate::elementary::two_word;

/// The quotients of a modulus in two words.
#[derive(Clone, Copy, Debug)]
pub struct PreciseQuotients {
    expansion: Expansion,
    /// z of the theta functions for one turn of 4K.
    scale: DoubleDouble,
    q: DoubleDouble,
    /// Factors of sn, cn, dn: first next to an even quarter, then next to an odd one.
    factors: [[DoubleDouble; 3]; 2],
}

/// sn, cn and dn in two words.
#[derive(Clone, Copy, Debug)]
pub struct PreciseJacobi {
    pub sn: DoubleDouble,
    pub cn: DoubleDouble,
    pub dn: DoubleDouble,
}

impl PreciseQuotients {
    pub fn new(modulus: &Modulus) -> Self {
        let root = modulus.root_of_smaller_nome();
        let q = root.square();
        let ThetaZero { second, third, fourth } = ThetaZero::in_two_words(q);
        let expansion = modulus.expansion();
        let factors = match expansion {
            Expansion::Circular => [[third / second, fourth / second, fourth / third]; 2],
            Expansion::Hyperbolic => {
                let (sn, cn, dn) = (third / fourth, second / fourth, second / third);
                let small = root.scaled(4.0);
                [[sn, cn, dn], [sn, small * cn, small * dn]]
            }
        };
        Self { expansion, scale: modulus.turn_scale(), q, factors }
    }

    /// The functions at a number of turns of 4K, with relative errors of about 2⁻⁶⁰; |turns| ≤ 1.
    pub fn at(&self, turns: f64) -> PreciseJacobi {
        let quarter = (4.0 * turns).round_ties_even();
        let rest = turns - 0.25 * quarter;
        let odd = quarter.rem_euclid(2.0) > 0.5;
        let sign = if quarter.rem_euclid(4.0) < 2.0 { 1.0 } else { -1.0 };
        let [first, second, third, fourth] = self.theta(rest);
        let (beside, other) = match self.expansion {
            Expansion::Circular => (second, fourth),
            Expansion::Hyperbolic => (fourth, second),
        };
        let [sn, cn, dn] = self.factors[usize::from(odd)];
        // The table at `Quotients::copolar`, with (beside, other) for (b, d) or (d, b).
        let (above, below) =
            if odd { ([beside, -first, other], third) } else { ([first, beside, third], other) };
        PreciseJacobi {
            sn: (sn * above[0] / below).scaled(sign),
            cn: (cn * above[1] / below).scaled(sign),
            dn: dn * above[2] / below,
        }
    }

    /// θ₁ … θ₄ as in `ThetaSeries`, with one more term.
    fn theta(&self, rest: f64) -> [DoubleDouble; 4] {
        let q = self.q;
        let (sine, cosine, change) = match self.expansion {
            Expansion::Circular => {
                let (sine, cosine) = two_word::sin_cos(self.scale * rest);
                (sine, cosine, sine.square().scaled(-4.0))
            }
            Expansion::Hyperbolic => {
                let power = two_word::exp(self.scale * rest);
                let (sinh, cosh) = (power - power.recip(), power + power.recip());
                (sinh.scaled(0.5), cosh.scaled(0.5), sinh.square())
            }
        };
        let y = q * (change + 2.0);
        let (q2, y2) = (q.square(), y.square());
        let (q4, qy) = (q2.square(), q * y);
        let q9 = q4.square() * q;
        let common = DoubleDouble::ONE - q2 + q4 * (y2 - q2);
        let odd = qy - q4 * qy;
        let cube = y2 * y - q2 * y * 2.0;
        let square = (y2 - q2) * q;
        let even = DoubleDouble::ONE + q2 * (y2 - q2.scaled(2.0)) + q4 * q4 * q4 * y2.square();
        let slope = y + q4 * q2 * (y2 * y - q2 * y * 3.0);
        [
            sine * (common - odd - q9 * (cube + square)),
            cosine * (common + odd + q9 * (cube - square)),
            even + slope,
            even - slope,
        ]
    }
}
