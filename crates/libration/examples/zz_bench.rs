use libration::taylor::{Effort, Launch, Moment, System, integrate, integrate_many};
use std::ops::ControlFlow;
fn cpu() -> f64 {
    std::fs::read_to_string("/proc/self/schedstat")
        .unwrap()
        .split(' ')
        .next()
        .unwrap()
        .parse::<f64>()
        .unwrap()
        * 1e-9
}
fn main() {
    let what = std::env::args().nth(1).unwrap();
    let tol: f64 = std::env::args().nth(2).unwrap().parse().unwrap();
    let reps: usize = std::env::args().nth(3).unwrap().parse().unwrap();
    let mut best = f64::INFINITY;
    let mut report = String::new();
    for _ in 0..reps {
        let t0 = cpu();
        if what == "pend" {
            let system = System::new(&"theta'' + sin(theta) = 0".parse().unwrap()).unwrap();
            let p = libration::pendulum::Pendulum::from_angular_frequency(1.0).unwrap();
            let a = 179_f64.to_radians();
            let m = p.released_from(libration::quantity::Angle::from_radians(a).unwrap()).unwrap();
            let t = 1000.0 * m.period();
            let s = integrate(
                &system,
                &Moment { time: 0.0, state: vec![a, 0.0] },
                &[t],
                &Effort::to_tolerance(tol),
                |_| ControlFlow::Continue(()),
            )
            .unwrap();
            best = best.min(cpu() - t0);
            let e = |x: &[f64]| 0.5 * x[1] * x[1] + 1.0 - x[0].cos();
            report = format!(
                "{:.2} ms steps {} ns/step {:.0} drift {:.2e} err {:.2e}",
                best * 1e3,
                s.steps,
                best * 1e9 / s.steps as f64,
                e(&s.end.state) / e(&[a, 0.0]) - 1.0,
                s.end.state[0] - m.state_at(t).angle
            );
        } else if what == "double" {
            let system = System::new(&"a'' = -(sin(a-b)*b'^2 + 2*sin(a) + cos(a-b)*(sin(a-b)*a'^2 - sin(b)))/(1+sin(a-b)^2); b'' = sin(a-b)*a'^2 - sin(b) + cos(a-b)*(sin(a-b)*b'^2 + 2*sin(a) + cos(a-b)*(sin(a-b)*a'^2 - sin(b)))/(1+sin(a-b)^2)".parse().unwrap()).unwrap();
            let a = 120_f64.to_radians();
            let s = integrate(
                &system,
                &Moment { time: 0.0, state: vec![a, a, 0.0, 0.0] },
                &[100.0],
                &Effort::to_tolerance(tol),
                |_| ControlFlow::Continue(()),
            )
            .unwrap();
            best = best.min(cpu() - t0);
            let e = |x: &[f64]| {
                x[2] * x[2] + 0.5 * x[3] * x[3] + x[2] * x[3] * (x[0] - x[1]).cos()
                    - 2.0 * x[0].cos()
                    - x[1].cos()
            };
            report = format!(
                "{:.3} ms steps {} ns/step {:.0} drift {:.2e}",
                best * 1e3,
                s.steps,
                best * 1e9 / s.steps as f64,
                e(&s.end.state) - e(&[a, a, 0.0, 0.0])
            );
        } else {
            let system =
                System::new(&"theta'' = -sin(theta) - theta'/2 + 1.2 cos(2t/3)".parse().unwrap()).unwrap();
            let t = [300.0 * std::f64::consts::PI];
            let n = 320;
            let launches: Vec<Launch> = (0..n)
                .map(|i| Launch {
                    start: Moment { time: 0.0, state: vec![-3.0 + 6.0 * f64::from(i) / f64::from(n), 0.1] },
                    parameters: vec![],
                    times: &t,
                })
                .collect();
            let steps: usize = if what == "one" {
                launches
                    .iter()
                    .map(|l| {
                        l.integrate(&system, &Effort::to_tolerance(tol), |_| ControlFlow::Continue(()))
                            .unwrap()
                            .steps
                    })
                    .sum()
            } else {
                integrate_many(&system, &launches, &Effort::to_tolerance(tol), |_, _| {
                    ControlFlow::Continue(())
                })
                .into_iter()
                .map(|s| s.unwrap().steps)
                .sum()
            };
            best = best.min(cpu() - t0);
            report = format!(
                "{:.4} ms/trajectory steps {} ns/step {:.0}",
                best * 1e3 / f64::from(n),
                steps / n as usize,
                best * 1e9 / steps as f64
            );
        }
    }
    println!("{what} {tol:e} {report}");
}
