//! Individual tolerances of coordinates.

use libm::{cos, sin};
use libration::progress::Quiet;
use libration::taylor::{
    Effort, Event, Solution, System, ToleranceError, Trajectory, ending_error, integrate, integrate_many,
};

const EFFORT: Effort = Effort::to_tolerance(1e-13);

fn system(equations: &str, tolerances: &[(&str, f64)]) -> System {
    System::new(&equations.parse().unwrap()).unwrap().with_tolerances(tolerances).unwrap()
}

fn solve(system: &System, start: &[(&str, f64)], times: &[f64]) -> Solution {
    integrate(system, &system.start(start).unwrap(), times, &EFFORT, &Quiet).unwrap()
}

/// A slow oscillator and a fast one, which are not coupled.
const TWO: &str = "x'' = -x; y'' = -900*y";

fn errors(solution: &Solution) -> [f64; 4] {
    let (t, state) = (solution.end.time, &solution.end.state);
    let exact = [cos(t), cos(30.0 * t), -sin(t), -30.0 * sin(30.0 * t)];
    [0, 1, 2, 3].map(|n| (state[n] - exact[n]).abs())
}

#[test]
fn one_tolerance_for_all_is_bit_for_bit_that_of_the_effort() {
    let equations = "x'' = -x + y/8; y' = -y + x*x'*abs(y - x)";
    let times: Vec<f64> = (0..40).map(f64::from).collect();
    let start = [("x", 1.0), ("y", -0.25)];
    let plain = solve(&system(equations, &[]), &start, &times);
    assert_eq!(solve(&system(equations, &[("y", 1e-13), ("x", 1e-13)]), &start, &times), plain);
    assert_eq!(solve(&system(equations, &[("y", 1e-13)]), &start, &times), plain);
    assert_ne!(solve(&system(equations, &[("y", 1e-12)]), &start, &times), plain);
}

#[test]
fn each_coordinate_has_the_error_that_it_is_allowed_and_steps_are_spared() {
    let start = [("x", 1.0), ("y", 1.0)];
    let all = solve(&system(TWO, &[]), &start, &[30.0]);
    let mut steps = all.steps;
    for tolerance in [1e-10, 1e-7, 1e-4] {
        let solution = solve(&system(TWO, &[("y", tolerance)]), &start, &[30.0]);
        let off = errors(&solution);
        // The allowed error of each step is its tolerance; in a velocity it is relative to the largest velocity, 30.
        let bound = f64::from(u32::try_from(solution.steps).unwrap()) * tolerance;
        assert!(off[0] < 1e-12 && off[2] < 1e-12, "{tolerance}: {off:?}");
        assert!(off[1] < bound && off[3] < 30.0 * bound, "{tolerance}: {off:?}, {bound}");
        assert!(off[1] > 1e-4 * tolerance, "{tolerance} is not made use of: {off:?}");
        assert!(solution.steps < steps, "{tolerance}: {} of {steps}", solution.steps);
        steps = solution.steps;
    }
    assert!(3 * steps < 2 * all.steps, "{steps} of {}", all.steps);
}

/// The smaller of the two tolerances holds, whichever it is.
#[test]
fn a_tolerance_below_that_of_the_effort_holds_too() {
    let fine = system(TWO, &[("x", 1e-16), ("y", 1e-16)]);
    let coarse = Effort::to_tolerance(1e-5);
    let start = fine.start(&[("x", 1.0), ("y", 1.0)]).unwrap();
    let by = |effort: &Effort| integrate(&fine, &start, &[10.0], effort, &Quiet).unwrap();
    assert_eq!(by(&coarse), by(&Effort::to_tolerance(1e-16)));
    let only_fast = system(TWO, &[("y", 1e-16)]);
    let off = errors(&integrate(&only_fast, &start, &[10.0], &coarse, &Quiet).unwrap());
    assert!(off.iter().all(|error| *error < 1e-11), "{off:?}");
}

#[test]
fn motions_side_by_side_are_those_alone() {
    let system = system("x'' = -sin(x) + y/100; y' = -y + cos(9*x)", &[("y", 1e-5)]);
    let times = [5.0, 50.0];
    let start = |n: u32| system.start(&[("x", 0.3 * f64::from(n)), ("y", 1.0)]).unwrap();
    let trajectory = |n| Trajectory { start: start(n), parameters: vec![], times: &times };
    let trajectories: Vec<Trajectory<'_>> = (1..=11).map(trajectory).collect();
    let alone: Vec<_> =
        trajectories.iter().map(|trajectory| trajectory.integrate(&system, &EFFORT, &Quiet)).collect();
    assert_eq!(integrate_many(&system, &trajectories, &EFFORT, &Quiet), alone);
}

/// The value of x determines the end of the motion, and y has an error of another size there.
#[test]
fn the_error_of_an_end_knows_the_tolerances() {
    let passage = Event { ends_at: Some(1), ..Event::zero_of("x - 10".parse().unwrap()) };
    let system = system("x' = 1; y'' = -900*y", &[("y", 1e-2)]).with_events(&[passage]).unwrap();
    let start = system.start(&[("y", 1.0)]).unwrap();
    let end = integrate(&system, &start, &[100.0], &EFFORT, &Quiet).unwrap().end;
    let error = ending_error(&system, &start, 100.0, &EFFORT, &end).unwrap();
    let missed = (end.state[1] - cos(300.0)).abs();
    assert!(missed > 1e-9 && missed <= error.state[1], "{missed} {}", error.state[1]);
}

/// sin(y)/y is removable at zero, whatever the tolerance there.
#[test]
fn removable_singularities_are_passed() {
    let system = system("x'' = -x; y' = sin(y)/y + 1", &[("y", 1e-6)]);
    let solution = solve(&system, &[("x", 1.0), ("y", -3.0)], &[5.0]);
    assert!((solution.end.state[0] - cos(5.0)).abs() < 1e-12 && solution.end.state[1] > 3.0);
}

#[test]
fn tolerances_that_cannot_be_are_refused() {
    let refused = |tolerances: &[(&str, f64)]| {
        System::new(&TWO.parse().unwrap()).unwrap().with_tolerances(tolerances).unwrap_err()
    };
    assert_eq!(refused(&[("x'", 1e-9)]).to_string(), "the system has no coordinate `x'`: it has x, y");
    assert_eq!(refused(&[("x", 1e-9), ("x", 1e-9)]), ToleranceError::Twice("x".to_owned()));
    for relative in [0.0, -1e-9, 1e-19, 0.2, f64::NAN, f64::INFINITY] {
        assert!(matches!(refused(&[("y", relative)]), ToleranceError::OutOfRange { .. }), "{relative}");
    }
}

/// A coordinate of a small motion about 2 begins to turn: two equal terms cancel in its rate of change, whose rounding is its error.
#[test]
fn a_small_motion_that_turns_takes_few_steps_in_any_order_of_the_equations() {
    let rates = ["y' = 2.000000002729829*x - x^2*y", "x' = 1 - 3.000000002729829*x + x^2*y"];
    for equations in [rates, [rates[1], rates[0]]] {
        let system = System::new(&equations.join("; ").parse().unwrap()).unwrap();
        let start = system.start(&[("y", 2.0000879906149276), ("x", 0.9999560071101364)]).unwrap();
        let effort = Effort::to_tolerance(1e-17);
        let solution = integrate(&system, &start, &[1.0], &effort, &Quiet).unwrap();
        assert!(solution.steps < 100, "{equations:?}: {} steps", solution.steps);
    }
}
