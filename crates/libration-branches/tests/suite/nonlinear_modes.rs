//! Nonlinear normal modes compared with collocation of Lagrange's equations and shooting in 130-bit floats.

use libration::expression::Equation;
use libration::nonlinear_modes::{NonlinearMode, NonlinearModeError};
use libration::normal_modes::NormalModes;
use libration::progress::Quiet;

const DOUBLE_PENDULUM: &str = "theta1'' = (-3*sin(theta1) - sin(theta1 - 2*theta2) - 2*sin(theta1 - theta2)*(theta2'^2 + theta1'^2*cos(theta1 - theta2)))/(3 - cos(2*theta1 - 2*theta2));
    theta2'' = 2*sin(theta1 - theta2)*(2*theta1'^2 + 2*cos(theta1) + theta2'^2*cos(theta1 - theta2))/(3 - cos(2*theta1 - 2*theta2))";

/// Mode, degrees of θ1, period, θ2 at the start, stability, relative error of the source.
const DOUBLE: [(usize, f64, f64, f64, bool, f64); 8] = [
    (0, 10.0, 8.230_380_253_079_805, 0.244_980_843_801_163_32, true, 1e-15),
    (0, 30.0, 8.381_208_378_152_85, 0.685_928_697_240_161_5, true, 1e-15),
    (0, 70.0, 8.869_836_535_477_8, 1.165_114_077_984, true, 1e-12),
    (0, 90.0, 9.248_130_105_843_829, 1.289_149_589_023_645_3, true, 1e-12),
    (1, 20.0, 4.051_546_786_416_3, -0.484_585_154_593_71, true, 1e-12),
    (1, 40.0, 5.280_932_060_967_7, -0.892_552_896_581_46, true, 1e-12),
    (1, 60.0, 6.287_859_494_514_626, -1.099_990_501_943_477_8, false, 1e-15),
    (1, 80.0, 6.987_331_242_680_5, -1.126_599_381_593_4, false, 1e-12),
];

#[test]
fn modes_of_the_double_pendulum_are_followed_to_a_right_angle_with_their_stability() {
    let equation: Equation = DOUBLE_PENDULUM.parse().unwrap();
    let modes = NormalModes::new(&equation).unwrap();
    for number in [0, 1] {
        let rows = DOUBLE.iter().filter(|row| row.0 == number);
        let amplitudes: Vec<f64> = rows.clone().map(|row| row.1.to_radians()).collect();
        let mode = NonlinearMode::follow(&equation, &modes, number, 0, &amplitudes, &Quiet).unwrap();
        assert_eq!(mode.lost, None);
        for (point, (_, degrees, period, start, stable, error)) in mode.points.iter().zip(rows) {
            let tolerance = error * period + point.orbit.period_uncertainty();
            assert!(
                (point.orbit.period() - period).abs() <= tolerance.max(1e-13),
                "{degrees}°: {}",
                point.orbit.period()
            );
            assert!(point.orbit.period_uncertainty() < 1e-10);
            assert!((point.start[1] - start).abs() < 1e-10, "{degrees}°: {}", point.start[1]);
            assert_eq!(point.is_stable(), *stable, "{degrees}°");
        }
        if number == 1 {
            let [change] = &mode.changes[..] else { panic!("{:?}", mode.changes) };
            let [from, to] = change.between.map(f64::to_degrees);
            assert!(!change.stable_above && from > 50.0 && to < 60.0 && to - from < 0.12, "{change:?}");
        }
    }
}

#[test]
fn the_series_is_told_as_far_as_it_goes() {
    let equation: Equation = DOUBLE_PENDULUM.parse().unwrap();
    let modes = NormalModes::new(&equation).unwrap();
    let amplitudes: Vec<f64> = (1..=20).map(|degrees| f64::from(degrees).to_radians()).collect();
    let reach = |number| {
        let mode = NonlinearMode::follow(&equation, &modes, number, 0, &amplitudes, &Quiet).unwrap();
        mode.series_reach(0.01).unwrap().to_degrees()
    };
    // In phase κ is small; out of phase the frequency falls by a sixth at 20°.
    assert!(reach(0) > 19.9 && reach(1) < 15.0, "{} {}", reach(0), reach(1));
}

#[test]
fn what_cannot_be_followed_is_told() {
    let equation: Equation = DOUBLE_PENDULUM.parse().unwrap();
    let modes = NormalModes::new(&equation).unwrap();
    let refusal = |number, amplitudes: &[f64]| {
        NonlinearMode::follow(&equation, &modes, number, 0, amplitudes, &Quiet).unwrap_err()
    };
    assert!(matches!(refusal(2, &[0.1]), NonlinearModeError::NoMode { wanted: 3, modes: 2 }));
    assert!(matches!(refusal(0, &[0.2, 0.1]), NonlinearModeError::Amplitudes(_)));
    assert!(matches!(refusal(0, &[f64::NAN]), NonlinearModeError::Amplitudes(_)));
    let spring: Equation =
        "r'' = r*theta'^2 + cos(theta) - 10*(r - 1); theta'' = -(2*r'*theta' + sin(theta))/r"
            .parse()
            .unwrap();
    let modes = NormalModes::about(&spring, &[1.1, 0.0], &Quiet).unwrap();
    let still = NonlinearMode::follow(&spring, &modes, 0, 0, &[0.1], &Quiet);
    assert!(matches!(still, Err(NonlinearModeError::AtRest(_))));
}

fn pendulum_mode(equation: &str, amplitudes: &[f64]) -> NonlinearMode {
    let equation: Equation = equation.parse().unwrap();
    let modes = NormalModes::new(&equation).unwrap();
    NonlinearMode::follow(&equation, &modes, 0, 0, amplitudes, &Quiet).unwrap()
}

#[test]
fn no_orbit_is_invented_at_a_separatrix_or_beyond() {
    let pair = "x'' = -sin(x) + (y - x)/5; y'' = -sin(y) + (x - y)/5";
    let soft = "x'' = -x + x^3";
    let degrees = f64::to_radians;
    for (equation, amplitudes, kept) in [
        ("x'' = -sin(x)", vec![degrees(180.0)], 0),
        ("x'' = -sin(x)", vec![degrees(200.0)], 0),
        ("x'' = -sin(x)", [10.0, 170.0, 180.0, 190.0].map(degrees).to_vec(), 2),
        (soft, vec![0.5, 0.99, 1.0, 1.01, 1.5], 2),
        (soft, vec![1.01], 0),
        (pair, [90.0, 180.0, 200.0].map(degrees).to_vec(), 1),
        (pair, vec![degrees(200.0)], 0),
    ] {
        let mode = pendulum_mode(equation, &amplitudes);
        assert_eq!(mode.points.len(), kept, "{equation} {amplitudes:?}");
        let lost = mode.lost.unwrap();
        let separatrix = if equation == soft { 1.0 } else { std::f64::consts::PI };
        assert!((0.9 * separatrix..separatrix).contains(&lost.reached), "{equation} {amplitudes:?}: {lost}");
        for point in &mode.points {
            assert!(point.orbit.period_uncertainty() < 1e-9 * point.orbit.period(), "{equation}");
        }
    }
}

#[test]
fn the_reason_for_no_orbit_is_that_of_a_release() {
    let reason = |equation: &str, amplitude: f64| {
        let lost = pendulum_mode(equation, &[amplitude]).lost.unwrap();
        lost.reason.to_string()
    };
    assert!(reason("x'' = -sin(x)", 200_f64.to_radians()).contains("about another equilibrium"));
    assert!(reason("x'' = -x + x^3", 1.0).contains("accelerations vanish"));
    assert!(reason("x'' = -x + x^3", 1.01).contains("does not return"));
}

#[test]
fn a_pendulum_next_to_its_separatrix_is_neither_lost_nor_called_unstable() {
    let amplitudes = [179.0, 179.9, 179.99, 179.9999].map(f64::to_radians);
    let mode = pendulum_mode("x'' = -sin(x)", &amplitudes);
    assert!(mode.lost.is_none() && mode.changes.is_empty(), "{:?} {:?}", mode.lost, mode.changes);
    let exact = libration::pendulum::Pendulum::from_angular_frequency(1.0).unwrap();
    for (point, amplitude) in mode.points.iter().zip(["179deg", "179.9deg", "179.99deg", "179.9999deg"]) {
        let period = exact.released_from(amplitude.parse().unwrap()).unwrap().period();
        let off = (point.orbit.period() - period).abs();
        assert!(off <= point.orbit.period_uncertainty() && point.is_stable(), "{amplitude}: {off:e}");
    }
}

/// Mode, amplitude, period, y′ at the start. Reference: shooting with SciPy's DOP853 at a tolerance of 1e-13.
const GYROSCOPIC: [(usize, f64, f64, f64); 6] = [
    (0, 0.1, 7.770_953_351_915, 0.045_216_267_158),
    (0, 0.5, 7.474_612_073_140, 0.259_108_839_007),
    (0, 1.0, 6.740_454_896_187, 0.750_193_985_566),
    (1, 0.1, 1.603_513_512_046, -0.444_872_399_772),
    (1, 0.5, 1.596_913_675_779, -2.215_263_013_729),
    (1, 1.0, 1.576_554_822_092, -4.375_824_528_673),
];

#[test]
fn modes_with_gyroscopic_forces_are_followed_though_one_coordinate_moves_while_the_other_turns() {
    let equation: Equation = "x'' = -2*x + 3*y' - x^3; y'' = -5*y - 3*x'".parse().unwrap();
    let modes = NormalModes::new(&equation).unwrap();
    for number in [0, 1] {
        let mode = NonlinearMode::follow(&equation, &modes, number, 0, &[0.1, 0.5, 1.0], &Quiet).unwrap();
        assert!(mode.lost.is_none() && mode.changes.is_empty(), "{:?} {:?}", mode.lost, mode.changes);
        let rows = GYROSCOPIC.iter().filter(|row| row.0 == number);
        for (point, (_, amplitude, period, velocity)) in mode.points.iter().zip(rows) {
            let off = [point.orbit.period() - period, point.start[3] - velocity];
            assert!(off.iter().all(|off| off.abs() < 2e-11) && point.is_stable(), "{amplitude}: {off:?}");
        }
    }
}

#[test]
fn stability_of_a_mode_does_not_depend_on_the_unit_of_time() {
    // By SciPy's DOP853 the multipliers of y are on the unit circle; those of x are 1.
    let slow = "x'' = -1e-8*x - 1e-8*x^3; y'' = -2e-8*y + 1e-8*x*y";
    let fast = "x'' = -1e8*x - 1e10*x^3 + y; y'' = -2e8*y + x";
    for equation in [slow, fast] {
        let equation: Equation = equation.parse().unwrap();
        let modes = NormalModes::new(&equation).unwrap();
        let mode = NonlinearMode::follow(&equation, &modes, 0, 0, &[0.01, 0.1, 1.0], &Quiet).unwrap();
        assert!(mode.lost.is_none() && mode.points.len() == 3, "{equation}: {:?}", mode.lost);
        assert!(mode.changes.is_empty(), "{equation}: {:?}", mode.changes);
        assert!(mode.points.iter().all(libration::nonlinear_modes::ModePoint::is_stable), "{equation}");
    }
}
