//! Models compared with each other.

use libration::decay::DampingKind;
use libration_lab::fit::trace::{
    Autocorrelation, Comparison, FittedTrace, Parameter, ParameterKind, Standing, TraceFit,
};
use libration_lab::fit::{DampingModel, Uncertain};
use libration_lab::internals::fit::trace::comparison::simplest;

fn coefficient(kind: ParameterKind, value: f64) -> Parameter {
    let estimate = Uncertain { value, uncertainty: 0.001 };
    Parameter { kind, estimate, ..Parameter::default() }
}

/// A model of a pendulum with ω0 and these coefficients that leaves residuals of this size in 100 rows.
fn fit(terms: &str, omega0: f64, coefficients: &[f64], residual: f64) -> TraceFit {
    let damping: DampingModel = terms.parse().unwrap();
    let kinds = damping.iter().map(ParameterKind::Damping);
    let of_damping = kinds.zip(coefficients).map(|(kind, &value)| coefficient(kind, value));
    let speed = Parameter { trace: Some(0), ..coefficient(ParameterKind::FirstVelocity, 2.0) };
    let parameters: Vec<Parameter> = [coefficient(ParameterKind::NaturalFrequency, omega0)]
        .into_iter()
        .chain(of_damping)
        .chain([speed])
        .collect();
    let n = parameters.len();
    let unit = |i: usize| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect();
    TraceFit {
        damping,
        correlations: (0..n).map(unit).collect(),
        parameters,
        traces: vec![FittedTrace { start_time: 0.0, fitted: vec![], residuals: vec![], outliers: vec![] }],
        degrees_of_freedom: 100 - n,
        independent_rows: 100.0,
        chi2_per_dof: None,
        rms: residual,
        unexplained: 0.0,
        autocorrelation: Autocorrelation::of_series(&[]),
        bootstrap_block: None,
        converged: true,
        standard_residuals: vec![residual; 100],
    }
}

/// The size of residuals of 100 rows for which the criterion of linear damping exceeds that of linear and quadratic damping by `excess`.
fn residual(excess: f64) -> f64 {
    let cost = |k: f64| libration_lab::internals::statistics::akaike::cost(100.0, k).unwrap();
    libm::exp((excess + cost(5.0) - cost(4.0)) / 200.0)
}

fn two(excess: f64, first: f64, second: f64) -> Comparison {
    let fits = vec![
        fit("linear", 3.0, &[first], residual(excess)),
        fit("linear+quadratic", 3.01, &[0.02, second], 1.0),
    ];
    Comparison::new(fits, false).unwrap()
}

#[test]
fn the_simplest_of_those_within_two_is_preferred() {
    assert_eq!(two(1.99, 0.1, 0.03).preferred, 0);
    assert_eq!(two(2.01, 0.1, 0.03).preferred, 1);
    assert_eq!(simplest(&[1, 1, 2], &[1.5, 0.5, 0.0]), 1);
}

#[test]
fn standings_change_at_four_and_at_ten() {
    for (excess, expected) in [
        (3.99, Standing::Tied),
        (4.01, Standing::Possible),
        (9.99, Standing::Possible),
        (10.01, Standing::Excluded),
    ] {
        let comparison = two(excess, 0.1, 0.03);
        assert_eq!((comparison.preferred, comparison.standing(0)), (1, expected), "{excess}");
        assert_eq!(comparison.rivals().len(), usize::from(expected != Standing::Excluded));
    }
}

/// Uncertainties are 0.001: the linear coefficient is 0.02 in the larger model.
#[test]
fn a_larger_model_contradicts_where_it_moves_a_coefficient() {
    for (linear, contradicts) in [(0.0229, false), (0.0231, true), (0.0169, true)] {
        let comparison = two(1.5, linear, 0.03);
        assert_eq!((comparison.preferred, comparison.rivals().len()), (0, 1));
        assert_eq!(comparison.contradicting().len(), usize::from(contradicts), "{linear}");
    }
    // A smaller one lacks what the preferred one has, as long as it is not excluded.
    assert_eq!(two(4.1, 0.02, 0.03).contradicting().len(), 1);
    assert_eq!(two(10.1, 0.1, 0.03).contradicting().len(), 0);
}

#[test]
fn a_negative_coefficient_is_believed_beyond_twenty_only_and_else_told() {
    let doubted = two(11.9, 0.1, -0.005);
    assert_eq!((doubted.preferred, doubted.standing(1)), (0, Standing::Possible));
    let better: Vec<f64> = doubted.better().map(|(_, by)| by).collect();
    assert!(better.len() == 1 && (better[0] - 11.9).abs() < 1e-9, "{better:?}");
    assert_eq!(two(9.0, 0.1, -0.005).standing(1), Standing::Negative);
    assert_eq!(two(19.0, 0.1, -0.005).preferred, 0);
    // Worse by ten or more it is excluded as any other.
    assert_eq!(two(-9.9, 0.1, -0.005).standing(1), Standing::Negative);
    assert_eq!(two(-10.1, 0.1, -0.005).standing(1), Standing::Excluded);
    let believed = two(22.1, 0.1, -0.005);
    assert_eq!((believed.preferred, believed.better().count()), (1, 0));
}

/// Burnham and Anderson, section 2.6: a criterion that differs by less than two is not evidence.
#[test]
fn a_criterion_that_is_hardly_lower_makes_no_model_better() {
    for (excess, better) in [(0.2, 0), (1.9, 0), (2.1, 1)] {
        let comparison = two(excess, 0.1, -0.005);
        assert_eq!((comparison.preferred, comparison.better().count()), (0, better), "{excess}");
        assert_eq!(comparison.standing(1), Standing::Negative);
    }
}

#[test]
fn what_feeds_energy_is_never_preferred() {
    let comparison = two(100.0, 0.1, -1.0);
    assert_eq!((comparison.preferred, comparison.standing(1)), (0, Standing::FeedsEnergy));
    assert!(comparison.weights()[0] > 0.999 && comparison.weights()[1] <= 0.0);
}

/// Weights 1 : e⁻² by hand, and the variance of both parts.
#[test]
fn numbers_are_averaged_over_the_models_that_are_left() {
    let comparison = two(4.0 + 1e-9, 0.1, 0.03);
    let part = libm::exp(-2.0) / (1.0 + libm::exp(-2.0));
    assert!((comparison.weights()[0] - part).abs() < 1e-9);
    let omega0 = comparison.parameter(ParameterKind::NaturalFrequency).unwrap();
    assert!((omega0.mean.value - (3.01 - 0.01 * part)).abs() < 1e-9);
    let spread = 0.01 * (part * (1.0 - part)).sqrt();
    assert!((omega0.spread - spread).abs() < 1e-9);
    assert!((omega0.mean.uncertainty - libm::hypot(spread, 0.001)).abs() < 1e-9);
    let [dry, quadratic] = [DampingKind::Dry, DampingKind::Quadratic]
        .map(|term| comparison.parameter(ParameterKind::Damping(term)));
    assert_eq!(quadratic.unwrap().mean.value.to_bits(), 0.03_f64.to_bits());
    assert_eq!(dry, None);
    assert!(
        (comparison.small_angle_period().mean.value - 2.0 * std::f64::consts::PI / omega0.mean.value).abs()
            < 1e-5
    );
}

/// Five rows count as seven, the fewest that judge the larger model: the parameters cost 8 + 40/2 and 10 + 60/1, and a
/// difference of 42 is just compensated by residuals smaller by e⁻³: 7·2·3.
#[test]
fn few_independent_rows_believe_in_far_better_fits_only() {
    let preferred = |residual: f64| {
        let mut fits = vec![fit("linear", 3.0, &[0.1], 1.0), fit("dry+linear", 3.0, &[0.1, 0.1], residual)];
        fits[1].independent_rows = 5.0;
        let comparison = Comparison::new(fits, false).unwrap();
        assert!((comparison.independent_rows - 7.0).abs() < 1e-12, "{}", comparison.independent_rows);
        assert!(comparison.aicc_differences.iter().all(|excess| excess.is_finite()));
        comparison.preferred
    };
    assert_eq!(preferred(0.5), 0);
    // The simpler one of those within two.
    assert_eq!(preferred(libm::exp(-3.1)), 0);
    assert_eq!(preferred(libm::exp(-3.2)), 1);
    assert_eq!(preferred(0.01), 1);
}

/// One outlier dominates the squares of the better model, but not Huber's loss.
#[test]
fn outliers_do_not_choose_a_robust_model() {
    let mut better = fit("linear", 3.0, &[0.1], 1.0);
    better.standard_residuals[7] = 40.0;
    let worse = fit("quadratic", 3.0, &[0.1], 2.0);
    let fits = vec![better, worse];
    assert_eq!(Comparison::new(fits.clone(), false).unwrap().best().damping.to_string(), "quadratic");
    assert_eq!(Comparison::new(fits, true).unwrap().best().damping.to_string(), "linear");
}
