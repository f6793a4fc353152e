//! Cycles of traces with known truth: made by the integrator, with noise, quantised, sampled coarsely, with outliers and gaps.

use libration::pendulum::Pendulum;
use libration::progress::{Interrupted, Quiet, Status};
use libration_lab::fit::MistakenUnit;
use libration_lab::fit::cycles::{
    Cycle, Cycles, CyclesError, CyclesOptions, CyclesWarning, beta_of_traces, beyond_a_turn, fit_cycles,
    mistaken_unit,
};
use libration_lab::fit::trace::DampingKind;
use libration_lab::measurement::{Observable, Trace};

use crate::random::Random;
use crate::synthetic_trace::Synthetic;
use libration_testing::sweep::{self, Limits};
use std::cell::Cell;
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

const DEGREE: f64 = PI / 180.0;

fn found_in(trace: &Trace) -> Cycles {
    fit_cycles(trace, &CyclesOptions::default(), &Quiet).unwrap()
}

fn of(synthetic: &Synthetic, seed: u64) -> Cycles {
    found_in(&synthetic.trace(&mut Random::seeded(seed)))
}

fn refused(trace: &Trace) -> CyclesError {
    fit_cycles(trace, &CyclesOptions::default(), &Quiet).unwrap_err()
}

/// Without noise the remaining errors are the bias of the local fits, and the second-order effect of damping on the period.
#[test]
fn without_noise_every_cycle_obeys_the_exact_law() {
    let cases = [
        Synthetic::USUAL,
        Synthetic { amplitude: 100.0 * DEGREE, linear: 0.05, ..Synthetic::USUAL },
        Synthetic { amplitude: 0.1, dry: 0.003, linear: 0.0, ..Synthetic::USUAL },
        Synthetic { quadratic: 0.05, linear: 0.0, offset: 0.3, ..Synthetic::USUAL },
        // 25 rows in a period.
        Synthetic { step: 0.083, rows: 480, ..Synthetic::USUAL },
        // 12 rows in a period.
        Synthetic { step: 0.175, rows: 240, ..Synthetic::USUAL },
        Synthetic { observable: Observable::AngularVelocity, offset: 0.05, ..Synthetic::USUAL },
        Synthetic { observable: Observable::AngularVelocity, amplitude: 2.2, ..Synthetic::USUAL },
    ];
    for case in cases {
        let cycles = of(&case, 1);
        let worst = cycles.small_angle_periods().map(|t0| (t0 / case.t0() - 1.0).abs()).fold(0.0, f64::max);
        assert!(worst < 3e-4, "{case:?}: {worst:e}");
        assert!((cycles.t0.value / case.t0() - 1.0).abs() < 5e-5, "{case:?}: {}", cycles.t0);
        assert!((cycles.offset.value - case.offset).abs() < 3e-4, "{case:?}: {}", cycles.offset);
    }
}

/// Sums of squares of errors over their stated uncertainties, of T0 and of β, over a number of traces.
fn pulls(case: &Synthetic, traces: u64, first_seed: u64) -> [f64; 2] {
    let mut squares = [0.0; 2];
    for draw in 0..traces {
        let cycles = of(case, first_seed.wrapping_add(draw));
        let beta = cycles.beta.unwrap();
        let errors = [
            (cycles.t0.value - case.t0()) / cycles.t0.uncertainty,
            (beta.factor.value - 1.0) / beta.factor.uncertainty,
        ];
        for (square, error) in squares.iter_mut().zip(errors) {
            *square += error * error;
        }
    }
    squares
}

/// Sums of squares of 12 pulls of a case in the default run and of 60 in the full one, and of five cases together. What damping does in second
/// order and noise in the amplitudes are not in the uncertainties, so that the hypothesis is a mean square between 0.75 and 1.3, of which
/// 600 pulls gave 0.87. A false alarm has the probability 1e-6, as each of 24 tails has 4.2e-8: `0.75*scipy.stats.chi2.ppf(1e-6/24, n)` and
/// `1.3*scipy.stats.chi2.isf(1e-6/24, n)`. Those of the test's own seed have kept between root mean squares of 0.7 and 1.35.
#[test]
fn errors_are_as_large_as_their_uncertainties_in_a_sweep() {
    let one = Limits { usual: 0.27..76.1, full: 13.7..179.7, seeded: 29.4..109.3 };
    let five = Limits { usual: 13.7..179.7, full: 139.9..585.4, seeded: 139.9..585.4 };
    let (number, seed) = (sweep::number(12, 60), sweep::seed(0));
    let cases = [
        Synthetic { noise: 0.002, linear: 0.01, ..Synthetic::USUAL },
        Synthetic { noise: 0.005, step: 0.083, rows: 480, ..Synthetic::USUAL },
        Synthetic { noise: 0.005, step: 0.175, rows: 240, ..Synthetic::USUAL },
        Synthetic { noise: 0.003, amplitude: 2.4, ..Synthetic::USUAL },
        Synthetic { noise: 0.01, offset: 0.02, observable: Observable::AngularVelocity, ..Synthetic::USUAL },
    ];
    let mut all = [0.0; 2];
    for (index, case) in (0..).zip(cases) {
        let pulls = pulls(&case, number, seed.wrapping_add(1000 * index));
        for (of, squares) in pulls.into_iter().enumerate() {
            one.check(squares, &format!("{} of {case:?}", ["T0", "beta"][of]));
            all[of] += squares;
        }
    }
    for (of, squares) in all.into_iter().enumerate() {
        five.check(squares, &format!("{} together", ["T0", "beta"][of]));
    }
}

/// An encoder of 4000 counts to the turn, 200 Hz: as a real one of a laboratory.
#[test]
fn counts_of_an_encoder_give_the_period_to_a_part_in_ten_thousand() {
    let quantum = 360.0 * DEGREE / 4000.0;
    let case =
        Synthetic { quantum, step: 0.005, rows: 3000, amplitude: 1.9, linear: 0.04, ..Synthetic::USUAL };
    let cycles = of(&case, 1);
    assert!((cycles.t0.value / case.t0() - 1.0).abs() < 1e-4, "{}", cycles.t0);
    // Rounding leaves an error of quantum/√12.
    assert!((cycles.noise / (quantum / 12.0_f64.sqrt()) - 1.0).abs() < 0.2, "{}", cycles.noise);
    let beta = cycles.beta.unwrap();
    assert!((beta.factor.value - 1.0).abs() < 0.005, "{beta:?}");
}

/// A trace with some of its rows changed or left out.
fn changed(trace: &Trace, value: impl Fn(usize, f64) -> Option<f64>) -> Trace {
    let rows =
        (0..trace.len()).filter_map(|row| Some((trace.times()[row], value(row, trace.values()[row])?)));
    let (times, values) = rows.unzip();
    Trace::new("changed", trace.observable(), times, values, None).unwrap()
}

#[test]
fn stray_values_and_dropped_frames_hardly_matter() {
    let case = Synthetic { noise: 0.002, ..Synthetic::USUAL };
    let trace = case.trace(&mut Random::seeded(5));
    let clean = found_in(&trace);
    let spoilt = changed(&trace, |row, value| match row % 97 {
        13 => Some(value + 0.8),
        50..53 => None,
        _ => Some(value),
    });
    let spoilt = found_in(&spoilt);
    assert_eq!(spoilt.cycles.len(), clean.cycles.len());
    assert!(
        (spoilt.t0.value - clean.t0.value).abs() < 2.0 * clean.t0.uncertainty,
        "{} {}",
        spoilt.t0,
        clean.t0
    );
    assert!((spoilt.noise / clean.noise - 1.0).abs() < 0.15, "{} {}", spoilt.noise, clean.noise);
}

#[test]
fn a_gap_costs_its_cycles_and_is_said() {
    let trace = Synthetic { noise: 0.001, ..Synthetic::USUAL }.trace(&mut Random::seeded(2));
    let whole = found_in(&trace);
    let gap = found_in(&changed(&trace, |row, value| (!(900..1000).contains(&row)).then_some(value)));
    assert!(gap.cycles.len() < whole.cycles.len() && gap.cycles.len() > whole.cycles.len() - 8);
    assert!((gap.t0.value - whole.t0.value).abs() < 4.0 * whole.t0.uncertainty);
    assert!(matches!(gap.warnings[..], [CyclesWarning::FarFromTheLaw { cycles: 1.. }]), "{:?}", gap.warnings);
    assert_eq!(whole.warnings, []);
}

#[test]
fn a_centre_that_drifts_is_followed() {
    let case = Synthetic { noise: 0.001, ..Synthetic::USUAL };
    let trace = case.trace(&mut Random::seeded(3));
    let tilted = changed(&trace, |row, value| Some(value + 0.05 * trace.times()[row] / 40.0));
    let cycles = found_in(&tilted);
    assert!(cycles.offset_wander > 0.005, "{}", cycles.offset_wander);
    assert!((cycles.t0.value / case.t0() - 1.0).abs() < 1e-4, "{}", cycles.t0);
}

#[test]
fn swings_over_the_top_are_left_out_and_said() {
    // Three turns or so, and then to and fro.
    let case = Synthetic { amplitude: 0.0, velocity: 13.0, linear: 0.12, ..Synthetic::USUAL };
    let cycles = of(&case, 1);
    assert!(cycles.cycles.len() > 20, "{}", cycles.cycles.len());
    let turns = cycles.offset.value / TAU;
    assert!(turns > 0.5 && (turns - libm::round(turns)).abs() < 1e-3, "{turns}");
    assert!((cycles.t0.value / case.t0() - 1.0).abs() < 1e-3, "{}", cycles.t0);
}

#[test]
fn the_envelope_tells_the_damping() {
    let base = Synthetic { linear: 0.0, noise: 0.002, ..Synthetic::USUAL };
    for (term, case) in [
        (DampingKind::Dry, Synthetic { dry: 0.05, ..base }),
        (DampingKind::Linear, Synthetic { linear: 0.05, ..base }),
        (DampingKind::Quadratic, Synthetic { quadratic: 0.08, ..base }),
    ] {
        let envelope = of(&case, 4).envelope.unwrap();
        let preferred = envelope.preferred();
        assert!(preferred.damping.has(term), "{}", envelope.verdict());
        // The law with this damping alone, whatever others cannot be told from it.
        let alone =
            envelope.fits.iter().find(|fit| fit.damping.count() == 1 && fit.damping.has(term)).unwrap();
        let truth = [case.dry, case.linear, case.quadratic].into_iter().fold(0.0, f64::max);
        let coefficient = alone.coefficients[0];
        assert!(
            (coefficient.estimate.value - truth).abs() < 4.0 * coefficient.estimate.uncertainty,
            "{coefficient:?}"
        );
        assert!(coefficient.estimate.uncertainty < 0.05 * truth, "{coefficient:?}");
        let wrong = envelope.fits.iter().filter(|fit| fit.damping.count() == 1 && !fit.damping.has(term));
        assert!(wrong.clone().all(|fit| fit.aicc_difference > 10.0), "{:?}", wrong.collect::<Vec<_>>());
    }
}

#[test]
fn a_short_trace_cannot_separate_the_laws_of_damping() {
    let case = Synthetic { noise: 0.01, rows: 700, linear: 0.01, ..Synthetic::USUAL };
    let envelope = of(&case, 6).envelope.unwrap();
    assert!(envelope.not_separated().count() >= 2, "{}", envelope.verdict());
    assert!(envelope.verdict().contains("cannot be distinguished"));
}

#[test]
fn what_has_no_cycles_is_refused_kindly() {
    let short = Synthetic { rows: 80, ..Synthetic::USUAL }.trace(&mut Random::seeded(1));
    assert!(matches!(refused(&short), CyclesError::TooShort { .. }), "{}", refused(&short));
    let coarse = Synthetic { step: 0.4, rows: 60, ..Synthetic::USUAL }.trace(&mut Random::seeded(1));
    assert!(matches!(refused(&coarse), CyclesError::TooCoarse { .. }), "{}", refused(&coarse));
    let turning = Synthetic { amplitude: 0.0, velocity: 13.0, rows: 300, ..Synthetic::USUAL };
    let turning = turning.trace(&mut Random::seeded(1));
    assert_eq!(refused(&turning), CyclesError::OnlyRotations);
    let resting = changed(&short, |_, _| Some(0.25));
    assert_eq!(refused(&resting), CyclesError::NothingSwings(0.25));
}

/// T/T0 then changes only by the noise of the amplitudes, and a straight line through it would give β = 0.
#[test]
fn amplitudes_that_only_scatter_leave_beta_open() {
    let steady = Synthetic { linear: 0.0, noise: 0.003, ..Synthetic::USUAL };
    for seed in 0..8 {
        let refusal = of(&steady, seed).beta.unwrap_err();
        let CyclesError::NoisyAmplitudes { noise_part } = refusal else { panic!("{refusal}") };
        assert!((0.3..3.0).contains(&noise_part), "{noise_part}");
        assert!(refusal.to_string().contains("record until the amplitude has fallen"), "{refusal}");
    }
    let falling = of(&Synthetic { linear: 0.02, ..steady }, 1);
    assert!(falling.beta.is_ok());
    // Two steady traces of the same amplitude are as little use as one.
    let traces = [1, 2].map(|seed| steady.trace(&mut Random::seeded(seed)));
    let cycles = traces.each_ref().map(|trace| fit_cycles(trace, &CyclesOptions::default(), &Quiet));
    let refusal = beta_of_traces(&traces, &cycles, &Quiet).unwrap_err();
    assert!(matches!(refusal, CyclesError::NoisyAmplitudes { .. }), "{refusal}");
}

#[test]
fn a_tail_at_rest_is_left_out_and_said() {
    let base = Synthetic { amplitude: 0.6, rows: 4000, ..Synthetic::USUAL };
    for case in [
        Synthetic { linear: 0.3, noise: 0.002, ..base },
        Synthetic { linear: 0.3, noise: 0.002, rows: 20_000, ..base },
        Synthetic { linear: 0.2, dry: 0.05, noise: 0.002, ..base },
        Synthetic { linear: 0.3, noise: 0.002, offset: 0.2, observable: Observable::AngularVelocity, ..base },
    ] {
        let cycles = of(&case, 3);
        assert!(cycles.cycles.len() >= 8, "{}: {case:?}", cycles.cycles.len());
        assert!((cycles.t0.value / case.t0() - 1.0).abs() < 3e-3, "{}: {case:?}", cycles.t0);
        // Dry friction ends the last swing all at once, before it is lost.
        let is_said =
            cycles.warnings.iter().any(|warning| matches!(warning, CyclesWarning::LostInNoise { .. }));
        assert_eq!(is_said, case.dry <= 0.0, "{:?}", cycles.warnings);
    }
    // With noise as large the swing goes on to the end.
    let swinging = of(&Synthetic { noise: 0.01, ..Synthetic::USUAL }, 3);
    assert!(swinging.warnings.is_empty(), "{:?}", swinging.warnings);
}

#[test]
fn refusals_count_in_singular_and_plural() {
    let said = |turning_points| CyclesError::TooShort { turning_points }.to_string();
    assert!(said(1).contains("shows 1 turning point between"), "{}", said(1));
    assert!(said(0).contains("shows 0 turning points between"), "{}", said(0));
    assert!(said(462).contains("but no full cycle that can be measured"), "{}", said(462));
    let cycles = CyclesError::EqualAmplitudes { cycles: 1 }.to_string();
    assert!(cycles.starts_with("1 cycle of"), "{cycles}");
}

/// Swings of an undamped pendulum, or of an oscillation with a constant period, without errors of measurement.
fn exact(amplitude: f64, step: f64, seconds: f64, value: impl Fn(f64) -> f64) -> Trace {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousand rows")]
    let rows = (seconds / step) as u32;
    let times: Vec<f64> = (0..rows).map(|row| step * f64::from(row)).collect();
    let values = times.iter().map(|&time| amplitude * value(time)).collect();
    Trace::new("exact", Observable::Angle, times, values, None).unwrap()
}

#[test]
fn exact_swings_have_cycles_however_they_are_sampled_in_a_sweep() {
    let (amplitudes, steps) =
        ([10.0, 20.0, 40.0, 60.0, 75.0, 80.0, 120.0], [0.01, 0.02, 0.025, 1.0 / 30.0, 0.04, 0.05, 0.1]);
    let cases = amplitudes.into_iter().flat_map(|degrees| {
        steps.into_iter().flat_map(move |step| [10.0, 20.0, 60.0].map(|seconds| (degrees, step, seconds)))
    });
    let mut failures = vec![];
    // Eleven has no factor in common with the numbers of amplitudes, steps and lengths, so that each of them comes.
    for (degrees, step, seconds) in sweep::part(cases, 11) {
        let pendulum = Pendulum::from_angular_frequency(TAU / 1.5).unwrap();
        let motion = pendulum.released_from(format!("{degrees}deg").parse().unwrap()).unwrap();
        let swing = exact(1.0, step, seconds, |time| motion.state_at(time).angle);
        let cosine = exact(degrees * DEGREE, step, seconds, |time| libm::cos(TAU / 1.5 * time));
        for (name, trace) in [("swing", swing), ("cosine", cosine)] {
            match fit_cycles(&trace, &CyclesOptions::default(), &Quiet) {
                Ok(cycles) if cycles.cycles.len() > 4 => {}
                other => failures.push(format!(
                    "{name} {degrees} {step} {seconds}: {:?}",
                    other.map(|other| other.cycles.len())
                )),
            }
        }
    }
    assert!(failures.is_empty(), "{}\n{}", failures.len(), failures.join("\n"));
}

/// A pendulum whose cycles vary by more than the noise of its values explains: a string that slips, or frames at irregular
/// times.
#[test]
fn cycles_scatter_by_their_stated_uncertainties() {
    let steady = Synthetic { noise: 0.001, ..Synthetic::USUAL };
    for [jitter, least, most] in [[0.0, 0.8, 1.25], [0.004, 0.8, 1.25], [0.02, 0.8, 1.25]] {
        let mut random = Random::seeded(41);
        let trace = steady.trace(&mut random);
        // Time itself goes slower or faster from half second to half second.
        let mut clock = 0.0;
        let mut rate = 1.0;
        let mut before = trace.times()[0];
        let times: Vec<f64> = trace
            .times()
            .iter()
            .enumerate()
            .map(|(row, &time)| {
                if row % 50 == 0 {
                    rate = 1.0 + jitter * random.normal();
                }
                clock += rate * (time - before);
                before = time;
                clock
            })
            .collect();
        let trace = Trace::new("jitter", Observable::Angle, times, trace.values().to_vec(), None).unwrap();
        let cycles = found_in(&trace);
        let kept: Vec<_> = cycles.cycles.iter().filter(|cycle| !cycle.outlier).collect();
        let pulls = kept.iter().map(|cycle| {
            let pull = (cycle.period.value / cycle.period_ratio - cycles.t0.value)
                / (cycle.period.uncertainty / cycle.period_ratio);
            pull * pull
        });
        #[expect(clippy::cast_precision_loss, reason = "some dozen")]
        let pull = (pulls.sum::<f64>() / kept.len() as f64).sqrt();
        assert!((least..most).contains(&pull), "{jitter}: {pull} {:?}", cycles.chi2_per_dof);
    }
}

/// χ² per degree of freedom of the cycles about the exact law, by their own bars.
fn chi2_by_the_bars(cycles: &Cycles) -> f64 {
    let kept: Vec<_> = cycles.cycles.iter().filter(|cycle| !cycle.outlier).collect();
    let pull = |cycle: &Cycle| {
        (cycle.period.value - cycles.t0.value * cycle.period_ratio) / cycle.period.uncertainty
    };
    let squares: f64 = kept.iter().map(|cycle| pull(cycle) * pull(cycle)).sum();
    #[expect(clippy::cast_precision_loss, reason = "some dozen")]
    let dof = kept.len() as f64 - 1.0;
    squares / dof
}

/// The trace with noise of standard deviation 0.003 rad added, each value of which is `memory` times the one before and a fresh part.
fn with_memory(trace: &Trace, memory: f64, random: &mut Random) -> Trace {
    let fresh = 0.003 * (1.0 - memory * memory).sqrt();
    let mut error = 0.003 * random.normal();
    let mut errors = vec![];
    for _ in 0..trace.len() {
        error = memory * error + fresh * random.normal();
        errors.push(error);
    }
    changed(trace, |row, value| Some(value + errors[row]))
}

/// About 38 cycles that share passages: χ² per degree of freedom of one trace scatters by about 0.25, and the uncertainties are enlarged
/// where it is above 1.
#[test]
fn bars_of_cycles_heed_noise_that_remembers_in_a_sweep() {
    let exact = Synthetic { linear: 0.01, ..Synthetic::USUAL }.trace(&mut Random::seeded(0));
    for memory in [0.0, 0.5, 0.8, 0.95] {
        let (mut mean, mut t0) = (0.0, 0.0);
        let traces = sweep::number(3_u16, 10);
        for seed in 0..traces {
            let cycles = found_in(&with_memory(&exact, memory, &mut Random::seeded(u64::from(seed))));
            let chi2 = chi2_by_the_bars(&cycles);
            assert!((0.4..2.0).contains(&chi2), "{memory} {seed}: {chi2}");
            let pull = (cycles.t0.value - Synthetic::USUAL.t0()) / cycles.t0.uncertainty;
            let weight = 1.0 / f64::from(traces);
            (mean, t0) = (mean + weight * chi2, t0 + weight * pull * pull);
        }
        Limits { usual: 0.5..1.5, full: 0.6..1.4, seeded: 0.75..1.25 }
            .check(mean, &format!("chi² with {memory}"));
        // The mean square of three pulls is above 4.3 in one of two hundred, of ten above 2.5.
        Limits { usual: 0.0..4.3, full: 0.0..2.5, seeded: 0.0..2.5 }.check(t0, &format!("T0 with {memory}"));
    }
}

/// Angles on a wrong scale for a long time: no cycle is far from the law, but all depart from it together, opposite to the
/// noise of passages, whose size was found ten times too large.
#[test]
fn bars_of_cycles_are_not_those_of_a_slow_departure_from_the_law() {
    for (seed, scale) in [(1, 0.9), (2, 0.95), (3, 1.08)] {
        let case = Synthetic { rows: 8000, linear: 0.015, noise: 0.002, ..Synthetic::USUAL };
        let trace = changed(&case.trace(&mut Random::seeded(seed)), |_, value| Some(scale * value));
        let cycles = found_in(&trace);
        let chi2 = chi2_by_the_bars(&cycles);
        assert!((0.8..1.3).contains(&chi2), "{scale}: {chi2}, by the noise {:?}", cycles.chi2_per_dof);
    }
}

#[test]
fn radians_that_are_called_degrees_are_recognised() {
    let right = Synthetic { noise: 0.002, amplitude: 0.8, ..Synthetic::USUAL }.trace(&mut Random::seeded(7));
    let cycles = found_in(&right);
    assert!(mistaken_unit(cycles.beta.unwrap().factor.value, cycles.cycles.iter()).is_none());
    let called = found_in(&changed(&right, |_, value| Some(value * DEGREE)));
    let beta = called.beta.unwrap().factor.value;
    // (180/π)² and what the next terms of the series add at 46°.
    assert!((3283.0..3800.0).contains(&beta), "{beta}");
    assert_eq!(mistaken_unit(beta, called.cycles.iter()), Some(MistakenUnit::Radians));
    // Angles that are too small by another factor are no radians.
    let other = found_in(&changed(&right, |_, value| Some(value / 40.0)));
    assert!(mistaken_unit(other.beta.unwrap().factor.value, other.cycles.iter()).is_none());
}

#[test]
fn angles_beyond_a_turn_are_told_from_swings_over_the_top() {
    let over = Synthetic { amplitude: 0.0, velocity: 13.0, linear: 0.12, noise: 0.01, ..Synthetic::USUAL };
    assert_eq!(beyond_a_turn(&over.trace(&mut Random::seeded(1))), None);
    let swing = Synthetic { noise: 0.01, ..Synthetic::USUAL }.trace(&mut Random::seeded(1));
    assert_eq!(beyond_a_turn(&swing), None);
    // Just below and just above 1.1 turns from side to side; the bound heeds the noise of the extremes.
    let span = |factor: f64| changed(&swing, |_, value| Some(value * factor));
    let [low, high] = [0.9, 1.3].map(|part| part * 1.1 * PI / 1.0472);
    assert_eq!(beyond_a_turn(&span(low)), None);
    let beyond = beyond_a_turn(&span(high)).unwrap();
    assert!(beyond.in_degrees && beyond.to_string().contains("no free pendulum"), "{beyond}");
    // Radians of swings about ±π, of which some jumps were taken out.
    let about_pi = Synthetic { omega0: 9.0, amplitude: 2.6, offset: PI, ..Synthetic::USUAL };
    let half_whole = changed(&about_pi.trace(&mut Random::seeded(1)), |row, value| {
        Some(value - TAU * libm::round(value / TAU) + if row / 40 % 2 == 1 { TAU } else { 0.0 })
    });
    let beyond = beyond_a_turn(&half_whole).unwrap();
    assert!(beyond.wrapped && !beyond.in_degrees && beyond.to_string().contains("whole turns"), "{beyond}");
    let counts = beyond_a_turn(&span(1000.0)).unwrap();
    assert!(!counts.in_degrees, "{counts}");
    let velocities = Synthetic { observable: Observable::AngularVelocity, velocity: 5.0, ..Synthetic::USUAL };
    assert_eq!(beyond_a_turn(&velocities.trace(&mut Random::seeded(1))), None);
}

/// Cancellation at the first check, at the last, and between: for passages and extremes, and for the fits.
#[test]
fn cycles_stop_at_any_question() {
    let trace = Synthetic { noise: 0.002, ..Synthetic::USUAL }.trace(&mut Random::seeded(1));
    let asked_until = |last: usize| {
        let questions = Cell::new(0);
        let progress = |_: Status| {
            questions.set(questions.get() + 1);
            if questions.get() == last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let outcome = fit_cycles(&trace, &CyclesOptions::default(), &progress);
        (outcome, questions.get())
    };
    let (whole, questions) = asked_until(usize::MAX);
    assert!(questions > 100, "{questions}");
    assert_eq!(whole.unwrap().cycles, found_in(&trace).cycles);
    for last in [1, 2, questions / 4, questions / 2, questions - 1, questions] {
        let (outcome, asked) = asked_until(last);
        assert_eq!((outcome.err(), asked), (Some(CyclesError::Interrupted(Interrupted)), last));
    }
    let traces = [trace.clone(), trace];
    let all = traces.each_ref().map(|trace| fit_cycles(trace, &CyclesOptions::default(), &Quiet));
    let progress = |_: Status| ControlFlow::Break(());
    let beta = beta_of_traces(&traces, &all, &progress);
    assert_eq!(beta, Err(CyclesError::Interrupted(Interrupted)));
}

/// Noise in units of the stated uncertainties is compared with the amplitude in theirs.
#[test]
fn stated_uncertainties_do_not_make_a_swing_faint() {
    let plain = Synthetic { noise: 0.005, ..Synthetic::USUAL }.trace(&mut Random::seeded(8));
    let (times, values) = (plain.times().to_vec(), plain.values().to_vec());
    let stated = Some(vec![0.005; plain.len()]);
    let stated = Trace::new("stated", Observable::Angle, times, values, stated).unwrap();
    let [plain, stated] = [plain, stated].map(|trace| found_in(&trace));
    assert_eq!(stated.cycles.len(), plain.cycles.len());
    assert!((stated.t0.value / plain.t0.value - 1.0).abs() < 1e-9, "{} {}", stated.t0, plain.t0);
    assert!((stated.noise / (plain.noise / 0.005) - 1.0).abs() < 1e-6, "{} {}", stated.noise, plain.noise);
}
