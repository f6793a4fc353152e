use libration::pendulum::{Amplitude, Pendulum, period, periods};
use libration::quantity::Angle;

/// Amplitudes of both signs over the domain, at its ends and outside: several blocks and a part of one.
fn amplitudes() -> Vec<f64> {
    let top = std::f64::consts::PI;
    let ends = [0.0, 1e-300, std::f64::consts::FRAC_PI_2, top, top.next_up(), f64::NAN, f64::INFINITY];
    let inner = (0..200).map(|i| f64::from(i) * 0.0157);
    inner.chain(ends).flat_map(|x| [x, -x]).collect()
}

#[test]
fn periods_are_those_of_the_pendulum() {
    let pendulum = Pendulum::new(0.994, 9.81).unwrap();
    for amplitude in amplitudes() {
        let computed = period(amplitude, 0.994, 9.81);
        let angle = Angle::from_radians(amplitude).ok();
        let truth =
            angle.and_then(|angle| Amplitude::new(angle).ok()).map(|amplitude| pendulum.period(&amplitude));
        match truth {
            Some(truth) => assert!((computed / truth - 1.0).abs() <= f64::EPSILON, "{amplitude}"),
            None => assert!(computed.is_nan(), "{amplitude}"),
        }
    }
}

#[test]
fn each_period_is_that_of_one_pendulum_bit_for_bit() {
    let amplitudes = amplitudes();
    let lengths: Vec<f64> = (0..amplitudes.len()).map(|i| [0.5, 0.5, 2.0, -1.0][i % 4]).collect();
    let gravities: Vec<f64> = (0..amplitudes.len()).map(|i| [9.81, 1e-300, f64::NAN][i % 3]).collect();
    let mut computed = vec![0.0; amplitudes.len()];
    periods(&amplitudes, &lengths, &gravities, &mut computed).unwrap();
    for (i, computed) in computed.iter().enumerate() {
        let one = period(amplitudes[i], lengths[i], gravities[i]);
        assert_eq!(computed.to_bits(), one.to_bits(), "{} {} {}", amplitudes[i], lengths[i], gravities[i]);
    }
    assert!(periods(&amplitudes, &lengths[1..], &gravities, &mut computed).is_err());
}

#[test]
fn quotients_beyond_the_range_of_numbers_are_none() {
    assert!(period(1.0, 1e-300, 1e270).is_finite());
    assert!(period(1.0, 1e300, 1e-270).is_finite());
    assert!(period(1.0, 1e-308, 1e308).is_nan());
    assert!(period(1.0, 0.0, 9.81).is_nan() && period(1.0, 1.0, f64::INFINITY).is_nan());
}
