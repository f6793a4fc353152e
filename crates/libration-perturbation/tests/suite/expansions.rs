//! Perturbation expansions compared with FLINT's tables, closed forms, and each other in different gauges.

use crate::typed::oscillator;
use libration::algebra::Rational;
use libration::oscillator::{NamedOscillator, Oscillator};
use libration::period_formulas::period_in_amplitude;
use libration::perturbation::{Certificate, Expansion, ExpansionError, Gauge, Precision, expand};
use libration::progress::{Quiet, Stage, Status};
use libration_testing::golden::Table;
use libration_testing::random::Random;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::ControlFlow;

type Series = Vec<Rational>;

fn rational(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator, denominator).unwrap()
}

fn integer(n: usize) -> Rational {
    Rational::from(i64::try_from(n).unwrap())
}

fn product(a: &[Rational], b: &[Rational]) -> Series {
    let length = a.len().min(b.len());
    let term = |n: usize| (0..=n).map(move |i| a[i].clone() * b[n - i].clone());
    (0..length).map(|n| term(n).fold(Rational::from(0), |sum, x| sum + x)).collect()
}

fn reciprocal(a: &[Rational]) -> Series {
    let mut b: Series = vec![Rational::from(1).checked_div(&a[0]).unwrap()];
    for n in 1..a.len() {
        let terms = (1..=n).fold(Rational::from(0), |sum, i| sum + a[i].clone() * b[n - i].clone());
        b.push(-terms.checked_div(&a[0]).unwrap());
    }
    b
}

fn constant(value: i64, length: usize) -> Series {
    let mut series = vec![Rational::from(0); length];
    series[0] = Rational::from(value);
    series
}

fn sum(a: &[Rational], b: &[Rational]) -> Series {
    a.iter().zip(b).map(|(a, b)| a.clone() + b.clone()).collect()
}

fn scaled(a: &[Rational], factor: &Rational) -> Series {
    a.iter().map(|a| a.clone() * factor.clone()).collect()
}

/// Σ cₙaⁿ for a series without constant term.
fn composed(outer: &[Rational], a: &[Rational]) -> Series {
    let zero = constant(0, a.len());
    outer.iter().rev().fold(zero, |sum, c| {
        let mut next = product(&sum, a);
        next[0] = next[0].clone() + c.clone();
        next
    })
}

fn pendulum() -> Oscillator {
    oscillator("x'' + sin(x) = 0")
}

/// The series of the tables by their names.
fn series_of(expansion: &Expansion, name: &str) -> Series {
    match name {
        "frequency_ratio" => expansion.frequency_ratio.clone(),
        "period_ratio" => reciprocal(&expansion.frequency_ratio),
        "x_max" => expansion.x_max.clone(),
        "x_min" => expansion.x_min.clone(),
        _ => {
            let k = name[3..].parse().unwrap();
            let nothing = vec![Rational::from(0); expansion.order + 1];
            let harmonic = expansion.harmonic(k);
            let part = harmonic.map(|h| if name.starts_with("cos") { &h.cos } else { &h.sin });
            part.cloned().unwrap_or(nothing)
        }
    }
}

/// Compares every series of a table; where one ends, zeros follow up to the highest power of its gauge.
fn compare(table: &str, expansion_of: impl Fn(&str, &str, usize) -> Expansion) {
    let table = Table::read(table);
    let mut groups: BTreeMap<(String, String), BTreeMap<String, BTreeMap<usize, Rational>>> = BTreeMap::new();
    for row in table.rows() {
        let group = (row.text("oscillator").to_owned(), row.text("gauge").to_owned());
        let series = groups.entry(group).or_default().entry(row.text("series").to_owned()).or_default();
        series.insert(row.text("power").parse().unwrap(), row.text("coefficient").parse().unwrap());
    }
    assert!(!groups.is_empty());
    for ((force, gauge), series) in groups {
        let highest = series.values().filter_map(|list| list.keys().last()).max().unwrap();
        let expansion = expansion_of(&force, &gauge, highest + 1);
        assert_eq!(expansion.precision, Precision::Exact);
        for (name, truth) in series {
            let computed = series_of(&expansion, &name);
            let last = *truth.keys().last().unwrap();
            for (power, value) in computed.iter().take(last + 1).enumerate() {
                let expected = truth.get(&power).cloned().unwrap_or_else(|| Rational::from(0));
                assert_eq!(*value, expected, "{force}, {gauge}: {name}, power {power}");
            }
        }
    }
}

fn centre(force: &str, gauge: &str, order: usize) -> Expansion {
    let gauge: Gauge = gauge.replace(' ', ",").parse().unwrap();
    expand(&oscillator(&format!("x'' + {force} = 0")), order, &gauge, &Quiet).unwrap()
}

#[test]
fn the_pendulum_agrees_with_flint_in_every_gauge() {
    compare("expansions_pendulum.csv", centre);
}

#[test]
fn conservative_oscillators_agree_with_flint_in_every_gauge() {
    compare("expansions_oscillators.csv", centre);
}

#[test]
fn limit_cycles_agree_with_flint() {
    compare("expansions_limit_cycles.csv", |key, _, order| {
        let oscillator = NamedOscillator::by_key(key).unwrap().oscillator(&[]).unwrap();
        expand(&oscillator, order, &Gauge::Fundamental, &Quiet).unwrap()
    });
}

#[test]
fn physical_relations_are_the_same_in_every_gauge() {
    let mut random = Random::seeded(20);
    for equation in ["x'' + sin(x) = 0", "x'' + x + x^2 = 0", "x'' = -x*(1-x'^2)^(3/2)", "x'' = -2*x - x^3"] {
        let oscillator = oscillator(equation);
        let natural = expand(&oscillator, 9, &Gauge::Fundamental, &Quiet).unwrap();
        let mut gauges = vec![Gauge::XMax, Gauge::HalfSwing];
        for _ in 0..4 {
            let mut number = || {
                let n = i64::try_from(random.below(19)).unwrap() - 9;
                rational(n, i64::try_from(random.below(7)).unwrap() + 1)
            };
            // Even coefficients, which break the symmetry, included.
            let mut list: Vec<Rational> = (0..9).map(|_| number()).collect();
            list[0] = rational(i64::try_from(random.below(5)).unwrap() + 1, 3);
            gauges.push(Gauge::Coefficients(list));
        }
        for gauge in gauges {
            let other = expand(&oscillator, 9, &gauge, &Quiet).unwrap();
            let (a, b) = (natural.of_amplitude.clone().unwrap(), other.of_amplitude.unwrap());
            assert_eq!(a.frequency_ratio, b.frequency_ratio, "{equation}, {gauge}");
            assert_eq!(a.period_ratio, b.period_ratio, "{equation}, {gauge}");
            assert_eq!(a.harmonics, b.harmonics, "{equation}, {gauge}");
            assert_eq!(
                natural.of_half_swing.as_ref().map(|of| &of.harmonics),
                other.of_half_swing.as_ref().map(|of| &of.harmonics)
            );
        }
    }
}

/// xⁿ·Tₙ(4/x), a polynomial in x, by Tₙ₊₁(y) = 2yTₙ(y) − Tₙ₋₁(y).
fn chebyshev_in_reciprocal(n: usize, length: usize) -> Series {
    let mut variable_squared = constant(0, length);
    variable_squared[2] = Rational::from(1);
    let (mut before, mut now) = (constant(1, length), constant(4, length));
    if n == 0 {
        return before;
    }
    for _ in 1..n {
        let next = sum(
            &scaled(&now, &Rational::from(8)),
            &scaled(&product(&variable_squared, &before), &Rational::from(-1)),
        );
        (before, now) = (now, next);
    }
    now
}

fn power(n: usize, length: usize) -> Series {
    let mut series = vec![Rational::from(0); length];
    if n < length {
        series[n] = Rational::from(1);
    }
    series
}

/// a₂ₙ₊₁ = (−1)ⁿ·4/((2n+1)·T₂ₙ₊₁(4/ε)) and T/T0 = 1 + 2Σ 1/T₂ₙ(4/ε) with ε = a₁.
#[test]
fn the_pendulum_in_its_fundamental_is_a_quotient_of_chebyshev_polynomials() {
    let order = 41;
    let expansion = expand(&pendulum(), order, &Gauge::Fundamental, &Quiet).unwrap();
    for n in (1..=order).step_by(2) {
        let inverse = reciprocal(&chebyshev_in_reciprocal(n, order + 1));
        let sign = if n % 4 == 1 { 4 } else { -4 };
        let factor = Rational::from(sign).checked_div(&integer(n)).unwrap();
        let closed = scaled(&product(&power(n, order + 1), &inverse), &factor);
        assert_eq!(expansion.harmonic(n).unwrap().cos, closed, "a{n}");
    }
    let period = (2..order).step_by(2).fold(constant(1, order), |period, n| {
        let inverse = reciprocal(&chebyshev_in_reciprocal(n, order));
        sum(&period, &scaled(&product(&power(n, order), &inverse), &Rational::from(2)))
    });
    assert_eq!(reciprocal(&expansion.frequency_ratio), period);
}

/// T/T0 = P₋½(cos θ0) and its series by the Euler numbers.
#[test]
fn the_period_obeys_legendre_and_euler() {
    let order = 61;
    let of = expand(&pendulum(), order, &Gauge::Fundamental, &Quiet).unwrap().of_amplitude.unwrap();
    let euler: Series = period_in_amplitude(order / 2);
    assert_eq!(of.period_ratio.iter().step_by(2).cloned().collect::<Vec<_>>(), euler);
    // sin θ R″ + cos θ R′ − ¼ sin θ R = 0.
    let derivative = |a: &[Rational]| -> Series {
        a.iter().enumerate().skip(1).map(|(n, a)| a.clone() * integer(n)).collect()
    };
    let mut sine = constant(0, order);
    let mut term = Rational::from(1);
    for n in (1..order).step_by(2) {
        sine[n] = term.clone();
        term = -term.checked_div(&integer((n + 1) * (n + 2))).unwrap();
    }
    let (first, second) = (derivative(&of.period_ratio), derivative(&derivative(&of.period_ratio)));
    let left = sum(&product(&sine, &second), &product(&derivative(&sine), &first));
    let right = scaled(&product(&sine, &of.period_ratio), &rational(1, 4));
    assert!(left.iter().zip(&right).all(|(a, b)| a == b));
    // Every coefficient is positive, and below the bound that is sharp at the second.
    let pi_squared = core::f64::consts::PI * core::f64::consts::PI;
    let (mut power, mut n) = (1.0, 0.0);
    for t in euler.iter().skip(1) {
        (power, n) = (power * pi_squared, n + 1.0);
        let scaled = t.to_f64() * power;
        assert!(scaled > 0.0 && scaled <= 11.0 * pi_squared * pi_squared / 1536.0 / n * (1.0 + 1e-12), "{n}");
    }
}

/// Σ over all integers n of signⁿ·q^{n²·scale} with q = (ε/8)².
fn theta(sign: i64, scale: usize, length: usize) -> Series {
    let mut series = constant(1, length);
    for n in 1_usize.. {
        let exponent = 2 * n * n * scale;
        if exponent >= length {
            return series;
        }
        let denominator = (0..exponent).fold(Rational::from(1), |power, _| power * rational(1, 8));
        series[exponent] = denominator * Rational::from(if n % 2 == 1 { 2 * sign } else { 2 });
    }
    series
}

/// In ε = 8√q: Ω/ω0 = θ₃(q)⁻², cos(θ0/2) = θ₄(q)²/θ₃(q)², and the steps of the arithmetic–geometric mean of 1 and
/// cos(θ0/2) miss the period by θ₃(q²)⁻² and θ₄(q²)⁻².
#[test]
fn the_pendulum_in_its_nome_has_theta_functions() {
    let order = 41;
    let expansion = expand(&pendulum(), order, &Gauge::Nome, &Quiet).unwrap();
    let square = |a: Series| product(&a, &a);
    let (theta3, theta4) = (square(theta(1, 1, order)), square(theta(-1, 1, order)));
    assert_eq!(expansion.frequency_ratio, reciprocal(&theta3));
    let mut cosine = constant(0, order);
    let mut term = Rational::from(1);
    for n in (0..order).step_by(2) {
        cosine[n] = term.clone();
        term = -term.checked_div(&integer((n + 1) * (n + 2))).unwrap();
    }
    let half: Series = scaled(&expansion.x_max[..order], &rational(1, 2));
    let complement = composed(&cosine, &half);
    assert_eq!(product(&complement, &theta3), theta4);
    // 1/a₁ = 2/(1 + k′) and 1/b₁ = 1/√k′, each times Ω/ω0.
    let arithmetic = scaled(&reciprocal(&sum(&constant(1, order), &complement)), &Rational::from(2));
    let missed = product(&arithmetic, &expansion.frequency_ratio);
    assert_eq!(missed, reciprocal(&square(theta(1, 2, order))));
    let geometric_squared = product(&reciprocal(&complement), &square(expansion.frequency_ratio.clone()));
    assert_eq!(geometric_squared, reciprocal(&square(square(theta(-1, 2, order)))));
}

#[test]
fn certificates_say_what_was_checked() {
    let certificate = |equation: &str, order| {
        expand(&oscillator(equation), order, &Gauge::Fundamental, &Quiet).unwrap().certificate
    };
    assert_eq!(certificate("x'' + sin(x) = 0", 9), Certificate::PlainRationals);
    assert_eq!(certificate("x'' + sin(x) = 0", 31), Certificate::Potential);
    assert_eq!(certificate("x'' + x + x^2 = 0", 21), Certificate::Potential);
    assert_eq!(certificate("x'' = -x*(1-x'^2)^(3/2)", 21), Certificate::FirstIntegral);
    assert_eq!(certificate("x'' = -x + mu*(1-x^2)*x'", 20), Certificate::FreshPrimes);
    assert_eq!(certificate("x'' = -sin(x) + 0.2", 5), Certificate::TwoPrecisions);
}

/// Van der Pol's cycle with another frequency, stiffness and amplitude is the same in other units.
#[test]
fn a_limit_cycle_keeps_its_series_in_other_units() {
    let series = |equation: &str| expand(&oscillator(equation), 6, &Gauge::Fundamental, &Quiet).unwrap();
    let plain = series("x'' - mu*(1-x^2)*x' + x = 0");
    // x = 3y.
    let tripled = series("x'' - mu*(1-x^2/9)*x' + x = 0");
    assert_eq!(plain.frequency_ratio, tripled.frequency_ratio);
    assert_eq!(scaled(&plain.harmonics[0].cos, &Rational::from(3)), tripled.harmonics[0].cos);
    // Rayleigh's amplitude 2/√3: given in units of a root.
    let rayleigh = series("x'' - mu*(1-x'^2)*x' + x = 0");
    assert_eq!(rayleigh.frequency_ratio, plain.frequency_ratio);
    assert_eq!(rayleigh.unit_squared, rational(4, 3));
    // With ω0 = 2 and time halved, μ is halved too.
    let faster = series("x'' - 2*mu*(1-x^2)*x' + 4*x = 0");
    assert_eq!(faster.frequency_ratio, plain.frequency_ratio);
    // A frequency that is not a fraction is given in digits.
    let irrational = series("x'' - mu*(1-x^2)*x' + 2*x = 0");
    assert!(matches!(irrational.precision, Precision::Digits(_)));
    assert!((irrational.frequency_ratio[2].to_f64() + 1.0 / 32.0).abs() < 1e-30);
}

#[test]
fn coefficients_in_digits_agree_with_exact_ones() {
    // About asin(3/5) the coefficients are fractions although sin and cos are not evaluated at zero; the equilibrium
    // is irrational, so that the engine uses floats.
    let in_digits = expand(&oscillator("x'' = -sin(x) + 3/5"), 5, &Gauge::Fundamental, &Quiet).unwrap();
    assert!(matches!(in_digits.precision, Precision::Digits(_)));
    // x = xₑ + u: u″ = −(4/5)·sin u − (3/5)·(cos u − 1).
    let exact =
        expand(&oscillator("u'' = -4/5*sin(u) - 3/5*(cos(u) - 1)"), 5, &Gauge::Fundamental, &Quiet).unwrap();
    assert_eq!(exact.precision, Precision::Exact);
    let pairs = in_digits.frequency_ratio.iter().zip(&exact.frequency_ratio);
    let harmonics = in_digits.harmonics.iter().zip(&exact.harmonics);
    for (a, b) in pairs.chain(harmonics.flat_map(|(a, b)| a.cos.iter().zip(&b.cos))) {
        assert!((a.clone() - b.clone()).to_f64().abs() < 1e-39, "{a} {b}");
    }
}

#[test]
fn questions_without_an_answer_are_refused() {
    let ask = |equation: &str, gauge: Gauge| {
        expand(&oscillator(equation), 5, &gauge, &Quiet).unwrap_err().to_string()
    };
    assert!(ask("x'' = -x*(1-x'^2)^(3/2)", Gauge::Energy).contains("velocity"));
    assert!(ask("x'' = -x - x^3", Gauge::Nome).contains("pendulum"));
    assert!(ask("x'' = -x + mu*(1-x^2)*x'", Gauge::XMax).contains("limit cycle"));
    assert!(ask("x'' = -x - mu*(1-x^2)*x'", Gauge::Fundamental).contains("unstable"));
    assert!(ask("x'' = -x + mu*x'*cos(x)", Gauge::Fundamental).contains("polynomial"));
    assert!(expand(&pendulum(), 0, &Gauge::Fundamental, &Quiet).is_err());
}

/// The largest displacement of Van der Pol's oscillator is 2 + μ²/96 − …, not that at Ωt = 0. At μ = 0.1 numerical
/// integration (SciPy, tolerance 1e-12) gives 2.000103979861, and, with an even term, for which the two turning points
/// differ, 2.000141936865 and −2.007250105633.
#[test]
fn a_limit_cycle_turns_where_its_velocity_vanishes() {
    let cycle =
        |equation: &str, order| expand(&oscillator(equation), order, &Gauge::Fundamental, &Quiet).unwrap();
    let van_der_pol = cycle("x'' = -x + mu*(1-x^2)*x'", 4);
    assert_eq!(van_der_pol.x_max[..4], ["2", "0", "1/96", "0"].map(|text| text.parse().unwrap()));
    assert!(van_der_pol.x_max.iter().zip(&van_der_pol.x_min).all(|(max, min)| *max == -min.clone()));
    let uneven = cycle("x'' = -x + mu*(1-x^2-x)*x'", 10);
    let at = |series: &Series| series.iter().rev().fold(0.0, |sum, c| sum * 0.1 + c.to_f64());
    assert!((at(&van_der_pol.x_max) - 2.000_103_979_861).abs() < 1e-8, "{}", at(&van_der_pol.x_max));
    assert!((at(&uneven.x_max) - 2.000_141_936_865).abs() < 1e-9, "{}", at(&uneven.x_max));
    assert!((at(&uneven.x_min) + 2.007_250_105_633).abs() < 1e-9, "{}", at(&uneven.x_min));
}

/// The first-order condition is 18 − 38s + 13s² − s³ = −(s − 9)·(s² − 4s + 2): the squares 2 − √2 and 9 attract.
#[test]
fn the_smallest_attracting_limit_cycle_is_taken_rational_or_not() {
    let equation = "x'' = -x + mu*(18 - 152*x^2 + 104*x^4 - 64/5*x^6)*x'";
    let expansion = expand(&oscillator(equation), 1, &Gauge::Fundamental, &Quiet).unwrap();
    assert_eq!(expansion.precision, Precision::Digits(40));
    let beside =
        expand(&oscillator("x'' = -(x - 1/2) + mu*(1-x^2)*x'"), 1, &Gauge::Fundamental, &Quiet).unwrap();
    assert_eq!((beside.precision, beside.equilibrium), (Precision::Digits(40), rational(1, 2)));
    let square = expansion.x_max[0].to_f64() * expansion.x_max[0].to_f64();
    assert!((square - 0.585_786_437_626_905).abs() < 1e-14, "{square}");
    let repelling = expand(&oscillator("x'' = -x + mu*(x^2-sqrt(2))*x'"), 2, &Gauge::Fundamental, &Quiet);
    assert!(repelling.unwrap_err().to_string().contains("no stable limit cycle"));
}

/// With an irrational ω0² nothing is exact, but the series are the pendulum's, down to its highest harmonics.
#[test]
fn digits_hold_for_small_coefficients_too() {
    let order = 61;
    let exact = expand(&pendulum(), order, &Gauge::Fundamental, &Quiet).unwrap();
    let digits = expand(&oscillator("x'' = -sqrt(2)*sin(x)"), order, &Gauge::Fundamental, &Quiet).unwrap();
    assert_eq!(digits.precision, Precision::Digits(40));
    for (exact, digits) in exact.harmonics.iter().zip(&digits.harmonics) {
        assert_eq!(exact.k, digits.k);
        for (exact, digits) in exact.cos.iter().zip(&digits.cos) {
            assert_eq!(exact.to_decimal(40), digits.to_decimal(40));
        }
    }
    assert_eq!(exact.harmonics.len(), digits.harmonics.len());
}

/// The expansion that is certain when the watch stops it at the first progress of this kind.
fn certain_at(
    oscillator: &Oscillator,
    order: usize,
    gauge: &Gauge,
    end: impl Fn(Status) -> bool,
) -> Option<Expansion> {
    let ask = |progress| if end(progress) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    match expand(oscillator, order, gauge, &ask) {
        Err(ExpansionError::Interrupted { known: partial }) => partial.map(|partial| *partial),
        other => panic!("not interrupted: {other:?}"),
    }
}

#[test]
fn an_interrupted_expansion_gives_the_orders_that_are_certain() {
    let cases = [
        ("x'' = -sin(x)", Gauge::Fundamental, 101),
        ("x'' = -sin(x)", Gauge::Nome, 101),
        ("x'' = -x - x^2", Gauge::HalfSwing, 40),
        ("x'' = -x - x^3/3", Gauge::Energy, 71),
        ("x'' = mu*(1 - x^2)*x' - x", Gauge::Fundamental, 24),
    ];
    for (equation, gauge, order) in cases {
        let oscillator = oscillator(equation);
        let mut before = 0;
        for primes in [4, 7] {
            let at = |progress: Status| {
                matches!(progress.stage, Stage::Prime { done } if done >= primes) && progress.done > order / 2
            };
            let partial = certain_at(&oscillator, order, &gauge, at).unwrap();
            let direct = expand(&oscillator, partial.order, &gauge, &Quiet).unwrap();
            assert_eq!(partial.certificate, Certificate::FreshPrimes);
            assert_eq!(
                Expansion { certificate: direct.certificate, ..partial.clone() },
                direct,
                "{equation}"
            );
            assert!(
                before <= partial.order && 0 < partial.order && partial.order < order,
                "{equation}: {}",
                partial.order
            );
            before = partial.order;
        }
        assert_eq!(certain_at(&oscillator, order, &gauge, |_| true), None, "{equation}");
    }
}

#[test]
fn an_interrupted_check_leaves_the_answer_unchecked() {
    for order in [9, 31] {
        let pendulum = oscillator("x'' = -sin(x)");
        let checked = expand(&pendulum, order, &Gauge::Fundamental, &Quiet).unwrap();
        let partial =
            certain_at(&pendulum, order, &Gauge::Fundamental, |status| status.stage == Stage::Check).unwrap();
        assert!(checked.certificate.is_proof() && partial.certificate == Certificate::FreshPrimes);
        assert_eq!(Expansion { certificate: checked.certificate, ..partial }, checked);
    }
}

#[test]
fn digits_are_certain_to_the_order_that_two_precisions_have() {
    for (equation, order) in [("x'' = -x - sqrt(2)*x^2", 12), ("x'' = mu*(1 - sqrt(2)*x^2)*x' - x", 7)] {
        let oscillator = oscillator(equation);
        let precisions = RefCell::new(vec![]);
        let ask = |Status { stage, .. }| {
            if !precisions.borrow().contains(&stage) {
                precisions.borrow_mut().push(stage);
            }
            ControlFlow::Continue(())
        };
        expand(&oscillator, order, &Gauge::Fundamental, &ask).unwrap();
        let precisions = precisions.into_inner();
        assert_eq!(precisions.len(), 2, "{precisions:?}");
        let during = |stage: Stage| {
            let at = |progress: Status| progress.stage == stage && progress.done == order - 2;
            certain_at(&oscillator, order, &Gauge::Fundamental, at)
        };
        assert_eq!(during(precisions[0]), None);
        let partial = during(precisions[1]).unwrap();
        assert_eq!(partial.order, order - 3, "{equation}");
        let direct = expand(&oscillator, partial.order, &Gauge::Fundamental, &Quiet).unwrap();
        assert_eq!(partial.frequency_ratio, direct.frequency_ratio, "{equation}");
        assert_eq!(partial.harmonics, direct.harmonics, "{equation}");
    }
}

#[test]
fn a_series_is_in_the_strength_for_limit_cycles_only() {
    let named = |key: &str| NamedOscillator::by_key(key).unwrap().oscillator(&[]).unwrap();
    let in_strength =
        |key: &str| expand(&named(key), 3, &Gauge::Fundamental, &Quiet).unwrap().variable.is_strength();
    assert!(in_strength("van_der_pol") && in_strength("rayleigh"));
    assert!(!in_strength("pendulum") && !in_strength("quadratic"));
}

/// A force with sign(x′) has no Taylor series in the velocity, though its derivative by it is zero on either side. x·sign(x′) changes the
/// stiffness between half swings: ω = √1.1 and √0.9, so that the frequency is not one.
#[test]
fn forces_with_the_sign_of_the_velocity_are_not_expanded() {
    use libration::oscillator::{NumbersOrLetters, Oscillator};
    use libration::perturbation::expand_symbolically;
    for text in
        ["x'' + x + 0.1*x*sign(x') = 0", "x'' + x + 0.1*x*sign(x')^2 = 0", "x'' + x + 0.1*sign(x') = 0"]
    {
        let oscillator = Oscillator::new(&text.parse().unwrap());
        let refused =
            oscillator.is_err() || expand(&oscillator.unwrap(), 4, &Gauge::Fundamental, &Quiet).is_err();
        assert!(refused, "{text}");
    }
    for text in [
        "x'' + w^2*x + c*x*sign(x') = 0",
        "x'' + x + a*x^3 + c*sign(x') = 0",
        "x'' + w^2*x + c*sign(x')*x^2 = 0",
        "x'' + x + a*x^3 + c*sign(sin(x')) = 0",
        "x'' + w^2*x + c*x*sign(x')^2 = 0",
        "x'' + w^2*x + c*x*abs(x') = 0",
    ] {
        let refused = match NumbersOrLetters::new(&text.parse().unwrap(), None) {
            Ok(NumbersOrLetters::Letters(letters)) => {
                expand_symbolically(&letters, 4, &Gauge::Fundamental, &Quiet).is_err()
            }
            refusal => refusal.is_err(),
        };
        assert!(refused, "{text}");
    }
}
