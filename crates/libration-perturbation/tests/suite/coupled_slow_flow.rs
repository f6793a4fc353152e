//! Slow flows of coupled oscillators compared with averages by quadrature, exact frequencies, and the integrated motion.

use crate::symbolic_slow_flow::value;
use crate::typed::equation;
use libration::expression::Symbol;
use libration::perturbation::{
    CoordinateFlow, CoupledSlowFlow, SymbolicSlowFlowError, SymbolicSlowFlowOptions, coupled_slow_flow,
    slow_flow_symbolically,
};
use libration::progress::Quiet;
use libration::taylor::{Effort, Moment, System, integrate};
use libration_testing::golden::Table;

fn options(ratios: &str, resonance: &str, order: usize) -> SymbolicSlowFlowOptions {
    SymbolicSlowFlowOptions {
        ratios: ratios.split(':').filter(|text| !text.is_empty()).map(|text| text.parse().unwrap()).collect(),
        resonance: resonance.split_once('/').map(|(p, q)| (p.parse().unwrap(), q.parse().unwrap())),
        order: Some(order),
        ..Default::default()
    }
}

fn flow(text: &str, ratios: &str, resonance: &str, order: usize) -> CoupledSlowFlow {
    coupled_slow_flow(&equation(text), &options(ratios, resonance, order), &Quiet)
        .unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn refusal(text: &str, ratios: &str, resonance: &str) -> SymbolicSlowFlowError {
    coupled_slow_flow(&equation(text), &options(ratios, resonance, 1), &Quiet).unwrap_err()
}

fn listed(text: &str) -> Vec<f64> {
    text.split(';').map(|number| number.parse().unwrap()).collect()
}

#[test]
fn rates_of_first_order_are_averages_over_a_period() {
    let table = Table::read("coupled_slow_flow.csv");
    let mut compared = 0;
    for row in table.rows() {
        let text = row.text("equation");
        let flow = flow(text, row.text("ratios"), row.text("resonance"), 1);
        let mut at: Vec<(String, f64)> = vec![("eps".to_owned(), 1.0)];
        at.push(("sigma".to_owned(), row.text("sigma").parse().unwrap()));
        for pair in row.text("values").split(',') {
            let (name, value) = pair.split_once('=').unwrap();
            at.push((name.to_owned(), value.parse().unwrap()));
        }
        let [amplitudes, phases, differences, rates] =
            ["amplitudes", "phases", "differences", "rates"].map(|name| listed(row.text(name)));
        for (number, coordinate) in flow.coordinates.iter().enumerate() {
            at.push((coordinate.amplitude.clone(), amplitudes[number]));
            at.push((coordinate.phase.clone(), phases[number]));
            at.push((format!("sigma_{}", coordinate.name), differences[number]));
        }
        let at: Vec<(&str, f64)> = at.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        for (number, coordinate) in flow.coordinates.iter().enumerate() {
            let amplitude = amplitudes[number];
            let computed = [
                value(&coordinate.amplitude_rate, &at),
                value(&coordinate.phase_rate, &at) * amplitude,
                value(&coordinate.equations[0], &at),
                value(&coordinate.equations[1], &at),
            ];
            for (computed, expected) in computed.iter().zip(rates[2 * number..2 * number + 2].iter().cycle())
            {
                assert!(
                    (computed - expected).abs() < 4e-15,
                    "{text}, {}: {computed} for {expected}",
                    coordinate.name
                );
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 68);
}

/// Two equal oscillators with a weak spring between them swing with ω and √(ω² + 2εk), whose power series the phase rates are.
#[test]
fn linear_coupling_shifts_the_frequency_exactly() {
    let flow = flow("x'' + w^2*x + eps*k*(x - y) = 0; y'' + w^2*y + eps*k*(y - x) = 0", "", "", 4);
    let at = |phase: f64, eps: f64| {
        [
            ("w", 1.3),
            ("k", 0.7),
            ("eps", eps),
            ("A_x", 0.4),
            ("A_y", 0.4),
            ("phi_x", 0.2),
            ("phi_y", 0.2 + phase),
        ]
    };
    let shift = |eps: f64| libm::sqrt(1.3 * 1.3 + 2.0 * eps * 0.7) - 1.3;
    for coordinate in &flow.coordinates {
        let rate = |phase: f64, eps: f64| value(&coordinate.phase_rate, &at(phase, eps));
        let drift = |phase: f64| value(&coordinate.amplitude_rate, &at(phase, 0.1));
        assert!(rate(0.0, 0.1).abs() < 1e-15 && drift(0.0).abs() < 1e-15);
        assert!(drift(std::f64::consts::PI).abs() < 1e-15);
        let error = |eps: f64| (rate(std::f64::consts::PI, eps) - shift(eps)).abs();
        let exponent = libm::log2(error(0.08) / error(0.04));
        assert!((exponent - 5.0).abs() < 0.15, "{exponent}");
    }
}

/// Coordinates that do not act on each other have the slow flows of one coordinate.
#[test]
fn coordinates_without_coupling_are_those_alone() {
    let one = "2*eps*mu*x' + w^2*x + eps*a*x^3 + eps*b*x^2";
    let other = one.replace("x", "y");
    let options = options("1:1", "1/1", 3);
    let both = format!("x'' + {one} = eps*F*cos(W*t); y'' + {other} = eps*F*cos(W*t)");
    let both = coupled_slow_flow(&equation(&both), &options, &Quiet).unwrap();
    let options = SymbolicSlowFlowOptions { ratios: vec![], ..options };
    let alone = equation(&format!("x'' + {one} = eps*F*cos(W*t)"));
    let alone = slow_flow_symbolically(&alone, &options, &Quiet).unwrap();
    for coordinate in both.coordinates {
        let renamed = |text: &str| {
            let names = [(coordinate.amplitude.as_str(), "A"), (coordinate.phase.as_str(), "phi")];
            names.iter().fold(text.to_owned(), |text, (symbol, plain)| text.replace(symbol, plain))
        };
        assert_eq!(renamed(&coordinate.amplitude_rate), alone.amplitude_rate);
        assert_eq!(renamed(&coordinate.phase_rate), alone.phase_rate);
        assert_eq!(renamed(&coordinate.displacement), alone.displacement);
    }
}

type Values<'a> = &'a [(&'a str, f64)];

/// The state of a system with numbers after a time.
fn state_after(text: &str, values: Values<'_>, start: &[f64], time: f64) -> Vec<f64> {
    let typed = equation(text);
    let number = |value: f64| format!("({value:e})").parse().unwrap();
    let put = |formula: &libration::expression::Expression| {
        values.iter().fold(formula.clone(), |formula, (name, value)| {
            formula.substitute(&Symbol::plain(name), &number(*value))
        })
    };
    let primes = if text.contains("''") { "''" } else { "'" };
    let sides = typed.variables().iter().zip(typed.accelerations());
    let numeric: Vec<String> = sides.map(|(name, side)| format!("{name}{primes} = {}", put(side))).collect();
    let system = System::new(&equation(&numeric.join("; "))).unwrap();
    let start = Moment { time: 0.0, state: start.to_vec() };
    let solution = integrate(&system, &start, &[time], &Effort::to_tolerance(1e-14), &Quiet).unwrap();
    solution.samples.last().unwrap().state.clone()
}

/// Displacements and velocities by the slow flow.
fn by_slow_flow(flow: &CoupledSlowFlow, values: Values<'_>, slow: &[f64], time: f64) -> Vec<f64> {
    let displacement = |coordinate: &CoordinateFlow, time: f64| {
        let mut at = values.to_vec();
        for (number, other) in flow.coordinates.iter().enumerate() {
            at.push((&other.amplitude, slow[2 * number]));
            at.push((&other.phase, slow[2 * number + 1]));
        }
        at.push(("t", time));
        value(&coordinate.displacement, &at)
    };
    flow.coordinates.iter().map(|coordinate| displacement(coordinate, time)).collect()
}

/// The largest distance between slow flow and motion at times from 1/ε to 2/ε, from states on the slow flow.
fn distance(text: &str, flow: &CoupledSlowFlow, values: Values<'_>, slow: &[f64], eps: f64) -> f64 {
    let mut at = values.to_vec();
    at.push(("eps", eps));
    let rates = flow.coordinates.iter().flat_map(|coordinate| {
        [
            format!("{}' = {}", coordinate.amplitude, coordinate.amplitude_rate),
            format!("{}' = {}", coordinate.phase, coordinate.phase_rate),
        ]
    });
    let slow_text = rates.collect::<Vec<_>>().join("; ");
    let before = by_slow_flow(flow, &at, slow, 0.0);
    // The velocity of the displacement along the slow flow, by a difference of which the error is 1e-10.
    let step = 1e-3;
    let moved = [-2.0, -1.0, 1.0, 2.0].map(|n| {
        let slow = state_after(&slow_text, &at, slow, n * step);
        by_slow_flow(flow, &at, &slow, n * step)
    });
    let velocity = |number: usize| {
        (moved[0][number] - 8.0 * moved[1][number] + 8.0 * moved[2][number] - moved[3][number])
            / (12.0 * step)
    };
    let mut start = before.clone();
    start.extend((0..before.len()).map(velocity));
    let distance = |time: f64| {
        let exact = state_after(text, &at, &start, time);
        let expected = by_slow_flow(flow, &at, &state_after(&slow_text, &at, slow, time), time);
        expected.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    (0..12).map(|n| distance((1.0 + f64::from(n) / 11.0) / eps)).fold(0.0, f64::max)
}

/// After a time of order 1/ε the slow flow of order n is wrong by a multiple of εⁿ.
#[test]
fn motions_depart_from_slow_flows_by_the_power_of_the_order() {
    let cases: [(&str, &str, &str, Values<'_>); 3] = [
        (
            "x'' + w^2*x + eps*a*x*y = 0; y'' + 4*w^2*y + eps*b*x^2 = 0",
            "",
            "",
            &[("w", 1.1), ("a", 1.3), ("b", 0.7)],
        ),
        (
            "x'' + eps*m*x' + w^2*x + eps*a*x*y^2 = 0; y'' + eps*m*y' + w^2*y + eps*a*x^2*y + eps*b*y^3 = 0",
            "",
            "",
            &[("w", 0.9), ("a", 0.8), ("b", -0.6), ("m", 0.1)],
        ),
        (
            "x'' + w^2*x + eps*a*x*y = eps*F*cos(w*t); y'' + eps*m*y' + 4*w^2*y + eps*a*x^2 = 0",
            "",
            "1/1",
            &[("w", 1.0), ("a", 1.4), ("m", 0.2), ("F", 0.8), ("sigma", 0.0)],
        ),
    ];
    for (text, ratios, resonance, values) in cases {
        for order in [1, 2] {
            let driven = text.replace("cos(w*t)", "cos(W*t)");
            let mut numeric = flow(&driven, ratios, resonance, order);
            for coordinate in &mut numeric.coordinates {
                coordinate.displacement = coordinate.displacement.replace('W', "w");
            }
            let slow = [1.1, 0.3, 0.9, -0.8];
            let [large, small] = [0.04, 0.01].map(|eps| distance(text, &numeric, values, &slow, eps));
            let exponent = libm::log2(large / small) / 2.0;
            let expected = f64::from(u8::try_from(order).unwrap());
            assert!((exponent - expected).abs() < 0.25, "{text}, order {order}: {exponent}, {small:e}");
        }
    }
}

/// Without small parameters terms are small with the amplitudes, and detunings are of the lowest order at which these act.
#[test]
fn detunings_have_the_order_of_the_terms_that_act_first() {
    let rates = |text: &str, ratios: &str, order: usize| {
        let flow = flow(text, ratios, "", order);
        flow.coordinates.into_iter().map(|coordinate| coordinate.phase_rate).collect::<Vec<_>>()
    };
    let quadratic = "x'' + w1^2*x + a*x*y = 0; y'' + w2^2*y + b*x^2 = 0";
    let expected = ["a*A_y/(4*w1)*cos(2*phi_x - phi_y)", "sigma_y + b*A_x^2/(8*w1*A_y)*cos(2*phi_x - phi_y)"];
    assert_eq!(rates(quadratic, "1:2", 1), expected);
    // The square of the detuning, as the cubic force, is of order 4.
    let cubic = "x'' + w1^2*x + a*x*y^2 = 0; y'' + w2^2*y + a*x^2*y = 0";
    let phase_rate = &rates(cubic, "1:1", 2)[1];
    assert!(
        phase_rate.starts_with("sigma_y + a*A_x^2/(4*w1)") && !phase_rate.contains("sigma_y^2"),
        "{phase_rate}"
    );
    assert!(!rates(quadratic, "1:2", 2)[1].contains("sigma_y^2/"), "√(ω² + 2ωσ + σ²) is ω + σ exactly");
}

#[test]
fn ratios_follow_from_numbers_and_equal_letters() {
    let frequencies = |text: &str, ratios: &str| {
        let flow = flow(text, ratios, "", 1);
        flow.coordinates.iter().map(|coordinate| coordinate.natural_frequency.clone()).collect::<Vec<_>>()
    };
    assert_eq!(frequencies("x'' + x + eps*x*y = 0; y'' + 9/4*y + eps*x = 0", ""), ["1", "3/2"]);
    assert_eq!(frequencies("x'' + 4*w^2*x + eps*x*y = 0; y'' + w^2*y + eps*x = 0", ""), ["2*w", "w"]);
    let sums = "x'' + (k1 + k2)*x + eps*x*y = 0; y'' + 4*(k1 + k2)*y + eps*x^2 = 0";
    assert_eq!(frequencies(sums, ""), ["w0", "2*w0"]);
    let unlike = "x'' + (k1 + k2)*x + eps*x*y = 0; y'' + (4*k1 + k2)*y + eps*x^2 = 0";
    assert_eq!(refusal(unlike, "", ""), SymbolicSlowFlowError::UnknownRatio(2));
    assert_eq!(frequencies("x'' + x + eps*x*y = 0; y'' + w2^2*y + eps*x^2 = 0", "1:2"), ["1", "2"]);
    let flow = flow("x'' + x + eps*x*y = 0; y'' + w2^2*y + eps*x^2 = 0", "1:2", "", 1);
    assert_eq!(flow.coordinates[1].detuning, Some(["sigma_y".to_owned(), "w2^2".to_owned()]));
    assert_eq!(flow.coordinates[1].frequency_difference.as_deref(), Some("eps*sigma_y"));
    assert_eq!(flow.coordinates[0].detuning, None);
}

/// The frequency of x″ + w²·x + x³ = 0 is w + 3·A²/(8·w) to second order.
#[test]
fn forces_without_a_small_parameter_act_at_the_order_that_is_not_given() {
    let text = "x'' + x^3 + w^2*x + eps*y = 0; y'' + y^3 + w^2*y + eps*x = 0";
    let options = SymbolicSlowFlowOptions::default();
    let flow = coupled_slow_flow(&equation(text), &options, &Quiet).unwrap();
    assert_eq!((flow.order, flow.order_note), (2, None));
    let rate = &flow.coordinates[0].phase_rate;
    assert!(rate.contains("3*A_x^2/(8*w)"), "{rate}");
}

#[test]
fn what_has_no_coupled_slow_flow_is_refused_with_its_reason() {
    use SymbolicSlowFlowError as Error;
    let plain = "x'' + w1^2*x + eps*x*y = 0; y'' + w2^2*y + eps*x^2 = 0";
    assert_eq!(refusal(plain, "", ""), Error::UnknownRatio(2));
    assert_eq!(refusal(plain, "1:2:3", ""), Error::Ratios { given: vec![1, 2, 3], coordinates: 2 });
    assert_eq!(refusal(plain, "0:2", ""), Error::Ratios { given: vec![0, 2], coordinates: 2 });
    assert_eq!(refusal(plain, "1:2", "1/1"), Error::NoDrive);
    assert_eq!(
        refusal("x'' + x + k*y = 0; y'' + y + eps*x = 0", "1:1", ""),
        Error::NotSmall("-k".to_owned())
    );
    assert_eq!(
        refusal("x'' + x + eps*y = 0; y'' + eps*x = 0", "1:1", ""),
        Error::NoOscillation("0".to_owned())
    );
    assert_eq!(refusal("x'' + x + eps*abs(y) = 0; y'' + y = 0", "1:1", ""), Error::SeveralKinks);
    assert!(matches!(
        refusal("x'' + x + eps*y/(x + y) = 0; y'' + y = 0", "1:1", ""),
        Error::NotPolynomial(_)
    ));
}
