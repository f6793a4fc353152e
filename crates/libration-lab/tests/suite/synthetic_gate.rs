//! Edges of a photogate passed by a damped pendulum, by the integrator.

use libration::taylor::{Direction, Effort, Event, Moment, System, integrate};

use crate::random::Random;
use libration::progress::Quiet;

/// A pendulum that is released from rest, and a gate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct GateRecord {
    pub(crate) omega0: f64,
    /// Damping rate of the velocity, per second.
    pub(crate) damping: f64,
    pub(crate) release: f64,
    /// The angle of the gate.
    pub(crate) gate: f64,
    /// Width of the bob, as an angle.
    pub(crate) width: f64,
    pub(crate) seconds: f64,
}

impl GateRecord {
    /// 2π/ω0, as lengthened by the damping.
    pub(crate) fn t0(&self) -> f64 {
        std::f64::consts::TAU / libm::sqrt(self.omega0 * self.omega0 - 0.25 * self.damping * self.damping)
    }

    /// Times at which the bob blocks or frees the gate, with `true` if it blocks it.
    pub(crate) fn edges(&self) -> Vec<(f64, bool)> {
        let (square, damping) = (self.omega0 * self.omega0, self.damping);
        let equation = format!("theta'' = -{square:e}*sin(theta) - {damping:e}*theta'");
        let event = |side: f64| Event {
            formula: format!("theta - ({:e})", self.gate + 0.5 * side * self.width).parse().unwrap(),
            direction: Direction::Any,
            ends_at: None,
        };
        let system = System::new(&equation.parse().unwrap()).unwrap();
        let system = system.with_events(&[event(-1.0), event(1.0)]).unwrap();
        let start = Moment { time: 0.0, state: vec![self.release, 0.0] };
        let motion =
            integrate(&system, &start, &[self.seconds], &Effort::to_tolerance(1e-12), &Quiet).unwrap();
        // Moving down the upper edge comes first.
        let blocks = |velocity: f64, event: usize| (event == 1) == (velocity < 0.0);
        motion
            .events
            .iter()
            .map(|crossing| (crossing.time, blocks(crossing.state[1], crossing.event)))
            .collect()
    }
}

/// Edges with normal errors of this standard deviation.
pub(crate) fn jittered(edges: &[(f64, bool)], jitter: f64, random: &mut Random) -> Vec<(f64, bool)> {
    edges.iter().map(|&(time, blocked)| (time + jitter * random.normal(), blocked)).collect()
}
