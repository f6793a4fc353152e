//! Weak damping and excitation compared with closed forms, first integrals, limit cycles and the integrated motion.

use crate::typed::equation;
use libration::algebra::{PiSum, Rational};
use libration::expression::Expression;
use libration::orbit::Orbit;
use libration::oscillator::{NamedOscillator, Oscillator};
use libration::perturbation::{
    Expansion, Gauge, MAX_PARAMETER_ORDER, MAX_SLOW_ORDER, SlowFlow, SlowFlowError, SlowSeries, expand,
    slow_flow,
};
use libration::progress::Quiet;
use libration::taylor::{Effort, System, integrate};
use libration_testing::golden::Table;
use std::f64::consts::{PI, TAU};

fn flow(text: &str, order: usize, parameter_order: usize) -> SlowFlow {
    slow_flow(&equation(text), None, order, parameter_order, &Gauge::XMax, &Quiet).unwrap()
}

fn texts(list: &[PiSum]) -> Vec<String> {
    list.iter().map(ToString::to_string).collect()
}

#[test]
fn linear_damping_of_a_linear_spring_is_exact() {
    // √(1 − c²/4).
    let ratios = ["1", "0", "-1/8", "0", "-1/128", "0", "-1/1024"];
    for gauge in [Gauge::XMax, Gauge::Fundamental] {
        let flow = slow_flow(&equation("x'' + c*x' + x = 0"), None, 3, 6, &gauge, &Quiet).unwrap();
        for (j, ratio) in ratios.iter().enumerate() {
            let rate = if j == 1 { "-1/2" } else { "0" };
            assert_eq!(texts(&flow.amplitude_rate[j]), ["0", rate, "0", "0"], "{gauge} c^{j}");
            assert_eq!(texts(&flow.phase_rate[j]), [*ratio, "0", "0"], "{gauge} c^{j}");
        }
    }
}

#[test]
fn the_frequency_of_the_spring_may_be_irrational() {
    // A′ = −cA/2 and ψ′ = √(2 − c²/4) = √2·(1 − c²/16 − …).
    let flow = flow("x'' + c*x' + 2*x = 0", 1, 2);
    assert_eq!(texts(&flow.amplitude_rate[1]), ["0", "-1/2"]);
    assert_eq!(texts(&flow.phase_rate[0]), ["sqrt(2)"]);
    assert_eq!(texts(&flow.phase_rate[2]), ["-1/16*sqrt(2)"]);
}

/// The averaged laws of the decay of small swings: −cβₙAⁿ/π with βₙ = ∫₀^π sinⁿ⁺¹.
#[test]
fn powers_of_the_velocity_begin_with_the_integrals_of_the_sine() {
    let laws = [
        ("sign(x')", 0, "-2/pi"),
        ("x'", 1, "-1/2"),
        ("x'*abs(x')", 2, "-4/(3*pi)"),
        ("x'^3", 3, "-3/8"),
        ("x'^3*abs(x')", 4, "-16/(15*pi)"),
        ("x'^5", 5, "-5/16"),
    ];
    for (force, n, coefficient) in laws {
        let flow = flow(&format!("x'' + c*({force}) + x = 0"), 5, 1);
        for (power, value) in flow.amplitude_rate[1].iter().enumerate() {
            assert_eq!(value.to_string(), if power == n { coefficient } else { "0" }, "{force} A^{power}");
        }
    }
}

#[test]
fn dry_friction_on_a_spring_takes_the_same_from_each_swing() {
    // x″ + x = c while x falls: a half swing takes 2c and lasts π, whatever its amplitude.
    let flow = flow("x'' + c*sign(x') + x = 0", 4, 4);
    for j in 0..=4 {
        assert_eq!(flow.amplitude_rate[j][0].to_string(), if j == 1 { "-2/pi" } else { "0" });
        assert!(flow.amplitude_rate[j][1..].iter().all(PiSum::is_zero));
        let frequency = texts(&flow.phase_rate[j]);
        assert_eq!(frequency, [if j == 0 { "1" } else { "0" }, "0", "0", "0"]);
    }
    assert!((flow.displacement_at(0.5, 0.0, 0.1) - 0.5).abs() < 1e-15);
    assert!((flow.displacement_at(0.5, PI, 0.1) + 0.5).abs() < 1e-15);
}

/// dA/dψ, whose flow over a phase of π takes one turning point to the next, from the first integrals that relate them.
#[test]
fn turning_points_follow_their_first_integrals() {
    let factor = |value: &PiSum, power: i32| match value.terms() {
        [] => Rational::from(0),
        [(exponent, factor)] => {
            assert_eq!(*exponent, power);
            factor.to_rational().unwrap().clone()
        }
        other => panic!("{other:?}"),
    };
    let (table, mut compared) = (Table::read("slow_flow.csv"), 0);
    for text in
        ["x'' + c*x'*abs(x') + x = 0", "x'' + c*x'*abs(x') + sin(x) = 0", "x'' + c*sign(x') + sin(x) = 0"]
    {
        let flow = flow(text, 6, 4);
        let rows: Vec<_> = table.rows().filter(|row| row.text("equation") == text).collect();
        let slope = |j: usize, n: usize| {
            let has = |name, power: usize| move |row: &&_| field(row, name) == power;
            let row = rows.iter().find(|row| has("c_power", j)(row) && has("a_power", n)(row));
            row.map_or_else(|| Rational::from(0), |row| row.text("pi_times_coefficient").parse().unwrap())
        };
        for j in 0..=4 {
            // ψ′ is known to A⁵, and begins with 1.
            for n in 0..=5 {
                let mut product = Rational::from(0);
                for i in 0..=j {
                    for m in 0..=n {
                        product = product + slope(i, m) * factor(&flow.phase_rate[j - i][n - m], 0);
                    }
                }
                assert_eq!(factor(&flow.amplitude_rate[j][n], -1), product, "{text} c^{j} A^{n}");
                compared += usize::from(!product.is_zero());
            }
        }
    }
    assert_eq!(compared, table.rows().filter(|row| field(row, "a_power") < 6).count());
}

fn field(row: &libration_testing::golden::Row, name: &str) -> usize {
    row.text(name).parse().unwrap()
}

/// A polynomial in A and μ at a series A(μ).
fn along(series: &SlowSeries, amplitude: &[Rational]) -> Vec<Rational> {
    let length = amplitude.len();
    let product = |a: &[Rational], b: &[Rational]| -> Vec<Rational> {
        let term = |n: usize| (0..=n).fold(Rational::from(0), |sum, i| sum + a[i].clone() * b[n - i].clone());
        (0..length).map(term).collect()
    };
    let mut sum = vec![Rational::from(0); length];
    for (j, list) in series.iter().enumerate() {
        let horner = list.iter().rev().fold(vec![Rational::from(0); length], |sum, value| {
            let mut next = product(&sum, amplitude);
            next[0] = next[0].clone() + value.to_rational().unwrap();
            next
        });
        for n in j..length {
            sum[n] = sum[n].clone() + horner[n - j].clone();
        }
    }
    sum
}

#[test]
fn limit_cycles_are_where_the_amplitude_stays() {
    const POWER: usize = 5;
    for key in ["van_der_pol", "rayleigh"] {
        let named = NamedOscillator::by_key(key).unwrap();
        let (equation, oscillator) = (named.equation_with(&[]).unwrap(), named.oscillator(&[]).unwrap());
        let expansion: Expansion = expand(&oscillator, POWER, &Gauge::Fundamental, &Quiet).unwrap();
        // A cubic excitation makes A′ a polynomial of degree 2j + 1 at μʲ.
        for (gauge, amplitude) in
            [(Gauge::XMax, &expansion.x_max), (Gauge::Fundamental, &expansion.harmonic(1).unwrap().cos)]
        {
            let flow = slow_flow(&equation, None, 2 * POWER + 2, POWER, &gauge, &Quiet).unwrap();
            let frequency = along(&flow.phase_rate, amplitude);
            assert_eq!(frequency, expansion.frequency_ratio, "{key} {gauge}");
            assert!(along(&flow.amplitude_rate, amplitude).iter().all(Rational::is_zero), "{key} {gauge}");
        }
    }
}

/// Limit cycles with a nonlinear force, compared with the integrated orbit: its largest displacement, frequency and multiplier.
#[test]
fn limit_cycles_are_those_of_integration() {
    const POWER: usize = 4;
    for text in [
        "x'' + x = k*((1 - x^2)*x' - x^3/2)",
        "x'' + x = k*((1 - x'^2)*x' - x^3/3)",
        "x'' + x = k*((1 - 3*x^2 + x^4/2)*x' + x^3/5)",
        "x'' + 4*x = k*((1 - x^2)*x' + x^2)",
    ] {
        let flow = flow(text, 5 * POWER, POWER);
        assert_eq!(flow.whole_powers, POWER, "{text}");
        let cycles = flow.limit_cycles();
        assert!(!cycles.is_empty(), "{text}");
        let cycle = cycles.iter().find(|cycle| cycle.exponent[1] < 0.0).unwrap();
        let errors = [0.08, 0.04].map(|strength| {
            let value: Expression = strength.to_string().parse().unwrap();
            let whole = equation(text).with(&[("k", value)]).unwrap();
            let orbit = Orbit::limit_cycle(&whole, &[cycle.amplitude_at(strength), 0.0], &Quiet).unwrap();
            let floquet = orbit.floquet().unwrap();
            let multiplier =
                floquet.multipliers.iter().map(|multiplier| multiplier.abs()).fold(1.0, f64::min);
            [
                (orbit.frequency() - cycle.frequency_at(strength)).abs(),
                (libm::log(multiplier) / orbit.period() - cycle.exponent_at(strength)).abs(),
            ]
        });
        // The first power left out is POWER + 1: half the strength leaves 1/32 of it, twice that with the next powers, or rounding.
        for (coarse, fine) in errors[0].into_iter().zip(errors[1]) {
            assert!(fine < 1e-11 + 2.0 * coarse / 32.0, "{text}: {errors:?}");
            assert!(coarse < 1e-4, "{text}: {errors:?}");
        }
    }
    // The force without small terms must be linear, and the order high enough.
    assert!(flow("x'' + sin(x) = k*(1 - x^2)*x'", 9, 2).limit_cycles().is_empty());
    assert_eq!(flow("x'' + x = k*(1 - x^2)*x'", 6, 4).whole_powers, 2);
    assert_eq!(flow("x'' + x = k*(1 - x^2)*x'", 7, 4).whole_powers, 3);
}

#[test]
fn what_conserves_energy_has_no_slow_change() {
    // At c = 0 the frequency is Lindstedt's; the resistance of (54) in Black and Vel, for even n, gives back what it takes.
    for (text, undamped) in [
        ("x'' + x + x^2 + c*x'^2 = 0", "x'' + x + x^2 = 0"),
        ("x'' + sin(x) + c*x^3 = 0", "x'' + sin(x) = 0"),
    ] {
        let flow = flow(text, 6, 2);
        assert!(flow.amplitude_rate.iter().flatten().all(PiSum::is_zero), "{text}");
        let oscillator = Oscillator::new(&equation(undamped)).unwrap();
        let of_amplitude = expand(&oscillator, 6, &Gauge::XMax, &Quiet).unwrap().frequency_ratio;
        let computed: Vec<Rational> =
            flow.phase_rate[0].iter().map(|value| value.to_rational().unwrap()).collect();
        assert_eq!(computed, of_amplitude);
    }
}

/// The fourth-order Runge–Kutta method for A and ψ, with steps small enough for a negligible error.
fn followed(rates: impl Fn(f64) -> [f64; 2], start: f64, time: f64) -> [f64; 2] {
    const STEPS: u32 = 1000;
    let h = time / f64::from(STEPS);
    let mut state = [start, 0.0];
    for _ in 0..STEPS {
        let k1 = rates(state[0]);
        let k2 = rates(state[0] + 0.5 * h * k1[0]);
        let k3 = rates(state[0] + 0.5 * h * k2[0]);
        let k4 = rates(state[0] + h * k3[0]);
        for i in 0..2 {
            state[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
    }
    state
}

/// Time and displacement of the turning point, near a given time, of the motion from rest at an amplitude.
fn turning_point(text: &str, c: f64, start: f64, near: f64) -> (f64, f64) {
    let equation = equation(text).with(&[("c", format!("{c:e}").parse::<Expression>().unwrap())]).unwrap();
    let system = System::new(&equation).unwrap();
    let moment = system.start(&[(equation.variables()[0].as_str(), start)]).unwrap();
    let state_at = |time: f64| {
        let solution = integrate(
            &system,
            &moment,
            &[time - 1e-4, time, time + 1e-4],
            &Effort::to_tolerance(1e-15),
            &Quiet,
        );
        solution.unwrap().samples.into_iter().map(|sample| sample.state).collect::<Vec<_>>()
    };
    let mut time = near;
    for _ in 0..5 {
        let states = state_at(time);
        time -= states[1][1] / ((states[2][1] - states[0][1]) / 2e-4);
    }
    (time, state_at(time)[1][0])
}

/// Errors of amplitude, relative, and phase at slow times, by the power k to which the slow flow is kept: A′ to cᵏ, and to one more
/// for the phase, into which an error of A is integrated once more.
fn errors(text: &str, full: &SlowFlow, k: usize, c: f64, start: f64) -> [f64; 2] {
    let cut = |series: &SlowSeries, k: usize| series[..=k].to_vec();
    let kept = |amplitude: usize, phase: usize| SlowFlow {
        amplitude_rate: cut(&full.amplitude_rate, amplitude),
        phase_rate: cut(&full.phase_rate, phase),
        ..full.clone()
    };
    let rates = |flow: &SlowFlow, a: f64| [flow.amplitude_rate_at(a, c), flow.phase_rate_at(a, c)];
    // Whole turns, so that the motion is at an upper turning point.
    let turns = (2.0 / c / TAU).round();
    let (time, displacement) =
        turning_point(text, c, start, turns * TAU / full.phase_rate_at(0.8 * start, c));
    let of_amplitude = kept(k, k);
    let [amplitude, _] = followed(|a| rates(&of_amplitude, a), start, time);
    let of_phase = kept(k + 1, k);
    let [_, phase] = followed(|a| rates(&of_phase, a), start, time);
    let turned = (phase / TAU).round();
    [(amplitude / displacement - 1.0).abs(), (phase - TAU * turned).abs()]
}

/// Each halving of c must divide the errors of order k by nearly 2ᵏ or more, unless they are at the floor of the truncation in A.
///
/// *Nearly*: the next power of c changes the quotient by a part of the order of c, a tenth and a half of that at the two halvings, of which a
/// fifth is left. The *floors* and amplitudes belong together: the first power of A that is left out changes the frequency by some
/// (A/R)^(order + 1), with the nearest singularity at R (π for the pendulum, 1 for the spring, ½ for the well), and the phase, as A falls, by that
/// over 8c: 1.5e-11 for the pendulum from 0.6 and 3e-11 for the spring from 0.2 at c = 0.025, with coefficients of a tenth or less. Under the
/// drag of a fast flow A falls more slowly, and that is 4e-10; in the well it grows, from 0.04 to 0.066, and that is 6e-12.
fn fall_with_the_order(
    text: &str,
    start: f64,
    order: usize,
    orders: std::ops::RangeInclusive<usize>,
    floor: f64,
) {
    let full = flow(text, order, orders.end() + 1);
    for k in orders {
        let of = [0.1, 0.05, 0.025].map(|c| errors(text, &full, k, c, start));
        for pair in of.windows(2) {
            let fall = 0.8 * f64::from(1_u32 << k);
            for (before, after) in pair[0].iter().zip(pair[1]) {
                assert!(after < (before / fall).max(floor), "{text} k = {k}: {of:?}");
            }
        }
    }
}

#[test]
fn viscous_damping_of_a_pendulum_at_slow_times() {
    fall_with_the_order("x'' + c*x' + sin(x) = 0", 0.6, 15, 1..=5, 1e-11);
}

#[test]
fn viscous_damping_of_a_stiffening_spring_at_slow_times() {
    fall_with_the_order("x'' + c*x' + x + x^3 = 0", 0.2, 15, 1..=5, 1e-11);
}

#[test]
fn the_drag_of_a_fast_flow_at_slow_times() {
    fall_with_the_order("x'' + c*x'*abs(x') + sin(x) = 0", 0.4, 11, 1..=4, 1e-10);
}

#[test]
fn dry_friction_at_slow_times() {
    // It rests after π·A/(2c), so the slow time is less.
    fall_with_the_order("x'' + c*0.1*sign(x') + sin(x) = 0", 0.6, 13, 1..=3, 1e-10);
}

#[test]
fn an_asymmetric_well_with_excitation_at_slow_times() {
    fall_with_the_order("x'' + c*(x^2 - 1/2)*x' + x + x^2 = 0", 0.04, 13, 1..=3, 1e-10);
}

#[test]
fn the_motion_has_the_displacement_of_the_integrated_one() {
    for (text, start) in [
        ("x'' + c*x'*abs(x') + sin(x) = 0", 0.4),
        ("x'' + c*x'^3 + x + x^2/2 = 0", 0.2),
        ("x'' + c*(x' + x'*abs(x')) + x + x^3 = 0", 0.2),
    ] {
        let (flow, c) = (flow(text, 9, 4), 0.02);
        let with = equation(text).with(&[("c", "0.02".parse().unwrap())]).unwrap();
        let system = System::new(&with).unwrap();
        let times: Vec<f64> = (1..40).map(|i| 0.7 * f64::from(i)).collect();
        let solution = integrate(
            &system,
            &system.start(&[("x", start)]).unwrap(),
            &times,
            &Effort::to_tolerance(1e-14),
            &Quiet,
        )
        .unwrap();
        for (time, sample) in times.iter().zip(&solution.samples) {
            let [a, psi] =
                followed(|a| [flow.amplitude_rate_at(a, c), flow.phase_rate_at(a, c)], start, *time);
            let x = flow.displacement_at(a, psi, c);
            assert!((x - sample.state[0]).abs() < 2e-7, "{text} {time}: {x} {}", sample.state[0]);
        }
    }
}

#[test]
fn what_has_no_slow_flow_says_why() {
    let refusal = |text: &str, small: Option<&str>, gauge: &Gauge| {
        slow_flow(&equation(text), small, 3, 2, gauge, &Quiet).unwrap_err()
    };
    let x_max = &Gauge::XMax;
    for (text, small, expected) in [
        ("x'' + 0.1*x' + x = 0", None, "no parameter is symbolic"),
        ("x'' + c*x' + x + b*x^3 = 0", None, "b, c have no value"),
        ("x'' + c*x' + x + b*x^3 = 0", Some("c"), "no value is given for b"),
        ("x'' + c*x' + x = 0", Some("b"), "`b` is not a symbolic parameter"),
        ("x'' + c*x' - x = 0", None, "at c = 0"),
        ("x'' + c*x' + x^3 = 0", None, "at c = 0"),
        ("x'' + c*x' + x = c*cos(t)", None, "depends on t"),
        ("x'' + c*x'*abs(x') + x + x^2 = 0", None, "changes its sign"),
        ("x'' + c*x'*abs(x')^(1/2) + x = 0", None, "no power series"),
        ("x'' + c*x*abs(x) + x = 0", None, "no power series"),
        ("x'' + c*x' + sin(x) = 1/2", None, "must be fractions"),
    ] {
        let message = refusal(text, small, x_max).to_string();
        assert!(message.contains(expected), "{text}: {message}");
    }
    let kinked = "x'' + c*x'*abs(x') + x = 0";
    assert!(matches!(refusal(kinked, None, &Gauge::Fundamental), SlowFlowError::Gauge(_)));
    assert!(matches!(refusal("x'' + c*x' + x = 0", None, &Gauge::Nome), SlowFlowError::Gauge(_)));
    let orders = [(0, 1), (MAX_SLOW_ORDER + 1, 1), (1, 0), (1, MAX_PARAMETER_ORDER + 1)];
    for (order, parameter_order) in orders {
        assert!(
            slow_flow(&equation("x'' + c*x' + x = 0"), None, order, parameter_order, x_max, &Quiet).is_err()
        );
    }
}
