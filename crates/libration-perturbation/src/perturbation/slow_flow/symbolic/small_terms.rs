//! Small terms of an equation of motion as formulas, along the motion.

use super::force::DriveFrequency;
use super::letters::{Column, Sum};
use super::phase_sums::{PhaseSum, append, append_term, real_and_imaginary};
use super::result::{angle, polar, rates};
use super::scales::{Forced, SmallForceTerm, Solved};
use super::setting::Setting;
use libration_numbers::algebra::Rational;
use libration_numbers::internals::algebra::InOrder;
use std::ops::RangeInclusive;

/// A small term of the equation of motion.
#[derive(Clone, Debug, PartialEq)]
pub struct SmallTerm {
    /// The term in displacement and velocity, in W·t and with (p/q)·(ψ − φ) in its place.
    pub force: [String; 2],
    /// The term as a sum of waves; `None` with abs or sign, whose harmonics do not end.
    pub waves: Option<String>,
    /// Waves of the drive whose frequency is that of ψ; empty if there are none.
    pub turning: String,
    /// Factors of cos ψ and sin ψ in the resonant part.
    pub resonant: [String; 2],
    /// The same of the waves of the drive alone.
    pub turned: [String; 2],
}

/// Formulas in the names of an equation.
#[derive(Clone, Copy)]
pub(super) struct Written<'a> {
    pub(super) setting: &'a Setting,
    pub(super) forced: &'a Forced<'a>,
    pub(super) variable: &'a str,
    /// `true` for (p/q)·(ψ − φ) in place of W·t.
    pub(super) is_at_phase: bool,
}

impl Written<'_> {
    /// The small terms of these orders along the motion of order zero.
    pub(super) fn terms(&self, solved: &Solved, orders: RangeInclusive<i64>) -> Vec<SmallTerm> {
        let of_term = |term: &SmallForceTerm| {
            let value = self.forced.along(&solved.displacements[0], term);
            let force = |written: &Self| written.product(&term.coefficient, term.powers[0], term.signs, None);
            self.term(&force, &value, !term.is_kinked())
        };
        self.forced.terms[0].iter().filter(|term| orders.contains(&term.order)).map(of_term).collect()
    }

    /// A force whose values along the motion are known, of a force with kinks only those of the first harmonic.
    pub(super) fn term(&self, force: &dyn Fn(&Self) -> String, value: &Sum, is_known: bool) -> SmallTerm {
        let (forced, letters) = (self.forced, self.forced.letters);
        let text = |sum: &PhaseSum| sum.text(letters, |k| multiple(k, self.phase()));
        let minus = letters.number(Rational::from(-1));
        let factors = |waves: &Sum| {
            let coefficient = letters.coefficient(waves, Column::Wave, forced.harmonics[0]);
            let [real, imaginary] = rates(letters, &coefficient);
            [text(&real), text(&imaginary.times(letters, &minus))]
        };
        let resonant = letters.part(value, |powers| self.is_resonant(powers));
        let is_turning = |powers: &[i64]| self.wave_numbers(powers)[1] != 0;
        let turning = letters.part(&resonant, is_turning);
        SmallTerm {
            force: [false, true].map(|is_at_phase| force(&Self { is_at_phase, ..*self })),
            waves: is_known.then(|| self.waves(value)),
            turning: self.waves(&turning),
            resonant: factors(value),
            turned: factors(&turning),
        }
    }

    /// `true` for waves with the frequency of the oscillation.
    pub(super) fn is_resonant(&self, powers: &[i64]) -> bool {
        powers[self.forced.letters.index(Column::Wave)].abs() == 2 * self.forced.harmonics[0]
    }

    pub(super) fn phase(&self) -> &str {
        &self.setting.names.coordinates[0].phase
    }

    /// A coefficient times powers of displacement and velocity, their signs, and a further factor.
    pub(super) fn product(
        &self,
        coefficient: &Sum,
        [position, velocity]: [usize; 2],
        signs: [bool; 2],
        further: Option<&str>,
    ) -> String {
        let x = self.variable;
        let power = |base: &str, exponent: usize| match exponent {
            0 => None,
            1 => Some(base.to_owned()),
            _ => Some(format!("{base}^{exponent}")),
        };
        let speed = format!("{x}'");
        let sign = |base: &str, is_factor: bool| is_factor.then(|| format!("sign({base})"));
        let factors = [
            power(x, position),
            sign(x, signs[0]),
            power(&speed, velocity),
            sign(&speed, signs[1]),
            further.map(str::to_owned),
        ];
        let factors: Vec<String> = factors.into_iter().flatten().collect();
        let mut text = String::new();
        let moving = (!factors.is_empty()).then(|| factors.join("*"));
        append(&mut text, &self.waves(coefficient), moving);
        text
    }

    /// Displacement and velocity, in W·t and with (p/q)·(ψ − φ) in its place.
    pub(super) fn both(&self, motion: &[Sum; 2]) -> [[String; 2]; 2] {
        [false, true].map(|is_at_phase| {
            let written = Self { is_at_phase, ..*self };
            motion.each_ref().map(|sum| written.waves(sum))
        })
    }

    /// j and m of a wave e^{i(jψ + mWt)}.
    fn wave_numbers(&self, powers: &[i64]) -> [i64; 2] {
        let letters = self.forced.letters;
        let [z, conjugate, wave] =
            [Column::Phasor, Column::Conjugate, Column::Wave].map(|column| powers[letters.index(column)]);
        let j = (z - conjugate) / 2;
        [j, (wave / 2 - self.forced.harmonics[0] * j) / self.forced.drive_harmonic]
    }

    /// A real sum of waves, those near the natural frequency first.
    pub(super) fn waves(&self, sum: &Sum) -> String {
        let letters = self.forced.letters;
        let q = self.forced.harmonics[0];
        let mut all: Vec<[i64; 2]> = sum.half_powers().map(|(powers, _)| self.wave_numbers(powers)).collect();
        all.retain(|[j, m]| *j > 0 || (*j == 0 && *m >= 0));
        let frequency = |[j, m]: &[i64; 2]| (q * j + self.forced.drive_harmonic * m).abs();
        all.put_in_order_by(|wave| (frequency(wave) != q, frequency(wave), *wave));
        all.dedup();
        let mut text = String::new();
        for numbers in all {
            let wave_part = letters.part(sum, |powers| self.wave_numbers(powers) == numbers);
            let wave = letters.index(Column::Wave);
            let still = letters.changed(&wave_part, |powers, factor| {
                powers[wave] = 0;
                factor.clone()
            });
            let doubled = if numbers == [0, 0] { 1 } else { 2 };
            let amplitude = letters.scaled(&polar(letters, &still), &Rational::from(doubled));
            let [real, imaginary] = real_and_imaginary(letters, &amplitude);
            let angle = self.angle(numbers);
            let sine = letters.scaled(&imaginary, &Rational::from(-1));
            for (name, coefficient) in [("cos", real), ("sin", sine)] {
                let function = (!angle.is_empty()).then(|| format!("{name}({angle})"));
                append(&mut text, &letters.text(&coefficient), function);
            }
        }
        text
    }

    /// jψ + mWt.
    fn angle(&self, [j, m]: [i64; 2]) -> String {
        let mut text = if j == 0 { String::new() } else { multiple(j, "psi") };
        let turns = Rational::from(m.abs());
        let (p, q) = self.setting.resonance;
        let drive = match &self.setting.drive {
            Some(_) if self.is_at_phase => {
                let turns = turns * Rational::new(p, q).unwrap_or_else(|| Rational::from(1));
                match (turns.to_string().as_str(), j == 0 && m > 0) {
                    ("0", _) => String::new(),
                    ("1", true) => format!("psi - {}", self.phase()),
                    (turns, _) => format!("{turns}*(psi - {})", self.phase()),
                }
            }
            Some(DriveFrequency::Symbol(name)) => angle(&turns, name),
            Some(DriveFrequency::Number(number)) => angle(&(turns * number.clone()), "1"),
            None => String::new(),
        };
        append_term(&mut text, &if m < 0 { format!("-{drive}") } else { drive });
        text
    }
}

pub(super) fn multiple(k: i64, of: &str) -> String {
    match k {
        1 => of.to_owned(),
        _ => format!("{k}*{of}"),
    }
}
