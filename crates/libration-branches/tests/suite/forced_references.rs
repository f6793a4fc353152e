//! Points of response curves, and singular points that are not in other files of the suite, compared with Fourier collocation with extended
//! systems and Taylor shooting, both in floats of 130 bits, which agree in 30 digits.

use crate::typed::equation_with;
use libration::continuation::{BranchPoint, Ending, Response, ResponseOptions, SpecialKind};
use libration::expression::Equation;
use libration::progress::Quiet;

const PENDULUM: &str = "theta'' = -c*theta' - sin(theta) + A*cos(w*t)";
const PIVOT: &str = "theta'' = -c*theta' - (1 - a*w^2*cos(w*t))*sin(theta)";
const DUFFING: &str = "x'' = -c*x' - x - b*x^3 + F*cos(w*t)";
const VAN_DER_POL: &str = "x'' = mu*(1 - x^2)*x' - x + F*cos(w*t)";

/// c and A, the frequency, the state at phase zero, the amplitude, the multipliers.
type Driven<'a> = ([&'a str; 2], f64, [f64; 2], f64, [f64; 2], [f64; 2]);

const DRIVEN: &[Driven<'_>] = &[
    (
        ["0.1", "0.15"],
        0.70,
        [0.2945168920184240369183, 0.02871899931394924897663],
        0.29738451418026991193,
        [-0.5408300221505175, 0.33919071531119344],
        [-0.5408300221505175, -0.33919071531119344],
    ),
    (
        ["0.1", "0.15"],
        0.82,
        [0.8031334380542660019678, 1.137746966574271967852],
        1.5681935320024609337,
        [0.3357661721582632, 0.0],
        [1.3841665185716332, 0.0],
    ),
    (
        ["0.1", "0.15"],
        0.90,
        [-0.7233375583213999238589, 1.147842604057744526505],
        1.4390702680283405089,
        [0.549299624851421, 0.44247470331344957],
        [0.549299624851421, -0.44247470331344957],
    ),
    (
        ["0.05", "0.08"],
        0.60,
        [0.1250709775837252637639, 0.003522851278501599156193],
        0.1252090380185979773,
        [-0.40060499325970905, 0.6571913622102602],
        [-0.40060499325970905, -0.6571913622102602],
    ),
    (
        ["0.05", "0.08"],
        0.80,
        [0.8452862559414249198374, 1.268826631495507674824],
        1.7389652817683730903,
        [0.4600250252707774, 0.0],
        [1.4678155960283368, 0.0],
    ),
    (
        ["0.05", "0.08"],
        0.90,
        [0.4579385470959567086796, 0.113270566748632317066],
        0.4750890339139672883,
        [0.7418555648136249, 0.3936965866443119],
        [0.7418555648136249, -0.3936965866443119],
    ),
    (
        ["0.05", "0.08"],
        0.90,
        [-0.8737122177127030455364, 0.9823655028639180188192],
        1.389211191506642999,
        [0.7257485865177982, 0.4226531326605103],
        [0.7257485865177982, -0.4226531326605103],
    ),
    (
        ["0.02", "0.03"],
        0.75,
        [0.06857965603890780638741, 0.001765253478799856549587],
        0.068620049017423855532,
        [-0.45554947006389246, 0.7988789956796087],
        [-0.45554947006389246, -0.7988789956796087],
    ),
    (
        ["0.02", "0.03"],
        0.85,
        [0.7594976073505290613305, 1.160652451908896283345],
        1.5277505972561323741,
        [0.6822691251387183, 0.0],
        [1.2642656414894033, 0.0],
    ),
    (
        ["0.02", "0.03"],
        0.95,
        [0.3487124716100267749195, 0.07675203514150143034311],
        0.35799811084729333994,
        [0.9139069896809355, 0.2021677114997053],
        [0.9139069896809355, -0.2021677114997053],
    ),
    (
        ["0.02", "0.03"],
        0.95,
        [-0.7776382308254793195488, 0.5946655930088984759708],
        0.99992119984416896426,
        [0.9003725262783397, 0.2557871835801344],
        [0.9003725262783397, -0.2557871835801344],
    ),
    (
        ["0.2", "0.32"],
        0.5,
        [0.4297457617312298390469, 0.02906796483944310805135],
        0.43385086278486844706,
        [0.2657427024548519, 0.1018990100537547],
        [0.2657427024548519, -0.1018990100537547],
    ),
    (
        ["0.2", "0.32"],
        0.7,
        [0.7828782491793221664098, 1.46530954580476636644],
        2.0654077175251069367,
        [0.11430914113615165, 0.0],
        [1.4530327652219677, 0.0],
    ),
    (
        ["0.2", "0.32"],
        0.8,
        [-0.4530451630732710495229, 1.606471376609114318435],
        1.9004548343316144722,
        [0.22900392709420947, 0.394254711736197],
        [0.22900392709420947, -0.394254711736197],
    ),
];

/// c and a, the frequency, the state at phase zero, the amplitude, and the stability.
type Swing<'a> = ([&'a str; 2], f64, [f64; 2], f64, bool);

const SWINGS: &[Swing<'_>] = &[
    (["0.1", "0.1"], 1.7, [-0.767919776574117638428, -1.271521079330650028895], 1.7187670014305315187, true),
    (["0.1", "0.1"], 1.7, [1.211495614994511952683, 0.3816193833431185008326], 1.3125393346641914969, false),
    (["0.1", "0.1"], 1.8, [-0.57902232665710025038, -1.228941888972720935527], 1.5328524410011299453, true),
    (["0.1", "0.1"], 1.8, [0.7404872416231674103562, 0.205139315693098809059], 0.78336769192489513935, false),
    (["0.1", "0.1"], 1.9, [-0.4311348536699103005901, -1.128279026066411117392], 1.3244542926298063671, true),
    (["0.1", "0.1"], 2.0, [0.3082417299599877328096, 0.9701330672749820807767], 1.0834319329429958589, true),
    (["0.02", "0.05"], 1.5, [0.4867154938655824616566, 1.630963249685889466141], 2.0714591749043360817, true),
    (["0.02", "0.05"], 1.7, [0.2776585166113730077387, 1.451971722863670410902], 1.6830529559289389602, true),
    (["0.02", "0.05"], 1.8, [0.2052089969201143022414, 1.304833828025804495326], 1.4546712633286063787, true),
    (["0.1", "0.2"], 2.0, [0.2269707947733999434097, 1.345142912732096433202], 1.520966294262613471, true),
    (["0.1", "0.2"], 1.5, [1.62867066851328747563, 0.2471063785965295901876], 1.6813645998015728711, false),
    (
        ["0.1", "0.2"],
        1.7,
        [0.4389033224879698143674, 0.05407727079641837451009],
        0.44663185594188912175,
        false,
    ),
];

/// The motion at a frequency near a state that is known to three decimals.
fn point_near(equation: &Equation, frequency: f64, state: [f64; 2], drive_periods: u32) -> BranchPoint {
    let rough = state.map(|x| (x * 1e3).round() / 1e3);
    let options = ResponseOptions {
        start: Some(rough.to_vec()),
        at: Some(frequency),
        drive_periods,
        generations: 0,
        most_points: 3,
        ..ResponseOptions::default()
    };
    let range = [frequency, frequency + 0.01];
    let response = Response::over(equation, "w", range, &options, &Quiet).unwrap();
    let points = response.branches.iter().flat_map(|branch| branch.points.clone());
    let mut at = points.filter(|point| point.parameter.to_bits() == frequency.to_bits());
    at.next().unwrap_or_else(|| panic!("nothing at {frequency}"))
}

fn assert_state(point: &BranchPoint, state: [f64; 2], amplitude: f64) {
    for (computed, expected) in point.state.iter().zip(state) {
        let off = (computed - expected).abs();
        assert!(off <= 1e-12 && off <= point.error.max(2e-14), "{point:?} for {state:?}: off by {off:e}");
    }
    assert!((point.amplitude(0, true) - amplitude).abs() < 1e-12, "{point:?} for {amplitude}");
}

#[test]
fn points_of_the_driven_pendulum_have_their_states_and_multipliers() {
    for (values, w, state, amplitude, first, second) in DRIVEN {
        let pendulum = equation_with(PENDULUM, &[("c", values[0]), ("A", values[1])]);
        let point = point_near(&pendulum, *w, *state, 1);
        assert_state(&point, *state, *amplitude);
        for expected in [first, second] {
            let off = |number: &libration::algebra::Complex| {
                libm::hypot(number.re - expected[0], number.im - expected[1])
            };
            let nearest = point.multipliers.iter().map(off).fold(f64::INFINITY, f64::min);
            assert!(nearest < 2e-12, "{expected:?} in {:?}", point.multipliers);
        }
        assert_eq!(
            point.is_stable(),
            libm::hypot(second[0], second[1]).max(libm::hypot(first[0], first[1])) < 1.0
        );
    }
}

#[test]
fn swings_of_the_pendulum_on_a_moving_pivot_have_their_states() {
    for (values, w, state, amplitude, stable) in SWINGS {
        let pivot = equation_with(PIVOT, &[("c", values[0]), ("a", values[1])]);
        let point = point_near(&pivot, *w, *state, 2);
        assert_state(&point, *state, *amplitude);
        assert_eq!(point.is_stable(), *stable, "{point:?}");
    }
}

/// Asserts that a special point is at its expected value, to 12 digits and within its error.
fn assert_special(equation: &Equation, parameter: &str, start: [f64; 2], kind: SpecialKind, expected: f64) {
    let range = [0.97 * expected, 1.03 * expected];
    let options = ResponseOptions {
        start: Some(start.to_vec()),
        at: Some(0.999 * expected),
        generations: 0,
        ..ResponseOptions::default()
    };
    let response = Response::over(equation, parameter, range, &options, &Quiet).unwrap();
    let special =
        response.branches.iter().flat_map(|branch| &branch.special).filter(|special| special.kind == kind);
    let off = |parameter: f64| (parameter - expected).abs();
    let nearest = special.min_by(|a, b| off(a.point.parameter).total_cmp(&off(b.point.parameter)));
    let nearest = nearest.unwrap_or_else(|| panic!("no {kind} at {expected}"));
    let computed = nearest.point.parameter;
    assert!(
        off(computed) <= 1e-12 * expected && off(computed) <= nearest.error.max(2e-13 * expected),
        "{kind} at {computed:?} ± {:e} for {expected:?}",
        nearest.error
    );
}

#[test]
fn further_folds_and_losses_of_symmetry_are_exact() {
    use SpecialKind::{Fold, SymmetryBreaking};
    for (values, parameter, start, kind, expected) in [
        ([("c", "0.05"), ("A", "0.08")], "w", [0.653, 0.263], Fold, 0.914059678144804115227226),
        ([("c", "0.1"), ("w", "0.8")], "A", [0.999, 0.267], Fold, 0.255190315515798797526048),
        ([("c", "0.05"), ("w", "0.85")], "A", [0.876, 0.17], Fold, 0.1665757435471294898163594),
        ([("c", "0.1"), ("w", "0.8")], "A", [-2.541, 0.431], SymmetryBreaking, 0.8313728241194022479976947),
        ([("c", "0.05"), ("w", "0.85")], "A", [-2.574, 0.202], SymmetryBreaking, 0.9904648158858902725871148),
    ] {
        assert_special(&equation_with(PENDULUM, &values), parameter, start, kind, expected);
    }
    let strong = equation_with(DUFFING, &[("c", "0.1"), ("b", "1"), ("F", "1")]);
    assert_special(&strong, "w", [-0.056, 8.749], Fold, 3.039054720421332215233475);
    for (mu, f, start, expected) in [
        ("0.1", "0.05", [-1.947, -0.241], 1.011950453981722751644733),
        ("0.5", "0.1", [-1.986, 0.032], 1.010141301474202509810812),
    ] {
        assert_special(&equation_with(VAN_DER_POL, &[("mu", mu), ("F", f)]), "w", start, Fold, expected);
    }
    // The other end of the entrainment range lies beyond the other value.
    let relaxed = equation_with(VAN_DER_POL, &[("mu", "1"), ("F", "0.2")]);
    let options = ResponseOptions {
        start: Some(vec![-1.974, 0.199]),
        at: Some(0.99),
        generations: 0,
        ..ResponseOptions::default()
    };
    let response = Response::over(&relaxed, "w", [0.85, 1.0], &options, &Quiet).unwrap();
    let folds =
        response.branches.iter().flat_map(|branch| &branch.special).filter(|special| special.kind == Fold);
    let offs = folds.map(|fold| (fold.point.parameter - 0.9955703586630364856476981).abs());
    assert!(offs.fold(f64::INFINITY, f64::min) < 1e-12);
}

#[test]
fn a_motion_of_two_hundred_harmonics_is_exact() {
    // Pulses: the drive has the harmonics exp(-500)*I_k(500), the response these divided by 1 - k²w² + ikw/2; summed in mpmath to 40 digits.
    let pulses = equation_with("x'' = -x'/2 - x + exp(500*(cos(w*t) - 1))", &[]);
    let point = point_near(&pulses, 0.3, [0.0231, 0.1741], 1);
    for (computed, expected) in point.state.iter().zip([0.02309985491357088725345, 0.1741238350746010008378])
    {
        let off = (computed - expected).abs();
        assert!(off < 1e-13 && off <= point.error, "{computed:?} ± {:e} for {expected:?}", point.error);
    }
}

#[test]
fn strong_damping_leaves_multipliers_below_rounding_and_no_special_point() {
    // A linear equation, so that amplitude and both multipliers are known: exp((-5 ± √24)·2π/w), the second below 1e-90.
    let damped = equation_with("x'' = -10*x' - x + cos(w*t)", &[]);
    let response = Response::over(&damped, "w", [0.2, 0.3], &ResponseOptions::default(), &Quiet).unwrap();
    let [branch] = &response.branches[..] else { panic!("{} branches", response.branches.len()) };
    assert!(branch.special.is_empty(), "{:?}", branch.special);
    for point in &branch.points {
        let w = point.parameter;
        let amplitude = 1.0 / libm::hypot(1.0 - w * w, 10.0 * w);
        assert!(point.is_stable() && (point.amplitude(0, false) - amplitude).abs() < 1e-14, "{point:?}");
        let slow = libm::exp((libm::sqrt(24.0) - 5.0) * std::f64::consts::TAU / w);
        let [first, second] = &point.multipliers[..] else { panic!("{:?}", point.multipliers) };
        assert!((first.re - slow).abs() < 1e-13 && first.im.abs() < 1e-300, "{first:?} for {slow}");
        assert!(second.abs() < 1e-13 * slow, "{second:?}");
    }
}

/// x″ = 4x + m + 10·cos ωt + s·cos 2ωt has the motion −10·cos(ωt)/(4 + ω²) − s·cos(2ωt)/(4 + 4ω²) − m/4, about which deviations grow by e^(4π/ω), up
/// to 4e13 in a period. Growth of more than 5e9 is checked piece by piece, with a mirror about zero or −m/4, and without one.
#[test]
fn a_motion_that_no_single_integration_closes_is_followed() {
    for [mean, second] in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]] {
        let start_of = |w: f64| -10.0 / (4.0 + w * w) - second / (4.0 + 4.0 * w * w) - mean / 4.0;
        let start = Some(vec![start_of(0.75), 0.0]);
        let options = ResponseOptions { start, at: Some(0.75), ..ResponseOptions::default() };
        let equation = format!("x'' = 4*x + {mean} + 10*cos(w*t) + {second}*cos(2*w*t)").parse().unwrap();
        let response = Response::over(&equation, "w", [0.4, 0.9], &options, &Quiet).unwrap();
        let branch = &response.branches[0];
        assert_eq!((branch.beginning, branch.ending), (Ending::RangeEnd, Ending::RangeEnd));
        assert_eq!(branch.space.mirrored, second == 0.0);
        for point in &branch.points {
            let off = (point.state[0] - start_of(point.parameter)).abs().max(point.state[1].abs());
            assert!(off <= point.error && point.error < 1e-10, "{off:e} {point:?}");
            assert!(!point.is_stable());
        }
    }
}

#[test]
fn a_branch_under_dry_friction_passes_the_change_of_the_number_of_stops() {
    for equation in
        ["x'' + 0.5*x' + x + 0.3*sign(x') = 0.5*cos(w*t)", "x'' + 0.1*x' + x + 0.3*sign(x') = 0.5*cos(w*t)"]
    {
        let response =
            Response::over(&equation.parse().unwrap(), "w", [0.2, 2.0], &ResponseOptions::default(), &Quiet)
                .unwrap();
        assert_eq!(response.branches.len(), 1, "{equation}");
        let branch = &response.branches[0];
        assert_eq!([branch.beginning, branch.ending], [Ending::RangeEnd; 2], "{equation}");
    }
}
