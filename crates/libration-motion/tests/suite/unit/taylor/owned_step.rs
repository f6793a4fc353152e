use libration::taylor::{Effort, Moment, System, integrate_stepwise};
use std::ops::ControlFlow;

#[test]
fn an_owned_step_is_the_step_bit_for_bit() {
    let system = System::new(&"x'' = -sin(x) - y; y'' = x - y^3".parse().unwrap()).unwrap();
    let start = Moment { time: 0.0, state: vec![1.0, 0.3, 0.0, -0.2] };
    let mut steps = 0;
    integrate_stepwise(&system, &start, &[20.0], &Effort::to_tolerance(1e-15), |step| {
        let owned = step.to_owned_step();
        for part in [0.0, 0.3, 1.0] {
            let time = step.start() + part * (step.end() - step.start());
            assert_eq!(step.state_at(time), owned.step().state_at(time));
        }
        steps += 1;
        ControlFlow::Continue(())
    })
    .unwrap();
    assert!(steps > 10);
}
