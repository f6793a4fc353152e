//! Exact values and their stated uncertainties compared with energy integrals in 120 digits, on both sides of separatrices, up to 1e-12 from them
//! and on them.

use std::f64::consts::TAU;

use libration::comparison::{
    Backbone, ExactMotion, ExactValue, ExactValueError, Method, SeriesComparison, SeriesQuantity,
};
use libration::oscillator::{NamedOscillator, Oscillator};
use libration::perturbation::{Expansion, Gauge, expand};
use libration::progress::Quiet;
use libration::quantity::Displacement;
use libration_testing::golden::{Row, Table};
use libration_testing::sweep;

struct Known {
    oscillator: Oscillator,
    expansion: Expansion,
}

impl Known {
    fn new(key: &str) -> Self {
        let oscillator = NamedOscillator::by_key(key).unwrap().oscillator(&[]).unwrap();
        let expansion = expand(&oscillator, 3, &Gauge::Fundamental, &Quiet).unwrap();
        Self { oscillator, expansion }
    }

    fn exact(&self, quantity: SeriesQuantity, amplitude: &str) -> Result<ExactValue, ExactValueError> {
        SeriesComparison::new(&self.oscillator, &self.expansion, quantity)
            .exact_from(&displacement(amplitude), &Quiet)
    }

    /// The motion of which [`exact`](Self::exact) takes one value.
    fn motion(&self, amplitude: &str) -> ExactMotion {
        ExactMotion::new(&self.oscillator, &self.expansion, &displacement(amplitude), &Quiet).unwrap()
    }
}

fn displacement(text: &str) -> Displacement {
    let angle = text.contains("pi") || text.ends_with("deg");
    let read = if angle { Displacement::from_angle_text } else { Displacement::from_number_text };
    read(text).unwrap()
}

/// Asserts that the error is below the stated one, apart from four roundings of the reference, and that the stated error is a few units in the last
/// digit of a size, at any distance from the separatrix.
fn assert_holds(exact: &ExactValue, truth: f64, size: f64, what: &str) {
    let error = (exact.value - truth).abs();
    let stated = exact.uncertainty;
    assert!(error <= stated + 4.0 * f64::EPSILON * truth.abs(), "{what}: {error:e} is more than {stated:e}");
    assert!(stated <= 1e-12 * size, "{what}: {stated:e} is stated");
}

fn check(key: &str) {
    let reference = Known::new(key);
    let small_period = TAU / reference.oscillator.omega0_squared().to_f64().sqrt();
    let table = Table::read("periods_near_separatrix.csv");
    // At the separatrix itself, and elsewhere every third row, of which the last are next to it.
    let at_separatrix = |row: &Row| row.input("period").is_infinite();
    let rows = sweep::part_and(table.rows().filter(|row| row.text("key") == key), 3, at_separatrix);
    assert!(rows.len() > 1, "{key}");
    for row in rows {
        let (amplitude, what) = (row.text("amplitude"), format!("{key} at {}", row.text("amplitude")));
        let period = row.input("period");
        let exact = reference.exact(SeriesQuantity::Period, amplitude);
        if period.is_infinite() {
            assert!(matches!(exact, Err(ExactValueError::Infinite(_))), "{what}: {exact:?}");
            continue;
        }
        let exact = exact.unwrap_or_else(|reason| panic!("{what}: {reason}"));
        assert_holds(&exact, period / small_period, period / small_period, &what);
        assert_eq!(exact.method == Method::Elliptic, key == "pendulum");
        assert_eq!(
            exact.encloses.is_some(),
            key == "double_well" && displacement(amplitude).to_f64() > 0.414_213_562_373_095_04
        );
        if row.text("a1").is_empty() && row.text("a3").is_empty() {
            continue;
        }
        let motion = reference.motion(amplitude);
        for (column, k) in [("a1", 1), ("a3", 3)] {
            if !row.text(column).is_empty() {
                let exact = motion.value(SeriesQuantity::Cosine(k)).unwrap();
                // What the period may be wrong by counts for each harmonic, with the velocity as factor.
                let size = 10.0 * displacement(amplitude).to_f64();
                assert_holds(&exact, row.input(column), size, &format!("{column} of {what}"));
            }
        }
    }
}

mod sweeps {
    use super::check;

    #[test]
    fn uncertainties_hold_for_duffings_oscillator_that_softens() {
        check("duffing_soft");
    }

    #[test]
    fn uncertainties_hold_for_the_quadratic_oscillator() {
        check("quadratic");
    }

    #[test]
    fn uncertainties_hold_for_the_pendulum() {
        check("pendulum");
    }

    #[test]
    fn uncertainties_hold_for_the_pendulum_on_a_hoop() {
        check("rotating_hoop");
    }

    #[test]
    fn uncertainties_hold_on_both_sides_of_the_barrier_between_two_wells() {
        check("double_well");
    }

    #[test]
    fn uncertainties_hold_far_from_any_separatrix() {
        for key in ["duffing", "sinh", "x_over_sqrt", "cubic_quintic", "toda"] {
            check(key);
        }
    }
}

/// At 0.999999999 the decimal and the `f64` next to it differ in the ninth digit of the period.
#[test]
fn a_decimal_and_its_f64_are_two_amplitudes() {
    let reference = Known::new("duffing_soft");
    let relation = SeriesComparison::new(&reference.oscillator, &reference.expansion, SeriesQuantity::Period);
    let decimal = relation.exact_from(&displacement("0.999999999"), &Quiet).unwrap();
    let double = relation.exact_at(0.999_999_999, &Quiet).unwrap();
    assert_holds(&decimal, 62.535_279_781_833_69 / TAU, 10.0, "the decimal");
    assert_holds(&double, 62.535_279_861_827_07 / TAU, 10.0, "its f64");
    assert_eq!(
        relation.exact_at(f64::NAN, &Quiet).map_err(|refusal| refusal.to_string()).unwrap_err(),
        "the amplitude is NaN: give a finite number above zero"
    );
}

#[test]
fn a_backbone_takes_the_decimal_too() {
    let curve = Backbone::new(&"x'' = -x + x^3".parse().unwrap(), None, 3, &Quiet).unwrap();
    for (point, period) in [
        (curve.at_displacement(&displacement("0.999999999"), &Quiet), 62.535_279_781_833_69),
        (curve.at(0.999_999_999, &Quiet), 62.535_279_861_827_07),
    ] {
        let orbit = point.orbit.unwrap();
        assert!((orbit.frequency - TAU / period).abs() <= orbit.uncertainty + f64::EPSILON * orbit.frequency);
        assert!(orbit.uncertainty < 1e-15 && point.exact.is_none());
    }
    assert!(curve.at(f64::INFINITY, &Quiet).orbit.is_err());
}

/// Amplitudes from small swings to the end of the well.
#[test]
fn the_curve_in_a_picture_has_six_digits() {
    let wells = [
        ("theta'' = -sin(theta)", std::f64::consts::PI),
        ("x'' = -x + x^3", 1.0),
        ("x'' = -x - x^2", 0.5),
        ("x'' = -x^3", 1e3),
        ("x'' = -x - 5*x^5", 10.0),
    ];
    for (equation, end) in wells {
        let curve = Backbone::new(&equation.parse().unwrap(), None, 1, &Quiet).unwrap();
        for part in [1e-6, 0.01, 0.3, 0.9, 0.999, 1.0 - 1e-6, 1.0 - 1e-10] {
            let amplitude = Displacement::from_f64(part * end).unwrap();
            let [drawn, orbit] =
                [curve.drawn_at(&amplitude, &Quiet), curve.at_displacement(&amplitude, &Quiet)]
                    .map(|point| point.orbit.unwrap());
            let error = (drawn.frequency / orbit.frequency - 1.0).abs();
            assert!(error < 1e-6, "{equation} at {part} of {end}: {error:e}");
        }
    }
}

/// The period of x″ + x + x² = 0 has a logarithm at 1/2, on whose cut, beyond it, approximants have their poles; that of x″ + x + x³ = 0 has
/// none.
#[test]
fn approximants_have_their_poles_beyond_the_separatrix() {
    let pole = |key: &str, degree: usize| {
        let oscillator = NamedOscillator::by_key(key).unwrap().oscillator(&[]).unwrap();
        let expansion = expand(&oscillator, 31, &Gauge::Fundamental, &Quiet).unwrap();
        SeriesComparison::new(&oscillator, &expansion, SeriesQuantity::Period)
            .approximant(degree)
            .unwrap()
            .first_pole()
    };
    assert!(pole("quadratic", 8).is_some_and(|pole| (0.5..0.55).contains(&pole)));
    assert!(pole("duffing_soft", 4).is_some_and(|pole| (1.0..1.25).contains(&pole)));
    assert_eq!(pole("duffing", 4), None);
}

#[test]
fn frequencies_have_the_uncertainty_of_their_period() {
    let reference = Known::new("double_well");
    let [period, frequency] = [SeriesQuantity::Period, SeriesQuantity::Frequency]
        .map(|quantity| reference.exact(quantity, "0.4").unwrap());
    assert!((period.value * frequency.value - 1.0).abs() <= f64::EPSILON);
    let relative = |exact: &ExactValue| exact.uncertainty / exact.value;
    assert!((relative(&period) / relative(&frequency) - 1.0).abs() < 1e-12);
}

/// Strength and period, by a Taylor method of order 55 with 260 bits.
const VAN_DER_POL: [(&str, f64); 6] = [
    ("0.01", 6.283_224_576_985_483),
    ("0.1", 6.287_111_272_288_727),
    ("-0.1", 6.287_111_272_288_727),
    ("0.5", 6.380_675_801_773_586),
    ("1", 6.663_286_859_323_13),
    ("2", 7.629_874_479_674_842),
];

#[test]
fn limit_cycles_are_found_and_their_uncertainties_hold() {
    let reference = Known::new("van_der_pol");
    for (strength, period) in VAN_DER_POL {
        let exact = reference.exact(SeriesQuantity::Period, strength).unwrap();
        assert_holds(&exact, period / TAU, 1.0, strength);
        assert_eq!(exact.method, Method::Integration);
    }
    let refusal = reference.exact(SeriesQuantity::Period, "0").unwrap_err();
    assert_eq!(refusal, ExactValueError::Strength(0.0));
}

/// The largest difference between 2·cos τ − (μ/4)·sin 3τ, the series to the first order, and the cycle at the same phase: by SciPy's DOP853 with a
/// tolerance of 1e-13 and a fast Fourier transform over 4096 phases.
const VAN_DER_POL_TO_FIRST_ORDER: [(&str, f64); 3] =
    [("0.1", 0.0013010691048822576), ("-0.1", 0.0013010691048822576), ("0.5", 0.03191796203045061)];

#[test]
fn the_distance_of_a_limit_cycle_from_its_orbit_is_that_of_another_program() {
    let oscillator = NamedOscillator::by_key("van_der_pol").unwrap().oscillator(&[]).unwrap();
    let distance = |order: usize, strength: &str| {
        let expansion = expand(&oscillator, order, &Gauge::Fundamental, &Quiet).unwrap();
        let comparison = SeriesComparison::new(&oscillator, &expansion, SeriesQuantity::Period);
        let strength = Displacement::from_number_text(strength).unwrap();
        comparison.cycle_distance(&strength, &Quiet).unwrap()
    };
    for (strength, expected) in VAN_DER_POL_TO_FIRST_ORDER {
        let computed = distance(1, strength).unwrap();
        // 512 phases miss the maximum of a difference with harmonics up to the seventh by 1e-3 of it.
        assert!((computed.distance / expected - 1.0).abs() < 1e-3 && computed.is_near(), "{computed:?}");
    }
    let precise = distance(15, "0.1").unwrap();
    assert!(precise.distance < 1e-13 && precise.uncertainty < 1e-13, "{precise:?}");
    // Far beyond the radius of convergence there is nothing near.
    assert!(distance(15, "6").map_or(true, |computed| !computed.is_near()));
    assert!(matches!(distance(3, "0"), Err(ExactValueError::Strength(_))));
}

#[test]
fn motions_that_do_not_return_are_refused_for_a_reason() {
    let from =
        |key: &str, amplitude: &str| Known::new(key).exact(SeriesQuantity::Period, amplitude).unwrap_err();
    assert_eq!(from("quadratic", "0.6"), ExactValueError::NoReturn(0.6));
    assert_eq!(from("quadratic", "0.500000000001"), ExactValueError::NoReturn(0.500000000001));
    assert!(matches!(
        from("duffing_soft", "1.5"),
        ExactValueError::NoReturn(_) | ExactValueError::NotRestoring(_)
    ));
    assert!(matches!(from("pendulum", "181deg"), ExactValueError::NotRestoring(_)));
    assert!(matches!(from("rotating_hoop", "181deg"), ExactValueError::NotRestoring(_)));
    assert_eq!(from("duffing", "-1"), ExactValueError::Amplitude(-1.0));
    assert_eq!(from("pendulum", "0"), ExactValueError::Amplitude(0.0));
}
