//! The rate at which clean traces are said not to tell their damping.

use libration_lab::fit::swings::SwingsOptions;
use libration_testing::sweep::{self, Limits};

use super::{SWING, analysis, named};
use crate::random::Random;
use crate::synthetic_trace::Synthetic;

/// Traces of a minute under one law each, whose amplitude falls to between 0.3 and 0.7 of itself, seen to between 0.03° and 0.3°: at most 15 % are said not
/// to tell their damping. Of the test's own 240 it is 24, half of them linear damping that dry and quadratic friction together imitate. A
/// false alarm has the probability 1e-6 where 15 % is true (`scipy.stats.binom.isf(1e-6, n, 0.15)`).
#[test]
fn clean_traces_tell_their_damping_in_a_sweep() {
    let mut random = Random::seeded(sweep::seed(0x5e9a));
    let number = sweep::number(24, 240);
    let mut alarms = 0;
    for draw in 0..number {
        let amplitude = random.between(0.35, 1.6);
        let omega0 = random.between(2.0, 8.0);
        let left = random.between(0.3, 0.7);
        let duration = 60.0;
        let still = Synthetic {
            amplitude,
            omega0,
            linear: 0.0,
            step: 0.04,
            rows: 1500,
            noise: random.between(0.0005, 0.005),
            ..SWING
        };
        let swing = match draw % 3 {
            0 => Synthetic { linear: -2.0 * libm::log(left) / duration, ..still },
            1 => Synthetic {
                dry: (1.0 - left) * amplitude * 0.5 * std::f64::consts::PI * omega0 / duration,
                ..still
            },
            _ => Synthetic {
                quadratic: (1.0 / left - 1.0) * 0.75 * std::f64::consts::PI / (omega0 * amplitude * duration),
                ..still
            },
        };
        let fit = analysis(&[swing.trace(&mut random)], &SwingsOptions::default());
        let alarm = named(&fit.warnings, "damping_not_separated");
        eprintln!("{draw} {:?} {alarm:?}", fit.fit.damping);
        alarms += u32::from(alarm.is_some());
    }
    Limits { usual: 0.0..14.5, full: 0.0..65.5, seeded: 0.0..36.5 }.check(f64::from(alarms), "not separated");
}
