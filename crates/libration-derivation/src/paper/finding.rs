//! Results of the checks of statements.

use std::fmt;

/// The verdict on a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StatementVerdict {
    /// The statement is correct.
    Verified,
    /// The statement has a typing error; its meaning is correct.
    Typo,
    /// The statement is wrong.
    Wrong,
    /// The check could not be evaluated, so that the statement is undecided.
    NotDecided,
}

impl StatementVerdict {
    /// All verdicts.
    pub const ALL: [Self; 4] = [Self::Verified, Self::Typo, Self::Wrong, Self::NotDecided];

    /// `verified`, `typo`, `wrong` or `not decided`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Verified => "verified",
            Self::Typo => "typo",
            Self::Wrong => "wrong",
            Self::NotDecided => "not decided",
        }
    }
}

impl fmt::Display for StatementVerdict {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

/// The verdict on a statement, with its reasons.
#[derive(Clone, Debug, PartialEq)]
pub struct StatementFinding {
    /// Verdict on the statement.
    pub verdict: StatementVerdict,
    /// Range in which the verdict holds, if not everywhere; often empty.
    pub restriction: String,
    /// Correction of the statement; empty if none is needed.
    pub correct: String,
    /// Computed evidence, with its numbers.
    pub evidence: String,
    /// The amplitudes in radians on which a quantitative claim holds; empty for other statements.
    pub holds_for: Vec<(f64, f64)>,
}

impl StatementFinding {
    pub(super) fn verified(evidence: impl Into<String>) -> Self {
        Self {
            verdict: StatementVerdict::Verified,
            restriction: String::new(),
            correct: String::new(),
            evidence: evidence.into(),
            holds_for: Vec::new(),
        }
    }

    pub(super) fn typo(correct: impl Into<String>, evidence: impl Into<String>) -> Self {
        Self { verdict: StatementVerdict::Typo, correct: correct.into(), ..Self::verified(evidence) }
    }

    pub(super) fn wrong(correct: impl Into<String>, evidence: impl Into<String>) -> Self {
        Self { verdict: StatementVerdict::Wrong, ..Self::typo(correct, evidence) }
    }

    pub(super) fn not_decided(evidence: impl Into<String>) -> Self {
        Self { verdict: StatementVerdict::NotDecided, ..Self::verified(evidence) }
    }

    /// Verified if `right`, otherwise wrong with this correction.
    pub(super) fn verified_if(right: bool, correct: impl Into<String>, evidence: impl Into<String>) -> Self {
        if right { Self::verified(evidence) } else { Self::wrong(correct, evidence) }
    }

    pub(super) fn restricted(self, restriction: impl Into<String>) -> Self {
        Self { restriction: restriction.into(), ..self }
    }

    pub(super) fn with_correct(self, correct: impl Into<String>) -> Self {
        Self { correct: correct.into(), ..self }
    }

    pub(super) fn holding_for(self, holds_for: Vec<(f64, f64)>) -> Self {
        Self { holds_for, ..self }
    }

    /// The verdict and its restriction: `verified`, `wrong for n = 1`.
    #[must_use]
    pub fn summary(&self) -> String {
        format!("{} {}", self.verdict, self.restriction).trim_end().to_owned()
    }
}
