//! The law of forces proportional to one power, compared with closed forms and orbits.

use libration::comparison::ScalingLaw;
use libration::elliptic::Modulus;
use libration::expression::Equation;
use libration::orbit::Orbit;
use libration::oscillator::PurePower;
use libration::progress::Quiet;
use std::f64::consts::{PI, SQRT_2};

fn force(text: &str) -> Option<PurePower> {
    PurePower::of(&text.parse::<Equation>().unwrap(), None)
}

fn law(text: &str) -> ScalingLaw {
    ScalingLaw::new(force(text).unwrap_or_else(|| panic!("{text}")))
}

/// x = A·cn(At) with k² = 1/2, whose nome is e^−π: aₖ/A = √2·π/K/cosh(kπ/2), Ω/A = π/(2K).
#[test]
fn the_cubic_force_has_jacobis_function() {
    let cubic = law("x'' + x^3 = 0");
    let quarter = Modulus::from_parameter(0.5).unwrap().first();
    assert!((cubic.frequency_factor() - PI / (2.0 * quarter)).abs() <= cubic.frequency_factor_uncertainty());
    assert!(cubic.frequency_factor_uncertainty() < 2e-15);
    for harmonic in cubic.harmonics(6) {
        let k = f64::from(u32::try_from(harmonic.k).unwrap());
        let exact = SQRT_2 * PI / quarter / libm::cosh(0.5 * k * PI);
        assert!((harmonic.ratio - exact).abs() <= harmonic.uncertainty, "{harmonic:?} {exact}");
        assert!(harmonic.uncertainty < 1e-14);
    }
}

/// x = A − kt²/2 to the middle: T = 4·√(2A/k), aₖ/A = ±32/(πk)³.
#[test]
fn a_force_of_one_size_has_parabolas() {
    let constant = law("x'' + 2*sign(x) = 0");
    for amplitude in [1e-6, 1.0, 50.0] {
        let exact = 2.0 * PI / (4.0 * libm::sqrt(amplitude));
        let computed = constant.frequency_at(amplitude).unwrap();
        assert!((computed / exact - 1.0).abs() < 2e-15, "{amplitude}: {computed} {exact}");
    }
    for (n, harmonic) in constant.harmonics(8).into_iter().enumerate() {
        let k = PI * f64::from(u32::try_from(harmonic.k).unwrap());
        let exact = if n % 2 == 0 { 32.0 } else { -32.0 } / (k * k * k);
        assert!((harmonic.ratio - exact).abs() <= harmonic.uncertainty, "{harmonic:?} {exact}");
    }
}

#[test]
fn the_law_and_its_harmonics_are_those_of_orbits() {
    for (text, amplitudes) in [
        ("x'' + x*abs(x) = 0", &[0.01, 1.0, 7.0][..]),
        ("x'' + 3*x^3 = 0", &[1e-3, 2.0]),
        ("x'' = -2*x^2*sign(x)", &[0.5]),
        ("x'' + x^5/7 = 0", &[0.3, 20.0]),
        ("x'' + x^9 = 0", &[1.0]),
        ("x'' = -abs(x)^4*sign(x)", &[1.3]),
    ] {
        let law = law(text);
        for &amplitude in amplitudes {
            let orbit = Orbit::released(&text.parse().unwrap(), amplitude, &Quiet).unwrap();
            let frequency = law.frequency_at(amplitude).unwrap();
            let relative = law.frequency_factor_uncertainty() / law.frequency_factor()
                + orbit.period_uncertainty() / orbit.period()
                + 8.0 * f64::EPSILON;
            assert!((frequency / orbit.frequency() - 1.0).abs() < relative, "{text} from {amplitude}");
            assert!(relative < 1e-13, "{text}: {relative:e}");
            let terms = orbit.harmonics(0).terms;
            for harmonic in law.harmonics(4) {
                let exact = terms.get(harmonic.k).map_or(0.0, |term| term.cosine) / amplitude;
                // What the uncertain period makes of the places of the samples.
                let allowed = harmonic.uncertainty + 100.0 * relative;
                assert!((harmonic.ratio - exact).abs() < allowed, "{text} {harmonic:?}: {exact}");
            }
        }
    }
}

#[test]
fn one_power_is_recognised_however_it_is_written() {
    for (text, exponent, strength) in [
        ("x'' + x^3 = 0", "3", "1"),
        ("x'' = -(2*x^3 + x^3/2)", "3", "2.5"),
        ("x'' + k*x*abs(x) = 0", "2", "k"),
        ("m*x'' + k*x^3 = 0", "3", "k/m"),
        ("x'' = -x*sqrt(abs(4*x))", "3/2", "2"),
        ("x'' + sign(x)*abs(x)^(5/3) = 0", "5/3", "1"),
        ("x'' + sign(x)*abs(-x)^0.5 = 0", "1/2", "1"),
        ("x'' = -(x - 1)*abs(1 - x)", "2", "1"),
        ("x'' = x^3 - 3*x^3 - x + x", "3", "2"),
    ] {
        let power = force(text).unwrap_or_else(|| panic!("{text}"));
        let told = (power.exponent().to_string(), power.strength().to_string());
        assert_eq!(told, (exponent.to_owned(), strength.to_owned()), "{text}");
    }
    let about = PurePower::of(&"x'' = -(x - 3)^3".parse().unwrap(), Some(&"3".parse().unwrap())).unwrap();
    assert_eq!(about.centre().to_string(), "3");
    assert_eq!(ScalingLaw::new(about).gamma_arguments().map(|argument| argument.to_string()), ["3/4", "1/4"]);
    for text in [
        "x'' + x = 0",
        "x'' + x^3 + 1e-30*x = 0",
        "x'' + x^3 + x^5 = 0",
        "x'' + x^2 = 0",
        "x'' = x^3",
        "x'' + k*x^3 + a*x^5 = 0",
        "x'' = k*x^3",
        "x'' + x^3 + x' = 0",
        "x'' + x^3 = cos(t)",
        "x'' = -x/abs(x)^3",
        "x'' = -2*x^3 - abs(x)^3",
    ] {
        assert_eq!(force(text), None, "{text}");
    }
}
