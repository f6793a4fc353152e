//! Long calls that are cancelled at one of the updates of their progress.

use libration::chaos::{
    Continuation, Family, LyapunovError, Points, Schedule, Section, compute_bifurcation_diagram,
    compute_section, lyapunov_exponent,
};
use libration::comparison::{
    Backbone, ExactMotion, ExactValueError, LeadingLimitCycles, LeadingLimitCyclesError, SeriesComparison,
    SeriesQuantity,
};
use libration::continuation::{BranchError, Response, ResponseOptions};
use libration::expression::Equation;
use libration::melnikov::{DriveResonance, Melnikov, MelnikovError, PerturbedPendulum, thresholds};
use libration::normal_form::{NormalForm, NormalFormError};
use libration::normal_modes::{ModesError, NormalModes};
use libration::orbit::{Orbit, OrbitError, OrbitGuess};
use libration::oscillator::{Oscillator, SymbolicOscillator};
use libration::period_formulas::{ErrorTable, catalogue};
use libration::perturbation::{
    EpsilonPowers, ExpansionError, Gauge, OpenGauge, OpenGaugeError, SlowFlowError, SymbolicExpansionError,
    TruncatedSystem, TruncatedSystemError, expand, expand_symbolically, restoring_force, slow_flow,
};
use libration::progress::{Interrupted, Progress, Quiet, Status};
use libration::quantity::Displacement;
use libration::taylor::{
    Cause, Effort, Ensemble, IntegrationError, Moment, Solution, System, Trajectory, integrate,
    integrate_many,
};
use std::cell::Cell;
use std::fmt::Debug;
use std::ops::ControlFlow;

/// Result of a call that is cancelled at the n-th update of its progress, and the number of updates.
fn cancelled_at<T>(n: usize, call: &impl Fn(&dyn Progress) -> T) -> (T, usize) {
    let updates = Cell::new(0);
    let progress = |_: Status| {
        updates.set(updates.get() + 1);
        if updates.get() == n { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let outcome = call(&progress);
    (outcome, updates.get())
}

/// Cancels a call at the first, the last and some other updates; there must be no more updates, and the result must be right. A call that is not
/// cancelled has the result of a quiet one.
fn stops<T: Debug + PartialEq>(call: impl Fn(&dyn Progress) -> T, is_right: impl Fn(&T, &T) -> bool) {
    let whole = call(&Quiet);
    let (complete, updates) = cancelled_at(usize::MAX, &call);
    assert!(updates > 1, "{updates} updates");
    assert_eq!(complete, whole);
    for n in [1, 2, updates / 3 + 1, updates / 2 + 1, updates] {
        let (outcome, made) = cancelled_at(n, &call);
        assert_eq!(made, n.min(updates), "updates after the cancellation at update {n} of {updates}");
        assert!(is_right(&outcome, &whole), "cancelled at update {n} of {updates}: {outcome:?}");
    }
}

fn equation(text: &str) -> Equation {
    text.parse().unwrap()
}

fn at(state: &[f64]) -> Moment {
    Moment { time: 0.0, state: state.to_vec() }
}

/// Orbits have no equality: their period and their start decide.
fn in_numbers(orbit: Result<Orbit, OrbitError>) -> Result<(f64, Vec<f64>), OrbitError> {
    orbit.map(|orbit| (orbit.period(), orbit.start()))
}

fn no_orbit<T>(outcome: &Result<T, OrbitError>, _: &Result<T, OrbitError>) -> bool {
    matches!(outcome, Err(OrbitError::Interrupted(Interrupted)))
}

#[test]
fn integrations_stop_with_the_samples_until_then() {
    let pendulum = System::new(&equation("theta'' = -sin(theta)")).unwrap();
    let (times, effort) = ([1.0, 5.0, 20.0], Effort::to_tolerance(1e-12));
    let is_part = |outcome: &Result<Solution, IntegrationError>,
                   whole: &Result<Solution, IntegrationError>| {
        let Err(IntegrationError::Stopped { cause: Cause::Interrupted, solution }) = outcome else {
            return false;
        };
        whole.as_ref().is_ok_and(|whole| whole.samples.starts_with(&solution.samples))
    };
    stops(|progress| integrate(&pendulum, &at(&[1.0, 0.0]), &times, &effort, progress), is_part);
    let start = |angle: f64| Trajectory { start: at(&[angle, 0.0]), parameters: vec![], times: &times };
    let many = [start(0.5), start(1.0), start(3.0)];
    stops(
        |progress| integrate_many(&pendulum, &many, &effort, progress),
        |outcome, whole| {
            let mut pairs = outcome.iter().zip(whole);
            pairs.all(|(part, whole)| part == whole || is_part(part, whole))
                && outcome.iter().any(Result::is_err)
        },
    );
    let starts = [at(&[0.5, 0.0]), at(&[3.0, 0.0])];
    stops(
        |progress| {
            let mut ensemble = Ensemble::new(pendulum.clone(), &starts, &effort).unwrap();
            let first = ensemble.states_at(20.0, progress);
            (first, ensemble.states_at(20.0, &Quiet))
        },
        |(first, resumed), (_, whole)| *first == Err(Interrupted) && resumed == whole,
    );
}

#[test]
fn searches_of_orbits_stop_at_any_update() {
    let pendulum = equation("theta'' = -sin(theta)");
    // In double precision, and next to the separatrix with more bits.
    for angle in [1.0, 3.141_592_653] {
        stops(|progress| in_numbers(Orbit::released(&pendulum, angle, progress)), no_orbit);
    }
    let van_der_pol = equation("x'' = (1 - x^2)*x' - x");
    stops(|progress| in_numbers(Orbit::limit_cycle(&van_der_pol, &[0.1, 0.0], progress)), no_orbit);
    let pair = equation("x'' = y - 2*x - (x - y)^3; y'' = x - 2*y + (x - y)^3");
    let guess = OrbitGuess { state: vec![0.1, -0.1, 0.0, 0.0], period: 3.6 };
    stops(|progress| in_numbers(Orbit::near(&pair, &guess, &[0, 2], progress)), no_orbit);
    let driven = equation("x'' = -x - x^3 - x'/5 + cos(t)");
    let period = std::f64::consts::TAU;
    stops(|progress| in_numbers(Orbit::driven(&driven, &[1.0, 0.2], period, progress)), no_orbit);
}

#[test]
fn normal_forms_stop_before_the_next_order() {
    let coupled = equation("x'' = -x - x*y; y'' = -4*y - x^2/2");
    let terms = |form: NormalForm| form.slow_terms;
    stops(
        |progress| NormalForm::about(&coupled, &[0.0, 0.0], 4, 0.1, progress).map(terms),
        |outcome, whole| {
            matches!(outcome, Err(NormalFormError::Interrupted(_) | NormalFormError::NoModes(_)))
                && whole.is_ok()
        },
    );
}

#[test]
fn resonances_stop_before_the_next() {
    let driven = PerturbedPendulum::new(&equation("x'' = -0.1*x' - sin(x) + 0.3*cos(t)")).unwrap();
    let places = |resonances: Vec<DriveResonance>| -> Vec<(u32, f64)> {
        resonances.iter().map(|resonance| (resonance.drive_periods, resonance.half_width)).collect()
    };
    stops(
        |progress| driven.resonances(4, progress).map(places),
        |outcome, whole| *outcome == Err(Interrupted) && whole.is_ok(),
    );
}

#[test]
fn branches_stop_with_the_points_that_are_followed() {
    let duffing = equation("x'' = -0.2*x' - x - x^3 + 0.3*cos(w*t)");
    let options = ResponseOptions { generations: 0, ..ResponseOptions::default() };
    stops(
        |progress| Response::over(&duffing, "w", [0.9, 1.0], &options, progress),
        |outcome, whole| match (outcome, whole) {
            (Err(error), _) => *error == BranchError::Interrupted(Interrupted),
            (Ok(response), Ok(whole)) => {
                let (part, all) = (&response.branches[0].points, &whole.branches[0].points);
                response.interrupted && part[..] == all[..part.len()]
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
            |progress| expand(&oscillator, 17, &Gauge::Fundamental, progress),
            |outcome, whole| match (outcome, whole) {
                (Err(ExpansionError::Interrupted { known: None }), _) => true,
                (Err(ExpansionError::Interrupted { known: Some(part) }), Ok(whole)) => {
                    whole.frequency_ratio.starts_with(&part.frequency_ratio)
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
            |progress| expand_symbolically(&oscillator, 7, &Gauge::Fundamental, progress),
            |outcome, whole| match (outcome, whole) {
                (Err(SymbolicExpansionError::Interrupted { known: Some(part) }), Ok(whole)) => {
                    whole.series.frequency_ratio.starts_with(&part.series.frequency_ratio)
                }
                _ => false,
            },
        );
    }
}

#[test]
fn slow_flows_stop_at_any_update() {
    let damped = equation("x'' + c*x'*abs(x') + sin(x) = 0");
    stops(
        |progress| slow_flow(&damped, None, 4, 2, &Gauge::XMax, progress),
        |outcome, _| *outcome == Err(SlowFlowError::Interrupted),
    );
}

#[test]
fn equations_of_harmonics_stop_at_any_update() {
    let pendulum = Oscillator::new(&equation("x'' = -sin(x)")).unwrap();
    let force = restoring_force(&pendulum, 9).unwrap();
    stops(
        |progress| {
            let open = OpenGauge::new(&force, 7, EpsilonPowers::OneParity, progress);
            open.map(|open| open.conditions().to_vec())
        },
        |outcome, _| matches!(outcome, Err(OpenGaugeError::Interrupted(_))),
    );
    let system = TruncatedSystem::new(&force, 2, 3).unwrap();
    stops(
        |progress| system.solutions(1.0, progress).map(|all| all[0].frequency_ratio_squared),
        |outcome, _| matches!(outcome, Err(TruncatedSystemError::Interrupted(_))),
    );
}

#[test]
fn backbones_and_exact_values_stop_at_any_update() {
    let duffing = equation("x'' = -x - x^3");
    let curve = Backbone::new(&duffing, None, 9, &Quiet).unwrap();
    stops(
        |progress| curve.at(0.5, progress),
        |outcome, whole| no_orbit(&outcome.orbit, &whole.orbit) && outcome.series == whole.series,
    );
    stops(
        |progress| {
            let curve = Backbone::new(&duffing, None, 21, progress).unwrap();
            (curve.no_series().cloned(), curve.at(0.5, &Quiet).orbit)
        },
        |(no_series, orbit), (_, whole)| no_series.is_some() && orbit == whole,
    );
    let oscillator = Oscillator::new(&duffing).unwrap();
    let expansion = expand(&oscillator, 5, &Gauge::Fundamental, &Quiet).unwrap();
    let interrupted =
        |error: &ExactValueError| *error == ExactValueError::from(OrbitError::Interrupted(Interrupted));
    let relation = SeriesComparison::new(&oscillator, &expansion, SeriesQuantity::Period);
    stops(|progress| relation.exact_at(0.5, progress), |outcome, _| outcome.as_ref().is_err_and(interrupted));
    let amplitude = Displacement::from_f64(0.5).unwrap();
    stops(
        |progress| {
            let motion = ExactMotion::new(&oscillator, &expansion, &amplitude, progress)?;
            motion.value(SeriesQuantity::Cosine(1))
        },
        |outcome, _| outcome.as_ref().is_err_and(interrupted),
    );
}

#[test]
fn thresholds_and_integrals_over_the_separatrix_stop_at_any_update() {
    let driven = equation("x'' + sin(x) = -0.1*x'*abs(x') + A*cos(t)");
    stops(
        |progress| thresholds(&driven, "A", [0.3, 0.4], progress),
        |outcome, _| matches!(outcome, Err(MelnikovError::Interrupted(_))),
    );
    let weak = PerturbedPendulum::new(&equation("x'' + sin(x) = -0.1*x'*abs(x')")).unwrap();
    stops(|progress| Melnikov::both(&weak, progress), |outcome, _| outcome.is_err());
}

#[test]
fn normal_modes_stop_at_any_update() {
    let pair = equation("x'' = y - 2*x - (x - y)^3; y'' = x - 2*y + (x - y)^3");
    stops(
        |progress| NormalModes::about(&pair, &[0.0, 0.0], progress).map(|modes| modes.modes),
        |outcome, _| matches!(outcome, Err(ModesError::Interrupted(_))),
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
            |progress| compute_section(&one, &at(&[1.0, 0.0]), &cut, points, &effort, progress).unwrap(),
            |outcome, whole| whole.points.starts_with(&outcome.points),
        );
        let family = Family { equation: &driven, parameter: "A", section: &cut, points, with_errors: false };
        for how in [Continuation::SameStart, Continuation::LastState] {
            let values = [1.0, 1.2, 1.4];
            stops(
                |progress| {
                    compute_bifurcation_diagram(&family, &values, &at(&[1.0, 0.0]), how, &effort, progress)
                        .unwrap()
                },
                |outcome, whole| outcome.iter().all(|column| whole.contains(column)),
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
        |progress| lyapunov_exponent(&pendulum, &start, &schedule, &effort, progress),
        |outcome, whole| match (outcome, whole) {
            (Ok(exponent), Ok(whole)) => whole.convergence.starts_with(&exponent.convergence),
            (Err(LyapunovError::Nothing(_) | LyapunovError::Integration(_)), _) => true,
            _ => false,
        },
    );
}

#[test]
fn tables_of_errors_stop_at_any_update() {
    let formulas = &catalogue()[..2];
    stops(
        |progress| ErrorTable::new(formulas, progress).map(|table| table.crossovers(0, 1)),
        |outcome, _| *outcome == Err(Interrupted),
    );
}

#[test]
fn limit_cycles_over_exact_orbits_stop() {
    let equation = equation("x'' + x + x^3 = e*(1 - x^2)*x'");
    let none = Err(LeadingLimitCyclesError::Interrupted);
    stops(|progress| LeadingLimitCycles::new(&equation, None, progress), |outcome, _| *outcome == none);
}
