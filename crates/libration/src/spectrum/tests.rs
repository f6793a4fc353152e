use super::*;
use crate::pendulum::Pendulum;

fn sampled(count: u32, interval: f64, value: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..count).map(|n| value(interval * f64::from(n))).collect()
}

/// A line has the height of its oscillation wherever its frequency lies between the points, and nothing is left beyond its width.
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
    assert_eq!(Spectrum::new(&values[1..], 1.0).unwrap_err(), NoSpectrum::TooFew(15));
    assert_eq!(Spectrum::new(&values, 0.0).unwrap_err(), NoSpectrum::Interval(0.0));
    assert!(Spectrum::new(&values, f64::NAN).is_err() && Spectrum::new(&values, f64::INFINITY).is_err());
    let infinite = [&values[1..], &[f64::INFINITY]].concat();
    assert_eq!(Spectrum::new(&infinite, 1.0).unwrap_err(), NoSpectrum::NotFinite(f64::INFINITY));
}
