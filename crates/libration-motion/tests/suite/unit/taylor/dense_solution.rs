use libration::pendulum::Pendulum;
use libration::taylor::{DenseSolution, Effort, System, integrate_dense};

/// The exact motion of the pendulum, at times within and at the ends of steps, forward and backward in time.
#[test]
fn the_state_between_the_steps_is_the_exact_one() {
    let system = System::new(&"theta'' + sin(theta) = 0".parse().unwrap()).unwrap();
    let start = system.start(&[("theta", 1.0)]).unwrap();
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    let exact = pendulum.released_from("1rad".parse().unwrap()).unwrap();
    for end in [30.0, -30.0] {
        let motion = integrate_dense(&system, &start, end, &Effort::to_tolerance(1e-15)).unwrap();
        assert_eq!(motion.span(), Some([0.0, end]));
        let ends = motion.steps().iter().flat_map(|step| [step.step().start(), step.step().end()]);
        let between = (0..=977_u32).map(|part| end * f64::from(part) / 977.0);
        for time in ends.chain(between) {
            let (state, exact) = (motion.state_at(time).unwrap(), exact.state_at(time));
            assert!((state[0] - exact.angle).abs() < 3e-14, "{time}");
            assert!((state[1] - exact.velocity).abs() < 3e-14, "{time}");
        }
        assert_eq!(motion.state_at(end * (1.0 + f64::EPSILON)), None);
        assert_eq!(motion.state_at(-end * f64::MIN_POSITIVE), None);
        assert_eq!(motion.state_at(f64::NAN), None);
    }
    assert_eq!(DenseSolution::default().state_at(0.0), None);
}
