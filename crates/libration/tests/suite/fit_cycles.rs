//! Cycles of traces with known truth: made by the integrator, with noise, quantised, sampled coarsely, with outliers.

use libration::fit::cycles::{Cycles, CyclesError, Options, cycles};
use libration::measurement::{Seen, Trace};
use libration::pendulum::period_ratio;

use crate::random::Random;
use crate::synthetic_trace::Synthetic;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

fn of(synthetic: &Synthetic, seed: u64) -> Cycles {
    cycles(&synthetic.trace(&mut Random::seeded(seed)), &Options::default()).unwrap()
}

/// Without noise what is left is the bias of the local fits and what damping does to the period in second order.
#[test]
fn without_noise_every_cycle_obeys_the_exact_law() {
    let cases = [
        Synthetic::USUAL,
        Synthetic { amplitude: 100.0 * DEGREE, linear: 0.05, ..Synthetic::USUAL },
        Synthetic { amplitude: 0.1, dry: 0.01, linear: 0.0, ..Synthetic::USUAL },
        Synthetic { quadratic: 0.05, linear: 0.0, offset: 0.3, ..Synthetic::USUAL },
        // 25 rows in a period.
        Synthetic { step: 0.083, rows: 480, ..Synthetic::USUAL },
        // 12 rows in a period.
        Synthetic { step: 0.175, rows: 240, ..Synthetic::USUAL },
    ];
    for case in cases {
        let found = of(&case, 1);
        let worst = found.small_angle_periods().map(|t0| (t0 / case.t0() - 1.0).abs()).fold(0.0, f64::max);
        assert!(worst < 2e-4, "{case:?}: {worst:e}");
        assert!((found.t0 / case.t0() - 1.0).abs() < 2e-5, "{case:?}: {}", found.t0);
        assert!((found.offset - case.offset).abs() < 2e-4, "{case:?}: {}", found.offset);
    }
}

#[test]
fn scratch() {
    for (name, case) in [
        ("fine", Synthetic { noise: 0.002, ..Synthetic::USUAL }),
        ("coarse", Synthetic { noise: 0.005, step: 0.083, rows: 480, ..Synthetic::USUAL }),
        ("coarse12", Synthetic { noise: 0.005, step: 0.175, rows: 240, ..Synthetic::USUAL }),
        (
            "quant",
            Synthetic {
                quantum: 0.0015708,
                step: 0.005,
                rows: 1600,
                amplitude: 1.9,
                linear: 0.04,
                ..Synthetic::USUAL
            },
        ),
        ("big", Synthetic { noise: 0.003, amplitude: 2.4, ..Synthetic::USUAL }),
        ("vel", Synthetic { noise: 0.01, offset: 0.02, seen: Seen::AngularVelocity, ..Synthetic::USUAL }),
        (
            "velbig",
            Synthetic {
                noise: 0.01,
                offset: 0.02,
                amplitude: 2.0,
                seen: Seen::AngularVelocity,
                ..Synthetic::USUAL
            },
        ),
    ] {
        let mut p = vec![];
        let mut b = vec![];
        let mut chi = 0.0;
        let mut db = 0.0;
        let mut ub = 0.0;
        let mut dt = 0.0;
        let mut ca = vec![];
        let mut ct = vec![];
        for seed in 0..60 {
            let f = of(&case, seed);
            let o = f.offset_wander;
            p.push((f.t0 - case.t0()) / f.t0_uncertainty);
            dt += (f.t0 / case.t0() - 1.0) / 60.0;
            let beta = f.beta.clone().unwrap();
            b.push((beta.beta - 1.0) / beta.uncertainty);
            db += (beta.beta - 1.0) / 60.0;
            ub += beta.uncertainty / 60.0;
            chi += f.chi2_per_dof.unwrap() / 60.0;
            for c in &f.cycles {
                ct.push(
                    (c.period / c.period_ratio - case.t0())
                        / (c.period_uncertainty.powi(2)
                            + (case.t0()
                                * (period_ratio(c.amplitude + 1e-3) - period_ratio(c.amplitude - 1e-3))
                                / 2e-3
                                * c.amplitude_uncertainty)
                                .powi(2))
                        .sqrt(),
                );
            }
            if o > 0.0 {
                ca.push(o);
            }
        }
        let rms = |v: &[f64]| (v.iter().map(|x| x * x).sum::<f64>() / v.len() as f64).sqrt();
        let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
        let f = of(&case, 3);
        println!(
            "{name}: noise {:e} n {} T0 pull rms {:.3} mean {:.3} relbias {:.1e} (sigma {:.1e}) beta pull {:.3} mean {:.3} bias {:.1e} sigma {:.1e} chi {:.3} cycle pull {:.3} wander {} {:?}",
            f.noise,
            f.cycles.len(),
            rms(&p),
            mean(&p),
            dt,
            f.t0_uncertainty / f.t0,
            rms(&b),
            mean(&b),
            db,
            ub,
            chi,
            rms(&ct),
            ca.len(),
            f.warnings
        );
    }
}
