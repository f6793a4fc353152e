use crate::typed::oscillator;
use libration::expression::{Equation, Expression};
use libration::oscillator::{Kind, NamedOscillator, Oscillator, catalogue};
use libration::perturbation::{Gauge, expand};
use libration::progress::Quiet;

fn refusal(text: &str) -> String {
    Oscillator::new(&text.parse::<Equation>().unwrap()).unwrap_err().to_string()
}

fn facts(oscillator: &Oscillator) -> (String, String, Kind, bool) {
    let (at, stiffness) = (oscillator.equilibrium().to_string(), oscillator.omega0_squared().to_string());
    (at, stiffness, oscillator.kind().clone(), oscillator.is_odd())
}

/// Key, equilibrium, ω0², `true` if x′ enters, `true` if the force is odd.
const CENTRES: &[(&str, &str, &str, bool, bool)] = &[
    ("pendulum", "0", "1", false, true),
    ("duffing", "0", "1", false, true),
    ("duffing_soft", "0", "1", false, true),
    ("double_well", "1", "2", false, false),
    ("cubic_quintic", "0", "1", false, true),
    ("quadratic", "0", "1", false, false),
    ("helmholtz_duffing", "0", "1", false, false),
    ("relativistic", "0", "1", true, true),
    ("x_over_sqrt", "0", "1", false, true),
    ("x_over_one_plus_square", "0", "1", false, true),
    ("sinh", "0", "1", false, true),
    ("morse", "0", "1", false, false),
    ("toda", "0", "1", false, false),
    ("rotating_hoop", "0", "0.5", false, true),
    ("mathews_lakshmanan", "0", "1", true, true),
    ("linear", "0", "1", false, true),
];

#[test]
fn centres_of_the_catalogue_are_classified() {
    for (key, at, stiffness, uses_velocity, odd) in CENTRES {
        let kind = if *uses_velocity { Kind::Reversible } else { Kind::Conservative };
        let computed = facts(&NamedOscillator::by_key(key).unwrap().oscillator(&[]).unwrap());
        assert_eq!(computed, ((*at).to_owned(), (*stiffness).to_owned(), kind, *odd), "{key}");
    }
}

#[test]
fn limit_cycles_of_the_catalogue_keep_their_strength_open() {
    for key in ["van_der_pol", "rayleigh", "rayleigh_cubic"] {
        let named = NamedOscillator::by_key(key).unwrap();
        let kind = Kind::LimitCycle { parameter: "mu".to_owned() };
        let computed = facts(&named.oscillator(&[]).unwrap());
        assert_eq!(computed, ("0".to_owned(), "1".to_owned(), kind, true), "{key}");
        let set = named.oscillator(&[("mu", "0.1".parse().unwrap())]).unwrap_err().to_string();
        assert!(set.contains("small motions grow") && set.contains("its strength open"), "{set}");
    }
}

#[test]
fn every_entry_of_the_catalogue_is_used_by_the_tests_above_or_refused() {
    let cycles = ["van_der_pol", "rayleigh", "rayleigh_cubic"];
    for named in catalogue() {
        let is_used = CENTRES.iter().any(|(key, ..)| *key == named.key) || cycles.contains(&named.key);
        let refused = named.oscillator(&[]).is_err();
        assert!(is_used != refused, "{}", named.key);
        for key in named.also {
            assert_eq!(NamedOscillator::by_key(key).unwrap().key, named.key);
        }
        let equation = named.equation.parse::<Equation>().unwrap();
        let names: Vec<String> = equation.parameters().into_iter().collect();
        assert_eq!(
            names,
            named.parameters.iter().map(|parameter| parameter.name).collect::<Vec<_>>(),
            "{}",
            named.key
        );
    }
    let refused = NamedOscillator::by_key("pure_cubic").unwrap().oscillator(&[]).unwrap_err().to_string();
    assert!(refused.contains("at 0 the restoring force has no linear part"), "{refused}");
}

#[test]
fn unknown_keys_are_refused_with_the_nearest() {
    let error = NamedOscillator::by_key("dufing").unwrap_err().to_string();
    assert!(error.contains("nearest are duffing") && error.contains("van_der_pol"), "{error}");
}

#[test]
fn equilibria_that_are_fractions_are_found_exactly() {
    for (text, at, stiffness) in [
        ("x'' = -(x - 1/3)*(x^2 + 1)", "1/3", "10/9"),
        ("x'' = x - x^3", "1", "2"),
        ("x'' = 2/5 - x/(1 + x^2)", "0.5", "12/25"),
        ("x'' = 1 - exp(x + 7/3)", "-7/3", "1"),
        ("x'' = -(x - 300)*(x + 300)*(x - 299)", "300", "600"),
        ("x'' = -(1000003*x - 17)/1000003", "17/1000003", "1"),
        ("x'' = -sin(pi*x)/pi", "0", "1"),
        ("x'' = -sqrt(2)*x/sqrt(2)", "0", "1"),
        ("x'' = 3 - x", "3", "1"),
    ] {
        let (equilibrium, stiff, _, _) = facts(&oscillator(text));
        assert_eq!(
            stiff.parse::<Expression>().unwrap().to_rational(),
            stiffness.parse::<Expression>().unwrap().to_rational(),
            "{text}: {stiff}"
        );
        assert_eq!(equilibrium, at, "{text}");
    }
}

#[test]
fn equilibria_that_are_no_fractions_are_said_to_be_in_digits() {
    // √2, ln 2 and the turned pendulum's π; OEIS A002193, A002162, A000796.
    for (text, at, stiffness) in [
        ("x'' = 2 - x^2", "1.41421356237309504880168872421…", 2.0 * 2.0_f64.sqrt()),
        ("x'' = 2 - exp(x)", "0.693147180559945309417232121458…", 2.0),
        ("x'' = sin(x)", "3.14159265358979323846264338328…", 1.0),
    ] {
        let computed = oscillator(text);
        assert_eq!(computed.equilibrium().to_string(), at, "{text}");
        assert!((computed.omega0_squared().to_f64() - stiffness).abs() < 1e-15, "{text}");
        assert!(computed.equilibrium().exact().is_none() && !computed.is_odd());
    }
}

#[test]
fn an_equilibrium_may_be_given() {
    let about = |text: &str, position: &str| {
        Oscillator::about(&text.parse().unwrap(), &position.parse().unwrap())
            .map(|centre| centre.equilibrium().to_string())
    };
    assert_eq!(about("x'' = x - x^3", "-1").unwrap(), "-1");
    assert_eq!(about("x'' = sin(x)", "3*pi").unwrap(), "9.42477796076937971538793014984…");
    assert!(about("x'' = x - x^3", "0").unwrap_err().to_string().contains("omega0^2 is -1"));
    assert!(about("x'' = x - x^3", "0.5").unwrap_err().to_string().contains("no equilibrium"));
    // In other units: zero is not next to 8e-13, nor 1e-12 within 5 % of it.
    let force = "x'' = x - 1e24*x^3";
    assert_eq!(about(force, "1e-12").unwrap(), "0.000000000001");
    assert_eq!(about(force, "1.01e-12").unwrap(), "0.000000000001");
    assert!(about(force, "8e-13").unwrap_err().to_string().contains("no equilibrium"));
    assert_eq!(
        about("x'' = 0.5 - sin(x*1e12)", "5.2e-13").unwrap(),
        "0.000000000000523598775598298873077107230547…"
    );
    assert_eq!(oscillator(force).equilibrium().to_string(), "0.000000000001");
}

#[test]
fn symmetries_are_proved_not_sampled() {
    assert!(oscillator("x'' = exp(-x) - exp(x)").is_odd());
    assert!(oscillator("x'' = -(x - 2) - (x - 2)^3").is_odd());
    assert!(!oscillator("x'' = -x - 1e-30*x^2").is_odd());
    assert_eq!(*oscillator("x'' = -x*(1 + x'^2)/(1 + (-x')^4)").kind(), Kind::Reversible);
    assert_eq!(*oscillator("x'' = -x*(1 + x^2)^300").kind(), Kind::Conservative);
    let conservative = oscillator("x'' = -x + x' - (1 + x)*x' + x*x'");
    assert_eq!(*conservative.kind(), Kind::Conservative);
    assert_eq!(conservative.acceleration().to_string(), "-x");
    let cycle = oscillator("x'' = mu*(x' - x'^3 + x^2*x') - 4*(x - 1)");
    assert_eq!(facts(&cycle), ("1".into(), "4".into(), Kind::LimitCycle { parameter: "mu".into() }, false));
}

#[test]
fn what_does_not_oscillate_is_refused_with_the_reason() {
    for (text, part) in [
        ("x'' = x", "at 0 the force points away from it: omega0^2 is -1 and must be positive"),
        (
            "x'' = -x - 0.1*x'",
            "small motions decay, because the acceleration contains -0.1 times the velocity",
        ),
        ("x'' = -x + 0.1*x'", "small motions grow, because the acceleration contains 0.1 times the velocity"),
        ("x'' = -x - x'^3", "neither the same for the opposite velocity"),
        ("x'' = -x + cos(t)", "depends on t"),
        ("x'' = -x; y'' = -y", "2 variables, x, y"),
        ("x'' = -k*x", "no value is given for k: give one, such as k=0.1"),
        ("x'' = -k*x/m", "no value is given for k, m"),
        ("x'' = -x - y^2", "no value is given for y"),
        ("x'' = -x - epsilon*x^3", "no value is given for epsilon"),
    ] {
        let error = refusal(text);
        assert!(error.contains(part), "{text}: {error}");
    }
}

#[test]
fn a_force_without_a_linear_part_is_told_by_the_way_it_drives() {
    for (text, part) in [
        ("x'' = -x^3", "at 0 the restoring force has no linear part: omega0^2 is 0"),
        ("x'' = -x^3", "expansion: the frequency at any amplitude is found without one"),
        ("x'' = -(x - 1)^5", "at 1 the restoring force"),
        ("x'' = x - sin(x)", "at 0 the force points away from it, with omega0^2 = 0"),
        ("x'' = sin(x) - x", "at 0 the restoring force"),
        ("x'' = x^3", "at 0 the force points away from it, with omega0^2 = 0"),
        ("x'' = 1 - cosh(x)", "at 0 the force points the same way on both sides"),
        ("x'' = -x^301", "at 0 the restoring force"),
        ("x'' = 0", "at 0 there is no force anywhere near it"),
        ("x'' = -x^3 - x'", "the motion is followed without one"),
    ] {
        let error = refusal(text);
        assert!(error.contains(part), "{text}: {error}");
    }
}

#[test]
fn what_a_force_lacks_for_a_power_series_is_said_as_it_is() {
    let by_orbits = "the force points back to it: the frequency at any amplitude is found without one";
    let one_way = "the force points the same way on both sides";
    for (text, parts) in [
        ("x'' = -x*abs(x)", ["it has a derivative, omega0^2 being 0, but not all", by_orbits]),
        (
            "x'' = -2*(x-1) - abs(x-1)",
            [
                "at 1 the acceleration has no power series to expand: it has a kink, its slope being -1 below and -3 above",
                by_orbits,
            ],
        ),
        ("x'' = -abs(x)", ["it has a kink, its slope being 1 below and -1 above", one_way]),
        (
            "x'' = -abs(x)*sign(-x)*(1 + abs(x))",
            ["it has a derivative, omega0^2 being -1,", "the force points away from it"],
        ),
        ("x'' = -sign(x)", ["it jumps", by_orbits]),
        ("x'' = -4*x - sign(x)", ["the force jumps from 1 to -1", "circular arcs with omega^2 = 4"]),
        ("x'' = -sqrt(x)", ["it has no value below this position", ""]),
        ("x'' = -sqrt(1 - x)", ["it has no value above this position", ""]),
        ("x'' = -sign(x)*sqrt(abs(x))", ["its slope is infinite", "the force points back to it"]),
        (
            "x'' = -x - x*abs(x)^(1/2)",
            ["it has a derivative, omega0^2 being 1, but not all", "the force points back to it"],
        ),
        // Slopes in slow units: none is negligible.
        (
            "x'' = -1e-12*(x + abs(x)/2)",
            ["it has a kink, its slope being -5e-13 below and -1.5e-12 above", by_orbits],
        ),
        ("x'' = -1e-12*x/(1 + sqrt(abs(x)))", ["it has a derivative, omega0^2 being 1e-12, but not all", ""]),
        ("x'' = -1e-12*x*abs(x)", ["it has a derivative, omega0^2 being 0, but not all", by_orbits]),
    ] {
        let error = refusal(text);
        assert!(parts.iter().all(|part| error.contains(part)), "{text}: {error}");
    }
    // Integration does not pass a root either, so that it is not offered.
    assert!(!refusal("x'' = -sign(x)*sqrt(abs(x))").contains("libration"));
}

#[test]
fn a_force_with_a_power_series_on_either_side_has_two_sides() {
    for (text, at, odd) in [
        ("x'' = -x - abs(x)^3", "0", false),
        ("x'' = -x/3 - x*abs(x)", "0", true),
        ("x'' = -x - sign(x)*x^2", "0", true),
        ("x'' = -sin(x) - x*abs(-2*x)", "0", true),
        ("x'' = -(x - 1) - (x - 1)^3*abs(1 - x)", "1", true),
        ("x'' = -x - abs(x*abs(x))", "0", false),
    ] {
        let computed = oscillator(text);
        assert_eq!((computed.equilibrium().to_string().as_str(), computed.is_odd()), (at, odd), "{text}");
        assert_eq!(*computed.kind(), Kind::TwoSided, "{text}");
    }
    // Beside the kink there is one power series.
    assert_eq!(*oscillator("x'' = -x - (x - 1e-13)*abs(x - 1e-13) - 1e-26").kind(), Kind::Conservative);
    for (text, part) in [
        ("x'' = -x - 1e-6*abs(x)", "it has a kink"),
        ("x'' = -x - 1e-6*sign(x)", "exactly 4/omega*arccos(k/(k + omega^2*A)), k = 0.000001"),
        ("x'' = -x - x*abs(x) - x*x'^2", "not all derivatives"),
        ("x'' = -x - x*abs(x)^(1/2)", "not all derivatives"),
        ("x'' = x + x*abs(x)", "omega0^2 being -1"),
    ] {
        let error = refusal(text);
        assert!(error.contains(part), "{text}: {error}");
    }
}

#[test]
fn where_no_equilibrium_is_found_nothing_is_claimed_beyond_the_search() {
    for (text, part) in [
        (
            "x'' = -1",
            "there is no equilibrium to oscillate about: the acceleration at rest never passes through zero",
        ),
        ("x'' = -(x - 100)^2 - 1", "never passes through zero"),
        ("x'' = -exp(x)", "through zero from -10 to 10, the range of the search"),
        ("x'' = -(x - 12.5)*exp(-x^2)", "if there is one further out, give it, such as 20"),
        ("x'' = ln(-1 - x^2) - x", "has no value at any position tried"),
    ] {
        let error = refusal(text);
        assert!(error.contains(part), "{text}: {error}");
    }
    let about =
        Oscillator::about(&"x'' = -(x - 12.5)*exp(-x^2/100)".parse().unwrap(), &"12.5".parse().unwrap());
    assert_eq!(about.unwrap().equilibrium().to_string(), "12.5");
    // Coefficients beyond f64 are searched for as other forces are.
    assert_eq!(oscillator("x'' = -x - 10^400*x^3").omega0_squared().to_string(), "1");
}

#[test]
fn powers_too_high_for_products_are_zero_where_their_base_is() {
    let high = oscillator("x'' = -x - x^10001");
    assert_eq!(high.omega0_squared().to_string(), "1");
    let expansion = expand(&high, 7, &Gauge::Fundamental, &Quiet).unwrap();
    assert_eq!(expansion.frequency_ratio[1..], vec![0.into(); 6]);
}

#[test]
fn an_open_parameter_is_refused_for_what_it_does() {
    for (text, part) in [
        ("x'' - mu*(1-x^2)*x' + x + x^3 = 0", "at mu = 0 the equation is x'' = -x - x^3"),
        ("x'' - mu*(1-x^2)*x' + sin(x) = 0", "give mu a value"),
        ("x'' - mu*(1-x^2)*x' - x = 0", "at mu = 0 the equation is x'' = x"),
        ("x'' + x + mu*x^2 + mu*x' = 0", "mu has no value, and is not the strength of a self-excitation"),
        ("x'' + a*x' + b*x = 0", "no value is given for a, b"),
    ] {
        let error = refusal(text);
        assert!(error.contains(part), "{text}: {error}");
    }
}

#[test]
fn a_place_is_a_number() {
    let about = |position: &str| {
        Oscillator::about(&"x'' = -sin(x)".parse().unwrap(), &position.parse().unwrap())
            .unwrap_err()
            .to_string()
    };
    assert!(about("foo").contains("`foo` is not a position: foo in it has no value"));
    assert!(about("1/0").contains("`1/0` is not a position: `1/0` has no value"));
    assert!(about("1").contains("there is no equilibrium at 1"));
}

/// Reference equations, for which series and periods are known independently, with the keys they have here.
const REFERENCES: &[(&str, &str)] = &[
    ("pendulum", "theta'' + sin(theta) = 0"),
    ("duffing", "x'' + x + x^3 = 0"),
    ("duffing_soft", "x'' + x - x^3 = 0"),
    ("cubic_quintic_duffing", "x'' + x + x^3 + x^5 = 0"),
    ("x_over_sqrt", "x'' + x/sqrt(1 + x^2) = 0"),
    ("x_over_one_plus_square", "x'' + x/(1 + x^2) = 0"),
    ("sinh", "x'' + sinh(x) = 0"),
    ("relativistic", "x'' = -x*(1 - x'^2)^(3/2)"),
    ("pure_cubic", "x'' + x^3 = 0"),
    ("quadratic", "x'' + x + x^2 = 0"),
    ("van_der_pol", "x'' - mu*(1 - x^2)*x' + x = 0"),
];

#[test]
fn reference_equations_are_in_the_catalogue_with_their_values() {
    for (key, reference) in REFERENCES {
        let equation = NamedOscillator::by_key(key).unwrap().equation_with(&[]).unwrap();
        let reference: Equation = reference.parse().unwrap();
        let pair = [&equation, &reference].map(|written| Box::new(written.accelerations()[0].clone()));
        let [ours, theirs] = pair;
        assert!(Expression::Subtract(ours, theirs).vanishes(), "{key}: {equation}");
    }
}

/// Equations that would take hours without limits; the test has no clock because machines differ.
#[test]
fn hostile_equations_are_answered() {
    for text in [
        "x'' = -2^60000000*x".to_owned(),
        format!("x'' = -x*({}1)", "9^9999999 + ".repeat(300)),
        "x'' = -sin(1e300*x) - 1".to_owned(),
        "x'' = -(x^4000 - 1e-900)^99*x^3".to_owned(),
        "x'' = exp(exp(exp(exp(x)))) - 7".to_owned(),
        "x'' = -1e-999*x - 1e999*x^3".to_owned(),
        "x'' = -(x - 1e500)".to_owned(),
        format!("x'' = -cos(200*x){}", " + cos(x)*exp(x)^2/7".repeat(90)),
    ] {
        let answer = Oscillator::new(&text.parse::<Equation>().unwrap());
        let text =
            answer.map_or_else(|error| error.to_string(), |answer| answer.omega0_squared().to_string());
        assert!(text.len() < 50_000);
    }
}
