//! Slow flows with symbolic parameters compared with `SymPy`, textbooks, and the integrated motion.

use crate::typed::equation;
use libration::expression::{Expression, Symbol};
use libration::orbit::Orbit;
use libration::perturbation::{
    JudgedState, SlowFlowAt, SteadySolution, SteadyStates, SymbolicSlowFlow, SymbolicSlowFlowError,
    SymbolicSlowFlowOptions, next_slow_flow, slow_flow_symbolically,
};
use libration::progress::Quiet;
use libration_testing::golden::Table;
use std::f64::consts::TAU;

const DUFFING: &str = "x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)";

fn options(resonance: &str, small: &str, order: usize) -> SymbolicSlowFlowOptions {
    let numbers = resonance.split_once('/').map(|(p, q)| (p.parse().unwrap(), q.parse().unwrap()));
    let small = small.split(',').filter(|text| !text.is_empty());
    let small = small.map(|text| text.split_once(':').map(|(name, n)| (name.to_owned(), n.parse().unwrap())));
    SymbolicSlowFlowOptions {
        resonance: numbers,
        small: small.map(Option::unwrap).collect(),
        order: Some(order),
        ..Default::default()
    }
}

fn flow(text: &str, resonance: &str, small: &str, order: usize) -> SymbolicSlowFlow {
    slow_flow_symbolically(&equation(text), &options(resonance, small, order), &Quiet).unwrap()
}

fn refusal(text: &str, resonance: &str, small: &str, order: usize) -> SymbolicSlowFlowError {
    slow_flow_symbolically(&equation(text), &options(resonance, small, order), &Quiet).unwrap_err()
}

/// A formula where its symbols have values.
pub(crate) fn value(formula: &str, values: &[(&str, f64)]) -> f64 {
    let number = |value: f64| -> Expression {
        let size: Expression = format!("{:e}", value.abs()).parse().unwrap();
        if value < 0.0 { Expression::Negate(Box::new(size)) } else { size }
    };
    let put = |formula: Expression, (name, value): &(&str, f64)| {
        formula.substitute(&Symbol::plain(name), &number(*value))
    };
    values.iter().fold(formula.parse::<Expression>().unwrap(), put).to_f64().unwrap()
}

fn numbers(list: &str) -> Vec<(String, f64)> {
    let pairs = list.split(',').map(|pair| pair.split_once('=').unwrap());
    pairs
        .map(|(name, text)| (name.to_owned(), text.parse::<Expression>().unwrap().to_f64().unwrap()))
        .collect()
}

fn cube(x: f64) -> f64 {
    x * x * x
}

fn assert_near(computed: f64, expected: f64, scale: f64, what: &str) {
    assert!((computed - expected).abs() <= 1e-13 * scale, "{what}: {computed} instead of {expected}");
}

/// Nayfeh & Mook, Nonlinear Oscillations (1979), section 4.1, with their γ = σT − β as −φ.
#[test]
fn primary_resonance_of_the_duffing_oscillator_is_that_of_the_textbooks() {
    let flow = flow(DUFFING, "1/1", "", 1);
    assert_eq!(flow.amplitude_rate, "-eps*mu*A - eps*F/(2*w0)*sin(phi)");
    assert_eq!(flow.phase_rate, "-eps*sigma + 3*eps*a*A^2/(8*w0) - eps*F/(2*w0*A)*cos(phi)");
    assert_eq!(flow.displacement, "A*cos(W*t + phi) + eps*a*A^3/(32*w0^2)*cos(3*W*t + 3*phi)");
    assert_eq!(flow.drive_frequency.as_deref(), Some("w0 + eps*sigma"));
    let steady = &flow.steady_state;
    assert_eq!(steady.peak_amplitude.as_deref(), Some("F/(2*mu*w0)"));
    assert_eq!(steady.backbone.as_deref(), Some("3*a*A^2/(8*w0)"));
    assert_eq!(steady.trace.as_deref(), Some("-2*eps*mu"));
    let at = [("a", -0.7), ("mu", 0.3), ("w0", 1.2), ("F", 0.4), ("eps", 0.1), ("A", 0.8), ("sigma", 0.15)];
    let [a, mu, w0, f, eps, amplitude, sigma]: [f64; 7] = at.map(|(_, value)| value);
    let bend = |factor: f64| sigma - factor * a * amplitude * amplitude / (8.0 * w0);
    let relation = (mu * mu + bend(3.0) * bend(3.0)) * amplitude * amplitude * 4.0 * w0 * w0 - f * f;
    assert_near(value(steady.relation.as_ref().unwrap(), &at), relation, 1.0, "relation");
    let determinant = eps * eps * (mu * mu + bend(3.0) * bend(9.0));
    assert_near(value(steady.determinant.as_ref().unwrap(), &at), determinant, 1.0, "determinant");
    let folds = determinant / (eps * eps) * 8.0 * w0 * w0;
    assert_near(value(steady.folds.as_ref().unwrap(), &at), folds, 10.0, "folds");
    let critical = (256.0 * cube(w0 * mu) / (9.0 * 3.0_f64.sqrt() * a.abs())).sqrt();
    assert_near(value(steady.critical_drive.as_ref().unwrap(), &at), critical, 1.0, "critical drive");
}

/// Without damping the amplitude at resonance has no bound and every drive has folds.
#[test]
fn a_resonance_without_damping_has_neither_peak_nor_critical_drive() {
    let steady = flow("x'' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)", "1/1", "", 1).steady_state;
    assert_eq!((steady.peak_amplitude, steady.critical_drive), (None, None));
    assert!(steady.folds.is_some() && steady.notes.iter().any(|note| note.starts_with("critical_drive")));
}

/// Nayfeh & Mook (1979), section 4.2: the effective cubic coefficient a3 − 10·a2²/(9·w²).
#[test]
fn quadratic_and_cubic_terms_have_an_effective_cubic_coefficient() {
    let text = "x'' + 2*mu*x' + w^2*x + a2*x^2 + a3*x^3 = F*cos(W*t)";
    let driven = flow(text, "1/1", "a2:1,a3:2,mu:2,F:2", 2);
    let at = [("a2", 0.7), ("a3", 0.4), ("w", 1.3), ("A", 0.6), ("mu", 0.1)];
    let [a2, a3, w, amplitude, mu]: [f64; 5] = at.map(|(_, value)| value);
    let shift = (9.0 * a3 * w * w - 10.0 * a2 * a2) * amplitude * amplitude / (24.0 * cube(w));
    assert_near(value(driven.steady_state.backbone.as_ref().unwrap(), &at), shift, 1.0, "backbone");
    let effective: f64 = a3 - 10.0 * a2 * a2 / (9.0 * w * w);
    let critical = (256.0 * cube(w * mu) / (9.0 * 3.0_f64.sqrt() * effective.abs())).sqrt();
    assert_near(value(driven.steady_state.critical_drive.as_ref().unwrap(), &at), critical, 1.0, "drive");
    // The same of the free motion, where the amplitude is what is small.
    let free = flow("x'' + w^2*x + a2*x^2 + a3*x^3 = 0", "", "", 2);
    assert_near(value(&free.phase_rate, &at), shift, 1.0, "frequency");
}

/// The rows of the golden table with the orders at which the slow flows begin.
#[test]
fn textbook_slow_flows_are_those_of_sympy() {
    let table = Table::read("symbolic_slow_flow.csv");
    let mut rows = 0;
    let mut steady_states = 0;
    for row in table.rows() {
        let [text, growth, turning] = ["equation", "amplitude_rate", "phase_rate"].map(|name| row.text(name));
        let flow = flow(text, row.text("resonance"), row.text("small"), row.text("order").parse().unwrap());
        let values = numbers(row.text("values"));
        let mut at: Vec<(&str, f64)> = values.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        at.extend([("eps", 1.0), ("sigma", 0.0), ("A", 0.7), ("phi", 0.4)]);
        assert_near(value(&flow.amplitude_rate, &at), value(growth, &at), 1.0, text);
        assert_near(value(&flow.phase_rate, &at), value(turning, &at) / 0.7, 1.0, text);
        let relation = flow.steady_state.relation.as_deref().unwrap_or_else(|| panic!("{text}"));
        for state in row.text("steady").split(';').filter(|state| !state.is_empty()) {
            let numbers: Vec<f64> = state
                .split(' ')
                .map(|word| word.parse::<Expression>().map(|number| number.to_f64().unwrap()).unwrap())
                .collect();
            let [amplitude, sigma, trace, determinant] = numbers[..] else { panic!("{state}") };
            let sigma_index = at.len() - 3;
            at[sigma_index] = ("sigma", sigma);
            at[sigma_index + 1] = ("A", amplitude);
            let scale = value(&relation.replace(" - ", " + ").replacen('-', "", 1), &at).abs();
            assert_near(value(relation, &at), 0.0, scale, text);
            let condition = |formula: &Option<String>| value(formula.as_ref().unwrap(), &at);
            assert_near(condition(&flow.steady_state.trace), trace, 1.0, text);
            assert_near(condition(&flow.steady_state.determinant), determinant, 1.0, text);
            steady_states += 1;
        }
        rows += 1;
    }
    assert!(rows >= 20 && steady_states > 60, "{rows} {steady_states}");
}

/// The stable periodic motion, its fundamental amplitude and phase by the integrated equation.
fn integrated(text: &str, resonance: (u32, u32), drive: f64, start: &[f64]) -> (f64, f64) {
    let (p, q) = resonance;
    let period = f64::from(p) * TAU / drive;
    let orbit = Orbit::driven(&equation(text), start, period, &Quiet).unwrap();
    let harmonics = orbit.harmonics(0);
    let fundamental = harmonics.terms[q as usize];
    // A·cos(ψ + φ) = A·cos φ·cos ψ − A·sin φ·sin ψ.
    (fundamental.amplitude(), libm::atan2(-fundamental.sine, fundamental.cosine))
}

/// The equation with numbers, as text.
fn with_numbers(text: &str, values: &[(&str, f64)], drive: f64) -> String {
    let put = |formula: Expression, (name, value): &(&str, f64)| {
        formula.substitute(&Symbol::plain(name), &format!("{value:e}").parse().unwrap())
    };
    let all: Vec<(&str, f64)> = values.iter().copied().chain([("W", drive)]).collect();
    let acceleration = equation(text).accelerations()[0].clone();
    format!("x'' = {}", all.iter().fold(acceleration, put))
}

/// A driven oscillator with its resonance, small parameters, and the order of the slow flow.
#[derive(Clone, Copy)]
struct Driven<'a> {
    text: &'a str,
    resonance: (u32, u32),
    small: &'a str,
    order: usize,
}

/// Errors of A, relative, and φ of the stable steady state of largest amplitude.
fn errors(of: Driven<'_>, values: &[(&str, f64)], drive: f64) -> [f64; 2] {
    let Driven { text, resonance, .. } = of;
    let flow = flow(text, &format!("{}/{}", resonance.0, resonance.1), of.small, of.order);
    let of_name = |name: &str| values.iter().find(|(other, _)| *other == name).map(|(_, value)| *value);
    let at = flow.at(&of_name, Some(drive)).unwrap();
    let stable =
        |at: &SlowFlowAt<'_>| at.steady_states().unwrap().into_iter().rfind(|state| state.is_stable).unwrap();
    let SteadySolution { amplitude, phase, .. } = stable(&at);
    let displacement = |time: f64| {
        let mut at: Vec<(&str, f64)> = values.to_vec();
        at.extend([("sigma", 0.0), ("A", amplitude), ("phi", phase), ("W", drive), ("t", time)]);
        value(&flow.displacement.replace("sigma", &format!("({})", flow_detuning(&flow, values, drive))), &at)
    };
    let step = 1e-4;
    let start = [displacement(0.0), (displacement(step) - displacement(-step)) / (2.0 * step)];
    let (exact, exact_phase) = integrated(&with_numbers(text, values, drive), resonance, drive, &start);
    let turn = TAU / f64::from(resonance.0);
    [(amplitude / exact - 1.0).abs(), libm::remainder(phase - exact_phase, turn).abs()]
}

fn flow_detuning(flow: &SymbolicSlowFlow, values: &[(&str, f64)], drive: f64) -> String {
    let of_name = |name: &str| values.iter().find(|(other, _)| *other == name).map(|(_, value)| *value);
    format!("{:?}", flow.at(&of_name, Some(drive)).unwrap().detuning())
}

/// The slow flow of order n leaves out εⁿ⁺¹, which stands against ε: the errors of A and φ are of order εⁿ.
fn assert_errors_fall(
    (text, resonance): (&str, (u32, u32)),
    orders: std::ops::RangeInclusive<usize>,
    values: &[(&str, f64)],
    (largest, sigma): (f64, f64),
) {
    for order in orders {
        let sizes = [largest, largest / 2.0, largest / 4.0];
        let distances = sizes.map(|eps| {
            let mut values = values.to_vec();
            values.push(("eps", eps));
            let w0 = values.iter().find(|(name, _)| *name == "w0").unwrap().1;
            let drive = f64::from(resonance.0) / f64::from(resonance.1) * w0 + eps * sigma;
            errors(Driven { text, resonance, small: "", order }, &values, drive)
        });
        // Zero crossings of one of the two errors do not count.
        for pair in distances.map(|[amplitude, phase]| libm::hypot(amplitude, phase)).windows(2) {
            let exponent = libm::log2(pair[0] / pair[1]);
            let is_right = pair[1] < 1e-11 || exponent > f64::from(u32::try_from(order).unwrap()) - 0.35;
            assert!(is_right, "{text}, order {order}: {distances:?} falls with the power {exponent}");
        }
    }
}

/// For each row of the golden table: the detuning σ at which its motion is compared, the largest ε, and the power of ε with which the slow
/// flow of the row's order misses amplitude and phase. The next order has the next power of ε; it vanishes where the force and the small
/// parameters have a parity, and the power is then the second.
const COMPARED: [(f64, f64, i32); 25] = [
    (0.3, 0.04, 1),
    (0.3, 0.04, 1),
    (0.3, 0.04, 1),
    (0.1, 0.04, 1),
    (1.8, 0.01, 1),
    (0.02, 0.04, 1),
    (0.85, 0.01, 1),
    (0.3, 0.1, 2),
    (0.3, 0.2, 2),
    (0.3, 0.2, 2),
    (0.47, 0.04, 1),
    (0.1, 0.1, 2),
    (0.1, 0.2, 2),
    (-0.1, 0.04, 1),
    (0.57, 0.04, 1),
    (-0.12, 0.04, 1),
    (-0.1, 0.04, 1),
    (0.3, 0.04, 1),
    (0.25, 0.04, 1),
    (0.3, 0.04, 1),
    (0.4, 0.04, 1),
    (0.45, 0.04, 1),
    (0.25, 0.04, 1),
    (0.3, 0.04, 1),
    (0.4, 0.2, 2),
];

/// The value of a parameter that is small of an order; where the amplitude is small of order ε too, as the sine has it, drives and steady
/// torques have a further ε.
fn scaled(text: &str, small: &str, (name, value): (&str, f64), eps: f64) -> f64 {
    let order = small.split(',').filter_map(|pair| pair.split_once(':')).find(|(other, _)| *other == name);
    let order = order.map_or(0, |(_, order)| order.parse::<i32>().unwrap());
    let is_torque = text.contains("sin(x)") && (name == "F" || name == "R");
    value * libm::pow(eps, f64::from(order + i32::from(is_torque)))
}

#[test]
fn every_textbook_motion_is_missed_by_the_stated_power_of_eps() {
    let table = Table::read("symbolic_slow_flow.csv");
    let mut rows = COMPARED.iter();
    for row in table.rows() {
        let &(sigma, largest, power) = rows.next().unwrap();
        let [text, small] = [row.text("equation"), row.text("small")];
        let (p, q) = row.text("resonance").split_once('/').unwrap();
        let resonance = (p.parse().unwrap(), q.parse().unwrap());
        let order: usize = row.text("order").parse().unwrap();
        let numbers = numbers(row.text("values"));
        let distances = [largest, largest / 2.0, largest / 4.0].map(|eps| {
            let mut values: Vec<(&str, f64)> = numbers
                .iter()
                .map(|(name, value)| (name.as_str(), scaled(text, small, (name, *value), eps)))
                .collect();
            values.push(("eps", if small.is_empty() { eps } else { 1.0 }));
            let w0 = numbers.iter().find(|(name, _)| name == "w0").unwrap().1;
            let small_power = if small.is_empty() { 1.0 } else { f64::from(u32::try_from(order).unwrap()) };
            let drive =
                f64::from(resonance.0) / f64::from(resonance.1) * w0 + libm::pow(eps, small_power) * sigma;
            errors(Driven { text, resonance, small, order }, &values, drive)
        });
        let sizes = distances.map(|[amplitude, phase]| libm::hypot(amplitude, phase));
        for pair in sizes.windows(2) {
            let exponent = libm::log2(pair[0] / pair[1]);
            // The next term of the error is smaller by a factor of ε.
            assert!(
                (exponent - f64::from(power)).abs() < 0.06,
                "{text}: {distances:?} has the power {exponent} instead of {power}"
            );
        }
    }
    assert_eq!(rows.next(), None);
}

#[test]
fn errors_of_driven_motions_fall_with_the_power_of_eps() {
    let values = [("mu", 0.3), ("w0", 1.2), ("a", 0.9), ("F", 0.8)];
    assert_errors_fall((DUFFING, (1, 1)), 1..=4, &values, (0.08, 0.3));
    let unbalanced = "x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*W^2*cos(W*t)";
    assert_errors_fall((unbalanced, (1, 1)), 1..=3, &values, (0.04, 0.3));
    let hard = "x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^2 + eps*b*x^3 = eps*F*cos(W*t)";
    let values = [("mu", 0.3), ("w0", 1.1), ("a", 0.5), ("b", 0.7), ("F", 0.8)];
    assert_errors_fall((hard, (1, 1)), 1..=3, &values, (0.08, -0.2));
}

#[test]
fn errors_of_superharmonic_and_parametric_motions_fall_with_the_power_of_eps() {
    let cubic = "x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = F*cos(W*t)";
    let values = [("mu", 0.2), ("w0", 1.0), ("a", 0.6), ("F", 0.9)];
    assert_errors_fall((cubic, (1, 3)), 1..=3, &values, (0.01, 0.2));
    let quadratic = "x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^2 = F*cos(W*t)";
    assert_errors_fall((quadratic, (1, 2)), 1..=3, &values, (0.02, 0.1));
    let mathieu = "x'' + 2*eps*mu*x' + (w0^2 + eps*h*cos(W*t))*x + eps*a*x^3 = 0";
    let values = [("mu", 0.1), ("w0", 1.0), ("a", 0.6), ("h", 1.5)];
    assert_errors_fall((mathieu, (2, 1)), 1..=3, &values, (0.04, 0.3));
    let locked = "x'' + w0^2*x = eps*(m*(1 - x^2)*x' + F*cos(W*t))";
    let values = [("w0", 1.0), ("m", 0.8), ("F", 1.5)];
    assert_errors_fall((locked, (1, 1)), 1..=3, &values, (0.04, 0.2));
}

#[test]
fn a_force_at_rest_that_is_not_zero_and_others_that_cannot_be_averaged_are_refused() {
    let said = |text, resonance, small, order| refusal(text, resonance, small, order).to_string();
    assert!(said("x'' + w0^2*x = F*cos(W*t)", "1/1", "", 1).contains("unless it is small"));
    assert!(said(DUFFING, "", "", 1).contains("name the resonance"));
    assert!(said("x'' + w0^2*x + eps*a*x^3 = 0", "1/1", "", 1).contains("does not depend on t"));
    assert!(said(DUFFING, "2/2", "", 1).contains("in lowest terms"));
    assert!(said(DUFFING, "1/1", "G:1", 1).contains("`G` is not a symbolic parameter"));
    assert!(said(DUFFING, "1/1", "", 13).contains("give 1 to 12"));
    assert!(said("x'' + w0^2*x + g + eps*x^3 = 0", "", "", 1).contains("`-g`"));
    assert!(said("x'' + c*x' + w0^2*x + eps*x^3 = 0", "", "", 1).contains("`-c` before the velocity"));
    assert!(said("x'' - w0^2*x + eps*x^3 = 0", "", "", 1).contains("no oscillation"));
    assert!(said("x'' + w0^2*x + eps*x/(x+x^2) = 0", "", "", 1).contains("not a polynomial"));
    assert!(said("x'' + w0^2*x + eps*x/(a+b) = 0", "", "", 1).contains("not a polynomial"));
    assert!(said("x'' + w0^2*x + eps*x/(1+x^2) = 0", "", "", 1).contains("write a polynomial"));
    assert!(said("x'' + w0^2*x + eps*sign(x') = 0", "", "", 2).contains("averaged to order 1"));
    assert!(said("x'' + w0^2*x + eps*sin(x) = 0", "", "", 1).contains("write a polynomial"));
    assert!(said("x'' + w0^2*x + sqrt(eps)*x^3 = 0", "", "", 1).contains("not a polynomial"));
    assert!(said("x'' + w0^2*x + x^3/eps = 0", "", "", 1).contains("not a polynomial"));
    assert!(said("x'' + w0^2*x = 0", "", "", 1).contains("nothing is small"));
    let two = "x'' + w0^2*x + eps*x^3 = eps*(cos(W*t) + cos(V*t))";
    assert!(said(two, "1/1", "", 1).contains("several frequencies"));
    for rate in ["pi", "sqrt(2)", "W/3", "pi*W", "k*W", "sqrt(k)"] {
        let one = format!("x'' + w0^2*x + eps*x^3 = eps*(cos({rate}*t) + sin({rate}*t))");
        let error = refusal(&one, "1/1", "", 1).to_string();
        assert!(error.contains("write a symbol in its place"), "{rate}: {error}");
    }
    let two = "x'' + w0^2*x + eps*x^3 = eps*(cos(t) + cos(pi*t))";
    assert!(said(two, "1/1", "", 1).contains("several frequencies"));
    assert!(said("x'' + w0^2*x + eps*x^3 = eps*t", "1/1", "", 1).contains("not periodic in t"));
}

#[test]
fn symbols_of_the_equation_keep_their_names() {
    let flow = flow("x'' + w0^2*x + 2*eps*A*x' + eps*sigma*x^3 = eps*phi*cos(W*t)", "1/1", "", 1);
    assert_eq!(flow.amplitude_rate, "-eps*A*A_1 - eps*phi/(2*w0)*sin(phi_1)");
    assert_eq!(flow.drive_frequency.as_deref(), Some("w0 + eps*sigma_1"));
    let names = [("amplitude", "A_1"), ("phase", "phi_1"), ("detuning", "sigma_1"), ("drive_frequency", "W")];
    assert_eq!(flow.letters, names.map(|(meaning, name)| (meaning, name.to_owned())));
}

#[test]
fn free_flows_have_letters_half_waves_and_natural_frequencies_that_are_roots() {
    let cycle = flow("x'' + x = eps*(m*(1 - x^2)*x' - b*x^3)", "", "", 1);
    assert_eq!(cycle.amplitude_rate, "eps*m*A/2 - eps*m*A^3/8");
    assert_eq!(cycle.phase_rate, "3*eps*b*A^2/8");
    assert_eq!(cycle.steady_state.relation.as_deref(), Some("1/2 - A^2/8"));
    // Ω = w + 4cA/(3πw), from the mean of |cos³|.
    let two_sided = flow("x'' + w^2*x + c*x*abs(x) = 0", "", "", 1);
    assert_eq!(two_sided.phase_rate, "4*c*A/(3*w*pi)");
    let spring = flow("x'' + (k + m)*x + eps*b*x^3 = 0", "", "", 1);
    assert_eq!(spring.phase_rate, "3*eps*b*A^2/(8*w0)");
    assert!(
        spring.letters.contains(&("natural_frequency_value", "sqrt(k + m)".to_owned())),
        "{:?}",
        spring.letters
    );
}

/// A′ = −μA − F/(2ω0)·sin φ + hA/(4ω0)·sin 2φ and the like for φ: steady states by a scan of φ, with both equations linear in σ and F.
#[test]
fn drive_and_parametric_drive_together_are_eliminated_by_a_resultant() {
    let text = "x'' + 2*eps*mu*x' + (w0^2 + eps*h*cos(2*W*t))*x + eps*a*x^3 = eps*F*cos(W*t)";
    let flow = flow(text, "1/1", "", 1);
    let relation = flow.steady_state.relation.as_deref().unwrap();
    assert_eq!(flow.steady_state.phase, None);
    let points: [(f64, f64); 3] = [(0.7, 0.4), (1.3, 2.1), (0.2, -1.0)];
    for (amplitude, phi) in points {
        let [mu, w0, h, a]: [f64; 4] = [0.1, 1.2, 0.6, 0.5];
        // F from A′ = 0, σ from φ′ = 0.
        let force = (h * amplitude / 2.0 * libm::sin(2.0 * phi) - 2.0 * w0 * mu * amplitude) / libm::sin(phi);
        let sigma = 3.0 * a * amplitude * amplitude / (8.0 * w0) + h / (4.0 * w0) * libm::cos(2.0 * phi)
            - force / (2.0 * w0 * amplitude) * libm::cos(phi);
        let at =
            [("mu", mu), ("w0", w0), ("h", h), ("a", a), ("F", force), ("A", amplitude), ("sigma", sigma)];
        assert_near(value(relation, &at), 0.0, 100.0, "relation");
        let beside: Vec<_> = at
            .iter()
            .map(|(name, number)| (*name, if *name == "sigma" { number + 0.1 } else { *number }))
            .collect();
        assert!(value(relation, &beside).abs() > 1e-6, "{at:?}");
    }
}

#[test]
fn orders_that_are_not_given_are_those_of_the_small_parameters() {
    let order = |text: &str, small: &str, resonance: &str| {
        let options = SymbolicSlowFlowOptions { order: None, ..options(resonance, small, 1) };
        slow_flow_symbolically(&equation(text), &options, &Quiet).unwrap().order
    };
    assert_eq!(order(DUFFING, "", "1/1"), 1);
    assert_eq!(order("x'' + 2*mu*x' + w^2*x + a*x^2 = F*cos(W*t)", "a:1,mu:2,F:2", "1/1"), 2);
    assert_eq!(order("x'' + w^2*x + c*x*abs(x) = 0", "", ""), 1);
    assert_eq!(order("x'' + 2*c*abs(x')*x' + w0^2*sin(x) = F*cos(W*t)", "c:1,F:2", "1/1"), 2);
    // Terms without a small parameter count with the amplitude.
    assert_eq!(order("x'' + eps*m*x' + w^2*x + x^3 = 0", "eps:1", ""), 2);
    assert_eq!(order("x'' + eps*m*x' + w^2*sin(x) = 0", "eps:1", ""), 2);
    assert_eq!(order("x'' + eps*m*x' + w^2*x + x^2 = 0", "", ""), 2);
    assert_eq!(order("x'' + w^2*x + x^5 = 0", "", ""), 4);
    assert_eq!(order("x'' + w^2*x + x^4 = 0", "", ""), 6);
    assert_eq!(order("x'' + w^2*x + x*sin(x)^3 = 0", "", ""), 2);
}

/// The frequencies are averages by hand: 3·A²/(8·w) for x³, 5·A⁴/(16·w) for x⁵ and −A²·w/16 for w²·sin x.
#[test]
fn terms_without_a_small_parameter_act_at_the_order_that_is_not_given() {
    let flow = |text: &str, order| {
        let options = SymbolicSlowFlowOptions { order, ..options("", "", 1) };
        slow_flow_symbolically(&equation(text), &options, &Quiet).unwrap()
    };
    let cubic = "x'' + x^3 + w^2*x + eps*m*x' = 0";
    let at = [("A", 0.3), ("w", 1.7), ("m", 0.0), ("eps", 1.0)];
    let expected = [(cubic, 3.0 * 0.09 / 13.6), ("x'' + w^2*sin(x) + eps*m*x' = 0", -0.09 * 1.7 / 16.0)];
    for (text, rate) in expected {
        let flow = flow(text, None);
        assert_near(value(&flow.phase_rate, &at), rate, 1.0, text);
        assert_eq!(flow.order_note, None);
    }
    let fifth = flow("x'' + w^2*x + x^5 = 0", None);
    assert_near(value(&fifth.phase_rate, &at), 5.0 * 0.0081 / 27.2, 1.0, "fifth");
    let note = flow(cubic, Some(1)).order_note.unwrap();
    assert!(note.contains("degrees above 2 are left out"), "{note}");
    assert!(flow("x'' + w^2*sin(x) + eps*m*x' = 0", Some(1)).order_note.is_some());
}

/// The truncated relation of order 3 has zeros at amplitudes where its last terms are the largest.
#[test]
fn zeros_that_the_truncation_makes_are_no_steady_states() {
    let flow = flow("x'' + w0^2*x = eps*(m*(1 - x^2)*x' + F*cos(W*t))", "1/1", "", 3);
    let value = |name: &str| {
        [("w0", 1.0), ("m", 0.8), ("F", 1.5), ("eps", 0.04)]
            .iter()
            .find(|pair| pair.0 == name)
            .map(|pair| pair.1)
    };
    let states = flow.at(&value, Some(1.008)).unwrap().steady_states().unwrap();
    assert_eq!(states.len(), 1, "{states:?}");
    assert!((2.0..3.0).contains(&states[0].amplitude) && states[0].is_stable);
    assert_eq!(flow.at(&|_| None, None).unwrap_err(), ["eps", "F", "m", "w0", "W"]);
}

/// Steady states compared with those of the next order.
fn judged(of: Driven<'_>, values: &[(&str, f64)], drive: f64) -> SteadyStates {
    let Driven { text, resonance: (p, q), small, order } = of;
    let options = options(&format!("{p}/{q}"), small, order);
    let flow = slow_flow_symbolically(&equation(text), &options, &Quiet).unwrap();
    let next = next_slow_flow(&equation(text), &options, &flow, &Quiet).unwrap();
    let of_name = |name: &str| values.iter().find(|(other, _)| *other == name).map(|(_, value)| *value);
    let next = next.at(&of_name, Some(drive)).unwrap();
    flow.at(&of_name, Some(drive)).unwrap().judged_states(Some(&next)).unwrap()
}

/// Amplitudes and phases by shooting with `SciPy` (DOP853, rtol 1e-11, residual below 1e-14).
#[test]
fn errors_of_amplitude_and_phase_are_those_from_the_integrated_motion() {
    let locked = "x'' + eps*(x^2 - 1)*x' + x = eps*F*cos(W*t)";
    let exact = [(1.696_314_537, 1.869_067_738), (2.195_495_485, -2.016_794_014)];
    for order in 1..=5 {
        let of = Driven { text: locked, resonance: (1, 1), small: "", order };
        let states = judged(of, &[("eps", 0.1), ("F", 0.5)], 1.004);
        for (amplitude, phase) in exact {
            let distance = |state: &JudgedState| (state.state.amplitude - amplitude).abs();
            let nearest = states.found.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            let nearest_state = nearest.filter(|nearest| distance(nearest) < 0.02).unwrap();
            let [_, error] = nearest_state.errors.unwrap();
            let missed = (nearest_state.state.phase - phase).abs();
            // Ratios of 0.8 to 1.1, and 2.3 at order 4, where the phase moves to the next order by a fifth of its error only.
            assert!(missed < 2.5 * error, "order {order}: phase {missed} {error}");
            assert_eq!(nearest_state.is_stable, Some(amplitude > 2.0));
        }
    }
    // Orders 3 and 5 of the undriven pendulum are zero.
    let text = "x'' + 2*mu*x' + sin(x) = F*cos(W*t)";
    let of = Driven { text, resonance: (1, 1), small: "mu:2,F:2", order: 2 };
    let states = judged(of, &[("mu", 0.01), ("F", 0.01)], 0.99);
    let [state] = states.found[..] else { panic!("{states:?}") };
    let [amplitude, phase] = state.errors.unwrap();
    let missed = (state.state.amplitude - 0.471_496_482).abs();
    assert!(missed > 0.002 && missed < 1.5 * amplitude, "{missed} {amplitude}");
    assert!((state.state.phase + 1.937_332_461).abs() < 1.5 * phase, "{state:?}");
}

/// Three states by shooting with `SciPy` (DOP853, rtol 1e-11), their stability by the multipliers.
#[test]
fn states_that_the_series_does_not_reach_are_left_out_by_name() {
    let text = "x'' + eps*(m*x' + a*x^3) + x = eps*F*cos(W*t)";
    let exact = [(0.145_157, true), (2.959_622, false), (3.048_061, true)];
    for order in 1..=4 {
        let of = Driven { text, resonance: (1, 1), small: "", order };
        let states = judged(of, &[("eps", 0.1), ("m", 0.2), ("a", 1.0), ("F", 1.0)], 1.3);
        let all = states
            .found
            .iter()
            .map(|state| state.state)
            .chain(states.left_out.iter().map(|state| state.state));
        let near = |amplitude: f64| all.clone().filter(|all| (all.amplitude - amplitude).abs() < 0.3).count();
        assert!(near(0.145) == 1 && near(3.0) >= 2, "order {order}: {states:?}");
        for state in &states.found {
            let distance = |amplitude: f64| (state.state.amplitude - amplitude).abs();
            let (_, is_stable) =
                exact.iter().min_by(|a, b| distance(a.0).total_cmp(&distance(b.0))).copied().unwrap();
            assert!(state.is_stable.is_none_or(|stable| stable == is_stable), "order {order}: {states:?}");
        }
    }
}

/// At exact resonance one symbol stands for both frequencies: the formulas are those with two, and the detuning is zero where it has a value.
#[test]
fn the_drive_frequency_may_be_the_symbol_of_the_natural_one() {
    for (spring, resonance) in [("w^2", "1/1"), ("4*w^2", "1/2")] {
        let of = |drive: &str| {
            let force = if resonance == "1/1" { "eps*F*w^2" } else { "F" };
            let text =
                format!("x'' + eps*m*x' + {spring}*x + eps*a*x^2 + eps*b*x^3 = {force}*cos({drive}*t)");
            flow(&text, resonance, "", 2)
        };
        let [same, other] = ["w", "v"].map(of);
        assert_eq!(same.amplitude_rate, other.amplitude_rate);
        assert_eq!(same.phase_rate, other.phase_rate);
        assert_eq!(same.displacement, other.displacement.replace("*v*t", "*w*t").replace("(v*t", "(w*t"));
        assert_eq!(same.drive_frequency.as_deref(), Some("w + eps*sigma"));
        assert!(same.at(&|_| Some(0.7), None).unwrap().detuning().abs() < 1e-15);
    }
    let sum = flow("x'' + eps*m*x' + (k + w^2)*x = eps*F*cos(w*t)", "1/1", "", 1);
    assert_eq!(sum.amplitude_rate, "-eps*m*A/2 - eps*F/(2*w0)*sin(phi)");
}

#[test]
fn waves_of_numeric_frequencies_have_one_number() {
    let mathieu = flow("x'' + (1 + eps*h*cos(2*t))*x + eps*a*x^3 = 0", "2/1", "", 1);
    let expected = "A*cos(t + phi) + eps*h*A/16*cos(3*t + phi) + eps*a*A^3/32*cos(3*t + 3*phi)";
    assert_eq!(mathieu.displacement, expected);
    let free = flow("x'' + 4*x + eps*a*x^3 = 0", "", "", 1);
    assert_eq!(free.displacement, "A*cos(2*t + phi) + eps*a*A^3/128*cos(6*t + 3*phi)");
}

/// The polynomials are the binomial and exponential series by hand.
#[test]
fn quotients_roots_and_functions_of_small_terms_are_power_series() {
    let driven = |force: &str| flow(&format!("x'' + eps*m*x' + {force} = eps*F*cos(W*t)"), "1/1", "", 2);
    let pairs = [
        ("w^2*x/(1 + eps*a*x^2)", "w^2*x*(1 - eps*a*x^2 + eps^2*a^2*x^4)"),
        ("w^2*x*sqrt(1 + 2*eps*a*x)", "w^2*x*(1 + eps*a*x - eps^2*a^2*x^2/2)"),
        ("w^2*x*(k + eps*x')^(-2)*k^2", "w^2*x*(1 - 2*eps*x'/k + 3*eps^2*x'^2/k^2)"),
        ("w^2*x*exp(-eps*a*x)", "w^2*x*(1 - eps*a*x + eps^2*a^2*x^2/2)"),
        ("w^2*x/(1 + eps*h*cos(2*W*t))", "w^2*x*(1 - eps*h*cos(2*W*t) + eps^2*h^2*cos(2*W*t)^2)"),
    ];
    for (force, polynomial) in pairs {
        let [computed, expected] = [force, polynomial].map(driven);
        assert_eq!(computed.amplitude_rate, expected.amplitude_rate, "{force}");
        assert_eq!(computed.phase_rate, expected.phase_rate, "{force}");
        assert_eq!(computed.displacement, expected.displacement, "{force}");
        assert!(computed.order_note.unwrap().contains("power series in the small parameters"), "{force}");
    }
    // Of the displacement alone, as of other functions, the amplitude is small.
    let softening = flow("x'' + w^2*x/sqrt(1 + x^2) = 0", "", "", 2);
    assert_eq!(softening.phase_rate, "-3*w*A^2/16");
    assert_eq!(flow("x'' + k*x*(1 - l/sqrt(1 + x^2)) = 0", "", "", 2).phase_rate, "3*k*l*A^2/(16*w0)");
}

/// Nayfeh & Mook (1979), section 4.1, with an inertia that depends on the displacement.
#[test]
fn errors_with_a_varying_inertia_fall_with_the_power_of_eps() {
    let text = "(1 + eps*x^2)*x'' + 2*eps*mu*x' + eps*x*x'^2 + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)";
    let values = [("mu", 0.3), ("w0", 1.2), ("a", 0.9), ("F", 0.8)];
    assert_errors_fall((text, (1, 1)), 1..=2, &values, (0.04, 0.2));
}

/// About 1 the double well has w0² = 2, x″ = −2u − 3u² − u³ with u = x − 1, and the frequency √2·(1 − 3A²/8 + …): (9·a3·w² − 10·a2²)/(24·w³).
#[test]
fn slow_flows_are_about_any_equilibrium() {
    let about = |text: &str, equilibrium: &str| {
        let options = SymbolicSlowFlowOptions {
            about: Some(equilibrium.parse().unwrap()),
            order: Some(2),
            ..options("1/1", "m:2,F:2", 2)
        };
        slow_flow_symbolically(&equation(text), &options, &Quiet).unwrap()
    };
    let well = about("x'' + m*x' - x + x^3 = F*cos(W*t)", "1");
    let shifted = flow("u'' + m*u' + 2*u + 3*u^2 + u^3 = F*cos(W*t)", "1/1", "m:2,F:2", 2);
    assert_eq!(well.amplitude_rate, shifted.amplitude_rate);
    assert_eq!(well.phase_rate, shifted.phase_rate);
    assert_eq!(well.displacement, format!("1 + {}", shifted.displacement));
    assert_eq!((well.equilibrium.as_str(), shifted.equilibrium.as_str()), ("1", "0"));
    let at = [("F", 0.0), ("A", 0.3), ("phi", 0.0), ("sigma", 0.0), ("w0", std::f64::consts::SQRT_2)];
    let expected = (9.0 * 2.0 - 90.0) * 0.09 / (24.0 * 2.0 * std::f64::consts::SQRT_2);
    assert_near(value(&well.phase_rate, &at), expected, 1.0, "frequency");
    let letters = about("x'' + m*x' - a*x + b*x^3 = F*cos(W*t)", "sqrt(a/b)");
    let at = [
        ("F", 0.0),
        ("A", 0.3),
        ("phi", 0.0),
        ("sigma", 0.0),
        ("a", 1.0),
        ("b", 1.0),
        ("w0", libm::sqrt(2.0)),
    ];
    assert_near(value(&letters.phase_rate, &at), expected, 1.0, "letters");
    let options =
        SymbolicSlowFlowOptions { about: Some("2".parse().unwrap()), ..options("1/1", "m:2,F:2", 2) };
    let refused = slow_flow_symbolically(&equation("x'' + m*x' - x + x^3 = F*cos(W*t)"), &options, &Quiet);
    assert!(matches!(refused, Err(SymbolicSlowFlowError::Equilibrium(_))), "{refused:?}");
}
