//! The verdicts follow from what is printed.

use super::*;
use statement::NOT_EVALUATED;

#[test]
fn every_statement_can_be_checked() {
    for row in rows() {
        assert_ne!(row.finding.evidence, NOT_EVALUATED, "{}", row.label);
    }
}
