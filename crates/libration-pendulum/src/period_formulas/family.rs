//! Formulas with a selectable number of terms.

use super::expansion::{frequency_in_amplitude, pade, period_in_amplitude, period_in_sine_squared};
use super::formula::{Attribution, Complexity, LeadingTerm, PeriodFormula};
use super::law::Law;
use super::real::Coefficients;
use libration_numbers::algebra::Rational;

/// The largest number of correction terms; computing their exact coefficients takes seconds.
pub const MOST_TERMS: usize = 1000;

/// The largest degree of a Padé approximant. In θ0² that of degree 11 has a pole at an amplitude of 2.89 rad (mpmath, 60 digits), and denominators of
/// degree 10 cancel so near the top that two words are off 300 times as far as for other formulas.
pub const LARGEST_PADE: usize = 5;

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
    PadePower,
    PadeSineSquared,
}

impl Family {
    pub const ALL: [Self; 5] = [
        Self::PowerSeries,
        Self::FourierPerturbation,
        Self::SineSquared,
        Self::PadePower,
        Self::PadeSineSquared,
    ];

    /// The largest number of a key.
    pub fn most(self) -> usize {
        if self.is_quotient() { LARGEST_PADE } else { MOST_TERMS }
    }

    fn is_quotient(self) -> bool {
        matches!(self, Self::PadePower | Self::PadeSineSquared)
    }

    fn is_in_sine(self) -> bool {
        matches!(self, Self::SineSquared | Self::PadeSineSquared)
    }

    /// The key without its number of corrections.
    pub(super) fn stem(self) -> &'static str {
        match self {
            Self::PowerSeries => "power_series_",
            Self::FourierPerturbation => "black_vel_",
            Self::SineSquared => "sin2_series_",
            Self::PadePower => "pade_power_",
            Self::PadeSineSquared => "pade_sin2_",
        }
    }

    /// The formula of a key such as `power_series_7`.
    pub(super) fn from_key(key: &str) -> Option<PeriodFormula> {
        let family = Self::ALL.into_iter().find(|family| key.starts_with(family.stem()))?;
        let digits = key.strip_prefix(family.stem())?;
        let corrections: usize = digits.parse().ok()?;
        let canonical = digits == corrections.to_string();
        (canonical && (1..=family.most()).contains(&corrections)).then(|| family.formula(corrections))
    }

    /// The formula with this many corrections, or of this degree, at least one.
    pub fn formula(self, corrections: usize) -> PeriodFormula {
        let Built { law, text, latex, leading_error } = self.built(corrections);
        let published = self.published(corrections);
        let numbered = format!("{}{corrections}", self.stem());
        PeriodFormula {
            key: published.map_or_else(|| numbered.clone(), |formula| formula.key.to_owned()),
            also: if published.is_some() { vec![numbered] } else { Vec::new() },
            name: published.map_or_else(|| self.name(corrections), |formula| formula.name.to_owned()),
            authors: published.map_or_else(|| self.authors(), |formula| formula.authors).to_owned(),
            year: published.map_or_else(|| self.year(), |formula| formula.year),
            source: published.map_or_else(|| self.source(), |formula| formula.source).to_owned(),
            attribution: Attribution::Certain,
            text,
            derivation: self.derivation().to_owned(),
            latex,
            domain: self.domain().to_owned(),
            complexity: self.complexity(corrections),
            leading_error: Some(leading_error),
            law,
        }
    }

    fn built(self, corrections: usize) -> Built {
        if self.is_quotient() {
            return self.quotient(corrections);
        }
        let mut coefficients = self.coefficients(corrections + 1);
        let next = coefficients.pop().unwrap_or_else(|| Rational::from(0));
        let polynomial = |notation: &Notation| notation.polynomial(&coefficients);
        let (text, latex) = (polynomial(&self.plain()), polynomial(&self.in_latex()));
        let is_reciprocal = self == Self::FourierPerturbation;
        Built {
            text: if is_reciprocal { format!("1/({text})") } else { text },
            latex: if is_reciprocal { format!(r"\left({latex}\right)^{{-1}}") } else { latex },
            leading_error: self.leading_error(if is_reciprocal { next } else { -next }, corrections + 1),
            law: self.law(Coefficients::new(coefficients)),
        }
    }

    /// The Padé approximant of this degree, which exists up to [`LARGEST_PADE`]; 1 where there is none.
    fn quotient(self, degree: usize) -> Built {
        let series = self.coefficients(2 * degree + 1);
        let one = || ([vec![Rational::from(1)], vec![Rational::from(1)]], series[1].clone());
        let (both, next) = pade(&series, degree).unwrap_or_else(one);
        let [text, latex] = [self.plain(), self.in_latex()].map(|notation| {
            let [numerator, denominator] =
                both.each_ref().map(|coefficients| notation.polynomial(coefficients));
            notation.quotient(&numerator, &denominator)
        });
        let both = both.map(Coefficients::new);
        let law = if self.is_in_sine() { Law::PadeSineSquared(both) } else { Law::PadePower(both) };
        Built { law, text, latex, leading_error: self.leading_error(-next, 2 * degree + 1) }
    }

    fn coefficients(self, corrections: usize) -> Vec<Rational> {
        match self {
            Self::PowerSeries | Self::PadePower => period_in_amplitude(corrections),
            Self::FourierPerturbation => frequency_in_amplitude(corrections),
            Self::SineSquared | Self::PadeSineSquared => period_in_sine_squared(corrections),
        }
    }

    fn law(self, coefficients: Coefficients) -> Law {
        match self {
            Self::FourierPerturbation => Law::FourierPerturbation(coefficients),
            Self::SineSquared | Self::PadeSineSquared => Law::SineSquared(coefficients),
            Self::PowerSeries | Self::PadePower => Law::PowerSeries(coefficients),
        }
    }

    fn name(self, corrections: usize) -> String {
        let plural = if corrections == 1 { "" } else { "s" };
        match self {
            Self::PowerSeries => format!("power series, {corrections} correction{plural}"),
            Self::FourierPerturbation => format!("Fourier-perturbation, {corrections} term{plural}"),
            Self::SineSquared => format!("series in sin\u{b2}(\u{3b8}0/2), {corrections} correction{plural}"),
            Self::PadePower => format!("Padé [{corrections}/{corrections}] in \u{3b8}0\u{b2}"),
            Self::PadeSineSquared => format!("Padé [{corrections}/{corrections}] in sin\u{b2}(\u{3b8}0/2)"),
        }
    }

    /// The older formula that equals this series with one correction, for two of the series.
    fn published(self, corrections: usize) -> Option<&'static Known> {
        match self {
            Self::PowerSeries if corrections == 1 => Some(&BERNOULLI),
            Self::FourierPerturbation if corrections == 1 => Some(&DENMAN),
            _ => None,
        }
    }

    fn authors(self) -> &'static str {
        match self {
            Self::PowerSeries | Self::SineSquared | Self::PadePower | Self::PadeSineSquared => "",
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
            Self::PadePower | Self::PadeSineSquared => {
                "the Padé approximant (DLMF 3.11.16) of the exact series"
            }
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
            Self::PadePower | Self::PadeSineSquared => "all amplitudes below the top, where it stays finite",
        }
    }

    fn derivation(self) -> &'static str {
        match self {
            Self::PowerSeries => "(2/π) K(k) expanded in powers of θ0²",
            Self::FourierPerturbation => {
                "perturbation theory gives the frequency Ω/ω0 in powers of θ0², and T/T0 = ω0/Ω"
            }
            Self::SineSquared => {
                "1/√(1 − k² sin²φ) under the integral of K expanded in powers of k², and integrated term by term"
            }
            Self::PadePower | Self::PadeSineSquared => {
                "the quotient of two polynomials that agrees with the exact series in as many terms as it has coefficients"
            }
        }
    }

    fn complexity(self, corrections: usize) -> Complexity {
        let terms = u16::try_from(corrections).unwrap_or(u16::MAX);
        let division = u16::from(self == Self::FourierPerturbation || self.is_quotient());
        let sine = u16::from(self.is_in_sine());
        let polynomials = 1 + u16::from(self.is_quotient());
        let operations = 1 + sine + division + terms.saturating_mul(2 * polynomials);
        Complexity { functions: sine, roots: 0, operations }
    }

    /// The coefficient of this power of the variable in the fractional error, in powers of θ0: sin²(θ0/2) is about θ0²/4.
    fn leading_error(self, coefficient: Rational, power: usize) -> LeadingTerm {
        let scaled =
            if self.is_in_sine() { coefficient.divided_by_power_of_two(2 * power) } else { coefficient };
        LeadingTerm { coefficient: scaled, power: u32::try_from(2 * power).unwrap_or(u32::MAX) }
    }

    fn in_latex(self) -> Notation {
        let variable = if self.is_in_sine() { r"\sin^{#}\frac{\theta_0}{2}" } else { r"\theta_0^{#}" };
        Notation { variable, is_latex: true }
    }

    fn plain(self) -> Notation {
        Notation { variable: if self.is_in_sine() { "k" } else { "θ0" }, is_latex: false }
    }
}

/// A formula of a family, of some number of corrections.
struct Built {
    law: Law,
    text: String,
    latex: String,
    leading_error: LeadingTerm,
}

/// A notation for polynomials in an even power of a variable.
struct Notation {
    variable: &'static str,
    is_latex: bool,
}

impl Notation {
    /// The first terms, and dots for more.
    fn polynomial(&self, coefficients: &[Rational]) -> String {
        let shown = if self.is_latex { 7 } else { 4 };
        let terms = coefficients.iter().take(shown).enumerate().skip(1);
        let mut text: String = terms.fold("1".to_owned(), |text, (n, c)| text + &self.term(c, 2 * n));
        if coefficients.len() > shown {
            let last = self.power(2 * (coefficients.len() - 1));
            text += &match self.is_latex {
                true => format!(r"+\cdots\ \left(\text{{to }}{last}\right)"),
                false => format!(" + … to {last}"),
            };
        }
        text
    }

    fn term(&self, coefficient: &Rational, power: usize) -> String {
        let (numerator, denominator) = (coefficient.numerator(), coefficient.denominator());
        let (sign, digits) = numerator
            .strip_prefix('-')
            .map_or((['+', '+'], numerator.as_str()), |digits| (['-', '−'], digits));
        let power = self.power(power);
        match (self.is_latex, digits) {
            (true, _) => format!(r"{}\frac{{{digits}}}{{{denominator}}}{power}", sign[0]),
            (false, "1") => format!(" {} {power}/{denominator}", sign[1]),
            (false, _) => format!(" {} {digits} {power}/{denominator}", sign[1]),
        }
    }

    fn power(&self, power: usize) -> String {
        if self.is_latex {
            return self.variable.replace('#', &power.to_string());
        }
        const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
        let raised =
            power.to_string().bytes().map(|digit| RAISED[usize::from(digit - b'0')]).collect::<String>();
        format!("{}{raised}", self.variable)
    }

    fn quotient(&self, numerator: &str, denominator: &str) -> String {
        if self.is_latex {
            // Blanks, at which lines can be broken.
            let [numerator, denominator] =
                [numerator, denominator].map(|part| part.replace('+', " +").replace('-', " -"));
            format!(r"\frac{{{numerator}}} {{{denominator}}}")
        } else {
            format!("({numerator})/({denominator})")
        }
    }
}
