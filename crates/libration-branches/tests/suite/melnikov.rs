//! The Melnikov function, resonances and their widths, compared with closed forms, other quadratures and published thresholds.

use libm::{acosh, atan, cos, cosh, sin, sinh, tanh};
use libration::algebra::Complex;
use libration::expression::Equation;
use libration::melnikov::{Melnikov, MelnikovError, PerturbedPendulum, thresholds};
use libration::progress::Quiet;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn perturbed(text: &str) -> PerturbedPendulum {
    PerturbedPendulum::new(&text.parse().unwrap()).unwrap()
}

/// Source: mpmath, (4c/π) cosh(πΩ/2) to 25 digits.
const THRESHOLDS: [(&str, &str, f64); 3] = [
    ("0.1", "1", 0.319_478_526_382_585_23),
    ("0.1", "(2/3)", 0.203_754_851_014_665_03),
    ("0.05", "1", 0.159_739_263_191_292_62),
];

#[test]
fn the_threshold_of_a_damped_driven_pendulum_is_that_of_the_closed_form() {
    for (c, omega, expected) in THRESHOLDS {
        let equation: Equation = format!("x'' + {c} x' + sin(x) = A cos({omega} t)").parse().unwrap();
        let computed = thresholds(&equation, "A", [0.0, 1.0], &Quiet).unwrap();
        assert_eq!(computed.len(), 2, "one on either separatrix: {computed:?}");
        for threshold in computed {
            assert!((threshold.value - expected).abs() <= threshold.error.min(2e-15), "{threshold:?}");
            assert!(threshold.above);
        }
    }
}

/// ∫ θ′·g dt over the separatrix by the trapezoidal rule, with separately written formulas.
fn by_trapezoids(omega0: f64, direction: f64, phase: f64, g: impl Fn(f64, f64, f64) -> f64) -> f64 {
    let step = 1.0 / 64.0;
    let at = |j: i32| {
        let t = step * f64::from(j);
        let (angle, velocity) = (direction * 2.0 * atan(sinh(t)), 2.0 * omega0 * direction / cosh(t));
        velocity * g(angle, velocity, t / omega0 + phase) * step / omega0
    };
    (-2600..=2600).map(at).sum()
}

#[test]
fn residues_agree_with_quadrature_for_any_trigonometric_polynomial() {
    let text = "x'' = -2.25 sin(x) - 0.1 x'^3 + 0.2 cos(x)^2 cos(2t) x' + 0.3 sin(2x - t + 0.4) + 0.05 x' sin(x) cos(x)^3 + 0.01";
    let pendulum = perturbed(text);
    assert!(pendulum.is_closed() && pendulum.omega0() == 1.5);
    let g = |x: f64, v: f64, t: f64| {
        -0.1 * v * v * v
            + 0.2 * cos(x) * cos(x) * cos(2.0 * t) * v
            + 0.3 * sin(2.0 * x - t + 0.4)
            + 0.05 * v * sin(x) * cos(x) * cos(x) * cos(x)
            + 0.01
    };
    for melnikov in Melnikov::both(&pendulum, &Quiet).unwrap() {
        for phase in [0.0, 0.7, 2.0, 4.5] {
            let expected = by_trapezoids(1.5, melnikov.direction, phase, g);
            let difference = (melnikov.at_phase(phase) - expected).abs();
            assert!(difference <= melnikov.error() && melnikov.error() < 1e-13, "{phase}: {difference:e}");
        }
    }
}

#[test]
fn other_perturbations_are_integrated_by_quadrature_with_their_error() {
    let text = "x'' + sin(x) = -0.1 x' abs(x') - 0.02 tanh(x') + 0.3 cos(t)/(2 + cos(t))";
    let pendulum = perturbed(text);
    assert!(!pendulum.is_closed());
    let g = |_: f64, v: f64, t: f64| -0.1 * v * v.abs() - 0.02 * tanh(v) + 0.3 * cos(t) / (2.0 + cos(t));
    for melnikov in Melnikov::both(&pendulum, &Quiet).unwrap() {
        for phase in [0.0, 1.0, 3.0] {
            let expected = by_trapezoids(1.0, melnikov.direction, phase, g);
            let difference = (melnikov.at_phase(phase) - expected).abs();
            assert!(
                difference <= melnikov.error() && melnikov.error() < 1e-9,
                "{difference:e} {:e}",
                melnikov.error()
            );
        }
    }
}

#[test]
fn what_is_exponentially_small_keeps_its_digits() {
    // 2π sech(πΩ/2), which is 6.5e-27 at Ω = 40.
    let [upper, _] = Melnikov::both(&perturbed("x'' + sin(x) = cos(40 t)"), &Quiet).unwrap();
    let expected = TAU / cosh(20.0 * PI);
    assert!((upper.harmonics[0].abs() / expected - 1.0).abs() < 1e-13);
    assert!(upper.harmonic_errors[0] < 1e-13 * expected);
}

#[test]
fn zeros_are_where_the_function_vanishes() {
    let [upper, _] =
        Melnikov::both(&perturbed("x'' + 0.1 x' + sin(x) = 0.5 cos(t) + 0.3 sin(3t)"), &Quiet).unwrap();
    assert_eq!(upper.has_simple_zeros(), Some(true));
    let zeros = upper.zeros();
    assert!(zeros.len() >= 2 && zeros.len() % 2 == 0, "{zeros:?}");
    for (phase, slope) in zeros {
        assert!(upper.at_phase(phase).abs() < 1e-14 && slope != 0.0);
        let quotient = (upper.at_phase(phase + 1e-6) - upper.at_phase(phase - 1e-6)) / 2e-6;
        assert!((quotient - slope).abs() < 1e-8);
    }
    let [least, most] = upper.extremes();
    let values = (0..20_000).map(|j| upper.at_phase(TAU * f64::from(j) / 20_000.0) - upper.mean);
    let seen = values.fold([0.0_f64; 2], |[low, high], value| [low.min(value), high.max(value)]);
    assert!((least - seen[0]).abs() < 1e-7 && least <= seen[0] && (most - seen[1]).abs() < 1e-7);
}

/// The largest value lies beside the phase 0 by less than the rounding of 2π, before it or after it.
#[test]
fn extremes_and_zeros_at_the_beginning_of_the_period_are_found() {
    let [driven, _] = Melnikov::both(&perturbed("x'' + sin(x) = 0.4 cos(t) + 0.1 cos(2t)"), &Quiet).unwrap();
    for shift in (-16..=16).map(|j| 3e-17 * f64::from(j)) {
        // c₁ = e^{iδ} and c₂ = e^{2iδ}/4 for a largest value at −δ; a quarter of a turn on, the function itself vanishes there.
        let with = |a: [f64; 2], b: [f64; 2]| Melnikov {
            harmonics: [a, b].map(|[re, im]| Complex::new(re, im)).to_vec(),
            ..driven.clone()
        };
        let even = with([1.0, shift], [0.25, 0.5 * shift]);
        let values = (0..2000).map(|j| even.at_phase(TAU * f64::from(j) / 2000.0) - even.mean);
        let seen = values.fold([0.0_f64; 2], |[low, high], value| [low.min(value), high.max(value)]);
        for (extreme, seen) in even.extremes().into_iter().zip(seen) {
            assert!((extreme - seen).abs() < 1e-5, "{shift}: {extreme} {seen}");
        }
        let zeros = with([shift, -1.0], [0.5 * shift, -0.25]).zeros();
        assert_eq!(zeros.len(), 2, "{shift}: {zeros:?}");
        assert!(zeros.iter().all(|(phase, _)| (0.0..TAU).contains(phase)), "{shift}: {zeros:?}");
        let rises = |(phase, slope): &(f64, f64)| sin(*phase).abs() < 1e-15 && *slope > 0.0;
        assert!(zeros.iter().any(rises), "{shift}: {zeros:?}");
    }
}

/// A pendulum whose angle is counted from elsewhere, also from the top, has the thresholds and tangencies of one that hangs at zero: gravity along
/// the cosine is not a perturbation.
#[test]
fn the_place_from_which_the_angle_is_counted_changes_nothing() {
    let both = |force: &str| {
        let equation: Equation = format!("x'' + 0.1*x' + {force} = A*cos(t) + 0.02*x'^2").parse().unwrap();
        let computed = thresholds(&equation, "A", [0.0, 1.0], &Quiet).unwrap();
        assert_eq!(computed.len(), 2, "{force}: {computed:?}");
        computed
            .into_iter()
            .map(move |threshold| (threshold, threshold.tangency(&equation, "A", &Quiet).unwrap()))
    };
    let expected: Vec<_> = both("sin(x)").collect();
    for force in [
        "sin(x - 1/2)",
        "(cos(0.5)*sin(x) - sin(0.5)*cos(x))",
        "-sin(x)",
        "-cos(x)",
        "sin(x - 100)",
        "-sin(x + 2)",
    ] {
        for ((here, touching), (there, expected)) in both(force).zip(&expected) {
            assert!((here.value - there.value).abs() < 1e-13, "{force}: {here:?} {there:?}");
            let off = (touching.value - expected.value).abs();
            assert!(off <= touching.error + expected.error, "{force}: {touching:?} {expected:?}");
        }
    }
    let centre = |text: &str| perturbed(text).centre();
    assert!((centre("x'' + sin(x - 1/2) = cos(t)") - 0.5).abs() < 1e-15);
    assert!((centre("x'' - sin(x) = cos(t)") - PI).abs() < 1e-15);
    assert_eq!(centre("x'' + sin(x) = cos(t)"), 0.0);
}

/// B. V. Chirikov's resonance of a wave with a free rotation: its separatrix extends 2√a from the velocity of the wave.
#[test]
fn a_travelling_wave_locks_the_rotations_that_its_own_separatrix_holds() {
    let driven = perturbed("x'' + 1e-8 sin(x) = -0.04 sin(x - 3t)");
    let resonances = driven.resonances(1, &Quiet).unwrap();
    let [rotation] =
        &resonances.iter().filter(|resonance| resonance.direction != 0.0).collect::<Vec<_>>()[..]
    else {
        panic!("{resonances:?}")
    };
    assert_eq!((rotation.motion_periods, rotation.drive_periods, rotation.direction), (1, 1, 1.0));
    assert!((rotation.motion.frequency() - 3.0).abs() < 1e-13);
    assert!((rotation.half_width - 0.4).abs() < 1e-7);
}

/// The half-width compared with the largest action of a locked motion.
#[test]
fn a_resonance_of_librations_is_as_wide_as_motions_show() {
    use libration::taylor::{Effort, Moment, System, integrate};
    let strength = 1e-4;
    let equation: Equation = format!("x'' + sin(x) = {strength} cos(0.9 t)").parse().unwrap();
    let resonances = PerturbedPendulum::new(&equation).unwrap().resonances(1, &Quiet).unwrap();
    let libration = resonances.iter().find(|resonance| resonance.direction == 0.0).unwrap();
    // A motion from the hyperbolic point of the resonance reaches the half-width on its way around.
    let system = System::new(&equation).unwrap();
    let action = |state: &[f64]| {
        let pendulum = libration::pendulum::Pendulum::from_angular_frequency(1.0).unwrap();
        pendulum
            .launched(libration::quantity::Angle::from_radians(state[0]).unwrap(), state[1])
            .unwrap()
            .action()
    };
    let period = libration.motion.period();
    let times: Vec<f64> = (1..1000).map(f64::from).collect();
    let widest = (0..6)
        .map(|j| {
            let state = libration.motion.state_at(period * f64::from(j) / 6.0);
            let start = Moment { time: 0.0, state: vec![state.angle, state.velocity] };
            let solution = integrate(&system, &start, &times, &Effort::to_tolerance(1e-12), &Quiet).unwrap();
            let reached = solution
                .samples
                .iter()
                .map(|sample| (action(&sample.state) - libration.motion.action()).abs());
            reached.fold(0.0, f64::max)
        })
        .fold(0.0, f64::max);
    assert!((widest / libration.half_width - 1.0).abs() < 0.05, "{widest} {}", libration.half_width);
}

#[test]
fn damping_must_be_made_up_for_within_a_resonance() {
    let driven = perturbed("x'' + 0.01 x' + sin(x) = 0.1 cos(0.8 t)");
    let libration = driven
        .resonances(1, &Quiet)
        .unwrap()
        .into_iter()
        .find(|resonance| resonance.direction == 0.0)
        .unwrap();
    // The dissipated energy per period is c∮θ′dθ = 2πcJ.
    let expected = -0.01 * libration.motion.action() * libration.motion.frequency();
    assert!((libration.mean_power - expected).abs() < 1e-15);
    assert!(libration.threshold_factor() > 0.0 && libration.threshold_factor() < 1.0);
}

/// v|v| has a kink where a libration turns, so that sums over equal steps converge slowly; a rotation has none.
#[test]
fn forces_with_kinks_have_powers_within_their_errors() {
    const STEPS: i32 = 100_000;
    let driven = perturbed("x'' + sin(x) = -0.1 x' abs(x') + 0.3 cos(t)/(2 + cos(t))");
    let resonances = driven.resonances(3, &Quiet).unwrap();
    assert!(resonances.len() >= 4, "{resonances:?}");
    let drive_mean = 0.3 * (1.0 - 2.0 / 3.0_f64.sqrt());
    for resonance in resonances {
        let sign = if resonance.direction < 0.0 { -1.0 } else { 1.0 };
        let power = |step: i32| {
            let time = (f64::from(step) + 0.3) / f64::from(STEPS) * resonance.motion.period();
            let velocity = sign * resonance.motion.state_at(time).velocity;
            velocity * (drive_mean - 0.1 * velocity * velocity.abs())
        };
        // In parts, whose sums are rounded less than one sum of all.
        let sums: Vec<f64> = (0..STEPS)
            .collect::<Vec<_>>()
            .chunks(250)
            .map(|part| part.iter().copied().map(power).sum())
            .collect();
        let expected = sums.iter().sum::<f64>() / f64::from(STEPS);
        let difference = (resonance.mean_power - expected).abs();
        assert!(
            difference <= resonance.error && resonance.error < 1e-11,
            "{difference:e} {:e}",
            resonance.error
        );
    }
}

#[test]
fn what_is_no_pendulum_under_a_periodic_drive_is_refused() {
    let refusal = |text: &str| PerturbedPendulum::new(&text.parse().unwrap()).unwrap_err();
    assert!(matches!(refusal("x'' = y; y'' = x"), MelnikovError::Coordinates(2)));
    assert!(matches!(refusal("x' = -x"), MelnikovError::NotSecondOrder(_)));
    assert!(matches!(refusal("x'' + k sin(x) = 0"), MelnikovError::Open(_)));
    assert!(matches!(refusal("x'' = x - x^3 + cos(t)"), MelnikovError::NoPendulum));
    assert!(matches!(refusal("x'' = -sin(x) - x^3"), MelnikovError::NoAngle(_)));
    assert!(matches!(refusal("x'' = -sin(x) + t"), MelnikovError::NotPeriodic));
    let equation: Equation = "x'' + sin(x) = A cos(t)".parse().unwrap();
    assert!(matches!(thresholds(&equation, "A", [1.0, 1.0], &Quiet), Err(MelnikovError::Range { .. })));
    assert!(matches!(thresholds(&equation, "B", [0.0, 1.0], &Quiet), Err(MelnikovError::At { .. })));
}

/// Without damping M = 2π·A·sech(π/2)·cos φ has simple zeros for every A but zero, on both sides of it.
#[test]
fn a_drive_that_vanishes_without_damping_is_no_threshold() {
    let equation: Equation = "x'' + sin(x) = A cos(t)".parse().unwrap();
    for range in [[0.0, 1.0], [-1.0, 0.0], [-1.0, 1.0], [-0.3, 1.0]] {
        assert_eq!(thresholds(&equation, "A", range, &Quiet).unwrap(), [], "{range:?}");
    }
    let damped: Equation = "x'' + c x' + sin(x) = 0.2 cos(t)".parse().unwrap();
    assert_eq!(thresholds(&damped, "c", [-1.0, 1.0], &Quiet).unwrap().len(), 4);
}

#[test]
fn a_parameter_may_be_the_frequency_of_the_drive() {
    let equation: Equation = "x'' + 0.1 x' + sin(x) = 0.4 cos(w t)".parse().unwrap();
    let computed = thresholds(&equation, "w", [0.2, 3.0], &Quiet).unwrap();
    let expected = acosh(0.4 * PI / 0.4) / FRAC_PI_2;
    assert!(!computed[0].above && (computed[0].value - expected).abs() < 1e-14, "{computed:?} {expected}");
}

/// dω/dJ by differences of 40 digits. Source: mpmath.
#[test]
fn the_frequency_changes_with_the_action_as_elliptic_integrals_tell() {
    let pendulum = libration::pendulum::Pendulum::from_angular_frequency(0.7).unwrap();
    for (energy, expected) in [
        (0.25, -0.139_512_894_048_611_5),
        (0.75, -0.220_415_847_870_794_58),
        (0.9999, -28.671_874_782_176_026),
        (1.0001, 114.753_361_372_281_63),
        (1.5, 1.117_687_137_839_307_1),
        (10.0, 1.001_041_079_719_956),
    ] {
        let computed = pendulum.with_energy_ratio(energy).unwrap().frequency_slope();
        // Near the separatrix the rounding of the energy ratio is amplified up to 1e4 times.
        let tolerance = 4e-16 / (energy - 1.0_f64).abs().min(1.0);
        assert!((computed / expected - 1.0).abs() < tolerance, "{energy}: {computed}");
    }
    let smallest = pendulum.with_energy_ratio(1e-200).unwrap();
    assert!((smallest.frequency_slope() + 0.125).abs() < 1e-16);
    assert_eq!(pendulum.on_separatrix().frequency_slope(), f64::NEG_INFINITY);
    assert_eq!(pendulum.on_separatrix().frequency(), 0.0);
    assert!((pendulum.with_energy_ratio(1e9).unwrap().frequency_slope() - 1.0).abs() < 1e-15);
}

#[test]
fn the_angle_variable_grows_evenly() {
    let pendulum = libration::pendulum::Pendulum::from_angular_frequency(1.0).unwrap();
    for energy in [0.3, 0.999, 1.001, 20.0] {
        let motion = pendulum.with_energy_ratio(energy).unwrap();
        assert_eq!(motion.angle_variable_at(0.0), 0.0);
        for share in [0.1, 0.25, 0.6, 0.999] {
            let computed = motion.angle_variable_at((share + 3.0) * motion.period());
            assert!((computed / TAU - share).abs() < 1e-14, "{energy} {share}: {computed}");
        }
        assert!(motion.angle_variable_at(f64::NAN).is_nan());
    }
    assert!(pendulum.on_separatrix().angle_variable_at(1.0).is_nan());
}

/// Source: two manifolds integrated in 150-bit floats and Newton's method for their contact, which agree with this computation in doubles
/// to 15 to 17 digits. The equation is θ″ + c·θ′ + sin θ = A·cos Ωt; the columns are c, Ω, A.
const TANGENCIES: [(&str, &str, f64); 4] = [
    ("0.1", "1", 0.319_869_600_087_485_03),
    ("0.1", "(2/3)", 0.203_712_546_072_548_16),
    ("0.05", "1", 0.159_787_761_749_641_87),
    ("0.1", "2", 1.509_547_968_519_473_175),
];

#[test]
fn manifolds_touch_where_they_do_in_more_digits_and_by_the_second_order_from_the_threshold() {
    let excesses = TANGENCIES.map(|(c, omega, expected)| {
        let equation: Equation = format!("x'' + {c} x' + sin(x) = A cos({omega} t)").parse().unwrap();
        let [upper, lower] = thresholds(&equation, "A", [0.0, 2.0], &Quiet).unwrap()[..] else { panic!() };
        let [original, mirrored] =
            [upper, lower].map(|threshold| threshold.tangency(&equation, "A", &Quiet).unwrap());
        for tangency in [original, mirrored] {
            assert!(
                (tangency.value - expected).abs() <= tangency.error && tangency.error < 1e-12,
                "{tangency:?}"
            );
        }
        // The equation is invariant under a reflection of the angle together with a shift by half a period.
        assert!((original.velocity + mirrored.velocity).abs() < 1e-6, "{mirrored:?}");
        assert!(((original.phase - mirrored.phase).abs() - PI).abs() < 1e-5, "{mirrored:?}");
        original.value / upper.value - 1.0
    });
    let ratio = excesses[0] / excesses[2];
    assert!((ratio - 4.0).abs() < 0.1, "of half the strength a quarter: {ratio}");
}

/// Source: SciPy's DOP853 along the eigenvectors of a saddle orbit from multiple shooting, with an uncertainty of about 2e-11.
#[test]
fn tangencies_of_uneven_and_parametric_drives_are_those_of_another_program() {
    let cases = [
        ("x'' + 0.2 x' + 2.25 sin(x) = A*(cos(t) + cos(2t)/2) + 0.05", 0.444_643_335_629),
        ("x'' + 0.1 x' + (1 - A cos(2t)) sin(x) = 0", 0.367_917_534_524),
    ];
    for (text, expected) in cases {
        let equation: Equation = text.parse().unwrap();
        let upper = thresholds(&equation, "A", [0.0, 1.0], &Quiet).unwrap()[0];
        let tangency = upper.tangency(&equation, "A", &Quiet).unwrap();
        assert!((tangency.value - expected).abs() < 5e-11 && tangency.error < 1e-12, "{tangency:?}");
    }
}

#[test]
fn a_perturbation_that_is_not_weak_has_no_tangency_near_its_threshold() {
    let equation: Equation = "x'' + 2 x' + sin(x) = A cos(t)".parse().unwrap();
    let upper = thresholds(&equation, "A", [0.0, 100.0], &Quiet).unwrap()[0];
    assert!(upper.tangency(&equation, "A", &Quiet).is_err());
}

/// The position of a tangency, compared with Taylor series and Newton's method in 200 bits from two distances.
#[test]
fn the_place_of_a_tangency_is_known_to_its_stated_error() {
    use libration::taylor::{Effort, Moment, System, integrate};
    let equation: Equation = "x'' + 0.1 x' + sin(x) = A cos(t)".parse().unwrap();
    let [upper, _] = &thresholds(&equation, "A", [0.0, 1.0], &Quiet).unwrap()[..] else { panic!() };
    let touching = upper.tangency(&equation, "A", &Quiet).unwrap();
    assert!((touching.value - 0.319_869_600_087_485_03).abs() < 1e-12);
    assert!(touching.place_error < 1e-10, "{touching:?}");
    let system =
        System::new(&equation.with(&[("A", "0.319869600087485".parse().unwrap())]).unwrap()).unwrap();
    let start = Moment { time: touching.phase, state: vec![0.0, touching.velocity] };
    let end = integrate(&system, &start, &[TAU], &Effort::to_tolerance(1e-15), &Quiet).unwrap().end.state;
    let expected = [0.042_517_821_156_603_723, 2.002_152_029_089_374_6];
    let off = (end[0] - expected[0]).abs().max((end[1] - expected[1]).abs());
    // An error of the phase changes the angle by the velocity times this error.
    assert!(off < 3.0 * touching.place_error, "{off:e} for {touching:?}");
}
