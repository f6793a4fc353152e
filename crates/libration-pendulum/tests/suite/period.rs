//! The period: published numbers, laws that it satisfies, and batches against single calls.

use crate::promises::RATIO;
use core::f64::consts::{FRAC_PI_2, PI};
use libration::pendulum::{self, Amplitude, LengthMismatch, Pendulum, PendulumError, SwingPeriod};
use libration::quantity::Angle;
use libration_testing::golden::Table;
use libration_testing::random::Random;
use libration_testing::ulp::{Truth, ulp};

#[test]
fn published_periods_are_reproduced_to_their_printed_digits() {
    for row in Table::read("published/periods.csv").rows() {
        let value = row.input("amplitude");
        let angle =
            if row.text("unit") == "deg" { Angle::from_degrees(value) } else { Angle::from_radians(value) };
        let ratio = Amplitude::new(angle.unwrap()).unwrap().period_ratio();
        let small_angle = Pendulum::new(1.0, 9.8).unwrap().small_angle_period();
        let got = if row.text("quantity") == "T/T0" { ratio } else { ratio * small_angle };
        let digits: i32 = row.text("printed_digits").parse().unwrap();
        let expected = row.input("value");
        let unit = libm::pow(10.0, libm::floor(libm::log10(expected)) + 1.0 - f64::from(digits));
        assert!(
            (got - expected).abs() <= unit.max(2.0 * ulp(expected)),
            "{} {value}: {got}",
            row.text("source")
        );
    }
}

#[test]
fn the_period_doubles_at_the_published_amplitude() {
    // OEIS A256514.
    let double = Amplitude::from_period_ratio(2.0).unwrap();
    assert!(
        Truth::from_decimal("2.78823112410720430142152184753089072761590872546").error(double.radians())
            <= 1.0
    );
}

/// Amplitudes of every kind: uniform, small, next to π, and the complement of each decade.
fn amplitudes(seed: u64, count: usize) -> Vec<f64> {
    let mut random = Random::seeded(seed);
    let mut draw = |n| match n % 4 {
        0 => random.log_between(-150.0, 0.0),
        1 => PI - random.log_between(-15.0, 0.0),
        _ => random.between(0.0, PI),
    };
    (0..count).map(&mut draw).collect()
}

/// Valid amplitudes or complements of every kind, then invalid ones.
fn inputs_with_edges() -> Vec<f64> {
    let mut inputs = amplitudes(1, 100_000);
    inputs.extend([
        f64::NAN,
        0.0,
        -0.0,
        f64::INFINITY,
        f64::NEG_INFINITY,
        5e-324,
        1e-310,
        1e-300,
        1e300,
        f64::MAX,
    ]);
    inputs.extend([
        PI,
        PI.next_down(),
        PI.next_up(),
        -1.0,
        4.0,
        PI / 2.0,
        (PI / 2.0).next_up(),
        f64::MIN_POSITIVE,
    ]);
    inputs
}

type Batch = fn(&[f64], &mut [f64]) -> Result<(), LengthMismatch>;
type Single = fn(f64) -> f64;

#[test]
fn batch_of_periods_equals_the_single_call_bit_for_bit() {
    let pairs: [(Batch, Single); 3] = [
        (pendulum::period_ratios, pendulum::period_ratio),
        (pendulum::period_excesses, pendulum::period_excess),
        (pendulum::period_ratios_near_top, pendulum::period_ratio_near_top),
    ];
    let inputs = inputs_with_edges();
    for (batch, single) in pairs {
        for count in [inputs.len(), 17, 16, 9, 8, 7, 3, 1, 0] {
            let slice = &inputs[inputs.len() - count..];
            let mut computed = vec![0.0; count];
            batch(slice, &mut computed).unwrap();
            for (&input, &computed) in slice.iter().zip(&computed) {
                assert_eq!(computed.to_bits(), single(input).to_bits(), "{input}");
            }
        }
    }
}

#[test]
fn batch_of_periods_refuses_slices_of_different_lengths() {
    assert!(pendulum::period_ratios(&[1.0, 2.0], &mut [0.0]).is_err());
}

#[test]
fn what_is_no_amplitude_has_no_period() {
    for amplitude in [f64::NAN, f64::INFINITY, PI.next_up(), -PI.next_up(), 4.0, 1e300] {
        assert!(pendulum::period_ratio(amplitude).is_nan(), "{amplitude}");
    }
    for complement in [f64::NAN, -1e-9, 4.0] {
        assert!(pendulum::period_ratio_near_top(complement).is_nan(), "{complement}");
    }
}

#[test]
fn the_period_of_no_swing_is_the_small_angle_period() {
    for amplitude in [0.0, -0.0, 5e-324, 1e-300, 1e-9] {
        assert_eq!(pendulum::period_ratio(amplitude), 1.0, "{amplitude}");
    }
    assert_eq!(pendulum::period_excess(0.0), 0.0);
}

#[test]
fn excess_is_the_ratio_less_one() {
    for amplitude in amplitudes(2, 20_000) {
        let (ratio, excess) = (pendulum::period_ratio(amplitude), pendulum::period_excess(amplitude));
        assert!((1.0 + excess - ratio).abs() <= 2.0 * ulp(ratio) + 2.0 * ulp(excess), "{amplitude}");
    }
}

#[test]
fn excess_of_a_tiny_swing_is_a_sixteenth_of_its_square() {
    for amplitude in [1e-5, 1e-20, 1e-100, 1e-150] {
        let expected = (amplitude / 4.0) * (amplitude / 4.0);
        assert!((pendulum::period_excess(amplitude) / expected - 1.0).abs() <= 1e-10, "{amplitude}");
    }
}

#[test]
fn an_amplitude_and_its_complement_have_the_same_period() {
    let mut random = Random::seeded(3);
    for _ in 0..20_000 {
        // π − δ rounds to an `f64` with an error of at most 2⁻⁵²; dR/dδ = −(2/π)/δ near the top.
        let complement = random.log_between(-3.0, 0.4);
        let (plain, near_top) =
            (pendulum::period_ratio(PI - complement), pendulum::period_ratio_near_top(complement));
        let slack = 2.0 * ulp(plain) + 2.0 * f64::EPSILON / complement;
        assert!((plain - near_top).abs() <= slack, "{complement}: {plain} {near_top}");
    }
}

#[test]
fn landens_transformation_joins_periods() {
    // R(θ0) = 1/agm(1, c) = [2/(1 + c)]·R(θ1), cos(θ1/2) = 2√c/(1 + c), c = cos(θ0/2) (DLMF 19.8.12).
    let mut random = Random::seeded(4);
    for _ in 0..20_000 {
        let amplitude = random.between(0.01, 3.0);
        let c = libm::cos(amplitude / 2.0);
        let next = 2.0 * libm::asin((1.0 - c) / (1.0 + c));
        let expected = 2.0 / (1.0 + c) * pendulum::period_ratio(next);
        assert!(
            (pendulum::period_ratio(amplitude) / expected - 1.0).abs() <= 32.0 * f64::EPSILON,
            "{amplitude}"
        );
    }
}

#[test]
fn a_period_gives_its_amplitude_back() {
    let mut random = Random::seeded(5);
    for _ in 0..5000 {
        let complement = random.log_between(-300.0, 0.4);
        let ratio = pendulum::period_ratio_near_top(complement);
        let back = Amplitude::from_period_ratio(ratio).unwrap();
        RATIO.holds((back.period_ratio() - ratio).abs() / ulp(ratio), &complement);
    }
    for impossible in [0.5, 1.0 - f64::EPSILON, f64::NAN, f64::INFINITY, -1.0] {
        assert!(
            matches!(Amplitude::from_period_ratio(impossible), Err(PendulumError::NoSuchPeriod(_))),
            "{impossible}"
        );
    }
}

#[test]
fn a_period_ratio_is_refused_for_its_own_reason_where_its_amplitude_is_too_close_to_the_top() {
    // T/T0 = 441.085 at the complement 1e-300.
    assert!(Amplitude::from_period_ratio(441.08).unwrap().complement() >= 1e-300);
    for long in [441.09, 441.2, 1e10] {
        let refused = Amplitude::from_period_ratio(long).unwrap_err();
        assert_eq!(refused, PendulumError::PeriodTooLong(long));
        assert!(refused.to_string().contains("give at most 441.08"), "{refused}");
        assert!(Amplitude::from_period_excess(long).is_err(), "{long}");
    }
}

#[test]
fn an_excess_gives_its_amplitude_back_however_small() {
    for excess in [5e-324, 1e-310, 1e-300, 1e-200, 1e-20, 1e-3, 0.1799, 0.18, 0.1801, 3.0, 440.0] {
        let amplitude = Amplitude::from_period_excess(excess).unwrap();
        // The rounding of the amplitude counts twice in the excess of a small swing; the bound of the excess is added.
        assert!((amplitude.period_excess() - excess).abs() <= 3.0 * ulp(excess), "{excess}");
    }
    assert_eq!(Amplitude::from_period_excess(0.0).unwrap().radians(), 0.0);
    assert!(Amplitude::from_period_excess(-1e-300).is_err());
}

#[test]
fn any_length_and_gravity_with_a_usable_frequency_make_a_pendulum() {
    let (large, small) = (libm::exp2(700.0), libm::exp2(-700.0));
    assert_eq!(Pendulum::new(large, small).unwrap().angular_frequency(), small);
    assert_eq!(Pendulum::new(small, large).unwrap().angular_frequency(), large);
    assert_eq!(Pendulum::new(libm::exp2(-1022.0), 1.0).unwrap().angular_frequency(), libm::exp2(511.0));
    assert_eq!(Pendulum::new(1.0, libm::exp2(-1022.0)).unwrap().angular_frequency(), libm::exp2(-511.0));
    for (length, gravity) in [(1e-300, 1e300), (1e300, 1e-300), (1e-320, 1.0), (1.0, 1e-310)] {
        let refused = Pendulum::new(length, gravity).unwrap_err();
        assert_eq!(refused, PendulumError::OutOfRange { length, gravity });
    }
}

#[test]
fn extreme_periods_give_their_pendulum_back_or_are_refused_for_what_they_are() {
    let amplitude = Amplitude::new(Angle::from_radians(1.0).unwrap()).unwrap();
    for (length, period) in [(1e-300, 1e-200), (1e300, 1e200), (1e-200, 1e-20), (1e200, 1e20)] {
        let gravity =
            Pendulum::from_length_and_period(length, period, &amplitude).unwrap().gravity().unwrap();
        let pendulum = Pendulum::from_gravity_and_period(gravity, period, &amplitude).unwrap();
        assert!((pendulum.length().unwrap() / length - 1.0).abs() <= 4.0 * f64::EPSILON, "{length} {period}");
        assert!(
            (pendulum.period(&amplitude) / period - 1.0).abs() <= 4.0 * f64::EPSILON,
            "{length} {period}"
        );
    }
    for period in [5e-324, 1e-300, 1e300, 1e308] {
        let refused = Pendulum::from_length_and_period(1.0, period, &amplitude).unwrap_err();
        assert_eq!(refused, PendulumError::PeriodOutOfRange(period));
    }
    for period in [1e-200, 1e200] {
        let refused = Pendulum::from_length_and_period(1.0, period, &amplitude).unwrap_err();
        assert_eq!(refused, PendulumError::Unattainable { name: "gravity", period });
        let refused = Pendulum::from_gravity_and_period(1.0, period, &amplitude).unwrap_err();
        assert_eq!(refused, PendulumError::Unattainable { name: "length", period });
    }
}

#[test]
fn condition_is_the_slope_of_the_period() {
    let mut random = Random::seeded(6);
    for _ in 0..2000 {
        let (amplitude, step) = (random.between(0.1, 3.0), 1e-5);
        let slope = (pendulum::period_ratio(amplitude + step) - pendulum::period_ratio(amplitude - step))
            / (2.0 * step);
        let expected = slope * amplitude / pendulum::period_ratio(amplitude);
        let got = Amplitude::new(Angle::from_radians(amplitude).unwrap()).unwrap().condition();
        assert!((got - expected).abs() <= 1e-6 * (1.0 + expected), "{amplitude}: {got} {expected}");
    }
}

#[test]
fn a_measured_period_gives_length_and_gravity_back() {
    let mut random = Random::seeded(7);
    for _ in 0..2000 {
        let (length, gravity) = (random.log_between(-3.0, 3.0), random.log_between(-1.0, 2.0));
        let amplitude = Amplitude::new(Angle::from_radians(random.between(0.0, 3.1)).unwrap()).unwrap();
        let period = Pendulum::new(length, gravity).unwrap().period(&amplitude);
        let by_length = Pendulum::from_length_and_period(length, period, &amplitude).unwrap();
        assert!(
            (by_length.gravity().unwrap() / gravity - 1.0).abs() <= 4.0 * f64::EPSILON,
            "{length} {gravity}"
        );
        let by_gravity = Pendulum::from_gravity_and_period(gravity, period, &amplitude).unwrap();
        assert!(
            (by_gravity.length().unwrap() / length - 1.0).abs() <= 4.0 * f64::EPSILON,
            "{length} {gravity}"
        );
    }
}

#[test]
fn what_belongs_to_a_period_is_what_each_method_says_bit_for_bit() {
    let pendulum = Pendulum::new(0.7, 9.81).unwrap();
    for amplitude in seams_and_2000_amplitudes() {
        let swing = pendulum.swing_period(&amplitude);
        let computed = [swing.period, swing.ratio, swing.excess, swing.nome, swing.condition];
        let expected = [
            pendulum.period(&amplitude),
            amplitude.period_ratio(),
            amplitude.period_excess(),
            amplitude.nome(),
            amplitude.condition(),
        ];
        assert_eq!(computed.map(f64::to_bits), expected.map(f64::to_bits), "{amplitude:?}");
        // The nome of the modulus agrees where its complement is a normal number.
        if amplitude.complement() > 1e-300 {
            assert_eq!(swing.nome.to_bits(), amplitude.modulus().nome().to_bits(), "{amplitude:?}");
        }
    }
}

#[test]
fn what_belongs_to_many_periods_is_what_belongs_to_each_bit_for_bit() {
    let bits = |period: &SwingPeriod| {
        [period.period, period.ratio, period.excess, period.nome, period.condition].map(f64::to_bits)
    };
    let amplitudes = seams_and_2000_amplitudes();
    for pendulum in [Pendulum::new(0.7, 9.81), Pendulum::from_angular_frequency(1e-200)].map(Result::unwrap) {
        // Blocks of every length, with amplitudes that are not regular at any position.
        for length in (0..200).chain([amplitudes.len()]) {
            let amplitudes = &amplitudes[..length];
            let mut computed = vec![SwingPeriod::default(); length];
            pendulum.swing_periods(amplitudes, &mut computed).unwrap();
            for (amplitude, computed) in amplitudes.iter().zip(&computed) {
                let alone = pendulum.swing_period(amplitude);
                assert_eq!(bits(computed), bits(&alone), "{amplitude:?}: {computed:?} {alone:?}");
            }
        }
    }
    let mut two = [SwingPeriod::default(); 2];
    let refused = Pendulum::new(1.0, 9.81).unwrap().swing_periods(&amplitudes[..3], &mut two);
    assert_eq!(refused, Err(LengthMismatch { expected: 3, found: 2 }));
}

fn seams_and_2000_amplitudes() -> Vec<Amplitude> {
    let mut random = Random::seeded(21);
    let complements = [5e-324, 2.2e-308, 4.4e-308, 4.5e-308, 1e-300, 1e-9].map(Angle::from_complement);
    let radians = [0.0, 1e-300, 1e-9, FRAC_PI_2, FRAC_PI_2.next_up(), FRAC_PI_2.next_down(), PI.next_down()];
    let drawn: Vec<f64> = (0..2000).map(|_| random.between(0.0, PI)).collect();
    let radians = radians.into_iter().chain(drawn).map(Angle::from_radians);
    complements.into_iter().chain(radians).map(|angle| Amplitude::new(angle.unwrap()).unwrap()).collect()
}

/// Between the ends of the change the period changes by the fraction, with a margin of 1e-3: at both ends of the branch of the inverse (an
/// excess of 0.18), at zero and next to the top.
#[test]
fn the_change_with_the_period_is_that_of_the_forward_function() {
    let seams =
        [0.18_f64, 0.18_f64.next_down(), 0.18_f64.next_up(), 1e-30, 1e-9, 0.01, 0.07, 1.0, 30.0, 439.0];
    for (excess, fraction) in
        seams.into_iter().flat_map(|seam| [1e-12, 1e-6, 1e-3, 0.1].map(|part| (seam, part)))
    {
        let amplitude = Amplitude::from_period_excess(excess).unwrap();
        let change = amplitude.change_with_period(fraction);
        let ratio_at = |by: f64| {
            let moved = if amplitude.complement() < 1.0 {
                Angle::from_complement((amplitude.complement() - by).max(1e-320)).unwrap()
            } else {
                Angle::from_radians((amplitude.radians() + by).max(0.0)).unwrap()
            };
            Amplitude::new(moved).unwrap().period_excess()
        };
        let changed = [change, -change].map(|by| (ratio_at(by) - excess).abs() / (1.0 + excess));
        let largest = changed[0].max(changed[1]);
        assert!(largest >= fraction * (1.0 - 1e-3), "{excess}, {fraction}: {changed:?}");
        // The larger of the two changes is the stated fraction; the smaller one does not exceed it.
        let least = changed[0].min(changed[1]);
        let reaches_end = excess < fraction || excess + fraction * (1.0 + excess) > 440.08;
        assert!(reaches_end || least <= fraction * (1.0 + 1e-3), "{excess}, {fraction}: {changed:?}");
    }
    let at_rest = Amplitude::from_period_excess(0.0).unwrap().change_with_period(1e-4);
    assert!((at_rest - 0.04).abs() < 1e-5, "{at_rest}");
}
