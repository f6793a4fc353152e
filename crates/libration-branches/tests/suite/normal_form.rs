//! Normal forms compared with Lindstedt's series, the exact pendulum, the shifts of normal modes, and exchanges of energy by other programs.

use libration::expression::Equation;
use libration::normal_form::{DETUNING, ExchangeError, NormalForm, NormalFormError};
use libration::normal_modes::NormalModes;
use libration::pendulum::Pendulum;
use libration::progress::Quiet;
use libration::quantity::Angle;

/// κ = 3 and l = g = 1: equilibrium at 4/3, frequencies √3 and √3/2.
const SPRING_PENDULUM: &str =
    "r'' = r*theta'^2 + cos(theta) - 3*(r - 1); theta'' = -(2*r'*theta' + sin(theta))/r";

const DOUBLE_PENDULUM: &str = "theta1'' = (-3*sin(theta1) - sin(theta1 - 2*theta2) - 2*sin(theta1 - theta2)*(theta2'^2 + theta1'^2*cos(theta1 - theta2)))/(3 - cos(2*theta1 - 2*theta2));
    theta2'' = 2*sin(theta1 - theta2)*(2*theta1'^2 + 2*cos(theta1) + theta2'^2*cos(theta1 - theta2))/(3 - cos(2*theta1 - 2*theta2))";

fn form(text: &str, rest: &[f64], order: usize) -> NormalForm {
    NormalForm::about(&text.parse().unwrap(), rest, order, DETUNING, &Quiet).unwrap()
}

/// Ω of a release from rest, by its amplitude in the normal form.
fn frequency(form: &NormalForm, angle: f64) -> f64 {
    let amplitude = form.amplitudes_of(&[angle, 0.0]).unwrap()[0];
    assert!(amplitude.im.abs() < 1e-15, "by symmetry real");
    form.rates(&[amplitude])[0].im / amplitude.re
}

#[test]
fn one_coordinate_gives_lindstedts_series_back() {
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    let exact = |angle| pendulum.released_from(Angle::from_radians(angle).unwrap()).unwrap().frequency();
    for (order, next) in [(3, 4.0), (5, 6.0), (7, 8.0), (9, 10.0)] {
        let form = form("x'' = -sin(x)", &[0.0], order);
        assert!(form.slow_terms.iter().all(|term| term.is_of_every_system() && term.exact.is_some()));
        let left = |angle| (frequency(&form, angle) - exact(angle)).abs();
        // The error is of order `order` + 1 in the amplitude.
        let gained = left(0.8) / left(0.4);
        let expected = libm::exp2(next);
        assert!(gained > 0.7 * expected, "{order}: {gained}");
    }
    let off = frequency(&form("x'' = -sin(x)", &[0.0], 9), 0.3) - exact(0.3);
    assert!(off.abs() < 1e-10, "{off:e}");
}

#[test]
fn an_uneven_force_gives_lindstedts_series_back() {
    // x″ + x + x² = 0: Ω = 1 − 5/12·a² of the first harmonic.
    let form = form("x'' = -x - x^2", &[0.0], 3);
    assert_eq!(form.slow_terms.len(), 1);
    assert_eq!(form.slow_terms[0].exact.as_deref(), Some("-5/12*i"));
}

#[test]
fn modes_without_resonance_have_the_shifts_of_lindstedts_expansion() {
    let equation: Equation = DOUBLE_PENDULUM.parse().unwrap();
    let form = form(DOUBLE_PENDULUM, &[0.0, 0.0], 3);
    let modes = NormalModes::new(&equation).unwrap().modes;
    for (number, mode) in modes.iter().enumerate() {
        let shift =
            |term: &&libration::normal_form::SlowTerm| term.mode == number && term.powers[number] == 2;
        let term = form.slow_terms.iter().find(shift).unwrap();
        let expected = mode.shift.as_ref().unwrap().coefficient;
        assert!((term.coefficient.im / expected - 1.0).abs() < 1e-12 && term.exact.is_some(), "{term:?}");
        assert!(term.coefficient.re == 0.0);
    }
    assert!(form.small_divisors[0].divisor.abs() > DETUNING * modes[0].frequency());
}

#[test]
fn the_resonance_of_the_spring_pendulum_is_kept_with_its_coefficients() {
    let form = form(SPRING_PENDULUM, &[4.0 / 3.0, 0.0], 2);
    // With k = 3ω/4r0 in displacements: r″ ∋ ..., a′ = (ik/4)·(r0·b)² and b′ = ikab̄.
    let texts: Vec<_> =
        form.slow_terms.iter().map(|term| (term.mode, term.exact.as_deref().unwrap())).collect();
    assert_eq!(texts, [(0, "9/32*sqrt(3)*i"), (1, "1/8*sqrt(3)*i")]);
    assert!(form.slow_terms.iter().all(|term| term.detuning == 0.0));
    let exchange = form.exchange(&[4.0 / 3.0 + 0.01, 0.01, 0.0, 0.0], &Quiet).unwrap();
    // Jacobi's functions agree with the integrated slow flow, and with multiple scales for first-order amplitudes: 598.954477867174.
    let closed = exchange.closed_form.unwrap();
    assert!((closed / exchange.period - 1.0).abs() < 1e-9, "{exchange:?}");
    assert!((closed / 598.954_477_867_174 - 1.0).abs() < 4e-3, "{exchange:?}");
}

/// The closed form is that of frequencies at 2:1 up to rounding, in slow and in fast units.
#[test]
fn detuning_is_relative_to_the_frequencies() {
    let closed = |square: &str, ratio: &str| {
        let text = format!("x'' = -{square}*(x + x*y); y'' = -{square}*({ratio}*y + x^2/2)");
        let exchange = form(&text, &[0.0, 0.0], 2).exchange(&[0.1, 0.1, 0.0, 0.0], &Quiet).unwrap();
        exchange.closed_form
    };
    assert_eq!(closed("1e-26", "4.1"), None);
    for square in ["1e-26", "1", "1e24*sin(1)"] {
        assert!(closed(square, "4").is_some(), "{square}");
    }
}

/// Return maps of motions in long double, on two sections, to the digits given.
const EXCHANGES: [(f64, f64, f64); 3] = [
    (0.01, 0.01, 597.727_754_675_995_24),
    (0.04, 0.04, 148.545_397_098_687_13),
    (0.16, 0.16, 36.380_808_970_967_56),
];

#[test]
fn the_exchange_is_that_of_return_maps() {
    let equation: Equation = SPRING_PENDULUM.parse().unwrap();
    for (r, theta, expected) in EXCHANGES {
        let state = [4.0 / 3.0 + r, theta, 0.0, 0.0];
        let mut last = f64::INFINITY;
        for order in [3, 5] {
            let form = form(SPRING_PENDULUM, &[4.0 / 3.0, 0.0], order);
            let exchange = form.exchange(&state, &Quiet).unwrap();
            let off = (exchange.period / expected - 1.0).abs();
            assert!(off < 0.2 * last, "{r} {order}: {off:e} after {last:e}");
            last = off;
            if order == 5 {
                let measured = form.measured_exchange(&equation, &state, &exchange, &Quiet).unwrap();
                assert!((measured.period / expected - 1.0).abs() < 1e-12, "{measured:?}");
                assert!(is_near_the_true_one(measured.error, measured.period, expected), "{r}: {measured:?}");
            }
        }
    }
}

/// Returns `true` if a stated error is not below the true one, and at most thirty times as large or within rounding.
fn is_near_the_true_one(stated: f64, period: f64, truth: f64) -> bool {
    const ROUNDING: f64 = 4e-12;
    let off = (period - truth).abs();
    stated >= off && (stated < 30.0 * off || stated < ROUNDING * period)
}

#[test]
fn stated_errors_of_exchanges_are_never_below_and_mostly_near_the_true_ones() {
    let form = form(SPRING_PENDULUM, &[4.0 / 3.0, 0.0], 2);
    for r in [0.01, 0.04, 0.1, -0.05] {
        for theta in [0.01, 0.05, 0.1] {
            let exchange = form.exchange(&[4.0 / 3.0 + r, theta, 0.0, 0.0], &Quiet).unwrap();
            let truth = exchange.closed_form.unwrap();
            assert!(
                is_near_the_true_one(exchange.error, exchange.period, truth),
                "{r} {theta}: {exchange:?}"
            );
        }
    }
}

#[test]
fn states_and_amplitudes_are_each_others_images() {
    let form = form(SPRING_PENDULUM, &[4.0 / 3.0, 0.0], 4);
    assert!(form.amplitudes_of(&[4.0 / 3.0, 0.0, 0.0, 0.0]).unwrap().iter().all(|a| a.abs() == 0.0));
    assert_eq!(form.amplitudes_of(&[40.0, 3.0, 0.0, 0.0]), None);
}

#[test]
fn the_slow_flow_is_also_an_equation() {
    let form = form(SPRING_PENDULUM, &[4.0 / 3.0, 0.0], 3);
    let flow = form.slow_flow();
    assert_eq!(flow.variables(), ["u1", "w1", "u2", "w2"]);
    let amplitudes =
        [libration::algebra::Complex::new(0.1, 0.2), libration::algebra::Complex::new(-0.3, 0.05)];
    let rates = form.rates(&amplitudes);
    let values = [("u1", 0.1), ("w1", 0.2), ("u2", -0.3), ("w2", 0.05)];
    for (formula, expected) in flow.derivatives().iter().zip(rates.iter().flat_map(|rate| [rate.re, rate.im]))
    {
        let put_in = values.iter().fold(formula.clone(), |partial, (name, value)| {
            partial.substitute(
                &libration::expression::Symbol::plain(name),
                &format!("({value:?})").parse().unwrap(),
            )
        });
        assert!((put_in.to_f64().unwrap() - expected).abs() < 1e-15);
    }
}

#[test]
fn what_has_no_normal_form_or_exchange_is_told() {
    let refusal = |text: &str, rest: &[f64], order| {
        NormalForm::about(&text.parse().unwrap(), rest, order, DETUNING, &Quiet).unwrap_err()
    };
    assert!(matches!(refusal("x'' = -x - x'", &[0.0], 3), NormalFormError::NotOscillating(1)));
    assert!(matches!(refusal("x'' = -x", &[0.0], 1), NormalFormError::Order(1)));
    assert!(matches!(refusal("x'' = -x - x*abs(x)", &[0.0], 3), NormalFormError::NoSeries));
    assert!(matches!(refusal("x'' = -x + cos(t)", &[0.0], 3), NormalFormError::NoModes(_)));
    let double = form(DOUBLE_PENDULUM, &[0.0, 0.0], 3);
    assert_eq!(double.exchange(&[0.1, 0.0, 0.0, 0.0], &Quiet), Err(ExchangeError::NoResonance));
}

const HENON_HEILES: &str = "x'' = -x - 2*x*y; y'' = -y - x^2 + y^2";

/// To third order |a1| and |a2| are constant from there; their exchange, 0.006 of them in 2800 s, appears in fifth order.
#[test]
fn an_exchange_is_found_where_the_order_has_it() {
    let state = [0.1, 0.05, 0.0, 0.0];
    let of_order = |order| form(HENON_HEILES, &[0.0, 0.0], order).exchange(&state, &Quiet);
    assert_eq!(of_order(3), Err(ExchangeError::Steady));
    let fifth = of_order(5).unwrap();
    // SciPy's DOP853 at 1e-12 with the fifth-order terms: 2850 s, with |a1| from 0.0972 to 0.1033 and |a2| from 0.0525 to 0.0631.
    assert!((fifth.period / 2850.0 - 1.0).abs() < 0.01 && fifth.error < 1e-3, "{fifth:?}");
    let expected = [[0.0972, 0.1033], [0.0525, 0.0631]];
    for (computed, expected) in fifth.amplitudes.as_flattened().iter().zip(expected.as_flattened()) {
        assert!((computed - expected).abs() < 2e-4, "{fifth:?}");
    }
}

/// About 400 terms in each equation, more than the parser accepts as text.
#[test]
fn a_slow_flow_of_high_order_is_integrated_too() {
    let form = form(HENON_HEILES, &[0.0, 0.0], 7);
    assert!(form.slow_flow().to_string().parse::<Equation>().is_err());
    let exchange = form.exchange(&[0.1, 0.05, 0.0, 0.0], &Quiet).unwrap();
    // The full motion has 2803.77344 s, from zeros of the mean of x′² + x² over many swings (SciPy's DOP853 at 1e-12).
    assert!((exchange.period / 2803.77344 - 1.0).abs() < 0.01, "{exchange:?}");
}
