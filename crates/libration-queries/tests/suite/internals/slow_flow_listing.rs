//! The letters of slow flows.

use libration_queries::internals::slow_flow_listing::in_letters;

#[test]
fn pi_stands_as_a_letter_where_it_cannot_be_misread() {
    assert_eq!(in_letters("-4/(3*pi) + 8/(9*pi^2)"), "-4/(3π) + 8/(9π^2)");
    assert_eq!(in_letters("3/4*pi - 2/pi"), "3/4*π - 2/π");
}
