//! Descriptions of checks in words.

use super::super::formula::{Decimal, DecimalUnit, Formula, Name, rounded};
use super::super::prose::Prose;
use super::{Against, AveragedClaim, Check, ComparedAt, CycleClaim, QuarterClaim, TruncatedClaim};

impl Check {
    /// Returns `true` if the statement required a check, and it was computed.
    #[doc(hidden)]
    pub fn is_computed(&self) -> bool {
        !matches!(self, Self::Definition | Self::Premise | Self::Given)
    }

    /// The description of the check.
    pub(crate) fn to_prose(&self) -> Prose {
        match self {
            Self::Definition => Prose::text("definition"),
            Self::Premise => Prose::text("the starting point"),
            Self::Below => Prose::text("checked with the equation of motion, below"),
            Self::Given => Prose::text("as given"),
            Self::Series { variable, coefficients } => Prose::new(
                "checked: the same power series in {}, exactly, through {}",
                [variable.into(), last_power(variable, *coefficients)],
            ),
            Self::Choices { variable, coefficients, choices } => Prose::new(
                &match choices {
                    1 => "checked: the same power series in {} through {}, to 60 digits".to_owned(),
                    _ => format!(
                        "checked: the same power series in {{}} through {{}}, to 60 digits, for {choices} choices of the symbols"
                    ),
                },
                [variable.into(), last_power(variable, *coefficients)],
            ),
            Self::Rationals { index, first, last } => Prose::new(
                "checked: the same fractions, exactly, for {} = {} ",
                [index.into(), (*first).into()],
            )
            .and(Prose::new("to {}", [(*last).into()])),
            Self::Fraction => Prose::text("checked: the same fraction, exactly"),
            Self::Catalogued { key, .. } => Prose::text(format!(
                "definition; checked: it has the values of the formula {key} in the catalogue"
            )),
            Self::Phases { variable, order, phases } => Prose::new(
                &format!(
                    "checked: put into the equation of motion with exact fractions, through {{}}, at {phases} phases, which are enough to decide for all"
                ),
                [last_power(variable, order + 1)],
            ),
            Self::Substituted { choices, .. } => Prose::text(format!(
                "checked: put into the equation of motion with exact fractions, for {choices} choices of the symbols"
            )),
            Self::Cycle(formula) => Prose::text(cycle(&formula.claim)),
            Self::Averaged(formula) => Prose::text(averaged(&formula.claim)),
            Self::Quarter(formula) => Prose::text(quarter(&formula.claim)),
            Self::Truncated(formula) => Prose::text(match &formula.claim {
                TruncatedClaim::Series { .. } => "checked: put into the equation above, exactly",
                _ => "checked: the same polynomial, exactly",
            }),
            Self::RoundedDigits => Prose::text("checked: the digits printed are those of the exact value"),
            Self::Digits { compared_at: ComparedAt::Choices { choices }, difference, .. } => {
                let equal =
                    Prose::text(format!("checked for {choices} choices of the symbols: equal in all digits"));
                match *difference > 0.0 {
                    true => equal
                        .and(Prose::new(" but a relative {}", [rounded(*difference, 1, DecimalUnit::One)])),
                    false => equal,
                }
            }
            Self::Digits { compared_at: point, value, difference, against } => {
                point.to_prose().and(agreement(value, *difference, *against))
            }
        }
    }
}

fn cycle(claim: &CycleClaim) -> &'static str {
    match claim {
        CycleClaim::Forcing { .. } => "checked: the sum of the products in the table, exactly",
        CycleClaim::Sine { .. } => "checked: this part of the equation above, exactly",
        CycleClaim::AmplitudeSeries { .. } => {
            "checked: each coefficient in its condition, exactly; another algorithm has the same"
        }
        CycleClaim::Amplitude => "checked: put into this condition, exactly; another algorithm has the same",
        CycleClaim::Frequency | CycleClaim::FrequencySeries { .. } => {
            "checked: nothing of the cosine is left, exactly; another algorithm has the same"
        }
        CycleClaim::Motion { .. } => "checked: put into the equation of motion, exactly",
    }
}

fn quarter(claim: &QuarterClaim) -> &'static str {
    match claim {
        QuarterClaim::Forcing { .. } => "checked: the sum of the products in the table, exactly",
        QuarterClaim::Begun => "checked: put into the equation above, exactly",
        QuarterClaim::Correction => {
            "checked: zero after a quarter of the period, exactly; another algorithm has the same"
        }
        QuarterClaim::Motion => "checked: put into the equation of motion, exactly",
        QuarterClaim::Harmonic { .. } => {
            "checked: integrated over the motion above, exactly; another algorithm has the same coefficients"
        }
    }
}

fn averaged(claim: &AveragedClaim) -> &'static str {
    match claim {
        AveragedClaim::ChainRule => "checked: the same for several functions of amplitude and phase, exactly",
        AveragedClaim::Forcing { .. } => "checked: the sum of the products in the table, exactly",
        AveragedClaim::Growth { .. } | AveragedClaim::Frequency { .. } => {
            "checked: nothing is left that would grow, exactly; another algorithm has the same"
        }
        AveragedClaim::Motion { .. } => "checked: put into the equation of motion, exactly",
        AveragedClaim::Velocity { .. } => "checked: the derivative along the motion, exactly",
        AveragedClaim::AmplitudeLaw { .. } | AveragedClaim::PhaseLaw { .. } => {
            "checked: the motion above satisfies the equation of motion with it, exactly; another algorithm has the same coefficients"
        }
        AveragedClaim::FirstLaw => {
            "checked: its product with the force is what is lost, power by power, exactly"
        }
        AveragedClaim::Loss { .. } => "checked: integrated over the motion above, exactly",
        AveragedClaim::Cycle { .. } => "checked: put into the slow flow, exactly",
    }
}

impl ComparedAt {
    fn to_prose(&self) -> Prose {
        match self {
            Self::Everywhere | Self::Choices { .. } => Prose::text("checked: "),
            Self::Cases { index, first, last } => {
                Prose::new("checked for {} = {}", [index.into(), Formula::from(*first)])
                    .and(Prose::new(" to {}; for the first ", [Formula::from(*last)]))
            }
            Self::Amplitudes { at, amplitudes } => {
                let mut prose = Prose::new("checked at {} = ", [Name::new("θ").index(0).into()]);
                for (n, amplitude) in amplitudes.iter().enumerate() {
                    let comma = match n {
                        0 => "",
                        n if n + 1 == amplitudes.len() => " and ",
                        _ => ", ",
                    };
                    prose = prose
                        .and(Prose::text(comma))
                        .and(Prose::formula(Formula::Decimal(amplitude.clone())));
                }
                prose.and(Prose::new("; at {} ", [Formula::Decimal(at.clone())]))
            }
        }
    }
}

fn last_power(variable: &Name, coefficients: usize) -> Formula {
    Formula::from(variable).pow(i64::try_from(coefficients.saturating_sub(1)).unwrap_or(i64::MAX))
}

fn agreement(value: &Decimal, difference: f64, against: Against) -> Prose {
    let value = Formula::Decimal(value.clone());
    let sides = Prose::new("both sides are {}", [value]);
    let sides = match against {
        Against::OtherSide => sides,
        Against::Library => sides.and(Prose::text(", one of them from the exact motion in double precision")),
    };
    if difference == 0.0 {
        return sides.and(Prose::text("; equal in all digits"));
    }
    sides.and(Prose::new("; largest relative difference {}", [rounded(difference, 1, DecimalUnit::One)]))
}
