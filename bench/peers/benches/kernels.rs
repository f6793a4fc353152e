//! Time of each kernel, to see a change before the comparison with peers is run: `cargo bench -p libration-peers`, with a name after `--` for
//! one kernel.

use divan::Bencher;
use divan::counter::ItemsCount;
use libration::elliptic::{self, JacobiSlices, Moduli};
use libration::oscillator::NamedOscillator;
use libration::pendulum::{self, Pendulum};
use libration::perturbation::{Gauge, expand};
use libration::progress::Quiet;
use libration::quantity::Angle;
use libration::taylor::{Effort, Moment, System, Trajectory, integrate, integrate_many};

const COUNT: usize = 10_000;

fn main() {
    divan::main();
}

/// Evenly distributed numbers between 0 and an end, by multiples of the golden ratio.
fn even(end: f64) -> Vec<f64> {
    (0_u32..).take(COUNT).map(|n| end * (f64::from(n) * 0.618_033_988_749_894_9).fract()).collect()
}

#[divan::bench]
fn periods(bencher: Bencher<'_, '_>) {
    let (amplitudes, mut ratios) = (even(3.14), vec![0.0; COUNT]);
    bencher.counter(ItemsCount::new(COUNT)).bench_local(|| pendulum::period_ratios(&amplitudes, &mut ratios));
}

/// States of one motion at many times.
#[divan::bench(args = [0.5, 2.0, 3.12])]
fn states_of_one_motion(bencher: Bencher<'_, '_>, amplitude: f64) {
    let pendulum = Pendulum::from_angular_frequency(1.0).expect("one is a frequency");
    let motion = pendulum.released_from(Angle::from_radians(amplitude).expect("finite"));
    let motion = motion.expect("below the top").prepare();
    let (times, mut angles, mut velocities) = (even(50.0), vec![0.0; COUNT], vec![0.0; COUNT]);
    bencher
        .counter(ItemsCount::new(COUNT))
        .bench_local(|| motion.states_at(&times, &mut angles, &mut velocities));
}

#[divan::bench]
fn states_of_many_motions(bencher: Bencher<'_, '_>) {
    let (amplitudes, times) = (even(3.14), even(50.0));
    let (mut angles, mut velocities) = (vec![0.0; COUNT], vec![0.0; COUNT]);
    bencher
        .counter(ItemsCount::new(COUNT))
        .bench_local(|| pendulum::states(&amplitudes, 1.0, &times, &mut angles, &mut velocities));
}

#[divan::bench]
fn complete_integrals(bencher: Bencher<'_, '_>) {
    let (parameters, mut firsts, mut seconds) = (even(1.0), vec![0.0; COUNT], vec![0.0; COUNT]);
    bencher.counter(ItemsCount::new(COUNT)).bench_local(|| {
        let moduli = Moduli::Parameters(&parameters);
        elliptic::complete_firsts(moduli, &mut firsts).and(elliptic::complete_seconds(moduli, &mut seconds))
    });
}

#[divan::bench]
fn incomplete_integrals(bencher: Bencher<'_, '_>) {
    let (angles, parameters, mut firsts) = (even(1.57), even(1.0), vec![0.0; COUNT]);
    bencher
        .counter(ItemsCount::new(COUNT))
        .bench_local(|| elliptic::incomplete_firsts(&angles, Moduli::Parameters(&parameters), &mut firsts));
}

#[divan::bench]
fn jacobi_functions(bencher: Bencher<'_, '_>) {
    let (arguments, parameters) = (even(50.0), even(1.0));
    let [mut sn, mut cn, mut dn, mut am] = std::array::from_fn(|_| vec![0.0; COUNT]);
    bencher.counter(ItemsCount::new(COUNT)).bench_local(|| {
        let results = JacobiSlices { sn: &mut sn, cn: &mut cn, dn: &mut dn, am: &mut am };
        elliptic::jacobi_functions(&arguments, Moduli::Parameters(&parameters), results)
    });
}

/// Ten swings from 179°, after enough runs that the system is compiled to machine code.
#[divan::bench(args = [1e-9, 1e-12, 1e-16])]
fn integration(bencher: Bencher<'_, '_>, tolerance: f64) {
    let system = system("theta'' + sin(theta) = 0");
    let start = Moment { time: 0.0, state: vec![3.124, 0.0] };
    let motion = || integrate(&system, &start, &[300.0], &Effort::to_tolerance(tolerance), &Quiet);
    (0..10).for_each(|_| drop(motion()));
    bencher.bench_local(motion);
}

#[divan::bench(args = [1, 4, 8, 64])]
fn driven_pendulums(bencher: Bencher<'_, '_>, count: u32) {
    let system = system("theta'' + theta'/2 + sin(theta) = 1.2*cos(2*t/3)");
    let start = |n: u32| Moment { time: 0.0, state: vec![0.04 * f64::from(n) - 1.0, 0.5] };
    let trajectories: Vec<Trajectory<'_>> =
        (0..count).map(|n| Trajectory { start: start(n), parameters: vec![], times: &[90.0] }).collect();
    let motions = || integrate_many(&system, &trajectories, &Effort::to_tolerance(1e-9), &Quiet);
    (0..10).for_each(|_| drop(motions()));
    bencher.counter(ItemsCount::new(count)).bench_local(motions);
}

#[divan::bench(args = [9, 31, 61])]
fn exact_series(bencher: Bencher<'_, '_>, order: usize) {
    let named = NamedOscillator::by_key("pendulum").expect("catalogued");
    let pendulum = named.oscillator(&[]).expect("without letters");
    bencher.bench_local(|| expand(&pendulum, order, &Gauge::Fundamental, &Quiet));
}

fn system(equation: &str) -> System {
    let equation = equation.parse().expect("an equation of motion");
    System::new(&equation).expect("a system that can be integrated")
}
