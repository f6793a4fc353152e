//! Times of a photogate with known truth: edges by the integrator, with jitter, missing and double ones.

use libration::progress::{Interrupted, Quiet, Status};
use libration::quantity::Quantity;
use libration_lab::fit::gates::{
    GateGeometry, GateGeometryError, GateOptions, GateSignals, GatesError, GatesFit, GatesWarning, T0Source,
    fit_gates,
};
use libration_lab::fit::{Apparatus, Bob, BudgetInput, Corrections, PeriodDamping};

use crate::random::Random;
use crate::synthetic_gate::{GateRecord, jittered};
use std::cell::Cell;
use std::ops::ControlFlow;

const OMEGA0: f64 = 3.2;
const T0: f64 = std::f64::consts::TAU / OMEGA0;
/// Width of the bob, as an angle.
const WIDTH: f64 = 0.026;
const RELEASE: f64 = 0.9;

/// A pendulum with a ball of this radius.
fn with_ball(length: Quantity, radius: Option<Quantity>) -> Apparatus {
    Apparatus { length, corrections: Corrections { bob: radius.map(Bob::ball), ..Corrections::default() } }
}

fn exactly(value: f64) -> Quantity {
    Quantity { value, uncertainty: None }
}

/// Times at which the bob blocks or frees a gate at this angle, with `true` if it blocks it, for 60 s.
fn edges(gate: f64, jitter: f64) -> Vec<(f64, bool)> {
    edges_from(RELEASE, gate, jitter)
}

/// The edges after another release.
fn edges_from(release: f64, gate: f64, jitter: f64) -> Vec<(f64, bool)> {
    let record = GateRecord { omega0: OMEGA0, damping: 0.02, release, gate, width: WIDTH, seconds: 60.0 };
    jittered(&record.edges(), jitter, &mut Random::seeded(7))
}

fn split(edges: &[(f64, bool)]) -> (Vec<f64>, Vec<bool>) {
    edges.iter().copied().unzip()
}

/// The middles of the passages.
fn middles(edges: &[(f64, bool)]) -> Vec<f64> {
    edges.chunks_exact(2).map(|pair| 0.5 * (pair[0].0 + pair[1].0)).collect()
}

/// The fit of edges of an object with this angular width.
fn fitted_with(times: &[f64], blocked: &[bool], width: Quantity) -> GatesFit {
    let options = GateOptions { width: Some(width), ..GateOptions::default() };
    fit_gates(times, Some(blocked), &options, &Quiet).unwrap()
}

fn with_width() -> GateOptions {
    GateOptions { width: Some(exactly(WIDTH)), ..GateOptions::default() }
}

fn agrees(fit: &GatesFit, most: f64) {
    let t0 = fit.t0.unwrap();
    let uncertainty = t0.uncertainty;
    assert!((t0.value - T0).abs() < 4.0 * uncertainty + 1e-5, "{t0:?}");
    assert!(uncertainty < most, "{t0:?}");
}

#[test]
fn speeds_at_the_gate_give_t0_and_the_exact_law_wherever_it_stands() {
    for gate in [0.0, 0.15, -0.2] {
        let (times, blocked) = split(&edges(gate, 1e-5));
        let fit = fit_gates(&times, Some(&blocked), &with_width(), &Quiet).unwrap();
        assert_eq!((fit.unpaired, fit.double_triggers, fit.missed), (0, 0, 0));
        assert_eq!(fit.t0_source, Some(T0Source::Speeds));
        agrees(&fit, 1e-3);
        let beta = fit.beta.unwrap();
        assert!((beta.factor.value - 1.0).abs() < 4.0 * beta.factor.uncertainty + 1e-3, "{beta:?}");
        let first = fit.cycles[0].amplitude.unwrap();
        assert!((first - RELEASE).abs() < 0.03, "{first}");
        assert!((fit.part_between - 0.5).abs() > 0.3 * gate.abs(), "{}", fit.part_between);
    }
}

#[test]
fn edges_without_states_are_told_from_their_pattern() {
    let (times, blocked) = split(&edges(0.1, 1e-5));
    let with = fit_gates(&times, Some(&blocked), &with_width(), &Quiet).unwrap();
    let without = fit_gates(&times, None, &with_width(), &Quiet).unwrap();
    assert!(without.edges);
    assert_eq!(with.t0, without.t0);
}

#[test]
fn the_jitter_of_the_times_is_found() {
    let jitter = 2e-4;
    let (times, blocked) = split(&edges(0.0, jitter));
    let fit = fit_gates(&times, Some(&blocked), &with_width(), &Quiet).unwrap();
    // The middle of two edges has 1/√2 of it; some fifty differences tell that to a sixth or so.
    assert!((fit.timing.unwrap() / (jitter / 2.0_f64.sqrt()) - 1.0).abs() < 0.4, "{:?}", fit.timing);
}

#[test]
fn passages_missing_and_twice_are_counted_and_change_nothing() {
    let clean = middles(&edges(0.2, 1e-5));
    let options = GateOptions { amplitude: Some(exactly(RELEASE)), ..GateOptions::default() };
    let whole = fit_gates(&clean, None, &options, &Quiet).unwrap();
    let without = clean.iter().enumerate().filter(|(k, _)| ![11, 20, 21].contains(k)).map(|(_, &time)| time);
    let doubled = [5, 30].map(|k| clean[k] + 0.004);
    let mut spoilt: Vec<f64> = without.chain(doubled).collect();
    spoilt.sort_by(f64::total_cmp);
    let fit = fit_gates(&spoilt, None, &options, &Quiet).unwrap();
    assert_eq!((fit.double_triggers, fit.missed), (2, 3));
    assert!((fit.t0.unwrap().value - whole.t0.unwrap().value).abs() < 2e-4);
    assert_eq!(
        fit.warnings,
        [GatesWarning::DoubleTriggers { passages: 2 }, GatesWarning::MissedPassages { passages: 3 }]
    );
    assert_eq!(whole.warnings, []);
}

#[test]
fn the_amplitude_of_the_release_gives_t0() {
    let options =
        GateOptions { amplitude: Some(exactly(RELEASE)), signals: Some(GateSignals::Passages), width: None };
    for gate in [0.0, 0.2] {
        let fit = fit_gates(&middles(&edges(gate, 1e-5)), None, &options, &Quiet).unwrap();
        assert_eq!(fit.t0_source, Some(T0Source::FirstAmplitude));
        agrees(&fit, 2e-3);
    }
}

/// ω0² = 9.81 s⁻², dry friction of 0.02 s⁻² and no other damping, released at 10°: passages of the centre by SciPy's DOP853 to 1e-12.
#[test]
fn dry_friction_is_in_the_uncertainty_of_t0_by_the_release() {
    #[rustfmt::skip]
    const PASSAGES: [f64; 42] = [
        0.506267564, 1.511217099, 2.516084418, 3.520872013, 4.525582408, 5.530218170, 6.534781905, 7.539276274,
        8.543703995, 9.548067856, 10.552370722, 11.556615554, 12.560805418, 13.564943509, 14.569033174, 15.573077936,
        16.577081533, 17.581047958, 18.584981512, 19.588886875, 20.592769186, 21.596634156, 22.600488206, 23.604338657,
        24.608193973, 25.612064097, 26.615960902, 27.619898834, 28.623895809, 29.627974532, 30.632164457, 31.636504793,
        32.641049285, 33.645874105, 34.651091514, 35.656874905, 36.663508093, 37.671491530, 38.681800727, 39.696632430,
        40.722219725, 41.786564011,
    ];
    let release = exactly(10_f64.to_radians());
    let options = GateOptions { amplitude: Some(release), signals: Some(GateSignals::Passages), width: None };
    for passages in [&PASSAGES[..], &PASSAGES[..16]] {
        let t0 = fit_gates(passages, None, &options, &Quiet).unwrap().t0.unwrap();
        let truth = std::f64::consts::TAU / libm::sqrt(9.81);
        assert!(t0.deviation_from(truth) < 3.0 && t0.uncertainty < 2e-4 * truth, "{t0:?} and not {truth}");
    }
}

/// Times without information on their scatter: exactly even ones, as in simulations, and those of three passages.
#[test]
fn times_that_do_not_tell_their_scatter_are_said_to() {
    let even: Vec<f64> = (0..20).flat_map(|k| [2.0 * f64::from(k), 2.0 * f64::from(k) + 1.2]).collect();
    let unknown = |times: &[f64]| {
        fit_gates(times, None, &GateOptions::default(), &Quiet)
            .unwrap()
            .warnings
            .contains(&GatesWarning::ScatterUnknown)
    };
    assert!(unknown(&even));
    let mut random = Random::seeded(3);
    let uneven: Vec<f64> = even.iter().map(|time| time + 1e-4 * random.normal()).collect();
    assert!(!unknown(&uneven));
    let few = fit_gates(&uneven[..4], None, &GateOptions::default(), &Quiet).unwrap();
    assert!(few.timing.is_none() && few.warnings.contains(&GatesWarning::ScatterUnknown), "{few:?}");
}

#[test]
fn without_an_amplitude_t0_is_not_known_and_said() {
    let fit = fit_gates(&middles(&edges(0.0, 1e-5)), None, &GateOptions::default(), &Quiet).unwrap();
    assert!(fit.t0.is_none());
    assert_eq!(fit.warnings, [GatesWarning::NoAmplitude]);
    assert!(fit.mean_period.value > T0);
    // An amplitude that is far too large makes T0 longer than any period, which no pendulum has.
    let wrong = GateOptions { amplitude: Some(exactly(0.01)), ..GateOptions::default() };
    let fit = fit_gates(&middles(&edges(0.0, 1e-5)), None, &wrong, &Quiet).unwrap();
    assert!(matches!(fit.warnings[..], [GatesWarning::PeriodBelowT0 { .. }]), "{:?}", fit.warnings);
    let cycles = &fit.cycles[fit.cycles.len() - 2..];
    let last = 0.5 * (cycles[0].period + cycles[1].period);
    assert!(fit.warnings[0].to_string().contains(&format!("{last:.3}")), "{}", fit.warnings[0]);
}

#[test]
fn times_of_no_pendulum_are_refused() {
    let refused = |times: &[f64]| fit_gates(times, None, &GateOptions::default(), &Quiet).unwrap_err();
    assert!(matches!(refused(&[0.0, 1.0]), GatesError::TooFew { .. }));
    assert!(matches!(refused(&[0.0, f64::INFINITY]), GatesError::NotFinite(_)));
    assert!(matches!(refused(&[]), GatesError::TooFew { passages: 0 }));
    assert!(matches!(refused(&[1.0; 9]), GatesError::TooFew { .. }));
    let mut random = Random::seeded(1);
    let mut noise: Vec<f64> = (0..60).map(|_| random.between(0.0, 60.0)).collect();
    noise.sort_by(f64::total_cmp);
    let outcome = fit_gates(
        &noise,
        None,
        &GateOptions { signals: Some(GateSignals::Passages), ..GateOptions::default() },
        &Quiet,
    );
    assert!(matches!(outcome, Err(GatesError::Irregular { .. })), "{outcome:?}");
    let wide = GateOptions { width: Some(exactly(4.0)), ..GateOptions::default() };
    assert!(matches!(fit_gates(&[0.0, 1.0, 2.0], None, &wide, &Quiet), Err(GatesError::NotUsable { .. })));
}

/// The whole calculation with a bob that is a little wider and narrower.
#[test]
fn the_change_of_t0_with_the_width_is_that_of_the_whole_calculation() {
    let (times, blocked) = split(&edges(0.1, 1e-5));
    let of_width = |factor: f64| {
        let width = Some(Quantity { value: WIDTH * factor, uncertainty: Some(0.01 * WIDTH) });
        fit_gates(&times, Some(&blocked), &GateOptions { width, ..GateOptions::default() }, &Quiet).unwrap()
    };
    let fit = of_width(1.0);
    // Less than a standard deviation of β, so that the rows do not contradict the law.
    let part = 1e-4;
    let wanted = (of_width(1.0 + part).t0.unwrap().value - of_width(1.0 - part).t0.unwrap().value)
        / (2.0 * part * WIDTH);
    let slope = fit.t0_by_width.unwrap();
    assert!((slope / wanted - 1.0).abs() < 1e-3, "{slope} {wanted}");
    // The width is nearly all that makes this T0 uncertain.
    let correlation = fit.correlation_by_width(0.01 * WIDTH).unwrap();
    assert!((-1.0..-0.9).contains(&correlation), "{correlation}");
    assert!(fit.t0_degrees_of_freedom > 1000.0);
    let exact = fit_gates(&times, Some(&blocked), &with_width(), &Quiet).unwrap();
    assert!((10.0..100.0).contains(&exact.t0_degrees_of_freedom), "{}", exact.t0_degrees_of_freedom);
    let bare = GateOptions { amplitude: Some(exactly(RELEASE)), ..GateOptions::default() };
    assert_eq!(fit_gates(&times, Some(&blocked), &bare, &Quiet).unwrap().correlation_by_width(1e-3), None);
}

#[test]
fn a_width_that_gives_no_speeds_is_said_to_be_of_no_use() {
    let (times, blocked) = split(&edges(0.0, 1e-5));
    // A bob of a metre would be so fast that the pendulum goes over the top.
    let wide = GateOptions { width: Some(exactly(1.0)), ..GateOptions::default() };
    let fit = fit_gates(&times, Some(&blocked), &wide, &Quiet).unwrap();
    assert!(fit.warnings.contains(&GatesWarning::WidthUnused { edges: true }), "{:?}", fit.warnings);
    let fit = fit_gates(&middles(&edges(0.0, 1e-5)), None, &with_width(), &Quiet).unwrap();
    assert!(fit.warnings.contains(&GatesWarning::WidthUnused { edges: false }), "{:?}", fit.warnings);
    assert_eq!(fit_gates(&times, Some(&blocked), &with_width(), &Quiet).unwrap().warnings, []);
}

#[test]
fn edges_without_the_other_one_are_told() {
    let mut all = edges(0.0, 1e-5);
    all.remove(21);
    let (times, blocked) = split(&all);
    let fit = fit_gates(&times, Some(&blocked), &with_width(), &Quiet).unwrap();
    assert!(
        fit.warnings.contains(&GatesWarning::UnpairedEdges { edges: fit.unpaired }),
        "{:?}",
        fit.warnings
    );
    assert!(fit.unpaired > 0);
}

/// 25 mm seen from 1 m, a chord of the circle of the middle; the relative uncertainties are 3 and 4 parts in a thousand.
#[test]
fn the_width_is_the_angle_of_the_bob_at_the_gate() {
    let about = |value: f64, part: f64| Quantity { value, uncertainty: Some(part * value) };
    let length = about(1.0, 0.004);
    let bob = with_ball(length, Some(about(0.0125, 0.003)));
    let geometry = GateGeometry::new(bob, None, None).unwrap();
    let width = geometry.width().unwrap();
    assert!((width.value - 4.0 * libm::asin(0.00625)).abs() < 1e-15);
    assert!((width.uncertainty.unwrap() / (0.025 * 0.005) - 1.0).abs() < 1e-4);
    let nearer = GateGeometry::new(bob, Some(exactly(0.02)), Some(exactly(0.5))).unwrap();
    let nearer_width = nearer.width().unwrap();
    assert!((nearer_width.value - 4.0 * libm::asin(0.01)).abs() < 1e-15);
    assert_eq!(nearer_width.uncertainty, Some(0.0));
    let unknown = GateGeometry::new(Apparatus::of_length(length), None, None).unwrap();
    assert_eq!(unknown.width(), None);
    // T0 has in common with length and radius what they do to the width; with a diameter and a distance of their own, nothing.
    let (times, blocked) = split(&edges(0.0, 1e-5));
    let fit = fitted_with(&times, &blocked, width);
    let inputs: Vec<BudgetInput> = fit.correlations(&geometry).iter().map(|both| both.between[0]).collect();
    assert_eq!(inputs, [BudgetInput::Length, BudgetInput::BobRadius]);
    let [by_length, by_radius] = [0, 1].map(|index| fit.correlations(&geometry)[index].coefficient);
    // Opposite signs, in the proportion of the uncertainties.
    assert!((by_length / by_radius + 4.0 / 3.0).abs() < 1e-9, "{by_length} {by_radius}");
    assert_eq!(fit.correlations(&nearer), []);
}

/// 10 mm below its middle a ball of 25 mm is 15 mm wide; each of the three sizes changes that, and length and radius change g too.
#[test]
fn a_gate_off_the_middle_of_the_bob_sees_a_chord() {
    let about = |value: f64| Quantity { value, uncertainty: Some(1e-4) };
    let at = |length: f64, radius: f64, distance: f64| {
        let bob = with_ball(about(length), Some(about(radius)));
        GateGeometry::new(bob, None, Some(about(distance))).unwrap()
    };
    let geometry = at(1.0, 0.0125, 1.01);
    let width = geometry.width().unwrap();
    assert!((width.value - 0.015 / 1.01).abs() < 1e-4, "{width:?}");
    let moved = [[1e-4, 0.0, 0.0], [0.0, 1e-4, 0.0], [0.0, 0.0, 1e-4]].map(|[a, b, c]| {
        let widths = [1.0, -1.0]
            .map(|sign| at(1.0 + sign * a, 0.0125 + sign * b, 1.01 + sign * c).width().unwrap().value);
        0.5 * (widths[0] - widths[1])
    });
    let expected = moved.iter().map(|change| change * change).sum::<f64>().sqrt();
    assert!((width.uncertainty.unwrap() / expected - 1.0).abs() < 1e-3, "{width:?} {expected}");
    let (times, blocked) = split(&edges(0.0, 1e-5));
    let fit = fitted_with(&times, &blocked, width);
    let coefficients: Vec<f64> = fit.correlations(&geometry).iter().map(|both| both.coefficient).collect();
    assert_eq!(coefficients.len(), 2);
    assert!(
        (coefficients[0] / coefficients[1] / (moved[0] / moved[1]) - 1.0).abs() < 1e-3,
        "{coefficients:?} {moved:?}"
    );
}

#[test]
fn what_blocks_the_gate_is_below_the_pivot_and_reaches_the_gate() {
    let apparatus = |radius: Option<f64>| with_ball(exactly(1.0), radius.map(exactly));
    let tried = |radius: Option<f64>, diameter: Option<f64>, distance: Option<f64>| {
        GateGeometry::new(apparatus(radius), diameter.map(exactly), distance.map(exactly)).map(|_| ())
    };
    for (diameter, distance) in [(2.0, None), (0.025, Some(0.0125))] {
        let refused = tried(None, Some(diameter), distance);
        let distance = distance.unwrap_or(1.0);
        assert_eq!(refused, Err(GateGeometryError::ReachesPivot { diameter, distance }));
        assert_eq!(tried(None, Some(diameter.next_down()), Some(distance)), Ok(()));
    }
    assert_eq!(
        tried(Some(1.5), None, None),
        Err(GateGeometryError::ReachesPivot { diameter: 3.0, distance: 1.0 })
    );
    for distance in [40.0, 1.25, 0.75] {
        let refused = tried(Some(0.25), None, Some(distance));
        assert_eq!(refused, Err(GateGeometryError::BobMissesGate { radius: 0.25, length: 1.0, distance }));
        // A flag above or below the bob is what blocks it.
        assert_eq!(tried(Some(0.25), Some(0.01), Some(distance)), Ok(()));
    }
    // A large bob about a gate above its middle reaches below the pivot.
    assert_eq!(tried(Some(0.6), None, Some(0.5)), Ok(()));
    assert_eq!(tried(Some(0.25), None, Some(1.25_f64.next_down())), Ok(()));
    assert_eq!(tried(Some(0.25), None, Some(0.75_f64.next_up())), Ok(()));
}

/// A release at 132°, where the period is 1.6 times that of small swings, which most later passages have.
#[test]
fn passages_of_large_amplitudes_are_no_double_triggers() {
    let (times, blocked) = split(&edges_from(2.3, 0.0, 1e-6));
    let fit = fit_gates(&times, Some(&blocked), &with_width(), &Quiet).unwrap();
    assert_eq!((fit.double_triggers, fit.missed, fit.warnings.len()), (0, 0, 0), "{:?}", fit.warnings);
    assert!(fit.cycles[0].amplitude.unwrap() > 2.1);
    agrees(&fit, 1e-3);
}

/// A gate near the turning point: the passages of one side come later as the amplitude falls, so that its periods are too long, and those of the
/// other side too short.
#[test]
fn periods_of_one_side_below_t0_are_no_error() {
    let (times, blocked) = split(&edges_from(0.3, 0.14, 1e-6));
    let fit = fit_gates(&times, Some(&blocked), &with_width(), &Quiet).unwrap();
    let t0 = fit.t0.unwrap();
    let below = |period: f64| t0.value - 3.0 * t0.uncertainty > period + 6.0 * fit.timing.unwrap();
    assert!(fit.cycles.iter().any(|cycle| below(cycle.period)), "no period of one side is below {t0:?}");
    assert_eq!(fit.warnings, []);
}

#[test]
fn a_width_that_contradicts_the_exact_law_is_doubted() {
    let (times, blocked) = split(&edges(0.1, 1e-5));
    let warned = |factor: f64| {
        let options = GateOptions { width: Some(exactly(factor * WIDTH)), ..GateOptions::default() };
        fit_gates(&times, Some(&blocked), &options, &Quiet).unwrap().warnings
    };
    assert_eq!(warned(1.0), []);
    // Below a fortieth nothing is said, though β is many of its uncertainties from 1.
    assert_eq!(warned(1.02), []);
    let wide = warned(1.05);
    let [GatesWarning::BetaNotOne { width_error: Some(part), .. }] = wide[..] else { panic!("{wide:?}") };
    assert!((part / 0.05 - 1.0).abs() < 0.25, "{part}");
    let far = warned(0.4);
    assert!(matches!(far[..], [GatesWarning::BetaNotOne { width_error: None, .. }, ..]), "{far:?}");
}

#[test]
fn fits_of_gates_stop_at_any_question() {
    let (times, blocked) = split(&edges(0.1, 1e-5)[..20]);
    let asked_until = |last: usize| {
        let questions = Cell::new(0);
        let progress = |_: Status| {
            questions.set(questions.get() + 1);
            if questions.get() == last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let outcome = fit_gates(&times, Some(&blocked), &with_width(), &progress);
        (outcome, questions.get())
    };
    let (whole, questions) = asked_until(usize::MAX);
    assert!(questions > 100, "{questions}");
    assert_eq!(whole, fit_gates(&times, Some(&blocked), &with_width(), &Quiet));
    for last in [1, 2, questions / 3, questions - 1, questions] {
        assert_eq!(asked_until(last), (Err(GatesError::Interrupted(Interrupted)), last));
    }
}

/// A width 1 to 5 % too large or too small refutes the model: it is the first warning and a row of the budget, and g is off by at most 2.5
/// uncertainties.
#[test]
fn a_wrong_width_is_a_row_of_the_budget() {
    let (times, blocked) = split(&edges(0.0, 1e-5));
    let length = Quantity { value: 0.958, uncertainty: Some(1e-4) };
    let geometry = GateGeometry::new(Apparatus::of_length(length), None, None).unwrap();
    let with = |width: f64| {
        let fit = fitted_with(&times, &blocked, exactly(width));
        let budget = fit.gravity(&geometry, None, None, PeriodDamping::Unknown, &[]).unwrap().unwrap();
        (fit, budget)
    };
    let (right, without) = with(WIDTH);
    assert_eq!(right.contradiction, None);
    assert!(without.rows.iter().all(|row| row.name != "model"));
    for part in [0.95, 0.97, 0.99, 1.01, 1.03, 1.05] {
        let (fit, budget) = with(part * WIDTH);
        let t0 = fit.t0.unwrap();
        assert!(
            t0.deviation_from(T0) < 2.5 && t0.uncertainty > right.t0.unwrap().uncertainty,
            "{part}: {t0:?}"
        );
        let model = fit.contradiction.as_ref().unwrap().uncertainty();
        let row = budget.rows.iter().find(|row| row.name == "model").unwrap();
        assert!(
            (row.uncertainty.unwrap() / (2.0 * budget.g * model / t0.value) - 1.0).abs() < 1e-3,
            "{row:?}"
        );
        if (part - 1.0_f64).abs() > 0.025 {
            assert!(matches!(fit.warnings[0], GatesWarning::BetaNotOne { .. }), "{part}: {:?}", fit.warnings);
        }
    }
}

/// T0 is that of the damped motion: without the correction g would be up to 47 of its uncertainties too small.
#[test]
fn gravity_is_that_without_the_damping_that_the_amplitudes_show() {
    for damping in [0.02, 0.1, 0.2] {
        let record =
            GateRecord { omega0: OMEGA0, damping, release: 0.3, gate: 0.0, width: WIDTH, seconds: 40.0 };
        let (times, blocked) = split(&jittered(&record.edges(), 1e-4, &mut Random::seeded(3)));
        let fit = fitted_with(&times, &blocked, exactly(WIDTH));
        let length = 9.81 / (OMEGA0 * OMEGA0);
        let geometry = GateGeometry::new(Apparatus::of_length(exactly(length)), None, None).unwrap();
        let of = |damping| fit.gravity(&geometry, None, None, damping, &[]).unwrap().unwrap();
        let (observed, left) = (of(PeriodDamping::Unknown), of(PeriodDamping::Fitted(0.0)));
        assert!((fit.drag.unwrap() / damping - 1.0).abs() < 0.05, "{damping}: {:?}", fit.drag);
        assert!((observed.g - 9.81).abs() < 3.0 * observed.uncertainty, "{damping}: {observed:?}");
        let effect = 0.25 * damping * damping / (OMEGA0 * OMEGA0);
        assert!(
            (observed.g / left.g - 1.0 - effect).abs() < 0.1 * effect,
            "{damping}: {observed:?} {left:?}"
        );
        assert!(observed.uncertainty > 0.4 * effect * 9.81, "{damping}: {observed:?}");
    }
}
