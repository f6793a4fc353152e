//! Formulas of a slow flow in plain text: as JSON has them, and for functions and MathML.

use super::SlowFlowResult;
use crate::output::formulas::{NamedFormula, sum};
use libration::perturbation::{PhaseTerm, SlowSeries};

impl SlowFlowResult {
    /// The symbols of amplitude and phase, numbered where the equation has these names.
    pub(super) fn letters(&self) -> [String; 2] {
        ["A", "psi"].map(|name| self.subject.free(name, std::slice::from_ref(&self.flow.parameter)))
    }

    /// The rates of amplitude and phase.
    pub(super) fn rates(&self) -> [String; 2] {
        [&self.flow.amplitude_rate, &self.flow.phase_rate].map(|series| sum(&self.terms(series)))
    }

    /// The displacement from the equilibrium; for half swings that with a phase between 0 and π.
    pub(super) fn displacement(&self) -> String {
        let mut terms = vec![];
        for term in &self.flow.motion {
            for (name, series) in [("cos", &term.cos), ("sin", &term.sin)] {
                let factor = self.terms(series);
                if !factor.is_empty() {
                    terms.push(times(&sum(&factor), &self.function(term, name)));
                }
            }
        }
        sum(&terms)
    }

    /// `psi^2*cos(3*psi)`; nothing for the mean.
    fn function(&self, term: &PhaseTerm, function: &str) -> String {
        let [_, phase] = self.letters();
        let wave = match term.k {
            0 => String::new(),
            1 => format!("{function}({phase})"),
            k => format!("{function}({k}*{phase})"),
        };
        product(&[power(&phase, term.power), wave])
    }

    /// The terms of a polynomial that are not zero.
    fn terms(&self, series: &SlowSeries) -> Vec<String> {
        let [amplitude, _] = self.letters();
        let mut terms = vec![];
        for (j, list) in series.iter().enumerate() {
            for (n, value) in list.iter().enumerate().filter(|(_, value)| !value.is_zero()) {
                let powers = product(&[power(&self.flow.parameter, j), power(&amplitude, n)]);
                terms.push(times(&value.to_string(), &powers));
            }
        }
        terms
    }

    pub(super) fn formulas(&self) -> Vec<NamedFormula> {
        let [amplitude, phase] = self.rates();
        let of_displacement = if self.flow.half_swing {
            "displacement for phases from 0 to pi, and the opposite at pi more"
        } else {
            "displacement"
        };
        NamedFormula::without_latex([
            ("amplitude", "rate of the amplitude", amplitude),
            ("phase", "rate of the phase", phase),
            ("displacement", of_displacement, self.displacement()),
        ])
    }
}

fn power(name: &str, power: usize) -> String {
    match power {
        0 => String::new(),
        1 => name.to_owned(),
        _ => format!("{name}^{power}"),
    }
}

fn product(factors: &[String]) -> String {
    let present: Vec<&str> = factors.iter().map(String::as_str).filter(|factor| !factor.is_empty()).collect();
    present.join("*")
}

/// A factor, which may be a sum, times a product of symbols.
fn times(factor: &str, symbols: &str) -> String {
    match factor {
        _ if symbols.is_empty() => factor.to_owned(),
        "1" => symbols.to_owned(),
        "-1" => format!("-{symbols}"),
        _ if factor.contains(" + ") || factor.contains(" - ") => format!("({factor})*{symbols}"),
        _ => format!("{factor}*{symbols}"),
    }
}
