//! The slow flow of damped pendulums compared with their turning points by integration.

use libration::comparison::{SlowDecay, SlowDecayError};
use libration::decay::{Damping, Decay, PowerLawTerm, TurningPoint};
use libration::pendulum::Pendulum;
use libration::progress::Quiet;
use std::f64::consts::PI;

fn decay(omega0: f64, start: f64, terms: &[(f64, f64)]) -> Decay {
    let terms: Vec<PowerLawTerm> =
        terms.iter().map(|&(exponent, coefficient)| PowerLawTerm { exponent, coefficient }).collect();
    let pendulum = Pendulum::from_angular_frequency(omega0).unwrap();
    Decay::new(pendulum, Damping::new(&terms).unwrap(), format!("{start}rad").parse().unwrap()).unwrap()
}

/// The largest errors of the amplitude, relative, of the phase, and of the time of a cycle, relative, in ten cycles.
fn errors(decay: &Decay, order: usize, damping_order: usize) -> [f64; 3] {
    let turns: Vec<TurningPoint> = decay.swings().take(21).collect::<Result<_, _>>().unwrap();
    let times: Vec<f64> = turns.iter().map(|turn| turn.time).collect();
    let slow = SlowDecay::new(decay, order, damping_order, &Quiet).unwrap();
    let mut largest = [0.0_f64; 3];
    for ((number, turn), at) in (0_u32..).zip(&turns).zip(slow.at_times(&times)) {
        largest[0] = largest[0].max((at.amplitude / turn.amplitude.radians() - 1.0).abs());
        largest[1] = largest[1].max((at.phase - PI * f64::from(number)).abs());
    }
    let slow_turns = slow.turning_points(turns.len());
    assert_eq!(slow_turns.len(), turns.len());
    for (pair, exact) in slow_turns.windows(3).zip(turns.windows(3)) {
        let [computed, exact] = [pair[2].time - pair[0].time, exact[2].time - exact[0].time];
        largest[2] = largest[2].max((computed / exact - 1.0).abs());
    }
    largest
}

/// Two more powers of A and one more of the damping, of 0.6/π squared and a twentieth, each leave less than a third of the errors.
#[test]
fn errors_fall_with_the_orders() {
    for terms in [
        &[(1.0, 0.05)][..],
        &[(2.0, 0.1)],
        &[(3.0, 0.2)],
        &[(0.0, 0.002), (1.0, 0.02), (2.0, 0.05)],
        &[(1.0, 0.02), (4.0, 0.1)],
    ] {
        let decay = decay(1.0, 0.6, terms);
        let of = [[3, 1], [5, 2], [7, 3], [9, 4]].map(|[order, power]| errors(&decay, order, power));
        for pair in of.windows(2) {
            assert!(
                pair[0].iter().zip(pair[1]).all(|(before, after)| after < before / 3.0),
                "{terms:?} {of:?}"
            );
        }
        assert!(of[3].iter().all(|error| *error < 3e-5), "{terms:?} {of:?}");
    }
}

/// With 1/ω0 as the unit of time it is the same motion.
#[test]
fn the_frequency_is_a_unit_of_time() {
    let [slow, fast] = [(1.0, 0.1), (5.0, 0.1)].map(|(omega0, c)| {
        let slow = SlowDecay::new(&decay(omega0, 0.5, &[(2.0, c)]), 5, 2, &Quiet).unwrap();
        slow.turning_points(9)[8]
    });
    assert!(
        (slow.time / fast.time - 5.0).abs() < 1e-13 && (slow.amplitude / fast.amplitude - 1.0).abs() < 1e-14
    );
}

#[test]
fn powers_that_are_not_whole_have_no_series_and_dry_friction_ends_it() {
    let refused = SlowDecay::new(&decay(1.0, 0.5, &[(1.5, 0.1)]), 3, 1, &Quiet).unwrap_err();
    assert_eq!(refused, SlowDecayError::Exponent(1.5));
    let stopped = SlowDecay::new(&decay(1.0, 0.1, &[(0.0, 0.02)]), 3, 2, &Quiet).unwrap();
    let points = stopped.turning_points(100);
    assert!((2..6).contains(&points.len()), "{points:?}");
    assert!(stopped.at_times(&[0.0, 1000.0])[1].amplitude.is_nan());
}
