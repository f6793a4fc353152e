//! Propagation of the uncertainties of inputs to that of g, as in the Guide to the Expression of Uncertainty in Measurement.

use libration_lab::fit::{
    BudgetError, BudgetInput, CombinedUncertainty, Contribution, Correlation, Evaluation,
};

/// The example of G.4.1: relative uncertainties of 0.25 % from ten readings, 0.57 % from five and 0.82 % from fifteen.
#[test]
fn effective_degrees_of_freedom_are_those_of_the_guide() {
    use BudgetInput::{Length, Period, Slope};
    let contributions = [(Length, 0.25, 9.0), (Period, 0.57, 4.0), (Slope, 0.82, 14.0)].map(
        |(input, spread, degrees_of_freedom)| Contribution {
            degrees_of_freedom,
            ..Contribution::judged(input, 1.0, Some(spread), 1.0)
        },
    );
    let combined = CombinedUncertainty::new(contributions.to_vec(), &[]).unwrap();
    assert!((combined.standard - 1.03).abs() < 5e-3 && (combined.degrees_of_freedom - 19.0).abs() < 0.05);
    // 18.98, cut down to 18 (the Guide, table G.2, 95 %).
    assert!((combined.coverage_factor() - 2.10).abs() < 5e-3, "{}", combined.coverage_factor());
}

#[test]
fn a_pair_has_one_correlation() {
    let inputs = [BudgetInput::Length, BudgetInput::Period, BudgetInput::Clock];
    let contributions = inputs.map(|input| Contribution::judged(input, 1.0, Some(1.0), 1.0));
    let both = |a: usize, b: usize| Correlation { between: [inputs[a], inputs[b]], coefficient: 0.5 };
    let combined =
        |pairs: &[Correlation]| CombinedUncertainty::new(contributions.to_vec(), pairs).map(|_| ());
    let repeated = BudgetError::CorrelationRepeated { first: inputs[1].name(), second: inputs[0].name() };
    assert_eq!(combined(&[both(0, 1), both(1, 0)]), Err(repeated));
    assert_eq!(combined(&[both(0, 1), both(1, 2), both(0, 2)]), Ok(()));
}

/// Three equal readings give no more information on their scatter than any three.
#[test]
fn no_scatter_among_few_readings_is_not_known_for_certain() {
    let judged = Contribution::judged(BudgetInput::Period, 2.0, Some(0.0), 9.8);
    let alike = Contribution { evaluation: Evaluation::Statistics, degrees_of_freedom: 2.0, ..judged };
    let length = Contribution::judged(BudgetInput::Length, 1.0, Some(0.0), 9.81);
    let combined = |length| CombinedUncertainty::new(vec![length, alike], &[]).unwrap().degrees_of_freedom;
    assert!((combined(length) - 2.0).abs() < f64::EPSILON);
    assert!(combined(Contribution { uncertainty: Some(0.1), ..length }).is_infinite());
}

#[test]
fn nothing_uncertain_leaves_nothing_to_share() {
    let length = Contribution::judged(BudgetInput::Length, 1.0, Some(0.0), 9.81);
    let combined = CombinedUncertainty::new(vec![length], &[]).unwrap();
    for nothing in [combined.standard, combined.share(&length), combined.share_of_correlations()] {
        assert!(nothing.abs() < f64::MIN_POSITIVE, "{combined:?}");
    }
    assert!(combined.degrees_of_freedom.is_infinite());
}
