//! Short searches end at the minima of long ones.

use libration::internals::progress::Watch;
use libration::progress::Quiet;
use libration::taylor::{Effort, Moment, System, integrate};
use libration_lab::fit::DampingModel;
use libration_lab::fit::trace::{TraceFitError, TraceOptions, compare, fit_traces};
use libration_lab::internals::fit::trace::minimum::{Care, TraceMinimum};
use libration_lab::internals::fit::trace::model::ResidualRows;
use libration_lab::internals::fit::trace::problem::{PATIENCE, Problem};
use libration_lab::internals::fit::trace::random::Random;
use libration_lab::internals::fit::trace::weights::Weights;
use libration_lab::internals::fit::trace::{search, series, uncertainty};
use libration_lab::internals::statistics::count;
use libration_lab::measurement::{Observable, Trace};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A pendulum with ω0 = 4 and a little linear and quadratic damping.
const TRUTH: &str = "theta'' = -16*sin(theta) - 0.02*theta' - 0.01*theta'*abs(theta')";

/// A release, recorded in a number of rows over a span in seconds with noise of 3 mrad, and with one outlier in every `outliers` rows.
fn trace(name: &str, amplitude: f64, rows: usize, span: f64, outliers: Option<usize>, seed: u64) -> Trace {
    let mut random = Random::new(seed);
    let mut uniform = || count(random.below(1 << 30)) / count(1 << 30) - 0.5;
    let times: Vec<f64> = (0..rows).map(|row| 0.01 + span * count(row) / count(rows)).collect();
    let start = Moment { time: 0.0, state: vec![amplitude, 0.0] };
    let system = System::new(&TRUTH.parse().unwrap()).unwrap();
    let motion = integrate(&system, &start, &times, &Effort::to_tolerance(1e-12), &Quiet).unwrap();
    let mut value = |(row, moment): (usize, &Moment)| {
        let noise: f64 = 0.003 * (0..12).map(|_| uniform()).sum::<f64>();
        let outlier = if outliers.is_some_and(|every| row % every == 7) { 1.0 + uniform() } else { 0.0 };
        moment.state[0] + noise + outlier
    };
    let values = motion.samples.iter().enumerate().map(&mut value).collect();
    Trace::new(name, Observable::Angle, times, values, None).unwrap()
}

fn terms() -> DampingModel {
    "linear+quadratic".parse().unwrap()
}

/// The largest difference of free parameters in uncertainties of the second.
fn apart(one: &TraceMinimum, other: &TraceMinimum, problem: &Problem<'_>) -> f64 {
    let fit = uncertainty::fit(problem, other, &Watch::new(&Quiet)).unwrap();
    let free = problem.model.free();
    let pairs = free.iter().zip(&fit.parameters);
    let differences = pairs.map(|(&index, parameter)| {
        (one.parameters[index] - other.parameters[index]).abs() / parameter.formal_uncertainty
    });
    differences.fold(0.0, f64::max)
}

/// Searches from few rows and from the truth, and with all rows from the beginning: 1e-14 of the sum of squares of 20 000 rows are 1.4e-5
/// deviations.
#[test]
fn a_search_in_few_rows_ends_where_all_rows_end() {
    for (robust, outliers) in [(false, None), (true, Some(20))] {
        let traces = [trace("dense", 1.0, 20_000, 20.0, outliers, 1)];
        let options = TraceOptions { robust, ..TraceOptions::default() };
        let problem = Problem::new(&traces, terms(), options).unwrap();
        let stated = Weights::stated(&traces);
        let few = series::of_search(problem.data, &[20_000], &stated, problem.cycles);
        assert!((500..2000).contains(&few[0].times.len()), "{}", few[0].times.len());
        let watch = Watch::new(&Quiet);
        let end = search::from_scratch(&problem, None, &watch).unwrap();
        let short = problem.minimum_near(end.parameters, PATIENCE, Care::FULL, &watch).unwrap();
        let truth = vec![4.0, 0.02, 0.01, 1.0, 0.0, 1.0, 0.0];
        let long = problem.minimum_near(truth, PATIENCE, Care::FULL, &watch).unwrap();
        assert_eq!(short.linearised.residuals.len(), 20_000);
        // Rounds of new weights end at 1e-8 of the sum of squares, and so do robust fits at 1e-4 of its rows' root.
        let bound = if robust { 0.03 } else { 1e-4 };
        assert!(apart(&short, &long, &problem) < bound, "{robust}: {}", apart(&short, &long, &problem));
    }
}

/// Integration together in the lanes, and one after the other.
#[test]
fn the_rows_of_each_trace_are_those_of_the_trace_alone() {
    let traces: Vec<Trace> = (0..11_u32)
        .map(|n| trace("run", 0.3 + 0.2 * f64::from(n), 300 + n as usize, 12.0, None, u64::from(n)))
        .collect();
    for terms in DampingModel::all() {
        let together = Problem::new(&traces, terms, TraceOptions::default()).unwrap();
        let (layout, shared) = (together.model.layout, terms.count() + 2);
        let mut parameters = vec![0.01; layout.len()];
        (parameters[0], parameters[layout.scale()]) = (4.0, 1.0);
        let stated = Weights::stated(&traces);
        let all = series::whole(together.data, &stated);
        let free = together.model.free();
        let rows = together
            .model
            .rows(&all, &parameters, &free, &libration_lab::internals::fit::trace::swing::EXACT)
            .unwrap();
        for (number, rows) in rows.iter().enumerate() {
            let trace = &traces[number..=number];
            let alone = Problem::new(trace, terms, TraceOptions::default()).unwrap();
            let first = layout.offset(number);
            let own_parameters = [&parameters[..shared], &parameters[first..first + 3]].concat();
            let stated = Weights::stated(trace);
            let of_one = series::whole(alone.data, &stated);
            let free = alone.model.free();
            let solutions = alone
                .model
                .rows(&of_one, &own_parameters, &free, &libration_lab::internals::fit::trace::swing::EXACT)
                .unwrap();
            let [solution] = &solutions[..] else { panic!() };
            let bits =
                |rows: &ResidualRows| ResidualRows::whole(std::slice::from_ref(rows), rows.places()).jacobian;
            assert_eq!(
                (solution.residuals(), bits(solution)),
                (rows.residuals(), bits(rows)),
                "{terms} {number}"
            );
        }
    }
}

/// Fewer rows with the same sum of squares, the same slopes and the same products of derivatives.
#[test]
fn few_rows_have_the_sums_of_all() {
    let traces = [0.4, 1.4].map(|amplitude| trace("run", amplitude, 900, 20.0, None, 3));
    let problem =
        Problem::new(&traces, terms(), TraceOptions { free_scale: true, ..TraceOptions::default() }).unwrap();
    let (stated, free) = (Weights::stated(&traces), problem.model.free());
    let all = series::whole(problem.data, &stated);
    let parameters = vec![4.01, 0.02, 0.01, 1.0, 0.01, 0.4, 0.0, 0.02, 1.4, 0.0];
    let rows = problem
        .model
        .rows(&all, &parameters, &free, &libration_lab::internals::fit::trace::swing::EXACT)
        .unwrap();
    let [whole, few] = [ResidualRows::whole(&rows, &free), ResidualRows::few(&rows, &free)];
    assert!(few.residuals.len() < 20 && whole.residuals.len() == 1800);
    let products = [&whole, &few].map(|solution| solution.jacobian.tr_mul(&solution.jacobian));
    let slopes = [&whole, &few].map(|solution| solution.jacobian.tr_mul(&solution.residuals));
    assert!((&products[0] - &products[1]).norm() < 1e-13 * products[0].norm());
    assert!((&slopes[0] - &slopes[1]).norm() < 1e-13 * slopes[0].norm());
    assert!((few.residuals.norm() / whole.residuals.norm() - 1.0).abs() < 1e-13);
}

/// Sums by a linear model next to the minimum, and by minimisation: at one deviation, and at distances for which the model is not linear.
#[test]
fn sums_beside_a_minimum_are_those_of_the_way_down() {
    let traces = [trace("short", 2.5, 120, 6.0, None, 4)];
    let problem = Problem::new(&traces, terms(), TraceOptions::default()).unwrap();
    let fit = fit_traces(&traces, terms(), &TraceOptions::default(), &Quiet).unwrap();
    let values = fit.parameters.iter().map(|parameter| parameter.estimate.value);
    let mut parameters: Vec<f64> = values.collect();
    parameters.insert(3, 1.0);
    let watch = Watch::new(&Quiet);
    let minimum = problem.minimum_near(parameters, PATIENCE, Care::FULL, &watch).unwrap();
    let least = minimum.sum_of_squares();
    for deviations in [1.0, -2.0, 100.0] {
        let mut moved = minimum.parameters.clone();
        moved[0] += deviations * fit.parameters[0].formal_uncertainty;
        let others = problem.model.free().into_iter().filter(|&index| index != 0).collect::<Vec<_>>();
        let sum = problem.sum_beside(&minimum.weights, moved.clone(), others.clone(), least, &watch).unwrap();
        let all = series::whole(problem.data, &minimum.weights);
        let start = libration_lab::internals::fit::trace::minimum::Start {
            parameters: moved,
            free: others,
            patience: 100,
            care: Care::FULL,
        };
        let down =
            libration_lab::internals::fit::trace::minimum::descent(&problem.model, &all, start, &watch)
                .unwrap()
                .sum_of_squares;
        assert!(((sum - least) / (down - least) - 1.0).abs() < 2e-3, "{deviations}: {sum} {down} {least}");
    }
}

/// Models are fitted on all cores in any order.
#[test]
fn comparisons_are_the_same_each_time() {
    let traces = [trace("twice", 1.0, 400, 15.0, None, 5)];
    let one = || compare(&traces, &TraceOptions::default(), &Quiet).unwrap();
    let (first, second) = (one(), one());
    assert_eq!(first.fits, second.fits);
    assert_eq!(first.best().damping, terms());
}

/// Three sines of equal size, which every model loses in the first swings: each is searched once or twice in these, and never with all rows.
#[test]
fn data_that_no_model_follows_are_refused_after_a_look_at_the_first_swings() {
    let angle = |t: f64| [3.0, 4.1, 5.7].map(|w| 0.5 * libm::sin(w * t)).iter().sum::<f64>();
    let times: Vec<f64> = (0..5000).map(|row| 0.02 * f64::from(row)).collect();
    let values = times.iter().map(|&time| angle(time)).collect();
    let trace = Trace::new("three sines", Observable::Angle, times, values, None).unwrap();
    let evaluations = AtomicUsize::new(0);
    let counted = |_| {
        evaluations.fetch_add(1, Ordering::Relaxed);
        ControlFlow::Continue(())
    };
    let outcome = compare(&[trace], &TraceOptions::default(), &Watch::new(&counted));
    assert!(matches!(outcome, Err(TraceFitError::Unexplained { percent }) if percent > 50.0), "{outcome:?}");
    let evaluations = evaluations.into_inner();
    assert!(evaluations < 1000, "{evaluations}");
}
