//! Backbone, peak, folds and critical drive of a response curve, from the relation between amplitude and detuning.

use super::letters::{Column, Letters, Sum};
use super::steady::without_common_powers;
use libration_numbers::algebra::{Rational, Ring};

/// A relation in A and σ, to an order relative to its lowest.
pub(super) struct ResponseCurve<'a> {
    pub(super) letters: &'a Letters,
    pub(super) relation: &'a Sum,
    pub(super) order: i64,
    /// ω0, whose symbols are positive.
    pub(super) omega0: &'a Sum,
}

/// The largest amplitude of a response curve: a root of order `root` of `power`.
pub(super) struct Peak {
    pub(super) power: Sum,
    pub(super) root: i64,
    /// The detuning there, where it is a sum of products.
    pub(super) detuning: Option<Sum>,
}

impl ResponseCurve<'_> {
    /// σ of the largest A as a function of A: the σ for which ∂/∂σ of the relation vanishes, where the relation is of the second degree in σ.
    pub(super) fn backbone(&self) -> Option<Sum> {
        let letters = self.letters;
        let leading = letters.of_order(self.relation, 0);
        if letters.exponents(&leading, Column::Detuning).last() != Some(&2) {
            return None;
        }
        let curvature = letters.coefficient(&leading, Column::Detuning, 2);
        let inverse = letters.inverse(&letters.scaled(&curvature, &Rational::from(-2)))?;
        let slope = letters.derivative(self.relation, Column::Detuning);
        let mut detuning = letters.zero();
        for _ in 0..=self.order + 1 {
            let left = letters.substituted(&slope, Column::Detuning, &detuning, self.order);
            let step = letters.product(&left, &inverse, self.order);
            if step.is_zero() {
                return Some(detuning);
            }
            detuning = letters.add(&detuning, &step);
        }
        None
    }

    /// The amplitude at which the backbone meets the curve, where the lowest order has two powers of A.
    pub(super) fn peak(&self, backbone: &Sum) -> Option<Peak> {
        let letters = self.letters;
        let on_ridge = letters.substituted(self.relation, Column::Detuning, backbone, self.order);
        let leading = letters.of_order(&on_ridge, 0);
        let &[low, high] = letters.exponents(&leading, Column::Amplitude).as_slice() else { return None };
        let root = high - low;
        let place = letters.place(Column::Amplitude);
        if on_ridge.half_powers().any(|(powers, _)| (powers[place] - 2 * low) % (2 * root) != 0) {
            return None;
        }
        // The amplitude's column now holds the power of A.
        let in_power = letters.changed(&on_ridge, |powers, factor| {
            powers[place] = (powers[place] - 2 * low) / root;
            factor.clone()
        });
        let slope = letters.coefficient(&letters.of_order(&in_power, 0), Column::Amplitude, 1);
        // Where the relation falls with A, the curve has a smallest amplitude there instead.
        let curvature = letters.coefficient(&letters.of_order(self.relation, 0), Column::Detuning, 2);
        let is_positive = |sum: &Sum| sum.as_single_term().map(|(_, factor)| !factor.is_negative());
        if is_positive(&slope)? != is_positive(&curvature)? {
            return None;
        }
        let inverse = letters.inverse(&letters.scaled(&slope, &Rational::from(-1)))?;
        let mut power = letters.zero();
        for _ in 0..=self.order + 1 {
            let left = self.substituted(&in_power, &power)?;
            let step = letters.product(&left, &inverse, self.order);
            if step.is_zero() {
                let detuning = self.at_power(backbone, &power, root);
                return Some(Peak { power, root, detuning });
            }
            power = letters.add(&power, &step);
        }
        None
    }

    /// A sum with natural powers of the amplitude's column at a value.
    fn substituted(&self, sum: &Sum, by: &Sum) -> Option<Sum> {
        let is_natural =
            self.letters.exponents(sum, Column::Amplitude).first().is_none_or(|&least| least >= 0);
        is_natural.then(|| self.letters.substituted(sum, Column::Amplitude, by, self.order))
    }

    /// A sum in powers of A at a value of a power of A.
    fn at_power(&self, sum: &Sum, power: &Sum, root: i64) -> Option<Sum> {
        let place = self.letters.place(Column::Amplitude);
        if sum.half_powers().any(|(powers, _)| powers[place] % (2 * root) != 0) {
            return None;
        }
        let in_power = self.letters.changed(sum, |powers, factor| {
            powers[place] /= root;
            factor.clone()
        });
        self.substituted(&in_power, power)
    }

    /// ∂/∂A of the relation, which vanishes where the response curve turns back.
    pub(super) fn folds(&self) -> Option<Sum> {
        let derivative = self.letters.derivative(self.relation, Column::Amplitude);
        let folds = without_common_powers(self.letters, &derivative);
        folds.to_constant().is_none().then_some(folds)
    }

    /// The drive at which the folds appear, as text, for κ·A²·((σ − b·A²)² + μ²) = D: D = 8·κ·μ³/(3·√3·|b|).
    pub(super) fn critical_drive(&self, drives: &[usize]) -> Option<String> {
        let letters = self.letters;
        let relation = letters.of_order(self.relation, 0);
        let at = |a: i64, sigma: i64| {
            let part = letters.coefficient(&relation, Column::Amplitude, a);
            letters.coefficient(&part, Column::Detuning, sigma)
        };
        let [kappa, damping, bent, drive] = [at(2, 2), at(2, 0), at(4, 1), at(0, 0)];
        let inverse = letters.inverse(&kappa)?;
        let slope = letters.scaled(&letters.times(&bent, &inverse), &Rational::new(-1, 2)?);
        let square = letters.times(&damping, &inverse);
        self.check_cubic(&relation, [&kappa, &slope, &square, &drive])?;
        let rate = letters.ring.power(&square, &Rational::new(3, 2)?)?;
        let place = drives
            .iter()
            .copied()
            .find(|&place| drive.as_single_term().is_some_and(|(powers, _)| powers[place] == 4))?;
        let per_square = letters.times(&drive, &letters.power_at(place, -2));
        let above = letters.times(&letters.times(&kappa, &rate), &letters.inverse(&per_square)?);
        let above = letters.scaled(&above, &Rational::new(-8, 3)?);
        // Without damping every drive has folds, and without a bend none.
        if slope.is_zero() || square.is_zero() {
            return None;
        }
        Some(self.over_slope(&above, &slope))
    }

    /// Checks that the relation is κ·A²·((σ − b·A²)² + μ²) − D.
    fn check_cubic(&self, relation: &Sum, [kappa, slope, square, drive]: [&Sum; 4]) -> Option<()> {
        let letters = self.letters;
        let ridge = letters.times(slope, &letters.power(Column::Amplitude, 2));
        let distance = letters.subtract(&letters.power(Column::Detuning, 1), &ridge);
        let width = letters.add(&letters.times(&distance, &distance), square);
        let energy = letters.times(kappa, &letters.power(Column::Amplitude, 2));
        let expected = letters.add(&letters.times(&energy, &width), drive);
        letters.subtract(relation, &expected).is_zero().then_some(())
    }

    /// √(above/(√3·|slope|)), positive factors of the slope taken out.
    fn over_slope(&self, above: &Sum, slope: &Sum) -> String {
        let letters = self.letters;
        let natural = letters.place(Column::Natural);
        let Some((powers, factor)) = slope.as_single_term() else {
            return format!("sqrt(({})/(sqrt(3)*abs({})))", letters.text(above), letters.text(slope));
        };
        let is_positive = |place: usize| self.omega0.half_powers().any(|(powers, _)| powers[place] != 0);
        let mut signed = vec![0; powers.len()];
        for (place, power) in powers.iter().enumerate() {
            if place < natural && *power > 0 && !is_positive(place) {
                signed[place] = *power;
            }
        }
        let signed = letters.ring.term(signed.into(), Rational::from(1));
        let positive = letters.scaled(slope, &Rational::from(if factor.is_negative() { -1 } else { 1 }));
        let quotient = letters.inverse(&signed).map(|inverse| letters.times(&positive, &inverse));
        let rest = quotient.and_then(|positive| letters.inverse(&positive));
        match rest {
            Some(inverse) => {
                let above = letters.times(above, &inverse);
                let size =
                    if signed.to_constant().is_some() { String::new() } else { format!("*abs({signed})") };
                format!("sqrt(({})/(sqrt(3){size}))", letters.text(&above))
            }
            _ => format!("sqrt(({})/(sqrt(3)*abs({})))", letters.text(above), letters.text(slope)),
        }
    }
}
