//! Formulas with a selectable number of terms.

use super::expansion::{frequency_in_amplitude, period_in_amplitude, period_in_sine_squared};
use super::formula::{Attribution, Complexity, LeadingTerm, PeriodFormula};
use super::law::Law;
use super::real::Coefficients;
use libration_numbers::algebra::Rational;

/// The largest number of correction terms; computing their exact coefficients takes seconds.
pub const MOST_TERMS: usize = 1000;

/// A formula that has another name.
struct Known {
    key: &'static str,
    name: &'static str,
    authors: &'static str,
    year: Option<u16>,
    source: &'static str,
}

static BERNOULLI: Known = Known {
    key: "bernoulli",
    name: "Bernoulli",
    authors: "D. Bernoulli",
    year: None,
    source: "D. Bernoulli in the late 1740s; equation (4) of B. Black and V. Vel, Am. J. Phys. 91, 776 (2023), doi:10.1119/5.0130943; not verified against the original",
};

static DENMAN: Known = Known {
    key: "denman",
    name: "Denman",
    authors: "H. H. Denman",
    year: Some(1959),
    source: "H. H. Denman, Am. J. Phys. 27, 524 (1959), as quoted by P. F. Hinrichsen, Phys. Teach. 59, 646 (2021); equation (51) of B. Black and V. Vel, Am. J. Phys. 91, 776 (2023), doi:10.1119/5.0130943, with one term; not verified against the original",
};

/// A series that gives one formula for each number of corrections.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(hidden)]
pub enum Family {
    PowerSeries,
    FourierPerturbation,
    SineSquared,
}

impl Family {
    pub const ALL: [Self; 3] = [Self::PowerSeries, Self::FourierPerturbation, Self::SineSquared];

    /// The key without its number of corrections.
    pub(super) fn stem(self) -> &'static str {
        match self {
            Self::PowerSeries => "power_series_",
            Self::FourierPerturbation => "black_vel_",
            Self::SineSquared => "sin2_series_",
        }
    }

    /// The formula of a key such as `power_series_7`.
    pub(super) fn from_key(key: &str) -> Option<PeriodFormula> {
        let family = Self::ALL.into_iter().find(|family| key.starts_with(family.stem()))?;
        let digits = key.strip_prefix(family.stem())?;
        let corrections: usize = digits.parse().ok()?;
        let canonical = digits == corrections.to_string();
        (canonical && (1..=MOST_TERMS).contains(&corrections)).then(|| family.formula(corrections))
    }

    /// The formula with this many corrections, at least one.
    pub fn formula(self, corrections: usize) -> PeriodFormula {
        let mut coefficients = self.coefficients(corrections + 1);
        let next = coefficients.pop().unwrap_or_else(|| Rational::from(0));
        let latex = self.latex(&coefficients);
        let known = self.known(corrections);
        let numbered = format!("{}{corrections}", self.stem());
        PeriodFormula {
            key: known.map_or_else(|| numbered.clone(), |known| known.key.to_owned()),
            also: if known.is_some() { vec![numbered] } else { Vec::new() },
            name: known.map_or_else(|| self.name(corrections), |known| known.name.to_owned()),
            authors: known.map_or_else(|| self.authors(), |known| known.authors).to_owned(),
            year: known.map_or_else(|| self.year(), |known| known.year),
            source: known.map_or_else(|| self.source(), |known| known.source).to_owned(),
            attribution: Attribution::Certain,
            latex,
            domain: self.domain().to_owned(),
            complexity: self.complexity(corrections),
            leading_error: Some(self.leading_error(next, corrections)),
            law: self.law(coefficients),
        }
    }

    fn coefficients(self, corrections: usize) -> Vec<Rational> {
        match self {
            Self::PowerSeries => period_in_amplitude(corrections),
            Self::FourierPerturbation => frequency_in_amplitude(corrections),
            Self::SineSquared => period_in_sine_squared(corrections),
        }
    }

    fn law(self, coefficients: Vec<Rational>) -> Law {
        let coefficients = Coefficients::new(coefficients);
        match self {
            Self::PowerSeries => Law::PowerSeries(coefficients),
            Self::FourierPerturbation => Law::FourierPerturbation(coefficients),
            Self::SineSquared => Law::SineSquared(coefficients),
        }
    }

    fn name(self, corrections: usize) -> String {
        let plural = if corrections == 1 { "" } else { "s" };
        match self {
            Self::PowerSeries => format!("power series, {corrections} correction{plural}"),
            Self::FourierPerturbation => format!("Fourier-perturbation, {corrections} term{plural}"),
            Self::SineSquared => format!("series in sin\u{b2}(\u{3b8}0/2), {corrections} correction{plural}"),
        }
    }

    /// The older formula that equals this series with one correction, for two of the series.
    fn known(self, corrections: usize) -> Option<&'static Known> {
        match self {
            Self::PowerSeries if corrections == 1 => Some(&BERNOULLI),
            Self::FourierPerturbation if corrections == 1 => Some(&DENMAN),
            _ => None,
        }
    }

    fn authors(self) -> &'static str {
        match self {
            Self::PowerSeries | Self::SineSquared => "",
            Self::FourierPerturbation => "B. Black and V. Vel",
        }
    }

    fn year(self) -> Option<u16> {
        (self == Self::FourierPerturbation).then_some(2023)
    }

    fn source(self) -> &'static str {
        match self {
            Self::PowerSeries => {
                "equation (14) of B. Black and V. Vel, Am. J. Phys. 91, 776 (2023), doi:10.1119/5.0130943"
            }
            Self::FourierPerturbation => {
                "equation (51) of B. Black and V. Vel, Am. J. Phys. 91, 776 (2023), doi:10.1119/5.0130943"
            }
            Self::SineSquared => "J. C\u{f4}t\u{e9}, Period of a Pendulum, the last equation",
        }
    }

    fn domain(self) -> &'static str {
        match self {
            Self::PowerSeries => {
                "all amplitudes below the top, where it stays finite and the series stops converging"
            }
            Self::FourierPerturbation => {
                "all amplitudes below the top, where it stays finite; with one term its pole is at 4 rad, beyond it"
            }
            Self::SineSquared => {
                "all amplitudes below the top, where it stays finite; converges slower than the power series"
            }
        }
    }

    fn complexity(self, corrections: usize) -> Complexity {
        let terms = u16::try_from(corrections).unwrap_or(u16::MAX);
        let division = u16::from(self == Self::FourierPerturbation);
        let sine = u16::from(self == Self::SineSquared);
        Complexity { functions: sine, roots: 0, operations: 1 + sine + division + terms.saturating_mul(2) }
    }

    /// The leading error of the truncated series: T/T0 lacks its next term; for the inverse of Ω/ω0 the next term keeps its sign; sin²(θ0/2) is
    /// about θ0²/4.
    fn leading_error(self, next: Rational, corrections: usize) -> LeadingTerm {
        let power = u32::try_from(2 * (corrections + 1)).unwrap_or(u32::MAX);
        let coefficient = match self {
            Self::PowerSeries => -next,
            Self::FourierPerturbation => next,
            Self::SineSquared => -next.divided_by_power_of_two(2 * (corrections + 1)),
        };
        LeadingTerm { coefficient, power }
    }

    fn latex(self, coefficients: &[Rational]) -> String {
        let variable = match self {
            Self::SineSquared => r"\sin^{#}\frac{\theta_0}{2}",
            Self::PowerSeries | Self::FourierPerturbation => r"\theta_0^{#}",
        };
        let polynomial = polynomial_latex(coefficients, variable);
        if self == Self::FourierPerturbation {
            format!(r"\left({polynomial}\right)^{{-1}}")
        } else {
            polynomial
        }
    }
}

/// The first terms, followed by dots if there are more than six.
fn polynomial_latex(coefficients: &[Rational], variable: &str) -> String {
    const SHOWN: usize = 7;
    let terms = coefficients.iter().take(SHOWN).enumerate().skip(1);
    let mut text: String = terms.fold("1".to_owned(), |text, (n, c)| {
        text + &term_latex(c, &variable.replace('#', &(2 * n).to_string()))
    });
    if coefficients.len() > SHOWN {
        let last = 2 * (coefficients.len() - 1);
        text += &format!(r"+\cdots\ \left(\text{{to }}{}\right)", variable.replace('#', &last.to_string()));
    }
    text
}

fn term_latex(coefficient: &Rational, power: &str) -> String {
    let numerator = coefficient.numerator();
    let (sign, digits) =
        numerator.strip_prefix('-').map_or(("+", numerator.as_str()), |digits| ("-", digits));
    format!(r"{sign}\frac{{{digits}}}{{{}}}{power}", coefficient.denominator())
}
