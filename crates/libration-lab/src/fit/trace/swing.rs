//! The motion of a damped pendulum, with its derivatives with respect to all parameters.
//!
//! θ″ = −ω0² sin θ − d·sign θ′ − b·θ′ − c·θ′|θ′| is integrated together with the equations of its derivatives by the
//! coefficients of the damping and by a shift of the first state across the motion. The others follow: a shift along the motion
//! is one of the time, and ω0 is one of the units of the time, in which b is a frequency and d the square of one. Where the velocity
//! changes its sign dry friction makes the acceleration jump from a₋ to a₊; a motion that turns by δt later has then another
//! velocity, so that ∂θ′ is multiplied by a₊/a₋ (M. A. Aizerman and F. R. Gantmakher, Q. J. Mech. Appl. Math. 11, 225 (1958),
//! doi:10.1093/qjmam/11.2.225).

use std::ops::ControlFlow;

use super::{DampingKind, DampingModel};
use crate::fit::damped_pendulum::{equation, symbol};
use crate::measurement::Observable;
use libration::expression::{Expression, Symbol};
use libration::progress::Quiet;
use libration::taylor::{
    Contact, Direction, Effort, Event, IntegrationError, Moment, Occurrence, Solution, Step, System,
    Trajectory, integrate_many_stepwise, with_sensitivities,
};

/// Pendulums with these kinds of damping.
#[derive(Clone, Debug)]
pub struct Swing {
    system: System,
    /// The kinds of damping.
    pub terms: DampingModel,
}

/// A motion to be computed: from an angle and a velocity at the first of some times, which increase.
#[derive(Clone, Debug)]
pub struct Course<'a> {
    /// The angular frequency of small swings, in rad/s.
    pub omega0: f64,
    /// Coefficients of the kinds of damping, in their order.
    pub coefficients: &'a [f64],
    /// Angle in rad and angular velocity in rad/s at the first time.
    pub start: [f64; 2],
    /// Times in seconds.
    pub times: &'a [f64],
    /// The measured quantity.
    pub observable: Observable,
}

/// Values of the measured quantity at the times of a course.
#[derive(Clone, Debug)]
pub struct Seen {
    /// The angle, or the angular velocity.
    pub values: Vec<f64>,
    /// The derivatives with respect to ω0, the coefficients, the first angle and the first velocity.
    pub derivatives: Vec<Vec<f64>>,
}

/// Tolerances of the final motions. With relative errors of 1e-9 and 1e-14, absolute ones of 1e-10, and 2000 steps no parameter of 21 fits moved by
/// 1e-6 of its uncertainty; the residuals of exact data are then 1e-12, which limits the tests.
pub const EXACT: Effort = Effort { relative: 1e-12, absolute: 1e-15, most_steps: 20_000 };
/// Tolerances for intermediate results.
pub(super) const ROUGH: Effort = Effort { relative: 1e-9, absolute: 1e-12, ..EXACT };

impl Swing {
    /// Returns pendulums whose equation of motion has these terms.
    pub fn new(terms: DampingModel) -> Self {
        let coefficients: Vec<&str> = terms.iter().map(symbol).collect();
        let equation = with_sensitivities(&equation(terms), &coefficients, 1);
        let names: Vec<&str> = ["k"].into_iter().chain(coefficients).collect();
        let system = System::with_parameters(&equation, &names).expect("all parameters are open");
        let system = if terms.has(DampingKind::Dry) { until_it_turns(system) } else { system };
        Self { system, terms }
    }

    /// Computes the motions, each equal bit for bit to that computed alone; `None` if one of them cannot be integrated.
    pub fn seen(&self, courses: &[Course<'_>], effort: &Effort) -> Option<Vec<Seen>> {
        let ways = courses.iter().map(|course| IntegratedMotion::new(self, course));
        let mut ways = ways.collect::<Option<Vec<IntegratedMotion<'_>>>>()?;
        // A pendulum that turns so much more often than it is sampled is far from any data.
        let most_rows = courses.iter().map(|course| course.times.len()).max().unwrap_or(0);
        for _ in 0..10 * most_rows + 100 {
            let mut under_way: Vec<&mut IntegratedMotion<'_>> =
                ways.iter_mut().filter(|way| !way.is_done()).collect();
            if under_way.is_empty() {
                return Some(ways.into_iter().map(IntegratedMotion::seen).collect());
            }
            for (solution, way) in self.legs(&mut under_way, effort).into_iter().zip(under_way) {
                way.arrive(solution.ok()?);
            }
        }
        None
    }

    /// Integrates all motions to their ends, or to their next turning points.
    fn legs(
        &self,
        ways: &mut [&mut IntegratedMotion<'_>],
        effort: &Effort,
    ) -> Vec<Result<Solution, IntegrationError>> {
        let trajectories: Vec<Trajectory<'_>> = ways.iter().map(|way| way.trajectory()).collect();
        let mut take = |number: usize, step: &Step<'_>| {
            ways[number].take(step);
            ControlFlow::Continue(())
        };
        match &trajectories[..] {
            // One motion alone would cost as much as eight in lanes.
            [one] => vec![one.integrate_stepwise(&self.system, effort, |step| take(0, step))],
            many => integrate_many_stepwise(&self.system, many, effort, take),
        }
    }

    /// Number of deviations: by the coefficients, and across the motion.
    fn deviations(&self) -> usize {
        self.terms.count() + 1
    }
}

/// A motion during its integration.
struct IntegratedMotion<'a> {
    swing: &'a Swing,
    course: &'a Course<'a>,
    parameters: Vec<f64>,
    moment: Moment,
    /// The first velocity, and the first acceleration over ω0.
    flow: [f64; 2],
    /// The size of both.
    speed: f64,
    /// The angle, the velocity, and the deviations of the measured quantity, at all times before the next one.
    columns: Vec<Vec<f64>>,
    next: usize,
}

impl<'a> IntegratedMotion<'a> {
    /// Prepares a motion; `None` if it is at rest and so has no direction.
    fn new(swing: &'a Swing, course: &'a Course<'a>) -> Option<Self> {
        let (omega0, [angle, velocity]) = (course.omega0, course.start);
        let flow = [velocity, swing.acceleration(course, angle, velocity) / omega0];
        let speed = libm::hypot(flow[0], flow[1]);
        let deviations = swing.deviations();
        let mut state = vec![0.0; 2 * (deviations + 1)];
        (state[0], state[deviations + 1]) = (angle, velocity);
        // Across the motion where angles and velocities over ω0 are measured alike.
        (state[deviations], state[2 * deviations + 1]) = (-flow[1] / speed, omega0 * flow[0] / speed);
        let moment = Moment { time: course.times.first().copied().unwrap_or(0.0), state };
        let parameters = [omega0 * omega0].iter().chain(course.coefficients).copied().collect();
        let columns = vec![vec![0.0; course.times.len()]; deviations + 2];
        let way = Self { swing, course, parameters, moment, flow, speed, columns, next: 0 };
        (speed > 0.0 && omega0 > 0.0).then(|| way.without_waiting())
    }

    /// Records the values at the times of its start.
    fn without_waiting(mut self) -> Self {
        let state = self.moment.state.clone();
        let here =
            self.course.times[self.next..].iter().take_while(|&&time| time <= self.moment.time).count();
        self.fill(here, &state);
        self
    }

    /// Records the same state at this number of further times.
    fn fill(&mut self, times: usize, state: &[f64]) {
        for (column, number) in self.columns.iter_mut().zip(numbers(self.swing, self.course.observable)) {
            column[self.next..self.next + times].fill(state[number]);
        }
        self.next += times;
    }

    fn is_done(&self) -> bool {
        self.next == self.course.times.len()
    }

    fn trajectory(&self) -> Trajectory<'a> {
        let times = &self.course.times[self.course.times.len() - 1..];
        Trajectory { start: self.moment.clone(), parameters: self.parameters.clone(), times }
    }

    /// Records the values in a step.
    fn take(&mut self, step: &Step<'_>) {
        let times = &self.course.times[self.next..];
        let times = &times[..times.partition_point(|&time| time <= step.end())];
        for (column, number) in self.columns.iter_mut().zip(numbers(self.swing, self.course.observable)) {
            step.values_at(number, times, &mut column[self.next..self.next + times.len()]);
        }
        self.next += times.len();
    }

    /// Ends a leg; the motion continues, turns, or stays.
    fn arrive(&mut self, Solution { end, events, .. }: Solution) {
        self.moment = end;
        if events.is_empty() {
            return;
        }
        // The last step may have gone on beyond the turning point.
        self.next = self.course.times.partition_point(|&time| time <= self.moment.time);
        let Some(turn) = events.iter().find(|event| is_turn(event)) else { return };
        let dry = self.swing.coefficient(DampingKind::Dry, self.course.coefficients);
        if !self.turns(turn.contact, dry) {
            let state = self.moment.state.clone();
            self.fill(self.course.times.len() - self.next, &state);
        }
    }

    /// Lets the motion turn; returns `false` if dry friction holds it in its position.
    fn turns(&mut self, contact: Contact, dry: f64) -> bool {
        let first = self.swing.deviations() + 1;
        let (angle, velocities) = self.moment.state.split_at_mut(first);
        let gravity = -self.parameters[0] * libm::sin(angle[0]);
        let sign_before = if contact == Contact::Falling { 1.0 } else { -1.0 };
        let [before, after] = [gravity - dry * sign_before, gravity + dry * sign_before];
        let goes_on = after * sign_before < 0.0;
        velocities[0] = 0.0;
        for deviation in &mut velocities[1..] {
            *deviation *= if goes_on { after / before } else { 0.0 };
        }
        goes_on
    }

    /// Computes the values and derivatives from the angle, the velocity and the deviations.
    fn seen(self) -> Seen {
        let Self { swing, course, flow, speed, mut columns, .. } = self;
        let across = columns.pop().unwrap_or_default();
        let by_coefficients = columns.split_off(2);
        let velocities = columns.pop().unwrap_or_default();
        let angles = columns.pop().unwrap_or_default();
        let accelerations = || {
            let both = angles.iter().zip(&velocities);
            both.map(|(&angle, &velocity)| swing.acceleration(course, angle, velocity)).collect()
        };
        let (rates, values): (Vec<f64>, _) = match course.observable {
            Observable::Angle => (velocities, angles),
            Observable::AngularVelocity => (accelerations(), velocities),
        };
        let combined = |along: f64, beside: f64| -> Vec<f64> {
            rates.iter().zip(&across).map(|(rate, across)| along * rate + beside * across).collect()
        };
        let square = speed * speed;
        let by_angle = combined(flow[0] / square, -flow[1] / speed);
        let by_velocity = combined(flow[1] / square / course.omega0, flow[0] / speed / course.omega0);
        let by_omega0 = by_omega0(swing, course, &values, &rates, &by_coefficients, &by_velocity);
        let derivatives = [by_omega0].into_iter().chain(by_coefficients).chain([by_angle, by_velocity]);
        Seen { derivatives: derivatives.collect(), values }
    }
}

/// ω0·∂θ/∂ω0 = tθ′ − b·∂θ/∂b − 2d·∂θ/∂d − θ′(0)·∂θ/∂θ′(0), with a further θ′ for velocities: the angle is a function of ω0t, b/ω0, c, d/ω0²,
/// θ(0) and θ′(0)/ω0 alone.
fn by_omega0(
    swing: &Swing,
    course: &Course<'_>,
    values: &[f64],
    rates: &[f64],
    by_coefficients: &[Vec<f64>],
    by_velocity: &[f64],
) -> Vec<f64> {
    let start = course.times.first().copied().unwrap_or(0.0);
    let of_value = if course.observable == Observable::AngularVelocity { 1.0 } else { 0.0 };
    let mut sums: Vec<f64> = course
        .times
        .iter()
        .zip(rates)
        .zip(values)
        .map(|((time, rate), value)| (time - start) * rate + of_value * value)
        .collect();
    let powers = swing.terms.iter().zip(course.coefficients).map(|(term, coefficient)| match term {
        DampingKind::Dry => 2.0 * coefficient,
        DampingKind::Linear => *coefficient,
        DampingKind::Quadratic => 0.0,
    });
    let columns = by_coefficients.iter().map(Vec::as_slice).chain([by_velocity]);
    for (factor, column) in powers.chain([course.start[1]]).zip(columns) {
        for (sum, derivative) in sums.iter_mut().zip(column) {
            *sum -= factor * derivative;
        }
    }
    for sum in &mut sums {
        *sum /= course.omega0;
    }
    sums
}

/// The indices of the state components that are kept.
fn numbers(swing: &Swing, observable: Observable) -> impl Iterator<Item = usize> {
    let coordinates = swing.deviations() + 1;
    let first = if observable == Observable::Angle { 0 } else { coordinates };
    [0, coordinates].into_iter().chain(first + 1..first + coordinates)
}

impl Swing {
    fn coefficient(&self, kind: DampingKind, coefficients: &[f64]) -> f64 {
        let mut all = self.terms.iter().zip(coefficients);
        all.find(|(term, _)| *term == kind).map_or(0.0, |(_, &value)| value)
    }

    /// Angular acceleration; for a state at rest that of its release, or zero if friction holds it.
    fn acceleration(&self, course: &Course<'_>, angle: f64, velocity: f64) -> f64 {
        let gravity = -course.omega0 * course.omega0 * libm::sin(angle);
        let [dry, linear, quadratic] = [DampingKind::Dry, DampingKind::Linear, DampingKind::Quadratic]
            .map(|kind| self.coefficient(kind, course.coefficients));
        let friction = match velocity == 0.0 {
            true => gravity.clamp(-dry.abs(), dry.abs()),
            false => dry * velocity.signum(),
        };
        gravity - friction - linear * velocity - quadratic * velocity * velocity.abs()
    }
}

/// Time and angle of the next turning point of a pendulum with this damping, from this angle and velocity at time zero; `None` if it does not turn
/// within that time, or cannot be integrated.
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
    let solution = trajectory.integrate(&until_it_turns(system), &EXACT, &Quiet).ok()?;
    solution.events.iter().find(|event| is_turn(event)).map(|turn| [turn.time, turn.state[0]])
}

/// Returns `true` if the velocity changes its sign: it may be zero at the start, or touch zero where friction stops the motion.
fn is_turn(event: &Occurrence) -> bool {
    matches!(event.contact, Contact::Rising | Contact::Falling)
}

/// Adds a terminal event where the velocity changes its sign.
fn until_it_turns(system: System) -> System {
    let formula = Expression::Symbol(Symbol::plain("theta").with_primes(1));
    let turning = Event { formula, direction: Direction::Any, ends_at: Some(1) };
    system.with_events(&[turning]).expect("the velocity is a number of the state")
}
