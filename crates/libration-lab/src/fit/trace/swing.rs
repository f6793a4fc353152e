//! The motion of a damped pendulum, with its derivatives by everything it depends on.
//!
//! θ″ = −ω0² sin θ − d·sign θ′ − b·θ′ − c·θ′|θ′| is integrated together with the equations of its derivatives by ω0, the
//! coefficients of the damping, the first angle and the first velocity. Where the velocity changes its sign dry friction
//! makes the acceleration jump from a₋ to a₊; a motion that turns by δt later has then another velocity, so that
//! ∂θ′ is multiplied by a₊/a₋ (M. A. Aizerman and F. R. Gantmakher, Q. J. Mech. Appl. Math. 11, 225 (1958),
//! doi:10.1093/qjmam/11.2.225).

use super::{DampingKind, DampingModel};
use libration::expression::{Equation, Expression, Symbol};
use libration::taylor::{
    Contact, Direction, Effort, Event, Moment, Solution, System, Trajectory, with_sensitivities,
};

/// Pendulums with these kinds of damping.
#[derive(Clone, Debug)]
pub(super) struct Swing {
    system: System,
    terms: DampingModel,
}

/// Angle and velocity, and their derivatives by ω0, the coefficients, the first angle and the first velocity.
#[derive(Clone, Debug)]
pub(super) struct Sample {
    pub(super) state: [f64; 2],
    pub(super) derivatives: Vec<[f64; 2]>,
}

/// With relative errors of 1e-9 and 1e-14, absolute ones of 1e-10, and 2000 steps no parameter of 21 fits moved by 1e-6 of its uncertainty;
/// the residuals of exact data are then 1e-12, and so is what can be tested.
const EFFORT: Effort = Effort { relative: 1e-12, absolute: 1e-15, most_steps: 20_000 };

impl Swing {
    pub(super) fn new(terms: DampingModel) -> Self {
        let names: Vec<&str> = ["k"].into_iter().chain(terms.iter().map(symbol)).collect();
        let equation = with_sensitivities(&equation(terms), &names, 2);
        let system = System::with_parameters(&equation, &names).expect("all parameters are open");
        let system = if terms.has(DampingKind::Dry) { until_it_turns(system) } else { system };
        Self { system, terms }
    }

    /// The motion at times that increase, of which the first is that of `start`, with these ω0 and coefficients; nothing
    /// where it cannot be followed.
    pub(super) fn samples(
        &self,
        omega0: f64,
        coefficients: &[f64],
        start: [f64; 2],
        times: &[f64],
    ) -> Option<Vec<Sample>> {
        let parameters: Vec<f64> = [omega0 * omega0].iter().chain(coefficients).copied().collect();
        let mut moment = Moment { time: times.first().copied().unwrap_or(0.0), state: self.state(start) };
        let mut moments: Vec<Moment> = Vec::with_capacity(times.len());
        // A pendulum that turns so much more often than it is looked at is far from any data.
        for _ in 0..10 * times.len() + 100 {
            if moments.len() == times.len() {
                break;
            }
            let trajectory =
                Trajectory { start: moment, parameters: parameters.clone(), times: &times[moments.len()..] };
            let Solution { samples, end, events, .. } = trajectory.integrate(&self.system, &EFFORT).ok()?;
            moments.extend(samples);
            moment = end;
            let turn =
                events.iter().find(|event| matches!(event.contact, Contact::Rising | Contact::Falling));
            if let Some(turn) = turn {
                let dry = self.dry(coefficients);
                if !self.turns(&mut moment, turn.contact, parameters[0], dry) {
                    let rest = times[moments.len()..].iter();
                    moments.extend(rest.map(|&time| Moment { time, state: moment.state.clone() }));
                }
            }
        }
        let samples = moments.iter().map(|moment| self.sample(&moment.state, omega0));
        (moments.len() == times.len()).then(|| samples.collect())
    }

    fn dry(&self, coefficients: &[f64]) -> f64 {
        let mut all = self.terms.iter().zip(coefficients);
        all.find(|(term, _)| *term == DampingKind::Dry).map_or(0.0, |(_, &value)| value)
    }

    /// How many deviations there are: by k, the coefficients, the first angle and the first velocity.
    fn deviations(&self) -> usize {
        self.terms.count() + 3
    }

    fn state(&self, [angle, velocity]: [f64; 2]) -> Vec<f64> {
        let deviations = self.deviations();
        let mut state = vec![0.0; 2 * (deviations + 1)];
        (state[0], state[deviations + 1]) = (angle, velocity);
        // ∂θ/∂θ(0) is the last but one, ∂θ′/∂θ′(0) the last.
        state[deviations - 1] = 1.0;
        state[2 * deviations + 1] = 1.0;
        state
    }

    /// Lets the motion turn; false if dry friction holds it where it is.
    fn turns(&self, moment: &mut Moment, contact: Contact, k: f64, dry: f64) -> bool {
        let first = self.deviations() + 1;
        let (angle, velocities) = moment.state.split_at_mut(first);
        let gravity = -k * libm::sin(angle[0]);
        let sign_before = if contact == Contact::Falling { 1.0 } else { -1.0 };
        let [before, after] = [gravity - dry * sign_before, gravity + dry * sign_before];
        let goes_on = after * sign_before < 0.0;
        velocities[0] = 0.0;
        for deviation in &mut velocities[1..] {
            *deviation *= if goes_on { after / before } else { 0.0 };
        }
        goes_on
    }

    fn sample(&self, state: &[f64], omega0: f64) -> Sample {
        let (angles, velocities) = state.split_at(self.deviations() + 1);
        let mut pairs = angles.iter().zip(velocities).map(|(&angle, &velocity)| [angle, velocity]);
        let state = pairs.next().unwrap_or_default();
        let mut derivatives: Vec<[f64; 2]> = pairs.collect();
        // k = ω0².
        derivatives[0] = derivatives[0].map(|derivative| 2.0 * omega0 * derivative);
        Sample { state, derivatives }
    }
}

/// When, and at which angle, a pendulum with this damping turns that is at this angle with this velocity at zero time; nothing where
/// it does not within that time, or cannot be followed.
pub(super) fn turning_point(
    terms: DampingModel,
    omega0: f64,
    coefficients: &[f64],
    start: [f64; 2],
    longest: f64,
) -> Option<[f64; 2]> {
    let names: Vec<&str> = ["k"].into_iter().chain(terms.iter().map(symbol)).collect();
    let system = System::with_parameters(&equation(terms), &names).expect("all parameters are open");
    let parameters = [omega0 * omega0].iter().chain(coefficients).copied().collect();
    let start = Moment { time: 0.0, state: start.to_vec() };
    let trajectory = Trajectory { start, parameters, times: &[longest] };
    let solution = trajectory.integrate(&until_it_turns(system), &EFFORT).ok()?;
    solution.events.first().map(|turn| [turn.time, turn.state[0]])
}

/// The motion ends where the velocity changes its sign.
fn until_it_turns(system: System) -> System {
    let turning = [Direction::Rising, Direction::Falling].map(|direction| {
        let formula = Expression::Symbol(Symbol::plain("theta").with_primes(1));
        Event { formula, direction, terminal: true }
    });
    system.with_events(&turning).expect("the velocity is a number of the state")
}

/// The equation of motion with these kinds of damping.
fn equation(terms: DampingModel) -> Equation {
    let all = "theta'' = -k*sin(theta) - d*sign(theta') - b*theta' - c*theta'*abs(theta')";
    let all: Equation = all.parse().expect("this can be read");
    let kinds = [DampingKind::Dry, DampingKind::Linear, DampingKind::Quadratic];
    let absent = kinds.into_iter().filter(|&term| !terms.has(term));
    let zeros: Vec<_> = absent.map(|term| (symbol(term), Expression::from(0))).collect();
    all.with(&zeros).expect("these are parameters, and zero leaves the acceleration")
}

fn symbol(term: DampingKind) -> &'static str {
    match term {
        DampingKind::Dry => "d",
        DampingKind::Linear => "b",
        DampingKind::Quadratic => "c",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The state at the last time with parameters ω0, coefficients, first angle and velocity.
    fn end(swing: &Swing, all: &[f64], time: f64) -> Sample {
        let (coefficients, start) = all[1..].split_at(all.len() - 3);
        swing.samples(all[0], coefficients, [start[0], start[1]], &[0.0, time]).unwrap().remove(1)
    }

    #[test]
    fn derivatives_are_the_limit_of_differences() {
        for terms in DampingModel::all() {
            let swing = Swing::new(terms);
            let coefficients = terms.iter().map(|term| match term {
                DampingKind::Dry => 0.05,
                DampingKind::Linear => 0.03,
                DampingKind::Quadratic => 0.04,
            });
            let all: Vec<f64> = [2.0].into_iter().chain(coefficients).chain([1.2, -0.4]).collect();
            let sample = end(&swing, &all, 9.0);
            for (place, derivative) in sample.derivatives.iter().enumerate() {
                let step = 1e-5;
                let shifted = |by: f64| {
                    let mut all = all.clone();
                    all[place] += by;
                    end(&swing, &all, 9.0).state
                };
                let (more, less) = (shifted(step), shifted(-step));
                for number in 0..2 {
                    let difference = (more[number] - less[number]) / (2.0 * step);
                    // The third derivative times step²/6.
                    let error = (difference - derivative[number]).abs();
                    assert!(
                        error < 3e-6 * (1.0 + difference.abs()),
                        "{terms} {place}: {difference} {derivative:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn dry_friction_holds_the_pendulum_in_the_end() {
        let swing = Swing::new(DampingModel::only(DampingKind::Dry));
        let times: Vec<f64> = (0..100).map(f64::from).collect();
        let samples = swing.samples(1.0, &[0.1], [1.0, 0.0], &times).unwrap();
        let [angle, velocity] = samples[99].state;
        assert!(velocity == 0.0 && angle.abs() < 0.1001, "{angle} {velocity}");
        assert!((samples[98].state[0] - angle).abs() == 0.0);
        assert!(samples[99].derivatives[0][1] == 0.0);
    }
}
