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
    /// The detuning there, if it is a sum of products.
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

    /// The relation on the backbone.
    pub(super) fn on_ridge(&self, backbone: &Sum) -> Sum {
        self.letters.substituted(self.relation, Column::Detuning, backbone, self.order)
    }

    /// The amplitude at which the backbone meets the curve, where the lowest order there has two powers of A, or three that make a square with them.
    pub(super) fn peak(&self, backbone: &Sum) -> Option<Peak> {
        let letters = self.letters;
        let on_ridge = self.on_ridge(backbone);
        let first = letters.lowest_order(&on_ridge)?;
        let order = self.order - first;
        let leading = letters.of_order(&on_ridge, first);
        let powers = letters.exponents(&leading, Column::Amplitude);
        let (low, root) = match *powers.as_slice() {
            [low, high] => (low, high - low),
            [low, middle, high] if middle - low == high - middle => (low, middle - low),
            [high] if self.is_small_root(&on_ridge, first, high) => (0, high),
            _ => return None,
        };
        let in_power = self.in_power(&on_ridge, low, root)?;
        let leading = letters.of_order(&in_power, first);
        let at = |power: i64| letters.coefficient(&leading, Column::Amplitude, power);
        let steepest = if powers.len() == 3 { at(2) } else { at(1) };
        // Where the relation falls with A, the curve has a smallest amplitude there instead.
        let curvature = letters.coefficient(&letters.of_order(self.relation, 0), Column::Detuning, 2);
        let is_positive = |sum: &Sum| sum.as_single_term().map(|(_, factor)| !factor.is_negative());
        if is_positive(&steepest)? != is_positive(&curvature)? {
            return None;
        }
        if powers.len() == 3 {
            let power = self.square_root([&at(0), &at(1), &steepest]).filter(|_| leading == in_power)?;
            return Some(Peak { detuning: self.at_power(backbone, &power, root, self.order), power, root });
        }
        let power = self.zero(&in_power, first)?;
        Some(Peak { detuning: self.at_power(backbone, &power, root, order), power, root })
    }

    /// The exponent and the value of the power of A at which a relation without σ is zero, if its lowest order has two powers of A.
    pub(super) fn only_amplitude(&self) -> Option<(Sum, i64)> {
        let leading = self.letters.of_order(self.relation, 0);
        let powers = self.letters.exponents(&leading, Column::Amplitude);
        let [low, high] = *powers.as_slice() else { return None };
        let in_power = self.in_power(self.relation, low, high - low)?;
        Some((self.zero(&in_power, 0)?, high - low))
    }

    /// A sum divided by the power `low` of A, with the power `root` of A in the column of A; `None` if others occur.
    fn in_power(&self, sum: &Sum, low: i64, root: i64) -> Option<Sum> {
        let amplitude = self.letters.index(Column::Amplitude);
        if sum.half_powers().any(|(powers, _)| (powers[amplitude] - 2 * low) % (2 * root) != 0) {
            return None;
        }
        Some(self.letters.changed(sum, |powers, factor| {
            powers[amplitude] = (powers[amplitude] - 2 * low) / root;
            factor.clone()
        }))
    }

    /// The zero of a polynomial in the column of A by its linear term of the lowest order, `first`.
    fn zero(&self, polynomial: &Sum, first: i64) -> Option<Sum> {
        let letters = self.letters;
        let slope = letters.coefficient(&letters.of_order(polynomial, first), Column::Amplitude, 1);
        let inverse = letters.inverse(&letters.scaled(&slope, &Rational::from(-1)))?;
        let mut power = letters.zero();
        for _ in 0..=self.order + 1 {
            let left = self.substituted(polynomial, &power, self.order)?;
            let step = letters.product(&left, &inverse, self.order - first);
            if step.is_zero() {
                return Some(power);
            }
            power = letters.add(&power, &step);
        }
        None
    }

    /// Returns `true` if damping, of the lowest order and in the power `high` of A, is balanced by a drive of higher order without A: A is then
    /// small, and the other terms have to be smaller than these two.
    fn is_small_root(&self, on_ridge: &Sum, first: i64, high: i64) -> bool {
        let letters = self.letters;
        let drive = letters.coefficient(on_ridge, Column::Amplitude, 0);
        let Some(order) = letters.lowest_order(&drive).filter(|_| high > 0) else { return false };
        // A^high has the order of the drive over that of the damping.
        let (amplitude, grade) = (letters.index(Column::Amplitude), letters.index(Column::Order));
        let is_smaller =
            |powers: &[i64]| powers[grade] * high + (order - first) * powers[amplitude] > 2 * order * high;
        on_ridge.half_powers().all(|(powers, _)| {
            let is_balance =
                powers[amplitude] == 0 || (powers[amplitude] == 2 * high && powers[grade] == 2 * first);
            is_balance || is_smaller(powers)
        })
    }

    /// The larger root of a quadratic polynomial whose discriminant is the square of one product.
    fn square_root(&self, [constant, linear, square]: [&Sum; 3]) -> Option<Sum> {
        let letters = self.letters;
        let product = letters.scaled(&letters.times(constant, square), &Rational::from(4));
        let discriminant = letters.subtract(&letters.times(linear, linear), &product);
        let width = letters.ring.power(&discriminant, &Rational::new(1, 2)?)?;
        width.as_single_term()?;
        let is_negative = square.as_single_term().is_some_and(|(_, factor)| factor.is_negative());
        let width = letters.scaled(&width, &Rational::from(if is_negative { -1 } else { 1 }));
        let inverse = letters.inverse(&letters.scaled(square, &Rational::from(2)))?;
        Some(letters.times(&letters.subtract(&width, linear), &inverse))
    }

    /// A sum with natural powers of the amplitude's column at a value.
    fn substituted(&self, sum: &Sum, by: &Sum, order: i64) -> Option<Sum> {
        let is_natural =
            self.letters.exponents(sum, Column::Amplitude).first().is_none_or(|&least| least >= 0);
        is_natural.then(|| self.letters.substituted(sum, Column::Amplitude, by, order))
    }

    /// A sum in powers of A at a value of a power of A.
    pub(super) fn at_power(&self, sum: &Sum, power: &Sum, root: i64, order: i64) -> Option<Sum> {
        let amplitude = self.letters.index(Column::Amplitude);
        if sum.half_powers().any(|(powers, _)| powers[amplitude] % (2 * root) != 0) {
            return None;
        }
        let in_power = self.letters.changed(sum, |powers, factor| {
            powers[amplitude] /= root;
            factor.clone()
        });
        self.substituted(&in_power, power, order)
    }

    /// ∂/∂A of the relation, which vanishes where the response curve turns back.
    pub(super) fn folds(&self) -> Option<Sum> {
        let derivative = self.letters.derivative(self.relation, Column::Amplitude);
        let folds = without_common_powers(self.letters, &derivative);
        folds.to_constant().is_none().then_some(folds)
    }

    /// b and δ where the lowest order of the relation is κ·A²·((σ − b·A²)² + δ²) − D.
    pub(super) fn cubic(&self) -> Option<[Sum; 2]> {
        let letters = self.letters;
        let at = |a: i64, sigma: i64| {
            let part = letters.coefficient(self.relation, Column::Amplitude, a);
            letters.coefficient(&part, Column::Detuning, sigma)
        };
        let inverse = letters.inverse(&at(2, 2))?;
        let slope = letters.scaled(&letters.times(&at(4, 1), &inverse), &Rational::new(-1, 2)?);
        let rate = letters.ring.power(&letters.times(&at(2, 0), &inverse), &Rational::new(1, 2)?)?;
        Some([slope, rate])
    }

    /// The amplitude of the drive, and its threshold for folds, as texts, for κ·A²·((σ − b·A²)² + μ²) = D: D = 8·κ·μ³/(3·√3·|b|).
    pub(super) fn critical_drive(&self, drives: &[usize]) -> Option<[String; 2]> {
        let letters = self.letters;
        let relation = self.leading();
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
        // A symbol that other terms have too, such as eps, is not the drive.
        let is_elsewhere = |column: &usize| {
            [&kappa, &slope, &square]
                .iter()
                .any(|sum| sum.half_powers().any(|(powers, _)| powers[*column] != 0))
        };
        let only_drives: Vec<usize> = drives.iter().copied().filter(|column| !is_elsewhere(column)).collect();
        let (amplitude, per_square) = self.drive_amplitude(&drive, &only_drives)?;
        let above = letters.times(&letters.times(&kappa, &rate), &letters.inverse(&per_square)?);
        let above = letters.scaled(&above, &Rational::new(-8, 3)?);
        // Without damping every drive has folds, and without a bend none.
        if slope.is_zero() || square.is_zero() {
            return None;
        }
        Some([amplitude, self.over_slope(&above, &slope)])
    }

    /// The amplitude of a drive in its symbols as text, and the factor of the square of this amplitude.
    fn drive_amplitude(&self, drive: &Sum, symbols: &[usize]) -> Option<(String, Sum)> {
        let letters = self.letters;
        let (first, factor) = drive.half_powers().next()?;
        let factor = factor.clone();
        let mut rest = first.clone();
        symbols.iter().for_each(|&column| rest[column] = 0);
        let rest = letters.ring.term(rest, factor);
        let square = letters.times(drive, &letters.inverse(&rest)?);
        let is_own = |(column, power): (usize, &i64)| *power == 0 || symbols.contains(&column);
        if square.to_constant().is_some()
            || !square.half_powers().all(|(powers, _)| powers.iter().enumerate().all(is_own))
        {
            return None;
        }
        let amplitude = self.root_of_square(&square).map(|root| letters.text(&root));
        Some((amplitude.unwrap_or_else(|| format!("sqrt({})", letters.text(&square))), rest))
    }

    /// The sum with this square; `None` if there is none.
    fn root_of_square(&self, square: &Sum) -> Option<Sum> {
        let letters = self.letters;
        let half = Rational::new(1, 2)?;
        let squares = letters.part(square, |powers| powers.iter().all(|power| power % 4 == 0));
        let mut sum = letters.zero();
        for (powers, factor) in squares.half_powers() {
            let root = letters.ring.power(&letters.ring.term(powers.clone(), factor.clone()), &half)?;
            // The sign is that of the product with the terms before.
            let minus = letters.subtract(&sum, &root);
            let both = letters.add(&sum, &root);
            let missing =
                |sum: &Sum| letters.subtract(square, &letters.times(sum, sum)).half_powers().count();
            sum = if missing(&minus) < missing(&both) { minus } else { both };
        }
        let is_negative = letters.text(&sum).starts_with('-');
        let sum = letters.scaled(&sum, &Rational::from(if is_negative { -1 } else { 1 }));
        letters.subtract(square, &letters.times(&sum, &sum)).is_zero().then_some(sum)
    }

    /// The lowest order, and those of damping and drive where they are higher: the terms without σ in A² and A⁰.
    ///
    /// At the critical drive A² is of the order of the damping divided by the curvature, so that corrections of the backbone
    /// are smaller.
    fn leading(&self) -> Sum {
        let letters = self.letters;
        let [detuning, amplitude] = [Column::Detuning, Column::Amplitude].map(|column| letters.index(column));
        let leading = letters.of_order(self.relation, 0);
        [0, 2].into_iter().fold(leading, |sum, power| {
            let is_level = |powers: &[i64]| powers[detuning] == 0 && powers[amplitude] == 2 * power;
            let level = letters.part(self.relation, is_level);
            match letters.lowest_order(&level) {
                Some(order) if order > 0 => letters.add(&sum, &letters.of_order(&level, order)),
                _ => sum,
            }
        })
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
        let natural = letters.index(Column::Natural);
        let Some((powers, factor)) = slope.as_single_term() else {
            return format!("sqrt(({})/(sqrt(3)*abs({})))", letters.text(above), letters.text(slope));
        };
        let is_positive = |column: usize| self.omega0.half_powers().any(|(powers, _)| powers[column] != 0);
        let mut signed = vec![0; powers.len()];
        for (column, power) in powers.iter().enumerate() {
            if column < natural && *power != 0 && !is_positive(column) {
                signed[column] = *power;
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
