//! The catalogues use the same words for the same things.

use libration::oscillator::NamedOscillator;
use libration::pendulum::ApproximateMotion;
use libration::period_formulas::{MOST_TERMS, PeriodFormula};
use libration::systems::NamedSystem;

#[test]
fn every_catalogue_refuses_in_the_same_words() {
    let refusals = [
        NamedOscillator::by_key("pendulem").map(|entry| entry.key).unwrap_err(),
        NamedSystem::by_key("pendulem").map(|entry| entry.key).unwrap_err(),
        PeriodFormula::by_key("pendulem").map(|formula| formula.key().to_owned()).unwrap_err(),
        ApproximateMotion::by_key("pendulem").map(|motion| motion.key()).unwrap_err(),
    ];
    for refusal in refusals {
        let keys = refusal.known.join(", ");
        let beginning = format!(
            "no {} has the key `pendulem`; the nearest are {}; the keys are {keys}",
            refusal.kind,
            refusal.near.join(", ")
        );
        assert!(refusal.near.len() == 3 && refusal.to_string().starts_with(&beginning), "{refusal}");
    }
}

#[test]
fn the_formulas_that_are_not_listed_are_named() {
    let refusal =
        PeriodFormula::by_key("power").map(|formula| formula.key().to_owned()).unwrap_err().to_string();
    assert!(refusal.contains(&format!("up to {MOST_TERMS} corrections")), "{refusal}");
}
