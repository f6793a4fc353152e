//! Terms of the equations whose order is above that of the slow flow.

use super::equations::{Equations, terms};
use super::force::DriveFrequency;
use super::letters::Column;
use super::phase_sums::{append, real_and_imaginary};
use super::result::fast_angle;
use super::scales::{Forced, SmallForceTerm};
use super::setting::Setting;
use libration_numbers::algebra::Rational;

impl Setting {
    /// The highest order that small parameters give a term.
    pub(super) fn stated_order(&self, equations: &Equations) -> Option<i64> {
        let order = self.letters.index(Column::Order);
        let powers =
            equations.accelerations.iter().flat_map(|sum| sum.half_powers().map(|(powers, _)| powers));
        powers.map(|powers| powers[order] / 2).filter(|order| *order > 0).max()
    }

    /// A note on terms of the equations whose order is above this one.
    pub(super) fn left_out(
        &self,
        equations: &Equations,
        forced: &Forced<'_>,
        variables: &[String],
        order: i64,
    ) -> Option<String> {
        let by_amplitude = self.large_degrees(equations).next().is_some();
        let mut notes: Vec<String> = self.plain_left_out(equations, order).into_iter().collect();
        if equations.is_series {
            notes.push(format!(
                "terms above order {order} are left out, those of power series in the small parameters among them"
            ));
            return Some(notes.join("; "));
        }
        for (acceleration, variable) in equations.accelerations.iter().zip(variables) {
            let is_beyond = |term: &SmallForceTerm| {
                let degree = term.powers.iter().flatten().sum::<usize>().saturating_sub(1);
                let raised = if by_amplitude { i64::try_from(degree).unwrap_or(0) } else { 0 };
                term.order > 0 && term.order + raised > order
            };
            let mut text = String::new();
            for term in terms(&self.letters, acceleration).iter().filter(|term| is_beyond(term)) {
                self.append_products(&mut text, forced, variables, term);
            }
            if !text.is_empty() {
                notes.push(format!("terms above order {order} are left out of {variable}'': {text}"));
            }
        }
        (!notes.is_empty()).then(|| notes.join("; "))
    }

    /// The same on terms without a small parameter.
    fn plain_left_out(&self, equations: &Equations, order: i64) -> Option<String> {
        let highest = self.known_degrees(equations).map(|(degree, _)| degree - 1).max()?;
        (highest > order).then(|| {
            format!(
                "terms without a small parameter are of the order of their degree less one: those of degrees above {} are left out",
                order + 1
            )
        })
    }

    /// Appends a term as products of symbols, waves, displacements and velocities.
    fn append_products(
        &self,
        text: &mut String,
        forced: &Forced<'_>,
        variables: &[String],
        term: &SmallForceTerm,
    ) {
        let letters = &self.letters;
        let moving = moving_factors(variables, term);
        let joined = |factors: &[String]| (!factors.is_empty()).then(|| factors.join("*"));
        for power in letters.exponents(&term.coefficient, Column::Drive) {
            let of_power = letters.coefficient(&term.coefficient, Column::Drive, power);
            let drive = match &self.drive {
                Some(DriveFrequency::Symbol(name)) => raised(name, power),
                _ => None,
            };
            for k in letters.exponents(&of_power, Column::Wave).into_iter().filter(|k| *k >= 0) {
                let doubled = Rational::from(if k == 0 { 1 } else { 2 });
                let of_wave = letters.scaled(&letters.coefficient(&of_power, Column::Wave, k), &doubled);
                let [cosine, imaginary] = real_and_imaginary(letters, &of_wave);
                let sine = letters.scaled(&imaginary, &Rational::from(-1));
                for (name, coefficient) in [("cos", cosine), ("sin", sine)] {
                    let wave = (k > 0).then(|| format!("{name}({})", fast_angle(self, forced, k)));
                    let factors: Vec<String> = drive.iter().chain(&moving).cloned().chain(wave).collect();
                    append(text, &letters.text(&coefficient), joined(&factors));
                }
            }
        }
    }
}

/// Powers of displacements and velocities with the signs of the first.
fn moving_factors(variables: &[String], term: &SmallForceTerm) -> Vec<String> {
    let mut factors = vec![];
    for (coordinate, (variable, powers)) in variables.iter().zip(&term.powers).enumerate() {
        let names = [variable.clone(), format!("{variable}'")];
        for ((name, &power), is_signed) in names.iter().zip(powers).zip(term.signs) {
            let is_signed = is_signed && coordinate == 0;
            let plain = if is_signed { power.saturating_sub(1) } else { power };
            factors.extend(raised(name, i64::try_from(plain).unwrap_or(0)));
            if is_signed {
                factors.push(format!("{}({name})", if power == 0 { "sign" } else { "abs" }));
            }
        }
    }
    factors
}

/// A power as text; `None` for one.
fn raised(name: &str, power: i64) -> Option<String> {
    match power {
        0 => None,
        1 => Some(name.to_owned()),
        _ => Some(format!("{name}^{power}")),
    }
}
