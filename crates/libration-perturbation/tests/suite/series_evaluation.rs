//! Series in numbers: partial sums, bounds on the remainder, radii of convergence, Padé approximants.

use std::f64::consts::PI;

use libration::algebra::{Complex, Rational};
use libration::comparison::{SeriesComparison, SeriesQuantity};
use libration::oscillator::NamedOscillator;
use libration::pendulum::Pendulum;
use libration::period_formulas::{frequency_in_amplitude, period_in_amplitude};
use libration::perturbation::{
    Certainty, Convergence, Gauge, Pade, SeriesEvaluation, Singularity, expand, pendulum_period_remainder,
};
use libration::progress::Quiet;
use libration::quantity::Angle;
use libration_testing::golden::Table;

fn rational(text: &str) -> Rational {
    text.parse().unwrap()
}

/// A series by powers of x², as one by powers of x.
fn even(coefficients: &[Rational]) -> Vec<Rational> {
    coefficients.iter().flat_map(|coefficient| [coefficient.clone(), Rational::from(0)]).collect()
}

/// T/T0 of the pendulum at an amplitude in radians.
fn exact(amplitude: f64) -> f64 {
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    let motion = pendulum.released_from(Angle::from_radians(amplitude).unwrap()).unwrap();
    motion.period() / pendulum.small_angle_period()
}

/// The pendulum's period series with its proven remainders.
fn period(corrections: usize, amplitude: f64) -> SeriesEvaluation {
    let bound = |power| pendulum_period_remainder(amplitude, power / 2);
    SeriesEvaluation::new(&even(&period_in_amplitude(corrections)), amplitude).with_bound(bound)
}

/// T/T0 of x″ + x + x³ = 0 by powers of z = A²: (1 + z)^(−1/2)·(2/π)K(m) with m = z/(2(1 + z)).
fn duffing(length: i64) -> Vec<Rational> {
    let mut series = vec![Rational::from(0); usize::try_from(length).unwrap()];
    let mut elliptic = Rational::from(1);
    for n in 0..length {
        // (½)ₙ²/n!²·2⁻ⁿ, times the coefficients of zⁿ(1 + z)^(−n − 1/2).
        let mut binomial = Rational::from(1);
        for j in n..length {
            let slot = &mut series[usize::try_from(j).unwrap()];
            *slot = slot.clone() + elliptic.clone() * binomial.clone();
            binomial = binomial * Rational::new(-(2 * j + 1), 2 * (j - n + 1)).unwrap();
        }
        let step = Rational::new(2 * n + 1, 2 * n + 2).unwrap();
        elliptic = elliptic * step.clone() * step * rational("1/2");
    }
    series
}

/// (1 − 2z·(3/5)/ρ + z²/ρ²)^(−1/2): Legendre polynomials at 3/5, singular at ρ(3 ± 4i)/5.
fn pair(length: i64, rho: i64) -> Vec<Rational> {
    let mut legendre = vec![Rational::from(1), rational("3/5")];
    for n in 1..length {
        let (last, before) = (legendre[legendre.len() - 1].clone(), legendre[legendre.len() - 2].clone());
        let next = last * Rational::new(3 * (2 * n + 1), 5 * (n + 1)).unwrap()
            - before * Rational::new(n, n + 1).unwrap();
        legendre.push(next);
    }
    let inverse = Rational::new(1, rho).unwrap();
    let mut power = Rational::from(1);
    legendre
        .into_iter()
        .map(|value| {
            let term = value * power.clone();
            power = power.clone() * inverse.clone();
            term
        })
        .collect()
}

/// T/T0 of x″ + x + x³ + x⁵ = 0 by powers of A², by reversion of the potential with python-flint. The force has further
/// zeros at A² = e^(±2πi/3), where a separatrix ends the series.
const CUBIC_QUINTIC: [&str; 12] = [
    "1",
    "-3/8",
    "-23/256",
    "469/2048",
    "-97285/786432",
    "-250921/6291456",
    "69222521/603979776",
    "-112601777/1610612736",
    "-6514578167/274877906944",
    "1481533518365/19791209299968",
    "-92333126443789/1899956092796928",
    "-253320174431833/15199648742375424",
];

/// Ω of the Van der Pol oscillator by powers of μ², with python-flint; singular at |μ| = 1.85 (C. M. Andersen and J. F.
/// Geer, SIAM J. Appl. Math. 42, 678 (1982)).
const VAN_DER_POL: [&str; 12] = [
    "1",
    "-1/16",
    "17/3072",
    "35/884736",
    "-678899/5096079360",
    "28160413/2293235712000",
    "16729607288111/3698530556313600000",
    "-5722795344767278507/5219366321069752320000000",
    "-1846779765852173498887007/14731139504587268947968000000000",
    "3202506386889338212533493973243/41577168137747107878744883200000000000",
    "-4038372199485064617691118289043994731/3872464178615255430139995425341440000000000000",
    "-56002320086753768951322082337270395510634270309/11902381115621105952443537043358727798784000000000000000",
];

#[test]
fn sums_of_the_period_series_are_the_exact_period() {
    for degrees in [1e-3_f64, 10.0, 60.0, 90.0] {
        let amplitude = degrees.to_radians();
        let ratio = period(40, amplitude);
        assert!((ratio.value() - exact(amplitude)).abs() <= f64::EPSILON * ratio.value());
    }
}

#[test]
fn the_proven_bound_encloses_the_exact_period_tightly() {
    for degrees in [10_f64, 60.0, 90.0, 120.0, 150.0, 170.0] {
        let amplitude = degrees.to_radians();
        let truth = exact(amplitude);
        for step in period(60, amplitude).steps() {
            let missing = truth - step.sum;
            let rounding = 2.0 * f64::EPSILON * truth;
            assert!(missing >= -rounding && missing <= step.remainder.size + rounding, "{degrees} {step:?}");
            // For N ≥ 1 nearly sharp; the constant 11π⁴/1536 is 10 % above the limit 2/π.
            if step.power > 0 && missing > 1e-9 {
                assert!(step.remainder.size < 1.3 * missing, "{degrees} {step:?}");
            }
            assert_eq!(step.remainder.certainty, Certainty::Proven);
        }
    }
}

#[test]
fn the_bound_holds_for_every_coefficient_known() {
    // tₙπ²ⁿn ≤ 11π⁴/1536, with equality at n = 2, where the bound is rounded up by 1e-13.
    for (n, coefficient) in (0..).zip(period_in_amplitude(200)).skip(1) {
        let scaled = coefficient.to_f64() * libm::pow(PI, 2.0 * f64::from(n)) * f64::from(n);
        assert!(scaled <= 0.69759114672860 * (1.0 + 1e-13), "{n}: {scaled}");
    }
    assert_eq!(pendulum_period_remainder(PI, 3), f64::INFINITY);
    assert_eq!(pendulum_period_remainder(4.0, 3), f64::INFINITY);
    assert_eq!(pendulum_period_remainder(0.0, 3), 0.0);
    assert!(pendulum_period_remainder(f64::NAN, 3).is_nan());
}

/// The number of terms for each tolerance: from the proven bound, and from the sums themselves.
#[test]
fn the_number_of_terms_needed_is_the_true_one() {
    let (slow, fast) = (even(&period_in_amplitude(330)), even(&frequency_in_amplitude(330)));
    for row in Table::read("series_terms_needed.csv").rows() {
        let (amplitude, tolerance) = (row.input("degrees").to_radians(), row.input("tolerance"));
        let count = |name: &str| row.text(name).parse::<usize>().ok();
        let case = format!("{} at {}", row.text("tolerance"), row.text("degrees"));
        let evaluation = SeriesEvaluation::new(&slow, amplitude);
        assert_eq!(evaluation.corrections_needed(tolerance), count("period"), "{case}");
        let bound = |power| pendulum_period_remainder(amplitude, power / 2);
        assert_eq!(evaluation.with_bound(bound).corrections_needed(tolerance), count("certified"), "{case}");
        let needed = SeriesEvaluation::new(&fast, amplitude).corrections_needed(tolerance);
        assert_eq!(needed, count("frequency"), "{case}");
    }
}

#[test]
fn sums_that_cancel_are_still_right() {
    // e⁻³⁰ = 9.4e-14, with terms up to 8e11.
    let mut coefficient = Rational::from(1);
    let mut exponential = vec![coefficient.clone()];
    for n in 1..160 {
        coefficient = coefficient * Rational::new(1, n).unwrap();
        exponential.push(coefficient.clone());
    }
    let value = SeriesEvaluation::new(&exponential, -30.0).value();
    assert!((value / 9.357622968840175e-14 - 1.0).abs() < 1e-15, "{value:e}");
}

#[test]
fn estimated_remainders_cover_the_truth_within_a_small_factor() {
    for degrees in [30_f64, 90.0, 120.0] {
        let amplitude = degrees.to_radians();
        let truth = 1.0 / exact(amplitude);
        for corrections in [12, 20, 30] {
            let evaluation = SeriesEvaluation::new(&even(&frequency_in_amplitude(corrections)), amplitude);
            let last = evaluation.steps()[corrections];
            let missing = (truth - last.sum).abs() - f64::EPSILON;
            assert!(missing <= last.remainder.size, "{degrees} {corrections}: {missing:e} {last:?}");
            assert_eq!(last.remainder.certainty, Certainty::Estimated);
        }
    }
}

#[test]
fn outside_the_circle_of_convergence_nothing_is_promised() {
    let evaluation = SeriesEvaluation::new(&even(&duffing(20)), 1.5);
    assert_eq!(evaluation.steps()[19].remainder.size, f64::INFINITY);
    assert_eq!(evaluation.corrections_needed(0.1), None);
    assert_eq!(SeriesEvaluation::new(&[], 1.0).corrections_needed(0.1), None);
}

#[test]
fn what_is_not_finite_gives_nan() {
    let series = period_in_amplitude(10);
    for x in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
        let evaluation = SeriesEvaluation::new(&series, x);
        assert!(evaluation.value().is_nan() && evaluation.corrections_needed(1.0).is_none());
        assert!(Pade::new(&series, 2, 2).unwrap().value_at(x).is_nan());
    }
    for x in [1e-300, 1e300, -0.0] {
        assert!(!SeriesEvaluation::new(&series, x).value().is_nan());
    }
}

#[test]
fn radii_of_convergence_are_found_with_honest_ranges() {
    let negated = |series: Vec<Rational>| -> Vec<Rational> {
        let sign = |n: usize| Rational::from(if n.is_multiple_of(2) { 1 } else { -1 });
        series.into_iter().enumerate().map(|(n, term)| term * sign(n)).collect()
    };
    let angle = libm::acos(0.6);
    // Series, radius, its largest relative error, where the singularity is.
    let cases = [
        ("pendulum, period", even(&period_in_amplitude(30)), PI, 1e-3, Singularity::Positive),
        ("pendulum, few terms", even(&period_in_amplitude(10)), PI, 0.02, Singularity::Positive),
        ("pendulum, frequency", even(&frequency_in_amplitude(60)), PI, 0.02, Singularity::Positive),
        ("hard duffing", even(&duffing(30)), 1.0, 1e-3, Singularity::Negative),
        ("soft duffing", even(&negated(duffing(30))), 1.0, 1e-3, Singularity::Positive),
        ("pair", pair(40, 2), 2.0, 0.02, Singularity::Pair { angle }),
        ("even pair", even(&pair(40, 9)), 3.0, 0.02, Singularity::Pair { angle }),
    ];
    for (name, series, radius, error, singularity) in cases {
        let estimate = Convergence::estimate(&series).unwrap();
        assert!((estimate.radius / radius - 1.0).abs() < error, "{name}: {estimate:?}");
        assert!(estimate.at_least <= radius && radius <= estimate.at_most, "{name}: {estimate:?}");
        match (estimate.singularity, singularity) {
            (Singularity::Pair { angle: a }, Singularity::Pair { angle: b }) => {
                assert!((a - b).abs() < 0.02, "{name}: {a}");
            }
            (a, b) => assert_eq!(a, b, "{name}"),
        }
    }
}

#[test]
fn twelve_coefficients_are_enough_for_a_pair_of_singularities() {
    let estimate = Convergence::estimate(&CUBIC_QUINTIC.map(rational)).unwrap();
    assert!(
        estimate.at_least < 1.0 && 1.0 < estimate.at_most && estimate.at_most - estimate.at_least < 0.2,
        "{estimate:?}"
    );
    let Singularity::Pair { angle } = estimate.singularity else { panic!("{estimate:?}") };
    assert!((angle - 2.0 * PI / 3.0).abs() < 0.03, "{angle}");
    let estimate = Convergence::estimate(&even(&VAN_DER_POL.map(rational))).unwrap();
    assert_eq!(estimate.stride, 2);
    assert!(
        estimate.at_least < 1.85 && 1.85 < estimate.at_most && estimate.at_most - estimate.at_least < 0.2,
        "{estimate:?}"
    );
}

#[test]
fn what_coefficients_do_not_tell_is_not_claimed() {
    assert_eq!(Convergence::estimate(&period_in_amplitude(5)), None);
    assert_eq!(Convergence::estimate(&[]), None);
    assert_eq!(Convergence::estimate(&[Rational::from(1), Rational::from(0)]), None);
    // Signs of no pattern: no direction.
    let signs = [1, 1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, -1, -1, 1, -1, 1].map(Rational::from);
    let estimate = Convergence::estimate(&signs).unwrap();
    assert_eq!(estimate.singularity, Singularity::Unclear);
    assert!(estimate.at_least <= 1.0 && estimate.at_most >= 1.0, "{estimate:?}");
    // eˣ converges everywhere: no upper end, or one beyond what its terms have reached.
    let mut term = Rational::from(1);
    let exponential: Vec<Rational> = (1..25)
        .map(|n| {
            term = term.clone() * Rational::new(1, n).unwrap();
            term.clone()
        })
        .collect();
    let estimate = Convergence::estimate(&exponential).unwrap();
    assert_eq!(estimate.at_most, f64::INFINITY, "{estimate:?}");
    assert!(estimate.at_least > 10.0, "{estimate:?}");
}

fn fractions(text: &str) -> Vec<Rational> {
    text.split(' ').map(rational).collect()
}

#[test]
fn pade_approximants_are_those_of_elimination() {
    let series = period_in_amplitude(24);
    for row in Table::read("series_pade.csv").rows() {
        let (m, n) = (row.text("m").parse().unwrap(), row.text("n").parse().unwrap());
        let pade = Pade::new(&series, m, n).unwrap();
        assert_eq!(pade.numerator(), fractions(row.text("numerator")), "[{m}/{n}]");
        assert_eq!(pade.denominator(), fractions(row.text("denominator")), "[{m}/{n}]");
        let parts = |name: &str| -> Vec<f64> {
            row.text(name).split(' ').map(|number| number.parse().unwrap()).collect()
        };
        let golden =
            parts("poles_re").into_iter().zip(parts("poles_im")).map(|(re, im)| Complex::new(re, im));
        let poles = pade.poles();
        assert_eq!(poles.len(), n);
        for pole in golden {
            let nearest =
                poles.iter().map(|estimate| (estimate.position - pole).abs()).fold(f64::MAX, f64::min);
            // The tenth pole of ten is the worst conditioned one.
            assert!(nearest < 1e-6 * pole.abs(), "[{m}/{n}] {pole:?} {nearest:e}");
        }
    }
}

#[test]
fn pade_approximants_outdo_the_series_they_are_made_from() {
    let series = period_in_amplitude(10);
    let error = |amplitude: f64, m, n| {
        let pade = Pade::new(&series, m, n).unwrap();
        (pade.value_at(amplitude * amplitude) / exact(amplitude) - 1.0).abs()
    };
    let (right_angle, steep) = (90_f64.to_radians(), 150_f64.to_radians());
    assert!((error(right_angle, 1, 1) / 6.3e-4 - 1.0).abs() < 0.02);
    assert!((error(right_angle, 4, 4) / 1.7e-10 - 1.0).abs() < 0.05);
    assert!((error(steep, 5, 5) / 2e-6 - 1.0).abs() < 0.3);
    let sum = SeriesEvaluation::new(&even(&series), steep).value();
    assert!(error(steep, 5, 5) < 2e-3 * (sum / exact(steep) - 1.0).abs());
}

/// The poles of diagonal approximants line up beyond the top, at θ0² > π²; some others have one on the imaginary axis.
#[test]
fn spurious_poles_are_recognised() {
    let series = period_in_amplitude(12);
    let poles = |m, n| Pade::new(&series, m, n).unwrap().poles();
    for n in [1, 2, 4, 5] {
        for pole in poles(n, n) {
            assert!(!pole.spurious && pole.position.re > PI * PI, "[{n}/{n}] {pole:?}");
            assert!(pole.position.im.abs() < 1e-9, "[{n}/{n}] {pole:?}");
        }
        assert!(poles(n, n)[0].residue.re < 0.0);
    }
    for (m, n) in [(1, 2), (3, 3)] {
        let (spurious, others): (Vec<_>, Vec<_>) = poles(m, n).into_iter().partition(|pole| pole.spurious);
        assert_eq!(spurious.len(), 1, "[{m}/{n}]");
        assert!(spurious[0].position.re < 0.0);
        assert!(others.iter().all(|pole| pole.position.re > PI * PI));
    }
}

#[test]
fn quotients_of_polynomials_are_their_own_approximants() {
    // (1 + z)/(1 − z/2) = 1 + 3z/2·(1 + z/2 + z²/4 + …).
    let series: Vec<Rational> = ["1", "3/2", "3/4", "3/8", "3/16", "3/32"].map(rational).into();
    for (m, n) in [(1, 1), (2, 1), (1, 2), (2, 2), (2, 3)] {
        let pade = Pade::new(&series, m, n).unwrap();
        assert_eq!(pade.numerator(), ["1", "1"].map(rational));
        assert_eq!(pade.denominator(), ["1", "-1/2"].map(rational));
    }
    assert_eq!(Pade::new(&series, 1, 1).unwrap().value_at(1.0), 4.0);
    assert!(!Pade::new(&series, 1, 1).unwrap().value_at(2.0).is_finite());
}

#[test]
fn approximants_that_do_not_exist_are_refused() {
    // 1 + z² has no [1/1]: no (a + bz)/(1 + cz) begins with 1 + 0z + z².
    let series = ["1", "0", "1"].map(rational);
    assert_eq!(Pade::new(&series, 1, 1), None);
    assert_eq!(Pade::new(&series, 2, 1), None);
    assert_eq!(Pade::new(&series, usize::MAX, 1), None);
    assert_eq!(Pade::new(&[], 0, 0), None);
    let zero = Pade::new(&[Rational::from(0), Rational::from(0)], 0, 1).unwrap();
    assert_eq!((zero.value_at(3.0), zero.poles().len()), (0.0, 0));
}

#[test]
fn the_smallest_term_is_where_a_diverging_series_helps_no_more() {
    // Σ n!·xⁿ: the term n is n·x times the one before.
    let factorials: Vec<Rational> = (1..30)
        .scan(Rational::from(1), |product, n| {
            let term = product.clone();
            *product = product.clone() * Rational::from(n);
            Some(term)
        })
        .collect();
    let diverging = SeriesEvaluation::new(&factorials, 0.095);
    assert_eq!(diverging.smallest_term().map(|step| step.power), Some(10));
    assert!(period(20, 1.0).smallest_term().is_none());
}

#[test]
fn an_approximant_has_its_first_pole_in_the_amplitude() {
    let pendulum = NamedOscillator::by_key("pendulum").unwrap().oscillator(&[]).unwrap();
    let expansion = expand(&pendulum, 7, &Gauge::Fundamental, &Quiet).unwrap();
    let approximant =
        SeriesComparison::new(&pendulum, &expansion, SeriesQuantity::Period).approximant(1).unwrap();
    // 1 + z/16 + 11z²/3072 + …: [1/1] has its pole at z = A² = (1/16)/(11/3072) = 192/11.
    let pole = approximant.first_pole().unwrap();
    assert!((pole - (192.0_f64 / 11.0).sqrt()).abs() < 1e-14, "{pole}");
    let amplitude =
        SeriesComparison::new(&pendulum, &expansion, SeriesQuantity::Cosine(3)).approximant(0).unwrap();
    assert_eq!(amplitude.first_pole(), None);
}
