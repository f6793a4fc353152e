//! The uncertainty budget of g against finite differences of the whole calculation, closed forms, and repeated experiments.

use std::f64::consts::TAU;

use libration::quantity::Quantity;
use libration_lab::fit::{
    Apparatus, Bob, Budget, BudgetError, BudgetInput, BudgetWarning, Contribution, Correction, Corrections,
    Correlation, MeasuredPeriod, PeriodDamping, evaluate_budget,
};

use crate::random::Random;
use crate::synthetic_trace::normal;

fn about(value: f64, uncertainty: f64) -> Quantity {
    Quantity { value, uncertainty: Some(uncertainty) }
}

/// An apparatus with all inputs and their uncertainties.
fn whole_apparatus() -> Apparatus {
    let corrections = Corrections {
        bob: Some(Bob::ball(about(0.03, 0.0003))),
        bob_mass: Some(about(0.25, 0.002)),
        rod_mass: Some(about(0.01, 0.0005)),
        rod_length: Some(about(0.95, 0.004)),
        stretch: Some(about(0.001, 0.0002)),
        expansion: Some(about(1.2e-5, 1e-6)),
        warming: Some(about(4.0, 0.5)),
        support_stiffness: Some(about(5000.0, 800.0)),
        edge_radius: Some(about(1e-4, 3e-5)),
        ..Corrections::default()
    };
    Apparatus { length: about(1.0, 0.002), corrections }
}

fn whole_period() -> MeasuredPeriod {
    MeasuredPeriod {
        model: None,
        t0: about(2.006, 0.001),
        amplitude: Some(0.7),
        angle_scale: Some(0.02),
        clock: Some(0.001),
        shared_timing: None,
        degrees_of_freedom: 9.0,
        damping: PeriodDamping::Contained(about(0.05, 0.01)),
    }
}

fn of(budget: &Budget, input: BudgetInput) -> Contribution {
    *budget.combined.contributions.iter().find(|each| each.input == input).unwrap()
}

fn correction(budget: &Budget, name: &str) -> Correction {
    budget.rows.iter().find(|row| row.name == name).unwrap().correction
}

fn square(x: f64) -> f64 {
    x * x
}

fn close(ours: f64, wanted: f64, relative: f64) -> bool {
    (ours - wanted).abs() <= relative * wanted.abs()
}

type Changed = fn(&mut Apparatus, &mut MeasuredPeriod, f64);

fn scale(quantity: &mut Quantity, factor: f64) {
    quantity.value *= factor;
}

/// Each input that a caller can move, multiplied by a factor.
const MOVED: [(BudgetInput, Changed); 12] = [
    (BudgetInput::Length, |apparatus, _, factor| scale(&mut apparatus.length, factor)),
    (BudgetInput::Period, |_, period, factor| scale(&mut period.t0, factor)),
    (BudgetInput::BobRadius, |rig, _, factor| {
        scale(&mut rig.corrections.bob.as_mut().unwrap().radius, factor);
    }),
    (BudgetInput::BobMass, |rig, _, factor| scale(rig.corrections.bob_mass.as_mut().unwrap(), factor)),
    (BudgetInput::RodMass, |rig, _, factor| scale(rig.corrections.rod_mass.as_mut().unwrap(), factor)),
    (BudgetInput::RodLength, |rig, _, factor| scale(rig.corrections.rod_length.as_mut().unwrap(), factor)),
    (BudgetInput::AirDensity, |rig, _, factor| scale(&mut rig.corrections.air_density, factor)),
    (BudgetInput::Stretch, |rig, _, factor| scale(rig.corrections.stretch.as_mut().unwrap(), factor)),
    (BudgetInput::Expansion, |rig, _, factor| scale(rig.corrections.expansion.as_mut().unwrap(), factor)),
    (BudgetInput::Warming, |rig, _, factor| scale(rig.corrections.warming.as_mut().unwrap(), factor)),
    (BudgetInput::SupportStiffness, |rig, _, factor| {
        scale(rig.corrections.support_stiffness.as_mut().unwrap(), factor);
    }),
    (BudgetInput::EdgeRadius, |rig, _, factor| scale(rig.corrections.edge_radius.as_mut().unwrap(), factor)),
];

#[test]
fn sensitivities_are_finite_differences_of_the_whole_calculation() {
    let budget = evaluate_budget(&whole_apparatus(), &whole_period(), &[]).unwrap();
    for (input, change) in MOVED {
        let moved = |factor: f64| {
            let (mut apparatus, mut period) = (whole_apparatus(), whole_period());
            change(&mut apparatus, &mut period, factor);
            evaluate_budget(&apparatus, &period, &[]).unwrap().g
        };
        let part = 1e-4;
        let contribution = of(&budget, input);
        let wanted = (moved(1.0 + part) - moved(1.0 - part)) / (2.0 * part * contribution.value);
        // The difference errs by 1e-8 of g‴x³/6, the sensitivity by far less; that of the air is 1e-4 of g.
        assert!(close(contribution.sensitivity, wanted, 1e-6), "{input:?}: {contribution:?} {wanted}");
    }
    // Time shown by a clock is T0 itself, but for the layer of air, which the frequency makes: δ grows as √T0.
    let (clock, period) = (of(&budget, BudgetInput::Clock), of(&budget, BudgetInput::Period));
    assert!(close(clock.sensitivity, period.sensitivity * period.value, 1e-9));
}

#[test]
fn a_bare_pendulum_has_the_coefficients_of_the_books() {
    let period = MeasuredPeriod { clock: Some(0.001), ..MeasuredPeriod::of_small_swings(about(2.0, 0.01)) };
    let budget = evaluate_budget(&Apparatus::of_length(about(1.0, 0.005)), &period, &[]).unwrap();
    let g = TAU * TAU / 4.0;
    assert!(close(budget.g, g, 1e-14));
    for (input, wanted) in
        [(BudgetInput::Length, g), (BudgetInput::Period, -g), (BudgetInput::Clock, -2.0 * g)]
    {
        assert!(close(of(&budget, input).sensitivity, wanted, 1e-9), "{input:?}");
    }
    let parts = [0.005, 0.01, 0.002].map(|part| g * part);
    let together = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
    assert!(close(budget.uncertainty, together, 1e-9));
    let shares: f64 = budget.combined.contributions.iter().map(|each| budget.combined.share(each)).sum();
    assert!(close(shares, 1.0, 1e-12));
    let of_length = budget.combined.share(&of(&budget, BudgetInput::Length));
    assert!(close(of_length, parts[0] * parts[0] / (together * together), 1e-9));
    // 1.959964 for known uncertainties.
    assert!(close(budget.combined.expanded(), 1.959963984540054 * together, 1e-7));
}

#[test]
fn effective_degrees_of_freedom_are_those_of_welch_and_satterthwaite() {
    let period =
        MeasuredPeriod { degrees_of_freedom: 4.0, ..MeasuredPeriod::of_small_swings(about(2.0, 0.01)) };
    let alone = evaluate_budget(&Apparatus::of_length(about(1.0, 0.0)), &period, &[]).unwrap();
    assert!(close(alone.combined.degrees_of_freedom, 4.0, 1e-9));
    assert!(close(alone.combined.coverage_factor(), 2.776445, 1e-6));
    // u(L)/L = 2u(T)/T: half of the variance is the period's, so that 4·2² are left.
    let shared = evaluate_budget(&Apparatus::of_length(about(1.0, 0.01)), &period, &[]).unwrap();
    assert!(close(shared.combined.degrees_of_freedom, 16.0, 1e-9));
    let with_known_length =
        evaluate_budget(&Apparatus::of_length(about(1.0, 0.01)), &whole_period(), &[]).unwrap();
    assert!(with_known_length.combined.degrees_of_freedom > 9.0);
}

/// g = 4π²L/T0² with the same factor on both: the length goes up by a part, the period by half of it, and g stays.
#[test]
fn correlations_are_part_of_the_uncertainty() {
    let apparatus = Apparatus::of_length(about(1.0, 0.002));
    let period = MeasuredPeriod::of_small_swings(about(2.0, 0.002));
    let with = |coefficient: f64| {
        let between = [BudgetInput::Length, BudgetInput::Period];
        evaluate_budget(&apparatus, &period, &[Correlation { between, coefficient }])
    };
    let budget = |coefficient: f64| with(coefficient).unwrap();
    let g = budget(0.0).g;
    assert!(budget(1.0).uncertainty < 1e-6 * g);
    assert!(close(budget(-1.0).uncertainty, 0.004 * g, 1e-9));
    let half = budget(0.5);
    assert!(close(half.uncertainty, 0.002 * g, 1e-9));
    assert!(close(half.combined.share_of_correlations(), -1.0, 1e-9), "{half:?}");
    assert_eq!(with(1.5), Err(BudgetError::Correlation { coefficient: 1.5 }));
    let between = [BudgetInput::Length, BudgetInput::RodMass];
    let nothing = evaluate_budget(&apparatus, &period, &[Correlation { between, coefficient: 0.5 }]);
    assert_eq!(nothing, Err(BudgetError::CorrelationWithNothing("rod mass")));
    let itself = Correlation { between: [BudgetInput::Length; 2], coefficient: 0.5 };
    assert_eq!(
        evaluate_budget(&apparatus, &period, &[itself]),
        Err(BudgetError::Correlation { coefficient: 0.5 })
    );
}

#[test]
fn correlations_that_contradict_each_other_are_refused() {
    use BudgetInput::{BobMass, BobRadius, Length};
    let correlation = |one: BudgetInput, other: BudgetInput, coefficient: f64| Correlation {
        between: [one, other],
        coefficient,
    };
    let with = |last: f64| {
        let all = [
            correlation(Length, BobRadius, 1.0),
            correlation(BobRadius, BobMass, 1.0),
            correlation(Length, BobMass, last),
        ];
        evaluate_budget(&whole_apparatus(), &whole_period(), &all)
    };
    assert!(with(1.0).is_ok());
    assert_eq!(with(0.5), Err(BudgetError::Correlations));
}

/// Uncertainties as large as the values themselves, at which a difference over one uncertainty would leave the domain.
#[test]
fn uncertainties_of_a_hundred_percent_and_more_are_kept() {
    for part in [0.9, 1.0, 1.5] {
        let vague = Apparatus::of_length(about(1.0, part));
        let budget = evaluate_budget(&vague, &MeasuredPeriod::of_small_swings(about(2.0, 0.0)), &[]).unwrap();
        assert!(close(budget.uncertainty, part * budget.g, 1e-9), "{part}: {budget:?}");
        assert!(budget.is_linear());
        let slow = MeasuredPeriod::of_small_swings(about(2.0, 2.0 * part));
        let budget = evaluate_budget(&Apparatus::of_length(about(1.0, 0.0)), &slow, &[]).unwrap();
        assert!(close(budget.uncertainty, 2.0 * part * budget.g, 1e-9), "{part}: {budget:?}");
        assert!(!budget.is_linear());
        assert_eq!(budget.warnings(), [BudgetWarning::NotLinear]);
    }
    let mut vague = whole_apparatus();
    let corrections = &mut vague.corrections;
    corrections.bob = Some(Bob::ball(about(0.03, 0.03)));
    for quantity in [&mut corrections.bob_mass, &mut corrections.rod_mass, &mut corrections.stretch] {
        let value = quantity.unwrap().value;
        *quantity = Some(about(value, value));
    }
    let budget = evaluate_budget(&vague, &whole_period(), &[]).unwrap();
    assert!(
        budget.uncertainty.is_finite()
            && budget.rows.iter().all(|row| row.uncertainty.is_none_or(f64::is_finite))
    );
}

/// g ∝ 1/T0²: the mean is off by 3(u/T0)² of g, which is a tenth of u(g) = 2(u/T0)·g at u/T0 = 1/15.
#[test]
fn the_bend_of_g_is_told_where_it_matters() {
    let of_part = |part: f64| {
        let period = MeasuredPeriod::of_small_swings(about(2.0, 2.0 * part));
        evaluate_budget(&Apparatus::of_length(about(1.0, 0.0)), &period, &[]).unwrap()
    };
    assert!(close(of_part(0.05).curvature, 3.0 * 0.05 * 0.05 * of_part(0.05).g, 1e-6));
    assert!(of_part(0.0666).is_linear() && !of_part(0.0667).is_linear());
}

#[test]
fn inputs_without_an_uncertainty_are_named() {
    let bare = |value: f64| Quantity { value, uncertainty: None };
    let ball = |radius: Quantity| Corrections { bob: Some(Bob::ball(radius)), ..Corrections::default() };
    let apparatus = Apparatus { length: bare(1.0), corrections: ball(bare(0.02)) };
    let period = MeasuredPeriod::of_small_swings(about(2.006, 0.001));
    let budget = evaluate_budget(&apparatus, &period, &[]).unwrap();
    let inputs = vec![BudgetInput::Length, BudgetInput::BobRadius];
    assert_eq!(budget.warnings(), [BudgetWarning::WithoutUncertainty { inputs }]);
    assert!(budget.warnings()[0].to_string().contains("length, bob radius"));
    let of_row = |name: &str| budget.rows.iter().find(|row| row.name == name).unwrap().uncertainty;
    assert_eq!((of_row("length"), of_row("finite bob")), (None, None));
    let said = Apparatus { length: about(1.0, 0.0), corrections: ball(about(0.02, 0.0)) };
    let budget = evaluate_budget(&said, &period, &[]).unwrap();
    assert_eq!((budget.warnings(), budget.rows[0].uncertainty), (vec![], Some(0.0)));
}

#[test]
fn clock_and_damping_are_in_every_budget() {
    let apparatus = Apparatus::of_length(about(1.0, 0.001));
    let with = |period: MeasuredPeriod| evaluate_budget(&apparatus, &period, &[]).unwrap();
    let plain = MeasuredPeriod::of_small_swings(about(2.0, 0.001));
    let bare = with(plain);
    assert_eq!(correction(&bare, "clock"), Correction::Typical(-0.002));
    // The amplitude falls by e^-1 in 60 s: b = 1/30 s, ω = π/s.
    let part = square(1.0 / (60.0 * std::f64::consts::PI));
    assert!(matches!(correction(&bare, "damping"), Correction::Typical(size) if close(size, part, 1e-3)));
    let contained = with(MeasuredPeriod { damping: PeriodDamping::Contained(about(0.2, 0.05)), ..plain });
    let fitted = with(MeasuredPeriod { damping: PeriodDamping::Fitted(0.2), ..plain });
    let size = square(0.1 / std::f64::consts::PI);
    for budget in [&contained, &fitted] {
        assert!(
            matches!(correction(budget, "damping"), Correction::Applied(applied) if close(applied, size, 1e-9))
        );
    }
    assert!(close(contained.g / bare.g - 1.0, size, 1e-9) && close(fitted.g, bare.g, 1e-15));
    assert!(close(of(&contained, BudgetInput::Damping).change(), 2.0 * bare.g * size * 0.25, 1e-6));
    let clocked = with(MeasuredPeriod { clock: Some(0.001), ..plain });
    let row = clocked.rows.iter().find(|row| row.name == "clock").unwrap();
    assert!(close(row.uncertainty.unwrap(), 0.002 * clocked.g, 1e-9));
}

#[test]
fn every_input_has_a_name_and_units() {
    let names: std::collections::BTreeSet<&str> = BudgetInput::ALL.iter().map(|input| input.name()).collect();
    assert_eq!(names.len(), BudgetInput::ALL.len());
    for input in BudgetInput::ALL {
        let (unit, of_sensitivity) = (input.unit(), input.unit_of_sensitivity());
        // ∂g/∂x times x is an acceleration.
        let whole = match unit {
            "1" => "m/s^2",
            "m" => "1/s^2",
            "s" => "m/s^3",
            "1/s" => "m/s",
            "K" => "m/(s^2 K)",
            "1/K" => "m K/s^2",
            "N/m" => "m^2/(s^2 N)",
            "s^2/m" => "m^2/s^4",
            "kg" => "m/(s^2 kg)",
            "kg/m^3" => "m^4/(s^2 kg)",
            other => panic!("{other}"),
        };
        assert_eq!(of_sensitivity, whole, "{input:?}");
    }
}

/// In 2000 experiments of five timings each, the mean of which is T0, the true g is within U in 95 %, with a binomial standard
/// deviation of 0.5 %; Welch and Satterthwaite are right to about one per cent for so few degrees of freedom. With k = 2 for all it
/// would be 91 %.
#[test]
fn the_expanded_uncertainty_holds_the_truth_as_often_as_it_says() {
    const EXPERIMENTS: u32 = 2000;
    let mut random = Random::seeded(5);
    let (g, of_length, of_timing, of_clock) = (9.81, 0.001, 0.01, 0.0005);
    let mut within = 0;
    for _ in 0..EXPERIMENTS {
        let length = 1.0;
        let clock = 1.0 + of_clock * normal(&mut random);
        let truth = TAU * f64::sqrt(length / g) / clock;
        let timings: Vec<f64> = (0..5).map(|_| truth + of_timing * normal(&mut random)).collect();
        let mean = timings.iter().sum::<f64>() / 5.0;
        let variance = timings.iter().map(|t| (t - mean) * (t - mean)).sum::<f64>() / 4.0;
        let apparatus = Apparatus::of_length(about(length + of_length * normal(&mut random), of_length));
        let period = MeasuredPeriod {
            clock: Some(of_clock),
            degrees_of_freedom: 4.0,
            ..MeasuredPeriod::of_small_swings(about(mean, (variance / 5.0).sqrt()))
        };
        let budget = evaluate_budget(&apparatus, &period, &[]).unwrap();
        within += u32::from((budget.g - g).abs() < budget.combined.expanded());
    }
    assert!((1870..=1930).contains(&within), "{within} of {EXPERIMENTS}");
}

/// 4π²/2.006² = 9.811 m/s² for a metre; the uncertainty of the period alone is three of these off at 0.994 and at 1.005 m.
#[test]
fn a_gravity_found_nowhere_on_earth_is_blamed_on_the_length() {
    let of_length = |length: f64| {
        let period = MeasuredPeriod::of_small_swings(about(2.006, 0.0001));
        evaluate_budget(&Apparatus::of_length(about(length, 0.0)), &period, &[]).unwrap()
    };
    for length in [0.9957, 1.0020] {
        assert_eq!(of_length(length).warnings(), [], "{length}");
    }
    for length in [0.9945, 1.0030] {
        let warnings = of_length(length).warnings();
        let [warning @ BudgetWarning::GravityContradicted { length: given, likely_length, mistake: None }] =
            &warnings[..]
        else {
            panic!("{length}: {warnings:?}")
        };
        assert!((given - length).abs() < 1e-15 && (likely_length / 0.99879 - 1.0).abs() < 1e-4);
        assert_eq!(warning.name(), "gravity_contradicted");
        assert!(warning.to_string().contains("the length is about 0.999 m and not"), "{warning}");
    }
    let halves = of_length(4.0).warnings();
    assert!(
        halves[0].to_string().ends_with("what half periods taken for whole ones would give"),
        "{halves:?}"
    );
    assert_eq!(BudgetWarning::NotLinear.name(), "budget");
}
