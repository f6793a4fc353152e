mod fourier;
mod window;

use libration::pendulum::Pendulum;
use libration::spectrum::{Spectrum, SpectrumError};
use libration::taylor::{DenseSolution, Effort, System, integrate_dense};
use std::f64::consts::TAU;

fn sampled(count: u32, interval: f64, value: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..count).map(|n| value(interval * f64::from(n))).collect()
}

/// A line has the height of its oscillation wherever its frequency lies between the points, and beyond its width the spectrum vanishes.
#[test]
fn a_line_has_its_height_and_its_width() {
    for count in [1000, 1024] {
        for frequency in (0..40_u32).map(|n| 1.0 + 0.7123 * f64::from(n)) {
            let values = sampled(count, 0.1, |t| 0.75 * libm::cos(frequency * t + 0.4));
            let spectrum = Spectrum::new(&values, 0.1).unwrap();
            assert!((spectrum.amplitude_at(frequency) - 0.75).abs() < 0.75 * 2.0 * Spectrum::SIDE_LOBES);
            let highest = spectrum.points().map(|(_, amplitude)| amplitude).fold(0.0, f64::max);
            assert!(highest > 0.996 * 0.75 && highest < 0.75 * (1.0 + 1e-7), "{frequency}: {highest}");
            for (at, amplitude) in spectrum.points() {
                let beside = (at - frequency).abs() > spectrum.resolution();
                assert!(
                    !beside || amplitude < 0.75 * 2.0 * Spectrum::SIDE_LOBES,
                    "{frequency} {at}: {amplitude}"
                );
            }
        }
    }
}

#[test]
fn a_mean_value_stands_at_zero_with_its_height() {
    let values = sampled(512, 0.1, |t| 3.0 + libm::sin(2.0 * t));
    let spectrum = Spectrum::new(&values, 0.1).unwrap();
    let (frequency, mean) = spectrum.points().next().unwrap();
    assert!(frequency.abs() < f64::MIN_POSITIVE);
    assert!((mean - 3.0).abs() < 1e-6);
}

/// The harmonics of the pendulum in closed form (from the nome) are those of the spectrum of its motion.
#[test]
fn the_lines_of_a_swing_are_its_harmonics() {
    for degrees in ["60deg", "150deg", "179deg"] {
        let motion =
            Pendulum::from_angular_frequency(1.0).unwrap().released_from(degrees.parse().unwrap()).unwrap();
        let interval = 40.0 * motion.period() / 8192.0;
        let spectrum =
            Spectrum::new(&sampled(8192, interval, |t| motion.state_at(t).angle), interval).unwrap();
        let harmonics = motion.harmonics(1e-12, 60);
        let all: f64 = harmonics.terms.iter().map(|term| term.angle.abs()).sum();
        for term in &harmonics.terms {
            let frequency = f64::from(u32::try_from(term.n).unwrap()) * TAU / motion.period();
            let error = (spectrum.amplitude_at(frequency) - term.angle.abs()).abs();
            assert!(error < Spectrum::SIDE_LOBES * all, "{degrees} {}: {error:e}", term.n);
        }
    }
}

#[test]
fn what_has_no_spectrum_is_refused() {
    let values = [1.0; 16];
    assert!(Spectrum::new(&values, 1.0).is_ok());
    assert_eq!(Spectrum::new(&values[1..], 1.0).unwrap_err(), SpectrumError::TooFew(15));
    assert_eq!(Spectrum::new(&values, 0.0).unwrap_err(), SpectrumError::Interval(0.0));
    assert!(Spectrum::new(&values, f64::NAN).is_err() && Spectrum::new(&values, f64::INFINITY).is_err());
    let infinite = [&values[1..], &[f64::INFINITY]].concat();
    assert_eq!(Spectrum::new(&infinite, 1.0).unwrap_err(), SpectrumError::NotFinite(f64::INFINITY));
}

fn integrated(equation: &str, start: &[(&str, f64)], end: f64) -> DenseSolution {
    let system = System::new(&equation.parse().unwrap()).unwrap();
    let start = system.start(start).unwrap();
    integrate_dense(&system, &start, end, &Effort::to_tolerance(1e-13)).unwrap()
}

/// Motions that are fast only for short times require many values for each step, or the highest harmonics would be aliased to lower ones: 1e-3
/// from the separatrix steps at the top are ten times longer than at the bottom.
#[test]
fn motions_are_sampled_until_their_fastest_oscillations_show() {
    let amplitude = std::f64::consts::PI - 1e-3;
    let motion =
        Pendulum::from_angular_frequency(1.0).unwrap().released_from("pi-1e-3".parse().unwrap()).unwrap();
    let end = 12.0 * motion.period();
    let steps = integrated("theta'' + sin(theta) = 0", &[("theta", amplitude)], end);
    let spectrum = Spectrum::of_motion(&steps, 1, [0.0, end]).unwrap();
    let harmonics = motion.harmonics(1e-12, 400);
    let all: f64 = harmonics.terms.iter().map(|term| term.velocity.abs()).sum();
    for term in harmonics.terms.iter().step_by(7) {
        let frequency = f64::from(u32::try_from(term.n).unwrap()) * TAU / motion.period();
        let error = (spectrum.amplitude_at(frequency) - term.velocity.abs()).abs();
        assert!(error < 1e-7 * all, "{}: {error:e}", term.n);
    }
    // The kinks of |x| have oscillations of all frequencies, which decrease like the inverse fourth power of the frequency.
    let kinked = integrated("x'' + x + abs(x)/2 = 0.3*cos(3*t)", &[("x", 1.0)], 60.0);
    assert!(Spectrum::of_motion(&kinked, 0, [0.0, 60.0]).is_ok());
    let fast = integrated("x'' + x = cos(2000*t)", &[("x", 1.0)], 60.0);
    assert!(Spectrum::of_motion(&fast, 1, [0.0, 60.0]).unwrap().highest() > 2000.0);
}

/// Oscillations, with any phases at the ends, have a spectrum; a motion that drifts from one end to the other has none.
#[test]
fn a_trend_is_told_from_a_swing() {
    let swing = integrated("x'' + x = 0", &[("x", 1.0)], 100.0);
    for number in 0..32_u32 {
        let from = 0.2 * f64::from(number);
        for until in [from + 45.0, from + 48.1] {
            assert!(Spectrum::of_motion(&swing, 0, [from, until]).is_ok(), "{from} {until}");
        }
    }
    let turning = integrated("theta'' + sin(theta) = 0", &[("theta'", 2.01)], 100.0);
    let refused = Spectrum::of_motion(&turning, 0, [0.0, 100.0]).unwrap_err();
    assert!(
        matches!(refused, SpectrumError::Trend { first, last } if first.abs() < f64::MIN_POSITIVE && last > 60.0),
        "{refused}"
    );
    assert!(Spectrum::of_motion(&turning, 1, [0.0, 100.0]).is_ok());
    let at_rest = integrated("x'' + x = 0", &[], 100.0);
    assert!(Spectrum::of_motion(&at_rest, 0, [0.0, 100.0]).is_ok());
    for span in [[0.0, 100.1], [-1.0, 50.0], [50.0, 50.0], [60.0, 50.0], [0.0, f64::NAN]] {
        assert!(
            matches!(Spectrum::of_motion(&swing, 0, span), Err(SpectrumError::NotKnown { .. })),
            "{span:?}"
        );
    }
    assert!(matches!(Spectrum::of_motion(&swing, 2, [0.0, 50.0]), Err(SpectrumError::NotKnown { .. })));
}
