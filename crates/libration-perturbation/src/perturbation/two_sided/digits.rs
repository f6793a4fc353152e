//! The integrals over a side as decimal numbers, by Gauss's quadrature of series: at each node χ the phase is a series of numbers.

use super::Side;
use super::phase::turned;
use libration_kernels::elementary::count;
use libration_numbers::algebra::{BigFloat, Floats, Ring};
use libration_numbers::internals::progress::Watch;

/// The coefficients of (1/π)∫ X·cos kθ dθ for each k, by powers of ρ; half of it for k = 0. `None` when cancelled.
pub(super) fn integrals(
    floats: Floats,
    side: &Side<'_, BigFloat>,
    harmonics: &[usize],
    watch: &Watch<'_>,
) -> Option<Vec<Vec<BigFloat>>> {
    let length = side.displacement.len();
    let mut sums = vec![vec![floats.zero(); length]; harmonics.len()];
    let highest = harmonics.last().copied().unwrap_or(0);
    for (node, weight) in upper_places(floats, number_of_places(floats, length + highest)) {
        watch.go_on().ok()?;
        let at = Place::new(floats, side, floats.multiply(&node, &floats.pi()?.halved()))?;
        for (sum, &k) in sums.iter_mut().zip(harmonics) {
            for (sum, value) in sum.iter_mut().zip(at.integrand(k)?) {
                *sum = floats.add(sum, &floats.multiply(&weight, &value));
            }
        }
    }
    Some(sums)
}

/// The values at one χ.
struct Place<'a> {
    floats: Floats,
    side: &'a Side<'a, BigFloat>,
    angle: BigFloat,
    sine: BigFloat,
    /// cosⁿχ.
    cosines: Vec<BigFloat>,
    /// Series of θ′(χ).
    rate: Vec<BigFloat>,
    /// Series of θ − χ.
    delta: Vec<BigFloat>,
}

impl<'a> Place<'a> {
    fn new(floats: Floats, side: &'a Side<'a, BigFloat>, angle: BigFloat) -> Option<Self> {
        let (sine, cosine) = (angle.sin(), angle.cos());
        let length = side.frequency.len();
        let mut cosines = vec![floats.rational(&1.into())?];
        while cosines.len() <= length {
            cosines.push(floats.multiply(cosines.last()?, &cosine));
        }
        // ∫ cosⁿ from zero: (cosⁿ⁻¹ sin + (n − 1)·∫ cosⁿ⁻²)/n.
        let mut integrals = vec![angle.clone(), sine.clone()];
        for n in 2..length {
            let before = floats.times_integer(&integrals[n - 2], i64::try_from(n - 1).ok()?);
            let sum = floats.add(&floats.multiply(&cosines[n - 1], &sine), &before);
            integrals.push(floats.over_integer(&sum, u64::try_from(n).ok()?)?);
        }
        let of = |powers: &[BigFloat]| -> Option<Vec<BigFloat>> {
            let slope: Option<Vec<BigFloat>> = (0..length)
                .map(|n| {
                    let c = floats.times_integer(side.displacement.get(n + 1)?, i64::try_from(n + 1).ok()?);
                    Some(floats.multiply(&c, &powers[n]))
                })
                .collect();
            Some(floats.series_product(&slope?, side.frequency, length))
        };
        let (rate, mut delta) = (of(&cosines)?, of(&integrals)?);
        if let Some(first) = delta.first_mut() {
            *first = floats.zero();
        }
        Some(Self { floats, side, angle, sine, cosines, rate, delta })
    }

    /// X·cos kθ·θ′ for k = 0, halved, and sin kθ·sin χ·ρX′/k else, which has the same integral.
    fn integrand(&self, k: usize) -> Option<Vec<BigFloat>> {
        let floats = self.floats;
        let length = self.side.displacement.len();
        let projected = |n: usize| floats.multiply(&self.side.displacement[n], &self.cosines[n]);
        if k == 0 {
            let products: Vec<BigFloat> = (0..length).map(projected).collect();
            let twice = floats.series_product(&products, &self.rate, length);
            return Some(twice.into_iter().map(BigFloat::halved).collect());
        }
        let angle = floats.times_integer(&self.angle, i64::try_from(k).ok()?);
        let [cosine, sine] = turned(&floats, k, &self.delta)?;
        let (base_sine, base_cosine) = (angle.sin(), angle.cos());
        let phase: Vec<BigFloat> = cosine
            .iter()
            .zip(&sine)
            .map(|(c, s)| floats.add(&floats.multiply(&base_sine, c), &floats.multiply(&base_cosine, s)))
            .collect();
        let fall: Option<Vec<BigFloat>> = (1..length)
            .map(|n| {
                let c = floats.times_integer(&self.side.displacement[n], i64::try_from(n).ok()?);
                let c = floats.over_integer(&c, u64::try_from(k).ok()?)?;
                Some(floats.multiply(&floats.multiply(&c, &self.cosines[n - 1]), &self.sine))
            })
            .collect();
        let mut product = floats.series_product(&phase, &fall?, length - 1);
        product.insert(0, floats.zero());
        Some(product)
    }
}

/// Gauss's rule with m nodes has an error of about (eL/4m)²ᵐ for a function that grows like e^L beyond the ends, here L = π/2 times the sum of the
/// frequencies; with a seventh of the bits as further nodes that is below the last bit.
fn number_of_places(floats: Floats, frequencies: usize) -> usize {
    8 * frequencies / 5 + floats.precision / 7
}

/// The nodes above zero of Gauss's rule from −1 to 1, with their weights: the zeros of the Legendre polynomial, by Newton's method.
fn upper_places(floats: Floats, places: usize) -> Vec<(BigFloat, BigFloat)> {
    let nodes = places + places % 2;
    let near = |i: usize| libm::cos(std::f64::consts::PI * (count(i) + 0.75) / (count(nodes) + 0.5));
    (0..nodes / 2).filter_map(|i| gauss_place(floats, nodes, near(i))).collect()
}

fn gauss_place(floats: Floats, degree: usize, near: f64) -> Option<(BigFloat, BigFloat)> {
    // From 1e-16 three steps lead to 1e-128, more bits take more.
    let steps = 3 + floats.precision / 400;
    let one = floats.rational(&1.into())?;
    let mut node = BigFloat::from_f64(near, floats.precision)?;
    for _ in 0..=steps {
        let (value, slope) = legendre(floats, degree, &node)?;
        node = floats.subtract(&node, &floats.divide(&value, &slope)?);
    }
    let (_, slope) = legendre(floats, degree, &node)?;
    let beyond = floats.subtract(&one, &floats.multiply(&node, &node));
    let weight = floats
        .divide(&floats.rational(&2.into())?, &floats.multiply(&beyond, &floats.multiply(&slope, &slope)))?;
    Some((node, weight))
}

/// Pₙ and its derivative n(tPₙ − Pₙ₋₁)/(t² − 1).
fn legendre(floats: Floats, degree: usize, t: &BigFloat) -> Option<(BigFloat, BigFloat)> {
    let one = floats.rational(&1.into())?;
    let (mut before, mut value) = (one.clone(), t.clone());
    for n in 1..degree {
        let n_signed = i64::try_from(n).ok()?;
        let rise = floats.times_integer(&floats.multiply(t, &value), 2 * n_signed + 1);
        let next = floats.subtract(&rise, &floats.times_integer(&before, n_signed));
        before = std::mem::replace(&mut value, floats.over_integer(&next, u64::try_from(n + 1).ok()?)?);
    }
    let above = floats.subtract(&floats.multiply(t, &value), &before);
    let slope = floats.times_integer(&above, i64::try_from(degree).ok()?);
    Some((value, floats.divide(&slope, &floats.subtract(&floats.multiply(t, t), &one))?))
}
