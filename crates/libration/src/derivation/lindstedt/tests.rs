//! A motion that is no solution is not taken for one.

use super::motion::motion;
use super::question::Question;
use super::substitution::{has_harmonics, solves};
use crate::algebra::Rational;
use crate::oscillator::NamedOscillator;
use crate::perturbation::Gauge;

fn question(key: &str, order: usize) -> Question {
    let oscillator = NamedOscillator::by_key(key).unwrap().oscillator(&[]).unwrap();
    Question::new(&oscillator, order, &Gauge::Fundamental).unwrap()
}

#[test]
fn every_single_coefficient_matters_to_the_equation_of_motion() {
    for (key, order) in [("pendulum", 5), ("quadratic", 4)] {
        let question = question(key, order);
        let right = motion(&question, &question.solution);
        assert!(solves(&question, &right).is_ok());
        for (place, (k, series)) in right.harmonics.iter().enumerate() {
            for n in (0..series.len()).filter(|n| *k != 1 || *n == 0) {
                let mut wrong = motion(&question, &question.solution);
                wrong.harmonics[place].1[n] = series[n].clone() + Rational::new(1, 1_000_000).unwrap();
                assert!(solves(&question, &wrong).is_err(), "{key} {k} {n}");
            }
        }
        for n in 0..order {
            let mut wrong = motion(&question, &question.solution);
            wrong.frequency[n] = wrong.frequency[n].clone() + Rational::new(1, 1_000_000).unwrap();
            assert!(solves(&question, &wrong).is_err(), "{key} frequency {n}");
        }
    }
}

#[test]
fn wrong_harmonics_of_the_residual_are_noticed() {
    let question = question("pendulum", 3);
    let right = motion(&question, &question.solution);
    assert!(has_harmonics(&question, &right, 3, &[]).is_ok());
    assert!(has_harmonics(&question, &right, 3, &[(3, Rational::from(1))]).is_err());
}
