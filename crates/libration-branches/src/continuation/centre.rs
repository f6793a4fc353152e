//! Centres about which a system may be its own mirror image, other than zero, as with springs that are not slack at zero.
//!
//! # Method
//! F(2c − x, −x′, t + T/2) = −F(x, x′, t) for all x makes the forces on a body at rest in c cancel over two times half a period apart. Newton's
//! method finds zeros of the sum over two such pairs from guesses of many sizes. A zero, or the middle between two of them, which the mirror
//! exchanges, as the wells about a hilltop, may be the centre: `symmetry.rs` tries the equation about them.

use libration_motion::internals::periodic::norm;
use libration_motion::taylor::StateLayout;
use libration_numbers::algebra::Doubles;
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::expression::{Jet, Tape};
use libration_numbers::internals::linear::{eigenvalues, solve};
use libration_numbers::internals::roots::{NewtonError, newton};

/// Candidates for the centre, in coordinates, the nearest to zero first, for forces as a tape in the state, the time and the parameters. `scale` is the
/// size of motions.
pub(super) fn centres(
    layout: &StateLayout,
    rates: &Tape,
    (period, parameters): (f64, &[f64]),
    scale: f64,
) -> Vec<Vec<f64>> {
    /// Most zeros: two wells and a hilltop.
    const MOST_ZEROS: usize = 3;
    const MOST_STEPS: usize = 40;
    /// Largest difference between results for one zero, relative to its size.
    const SAME: f64 = 1e-6;
    let forces = MeanForces { layout, rates, period, parameters };
    let is_last =
        |step: &[f64], at: &[f64]| norm(step) <= 4.0 * f64::EPSILON * norm(at).max(f64::MIN_POSITIVE);
    let is_near = |a: &[f64], b: &[f64]| norm(&difference(a, b)) <= SAME * norm(a);
    let mut zeros: Vec<Vec<f64>> = vec![];
    for guess in guesses(layout.coordinates(), scale) {
        let zero = newton(&Doubles, &guess, MOST_STEPS, |at| forces.correction(at), is_last);
        match zero {
            Ok(zero) if !zeros.iter().any(|other| is_near(other, &zero)) => zeros.push(zero),
            _ => {}
        }
        if zeros.len() == MOST_ZEROS {
            break;
        }
    }
    let middle = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| f64::midpoint(*a, *b)).collect();
    let pairs = (0..zeros.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let middles: Vec<Vec<f64>> = pairs.map(|(i, j)| middle(&zeros[i], &zeros[j])).collect();
    let mut candidates: Vec<Vec<f64>> = zeros.into_iter().chain(middles).collect();
    candidates.put_in_order(|a, b| norm(a).total_cmp(&norm(b)));
    // An angle has a centre at the bottom and one at the top.
    candidates.sort_by_cached_key(|centre| !forces.restore(centre));
    candidates.into_iter().flat_map(|centre| [rounded(&centre), centre]).collect()
}

fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Guesses: zero, and each of the first coordinates alone and all together over six decades.
fn guesses(coordinates: usize, scale: f64) -> Vec<Vec<f64>> {
    /// Most coordinates that are moved alone: the work for a long chain would grow with the fourth power of its length.
    const MOST: usize = 7;
    let each = |part: &dyn Fn(usize) -> f64| (0..coordinates).map(part).collect::<Vec<f64>>();
    let alone = (0..coordinates.min(MOST)).map(|moved| each(&|number| f64::from(number == moved)));
    let together = (coordinates > 1).then(|| each(&|_| 1.0));
    let shapes: Vec<Vec<f64>> = alone.chain(together).collect();
    let sizes = (-3..=3).map(|decade| scale * libm::exp10(f64::from(decade))).flat_map(|size| [size, -size]);
    let of_size = |size: f64| {
        shapes.iter().map(move |shape| shape.iter().map(|part| size * part).collect()).collect::<Vec<_>>()
    };
    std::iter::once(vec![0.0; coordinates]).chain(sizes.flat_map(of_size)).collect()
}

/// The coordinates to 12 digits, which is what was typed if it has fewer.
fn rounded(centre: &[f64]) -> Vec<f64> {
    centre.iter().map(|x| format!("{x:.11e}").parse().unwrap_or(*x)).collect()
}

/// The sum of the forces on bodies at rest at four times a quarter of a period apart.
struct MeanForces<'a> {
    layout: &'a StateLayout,
    rates: &'a Tape,
    period: f64,
    parameters: &'a [f64],
}

impl MeanForces<'_> {
    /// Newton's correction of coordinates.
    fn correction(&self, at: &[f64]) -> Result<Vec<f64>, NewtonError> {
        let (sums, slopes) = self.sums(at)?;
        if sums.iter().all(|sum| *sum == 0.0) {
            return Ok(sums);
        }
        let against: Vec<f64> = sums.iter().map(|sum| -sum).collect();
        let step = solve(&Doubles, |x| x.abs(), &slopes, &against);
        step.filter(|step| step.iter().all(|x| x.is_finite())).ok_or(NewtonError::NoSlope)
    }

    /// Returns `true` if no deviation is driven away; without damping it need not return.
    fn restore(&self, at: &[f64]) -> bool {
        const ROUNDING: f64 = 1e-9;
        let eigenvalues = self.sums(at).ok().and_then(|(_, slopes)| eigenvalues(&slopes));
        eigenvalues.is_some_and(|all| all.iter().all(|value| value.re <= ROUNDING * value.abs()))
    }

    /// The sums with their derivatives with respect to the coordinates.
    fn sums(&self, at: &[f64]) -> Result<(Vec<f64>, Vec<Vec<f64>>), NewtonError> {
        /// Times at which no simple drive is zero, in periods.
        const TIMES: [f64; 4] = [0.11, 0.36, 0.61, 0.86];
        let (n, at_rest) = (at.len(), self.layout.arrange(at.iter().copied(), |_| 0.0));
        let (mut sums, mut slopes) = (vec![0.0; n], vec![vec![0.0; n]; n]);
        for time in TIMES {
            let further = [time * self.period].into_iter().chain(self.parameters.iter().copied());
            let inputs: Vec<f64> = at_rest.iter().copied().chain(further).collect();
            let jet = Jet::new(&Doubles, self.rates, &inputs).map_err(|_| NewtonError::NoValue)?;
            let gains: Result<Vec<Vec<f64>>, _> = (0..n).map(|j| jet.gains(j)).collect();
            let gains = gains.map_err(|_| NewtonError::NoSlope)?;
            for (row, slot) in slopes.iter_mut().zip(self.rates.results()) {
                row.iter_mut().zip(&gains).for_each(|(slope, gain)| *slope += gain[*slot]);
            }
            sums.iter_mut().enumerate().for_each(|(i, sum)| *sum += jet.result(i)[0]);
        }
        Ok((sums, slopes))
    }
}
