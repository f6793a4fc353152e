//! Branches of random driven oscillators compared with an independent Runge–Kutta integration: every point closes over its full period and has
//! the stability of its deviations, and no step between two points skips a change of stability.
//!
//! By default ten oscillators of each kind; in the full run two hundred parametrons and a hundred of each other kind.

use libration::algebra::Complex;
use libration::continuation::{Branch, BranchPoint, Ending, Response, ResponseOptions};
use libration::expression::Equation;
use libration::orbit::Stability;
use libration::progress::Quiet;
use libration_motion::internals::periodic::{Flow, multiplier_errors};
use libration_numbers::internals::linear::eigenvalues;
use libration_testing::random::Random;
use libration_testing::sweep;
use std::f64::consts::TAU;

/// Number of steps per period of the drive.
const STEPS: u32 = 600;

/// An oscillator x″ = f(t, x, x′; w) whose period is 2π/w times `beat`.
struct Oscillator {
    text: String,
    force: Box<dyn Fn(f64, [f64; 2], f64) -> f64>,
    range: [f64; 2],
    /// The drive frequency divided by the parameter.
    beat: f64,
    /// Positions of the kinks of the force.
    kinks: Vec<f64>,
}

impl Oscillator {
    fn response(&self) -> Response {
        let equation: Equation = self.text.parse().unwrap();
        let response = Response::over(&equation, "w", self.range, &ResponseOptions::default(), &Quiet);
        response.unwrap_or_else(|error| panic!("{}: {error}", self.text))
    }

    /// The state after a number of drive periods from t = 0, by the classical Runge–Kutta method.
    fn after(&self, state: [f64; 2], w: f64, periods: u32) -> [f64; 2] {
        self.followed(state, w, periods * STEPS)
    }

    fn followed(&self, state: [f64; 2], w: f64, steps: u32) -> [f64; 2] {
        let step = TAU / (self.beat * w) / f64::from(STEPS);
        (0..steps).fold(state, |state, number| self.step(state, w, step * f64::from(number), step))
    }

    /// About the state after a number of drive periods, by few steps.
    fn roughly_after(&self, state: [f64; 2], w: f64, periods: u32) -> [f64; 2] {
        const FEW: u32 = 40;
        let step = TAU / (self.beat * w) / f64::from(FEW);
        (0..periods * FEW)
            .fold(state, |state, step_number| self.smooth_step(state, w, step * f64::from(step_number), step))
    }

    /// One step, or two if a kink of the force lies between its ends: across
    /// a kink the error of the method and of differences is of first order.
    fn step(&self, state: [f64; 2], w: f64, t: f64, step: f64) -> [f64; 2] {
        let end = self.smooth_step(state, w, t, step);
        let crosses = |kink: &&f64| (state[0] - **kink) * (end[0] - **kink) < 0.0;
        let Some(kink) = self.kinks.iter().find(crosses) else { return end };
        let is_before =
            |part: f64| (self.smooth_step(state, w, t, part * step)[0] - kink) * (state[0] - kink) > 0.0;
        let (mut before, mut after) = (0.0, 1.0);
        while after - before > 1e-12 {
            let middle = 0.5 * (before + after);
            if is_before(middle) { before = middle } else { after = middle }
        }
        let [_, v] = self.smooth_step(state, w, t, after * step);
        self.smooth_step([*kink, v], w, t + after * step, (1.0 - after) * step)
    }

    fn smooth_step(&self, state: [f64; 2], w: f64, t: f64, step: f64) -> [f64; 2] {
        let slope = |t: f64, [x, v]: [f64; 2]| [v, (self.force)(t, [x, v], w)];
        let moved = |[x, v]: [f64; 2], [dx, dv]: [f64; 2], by: f64| [x + by * dx, v + by * dv];
        let a = slope(t, state);
        let b = slope(t + 0.5 * step, moved(state, a, 0.5 * step));
        let c = slope(t + 0.5 * step, moved(state, b, 0.5 * step));
        let d = slope(t + step, moved(state, c, step));
        let mean = |i: usize| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0;
        moved(state, [mean(0), mean(1)], step)
    }

    /// The map over a number of drive periods, with its derivatives by differences.
    fn map(&self, state: [f64; 2], w: f64, periods: u32) -> ([f64; 2], [[f64; 2]; 2]) {
        let aside = 1e-6 * (1.0 + state[0].abs().max(state[1].abs()));
        let ends = [[aside, 0.0], [-aside, 0.0], [0.0, aside], [0.0, -aside]]
            .map(|[dx, dv]| self.after([state[0] + dx, state[1] + dv], w, periods));
        let slope = |i: usize, j: usize| (ends[2 * j][i] - ends[2 * j + 1][i]) / (2.0 * aside);
        (self.after(state, w, periods), [[slope(0, 0), slope(0, 1)], [slope(1, 0), slope(1, 1)]])
    }

    /// The periodic motion near a state, by Newton's method, with the magnitude of its largest multiplier.
    fn periodic(&self, mut state: [f64; 2], w: f64, periods: u32) -> Option<([f64; 2], f64)> {
        for _ in 0..8 {
            let (end, [[a, b], [c, d]]) = self.map(state, w, periods);
            let (r, s) = (end[0] - state[0], end[1] - state[1]);
            let determinant = (a - 1.0) * (d - 1.0) - b * c;
            let change = [-((d - 1.0) * r - b * s) / determinant, -((a - 1.0) * s - c * r) / determinant];
            state = [state[0] + change[0], state[1] + change[1]];
            if change[0].abs().max(change[1].abs()) < 1e-9 * (1.0 + state[0].abs()) {
                return Some((state, largest([[a, b], [c, d]])));
            }
        }
        None
    }
}

/// The magnitude of the largest eigenvalue.
fn largest([[a, b], [c, d]]: [[f64; 2]; 2]) -> f64 {
    let (half, determinant) = (0.5 * (a + d), a * d - b * c);
    let square = half * half - determinant;
    if square > 0.0 { half.abs() + square.sqrt() } else { determinant.sqrt() }
}

/// Error of a multiplier from the Runge–Kutta method and its differences.
const OPEN: f64 = 1e-4;

fn check_points(oscillator: &Oscillator, branch: &Branch) {
    let periods = branch.space.drive_periods();
    for point in branch.points.iter().step_by(3) {
        let state = [point.state[0], point.state[1]];
        let (end, map) = oscillator.map(state, point.parameter, periods);
        let growth = largest(map);
        let off = (end[0] - state[0]).abs().max((end[1] - state[1]).abs());
        let size = 1.0 + state[0].abs().max(state[1].abs());
        let label = format!("{} at w = {:?}", oscillator.text, point.parameter);
        assert!(off <= 1e-5 * size * growth.max(1.0), "{label} misses its start by {off:e}");
        // Next to a motion that grazes a kink the multipliers change within the differences of the starts.
        let is_open = || {
            let beside = [2e-6, -2e-6].map(|aside| [state[0] + aside * size, state[1]]);
            let others = beside.map(|state| largest(oscillator.map(state, point.parameter, periods).1));
            others.iter().any(|other| (growth - 1.0).abs() <= (growth - other).abs())
        };
        if (growth - 1.0).abs() > OPEN && !is_open() {
            assert_eq!(point.is_stable(), growth < 1.0, "{label}: the largest multiplier is {growth}");
        }
    }
}

/// Checks that between two points without a special point the stability does not change.
fn check_steps(oscillator: &Oscillator, branch: &Branch) {
    let periods = branch.space.drive_periods();
    for (number, pair) in branch.points.windows(2).enumerate() {
        let [a, b] = [&pair[0], &pair[1]];
        let is_left_out = |range: &[f64; 2]| {
            let [low, high] = [a.parameter.min(b.parameter), a.parameter.max(b.parameter)];
            low < range[1] && range[0] < high
        };
        let has_special = branch.special.iter().any(|special| special.before == number + 1);
        // At a branch point a multiplier is on the unit circle.
        let leaves = number == 0 && branch.beginning == Ending::BranchPoint;
        // At the end of a branch on another one a multiplier is on the unit circle within its error.
        let is_end = number == 0 || number + 2 == branch.points.len();
        let is_open = is_end && [a, b].iter().any(|point| point.stability == Stability::Undetermined);
        if leaves || is_open || has_special || branch.unresolved.iter().any(is_left_out) {
            continue;
        }
        assert_eq!(
            a.is_stable(),
            b.is_stable(),
            "{} from w = {:?} to {:?}",
            oscillator.text,
            a.parameter,
            b.parameter
        );
        for part in [0.25, 0.5, 0.75] {
            check_between(oscillator, [a, b], part, periods);
        }
    }
}

fn check_between(oscillator: &Oscillator, [a, b]: [&BranchPoint; 2], part: f64, periods: u32) {
    let mean = |x: f64, y: f64| x + part * (y - x);
    let guess = [0, 1].map(|i| mean(a.state[i], b.state[i]));
    let w = mean(a.parameter, b.parameter);
    let Some((state, growth)) = oscillator.periodic(guess, w, periods) else { return };
    // A branch whose steps turn by at most a third of a radian is this near to its chord.
    let far = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).abs().max((p[1] - q[1]).abs());
    let chord = far([a.state[0], a.state[1]], [b.state[0], b.state[1]]);
    let is_other_motion = far(state, guess) > 1e-6 + 0.1 * chord;
    if !is_other_motion && (growth - 1.0).abs() > OPEN {
        assert_eq!(
            a.is_stable(),
            growth < 1.0,
            "{} at w = {w:?}: {state:?} has the largest multiplier {growth}; expected near {guess:?}, {periods} periods, {:?} {:?}",
            oscillator.text,
            a.multipliers,
            b.multipliers
        );
    }
}

/// Checks that a stable motion of one or two periods to which motions from several starts settle lies on a followed branch and is stable there.
fn check_settled(oscillator: &Oscillator, response: &Response, w: f64, random: &mut Random) {
    let start = [random.between(-1.5, 1.5), random.between(-1.5, 1.5)];
    let state = oscillator.after(start, w, 400);
    if state[0].is_nan() || state[0].abs() > 1e3 {
        return;
    }
    let returned = |periods: u32| {
        let end = oscillator.after(state, w, periods);
        (end[0] - state[0]).abs().max((end[1] - state[1]).abs()) < 1e-6
    };
    let Some(periods) = [1, 2].into_iter().find(|periods| returned(*periods)) else { return };
    let Some((_, growth)) = oscillator.periodic(state, w, periods) else { return };
    // Another phase of a motion with twice the period, or the mirror image of one without symmetry, is on the same branch.
    let mirrored = |state: [f64; 2]| oscillator.followed(state, w, STEPS / 2).map(|x| -x);
    let other = oscillator.after(state, w, 1);
    let copies = [state, other, mirrored(state), mirrored(other)];
    let passes = |branch: &Branch, is_counted: &dyn Fn(&BranchPoint) -> bool| {
        branch.points.windows(2).any(|pair| {
            let [a, b] = [&pair[0], &pair[1]];
            let part = (w - a.parameter) / (b.parameter - a.parameter);
            let is_near = |copy: &[f64; 2]| {
                (0..2).all(|i| {
                    let mean = a.state[i] + part * (b.state[i] - a.state[i]);
                    (mean - copy[i]).abs() < 0.01 + 0.3 * (a.state[i] - b.state[i]).abs()
                })
            };
            (0.0..=1.0).contains(&part) && (is_counted(a) || is_counted(b)) && copies.iter().any(is_near)
        })
    };
    let is_on = |is_counted: &dyn Fn(&BranchPoint) -> bool| {
        response.branches.iter().any(|branch| passes(branch, is_counted))
    };
    if growth < 1.0 - OPEN && is_on(&|_| true) {
        let label = &oscillator.text;
        assert!(
            is_on(&|point| point.is_stable()),
            "{label} at w = {w:?} settles to {state:?}, called unstable"
        );
    }
}

fn check(oscillator: &Oscillator, random: &mut Random) {
    let response = oscillator.response();
    for branch in &response.branches {
        check_points(oscillator, branch);
        check_steps(oscillator, branch);
    }
    let [low, high] = oscillator.range;
    let unresolved: f64 =
        response.branches.iter().flat_map(|branch| &branch.unresolved).map(|[a, b]| b - a).sum();
    assert!(
        unresolved <= 0.01 * (high - low),
        "{}: {unresolved} of the range is unresolved",
        oscillator.text
    );
    for number in 0..sweep::number(4, 24) {
        let part = (f64::from(number) + 0.5) / f64::from(sweep::number(4, 24));
        check_settled(oscillator, &response, low + part * (high - low), random);
    }
}

fn parametron(random: &mut Random) -> Oscillator {
    let damping = random.between(0.002, 0.02);
    let modulation = random.between(2.2 * 2.0 * damping, 0.12);
    Oscillator {
        text: format!("x'' + {damping:?}*x' + (1 - {modulation:?}*cos(2*w*t))*x + x^3 = 0"),
        force: Box::new(move |t, [x, v], w| {
            -damping * v - (1.0 - modulation * libm::cos(2.0 * w * t)) * x - x * x * x
        }),
        range: [0.95, 1.05],
        beat: 2.0,
        kinks: vec![],
    }
}

fn clearance(random: &mut Random) -> Oscillator {
    let [damping, stiffness, drive] =
        [(0.08, 0.3), (0.2, 4.0), (0.1, 0.6)].map(|(a, b)| random.between(a, b));
    let [gap, other] = [random.between(0.05, 0.8), random.between(0.05, 0.8)];
    let is_two_sided = random.below(2) == 0;
    let spring = format!("{stiffness:?}*max(x - {gap:?}, 0)");
    let second =
        if is_two_sided { format!(" - {stiffness:?}*max(-x - {other:?}, 0)") } else { String::new() };
    Oscillator {
        text: format!("x'' + {damping:?}*x' + x + {spring}{second} = {drive:?}*cos(w*t)"),
        force: Box::new(move |t, [x, v], w| {
            let back = if is_two_sided { stiffness * (-x - other).max(0.0) } else { 0.0 };
            drive * libm::cos(w * t) - damping * v - x - stiffness * (x - gap).max(0.0) + back
        }),
        range: [0.6, 2.0],
        beat: 1.0,
        kinks: if is_two_sided { vec![gap, -other] } else { vec![gap] },
    }
}

fn smooth(random: &mut Random) -> Oscillator {
    let [damping, square, cube, drive] =
        [(0.05, 0.3), (-0.4, 0.4), (0.1, 1.0), (0.05, 0.5)].map(|(a, b)| random.between(a, b));
    Oscillator {
        text: format!("x'' + {damping:?}*x' + x + ({square:?})*x^2 + {cube:?}*x^3 = {drive:?}*cos(w*t)"),
        force: Box::new(move |t, [x, v], w| {
            drive * libm::cos(w * t) - damping * v - x - square * x * x - cube * x * x * x
        }),
        range: [0.6, 2.0],
        beat: 1.0,
        kinks: vec![],
    }
}

#[test]
fn parametrons_have_the_tongues_and_motions_of_a_sweep_by_brute_force() {
    let mut random = Random::seeded(sweep::seed(35_001));
    (0..sweep::number(10, 200)).for_each(|_| check(&parametron(&mut random), &mut random));
}

#[test]
fn clearance_oscillators_have_the_motions_of_a_sweep_by_brute_force() {
    let mut random = Random::seeded(sweep::seed(35_002));
    (0..sweep::number(10, 100)).for_each(|_| check(&clearance(&mut random), &mut random));
}

#[test]
fn a_branch_next_to_its_end_does_not_go_on_as_the_other_one() {
    // From the doubling at 0.934 the motions of four periods lead to the doubling at 0.968, where the branch once went on with motions of two.
    let [damping, stiffness, drive] = [0.0812, 2.961, 0.29467];
    let kinks = vec![0.3684, -0.05657];
    let oscillator = Oscillator {
        text: format!(
            "x'' + {damping}*x' + x + {stiffness}*max(x - 0.3684, 0) - {stiffness}*max(-x - 0.05657, 0) = {drive}*cos(w*t)"
        ),
        force: Box::new(move |t, [x, v], w| {
            let back = stiffness * (-x - 0.05657).max(0.0);
            drive * libm::cos(w * t) - damping * v - x - stiffness * (x - 0.3684).max(0.0) + back
        }),
        range: [0.6, 2.0],
        beat: 1.0,
        kinks,
    };
    let response = oscillator.response();
    let fourfold: Vec<&Branch> =
        response.branches.iter().filter(|branch| branch.space.drive_periods() == 4).collect();
    assert!(!fourfold.is_empty());
    for branch in fourfold {
        check_steps(&oscillator, branch);
        for point in &branch.points[1..branch.points.len() - 1] {
            let state = [point.state[0], point.state[1]];
            let half = oscillator.after(state, point.parameter, 2);
            let apart = (half[0] - state[0]).abs().max((half[1] - state[1]).abs());
            assert!(apart > 1e-5, "at w = {:?} the motion closes after two periods", point.parameter);
        }
    }
}

#[test]
fn smooth_oscillators_have_the_motions_of_a_sweep_by_brute_force() {
    let mut random = Random::seeded(sweep::seed(35_003));
    (0..sweep::number(10, 100)).for_each(|_| check(&smooth(&mut random), &mut random));
}

/// The motions with the period of the drive, or with twice this period, to which motions from a grid of starts settle by integration.
fn settled(oscillator: &Oscillator, w: f64, reach: f64) -> Vec<([f64; 2], u32)> {
    const SIDE: i32 = 2;
    let grid = (-SIDE..=SIDE).flat_map(|i| (-SIDE..=SIDE).map(move |j| [i, j]));
    let mut motions: Vec<([f64; 2], u32)> = vec![];
    for start in grid.map(|grid| grid.map(|k| reach * f64::from(k) / f64::from(SIDE))) {
        let state = oscillator.roughly_after([start[0], start[1] * w], w, 150);
        let motion = [1, 2].into_iter().find_map(|periods| {
            let (closed, growth) = oscillator.periodic(state, w, periods)?;
            let near = (0..2).all(|i| (closed[i] - state[i]).abs() < 0.05 * (1.0 + closed[0].abs()));
            (near && growth < 1.0 - OPEN).then_some((closed, periods))
        });
        let is_new = |(a, _): &([f64; 2], u32)| {
            motions.iter().all(|(b, _)| (0..2).any(|i| (a[i] - b[i]).abs() > 1e-5 * (1.0 + b[0].abs())))
        };
        motions.extend(motion.filter(is_new));
    }
    motions
}

/// The distance of a motion from the nearest end of a branch at a value, over all copies of the motion.
fn distance(oscillator: &Oscillator, response: &Response, w: f64, state: [f64; 2]) -> f64 {
    let mirrored = |state: [f64; 2]| oscillator.followed(state, w, STEPS / 2).map(|x| -x);
    let other = oscillator.after(state, w, 1);
    let copies = [state, other, mirrored(state), mirrored(other), state.map(|x| -x), other.map(|x| -x)];
    let ends = response.branches.iter().flat_map(|branch| [branch.points.first(), branch.points.last()]);
    let ends = ends.flatten().filter(|point| point.parameter.to_bits() == w.to_bits() && point.is_stable());
    let is_angle = oscillator.text.contains("sin(x)");
    let turned = |x: f64| if is_angle { x - TAU * (x / TAU).round() } else { x };
    let off = |point: &BranchPoint| {
        copies.map(|copy| turned(copy[0] - point.state[0]).abs().max((copy[1] - point.state[1]).abs()))
    };
    ends.flat_map(off).fold(f64::INFINITY, f64::min)
}

/// The number of attracting motions of random oscillators at the ends of their ranges, and of those that are on no branch.
fn number_missed(
    random: &mut Random,
    kind: fn(&mut Random) -> Oscillator,
    [usual, full]: [u32; 2],
    [reach, most_periods]: [f64; 2],
) -> [usize; 2] {
    let (mut all, mut missed) = (0, 0);
    for _ in 0..sweep::number(usual, full) {
        let oscillator = kind(random);
        let response = oscillator.response();
        for w in oscillator.range {
            for (state, _) in
                settled(&oscillator, w, reach).iter().filter(|motion| f64::from(motion.1) <= most_periods)
            {
                all += 1;
                let off = distance(&oscillator, &response, w, *state);
                if off > 1e-4 {
                    missed += 1;
                    eprintln!("{} at w = {w}: {state:?} is {off} from all branches", oscillator.text);
                }
            }
        }
    }
    [all, missed]
}

/// The motions to which a grid of starts settles: of the period of the drive; of parametrons also of twice this period.
#[test]
fn attracting_motions_at_the_ends_of_the_range_are_followed_sweep() {
    let mut random = Random::seeded(sweep::seed(35_009));
    type Kind = fn(&mut Random) -> Oscillator;
    let kinds: [(Kind, [f64; 2]); 5] = [
        (hardening, [6.0, 1.0]),
        (pendulum, [3.0, 1.0]),
        (smooth, [3.0, 1.0]),
        (clearance, [4.0, 1.0]),
        (tongue, [1.5, 2.0]),
    ];
    for (kind, extent) in kinds {
        let [all, missed] = number_missed(&mut random, kind, [4, 40], extent);
        assert!(missed == 0 && all > 0, "{missed} of {all} are missed");
    }
    // Large motions in one well and near the separatrix have many harmonics: of 573 motions of 160 oscillators, 13 were missed.
    let [all, missed] = number_missed(&mut random, wells, [4, 40], [3.0, 1.0]);
    assert!(8 * missed <= all, "{missed} of {all} are missed");
}

/// A motion about each well, by integration from a grid of starts, where the balance of a mean and one harmonic has no solution about a well.
#[test]
fn motions_beyond_the_fold_of_one_harmonic_are_followed() {
    let wells = cubic(&mut Random::seeded(1), [0.1786, -1.0, 1.0, 0.1994], [1.0, 1.1]);
    let oscillator = Oscillator { range: [1.033, 1.1], ..wells };
    let response = oscillator.response();
    let motions = settled(&oscillator, 1.033, 3.0);
    assert_eq!(motions.iter().map(|motion| motion.1).collect::<Vec<_>>(), [1, 1]);
    for (state, _) in motions {
        let off = distance(&oscillator, &response, 1.033, state);
        assert!(off < 1e-4, "{state:?} is {off} from all branches");
    }
}

/// Two driven oscillators x, y with velocities u, v, whose motions have mirror images half a period later.
struct Pair {
    text: &'static str,
    rate: fn(f64, [f64; 4], f64) -> [f64; 4],
    range: [f64; 2],
    /// The two values of which each component of the starts has one.
    starts: [f64; 2],
    /// The state from which motions are searched, if it is not zero.
    given: Option<Vec<f64>>,
    /// Removes from a difference of two states what changes nothing.
    without_turns: fn([f64; 4]) -> [f64; 4],
}

impl Pair {
    /// The number of motions at each end of the range to which motions from a grid of starts lead; all of them, or
    /// their mirror images, are on branches, each on one.
    fn checked(&self) -> [usize; 2] {
        let options =
            ResponseOptions { generations: 0, start: self.given.clone(), ..ResponseOptions::default() };
        let response =
            Response::over(&self.text.parse().unwrap(), "w", self.range, &options, &Quiet).unwrap();
        let middles =
            |point: &BranchPoint| [0, 1].map(|number| 0.5 * point.ranges[number].iter().sum::<f64>());
        let is_upright = |point: &BranchPoint| {
            let [x, y] = middles(point);
            (self.without_turns)([x, y, 0.0, 0.0]) == [x, y, 0.0, 0.0]
        };
        for branch in &response.branches {
            let ends = [branch.points.first(), branch.points.last()];
            assert!(ends.into_iter().flatten().any(is_upright), "{:?}", ends.map(|end| end.map(middles)));
        }
        self.range.map(|w| {
            let ends = response
                .branches
                .iter()
                .flat_map(|branch| [branch.points.first(), branch.points.last()])
                .flatten();
            let here: Vec<_> = ends.filter(|end| end.parameter.to_bits() == w.to_bits()).collect();
            let far = |point: &BranchPoint, state: [f64; 4]| {
                let apart = (self.without_turns)(std::array::from_fn(|i| point.state[i] - state[i]));
                apart.iter().fold(0.0, |far: f64, x| far.max(x.abs()))
            };
            let mut seen = vec![false; here.len()];
            for number in 0..16_u32 {
                let start = [0, 1, 2, 3].map(|bit| self.starts[usize::from(number >> bit & 1 == 1)]);
                let end = self.followed(start, w, 500);
                let mirrored = self.followed(end, w, 1).map(|x| -x);
                let is_near =
                    |number: &usize| far(here[*number], end).min(far(here[*number], mirrored)) < 1e-3;
                let nearest: Vec<usize> = (0..here.len()).filter(is_near).collect();
                assert!(
                    nearest.len() == 1 && here[nearest[0]].is_stable(),
                    "{end:?} at w = {w} is on {nearest:?}"
                );
                seen[nearest[0]] = true;
            }
            seen.into_iter().filter(|is_seen| *is_seen).count()
        })
    }

    /// The state after a number of half periods of the drive, by the classical Runge–Kutta method.
    fn followed(&self, start: [f64; 4], w: f64, halves: u32) -> [f64; 4] {
        let step = TAU / w / 60.0;
        let advanced = |state: [f64; 4], t: f64| {
            let moved = |by: [f64; 4], part: f64| std::array::from_fn(|i| state[i] + part * step * by[i]);
            let a = (self.rate)(t, state, w);
            let b = (self.rate)(t + 0.5 * step, moved(a, 0.5), w);
            let c = (self.rate)(t + 0.5 * step, moved(b, 0.5), w);
            let d = (self.rate)(t + step, moved(c, 1.0), w);
            std::array::from_fn(|i| state[i] + step / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]))
        };
        (0..30 * halves).fold(start, |state, k| advanced(state, step * f64::from(k)))
    }
}

/// An unsymmetric motion about the top and its mirror image, a turn away, are one: the equation is that of the hanging pendulum with the angle
/// from the top.
#[test]
fn mirror_images_about_the_top_are_followed_once() {
    let branches = |sign: &str| {
        let equation = format!("theta'' + 0.5*theta' {sign} sin(theta) = A*cos(2/3*t)").parse().unwrap();
        let options = ResponseOptions::default();
        Response::over(&equation, "A", [1.02, 1.066], &options, &Quiet).unwrap().branches
    };
    let swings =
        |branch: &Branch| branch.points.last().map(|point| point.ranges[0]).map(|[low, high]| high - low);
    let (hanging, upright) = (branches("+"), branches("-"));
    let ([hanging], [upright]) = (&hanging[..], &upright[..]) else { panic!("{hanging:?} {upright:?}") };
    assert!(!upright.space.mirrored);
    let [a, b] = [hanging, upright].map(|branch| swings(branch).unwrap());
    assert!((a - b).abs() < 1e-9, "{a} {b}");
}

/// A pendulum with a torque: its motions of two periods become so unstable that hundreds of points would follow to the end of the range.
#[test]
fn doubled_periods_end_where_deviations_grow_a_million_times() {
    let equation = "theta'' + 0.2*theta' + sin(theta) = 0.3 + 0.4*cos(w*t)".parse().unwrap();
    let options = ResponseOptions { generations: 1, ..ResponseOptions::default() };
    let response = Response::over(&equation, "w", [0.3, 1.4], &options, &Quiet).unwrap();
    let doubled = response.branches.iter().find(|branch| branch.space.drive_periods() == 2).unwrap();
    assert_eq!(doubled.ending, Ending::Sensitive);
    let last = doubled.points.last().unwrap().multipliers[0].abs();
    assert!((1e5..1e6).contains(&last), "{last}");
}

/// Two masses, of which one has a hardening spring, between the folds of a resonance.
#[test]
fn attracting_motions_of_two_coupled_oscillators_are_followed() {
    let pair = Pair {
        text: "x'' + 0.02*x' + 2*x - y + 0.5*x^3 = 0.15*cos(w*t); y'' + 0.02*y' + 2*y - x = 0",
        rate: |t, [x, y, u, v], w| {
            let push = 0.15 * libm::cos(w * t) - 0.02 * u - 2.0 * x + y - 0.5 * x * x * x;
            [u, v, push, x - 2.0 * y - 0.02 * v]
        },
        range: [1.1, 1.15],
        starts: [-0.5, 1.5],
        given: None,
        without_turns: |apart| apart,
    };
    assert_eq!(pair.checked(), [2, 2]);
}

/// Two pendulums that a spring couples: a turn of both changes nothing, one of them alone winds the spring up.
#[test]
fn motions_of_coupled_pendulums_are_followed_once() {
    let pair = |range, given| Pair {
        text: "x'' + 0.1*x' + sin(x) + 0.1*(x - y) = 0.4*cos(w*t); y'' + 0.1*y' + sin(y) - 0.1*x + 0.1*y = 0",
        rate: |t, [x, y, u, v], w| {
            let torque = 0.4 * libm::cos(w * t) - 0.1 * u - libm::sin(x) - 0.1 * (x - y);
            [u, v, torque, 0.1 * (x - y) - 0.1 * v - libm::sin(y)]
        },
        range,
        starts: [-1.0, 6.0],
        given,
        without_turns: |[x, y, u, v]| {
            let turns = TAU * libm::rint(0.5 * (x + y) / TAU);
            [x - turns, y - turns, u, v]
        },
    };
    assert_eq!(pair([1.1, 1.3], None).checked(), [2, 2]);
    assert_eq!(pair([0.5, 1.3], None).checked(), [2, 2]);
    // From a start about other turns Newton's method leads to copies several turns away.
    assert_eq!(pair([1.0, 1.3], Some(vec![-1.2149, -5.6423, 0.0, 0.0])).checked(), [1, 2]);
}

/// A range with both folds of the resonance outside, and the coordinate at t = 0 of the two stable motions at either end by Fourier collocation
/// with 40 harmonics (SciPy's `fsolve`).
#[test]
fn a_range_between_the_folds_has_both_stable_branches() {
    const EXPECTED: [(f64, [f64; 2]); 2] =
        [(1.1, [-0.5214468245574, 1.6954936148828]), (1.35, [-0.1216164199760, 1.4076615831498])];
    let equation = "x'' + 0.1*x^3 + 0.02*x' + x = 0.1*cos(W*t)".parse().unwrap();
    let response = Response::over(&equation, "W", [1.1, 1.35], &ResponseOptions::default(), &Quiet).unwrap();
    for (value, position) in
        EXPECTED.into_iter().flat_map(|(value, places)| places.map(|position| (value, position)))
    {
        let ends = response
            .branches
            .iter()
            .flat_map(|branch| [branch.points.first(), branch.points.last()])
            .flatten();
        let stable = ends.filter(|end| end.parameter.to_bits() == value.to_bits() && end.is_stable());
        let off = stable.map(|stable| (stable.state[0] - position).abs()).fold(f64::INFINITY, f64::min);
        assert!(off < 1e-9, "{position} at {value} is missed by {off}");
    }
}

/// x″ + damping·x′ + linear·x + cube·x³ = drive·cos(w·t).
fn cubic(random: &mut Random, [damping, linear, cube, drive]: [f64; 4], lowest: [f64; 2]) -> Oscillator {
    let low = random.between(lowest[0], lowest[1]);
    Oscillator {
        text: format!("x'' + {damping:?}*x' + ({linear:?})*x + {cube:?}*x^3 = {drive:?}*cos(w*t)"),
        force: Box::new(move |t, [x, v], w| {
            drive * libm::cos(w * t) - damping * v - linear * x - cube * x * x * x
        }),
        range: [low, low + random.between(0.05, 0.4)],
        beat: 1.0,
        kinks: vec![],
    }
}

fn hardening(random: &mut Random) -> Oscillator {
    let [damping, cube, drive] = [(0.01, 0.1), (0.02, 1.0), (0.05, 0.5)].map(|(a, b)| random.between(a, b));
    cubic(random, [damping, 1.0, cube, drive], [0.7, 1.3])
}

fn wells(random: &mut Random) -> Oscillator {
    let [damping, drive] = [(0.05, 0.4), (0.02, 0.4)].map(|(a, b)| random.between(a, b));
    cubic(random, [damping, -1.0, 1.0, drive], [0.7, 1.6])
}

fn pendulum(random: &mut Random) -> Oscillator {
    let [damping, drive] = [(0.02, 0.2), (0.02, 0.5)].map(|(a, b)| random.between(a, b));
    let low = random.between(0.6, 1.0);
    Oscillator {
        text: format!("x'' + {damping:?}*x' + sin(x) = {drive:?}*cos(w*t)"),
        force: Box::new(move |t, [x, v], w| drive * libm::cos(w * t) - damping * v - libm::sin(x)),
        range: [low, low + random.between(0.02, 0.2)],
        beat: 1.0,
        kinks: vec![],
    }
}

fn tongue(random: &mut Random) -> Oscillator {
    let low = random.between(0.99, 1.1);
    Oscillator { range: [low, low + random.between(0.01, 0.05)], ..parametron(random) }
}

/// An oscillator with the drive 0.3·cos(w·t) and this force.
fn driven(text: &str, kinks: Vec<f64>, force: impl Fn(f64, f64) -> f64 + 'static) -> Oscillator {
    Oscillator {
        text: format!("{text} = 0.3*cos(w*t)"),
        force: Box::new(move |t, [x, v], w| 0.3 * libm::cos(w * t) - force(x, v)),
        range: [0.5, 2.0],
        beat: 1.0,
        kinks,
    }
}

/// Each of these forces is odd between its kinks, where all states of small size are.
#[test]
fn a_force_with_a_kink_on_one_side_is_not_symmetric() {
    let mut random = Random::seeded(35_004);
    let one_sided = |x: f64| (x - 1.0).max(0.0);
    for oscillator in [
        driven("x'' + 0.1*x' + x + 10*max(x - 1, 0)", vec![1.0], move |x, v| {
            0.1 * v + x + 10.0 * one_sided(x)
        }),
        driven("x'' + 0.1*x' + x + 0.5*max(x - 1, 0)^2", vec![1.0], move |x, v| {
            0.1 * v + x + 0.5 * one_sided(x) * one_sided(x)
        }),
        driven("x'' + 0.1*x' + x + x^2*max(x - 1, 0)", vec![1.0], move |x, v| {
            0.1 * v + x + x * x * one_sided(x)
        }),
        driven("x'' + 0.1*x' + x + 2*abs(x - 1) + 2*(x - 1)", vec![1.0], move |x, v| {
            0.1 * v + x + 4.0 * one_sided(x)
        }),
    ] {
        assert!(
            oscillator.response().branches.iter().all(|branch| !branch.space.mirrored),
            "{}",
            oscillator.text
        );
        check(&oscillator, &mut random);
    }
    // A pair of oscillators with a stop: the motions of a symmetric branch do not exist.
    let pair = "x'' + 0.1*x' + 2*x - y = 0.3*cos(w*t); y'' + 0.1*y' + 2*y - x + 20*max(y - 0.5, 0) = 0";
    let response =
        Response::over(&pair.parse().unwrap(), "w", [0.5, 2.0], &ResponseOptions::default(), &Quiet).unwrap();
    for branch in &response.branches {
        assert!(!branch.space.mirrored);
        assert!(branch.points.iter().all(|point| point.amplitude(0, false) < 10.0), "{:?}", branch.ending);
    }
}

/// A second kink on the other side makes the force odd again, however far out it is.
#[test]
fn a_force_with_kinks_on_both_sides_is_symmetric_where_they_match() {
    for (other, mirrored) in [("1000", true), ("1000.0001", false)] {
        let text = format!("x'' + 0.1*x' + x + 3*max(x - 1000, 0) - 3*max(-x - {other}, 0) = 0.3*cos(w*t)");
        let response =
            Response::over(&text.parse().unwrap(), "w", [1.5, 2.0], &ResponseOptions::default(), &Quiet);
        assert_eq!(response.unwrap().branches[0].space.mirrored, mirrored, "{other}");
    }
}

/// A spring that acts only from 0.69 to 0.71, where the symmetry is not tested: the motions are
/// symmetric until they reach it, and each point in the result is an orbit of the whole equation.
#[test]
fn a_narrow_force_that_no_trial_of_the_symmetry_meets_invents_no_orbit() {
    let oscillator = Oscillator {
        text: "x'' + 0.1*x' + x + 5*max(0.01 - abs(x - 0.7), 0) = 0.3*cos(w*t)".to_owned(),
        force: Box::new(|t, [x, v], w| {
            0.3 * libm::cos(w * t) - 0.1 * v - x - 5.0 * (0.01 - (x - 0.7).abs()).max(0.0)
        }),
        range: [0.5, 0.9],
        beat: 1.0,
        kinks: vec![0.69, 0.7, 0.71],
    };
    let response = oscillator.response();
    assert!(response.branches[0].space.mirrored && response.branches[0].points.len() > 5);
    response.branches.iter().for_each(|branch| check_points(&oscillator, branch));
}

/// The edges of the tongues by Floquet multipliers of other programs, to the digits given here.
#[test]
fn tongues_narrower_than_a_step_are_found() {
    let mut random = Random::seeded(35_005);
    let shaken = Oscillator {
        text: "theta'' + 0.005*theta' + (1 - 0.01*w^2*cos(w*t))*sin(theta) = 0".to_owned(),
        force: Box::new(|t, [x, v], w| -0.005 * v - (1.0 - 0.01 * w * w * libm::cos(w * t)) * libm::sin(x)),
        range: [1.5, 2.5],
        beat: 1.0,
        kinks: vec![],
    };
    let parametron = |range: [f64; 2]| Oscillator {
        text: "x'' + 0.005*x' + (1 - 0.011*cos(2*w*t))*x + x^3 = 0".to_owned(),
        force: Box::new(|t, [x, v], w| -0.005 * v - (1.0 - 0.011 * libm::cos(2.0 * w * t)) * x - x * x * x),
        range,
        beat: 2.0,
        kinks: vec![],
    };
    let edges = [0.99884934, 1.00114063];
    // In the last range the initial step, a fiftieth of the range, begins before the tongue and ends after it.
    let parametrons = [[0.95, 1.05], [0.9985, 1.3]].map(|range| (parametron(range), edges));
    for (oscillator, edges) in [(shaken, [1.98, 2.02])].into_iter().chain(parametrons) {
        let response = oscillator.response();
        let rest: Vec<f64> = response.branches[0].special.iter().map(|edge| edge.point.parameter).collect();
        let tolerance = if edges[0] > 1.5 { 2e-3 } else { 1e-8 };
        assert!(
            rest.len() == 2 && rest.iter().zip(edges).all(|(a, b)| (a - b).abs() < tolerance),
            "{rest:?}"
        );
        assert!(response.branches.len() > 1, "the motions in the tongue are followed");
        check(&oscillator, &mut random);
    }
}

#[test]
fn the_branch_in_which_another_one_ends_is_followed() {
    let mut random = Random::seeded(35_006);
    let gap = |x: f64| 3.0 * ((x - 0.2).max(0.0) - (-x - 0.2).max(0.0));
    let oscillator = Oscillator {
        text: "x'' + 0.05*x' + 3*max(x - 0.2, 0) - 3*max(-x - 0.2, 0) = 0.2*cos(w*t)".to_owned(),
        force: Box::new(move |t, [x, v], w| 0.2 * libm::cos(w * t) - 0.05 * v - gap(x)),
        range: [0.5, 2.0],
        beat: 1.0,
        kinks: vec![0.2, -0.2],
    };
    let response = oscillator.response();
    let points = response.branches.iter().flat_map(|branch| &branch.points);
    let largest = points.map(|point| point.amplitude(0, false)).fold(0.0, f64::max);
    assert!((largest - 2.449).abs() < 0.01, "the main resonance comes to {largest}");
    check(&oscillator, &mut random);
}

/// Two period doublings on one branch are the ends of the doubled branch. Each end is known by interpolation
/// only, and could be mistaken, again and again, for an end on a branch that is not followed yet.
#[test]
fn a_branch_in_which_others_end_is_followed_once() {
    let equation = "x'' + 0.09982078986811771*x' + x + 3.0515445510566805*max(x - 0.3834842493610043, 0) - 3.0515445510566805*max(-x - 0.09108689179579989, 0) = 0.32494762822662293*cos(w*t)";
    let equation: Equation = equation.parse().unwrap();
    let response = Response::over(&equation, "w", [0.6, 2.0], &ResponseOptions::default(), &Quiet).unwrap();
    let periods: Vec<u32> = response.branches.iter().map(|branch| branch.space.drive_periods()).collect();
    assert_eq!(periods.iter().filter(|period| **period == 1).count(), 1, "{periods:?}");
    assert_eq!(periods.len(), 2, "{periods:?}");
}

/// Errors of multipliers relative to their stated errors, by comparison with the variational equations over the whole period, integrated without
/// symmetry and with another tolerance, which has errors too. The quantiles are quoted at the constants that they justify.
#[test]
fn errors_of_multipliers_hold_for_random_oscillators() {
    let mut random = Random::seeded(sweep::seed(35_007));
    // The dependence of its multipliers on the start is sixty times as large as the multipliers.
    let steep = "x'' + 0.11141216426232345*x' + x + 2.0132773054851065*max(x - 0.4149787521198229, 0) - 2.0132773054851065*max(-x - 0.2586924018343485, 0) = 0.5210147256379014*cos(w*t)";
    let mut oscillators = vec![(steep.to_owned(), [0.6, 2.0])];
    for kind in [parametron, clearance, smooth] {
        let drawn = (0..sweep::number(4, 40)).map(|_| kind(&mut random));
        oscillators.extend(drawn.map(|drawn| (drawn.text, drawn.range)));
    }
    let mut ratios = vec![];
    for (text, range) in oscillators {
        let equation: Equation = text.parse().unwrap();
        let flow = Flow::new(&equation, &["w"], 100_000).unwrap();
        let response = Response::over(&equation, "w", range, &ResponseOptions::default(), &Quiet).unwrap();
        for point in response.branches.iter().flat_map(|branch| &branch.points).step_by(2) {
            ratios.extend(ratios_of_multipliers(&flow, point));
        }
    }
    ratios.sort_by(f64::total_cmp);
    // From the median on, quantiles with a tenth of the remaining values beyond each.
    let beyond = [2, 10, 100, 1000].map(|part| ratios[ratios.len() - 1 - ratios.len() / part]);
    eprintln!("{} ratios: quantiles {beyond:?}", ratios.len());
    // One of 47 358 values with four seeds, for a motion that nearly grazes a kink, was
    // off by 2.7 times its error: the change of the map with the start is an estimate.
    let wrong = ratios.iter().filter(|ratio| **ratio > 1.0).count();
    assert!(10_000 * wrong <= ratios.len(), "{wrong} of {}, the largest {:?}", ratios.len(), ratios.last());
}

fn ratios_of_multipliers(flow: &Flow, point: &BranchPoint) -> Vec<f64> {
    let go_on = || std::ops::ControlFlow::Continue(());
    let to_tolerance = |tolerance: f64| {
        let span = [0.0, point.period];
        flow.variations(&point.state, &[point.parameter], span, tolerance, go_on).unwrap().by_start
    };
    let matrix = to_tolerance(3e-16);
    let multipliers = eigenvalues(&matrix).unwrap();
    // At a kink, two integrations differ by far more than the rounding of a multiplication.
    let other = eigenvalues(&to_tolerance(1e-16)).unwrap();
    let errors = multiplier_errors(&matrix, &[1.0; 2], &multipliers, 1e-15);
    let nearest = |all: &[Complex], z: Complex| {
        let off = all.iter().enumerate().map(|(index, multiplier)| ((*multiplier - z).abs(), index));
        off.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
    };
    let ratio = |(z, stated): (&Complex, &f64)| {
        let (off, index) = nearest(&multipliers, *z);
        off / (stated + errors[index] + nearest(&other, multipliers[index]).0)
    };
    point.multipliers.iter().zip(&point.multiplier_errors).map(ratio).collect()
}
