//! Responses of driven pendulums by integration: slow sweeps up and down by Runge's and Kutta's method, which the fits do not use.

/// x″ = −c·x′ − ω0²·sin x + A cos Ωt.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DrivenPendulum {
    pub(crate) omega: f64,
    pub(crate) damping: f64,
    pub(crate) drive: f64,
}

/// Steps in a period of the drive: errors of the peak are below 1e-6.
const STEPS: u32 = 160;

impl DrivenPendulum {
    fn acceleration(self, angle: f64, velocity: f64, force: f64) -> f64 {
        -self.damping * velocity - self.omega * self.omega * libm::sin(angle) + self.drive * force
    }

    /// A step with the forces of the drive at its start, middle and end.
    fn step(self, [x, v]: [f64; 2], h: f64, forces: &[f64; 3]) -> [f64; 2] {
        let slope = |x: f64, v: f64, force: f64| [v, self.acceleration(x, v, force)];
        let [a, b] = slope(x, v, forces[0]);
        let [c, d] = slope(x + 0.5 * h * a, v + 0.5 * h * b, forces[1]);
        let [e, f] = slope(x + 0.5 * h * c, v + 0.5 * h * d, forces[1]);
        let [g, i] = slope(x + h * e, v + h * f, forces[2]);
        [x + h / 6.0 * (a + 2.0 * c + 2.0 * e + g), v + h / 6.0 * (b + 2.0 * d + 2.0 * f + i)]
    }

    /// The largest displacements at these frequencies, one after the other, each when a period changes nothing any more.
    pub(crate) fn peaks(self, frequencies: &[f64]) -> Vec<f64> {
        let forces: Vec<f64> = (0..=2 * STEPS)
            .map(|half| libm::cos(std::f64::consts::PI * f64::from(half) / f64::from(STEPS)))
            .collect();
        let mut state = [0.0, 0.0];
        let mut peaks = vec![];
        for frequency in frequencies {
            let period = std::f64::consts::TAU / frequency;
            // Next to a fold transients last far longer than elsewhere.
            let peak = loop {
                let (end, peak) = self.period(state, period, &forces);
                let change = libm::hypot(end[0] - state[0], (end[1] - state[1]) / frequency);
                state = end;
                if change < 1e-7 * peak * (self.damping * period).min(1.0) {
                    break peak;
                }
            };
            peaks.push(peak);
        }
        peaks
    }

    /// A period of the drive: its end and its largest displacement, between steps by a cubic.
    fn period(self, mut state: [f64; 2], period: f64, forces: &[f64]) -> ([f64; 2], f64) {
        let h = period / f64::from(STEPS);
        let mut peak = 0.0_f64;
        for step in 0..STEPS as usize {
            let next = self.step(state, h, &[forces[2 * step], forces[2 * step + 1], forces[2 * step + 2]]);
            if state[1] * next[1] <= 0.0 {
                peak = peak.max(turning_point(state, next, h));
            }
            state = next;
        }
        (state, peak)
    }
}

/// The largest value of the cubic with these ends and slopes.
fn turning_point([x0, v0]: [f64; 2], [x1, v1]: [f64; 2], h: f64) -> f64 {
    let cubic = |s: f64| {
        let (r, t) = (1.0 - s, s);
        r * r * (1.0 + 2.0 * t) * x0 + r * r * t * h * v0 + t * t * (1.0 + 2.0 * r) * x1 - t * t * r * h * v1
    };
    let velocity = |s: f64| {
        6.0 * s * (1.0 - s) * (x1 - x0) / h + (1.0 - s) * (1.0 - 3.0 * s) * v0 + s * (3.0 * s - 2.0) * v1
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if velocity(middle) * v0 > 0.0 { low = middle } else { high = middle }
    }
    cubic(low).abs()
}
