//! Long calls that are told to stop at one of their questions.

use libration::chaos::{
    Continuation, Family, LyapunovError, Points, Schedule, Section, bifurcation_diagram, lyapunov_exponent,
    section,
};
use libration::comparison::{
    Backbone, ExactMotion, LeadingLimitCycles, NoExactValue, NoLeadingLimitCycles, SeriesComparison,
    SeriesQuantity,
};
use libration::continuation::{NoBranch, Response, ResponseOptions};
use libration::expression::Equation;
use libration::melnikov::{DriveResonance, Melnikov, NoMelnikov, PerturbedPendulum, thresholds};
use libration::normal_form::{NoNormalForm, NormalForm};
use libration::normal_modes::{NoModes, NormalModes};
use libration::orbit::{NoOrbit, Orbit, OrbitGuess};
use libration::oscillator::{Oscillator, SymbolicOscillator};
use libration::period_formulas::{ErrorTable, catalogue};
use libration::perturbation::{
    EpsilonPowers, ExpansionError, Gauge, OpenGauge, OpenGaugeError, SlowFlowError, SymbolicExpansionError,
    TruncatedSystem, TruncatedSystemError, expand, expand_symbolically, restoring_force, slow_flow,
};
use libration::progress::{Interrupted, Progress, Quiet, Status};
use libration::quantity::Displacement;
use libration::taylor::{Effort, Moment};
use std::cell::Cell;
use std::fmt::Debug;
use std::ops::ControlFlow;

/// Result of a call that is cancelled at the n-th time that it consults the watch, and the number of these times.
fn stopped_at<T>(n: usize, call: &impl Fn(&dyn Progress) -> T) -> (T, usize) {
    let questions = Cell::new(0);
    let ask = |_: Status| {
        questions.set(questions.get() + 1);
        if questions.get() == n { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let found = call(&ask);
    (found, questions.get())
}

/// Stops a call at the first, the last and some other questions; it must ask no more, and what it gives then must be right.
/// Watched to its end it gives what it gives unwatched.
fn stops<T: Debug + PartialEq>(call: impl Fn(&dyn Progress) -> T, is_right: impl Fn(&T, &T) -> bool) {
    let whole = call(&Quiet);
    let (watched, questions) = stopped_at(usize::MAX, &call);
    assert!(questions > 1, "{questions} questions");
    assert_eq!(watched, whole);
    for n in [1, 2, questions / 3 + 1, questions / 2 + 1, questions] {
        let (found, asked) = stopped_at(n, &call);
        assert_eq!(
            asked,
            n.min(questions),
            "asked again after it was stopped at question {n} of {questions}"
        );
        assert!(is_right(&found, &whole), "stopped at question {n} of {questions}: {found:?}");
    }
}

fn equation(text: &str) -> Equation {
    text.parse().unwrap()
}

fn at(state: &[f64]) -> Moment {
    Moment { time: 0.0, state: state.to_vec() }
}

/// Orbits have no equality: their period and their start decide.
fn in_numbers(orbit: Result<Orbit, NoOrbit>) -> Result<(f64, Vec<f64>), NoOrbit> {
    orbit.map(|orbit| (orbit.period(), orbit.start()))
}

fn no_orbit<T>(found: &Result<T, NoOrbit>, _: &Result<T, NoOrbit>) -> bool {
    matches!(found, Err(NoOrbit::Interrupted(Interrupted)))
}

#[test]
fn searches_of_orbits_stop_at_any_question() {
    let pendulum = equation("theta'' = -sin(theta)");
    // In double precision, and next to the separatrix with more bits.
    for place in [1.0, 3.141_592_653] {
        stops(|watch| in_numbers(Orbit::released(&pendulum, place, watch)), no_orbit);
    }
    let van_der_pol = equation("x'' = (1 - x^2)*x' - x");
    stops(|watch| in_numbers(Orbit::limit_cycle(&van_der_pol, &[0.1, 0.0], watch)), no_orbit);
    let pair = equation("x'' = y - 2*x - (x - y)^3; y'' = x - 2*y + (x - y)^3");
    let guess = OrbitGuess { state: vec![0.1, -0.1, 0.0, 0.0], period: 3.6 };
    stops(|watch| in_numbers(Orbit::near(&pair, &guess, &[0, 2], watch)), no_orbit);
    let driven = equation("x'' = -x - x^3 - x'/5 + cos(t)");
    let period = std::f64::consts::TAU;
    stops(|watch| in_numbers(Orbit::driven(&driven, period, &[1.0, 0.2], watch)), no_orbit);
}

#[test]
fn normal_forms_stop_before_the_next_order() {
    let coupled = equation("x'' = -x - x*y; y'' = -4*y - x^2/2");
    let terms = |form: NormalForm| form.slow_terms;
    stops(
        |watch| NormalForm::about(&coupled, &[0.0, 0.0], 4, 0.1, watch).map(terms),
        |found, whole| {
            matches!(found, Err(NoNormalForm::Interrupted(_) | NoNormalForm::NoModes(_))) && whole.is_ok()
        },
    );
}

#[test]
fn resonances_stop_before_the_next() {
    let driven = PerturbedPendulum::new(&equation("x'' = -0.1*x' - sin(x) + 0.3*cos(t)")).unwrap();
    let places = |found: Vec<DriveResonance>| -> Vec<(u32, f64)> {
        found.iter().map(|it| (it.drive_periods, it.half_width)).collect()
    };
    stops(
        |watch| driven.resonances(4, watch).map(places),
        |found, whole| *found == Err(Interrupted) && whole.is_ok(),
    );
}

#[test]
fn branches_stop_with_the_points_that_are_followed() {
    let duffing = equation("x'' = -0.2*x' - x - x^3 + 0.3*cos(w*t)");
    let options = ResponseOptions { generations: 0, ..ResponseOptions::default() };
    stops(
        |watch| Response::over(&duffing, "w", [0.9, 1.0], &options, watch),
        |found, whole| match (found, whole) {
            (Err(error), _) => *error == NoBranch::Interrupted(Interrupted),
            (Ok(found), Ok(whole)) => {
                let (part, all) = (&found.branches[0].points, &whole.branches[0].points);
                found.interrupted && part[..] == all[..part.len()]
            }
            _ => false,
        },
    );
}

#[test]
fn expansions_stop_with_the_orders_that_are_certain() {
    for text in ["x'' = -sin(x)", "x'' = mu*(1 - x^2)*x' - x", "x'' = -x - sqrt(2)*x^2"] {
        let oscillator = Oscillator::new(&equation(text)).unwrap();
        stops(
            |watch| expand(&oscillator, 17, &Gauge::Fundamental, watch),
            |found, whole| match (found, whole) {
                (Err(ExpansionError::Interrupted { known: None }), _) => true,
                (Err(ExpansionError::Interrupted { known: Some(known) }), Ok(whole)) => {
                    whole.frequency_ratio.starts_with(&known.frequency_ratio)
                }
                _ => false,
            },
        );
    }
}

#[test]
fn expansions_with_letters_stop_with_the_orders_that_are_found() {
    for text in ["x'' + w^2*x + a*x^2 + b*x^3 = 0", "x'' + (k + m)*x + b*x*x'^2 = 0"] {
        let oscillator = SymbolicOscillator::new(&equation(text)).unwrap();
        stops(
            |watch| expand_symbolically(&oscillator, 7, &Gauge::Fundamental, watch),
            |found, whole| match (found, whole) {
                (Err(SymbolicExpansionError::Interrupted { known: Some(known) }), Ok(whole)) => {
                    whole.series.frequency_ratio.starts_with(&known.series.frequency_ratio)
                }
                _ => false,
            },
        );
    }
}

#[test]
fn slow_flows_stop_at_any_question() {
    let damped = equation("x'' + c*x'*abs(x') + sin(x) = 0");
    stops(
        |watch| slow_flow(&damped, None, 4, 2, &Gauge::XMax, watch),
        |found, _| *found == Err(SlowFlowError::Interrupted),
    );
}

#[test]
fn equations_of_harmonics_stop_at_any_question() {
    let pendulum = Oscillator::new(&equation("x'' = -sin(x)")).unwrap();
    let force = restoring_force(&pendulum, 9).unwrap();
    stops(
        |watch| {
            let open = OpenGauge::new(&force, 7, EpsilonPowers::OneParity, watch);
            open.map(|open| open.conditions().to_vec())
        },
        |found, _| matches!(found, Err(OpenGaugeError::Interrupted(_))),
    );
    let system = TruncatedSystem::new(&force, 2, 3).unwrap();
    stops(
        |watch| system.solutions(1.0, watch).map(|all| all[0].frequency_ratio_squared),
        |found, _| matches!(found, Err(TruncatedSystemError::Interrupted(_))),
    );
}

#[test]
fn backbones_and_exact_values_stop_at_any_question() {
    let duffing = equation("x'' = -x - x^3");
    let curve = Backbone::new(&duffing, None, 9, &Quiet).unwrap();
    stops(
        |watch| curve.at(0.5, watch),
        |found, whole| no_orbit(&found.orbit, &whole.orbit) && found.series == whole.series,
    );
    stops(
        |watch| {
            let curve = Backbone::new(&duffing, None, 21, watch).unwrap();
            (curve.no_series().cloned(), curve.at(0.5, &Quiet).orbit)
        },
        |(no_series, orbit), (_, whole)| no_series.is_some() && orbit == whole,
    );
    let oscillator = Oscillator::new(&duffing).unwrap();
    let expansion = expand(&oscillator, 5, &Gauge::Fundamental, &Quiet).unwrap();
    let interrupted = |error: &NoExactValue| *error == NoExactValue::from(NoOrbit::Interrupted(Interrupted));
    let relation = SeriesComparison::new(&oscillator, &expansion, SeriesQuantity::Period);
    stops(|watch| relation.exact_at(0.5, watch), |found, _| found.as_ref().is_err_and(interrupted));
    let amplitude = Displacement::from_f64(0.5).unwrap();
    stops(
        |watch| {
            let motion = ExactMotion::new(&oscillator, &expansion, &amplitude, watch)?;
            motion.value(SeriesQuantity::Cosine(1))
        },
        |found, _| found.as_ref().is_err_and(interrupted),
    );
}

#[test]
fn thresholds_and_integrals_over_the_separatrix_stop_at_any_question() {
    let driven = equation("x'' + sin(x) = -0.1*x'*abs(x') + A*cos(t)");
    stops(
        |watch| thresholds(&driven, "A", [0.3, 0.4], watch),
        |found, _| matches!(found, Err(NoMelnikov::Interrupted(_))),
    );
    let weak = PerturbedPendulum::new(&equation("x'' + sin(x) = -0.1*x'*abs(x')")).unwrap();
    stops(|watch| Melnikov::both(&weak, watch), |found, _| found.is_err());
}

#[test]
fn normal_modes_stop_at_any_question() {
    let pair = equation("x'' = y - 2*x - (x - y)^3; y'' = x - 2*y + (x - y)^3");
    stops(
        |watch| NormalModes::about(&pair, &[0.0, 0.0], watch).map(|modes| modes.modes),
        |found, _| matches!(found, Err(NoModes::Interrupted(_))),
    );
}

#[test]
fn sections_and_diagrams_stop_with_the_points_until_then() {
    let driven = equation("x'' = -x - x'/2 + A*cos(t)");
    let stroboscope = Section::Stroboscope { period: None, phase: 0.0 };
    let surface =
        Section::Crossing { formula: "x".parse().unwrap(), direction: libration::taylor::Direction::Rising };
    let (effort, points) = (Effort::to_tolerance(1e-9), Points { skipped: 1, recorded: 6 });
    for cut in [stroboscope, surface] {
        let one = driven.with(&[("A", "1".parse().unwrap())]).unwrap();
        stops(
            |watch| section(&one, &at(&[1.0, 0.0]), &cut, points, &effort, watch).unwrap(),
            |found, whole| whole.points.starts_with(&found.points),
        );
        let family = Family { equation: &driven, parameter: "A", section: &cut, points };
        for how in [Continuation::SameStart, Continuation::LastState] {
            let values = [1.0, 1.2, 1.4];
            stops(
                |watch| bifurcation_diagram(&family, &values, &at(&[1.0, 0.0]), how, &effort, watch).unwrap(),
                |found, whole| found.iter().all(|column| whole.contains(column)),
            );
        }
    }
}

#[test]
fn lyapunov_exponents_stop_with_the_intervals_until_then() {
    let pendulum = equation("theta'' + theta'/2 + sin(theta) = 1.5*cos(2t/3)");
    let (start, effort) = (at(&[0.2, 0.0]), Effort::to_tolerance(1e-12));
    let schedule = Schedule { transient: 5.0, interval: 4.0, intervals: 40 };
    stops(
        |watch| lyapunov_exponent(&pendulum, &start, &schedule, &effort, watch),
        |found, whole| match (found, whole) {
            (Ok(found), Ok(whole)) => whole.convergence.starts_with(&found.convergence),
            (Err(LyapunovError::Nothing(_) | LyapunovError::Integration(_)), _) => true,
            _ => false,
        },
    );
}

#[test]
fn tables_of_errors_stop_at_any_question() {
    let formulas = &catalogue()[..2];
    stops(
        |watch| ErrorTable::new(formulas, watch).map(|table| table.crossovers(0, 1)),
        |found, _| *found == Err(Interrupted),
    );
}

#[test]
fn limit_cycles_over_exact_orbits_stop() {
    let equation = equation("x'' + x + x^3 = e*(1 - x^2)*x'");
    let none = Err(NoLeadingLimitCycles::Interrupted);
    stops(|watch| LeadingLimitCycles::new(&equation, None, watch), |found, _| *found == none);
}
