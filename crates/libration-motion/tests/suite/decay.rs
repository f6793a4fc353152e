//! Damped pendulums compared with turning points in thirty digits, first integrals and closed forms; and the range of averaging.

use libration::decay::{
    Damping, Decay, DecayEnding, DecayError, EnvelopeLaw, PowerLawTerm, TurningPoint, cycle_integral,
    small_cycle_integral,
};
use libration::pendulum::{Amplitude, Pendulum};
use libration::quantity::Angle;
use libration_testing::golden::Table;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn amplitude(radians: f64) -> Amplitude {
    Amplitude::new(Angle::from_radians(radians).unwrap()).unwrap()
}

/// A damped pendulum with ω0 = 1; terms as (power, coefficient).
fn decay(terms: &[(f64, f64)], start: f64) -> Decay {
    of(Pendulum::from_angular_frequency(1.0).unwrap(), terms, start)
}

fn of(pendulum: Pendulum, terms: &[(f64, f64)], start: f64) -> Decay {
    let terms: Vec<PowerLawTerm> =
        terms.iter().map(|&(exponent, coefficient)| PowerLawTerm { exponent, coefficient }).collect();
    let start = Angle::from_radians(start).unwrap();
    Decay::new(pendulum, Damping::new(&terms).unwrap(), start).unwrap()
}

fn turns(decay: &Decay, count: usize) -> Vec<TurningPoint> {
    decay.swings().take(count).collect::<Result<_, _>>().unwrap()
}

fn terms_of(text: &str) -> Vec<(f64, f64)> {
    let term = |text: &str| {
        let (power, coefficient) = text.split_once(':').unwrap();
        (power.parse().unwrap(), coefficient.parse().unwrap())
    };
    text.split_whitespace().map(term).collect()
}

#[test]
fn turning_points_have_the_digits_of_the_table() {
    for row in Table::read("decay_turning_points.csv").rows() {
        let terms = terms_of(row.text("damping"));
        let number: usize = row.text("number").parse().unwrap();
        let turn = turns(&decay(&terms, row.input("start")), number + 1)[number];
        let whole = terms.iter().all(|(power, _)| power.fract() == 0.0);
        // A rounding error of the angle next to the top is relative to the distance from the top, 9e-5, which determines the time of the fall.
        let bound = if row.input("start") > 3.0 {
            2e-11
        } else if whole {
            2e-14
        } else {
            2e-13
        };
        let (time, angle) =
            (turn.time - row.input("time"), turn.amplitude.radians() - row.input("amplitude"));
        assert!(
            time.abs() < bound && angle.abs() < bound,
            "{}: {number}: {time:e} {angle:e}",
            row.text("damping")
        );
    }
}

#[test]
fn cycle_integrals_have_the_digits_of_the_table() {
    for row in Table::read("decay_cycles.csv").rows() {
        let (exponent, radians) = (row.input("exponent"), row.input("amplitude"));
        let error = cycle_integral(exponent, &amplitude(radians)) / row.input("loss") - 1.0;
        let bound = if [0.0, 1.0, 2.0, 3.0].contains(&exponent) { 2e-15 } else { 2e-14 };
        assert!(error.abs() < bound, "n = {exponent}, {radians} rad: {error:e}");
    }
}

#[test]
fn small_cycles_have_the_limit_of_the_exact_ones() {
    for exponent in [0.0, 0.3, 1.0, 1.83, 2.0, 3.0, 5.5] {
        // The neglected term is A² times a factor below one.
        let error = small_cycle_integral(exponent, 1e-6) / cycle_integral(exponent, &amplitude(1e-6)) - 1.0;
        assert!(error.abs() < 5e-12, "n = {exponent}: {error:e}");
    }
}

#[test]
fn dry_friction_takes_the_height_from_the_energy() {
    // cos A′ − cos A = c(A + A′) is the work of the friction.
    for start in [0.4, 1.0, 2.0, 3.1] {
        let turns = turns(&decay(&[(0.0, 0.02)], start), 9);
        for pair in turns.windows(2) {
            let [before, after] = [pair[0], pair[1]].map(|turn| turn.amplitude.radians());
            let gained = libm::cos(after) - libm::cos(before);
            assert!((gained - 0.02 * (after + before)).abs() < 2e-15, "from {before} to {after}");
        }
    }
}

#[test]
fn quadratic_damping_has_its_first_integral() {
    // e^(−2cθ)(2c sin θ + cos θ) is the same at both ends of a swing that goes up from −A to A′, with −c for c.
    let integral =
        |c: f64, angle: f64| libm::exp(2.0 * c * angle) * (libm::cos(angle) - 2.0 * c * libm::sin(angle));
    for (c, start) in [(0.1, 0.4), (0.5, 1.0), (2.0, 2.0), (0.01, 3.1)] {
        for pair in turns(&decay(&[(2.0, c)], start), 9).windows(2) {
            let [before, after] = [pair[0], pair[1]].map(|turn| turn.amplitude.radians());
            let (low, high) = (integral(c, -before), integral(c, after));
            assert!((high - low).abs() < 1e-14 * high.abs().max(1.0), "c = {c}, from {before} to {after}");
        }
    }
}

#[test]
fn viscous_damping_of_small_swings_is_the_damped_oscillator() {
    for c in [1e-3_f64, 0.1, 1.0, 1.9] {
        let frequency = (1.0 - 0.25 * c * c).sqrt();
        for (number, turn) in turns(&decay(&[(1.0, c)], 1e-9), 6).iter().enumerate() {
            let time = PI * f64::from(u32::try_from(number).unwrap()) / frequency;
            let left = 1e-9 * libm::exp(-0.5 * c * time);
            let late = turn.time - time;
            assert!(late.abs() < 1e-13 * time.max(1.0), "c = {c}: {number}: {late:e}");
            let error = turn.amplitude.radians() / left - 1.0;
            // The error of a swing is proportional to its initial amplitude.
            let begun = libm::exp(0.5 * c * PI / frequency);
            assert!(error.abs() < 1e-14 * begun, "c = {c}: {number}: {error:e}");
        }
    }
}

#[test]
fn the_law_of_small_amplitudes_has_its_closed_forms() {
    let start = 0.7;
    type Form = fn(f64) -> f64;
    let forms: [(&[(f64, f64)], Form); 7] = [
        (&[(0.0, 0.01)], |t| 0.7 - 2.0 * 0.01 * t / PI),
        (&[(1.0, 0.1)], |t| 0.7 * libm::exp(-0.05 * t)),
        (&[(2.0, 0.1)], |t| 0.7 / (1.0 + 4.0 * 0.1 * 0.7 * t / (3.0 * PI))),
        (&[(3.0, 0.1)], |t| 0.7 / (1.0 + 0.75 * 0.1 * 0.49 * t).sqrt()),
        (&[(0.0, 0.01), (1.0, 0.1)], |t| {
            let stop = 2.0 * 0.01 / (PI * 0.05);
            (0.7 + stop) * libm::exp(-0.05 * t) - stop
        }),
        (&[(1.0, 0.1), (2.0, 0.1)], |t| {
            let (a, b) = (0.05, 0.4 / (3.0 * PI));
            let decayed = 0.7 * libm::exp(-a * t);
            a * decayed / (a + b * (0.7 - decayed))
        }),
        (&[(0.0, 0.01), (2.0, 0.1)], |t| {
            let (a, b) = (0.02 / PI, 0.4 / (3.0 * PI));
            let root = (b / a).sqrt();
            libm::tan(libm::atan(0.7 * root) - (a * b).sqrt() * t) / root
        }),
    ];
    for (terms, form) in forms {
        let decay = decay(terms, start);
        for time in [0.0, 1e-9, 0.3, 4.0, 25.0] {
            let error = decay.envelope(EnvelopeLaw::SmallAmplitude).amplitude_at(time) - form(time);
            assert!(error.abs() < 1e-14, "{terms:?} at {time}: {error:e}");
        }
    }
}

#[test]
fn the_averaged_amplitude_falls_as_the_energy_says() {
    // A difference quotient of fourth order against −Σ c J/(T sin A).
    for (terms, start) in
        [(vec![(1.0, 0.1)], 3.0), (vec![(0.0, 0.05), (2.0, 0.1)], 1.5), (vec![(0.4, 0.1)], 0.2)]
    {
        let decay = decay(&terms, start);
        let envelope = decay.envelope(EnvelopeLaw::Averaged);
        let time = 1.3;
        let at = |steps: f64| envelope.amplitude_at(time + 1e-3 * steps);
        let slope = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / 12e-3;
        let now = amplitude(at(0.0));
        let loss: f64 = terms.iter().map(|&(n, c)| c * cycle_integral(n, &now)).sum();
        let wanted = -loss / (TAU * now.period_ratio() * libm::sin(now.radians()));
        assert!((slope / wanted - 1.0).abs() < 1e-10, "{terms:?}: {slope} {wanted}");
    }
}

#[test]
fn the_time_of_an_amplitude_is_when_it_is_reached() {
    for law in [EnvelopeLaw::Averaged, EnvelopeLaw::SmallAmplitude] {
        for start in [1e-3, 0.5, FRAC_PI_2, 3.0, PI] {
            let decay = decay(&[(0.5, 0.01), (1.0, 0.1), (2.0, 0.3)], start);
            let envelope = decay.envelope(law);
            for part in [1.0, 0.999, 0.7, 0.2, 1e-4] {
                let wanted = amplitude(start * part);
                let reached = envelope.amplitude_at(envelope.time_of(&wanted));
                assert!((reached / wanted.radians() - 1.0).abs() < 1e-13, "{law:?} from {start}: {part}");
            }
        }
    }
}

#[test]
fn the_error_of_averaging_falls_with_the_square_of_the_damping() {
    for exponent in [0.0, 1.0, 2.0, 3.0] {
        let error = |c: f64, turn: usize| {
            let decay = decay(&[(exponent, c)], 2.0);
            let turn = turns(&decay, turn + 1)[turn];
            decay.envelope(EnvelopeLaw::Averaged).amplitude_at(turn.time) - turn.amplitude.radians()
        };
        // The number of turns is inversely proportional to the damping: the amplitude is nearly the same.
        let ratio = error(0.02, 8) / error(0.01, 16);
        assert!((ratio - 4.0).abs() < 0.2, "n = {exponent}: {ratio}");
    }
}

#[test]
fn dry_friction_holds_the_pendulum_in_the_end() {
    let decay = decay(&[(0.0, 0.05)], 1.0);
    let mut swings = decay.swings();
    let last = swings.by_ref().last().unwrap().unwrap();
    assert_eq!(swings.ending(), Some(DecayEnding::Sticks));
    assert!(last.amplitude.radians() <= decay.sticking_amplitude());
    assert!((last.time - 28.905940906410518).abs() < 1e-13);
    assert!(swings.next().is_none());
}

#[test]
fn dry_friction_stops_it_before_the_bottom_too() {
    // Small swings with dry friction d go from d + s to d − s: they stop before the bottom if s is below d.
    for (start, turning_points) in [(0.06, 1), (0.09, 1), (0.18, 2)] {
        let decay = decay(&[(0.0, 0.05)], start);
        let mut swings = decay.swings();
        assert_eq!(swings.by_ref().count(), turning_points, "{start}");
        let Some(DecayEnding::StopsOnTheWay { time, angle }) = swings.ending() else { panic!("{start}") };
        // Each half swing takes π, and the last amplitude s goes to 2d − s, but for the part that the pendulum differs in.
        let last = start - 0.1 * f64::from(u32::try_from(turning_points).unwrap() - 1);
        assert!((angle - (0.1 - last)).abs() < 5e-4, "{start}: {angle}");
        assert!(
            (time - PI * f64::from(u32::try_from(turning_points).unwrap())).abs() < 0.01,
            "{start}: {time}"
        );
    }
    let held = decay(&[(0.0, 0.05)], 0.12);
    let mut held = held.swings();
    assert_eq!((held.by_ref().count(), held.ending()), (2, Some(DecayEnding::Sticks)));
    // By SciPy's DOP853 with an event: x″ = −sin x + 0.2 from 0.3 rad comes to rest after 3.17587 at 0.1033743 rad.
    let swings = decay(&[(0.0, 0.2)], 0.3);
    let mut swings = swings.swings();
    assert_eq!(swings.by_ref().count(), 1);
    let Some(DecayEnding::StopsOnTheWay { time, angle }) = swings.ending() else { panic!() };
    assert!((time - 3.17587).abs() < 1e-5 && (angle - 0.103_374_3).abs() < 1e-7, "{time} {angle}");
}

#[test]
fn dry_friction_holds_it_next_to_the_top_as_well() {
    let decay = decay(&[(0.0, 0.05)], PI - 0.04);
    let mut swings = decay.swings();
    assert_eq!(swings.by_ref().count(), 1);
    assert_eq!(swings.ending(), Some(DecayEnding::Sticks));
}

#[test]
fn strong_damping_lets_it_creep() {
    for (exponent, c) in [(1.0, 2.0), (1.0, 50.0), (0.5, 30.0)] {
        let decay = decay(&[(exponent, c)], 0.5);
        let mut swings = decay.swings();
        assert_eq!(swings.by_ref().map(Result::unwrap).count(), 1, "n = {exponent}, c = {c}");
        assert_eq!(swings.ending(), Some(DecayEnding::Creeps));
    }
    // Strong quadratic drag weakens, so that the pendulum swings.
    assert_eq!(turns(&decay(&[(2.0, 50.0)], 0.5), 4).len(), 4);
}

#[test]
fn an_amplitude_below_all_others_has_vanished() {
    // Half a cycle leaves e^(−1.8π/√(4 − 1.8²)) = e^−6.49 of the amplitude, 35 half cycles 3e-99.
    let decay = decay(&[(1.0, 1.8)], 0.5);
    let mut swings = decay.swings();
    assert_eq!(swings.by_ref().map(Result::unwrap).count(), 36);
    assert_eq!(swings.ending(), Some(DecayEnding::Vanishes));
}

#[test]
fn the_top_is_not_lost() {
    let start = Angle::from_complement(1e-100).unwrap();
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    let weak = Decay::new(pendulum, Damping::of_degree(2.0, 1e-9).unwrap(), start).unwrap();
    let turn = turns(&weak, 2)[1];
    // The fall to the bottom takes ln(8/δ); then the pendulum rises to within some 1e-4 of the top.
    assert!(turn.time > libm::log(8e100) && turn.time < libm::log(8e100) + 15.0, "{}", turn.time);
    // Half a cycle from the top reduces the energy by 4πc.
    let lost = 1.0 + libm::cos(turn.amplitude.radians());
    assert!((lost / (4.0 * PI * 1e-9) - 1.0).abs() < 1e-6, "{lost:e}");
}

#[test]
fn seconds_and_radians_are_units_only() {
    let pendulum = Pendulum::new(0.25, 9.81).unwrap();
    let frequency = pendulum.angular_frequency();
    let terms = [(0.0, 0.01), (1.0, 0.02), (2.0, 0.1), (2.7, 0.1)];
    let in_seconds = terms.map(|(n, c)| (n, c * libm::pow(frequency, 2.0 - n)));
    let (here, there) = (decay(&terms, 1.2), of(pendulum, &in_seconds, 1.2));
    for (one, other) in turns(&here, 8).iter().zip(turns(&there, 8)) {
        assert!((one.time / frequency - other.time).abs() < 1e-13);
        assert!((one.amplitude.radians() - other.amplitude.radians()).abs() < 1e-13);
        for law in [EnvelopeLaw::Averaged, EnvelopeLaw::SmallAmplitude] {
            let (one, other) =
                (here.envelope(law).amplitude_at(one.time), there.envelope(law).amplitude_at(other.time));
            assert!((one - other).abs() < 1e-13, "{law:?}");
        }
    }
}

#[test]
fn what_is_no_damping_is_refused() {
    assert!(matches!(Damping::new(&[]), Err(DecayError::NoDamping)));
    assert!(matches!(Damping::of_degree(1.0, 0.0), Err(DecayError::NoDamping)));
    assert!(matches!(Damping::of_degree(-0.1, 1.0), Err(DecayError::Exponent(_))));
    assert!(matches!(Damping::of_degree(f64::NAN, 1.0), Err(DecayError::Exponent(_))));
    assert!(matches!(Damping::of_degree(1.0, -1.0), Err(DecayError::Coefficient { .. })));
    assert!(matches!(Damping::of_degree(1.0, f64::INFINITY), Err(DecayError::Coefficient { .. })));
    let many: Vec<PowerLawTerm> =
        (0..17u8).map(|n| PowerLawTerm { exponent: f64::from(n), coefficient: 1.0 }).collect();
    assert!(matches!(Damping::new(&many), Err(DecayError::TooManyTerms(17))));
}

#[test]
fn what_is_no_start_is_refused() {
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    let start =
        |text: &str| Decay::new(pendulum, Damping::of_degree(1.0, 0.1).unwrap(), text.parse().unwrap());
    assert!(matches!(start("180deg"), Err(DecayError::Amplitude(_))));
    assert!(matches!(start("200deg"), Err(DecayError::Amplitude(_))));
    assert!(matches!(start("0deg"), Err(DecayError::AtRest(_))));
    let fast = Pendulum::from_angular_frequency(1e200).unwrap();
    let out = Decay::new(fast, Damping::of_degree(4.0, 0.1).unwrap(), "1rad".parse().unwrap());
    assert!(matches!(out, Err(DecayError::OutOfRange { .. })));
}

#[test]
fn the_loss_in_a_cycle_of_small_swings_is_that_of_the_harmonic_oscillator() {
    // Relative loss of energy: 2πc/ω0 by cθ′, 16cA/3 by cθ′|θ′|, with relative corrections of order A².
    let pendulum = || Pendulum::from_angular_frequency(3.0).unwrap();
    let small = amplitude(1e-4);
    for (terms, expected) in [
        (vec![(1.0, 0.01)], TAU * 0.01 / 3.0),
        (vec![(2.0, 0.05)], 16.0 * 0.05 * 1e-4 / 3.0),
        (vec![(1.0, 0.02), (2.0, 0.5)], TAU * 0.02 / 3.0 + 16.0 * 0.5 * 1e-4 / 3.0),
    ] {
        let loss = of(pendulum(), &terms, 1.0).loss_in_a_cycle(&small);
        assert!((loss / expected - 1.0).abs() < 1e-8, "{terms:?}: {loss}");
    }
    // For a small loss the energy decreases by 2δ when the amplitude decreases from A to A(1 − δ).
    let weak = of(pendulum(), &[(1.0, 1e-5)], 0.01);
    let after = turns(&weak, 3)[2].amplitude.radians();
    let fall = 2.0 * (1.0 - after / 0.01);
    assert!((weak.loss_in_a_cycle(&amplitude(0.01)) / fall - 1.0).abs() < 1e-4);
}
