//! Order and length of the steps from what is demanded.
//!
//! Reference: À. Jorba and M. Zou, Experiment. Math. 14, 99 (2005), doi:10.1080/10586458.2005.10128904.

/// How exact an integration shall be, and when it shall give up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// The error that one step makes in each number of the state: in a velocity as a part of its size, in a coordinate as
    /// a part of how far it moves. So it depends neither on units nor on where zero is.
    pub relative: f64,
    /// The error of each number of the state, in its own units, below which no step need come; zero if there is none.
    pub absolute: f64,
    /// The largest number of steps.
    pub most_steps: usize,
}

impl Effort {
    /// The least and the greatest relative tolerance.
    pub const TOLERANCES: [f64; 2] = [1e-18, 0.1];

    /// A relative tolerance, and so many steps that none but endless integrations take them.
    #[must_use]
    pub const fn to_tolerance(relative: f64) -> Self {
        Self { relative, absolute: 0.0, most_steps: 100_000_000 }
    }

    pub(super) fn is_possible(&self) -> bool {
        let [least, greatest] = Self::TOLERANCES;
        (least..=greatest).contains(&self.relative) && (0.0..f64::INFINITY).contains(&self.absolute)
    }

    /// −ln(tolerance)/2 + 1, rounded up: the order at which a given accuracy costs least.
    pub(super) fn order(&self) -> u32 {
        const LOWEST: u32 = 6;
        let best = (1.0 - 0.5 * libm::log(self.relative)).ceil();
        (LOWEST..64).find(|&order| f64::from(order) >= best).unwrap_or(LOWEST)
    }

    /// The length of a step with these series, positive; infinite where the series end.
    ///
    /// At e^−2 of the radius of convergence the terms fall by e² each, and by the order below the tolerance.
    pub(super) fn step_length(&self, series: &[Vec<f64>]) -> f64 {
        let floor = self.absolute / self.relative;
        let (coordinates, velocities) = series.split_at(series.len() / 2);
        let moving = coordinates.iter().map(|one| log_radius(one, floor));
        let all = moving.chain(velocities.iter().map(|one| log_radius(one, one[0].abs().max(floor))));
        libm::exp(all.fold(f64::INFINITY, f64::min) - 2.0 - 0.7 / (f64::from(self.order()) - 1.0))
    }
}

/// How many of the last coefficients are asked: by symmetry or by chance some are small.
const LAST: usize = 4;
/// How many of the first coefficients that are not zero tell the size.
const FIRST: usize = 3;

/// The logarithm of the radius of convergence, (|cₙ|/|cₖ|)^{1/(k−n)} with n among the first and k among the last.
/// In the place of |c₀|, which of a coordinate only says where it is, stands a size that is given.
fn log_radius(series: &[f64], size: f64) -> f64 {
    let sizes = [size].into_iter().chain(series.iter().skip(1).map(|c| c.abs()));
    let known = sizes.enumerate().filter(|(_, size)| *size > 0.0).take(FIRST);
    let first: [Option<(usize, f64)>; FIRST] = collected(known.map(|(n, size)| (n, libm::log(size))));
    let by = |k: usize| {
        let last = libm::log(series[k].abs());
        let before = first.iter().flatten().filter(|(n, _)| *n < k);
        before.map(|(n, size)| (size - last) / count(k - n)).reduce(f64::max)
    };
    (series.len().saturating_sub(LAST)..series.len()).filter_map(by).fold(f64::INFINITY, f64::min)
}

fn collected<T: Copy, const N: usize>(mut items: impl Iterator<Item = T>) -> [Option<T>; N] {
    std::array::from_fn(|_| items.next())
}

fn count(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}
