//! The published formulas: their errors against mpmath, their crossovers, and identities of theta functions.
#![expect(clippy::disallowed_methods, clippy::float_cmp, reason = "expectations, some of them exact")]

use libration::progress::{Quiet, Status};
use std::cell::Cell;
use std::ops::ControlFlow;
use std::sync::LazyLock;

use libration::period_formulas::{
    Attribution, Complexity, ErrorTable, MOST_TERMS, PeriodFormula, catalogue, fractional_errors,
};
use libration::quantity::Angle;

fn rows(text: &str) -> impl Iterator<Item = Vec<&str>> {
    text.lines().filter(|line| !line.starts_with('#')).skip(1).map(|line| line.split(',').collect())
}

fn formula(key: &str) -> PeriodFormula {
    PeriodFormula::by_key(key).unwrap()
}

fn degrees(value: f64) -> Angle {
    Angle::from_degrees(value).unwrap()
}

fn relative(computed: f64, expected: f64) -> f64 {
    if computed == expected { 0.0 } else { ((computed - expected) / expected).abs() }
}

static TABLE: LazyLock<ErrorTable> = LazyLock::new(|| ErrorTable::new(catalogue(), &Quiet).unwrap());

fn index_of(key: &str) -> usize {
    TABLE.formulas().position(|formula| formula.key() == key).unwrap()
}

#[test]
fn fractional_errors_equal_those_of_3200_digits() {
    for row in rows(include_str!("../../../libration-testing/data/formulas_errors.csv")) {
        let amplitude = Angle::from_radians(row[0].parse().unwrap()).unwrap();
        let computed = formula(row[1]).fractional_error(&amplitude);
        let expected: f64 = row[3].parse().unwrap();
        assert!(relative(computed, expected) < f64::EPSILON, "{row:?}: {computed:e}");
    }
}

#[test]
fn ratios_in_plain_f64_are_good_to_a_few_ulp() {
    for row in rows(include_str!("../../../libration-testing/data/formulas_errors.csv")) {
        let (amplitude, expected): (f64, f64) = (row[0].parse().unwrap(), row[2].parse().unwrap());
        let computed = formula(row[1]).period_ratio_at(amplitude);
        assert!(relative(computed, expected) < 2e-15, "{row:?}: {computed:e}");
        assert_eq!(computed, formula(row[1]).period_ratio(&Angle::from_radians(amplitude).unwrap()));
    }
}

#[test]
fn quotients_of_errors_equal_the_published_ones() {
    for row in rows(include_str!("../../../libration-testing/data/formulas_error_quotients.csv")) {
        let amplitude = degrees(row[0].parse().unwrap());
        let error = |key| formula(key).fractional_error(&amplitude);
        let expected: f64 = row[3].parse().unwrap();
        assert!(relative((error(row[1]) / error(row[2])).abs(), expected) < 1e-11, "{row:?}");
    }
}

/// The amplitudes of the search for one row of the claims.
fn searched(row: &[&str]) -> Vec<f64> {
    match row[0] {
        "zero" => TABLE.amplitudes_where_exact(index_of(row[1])).iter().map(Angle::radians).collect(),
        "tolerance" => {
            let intervals = TABLE.holds_on(index_of(row[1]), row[3].parse().unwrap());
            intervals.into_iter().flat_map(|(from, to)| [from, to]).collect()
        }
        "crossover" => {
            let crossovers = TABLE.crossovers(index_of(row[1]), index_of(row[2]));
            crossovers.iter().map(|crossover| crossover.amplitude.radians()).collect()
        }
        _ => {
            let factor = row[3].parse().unwrap();
            let places = TABLE.amplitudes_where_ratio_of_errors(index_of(row[1]), index_of(row[2]), factor);
            places.iter().map(Angle::radians).collect()
        }
    }
}

#[test]
fn every_claimed_amplitude_is_found_by_the_search() {
    for row in rows(include_str!("../../../libration-testing/data/formulas_claims.csv")) {
        let expected: f64 = row[4].parse().unwrap();
        let amplitudes = searched(&row);
        let nearest =
            amplitudes.iter().map(|amplitude| (amplitude - expected).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-13, "{row:?}: {amplitudes:?}");
    }
}

#[test]
fn tolerances_hold_up_to_the_claimed_amplitudes() {
    assert!((TABLE.holds_to(index_of("denman"), 1e-3).to_degrees() - 77.785507775387).abs() < 1e-10);
    assert_eq!(TABLE.holds_on(index_of("denman"), 1e-3).len(), 2);
    assert_eq!(TABLE.holds_to(index_of("butikov"), 1e-3), 0.0);
    assert_eq!(TABLE.holds_on(index_of("butikov"), 1e-3).last().unwrap().1, std::f64::consts::PI);
    assert_eq!(TABLE.holds_to(index_of("chachiyo"), 0.002), std::f64::consts::PI);
}

#[test]
fn worst_errors_equal_the_published_ones() {
    let bounds = [90.0, 150.0, 179.0];
    for row in rows(include_str!("../../../libration-testing/data/formulas_worst_errors.csv")) {
        let formula = formula(row[0]);
        for (bound, printed) in bounds.into_iter().zip(&row[1..]) {
            let Ok(published) = printed.parse::<f64>() else { continue };
            // The published numbers are maxima of the bound over amplitudes in steps of 1/360.
            let sampled =
                (1..=360).map(|i| formula.fractional_error(&degrees(bound * f64::from(i) / 360.0)).abs());
            let sampled = sampled.fold(0.0, f64::max);
            assert!(relative(sampled, published) < 5.1e-6, "{} to {bound}°: {sampled}", row[0]);
            let worst = formula.worst_error(&degrees(bound / 360.0), &degrees(bound)).unwrap().error.abs();
            assert!(worst >= sampled * (1.0 - 1e-12), "{} to {bound}°: {worst} < {sampled}", row[0]);
            assert!(worst <= sampled * 1.001, "{} to {bound}°: {worst} > {sampled}", row[0]);
        }
    }
}

/// The stored errors are those of the search; those that are missing or differ are printed as the table has them.
#[test]
fn stored_errors_are_those_of_the_search() {
    let mut differing = vec![];
    for formula in catalogue() {
        let searched = formula.worst_error(&degrees(0.0), &degrees(90.0)).unwrap().error;
        if relative(formula.worst_error_to_90deg(), searched) > 1e-14 || !is_stored(formula.key()) {
            differing.push(format!("    (\"{}\", {searched:?}),", formula.key()));
        }
    }
    assert!(differing.is_empty(), "\n{}", differing.join("\n"));
}

fn is_stored(key: &str) -> bool {
    include_str!("../../src/period_formulas/worst.rs").contains(&format!("(\"{key}\", "))
}

#[test]
fn leading_errors_are_the_limits_of_the_errors() {
    for formula in catalogue() {
        let Some(leading) = formula.leading_error() else { continue };
        let amplitude = 1e-4_f64;
        let power = f64::from(leading.power);
        let quotient = formula.fractional_error_at(amplitude).abs().ln() - power * amplitude.ln();
        let expected = leading.coefficient.to_f64().abs().ln();
        assert!((quotient - expected).abs() < 1e-6, "{}: {leading}", formula.key());
        let sign = formula.fractional_error_at(amplitude).signum();
        assert_eq!(sign, leading.coefficient.to_f64().signum(), "{}", formula.key());
    }
}

/// θ₃(q)⁻² − 1 or, with −q, θ₄(q)⁻² − 1, free of cancellation (DLMF 20.2.3, 20.2.4).
fn theta_error(q: f64) -> f64 {
    let excess: f64 =
        (1..40).map(|n| 2.0 * q.abs().powi(n * n) * if n % 2 == 1 { q.signum() } else { 1.0 }).sum();
    -excess * (2.0 + excess) / (1.0 + excess).powi(2)
}

#[test]
fn errors_of_the_means_are_theta_functions_of_the_nome() {
    // At a right angle k = k′, so that the nome is e^(−π).
    let right_angle = Angle::from_degrees(90.0).unwrap();
    let nome_power = |n: i32| (-std::f64::consts::PI * f64::from(1 << n)).exp();
    for (key, n) in [("agm_a1", 1), ("agm_a2", 2), ("agm_a3", 3), ("agm_a4", 4), ("agm_a5", 5)] {
        let expected = theta_error(nome_power(n));
        assert!(relative(formula(key).fractional_error(&right_angle), expected) < 1e-13, "{key}");
    }
    for (key, n) in [("agm_b1", 1), ("agm_b2", 2)] {
        let expected = theta_error(-nome_power(n));
        assert!(relative(formula(key).fractional_error(&right_angle), expected) < 1e-13, "{key}");
    }
}

#[test]
fn the_one_term_formula_is_exact_at_141_degrees() {
    let formula = formula("denman");
    let error = |offset: f64| formula.fractional_error_at(2.4630902111802985 + offset);
    assert!(error(-1e-12) > 0.0 && error(1e-12) < 0.0);
}

#[test]
fn formulas_that_are_the_same_are_listed_once_and_found_by_both_keys() {
    for (key, listed) in [
        ("power_series_1", "bernoulli"),
        ("agm_a2", "carvalhaes_suppes"),
        ("agm_b1", "kidd_fogg"),
        ("power_series_0", "small_angle"),
    ] {
        assert_eq!(formula(key).key(), listed);
    }
    let keys: Vec<&str> = catalogue().iter().map(PeriodFormula::key).collect();
    assert!(keys.iter().all(|key| keys.iter().filter(|other| *other == key).count() == 1));
}

#[test]
fn series_formulas_have_any_number_of_terms() {
    let amplitude = degrees(90.0);
    for stem in ["power_series", "black_vel", "sin2_series"] {
        let error = |n: usize| formula(&format!("{stem}_{n}")).fractional_error(&amplitude).abs();
        assert!(error(40) < error(7) && error(7) < error(3), "{stem}");
    }
    assert!(formula("power_series_40").fractional_error(&amplitude).abs() < 1e-24);
    assert!(PeriodFormula::by_key(&format!("power_series_{}", MOST_TERMS + 1)).is_err());
}

#[test]
fn an_unknown_key_is_answered_with_the_nearest_ones() {
    let refusal = PeriodFormula::by_key("molino").unwrap_err();
    assert_eq!(refusal.near[0], "molina");
    assert!(refusal.to_string().starts_with("no formula has the key `molino`"));
    for key in
        ["", "power_series_", "power_series_-1", "power_series_07", "power_series_99999999999999999999"]
    {
        assert!(PeriodFormula::by_key(key).is_err(), "{key}");
    }
}

#[test]
fn outside_the_swing_there_is_no_error() {
    for formula in catalogue() {
        assert!(formula.fractional_error(&Angle::from_radians(4.0).unwrap()).is_nan());
        assert!(formula.period_ratio_at(f64::NAN).is_nan() && formula.period_ratio_at(-1.0).is_nan());
        assert!(formula.period_ratio_at(0.0).is_finite() && formula.fractional_error_at(0.0).is_finite());
    }
    assert_eq!(formula("molina").fractional_error_at(0.0), 0.0);
    assert_eq!(formula("lima_arun").period_ratio_at(0.0), 1.0);
    assert_eq!(formula("cubic_force").fractional_error_at(3.0), f64::INFINITY);
}

#[test]
fn near_the_top_the_complement_counts() {
    // The next term of the expansion about the top: δ²(1/16 − 1/(48 L)), L = ln(8/δ).
    let complement = 1e-40_f64;
    let error = formula("butikov").fractional_error(&Angle::from_complement(complement).unwrap());
    let logarithm = (8.0 / complement).ln();
    let expected = -complement * complement * (1.0 / 16.0 - 1.0 / (48.0 * logarithm));
    assert!(relative(error, expected) < 1e-13, "{error:e}");
}

#[test]
fn the_last_amplitudes_below_the_top_are_the_same_as_angles_and_in_radians() {
    let mut radians = std::f64::consts::PI;
    for _ in 0..40 {
        let angle = Angle::from_radians(radians).unwrap();
        for formula in catalogue() {
            assert_eq!(formula.fractional_error_at(radians), formula.fractional_error(&angle), "{radians}");
        }
        radians = radians.next_down();
    }
}

#[test]
fn simplest_formulas_come_first_and_keep_their_tolerance() {
    let amplitude = degrees(90.0);
    let sufficient = TABLE.simplest(&amplitude, 1e-4);
    let ranks: Vec<u32> = sufficient.iter().map(|formula| formula.complexity().rank()).collect();
    assert!(ranks.is_sorted());
    for formula in catalogue() {
        let worst = formula.worst_error(&degrees(0.01), &amplitude).unwrap().error.abs();
        let listed = sufficient.iter().any(|listed| listed.key() == formula.key());
        assert_eq!(listed, worst <= 1e-4, "{}: {worst}", formula.key());
    }
    assert_eq!(Complexity { functions: 1, roots: 1, operations: 1 }.rank(), 6);
}

#[test]
fn errors_are_equal_at_every_crossover_and_the_lead_changes() {
    for crossover in TABLE.all_crossovers(&Quiet) {
        let (below, above) = (formula(&crossover.better_below), formula(&crossover.better_above));
        let gap = |amplitude: &Angle| {
            below.fractional_error(amplitude).abs() - above.fractional_error(amplitude).abs()
        };
        // The error from the spacing of `f64` amplitudes, which matters next to the zero of an error.
        let slope = gap(&Angle::from_radians(crossover.amplitude.radians() + 1e-9).unwrap()).abs() / 1e-9;
        let allowed = 1e-9 * crossover.error + 4e-15 * slope;
        assert!(gap(&crossover.amplitude).abs() <= allowed || slope.is_nan(), "{crossover:?}");
    }
}

#[test]
fn a_search_can_be_stopped_and_keeps_what_it_has() {
    let pairs = Cell::new(0);
    let progress = |status: Status| {
        pairs.set(status.done);
        if status.done == 40 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let some = TABLE.all_crossovers(&progress);
    assert_eq!(pairs.get(), 40);
    assert!(!some.is_empty() && TABLE.all_crossovers(&Quiet).starts_with(&some));
}

#[test]
fn errors_that_share_the_exact_period_are_those_of_each_formula_alone() {
    let seldom = ["0", "1e-9", "60deg", "170deg", "pi-1e-12", "pi", "pi-1e-300", "540deg", "-60deg"];
    let seldom = seldom.map(|text| text.parse().unwrap());
    let often = (0..150).map(|degrees| Angle::from_degrees(f64::from(degrees)).unwrap());
    let amplitudes: Vec<Angle> = often.chain(seldom).collect();
    let shared = fractional_errors(catalogue(), &amplitudes);
    assert_eq!(shared.len(), amplitudes.len() * catalogue().len());
    for (amplitude, shared) in amplitudes.iter().zip(shared.chunks(catalogue().len())) {
        for (formula, &shared) in catalogue().iter().zip(shared) {
            let alone = formula.fractional_error(amplitude);
            let near = shared == alone || (shared - alone).abs() <= 2.0 * f64::EPSILON * alone.abs();
            let same = near || shared.is_nan() && alone.is_nan();
            assert!(same, "{} at {amplitude}: {shared} beside {alone}", formula.key());
        }
    }
    assert!(fractional_errors(catalogue(), &[]).is_empty() && fractional_errors(&[], &amplitudes).is_empty());
}

#[test]
fn every_key_of_a_formula_finds_it() {
    for entry in catalogue() {
        for key in entry.other_keys() {
            assert_eq!(formula(key).key(), entry.key(), "{key}");
        }
    }
    assert_eq!(formula("carvalhaes_suppes").other_keys(), ["agm_a2", "ingham"]);
}

#[test]
fn what_rests_on_memory_says_so_in_its_source() {
    for entry in catalogue() {
        let by_word = entry.source().contains("attributed to");
        assert_eq!(entry.attribution() == Attribution::Attributed, by_word, "{}", entry.key());
    }
}

#[test]
fn a_formula_that_ends_below_the_top_has_no_error_from_there_on() {
    for entry in catalogue() {
        let end = entry.defined_below();
        assert!(entry.fractional_error_at(end.next_down()).is_finite(), "{}", entry.key());
        assert_eq!(end < core::f64::consts::PI, entry.key() == "cubic_force", "{}", entry.key());
    }
    assert!(formula("cubic_force").fractional_error_at(2.83).is_infinite());
}

#[test]
fn two_formulas_cross_where_the_table_says() {
    let (one, other) = (formula("bernoulli"), formula("kidd_fogg"));
    let alone: Vec<f64> =
        one.crossovers_with(&other).iter().map(|crossover| crossover.amplitude.radians()).collect();
    let in_table = TABLE.crossovers(index_of("bernoulli"), index_of("kidd_fogg"));
    assert_eq!(alone, in_table.iter().map(|crossover| crossover.amplitude.radians()).collect::<Vec<_>>());
    for amplitude in alone {
        let (a, b) = (one.fractional_error_at(amplitude), other.fractional_error_at(amplitude));
        assert!((a.abs() / b.abs() - 1.0).abs() < 1e-9, "{amplitude}: {a} {b}");
    }
}

#[test]
fn the_formula_of_denman_keeps_its_older_key() {
    let denman = PeriodFormula::by_key("black_vel_1").unwrap();
    assert_eq!((denman.key(), denman.authors(), denman.year()), ("denman", "H. H. Denman", Some(1959)));
    assert!((denman.period_ratio_at(1.0) - 16.0 / 15.0).abs() < 1e-15);
    assert_eq!(PeriodFormula::by_key("black_vel_2").unwrap().year(), Some(2023));
}

#[test]
fn attributions_that_were_not_verified_say_so() {
    for formula in catalogue() {
        let is_marked = formula.source().ends_with("not verified against the original");
        let attributed = formula.attribution() == Attribution::Attributed;
        assert!(is_marked || !attributed, "{}: {}", formula.key(), formula.source());
        assert!(
            is_marked || formula.authors().is_empty() || !formula.source().contains("attributed"),
            "{}",
            formula.key()
        );
    }
}
