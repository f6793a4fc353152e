//! The algebraic system of few harmonics: all its solutions against elimination by resultants, the accepted one
//! against the exact motion.

use std::collections::BTreeMap;

use libration::algebra::{Complex, Monomial, Polynomial, Rational, Variable};
use libration::pendulum::{Motion, Pendulum};
use libration::perturbation::{SolutionVerdict, TruncatedSolution, TruncatedSystem, TruncatedSystemError};
use libration::progress::Quiet;
use libration::quantity::Angle;
use libration_testing::golden::{Row, Table};

/// sin x = x − x³/6 + … as the coefficients of x, x², ….
fn sine(powers: u32) -> Vec<Rational> {
    let mut factorial = Rational::from(1);
    (1..=powers)
        .map(|power| {
            factorial = factorial.clone() * Rational::from(i64::from(power));
            let sign = [0, 1, 0, -1][power as usize % 4];
            Rational::from(sign).checked_div(&factorial).unwrap()
        })
        .collect()
}

/// The number of harmonics, and the degree of the sine.
fn system(harmonics: u32, degree: usize) -> TruncatedSystem {
    TruncatedSystem::new(&sine(30), harmonics, degree).unwrap()
}

fn accepted(harmonics: u32, degree: usize, amplitude: f64) -> TruncatedSolution {
    let solutions = system(harmonics, degree).solutions(amplitude, &Quiet).unwrap();
    let accepted: Vec<_> =
        solutions.into_iter().filter(|solution| solution.verdict == SolutionVerdict::Accepted).collect();
    assert_eq!(accepted.len(), 1, "{harmonics} harmonics at {amplitude}");
    accepted[0].clone()
}

fn exact(amplitude: f64) -> Motion {
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    pendulum.released_from(Angle::from_radians(amplitude).unwrap()).unwrap()
}

fn coordinates(solution: &TruncatedSolution) -> Vec<Complex> {
    [&solution.amplitudes[..], &[solution.frequency_ratio_squared]].concat()
}

fn golden_coordinates(row: Row<'_>, harmonics: usize) -> Vec<Complex> {
    let number =
        |name: &str| Complex::new(row.input(&format!("{name}_re")), row.input(&format!("{name}_im")));
    [&["a1", "a3", "a5"][..harmonics], &["squared"]].concat().into_iter().map(number).collect()
}

fn distance(a: &[Complex], b: &[Complex]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (*a - *b).abs()).fold(0.0, f64::max)
}

#[test]
fn all_solutions_are_those_of_elimination() {
    let table = Table::read("truncated_system.csv");
    let mut cases = BTreeMap::<_, Vec<Row<'_>>>::new();
    for row in table.rows() {
        let case = (row.text("harmonics"), row.text("degree"), row.text("amplitude"));
        cases.entry(case).or_default().push(row);
    }
    assert_eq!(cases.len(), 6);
    for ((harmonics, degree, amplitude), rows) in cases {
        let harmonics: u32 = harmonics.parse().unwrap();
        let system = system(harmonics, degree.parse().unwrap());
        let solutions = system.solutions(amplitude.parse().unwrap(), &Quiet).unwrap();
        assert_eq!(rows.len() as u64, system.number_of_solutions());
        assert_eq!(rows.len(), solutions.len());
        for row in rows {
            let golden = golden_coordinates(row, harmonics as usize);
            let nearest = solutions
                .iter()
                .map(|solution| distance(&coordinates(solution), &golden))
                .fold(f64::MAX, f64::min);
            // Newton's method stops at rounding errors, which the worst conditioned solution multiplies by 1e3.
            assert!(nearest < 1e-12, "{golden:?} is {nearest:e} away");
        }
    }
}

#[test]
fn four_harmonics_have_four_hundred_solutions_in_conjugate_pairs() {
    let solutions = system(4, 7).solutions(1.0, &Quiet).unwrap();
    assert_eq!(solutions.len(), 1 + 7 + 49 + 343);
    for solution in &solutions {
        let conjugate: Vec<_> = coordinates(solution).iter().map(|z| Complex::new(z.re, -z.im)).collect();
        let nearest = solutions
            .iter()
            .map(|solution| distance(&coordinates(solution), &conjugate))
            .fold(f64::MAX, f64::min);
        assert!(nearest < 1e-9, "{nearest:e}");
    }
}

/// The degree of the sine and the number of harmonics grow together as in the publication.
#[test]
fn the_accepted_solution_approaches_the_exact_motion() {
    for (amplitude, last) in [(40_f64, 1e-7), (90.0, 1e-4), (170.0, 0.1)] {
        let amplitude = amplitude.to_radians();
        let truth = exact(amplitude);
        let errors: Vec<f64> = [(2, 3), (3, 5), (4, 7)]
            .into_iter()
            // At 170 degrees the sine cut off after x³ does not pull back any more.
            .filter(|(_, degree)| amplitude < 2.0 || *degree > 3)
            .map(|(harmonics, degree)| {
                let solution = accepted(harmonics, degree, amplitude);
                let ratio = solution.frequency_ratio_squared.re.sqrt();
                (ratio - std::f64::consts::TAU / truth.period()).abs()
            })
            .collect();
        assert!(errors.windows(2).all(|pair| pair[1] < pair[0]), "{errors:?}");
        assert!(errors[errors.len() - 1] < last, "{errors:?}");
    }
}

#[test]
fn harmonics_of_the_accepted_solution_are_those_of_the_motion() {
    let amplitude = 40_f64.to_radians();
    let solution = accepted(4, 7, amplitude);
    let truth = exact(amplitude).harmonics(1e-12, 4);
    for (amplitude, term) in solution.amplitudes.iter().zip(truth.terms) {
        assert!((amplitude.re - term.angle).abs() < 1e-8, "harmonic {}", term.n);
    }
}

#[test]
fn among_real_solutions_the_accepted_one_has_the_smallest_residual() {
    for amplitude in [0.1, 1.0, 2.0] {
        let solutions = system(3, 5).solutions(amplitude, &Quiet).unwrap();
        let smallest = solutions.iter().min_by(|a, b| a.residual.total_cmp(&b.residual)).unwrap();
        assert_eq!(smallest.verdict, SolutionVerdict::Accepted);
    }
}

/// The cubic sine turns round at √6 and pulls away beyond: no small oscillation continues to 170°.
#[test]
fn beyond_the_reach_of_the_cubic_force_nothing_is_accepted() {
    let solutions = system(2, 3).solutions(170_f64.to_radians(), &Quiet).unwrap();
    assert!(solutions.iter().all(|solution| solution.verdict != SolutionVerdict::Accepted));
    assert_eq!(solutions.len(), 4);
}

#[test]
fn pure_overtones_are_recognised() {
    let solutions = system(3, 5).solutions(0.5, &Quiet).unwrap();
    let overtones: Vec<_> =
        solutions.iter().filter(|solution| solution.verdict == SolutionVerdict::Overtone).collect();
    assert_eq!(overtones.len(), 2);
    for overtone in overtones {
        // x = θ0 cos nΩt: the frequency nΩ is that of one harmonic.
        let n = if overtone.amplitudes[1].abs() > 0.4 { 3.0 } else { 5.0 };
        let alone = accepted(1, 5, 0.5).frequency_ratio_squared.re;
        assert!((overtone.frequency_ratio_squared.re * n * n - alone).abs() < 1e-12);
    }
}

/// The conditions, exact, vanish at the solutions, found in numbers by another way of projecting.
#[test]
fn the_conditions_vanish_at_the_solutions() {
    let system = system(3, 5);
    for solution in system.solutions(1.25, &Quiet).unwrap() {
        for condition in system.conditions() {
            let largest = coordinates(&solution).iter().map(|z| z.abs()).fold(1.0, f64::max);
            let size: f64 = condition.terms().map(|(_, factor)| factor.to_f64().abs()).sum();
            let value = value_at(&condition, &solution).abs();
            assert!(value <= 1e-14 * size * libm::pow(largest, 5.0), "{value:e}");
        }
    }
}

fn value_at(polynomial: &Polynomial, solution: &TruncatedSolution) -> Complex {
    let power = |(variable, exponent): &(Variable, u32)| match variable.index() {
        Some(n) => solution.amplitudes[n as usize / 2].powi(*exponent),
        None => solution.frequency_ratio_squared.powi(exponent / 2),
    };
    let term = |(monomial, factor): (&Monomial, &Rational)| {
        let powers = monomial.factors().iter().map(power);
        powers.fold(Complex::from(factor.to_f64()), |product, power| product * power)
    };
    polynomial.terms().map(term).sum()
}

/// (22) and (23) of Black and Vel.
#[test]
fn the_conditions_are_the_published_ones() {
    let conditions: Vec<String> = system(2, 3).conditions().iter().map(ToString::to_string).collect();
    assert_eq!(
        conditions,
        ["-8 + a1^2 + a1*a3 + 2*a3^2 + 8*Delta^2", "-24*a3 + a1^3 + 6*a1^2*a3 + 3*a3^3 + 216*a3*Delta^2"]
    );
}

#[test]
fn other_units_of_x_change_nothing() {
    // x = y/1000.
    let scaled: Vec<Rational> = ["1", "0", "-1000000/6"].map(|text| text.parse().unwrap()).into();
    let solutions = TruncatedSystem::new(&scaled, 2, 3).unwrap().solutions(1e-3, &Quiet).unwrap();
    let plain = TruncatedSystem::new(&sine(3), 2, 3).unwrap().solutions(1.0, &Quiet).unwrap();
    for (a, b) in solutions.iter().zip(&plain) {
        assert_eq!(a.verdict, b.verdict);
        assert!((a.frequency_ratio_squared - b.frequency_ratio_squared).abs() < 1e-12);
        assert!((a.amplitudes[1].scaled(1e3) - b.amplitudes[1]).abs() < 1e-12);
    }
}

#[test]
fn what_cannot_be_solved_is_refused() {
    let new = |force: &[&str], harmonics, degree| {
        let force: Vec<Rational> = force.iter().map(|text| text.parse().unwrap()).collect();
        TruncatedSystem::new(&force, harmonics, degree).map(|_| ())
    };
    assert_eq!(new(&["1", "0", "1"], 0, 3), Err(TruncatedSystemError::Size { harmonics: 0, degree: 3 }));
    assert_eq!(new(&["1", "0", "1"], 80, 3), Err(TruncatedSystemError::Size { harmonics: 80, degree: 3 }));
    assert_eq!(new(&["1", "0", "1"], 2, 2), Err(TruncatedSystemError::Linear { degree: 2 }));
    assert_eq!(new(&["1", "1", "1"], 2, 3), Err(TruncatedSystemError::EvenTerm { power: 2 }));
    assert_eq!(new(&["0", "0", "1"], 2, 3), Err(TruncatedSystemError::NotRestoring));
    for amplitude in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = system(2, 3).solutions(amplitude, &Quiet).unwrap_err();
        assert!(matches!(error, TruncatedSystemError::Amplitude { .. }));
    }
}

#[test]
fn absurd_amplitudes_do_no_harm() {
    for amplitude in [1e-300, 1e-20, 1e6, 1e200, f64::MAX] {
        let _ = system(2, 3).solutions(amplitude, &Quiet);
    }
}

/// The mean over a thousand phases of the whole period; the sine of degree 5 makes harmonics up to 30 in the square. Source of the last digits of
/// two of them: a sum of squares in Python, 0.566 and 0.839 at 1 rad.
#[test]
fn residuals_are_the_root_mean_square_over_the_period() {
    for (powers, degree, amplitude) in [(3, 3, 1.0), (3, 3, 0.75), (5, 3, 1.0), (9, 5, 1.5), (30, 3, 2.0)] {
        let force = sine(powers);
        let system = TruncatedSystem::new(&force, 2, degree).unwrap();
        for solution in system.solutions(amplitude, &Quiet).unwrap() {
            let square = |j: u32| {
                let phase = std::f64::consts::TAU * f64::from(j) / 1000.0;
                let (mut x, mut acceleration) = (Complex::default(), Complex::default());
                for (n, a) in [1.0, 3.0].into_iter().zip(&solution.amplitudes) {
                    x = x + a.scaled(libm::cos(n * phase));
                    acceleration = acceleration + a.scaled(-n * n * libm::cos(n * phase));
                }
                let zero = Complex::default();
                let restoring = force.iter().rev().fold(zero, |sum, c| (sum + Complex::from(c.to_f64())) * x);
                let left = (solution.frequency_ratio_squared * acceleration + restoring).abs();
                left * left
            };
            let expected = ((0..1000).map(square).sum::<f64>() / 1000.0).sqrt();
            let difference = (solution.residual - expected).abs();
            assert!(difference <= 1e-12 * expected, "{powers} {degree}: {solution:?} {expected}");
        }
    }
}
