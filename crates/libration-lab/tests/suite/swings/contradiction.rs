//! Models refuted by the data: the first warning, and a part of the uncertainty of T0.

use libration::taylor::{Effort, Moment, System, integrate};
use libration_lab::fit::swings::{FittedPendulum, Warning};
use libration_lab::measurement::{Observable, Trace};
use libration_testing::sweep::{self, Limits};

use super::{SWING, analysis, changed, linear, of_length, trace};
use crate::random::Random;
use crate::synthetic_trace::{Synthetic, normal};
use libration::progress::Quiet;

/// A pendulum whose length changes: ω0² rises by the square of `ratio` within 40 s.
fn drifting(ratio: f64) -> Trace {
    let rate = (ratio * ratio - 1.0) / 40.0;
    let equation = format!("theta'' = -74.4*(1 + {rate:e}*t)*sin(theta) - 0.03*theta'");
    let system = System::new(&equation.parse().unwrap()).unwrap();
    let times: Vec<f64> = (0..2000).map(|row| 0.02 * f64::from(row)).collect();
    let start = Moment { time: 0.0, state: vec![0.4, 0.0] };
    let solution = integrate(&system, &start, &times, &Effort::to_tolerance(1e-12), &Quiet).unwrap();
    let mut random = Random::seeded(4);
    let values = solution.samples.iter().map(|sample| sample.state[0] + 0.002 * normal(&mut random));
    Trace::new("drifting", Observable::Angle, times, values.collect(), None).unwrap()
}

/// T0 falls from 0.7284 s by 2.4 %.
#[test]
fn a_period_that_drifts_is_in_the_uncertainty() {
    let fit = analysis(&[drifting(1.0246)], &linear());
    let t0 = fit.small_angle_period();
    assert!(t0.uncertainty > 0.002, "{t0}");
    assert!(matches!(fit.warnings[0], Warning::ModelRefuted(_)), "{:?}", fit.warnings);
    assert!(fit.warnings[0].to_string().contains("rejected"));
}

#[test]
fn a_contradiction_is_a_row_of_the_budget_and_never_makes_less_uncertain() {
    let scaled = changed(&trace(&SWING), |_, time, angle| (time, 1.05 * angle));
    let fit = analysis(&[scaled], &of_length(1.09, Some(0.001)));
    let FittedPendulum::Gravity { budget, .. } = &fit.pendulum else { panic!("no gravity") };
    let row = budget.rows.iter().find(|row| row.name == "model").unwrap();
    let model = fit.contradiction.as_ref().unwrap().uncertainty() / fit.small_angle_period().value;
    assert!((row.uncertainty.unwrap() / (2.0 * budget.g * model) - 1.0).abs() < 1e-3, "{row:?}");
    assert!(fit.small_angle_period().uncertainty > fit.fit.small_angle_period().uncertainty);
    let plain = analysis(&[trace(&SWING)], &of_length(1.09, Some(0.001)));
    assert_eq!(plain.contradiction, None);
    let FittedPendulum::Gravity { budget, .. } = &plain.pendulum else { panic!("no gravity") };
    assert!(budget.rows.iter().all(|row| row.name != "model"));
}

/// Angles by ± 1 to 3 % too large or too small, over a minute: |z| is at most 2.5 of at least 90 % of 60 traces of the test's own seed, and the
/// uncertainty is never below that by the rows alone. From 0.5 rad on it holds for each trace. All 31 of 300 (five seeds) beyond began below 0.4 rad: there β is uncertain
/// by more than the scale does to it, and the data do not tell one of 1 to 3 %. Limits for other seeds leave a
/// false alarm the probability 1e-6 where 90 % is true (`scipy.stats.binom.ppf(1e-6, n, 0.9)`).
#[test]
fn wrong_scales_are_in_the_uncertainty_in_a_sweep() {
    let mut random = Random::seeded(sweep::seed(0x5ca1e));
    let limits = Limits { usual: 2.0..8.5, full: 41.0..60.5, seeded: 54.0..60.5 };
    let number = sweep::number(8, 60);
    let mut near = 0;
    for draw in 0..number {
        let swing = Synthetic {
            amplitude: random.between(0.15, 1.2),
            omega0: random.between(2.0, 9.0),
            linear: random.between(0.02, 0.06),
            noise: random.between(0.0005, 0.003),
            rows: 1500,
            ..SWING
        };
        let part = random.between(0.01, 0.03) * if draw % 2 == 0 { 1.0 } else { -1.0 };
        let scaled = changed(&swing.trace(&mut random), |_, time, angle| (time, (1.0 + part) * angle));
        let fit = analysis(&[scaled], &linear());
        let z = fit.small_angle_period().deviation_from(swing.t0());
        let by_rows = fit.fit.small_angle_period();
        assert!(fit.small_angle_period().uncertainty >= by_rows.uncertainty);
        let by_rows = by_rows.deviation_from(swing.t0());
        eprintln!("{swing:?} {part:.4}: {z:.2}, by the rows alone {by_rows:.2}");
        assert!(z <= 2.5 || swing.amplitude < 0.5, "{swing:?} {part}: {z}");
        near += u32::from(z <= 2.5);
    }
    limits.check(f64::from(near), "|z| of at most 2.5");
}

/// Two runs of one pendulum, between which its length changed by half a percent.
#[test]
fn runs_that_contradict_each_other_are_in_the_uncertainty() {
    let [one, other] = [3.0, 3.0075].map(|omega0| trace(&Synthetic { omega0, ..SWING }));
    let fit = analysis(&[one, other], &linear());
    let t0 = fit.small_angle_period();
    assert!(t0.uncertainty > 0.0025 * t0.value / 3.0, "{t0}");
    assert!(matches!(fit.warnings[0], Warning::ModelRefuted(_)), "{:?}", fit.warnings);
}

#[test]
fn degrees_called_radians_are_told_first() {
    let small = Synthetic { amplitude: 0.05, noise: 1e-5, rows: 1500, ..SWING };
    let called = changed(&trace(&small), |_, time, angle| (time, angle.to_degrees()));
    let said = analysis(&[called], &linear()).warnings;
    assert!(matches!(said[0], Warning::AnglesAreDegrees { .. } | Warning::PoorFit { .. }), "{said:?}");
    assert!(said.iter().any(|warning| matches!(warning, Warning::AnglesAreDegrees { .. })), "{said:?}");
}
