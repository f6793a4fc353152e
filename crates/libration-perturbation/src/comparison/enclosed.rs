//! Other equilibria enclosed by an orbit.

use libration_numbers::algebra::Doubles;
use libration_numbers::roots::{Tolerance, bisect};
use libration_numbers::{
    expression::{Equation, Symbol},
    internals::expression::{Jet, Tape},
};

/// An equilibrium other than the centre between two turning points, the nearest to the centre on its side that is detected: beyond it the static
/// force points away from the centre. The search uses even distances from the centre, and each 2^(1/16) times the one before, so that a well that
/// is small compared with the orbit is detected.
pub fn other_equilibrium(equation: &Equation, centre: f64, turning_points: [f64; 2]) -> Option<f64> {
    let name = equation.variables().first()?;
    let inputs = [Symbol::plain(name), Symbol::plain(name).with_primes(1)];
    let tape = Tape::new(&[&equation.accelerations()[0]], &inputs).ok()?;
    let force = |x: f64| Jet::new(&Doubles, &tape, &[x, 0.0]).map_or(f64::NAN, |jet| jet.result(0)[0]);
    let nearest = turning_points.iter().filter_map(|end| on_one_side(&force, centre, end - centre));
    nearest.min_by(|a, b| (a - centre).abs().total_cmp(&(b - centre).abs()))
}

fn on_one_side(force: &impl Fn(f64) -> f64, centre: f64, reach: f64) -> Option<f64> {
    // Weak forces vanish in double precision, which does not make an equilibrium.
    let away = |part: f64| {
        let force = force(centre + part * reach);
        force.abs() > 0.0 && (force > 0.0) == (reach > 0.0)
    };
    let mut before = 0.0;
    for part in parts() {
        if away(part) {
            let [_, turned] = bisect([before, part], Tolerance::LAST_BIT, |part| !away(part));
            let turning_point = centre + reach * turned;
            // Zero, but for the rounding of the sum.
            let vanishes = turning_point.abs() <= 4.0 * f64::EPSILON * centre.abs();
            return Some(if vanishes { 0.0 } else { turning_point });
        }
        before = part;
    }
    None
}

/// Fractions of the distance to the turning point, below one, in order.
fn parts() -> Vec<f64> {
    /// Number of even fractions. A zero of the force between two of them is detected if the force has the other sign at one of them: two zeros
    /// nearer than the 256th part of the distance, or than a 23rd part of their distance from the equilibrium, may be missed.
    const EVEN: u32 = 256;
    const AN_OCTAVE: u32 = 16;
    /// Number of halvings, down to 1e-6 of the distance.
    const OCTAVES: u32 = 20;
    let even = (1..EVEN).map(|k| f64::from(k) / f64::from(EVEN));
    let halves = (1..=OCTAVES * AN_OCTAVE).map(|k| libm::exp2(-f64::from(k) / f64::from(AN_OCTAVE)));
    let mut parts: Vec<f64> = even.chain(halves).collect();
    parts.sort_by(f64::total_cmp);
    parts
}
