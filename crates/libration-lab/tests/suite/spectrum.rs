//! Harmonics of swings with known truth: without errors, with noise of known kinds, and with distorting instruments.

use std::f64::consts::PI;

use libration::progress::{Interrupted, Quiet, Status};
use libration_lab::fit::cycles::CyclesError;
use libration_lab::fit::spectrum::{
    Spectrum, SpectrumError, SpectrumOptions, SpectrumRemark, fit_spectrum, lomb_scargle,
};
use libration_lab::measurement::{Observable, Trace};

use crate::random::Random;
use crate::synthetic_trace::Synthetic;
use libration_testing::sweep::{self, Limits};
use std::ops::ControlFlow;

fn found_in(trace: &Trace) -> Spectrum {
    fit_spectrum(trace, &SpectrumOptions::default(), &Quiet).unwrap()
}

fn of(synthetic: &Synthetic, seed: u64) -> Spectrum {
    found_in(&synthetic.trace(&mut Random::seeded(seed)))
}

fn refused(trace: &Trace) -> SpectrumError {
    fit_spectrum(trace, &SpectrumOptions::default(), &Quiet).unwrap_err()
}

/// The same rows with other values.
fn seen_as(trace: &Trace, see: impl Fn(usize, f64) -> f64) -> Trace {
    let values = trace.values().iter().enumerate().map(|(row, &value)| see(row, value)).collect();
    Trace::new("seen", trace.observable(), trace.times().to_vec(), values, None).unwrap()
}

fn names(spectrum: &Spectrum) -> Vec<&'static str> {
    spectrum.remarks.iter().map(SpectrumRemark::name).collect()
}

/// 120°, by mpmath as `reference/fourier.py` has it: frequency over that of small swings, and harmonics 1, 3, 5, 7.
const FREQUENCY: f64 = 0.728_395_515_523_453_5;
const EXACT: [f64; 4] = [
    2.158_115_591_616_902_9,
    -0.066_971_971_806_469_6,
    0.003_449_706_882_651_65,
    -0.000_211_408_213_424_002_55,
];
const STILL: Synthetic =
    Synthetic { amplitude: 2.094_395_102_393_195_5, linear: 0.0, rows: 1500, ..Synthetic::USUAL };

/// The sum of the harmonics above the eighth is below 1.5e-5 rad, and nearly orthogonal to the others.
#[test]
fn without_damping_and_noise_harmonics_are_the_exact_ones() {
    let spectrum = of(&STILL, 1);
    assert_eq!(spectrum.harmonics.len(), 8);
    assert!((spectrum.amplitude - STILL.amplitude).abs() < 2e-7, "{}", spectrum.amplitude);
    assert!(
        (spectrum.frequency / (3.0 * FREQUENCY / (2.0 * PI)) - 1.0).abs() < 1e-7,
        "{}",
        spectrum.frequency
    );
    for harmonic in &spectrum.harmonics {
        let exact = if harmonic.n % 2 == 1 { EXACT[harmonic.n / 2] } else { 0.0 };
        let quadrature = harmonic.quadrature.map_or(0.0, |quadrature| quadrature.value);
        assert!((harmonic.in_phase.value - exact).abs() < 1e-6, "{harmonic:?}");
        assert!((harmonic.theory - exact).abs() < 1e-6 && quadrature.abs() < 1e-6, "{harmonic:?}");
    }
    let velocity = of(&Synthetic { observable: Observable::AngularVelocity, ..STILL }, 1);
    assert!((velocity.amplitude - STILL.amplitude).abs() < 1e-5, "{}", velocity.amplitude);
    for (k, exact) in EXACT.into_iter().enumerate() {
        let speed = f64::from([1, 3, 5, 7][k]) * 3.0 * FREQUENCY * exact.abs();
        assert!((velocity.harmonics[2 * k + 1].in_phase.value - speed).abs() < 1e-5, "{speed}");
    }
}

/// Amplitudes that fall by a third and more during the measurement of harmonics.
#[test]
fn falling_amplitudes_leave_the_harmonics_of_the_pendulum() {
    for linear in [0.02, 0.1] {
        let spectrum = of(&Synthetic { linear, ..Synthetic::USUAL }, 1);
        let [first, last] =
            [0, spectrum.windows.len() - 1].map(|index| spectrum.windows[index].amplitude.value);
        assert!(last < 0.8 * first, "{first} {last}");
        for window in &spectrum.windows {
            let third = window.harmonics[3];
            let off = third.in_phase.value / third.theory - 1.0;
            assert!(off.abs() < 2e-3, "{linear} at {} s: {off:e}", window.time);
            // Linear damping turns it by 3/2 of the rate over the frequency.
            let turned = third.quadrature.unwrap().value / third.theory;
            let expected = 1.5 * 0.5 * linear / (2.0 * PI * window.frequency.value);
            assert!((turned.abs() / expected - 1.0).abs() < 0.2, "{turned} {expected}");
            for n in [2, 4, 6] {
                assert!(window.harmonics[n].amplitude().value < 5e-6, "{:?}", window.harmonics[n]);
            }
        }
        assert!(names(&spectrum).iter().all(|name| *name == "outliers"), "{:?}", spectrum.remarks);
    }
}

/// About 10 swings in 360 rows.
const SHORT: Synthetic = Synthetic { step: 0.065, rows: 360, noise: 0.01, ..Synthetic::USUAL };

/// Noise whose neighbours have this correlation, with the standard deviation of the noise of the rows before it.
fn with_memory(trace: &Trace, correlation: f64, deviation: f64, seed: u64) -> Trace {
    let mut random = Random::seeded(seed);
    let mut last = deviation * random.normal();
    let fresh = deviation * (1.0 - correlation * correlation).sqrt();
    let noise: Vec<f64> = (0..trace.len())
        .map(|_| {
            last = correlation * last + fresh * random.normal();
            last
        })
        .collect();
    seen_as(trace, |row, value| value + noise[row])
}

/// |t| of Student's distribution with 8 degrees of freedom is below this with the probability 0.6827 and 0.95: SciPy 1.17,
/// `scipy.stats.t.ppf(0.5 + p/2, 8)`.
const T_OF_8: [(f64, f64); 2] = [(0.6827, 1.066_8), (0.95, 2.306_0)];

/// Limits of the number of 20 draws, or of 100, that are so near the truth if the true probability is within 0.03 of Student's: 0.680 and 0.952 of
/// 1200 were. A false alarm has the probability 1e-6, as each of 40 tails has 2.5e-8: `scipy.stats.binom.ppf(2.5e-8, n, p - 0.03)` and `isf(2.5e-8,
/// n, p + 0.03)`. The full sample of the test's own seed has kept within three and a half standard deviations.
const ONE_PLACE: [Limits; 2] = [
    Limits { usual: 1.0..21.0, full: 38.0..94.0, seeded: 52.0..85.0 },
    Limits { usual: 9.0..21.0, full: 74.0..101.0, seeded: 88.0..101.0 },
];

/// Limits for six places and two kinds of noise together, which the hypothesis takes to be independent.
const ALL_PLACES: [Limits; 2] = [
    Limits { usual: 115.0..208.0, full: 692.0..939.0, seeded: 692.0..939.0 },
    Limits { usual: 194.0..241.0, full: 1049.0..1198.0, seeded: 1049.0..1198.0 },
];

#[test]
fn uncertainties_cover_the_truth_for_noise_with_and_without_memory_in_a_sweep() {
    let (number, seed) = (sweep::number(20, 100), sweep::seed(0));
    let mut all = [0; 2];
    let clean = Synthetic { noise: 0.0, ..SHORT }.trace(&mut Random::seeded(0));
    let truth = found_in(&clean);
    for (kind, correlation) in (0..).zip([0.0, 0.8]) {
        let mut hits = [[0; 2]; 6];
        for draw in 0..number {
            let seed = seed.wrapping_add(1000 * kind + draw);
            let spectrum = found_in(&with_memory(&clean, correlation, SHORT.noise, seed));
            assert_eq!(spectrum.windows.len(), 2);
            for (index, n) in [0, 2, 3, 4].into_iter().enumerate() {
                let harmonic = spectrum.harmonics[n];
                assert_eq!(harmonic.degrees_of_freedom, 8);
                let bias = truth.harmonics[n].difference.unwrap().value;
                let difference = harmonic.difference.unwrap();
                count(&mut hits[index], (difference.value - bias) / difference.uncertainty);
            }
            let third = spectrum.harmonics[3].quadrature.unwrap();
            let true_third = truth.harmonics[3].quadrature.unwrap().value;
            count(&mut hits[4], (third.value - true_third) / third.uncertainty);
            let first = spectrum.harmonics[1].in_phase;
            count(&mut hits[5], (first.value - truth.harmonics[1].in_phase.value) / first.uncertainty);
        }
        for (index, hits) in hits.into_iter().enumerate() {
            for (of, hits) in hits.into_iter().enumerate() {
                let what = format!("{correlation} {index} of {number} in {}", T_OF_8[of].0);
                ONE_PLACE[of].check(f64::from(hits), &what);
                all[of] += hits;
            }
        }
    }
    for (of, hits) in all.into_iter().enumerate() {
        ALL_PLACES[of].check(f64::from(hits), &format!("together in {}", T_OF_8[of].0));
    }
}

fn count(hits: &mut [u32; 2], deviation: f64) {
    for (hits, (_, limit)) in hits.iter_mut().zip(T_OF_8) {
        *hits += u32::from(deviation.abs() < limit);
    }
}

/// A scale that bends, θ + εθ², adds εA²/2 to the amplitude of cos 2φ.
#[test]
fn an_instrument_that_bends_the_scale_is_seen_in_the_second_harmonic() {
    let noisy = Synthetic { noise: 1e-3, ..Synthetic::USUAL }.trace(&mut Random::seeded(2));
    let spectrum = found_in(&seen_as(&noisy, |_, value| value + 0.02 * value * value));
    let window = &spectrum.windows[0];
    let expected = 0.5 * 0.02 * window.amplitude.value * window.amplitude.value;
    let second = window.harmonics[2];
    assert!((second.in_phase.value / expected - 1.0).abs() < 0.02, "{second:?} {expected}");
    assert!(names(&spectrum).contains(&"even_harmonic"), "{:?}", spectrum.remarks);
    assert!(!names(&found_in(&noisy)).contains(&"even_harmonic"));
}

#[test]
fn a_wrong_scale_is_told_from_the_third_harmonic() {
    let noisy = Synthetic { noise: 1e-3, ..Synthetic::USUAL }.trace(&mut Random::seeded(3));
    let spectrum = found_in(&seen_as(&noisy, |_, value| 0.9 * value));
    let told = spectrum.remarks.iter().find_map(|remark| match remark {
        SpectrumRemark::Odd { n: 3, scale, ratio } => Some((scale.unwrap(), *ratio)),
        _ => None,
    });
    let (scale, ratio) = told.unwrap();
    assert!(
        (scale - 1.0 / 0.9).abs() < 3.0 * 0.5 * ratio.uncertainty && ratio.uncertainty < 0.05,
        "{scale} {ratio}"
    );
}

#[test]
fn dry_friction_is_seen_beside_the_third_harmonic() {
    let dry = Synthetic { dry: 0.1, linear: 0.0, noise: 1e-3, ..Synthetic::USUAL };
    assert!(names(&of(&dry, 4)).contains(&"quadrature"), "{:?}", of(&dry, 4).remarks);
    // −d·sign θ′ has 4d/3π with sin 3φ, to which a pendulum of small swings answers with 1/(9 − 1)ω².
    let small = Synthetic { dry: 0.005, linear: 0.0, amplitude: 0.3, ..Synthetic::USUAL };
    let expected = 4.0 * 0.005 / (3.0 * PI) / (8.0 * 9.0);
    let quadrature = of(&small, 4).windows[0].harmonics[3].quadrature.unwrap().value;
    assert!((quadrature.abs() / expected - 1.0).abs() < 0.05, "{quadrature} {expected}");
    assert!(
        !names(&of(&Synthetic { linear: 0.1, noise: 1e-4, ..Synthetic::USUAL }, 4)).contains(&"quadrature")
    );
}

#[test]
fn an_offset_is_told() {
    let spectrum = of(&Synthetic { offset: 0.02, noise: 1e-3, ..Synthetic::USUAL }, 5);
    assert_eq!(names(&spectrum), ["offset"]);
    assert!(
        (spectrum.harmonics[0].in_phase.value - 0.02).abs()
            < 5.0 * spectrum.harmonics[0].in_phase.uncertainty
    );
}

/// A third of the rows left out at random, all rows of two swings, and one row in 25 that is wrong.
#[test]
fn uneven_rows_gaps_and_outliers_do_not_matter() {
    let whole = Synthetic { noise: 1e-3, ..Synthetic::USUAL }.trace(&mut Random::seeded(6));
    let mut random = Random::seeded(7);
    let chosen: Vec<bool> = (0..whole.len()).map(|_| random.below(3) > 0).collect();
    let spoilt = seen_as(&whole, |row, value| if row % 25 == 3 { value + 2.0 } else { value });
    let kept = |row: usize| chosen[row] && !(15.0..20.0).contains(&whole.times()[row]);
    let part = spoilt.only(kept).unwrap();
    let spectrum = found_in(&part);
    let wrong = (0..whole.len()).filter(|row| kept(*row) && row % 25 == 3).count();
    assert!(
        spectrum.outliers.len() <= wrong && spectrum.outliers.len() + 12 >= wrong,
        "{} of {wrong}",
        spectrum.outliers.len()
    );
    assert!(
        names(&spectrum).contains(&"windows_left_out") && names(&spectrum).contains(&"outliers"),
        "{:?}",
        spectrum.remarks
    );
    for harmonic in spectrum.harmonics.iter().filter(|harmonic| harmonic.n != 1) {
        assert!(harmonic.deviation().unwrap().abs() < 4.0, "{harmonic:?}");
    }
    let third = spectrum.harmonics[3];
    assert!(third.in_phase.uncertainty < 0.02 * third.theory.abs(), "{third:?}");
    assert!((spectrum.noise / 1e-3 - 1.0).abs() < 0.1, "{}", spectrum.noise);
}

/// Ten rows in a period resolve four harmonics: half of ten, minus one half.
#[test]
fn harmonics_beyond_half_the_sampling_rate_are_not_told() {
    let spectrum = of(&Synthetic { step: 0.215, rows: 200, noise: 1e-3, ..Synthetic::USUAL }, 8);
    assert_eq!(spectrum.harmonics.len(), 5);
    assert!(
        spectrum.remarks.contains(&SpectrumRemark::NotSampled { highest: 4, asked: 7 }),
        "{:?}",
        spectrum.remarks
    );
    assert!(spectrum.harmonics[3].deviation().unwrap().abs() < 4.0);
    let last = spectrum.points.last().unwrap().frequency;
    assert!(last < 0.5 / 0.215, "{last}");
}

#[test]
fn uncertainties_of_rows_are_weights() {
    let clean = Synthetic::USUAL.trace(&mut Random::seeded(9));
    let mut random = Random::seeded(9);
    let deviation = |row: usize| if row.is_multiple_of(2) { 1e-3 } else { 1e-2 };
    let values =
        clean.values().iter().enumerate().map(|(row, value)| value + deviation(row) * random.normal());
    let values: Vec<f64> = values.collect();
    let uncertainties = Some((0..clean.len()).map(deviation).collect());
    let times = clean.times().to_vec();
    let trace =
        Trace::new("weighted", Observable::Angle, times.clone(), values.clone(), uncertainties).unwrap();
    let without = Trace::new("plain", Observable::Angle, times, values, None).unwrap();
    let [stated, without] = [&trace, &without].map(found_in);
    assert!((stated.noise - 1.0).abs() < 0.1, "{}", stated.noise);
    let [weighted, plain] = [stated, without].map(|spectrum| spectrum.harmonics[3].in_phase.uncertainty);
    assert!(weighted < 0.3 * plain, "{weighted} {plain}");
}

#[test]
fn what_has_no_harmonics_is_refused() {
    let usual = Synthetic::USUAL.trace(&mut Random::seeded(1));
    let constant = seen_as(&usual, |_, _| 0.3);
    assert_eq!(refused(&constant), CyclesError::NothingSwings(0.3).into());
    let coarse = Synthetic { step: 0.45, rows: 100, ..Synthetic::USUAL }.trace(&mut Random::seeded(1));
    assert!(matches!(refused(&coarse), SpectrumError::Cycles(CyclesError::TooCoarse { .. })));
    let two = Synthetic { rows: 250, ..Synthetic::USUAL }.trace(&mut Random::seeded(1));
    assert!(
        matches!(refused(&two), SpectrumError::TooShort { swings, needed: 3 } if (swings - 2.2).abs() < 0.1)
    );
    let degrees = seen_as(&usual, |_, value| value.to_degrees());
    assert!(matches!(refused(&degrees), SpectrumError::BeyondATurn(_)));
    let options = |harmonics, swings| SpectrumOptions { harmonics, swings };
    assert_eq!(fit_spectrum(&usual, &options(7, 2), &Quiet).unwrap_err(), SpectrumError::ShortWindows(2));
    assert_eq!(fit_spectrum(&usual, &options(0, 5), &Quiet).unwrap_err(), SpectrumError::NoHarmonics);
    // Three swings, a gap of 1.7 periods, and three more, all in one window.
    let torn = usual.only(|row| row < 370 || (560..900).contains(&row)).unwrap();
    assert_eq!(refused(&torn), SpectrumError::NoWindow { windows: 1 });
}

/// The columns of the harmonics span all other signals in a window of three swings.
#[test]
fn windows_of_three_swings_take_all_residuals_for_noise() {
    let trace = Synthetic { rows: 370, noise: 1e-3, ..Synthetic::USUAL }.trace(&mut Random::seeded(11));
    let spectrum = found_in(&trace);
    assert_eq!(spectrum.windows.len(), 1);
    for harmonic in &spectrum.harmonics {
        // 0.5·cos² of 370 rows; the constant and the first have more columns next to them.
        let uncertainty = harmonic.in_phase.uncertainty / (1e-3 * (2.0_f64 / 370.0).sqrt());
        assert!((0.5..4.0).contains(&uncertainty), "{harmonic:?}");
        assert!(
            harmonic.degrees_of_freedom >= 4 && harmonic.deviation().unwrap_or(0.0).abs() < 5.0,
            "{harmonic:?}"
        );
    }
    assert!(spectrum.harmonics[1].degrees_of_freedom > 300, "{:?}", spectrum.harmonics[1]);
}

#[test]
fn the_search_is_stopped_when_asked() {
    let trace = Synthetic::USUAL.trace(&mut Random::seeded(1));
    let calls = std::cell::Cell::new(0);
    let progress = |_: Status| {
        calls.set(calls.get() + 1);
        ControlFlow::Continue(())
    };
    fit_spectrum(&trace, &SpectrumOptions::default(), &progress).unwrap();
    let all = calls.get();
    assert!(all > 20, "{all}");
    for last in [0, all / 2, all - 2] {
        calls.set(0);
        let progress = |_: Status| {
            calls.set(calls.get() + 1);
            if calls.get() > last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let stopped = fit_spectrum(&trace, &SpectrumOptions::default(), &progress);
        assert!(matches!(
            stopped,
            Err(SpectrumError::Interrupted(Interrupted) | SpectrumError::Cycles(CyclesError::Interrupted(_)))
        ));
    }
}

/// SciPy 1.17.1 for t = 0.05k + 0.013(k² mod 7), y = 0.4 cos(2π·0.7t) + 0.1 sin(2π·2.1t) + 0.03((37k mod 11) − 5) + 2, k < 60:
/// `lombscargle(t, y, 2*pi*f, weights=w, floating_mean=True, normalize=True)`, and the absolute value of that with
/// `normalize="amplitude"`, at f = 0.3, 0.6 … 2.1; without weights, and with w = 1 + (k mod 5)/2.
const SCIPY: [([f64; 7], [f64; 7]); 2] = [
    (
        [
            0.02290015541254543,
            0.6517859419339382,
            0.2373062817505483,
            0.05035912368690744,
            0.02219875100744311,
            0.0002731386658053985,
            0.032094108234865616,
        ],
        [
            0.06876563162278933,
            0.36185564162727757,
            0.21482212200461695,
            0.09673278471070891,
            0.06750073543643774,
            0.00710675564137937,
            0.07597474185018419,
        ],
    ),
    (
        [
            0.02736062219532405,
            0.6563275760134475,
            0.22095895291556156,
            0.059132702501132735,
            0.021422314588722586,
            0.005266309114937086,
            0.029464316884964804,
        ],
        [
            0.07619499575444104,
            0.3643238980038855,
            0.21094236937922448,
            0.10545996683674176,
            0.06718469688056748,
            0.03136634211584037,
            0.07673149505949006,
        ],
    ),
];

#[test]
fn periodograms_are_those_of_scipy() {
    let times: Vec<f64> = (0..60).map(|k| 0.05 * f64::from(k) + 0.013 * f64::from(k * k % 7)).collect();
    let value = |(k, t): (u32, &f64)| {
        let noise = 0.03 * (f64::from(k * 37 % 11) - 5.0);
        0.4 * libm::cos(2.0 * PI * 0.7 * t) + 0.1 * libm::sin(2.0 * PI * 2.1 * t) + noise + 2.0
    };
    let values: Vec<f64> = (0..).zip(&times).map(value).collect();
    let weights: Vec<f64> = (0..60).map(|k| 1.0 + 0.5 * f64::from(k % 5)).collect();
    for (weights, (powers, amplitudes)) in [None, Some(&weights[..])].into_iter().zip(SCIPY) {
        let points = lomb_scargle(&times, &values, weights, 0.3, 7, &Quiet).unwrap();
        for (index, point) in points.iter().enumerate() {
            assert!((point.power - powers[index]).abs() < 1e-12, "{point:?} {}", powers[index]);
            assert!((point.amplitude - amplitudes[index]).abs() < 1e-12, "{point:?} {}", amplitudes[index]);
        }
    }
}

#[test]
fn rows_that_determine_no_sine_have_none() {
    let even: Vec<f64> = (0..20).map(f64::from).collect();
    let values: Vec<f64> = even.iter().map(|t| libm::cos(t * 1.3)).collect();
    let points = lomb_scargle(&even, &values, None, 0.25, 4, &Quiet).unwrap();
    // At 1/4 of the rate there is a sine; at half of it cosines alone, at the rate a constant alone.
    let is_there: Vec<bool> = points.iter().map(|point| point.amplitude.is_finite()).collect();
    assert_eq!(is_there, [true, false, true, false]);
    assert!(lomb_scargle(&even[..2], &values, None, 0.25, 1, &Quiet).unwrap()[0].power.is_nan());
    assert!(lomb_scargle(&[], &[], None, 0.25, 1, &Quiet).unwrap()[0].power.is_nan());
    assert!(lomb_scargle(&even, &[1.0; 20], None, 0.2, 1, &Quiet).unwrap()[0].power.is_nan());
}
