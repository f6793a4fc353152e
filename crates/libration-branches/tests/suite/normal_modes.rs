//! Normal modes compared with textbooks, exact numbers, and periodic orbits found by integration.

use crate::typed::equation;
use libration::normal_modes::{Behaviour, Mode, ModesError, NormalModes, SearchEnd, ShiftError};
use libration::orbit::{Orbit, OrbitGuess};
use libration::progress::Quiet;
use std::f64::consts::{PI, TAU};

fn modes(text: &str) -> Vec<Mode> {
    NormalModes::new(&equation(text)).unwrap().modes
}

/// The frequency, the shape and κ/ω as text.
fn written(mode: &Mode) -> (String, String, String) {
    let frequency = mode.frequency_squared.as_ref().map(|square| square.square_root_text());
    let shape = mode
        .exact_shape
        .as_ref()
        .map(|shape| shape.iter().map(ToString::to_string).collect::<Vec<_>>().join(" : "));
    let shift = mode.shift.as_ref().ok().and_then(|shift| shift.relative.as_ref()).map(ToString::to_string);
    (frequency.unwrap_or_default(), shape.unwrap_or_default(), shift.unwrap_or_default())
}

fn texts(mode: &Mode) -> [String; 3] {
    let (frequency, shape, shift) = written(mode);
    [frequency, shape, shift]
}

/// Two pendulums of equal length and mass, one below the other.
const DOUBLE: &str = "
    a'' = (-3*sin(a) - sin(a - 2*b) - 2*sin(a - b)*(b'^2 + a'^2*cos(a - b)))/(3 - cos(2*a - 2*b));
    b'' = 2*sin(a - b)*(2*a'^2 + 2*cos(a) + b'^2*cos(a - b))/(3 - cos(2*a - 2*b))";

/// A pendulum on a spring: r is the elongation from the equilibrium, in lengths.
const SPRING: &str = "
    r'' = (1 + r)*theta'^2 - s*r + cos(theta) - 1;
    theta'' = -(2*r'*theta' + sin(theta))/(1 + r)";

fn spring(square: &str) -> Vec<Mode> {
    let equation = equation(SPRING).with(&[("s", square.parse().unwrap())]).unwrap();
    NormalModes::new(&equation).unwrap().modes
}

#[test]
fn one_coordinate_has_the_known_shifts() {
    assert_eq!(texts(&modes("theta'' + sin(theta) = 0")[0]), ["1", "1", "-1/16"]);
    assert_eq!(texts(&modes("x'' + 4*x + x^3 = 0")[0]), ["2", "1", "3/32"]);
    // −5α²/12 and 3β/8.
    assert_eq!(texts(&modes("x'' + x + x^2 + x^3 = 0")[0]), ["1", "1", "-1/24"]);
    // x″ = −x(1 − x′²)^{3/2}: Ω = 1 − 3A²/16.
    assert_eq!(texts(&modes("x'' = -x*(1 - x'^2)^(3/2)")[0]), ["1", "1", "-3/16"]);
    assert_eq!(texts(&modes("x'' = -3*x - x'^2*x")[0]), ["sqrt(3)", "1", "1/8"]);
}

#[test]
fn the_double_pendulum_is_exact() {
    let modes = modes(DOUBLE);
    let [frequency, shape, shift] = texts(&modes[0]);
    assert_eq!([frequency, shape], ["sqrt(2 - sqrt(2))", "1/2*sqrt(2) : 1"].map(str::to_owned));
    assert!(!shift.is_empty());
    let [frequency, shape, _] = texts(&modes[1]);
    assert_eq!([frequency, shape], ["sqrt(2 + sqrt(2))", "-1/2*sqrt(2) : 1"].map(str::to_owned));
    for (number, mode) in modes.iter().enumerate() {
        assert_meets_orbits(DOUBLE, mode, number);
    }
}

/// Asserts that (Ω(a) − ω)/a² of orbits, extrapolated to a = 0, is κ. The orbit begins at the largest value of the leading coordinate.
fn assert_meets_orbits(text: &str, mode: &Mode, number: usize) {
    let shift = mode.shift.as_ref().unwrap().coefficient;
    let slope = |amplitude: f64| {
        let orbit = nonlinear_mode(text, mode, amplitude);
        // The shift refers to the amplitude of the fundamental harmonic.
        let first = orbit.harmonics(mode.leading()).terms[1].amplitude();
        (orbit.frequency() - mode.frequency()) / (first * first)
    };
    let (coarse, fine) = (slope(0.02), slope(0.01));
    let computed = (4.0 * fine - coarse) / 3.0;
    assert!(
        (computed - shift).abs() < 2e-5 * shift.abs().max(1.0),
        "mode {number}: {computed} is not {shift}"
    );
}

fn nonlinear_mode(text: &str, mode: &Mode, amplitude: f64) -> Orbit {
    let equation = equation(text);
    let n = mode.shape.len();
    let mut state = vec![0.0; 2 * n];
    for (coordinate, part) in state.iter_mut().zip(&mode.shape) {
        *coordinate = amplitude * part.re;
    }
    let guess = OrbitGuess { state, period: TAU / mode.frequency() };
    Orbit::near(&equation, &guess, &[mode.leading(), n + mode.leading()], &Quiet).unwrap()
}

#[test]
fn coupled_pendulums_swing_together_as_one() {
    let coupled = "x'' = -sin(x) - k*(x - y); y'' = -sin(y) + k*(x - y)";
    let quarter = equation(coupled).with(&[("k", "5/8".parse().unwrap())]).unwrap();
    let modes = NormalModes::new(&quarter).unwrap().modes;
    assert_eq!(texts(&modes[0]), ["1", "1 : 1", "-1/16"]);
    // In opposite phase x″ = −sin x − 2kx: κ/ω = −1/(16ω²).
    assert_eq!(texts(&modes[1]), ["3/2", "1 : -1", "-1/36"]);
    assert_meets_orbits(&quarter.to_string(), &modes[1], 1);
}

#[test]
fn chains_have_frequencies_with_square_roots() {
    let chain = "x'' = y - 2*x; y'' = x - 2*y + z; z'' = y - 2*z + w; w'' = z - 2*w";
    let squares: Vec<String> =
        modes(chain).iter().map(|mode| mode.frequency_squared.as_ref().unwrap().to_string()).collect();
    let expected = ["3/2 - 1/2*sqrt(5)", "5/2 - 1/2*sqrt(5)", "3/2 + 1/2*sqrt(5)", "5/2 + 1/2*sqrt(5)"];
    assert_eq!(squares, expected);
    // 2 sin(kπ/14) is not the square root of a simple number.
    let six = "a''=b-2*a; b''=a-2*b+c; c''=b-2*c+d; d''=c-2*d+e; e''=d-2*e+f; f''=e-2*f";
    for (k, mode) in (1..).zip(modes(six)) {
        let exact = 2.0 * libm::sin(f64::from(k) * PI / 14.0);
        assert!(mode.frequency_squared.is_none());
        assert!((mode.frequency() / exact - 1.0).abs() < 1e-13, "{k}: {:e}", mode.frequency() / exact - 1.0);
    }
}

#[test]
fn the_spring_pendulum_is_in_resonance_at_two_to_one() {
    let modes = spring("4");
    assert_eq!(modes[0].shift, Err(ShiftError::Resonance(2)));
    let resonance = modes[0].resonances[0];
    assert!(resonance.exact && resonance.multiple == 2 && resonance.other_is_faster && resonance.other == 1);
    // The mode of the spring alone is linear, though its swings are not stable.
    assert_eq!(texts(&modes[1]), ["2", "1 : 0", "0"]);
    assert!(modes[1].resonances[0].exact);
}

/// Nayfeh and Mook, section 6.2, in other symbols; compared with orbits on both sides of the resonance.
#[test]
fn away_from_resonance_the_swings_of_the_spring_pendulum_have_their_shift() {
    for square in ["2", "3", "6", "20"] {
        let modes = spring(square);
        let swings = modes.iter().position(|mode| mode.leading() == 1).unwrap();
        let text = equation(SPRING).with(&[("s", square.parse().unwrap())]).unwrap().to_string();
        assert!(modes[swings].shift.as_ref().unwrap().relative.is_some(), "{square}");
        assert_meets_orbits(&text, &modes[swings], swings);
    }
    // A stiff spring is a rod.
    let stiff = spring("1000000");
    assert!((stiff[0].shift.as_ref().unwrap().coefficient + 1.0 / 16.0).abs() < 1e-5);
}

#[test]
fn resonances_that_nothing_drives_do_no_harm() {
    // Odd forces have no second harmonic.
    let pair = modes("x'' = -x - x*y^2; y'' = -4*y - x^2*y");
    assert!(pair[0].resonances[0].exact && pair[0].shift.as_ref().unwrap().coefficient == 0.0);
    // x³ drives y at its own frequency.
    let pair = modes("x'' = -x - x^3; y'' = -9*y - x^3");
    assert_eq!(pair[0].shift, Err(ShiftError::Resonance(3)));
    // Near the resonance it does not do so, but the resonance is reported.
    let pair = modes("x'' = -x - x^3; y'' = -9.1*y - x^3");
    let resonance = pair[0].resonances[0];
    assert!(!resonance.exact && (resonance.detuning - ((9.1_f64).sqrt() / 3.0 - 1.0)).abs() < 1e-15);
    assert_eq!(pair[0].shift.as_ref().unwrap().relative.as_ref().unwrap().to_string(), "3/8");
}

#[test]
fn modes_of_one_frequency_are_given_together() {
    let modes = modes("x'' = -sin(x); y'' = -sin(y)");
    assert_eq!(modes.len(), 2);
    for mode in &modes {
        assert_eq!((mode.multiplicity, &mode.shift), (2, &Err(ShiftError::Degenerate)));
    }
    assert!(modes[0].shape != modes[1].shape);
}

#[test]
fn free_unstable_and_damped_modes_are_told_apart() {
    let behaviours = |text: &str| modes(text).iter().map(|mode| mode.behaviour).collect::<Vec<_>>();
    assert_eq!(behaviours("x'' = y - x; y'' = x - y"), [Behaviour::Free, Behaviour::Oscillating]);
    assert_eq!(behaviours("x'' = 2*x - x^3"), [Behaviour::Unstable]);
    assert_eq!(behaviours("x'' = -x - x'/2"), [Behaviour::Damped]);
    assert_eq!(behaviours("x'' = -x - 3*x'"), [Behaviour::Damped; 2]);
    let damped = &modes("x'' = -x - x'/2")[0];
    assert!(
        (damped.exponent.re + 0.25).abs() < 1e-15
            && (damped.exponent.im - (15.0_f64 / 16.0).sqrt()).abs() < 1e-15
    );
    // Ziegler's follower force: flutter.
    let flutter = modes("x'' = -x - 2*y; y'' = 2*x - y");
    assert_eq!(flutter[0].behaviour, Behaviour::Damped);
    assert_eq!(flutter[1].behaviour, Behaviour::Unstable);
}

/// Foucault's pendulum: ω± = √(ω² + Ω²) ± Ω, circles in opposite senses.
/// The solutions: (A + Bt)·e^{−t}; cos t with t·cos t, exactly and with a third coordinate; all as many exponents as half the components of the state.
#[test]
fn exponents_with_fewer_shapes_than_their_multiplicity_have_powers_of_time() {
    let numbers = |text: &str| -> Vec<[usize; 2]> {
        modes(text).iter().map(|mode| [mode.multiplicity, mode.with_powers_of_time]).collect()
    };
    assert_eq!(numbers("x'' + 2*x' + x = 0"), [[1, 1]]);
    assert_eq!(numbers("x'' = -x + y; y'' = -y"), [[1, 1]]);
    assert_eq!(numbers("x'' = -x + y; y'' = -y + z; z'' = -z"), [[1, 2]]);
    assert_eq!(numbers("x'' = -x; y'' = -y"), [[2, 0], [2, 0]]);
    assert_eq!(numbers("x'' = -2*x + y; y'' = x - 2*y"), [[1, 0], [1, 0]]);
    assert_eq!(numbers("x'' + x'/10 + x = 0; y'' + y'/10 + y = 0"), [[2, 0], [2, 0]]);
    // Not exact: the square root of a frequency's square.
    assert_eq!(numbers("x'' = -pi*x + y; y'' = -pi*y"), [[1, 1]]);
}

#[test]
fn a_pendulum_in_a_turning_frame_moves_in_circles() {
    let turning = "x'' = -2*x + 2*y'; y'' = -2*y - 2*x'";
    let modes = modes(turning);
    for (mode, sign) in modes.iter().zip([-1.0, 1.0]) {
        assert!((mode.frequency() - (3.0_f64.sqrt() + sign)).abs() < 1e-14);
        assert!(
            (mode.shape[1].im - sign).abs() < 1e-14 && mode.shape[1].re.abs() < 1e-14,
            "{:?}",
            mode.shape
        );
        assert_eq!(mode.behaviour, Behaviour::Oscillating);
    }
    assert_eq!(modes[0].frequency_squared.as_ref().unwrap().to_string(), "4 - 2*sqrt(3)");
}

/// Circles of radius a in x″ = −(1 + βr²)x + 2Ωy′ turn with s² + 2Ωs = 1 + βa².
#[test]
fn shifts_of_gyroscopic_modes_are_those_of_circles() {
    let modes = modes("x'' = -x*(1 + (x^2 + y^2)/3) + y'; y'' = -y*(1 + (x^2 + y^2)/3) - x'");
    for (mode, sign) in modes.iter().zip([1.0, -1.0]) {
        // κ from d(s² + sign·s)/ds·κ = β.
        let shift = 1.0 / 3.0 / (2.0 * mode.frequency() + sign);
        assert!((mode.shift.as_ref().unwrap().coefficient - shift).abs() < 1e-13);
    }
}

#[test]
fn damping_that_grows_with_the_amplitude_is_no_frequency() {
    assert_eq!(modes("x'' = -x - x'^3")[0].shift, Err(ShiftError::NotPeriodic { grows: false }));
    assert_eq!(modes("x'' = -x + x^2*x'")[0].shift, Err(ShiftError::NotPeriodic { grows: true }));
}

#[test]
fn equilibria_are_found_from_a_guess() {
    let wells = equation("x'' = x - x^3 + y; y'' = -y*x");
    let near_well = NormalModes::about(&wells, &[0.9, 0.1], &Quiet).unwrap();
    assert_eq!(near_well.exact_equilibrium.unwrap(), [1, 0].map(libration::algebra::Rational::from));
    assert_eq!(near_well.modes[0].frequency_squared.as_ref().unwrap().to_string(), "1");
    let hoop = NormalModes::about(&equation("x'' = -sin(x) + 2*sin(x)*cos(x)"), &[1.0], &Quiet).unwrap();
    assert!((hoop.equilibrium[0] - PI / 3.0).abs() < 1e-15);
    // ω² = 2 sin²(π/3), and both forces are smooth at the equilibrium.
    assert!((hoop.modes[0].frequency() - 1.5_f64.sqrt()).abs() < 1e-15);
    let shift = hoop.modes[0].shift.as_ref().unwrap();
    let orbit =
        Orbit::released(&equation("x'' = -sin(x) + 2*sin(x)*cos(x)"), PI / 3.0 + 0.01, &Quiet).unwrap();
    let first = orbit.harmonics(0).terms[1].amplitude();
    let slope = (orbit.frequency() - 1.5_f64.sqrt()) / (first * first);
    assert!((slope - shift.coefficient).abs() < 1e-4, "{slope} {}", shift.coefficient);
}

#[test]
fn what_has_no_modes_is_refused_for_a_reason() {
    let refusal = |text: &str, guess: &[f64]| NormalModes::about(&equation(text), guess, &Quiet).unwrap_err();
    assert!(matches!(refusal("x'' = -k*x", &[0.0]), ModesError::WithoutValue(_)));
    assert_eq!(refusal("x'' = -x + cos(t)", &[0.0]), ModesError::DependsOnTime);
    assert!(matches!(refusal("x'' = -x", &[0.0, 1.0]), ModesError::Guess { wanted: 1, .. }));
    assert!(matches!(refusal("x'' = -x^2 - 1", &[0.3]), ModesError::NoEquilibrium { .. }));
    assert!(matches!(refusal("x'' = -sqrt(x)", &[0.0]), ModesError::NotSmooth { .. }));
    for (text, end) in [
        ("x'' = 1", SearchEnd::NoSlope),
        ("x'' = -ln(x)", SearchEnd::NoValue),
        ("x'' = -x^2 - 1", SearchEnd::Unsettled),
    ] {
        let refused = refusal(text, &[0.3 * f64::from(u8::from(end == SearchEnd::Unsettled))]);
        assert!(
            matches!(refused, ModesError::NoEquilibrium { end: reached, .. } if reached == end),
            "{text}: {refused}"
        );
    }
    // Kinks and dry friction are not linear, though both vanish at rest.
    assert!(matches!(refusal("x'' = -x - abs(x)/3", &[0.0]), ModesError::NotSmooth { .. }));
    assert!(matches!(refusal("x'' = -x - sign(x')/3", &[0.0]), ModesError::NotSmooth { .. }));
}

#[test]
fn quadratic_drag_does_not_change_small_oscillations() {
    let mode = &modes("x'' = -4*x - x'*abs(x')")[0];
    assert_eq!((mode.frequency(), mode.behaviour), (2.0, Behaviour::Oscillating));
    assert_eq!(mode.shift, Err(ShiftError::NotSmooth));
}

/// Springs between neighbours on a line with fixed ends: ω² = 4 sin²(kπ/(2(n + 1))), k = 1 … n.
#[test]
fn chains_of_many_masses_have_all_their_modes() {
    for n in [8_u32, 16, 31, 33] {
        let chain = format!("x[i]'' = x[i+1] - 2*x[i] + x[i-1], i = 1..{n}");
        let modes = modes(&chain);
        assert_eq!(modes.len(), n as usize);
        // For an odd number of masses the middle mode has ω² = 2, which is given as a fraction for up to 32 masses.
        let exact = modes[(n as usize - 1) / 2].frequency_squared.as_ref().map(ToString::to_string);
        assert_eq!(exact, (n == 31).then(|| "2".to_owned()), "{n}");
        for (k, mode) in (1..).zip(&modes) {
            let half_angle = std::f64::consts::FRAC_PI_2 * f64::from(k) / f64::from(n + 1);
            let expected = 2.0 * libm::sin(half_angle);
            assert!((mode.exponent.im - expected).abs() < 2e-14, "{n}, {k}: {} {expected}", mode.exponent.im);
            let part = |mass: usize| mode.shape[mass].re;
            let ratio = part(1) / part(0);
            assert!((ratio - 2.0 * libm::cos(2.0 * half_angle)).abs() < 1e-10, "{n}, {k}: {ratio}");
        }
    }
}

/// A chain of charges in a magnetic field along the normal of the line, on circular orbits: s² + ωₖ² = ±i B s.
#[test]
fn chains_in_a_magnetic_field_have_all_their_modes() {
    let n = 12_u32;
    let chain = format!(
        "x[i]'' = x[i+1] - 2*x[i] + x[i-1] + y[i]', i = 1..{n}; y[i]'' = y[i+1] - 2*y[i] + y[i-1] - x[i]', i = 1..{n}"
    );
    let mut frequencies: Vec<f64> = modes(&chain).iter().map(|mode| mode.exponent.im).collect();
    let mut expected: Vec<f64> = (1..=n)
        .flat_map(|k| {
            let free = 2.0 * libm::sin(std::f64::consts::FRAC_PI_2 * f64::from(k) / f64::from(n + 1));
            [-0.5, 0.5].map(|half| (free * free + 0.25).sqrt() + half)
        })
        .collect();
    frequencies.sort_by(f64::total_cmp);
    expected.sort_by(f64::total_cmp);
    assert_eq!(frequencies.len(), expected.len());
    for (computed, expected) in frequencies.iter().zip(&expected) {
        assert!((computed - expected).abs() < 1e-12, "{computed} {expected}");
    }
}

/// The motion forces the harmonic of the other mode, but not along that mode: the shifts are those of each coordinate alone, 3/8 for x³ and −5/12 for x².
#[test]
fn a_resonance_that_is_forced_across_the_other_mode_does_no_harm() {
    for (equations, shift) in [
        ("x'' = -x - x^3; y'' = -9*y", 0.375),
        ("x'' = -x - x^2; y'' = -4*y", -5.0 / 12.0),
        ("x'' = -x - 0.5*x*y^2 - x^3; y'' = -9*y - 0.5*x^2*y", 0.375),
        ("x'' = -x - x^2; y'' = -4*y - x*y - y^2/2", -5.0 / 12.0),
        ("x'' = -1.1*x - x^3; y'' = -9.9*y", 0.375 / 1.1_f64.sqrt()),
    ] {
        let modes = modes(equations);
        assert!(
            (modes[0].shift.as_ref().unwrap().coefficient - shift).abs() < 1e-14,
            "{equations}: {:?}",
            modes[0].shift
        );
    }
    // Here y is driven by x² at its own frequency, and there a motion of y at twice the frequency changes that of x.
    for equations in ["x'' = -x - x^2; y'' = -4*y - x^2", "x'' = -x - x^2 - x*y; y'' = -4*y - y^2"] {
        assert_eq!(modes(equations)[0].shift, Err(ShiftError::Resonance(2)), "{equations}");
    }
}

/// The frequencies of stiff systems. Reference: eigenvalues with 40 digits by mpmath.
#[test]
fn small_frequencies_of_stiff_systems_have_all_their_digits() {
    let rods = "x'' = -sin(x) - exp(0.1)*(x-y); y'' = -exp(9)*(y-x) - 3*(y-z); z'' = -2.5*exp(0.3)*(z-y) - z*exp(12)";
    let rod = "x'' = -sin(x) - exp(0.1)*(x-y); y'' = -exp(18)*(y-x)*1.1 - 3*(y-z); z'' = -2.5*exp(0.3)*(z-y) - z*exp(-12)";
    for (equation, frequencies) in [
        (rods, [1.000_136_323_154_475_6, 90.039_928_700_359_68, 403.432_976_009_008_93]),
        (rod, [0.999_999_982_683_709_6, 1.837_022_887_232_957_5, 8_498.586_362_227_226]),
    ] {
        let modes = NormalModes::new(&equation.parse().unwrap()).unwrap().modes;
        for (mode, frequency) in modes.iter().zip(frequencies) {
            let off = mode.frequency() / frequency - 1.0;
            assert!(off.abs() < 4e-15, "{equation}: {frequency} {off:e}");
        }
    }
}

/// Slow modes next to a fast one, with the squares of their exponents: one that swings, and one that swings or falls.
#[test]
fn slow_modes_next_to_a_fast_one_are_not_taken_for_free_or_equal_ones() {
    for (sign, behaviour) in [("-", Behaviour::Oscillating), ("+", Behaviour::Unstable)] {
        let equation = format!("x'' = -sin(x)*exp(0.1); y'' = {sign}sin(y)*exp(0.5); z'' = -z*exp(24)");
        let modes = NormalModes::new(&equation.parse().unwrap()).unwrap().modes;
        assert_eq!(modes.len(), 3, "{equation}");
        for (square, expected) in [(libm::exp(0.1), Behaviour::Oscillating), (libm::exp(0.5), behaviour)] {
            let near = |mode: &&Mode| (mode.exponent.abs() / square.sqrt() - 1.0).abs() < 1e-14;
            let mode = modes.iter().find(near).unwrap();
            assert_eq!((mode.behaviour, mode.multiplicity), (expected, 1), "{equation}");
        }
    }
}

/// Half of the factor of the velocity is the rate, whatever else the system contains, and in any unit of time.
#[test]
fn weak_damping_and_weak_excitation_are_not_lost() {
    for (equation, rate) in [
        ("x'' = -x - 1e-10*x'", -5e-11),
        ("x'' = -x - 1e-5*x'; y'' = -1e10*y", -5e-6),
        ("x'' = -x + 1e-5*x'; y'' = -1e10*y", 5e-6),
        ("x'' = -1e-20*x + 1e-13*x'", 5e-14),
        ("x'' = -x - 1e-13*x'", -5e-14),
        ("x'' = -1e18*x + 1e-4*x'", 5e-5),
        ("x'' = -sqrt(2)*x - 4e-13*x'", -2e-13),
    ] {
        let modes = NormalModes::new(&equation.parse().unwrap()).unwrap().modes;
        let mode = modes.iter().find(|mode| mode.exponent.re != 0.0).unwrap();
        let off = (mode.exponent.re - rate).abs();
        assert!(off < 4.0 * f64::EPSILON * mode.exponent.abs(), "{equation}: {off:e}");
    }
}

/// s = −1 ± 1e-7, and half a damping that is below the rounding errors of the frequency.
#[test]
fn exponents_of_one_coordinate_have_all_digits() {
    let exponents = |text: &str| modes(text).iter().map(|mode| mode.exponent).collect::<Vec<_>>();
    let critical = exponents("x'' = -(1 - 1e-14)*x - 2*x'");
    for expected in [-1.000_000_1, -0.999_999_9] {
        let is_there =
            critical.iter().any(|exponent| (exponent.re - expected).abs() < 4e-16 && exponent.im == 0.0);
        assert!(is_there, "{critical:?}");
    }
    assert_eq!(exponents("x'' = -x - 2*x'").len(), 1);
    let weak = exponents("x'' = -x - 2e-25*x'");
    assert_eq!((weak[0].re, weak[0].im), (-1e-25, 1.0));
    let stiff = exponents("x'' = -x - 1e9*x'");
    assert!(stiff.iter().any(|exponent| (exponent.re + 1e-9).abs() < 1e-24), "{stiff:?}");
}

/// Reference: eigenvalues with 40 digits by mpmath.
#[test]
fn exponents_of_a_stiff_system_with_velocities_have_their_digits() {
    let equation = "x'' = -sin(x)*exp(0.1) - 0.3*y'; y'' = -exp(18)*(y-x)*1.1 + 0.3*x'";
    let modes = NormalModes::new(&equation.parse().unwrap()).unwrap().modes;
    let expected = [
        (-0.150_000_001_921_409_24, 1.040_514_735_477_081_8),
        (0.150_000_001_921_409_24, 8_498.586_129_972_654),
    ];
    for (mode, (re, im)) in modes.iter().zip(expected) {
        let off = [mode.exponent.re - re, mode.exponent.im - im].map(|off| off.abs() / mode.exponent.abs());
        assert!(off.iter().all(|off| *off < 1e-14), "{re} + {im}i: {off:?}");
    }
}

/// From 1.1 a full step of Newton's method crosses the singularity at zero, behind which there is another equilibrium, at −1.
#[test]
fn an_equilibrium_is_not_sought_beyond_a_singularity() {
    let equation = "x'' = 24*(1/x^13 - 1/x^7)".parse().unwrap();
    for guess in [0.9, 1.05, 1.1] {
        let modes = NormalModes::about(&equation, &[guess], &Quiet).unwrap();
        assert_eq!(modes.equilibrium, [1.0], "{guess}");
        assert!((modes.modes[0].frequency() - 12.0).abs() < 1e-14, "{guess}");
    }
}

/// Far out these forces vanish by rounding, and next to a double zero double precision knows half the digits of a zero.
#[test]
fn forces_that_vanish_by_rounding_only_have_no_equilibrium() {
    for (text, guess) in [
        ("x'' = -x + sqrt(x^2 + 1e-12)", 0.0),
        ("x'' = -x + sqrt(x^2 + 1)", 0.0),
        ("x'' = sin(x) - 1", 1.5),
        ("x'' = -exp(-x)", 700.0),
    ] {
        let refused = NormalModes::about(&equation(text), &[guess], &Quiet);
        assert!(matches!(refused, Err(ModesError::NoEquilibrium { .. })), "{text}: {refused:?}");
    }
    let several = equation("x'' = -x; y'' = -y + sqrt(y^2 + 1e-12)");
    assert!(matches!(NormalModes::new(&several), Err(ModesError::NoEquilibrium { .. })));
}

/// References: mpmath with 40 digits.
#[test]
fn equilibria_next_to_double_zeros_have_all_their_digits() {
    let double = NormalModes::about(&equation("x'' = -x - x^2 - 1/4"), &[-0.4], &Quiet).unwrap();
    assert_eq!((double.equilibrium[0], double.modes[0].behaviour), (-0.5, Behaviour::Free));
    let near = equation("x'' = sin(x) - 0.99999999999999");
    let near = NormalModes::about(&near, &[1.5], &Quiet).unwrap();
    assert!((near.equilibrium[0] - 1.570_796_185_373_540_3).abs() < 1e-15, "{:?}", near.equilibrium);
    assert!(
        (near.modes[0].exponent.re / 0.000_376_060_309_308_638_9 - 1.0).abs() < 1e-14,
        "{:?}",
        near.modes[0].exponent
    );
}

/// A double well of any width: a guess next to one minimum is not taken for the maximum at zero, and a narrow one has the frequencies of a wide one.
#[test]
fn equilibria_are_distinguished_in_all_units() {
    for width in [1e-15, 1e-9, 1.0, 1e9] {
        let wells = equation(&format!("x'' = x - ({:e}*x)^2*x; y'' = -2*y", 1.0 / width));
        let modes = NormalModes::about(&wells, &[0.8 * width, 0.0], &Quiet).unwrap();
        assert!((modes.equilibrium[0] / width - 1.0).abs() < 1e-14, "{width}: {:?}", modes.equilibrium);
        let squares: Vec<f64> = modes.modes.iter().map(|mode| mode.frequency() * mode.frequency()).collect();
        assert!(squares.iter().all(|square| (square - 2.0).abs() < 1e-13), "{width}: {squares:?}");
    }
}

/// A kink of one coordinate is seen next to the stiffness of another, coupled or not.
#[test]
fn kinks_are_seen_next_to_stiff_coordinates() {
    for stiffness in [1e8, 1e10, 1e12] {
        for coupling in ["", "+ x"] {
            let text = format!("x'' = -{stiffness:e}*x; y'' = -y - 0.5*max(y,0) {coupling}");
            let refused = NormalModes::about(&equation(&text), &[0.0, 0.0], &Quiet);
            assert!(matches!(refused, Err(ModesError::NotSmooth { .. })), "{text}: {refused:?}");
        }
    }
}

/// An equilibrium at a kink is not linear, however large its coordinate and with it the rounding; one next to a kink is, however small both are.
#[test]
fn kinks_are_seen_in_all_units() {
    for unit in [1e-13, 1.0, 1e9] {
        let at_kink = format!("x'' = -(x - sqrt(2)*{unit:e}) - abs(x - sqrt(2)*{unit:e})/2");
        let refused = NormalModes::about(&equation(&at_kink), &[1.5 * unit], &Quiet);
        assert!(matches!(refused, Err(ModesError::NotSmooth { .. })), "{unit}: {refused:?}");
        let beside = format!("x'' = -(x - {unit:e}) - 10*max(x - 3*{unit:e}, 0)");
        let modes = NormalModes::about(&equation(&beside), &[1.5 * unit], &Quiet).unwrap();
        assert!((modes.modes[0].frequency() - 1.0).abs() < 1e-14, "{unit}");
    }
}
