//! Order and length of the steps for a required accuracy.
//!
//! Reference: À. Jorba and M. Zou, Experiment. Math. 14, 99 (2005), doi:10.1080/10586458.2005.10128904.
//!
//! # Method
//! Order and length of a step follow from the tolerance and the radius of convergence. The order is 19 at the loosest tolerance and 28 at 1e-12,
//! because more than half the cost of a step does not depend on its order. The size relative to which errors are measured comes from the first
//! terms, and series are in powers of a unit of time that is adapted to the steps, so that the units of the equations do not matter.

use super::allowance::Allowance;
use super::block::{Block, Row};
use super::larger::larger;
use libration_kernels::elementary::count;
use libration_numbers::internals::algebra::lanes;

use libration_kernels::elementary::rough::{exp2, log2};

/// Tolerances and step limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// The allowed error of one step in each state component: relative to its size in a velocity, relative to its displacement in a coordinate,
    /// whatever the order of its equation. So the tolerance depends neither on units nor on the position of zero. Coordinates may have
    /// individual tolerances, by [`System::with_tolerances`](crate::taylor::System::with_tolerances).
    pub relative: f64,
    /// An error of each state component, in its own unit, that is always allowed; zero if there is none.
    pub absolute: f64,
    /// Maximum number of steps.
    pub most_steps: usize,
}

impl Effort {
    /// The least and the greatest relative tolerance.
    pub const TOLERANCES: [f64; 2] = [1e-18, 0.1];

    /// A relative tolerance, with a step limit that only endless integrations reach.
    #[must_use]
    pub const fn to_tolerance(relative: f64) -> Self {
        Self { relative, absolute: 0.0, most_steps: 100_000_000 }
    }

    pub(in crate::taylor) fn is_possible(&self) -> bool {
        let [least, greatest] = Self::TOLERANCES;
        (least..=greatest).contains(&self.relative) && (0.0..f64::INFINITY).contains(&self.absolute)
    }

    /// The order at which a given accuracy costs least: it would be 1 − ln(tolerance)/2 if the cost of a step were the square of its order, as
    /// for products of series. But the other costs of a step are larger than that, so that longer steps of higher order are cheaper, the more so
    /// the looser the tolerance. Pendulums from 179° take 4.3, 4.0 and 3.9 ms with orders 14, 18 and 19 at 0.1, 5.7, 4.9 and 4.8 ms with 14, 20
    /// and 21 at 1e-3, 10.9, 9.5 and 8.9 ms with 16, 20 and 24 at 1e-6, 8.9, 8.1 and 8.1 ms with 22, 26 and 28 at 1e-9, and 10.6, 10.3 and 10.6
    /// ms with 26, 28 and 30 at 1e-12. At 1e-16 double pendulums take 0.79, 0.82, 0.98 and 1.03 ms with a factor of 0.9, 0.95, 1 and 1.05, since
    /// the machine code of higher orders exceeds the first-level instruction cache.
    pub(in crate::taylor) fn order(&self) -> usize {
        let digits = -libm::log(self.relative);
        let best = f64::max(1.0 + 0.9 * digits, f64::min(18.0 + 0.37 * digits, 28.0));
        (1..HIGHEST_ORDER).find(|&order| count(order) >= best).unwrap_or(HIGHEST_ORDER)
    }

    /// The length of a step relative to the radius of convergence, as a base-2 logarithm: the first missing terms are far below the tolerance,
    /// since a radius estimated too large by a fifth makes them a hundred times larger. With 12 the energy of a pendulum from 179° at 1e-12
    /// changes by 5.1e-14 in 1000 periods, and by at most 3.5e-13 from five other amplitudes. Orders above 28 are for tolerances close to the
    /// rounding errors: at 1e-15 with order 34 the energy changes by more than 4e-15, with 33 and 14 by less.
    pub(in crate::taylor) fn log2_part_of_radius(&self) -> f64 {
        let order = count(self.order());
        let reserve = (12.0 + 2.0 / 3.0 * (order - 28.0)).clamp(12.0, 14.0);
        (log2(self.relative) - reserve) / (order + 1.0)
    }

    /// The factor by which a step of the same order may be longer for another tolerance, as a base-2 logarithm.
    pub(in crate::taylor) fn log2_longer(&self, relative: f64) -> f64 {
        libm::log2(relative / self.relative) / (count(self.order()) + 1.0)
    }
}

/// The highest order of a series.
const HIGHEST_ORDER: usize = 63;

/// Number of last coefficients that are examined: by symmetry or by chance some are small.
const LAST: usize = 4;
/// Number of first coefficients that determine the size.
const FIRST: usize = 3;

/// The lengths of the steps for the series of the state and of some other rows, positive; infinite for finite series. The other
/// rows are given with the factor by which their steps may be longer, as a base-2 logarithm.
#[inline(always)]
pub(in crate::taylor) fn step_lengths<const N: usize>(
    block: &Block<N>,
    others: impl Iterator<Item = (Row, f64)>,
    allowances: &[Allowance],
    absolute: f64,
    log2_part: f64,
) -> [f64; N] {
    let mut radius = radius_of_state(block, usize::MAX, allowances, absolute);
    for (row, longer) in others {
        let of_row = log2_radius(&Sizes::new(&block[row], &block[row][0]));
        radius = radius.smaller(&of_row.longer(&[longer; N]));
    }
    let radius = radius.logarithm();
    lanes(|lane| {
        if radius[lane] == f64::INFINITY {
            f64::INFINITY
        } else {
            exp2(radius[lane] + log2_part) * block.unit[lane]
        }
    })
}

/// The logarithm of the radius of convergence, in units of the block, as
/// estimated from the first coefficients; infinite if these do not determine it.
pub(in crate::taylor) fn log2_time_scale<const N: usize>(
    block: &Block<N>,
    allowances: &[Allowance],
) -> [f64; N] {
    const FEW: usize = 8;
    radius_of_state(block, FEW, allowances, 0.0).of_sizes
}

/// The logarithm of a radius of convergence in each lane.
#[derive(Clone, Copy, Debug)]
struct Log2Radius<const N: usize> {
    /// The logarithm from series whose first coefficients give a size.
    of_sizes: [f64; N],
    /// The logarithm from other series, whose size is assumed to be the smallest positive number.
    of_nothing: [f64; N],
}

impl<const N: usize> Log2Radius<N> {
    const ENDLESS: Self = Self { of_sizes: [f64::INFINITY; N], of_nothing: [f64::INFINITY; N] };

    /// The radius of a single lane, copied to all lanes.
    #[inline(always)]
    fn lane<const M: usize>(&self, lane: usize) -> Log2Radius<M> {
        Log2Radius { of_sizes: [self.of_sizes[lane]; M], of_nothing: [self.of_nothing[lane]; M] }
    }

    #[inline(always)]
    fn smaller(&self, other: &Self) -> Self {
        Self {
            of_sizes: smaller(&self.of_sizes, &other.of_sizes),
            of_nothing: smaller(&self.of_nothing, &other.of_nothing),
        }
    }

    #[inline(always)]
    fn longer(&self, by: &[f64; N]) -> Self {
        Self {
            of_sizes: lanes(|lane| self.of_sizes[lane] + by[lane]),
            of_nothing: lanes(|lane| self.of_nothing[lane] + by[lane]),
        }
    }

    #[inline(always)]
    fn logarithm(&self) -> [f64; N] {
        lanes(
            |lane| {
                if self.of_sizes[lane] < f64::INFINITY { self.of_sizes[lane] } else { self.of_nothing[lane] }
            },
        )
    }
}

/// The smallest radius of convergence of the first `terms` terms of a state's series, larger for components with a larger allowed error.
#[inline(always)]
fn radius_of_state<const N: usize>(
    block: &Block<N>,
    terms: usize,
    allowances: &[Allowance],
    absolute: f64,
) -> Log2Radius<N> {
    /// Number of state components of a single motion that fill a register.
    const BESIDE: usize = 4;
    let series = |number: usize| {
        let series = block.series(number);
        &series[..terms.min(series.len())]
    };
    let size = |number: usize, allowance: &Allowance| -> [f64; N] {
        let zeroth = &block.series(number)[0];
        let floor = absolute / allowance.relative;
        // The zeroth coefficient of a coordinate is only its position, which is not a size; a
        // coordinate of first order may be a phase or a temperature, for which the same holds.
        let velocity = block.layout().is_velocity(number);
        lanes(|lane| if velocity { zeroth[lane].abs().max(floor) } else { floor })
    };
    let mut radius = Log2Radius::<N>::ENDLESS;
    if N > 1 {
        for (number, allowance) in allowances.iter().enumerate() {
            let of_component = log2_radius(&Sizes::new(series(number), &size(number, allowance)));
            radius = radius.smaller(&of_component.longer(&[allowance.log2_longer; N]));
        }
        return radius;
    }
    for (group, allowances) in allowances.chunks(BESIDE).enumerate() {
        let allowance = |i: usize| &allowances[i.min(allowances.len() - 1)];
        let number = |i: usize| BESIDE * group + i.min(allowances.len() - 1);
        let size: [[f64; N]; BESIDE] = std::array::from_fn(|i| size(number(i), allowance(i)));
        let group_sizes: [_; BESIDE] = std::array::from_fn(|i| Sizes::new(series(number(i)), &size[i]));
        let longer: [f64; BESIDE] = lanes(|i| allowance(i).log2_longer);
        let (first, last) =
            (first_lanes(group_sizes.map(|of| of.first)), first_lanes(group_sizes.map(|of| of.last)));
        let sizes = Sizes { first: first.each_ref(), last: last.each_ref(), terms: group_sizes[0].terms };
        let beside = log2_radius(&sizes).longer(&longer);
        for i in 0..BESIDE {
            radius = radius.smaller(&beside.lane(i));
        }
    }
    radius
}

#[inline(always)]
fn smaller<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    lanes(|lane| if b[lane] < a[lane] { b[lane] } else { a[lane] })
}

/// The coefficients of series that determine their radii of convergence. They
/// are references: copies of sixteen lanes took a fifth of a step's time.
#[derive(Clone, Copy, Debug)]
struct Sizes<'s, const N: usize> {
    /// The first coefficients, with a size in place of the zeroth.
    first: [&'s [f64; N]; FIRST],
    last: [&'s [f64; N]; LAST],
    /// Number of terms.
    terms: usize,
}

impl<'s, const N: usize> Sizes<'s, N> {
    /// The coefficients of series, with a size in place of the zeroth ones; NaN for too few terms.
    #[inline(always)]
    fn new(series: &'s [[f64; N]], size: &'s [f64; N]) -> Self {
        let nothing = &const { [[f64::NAN; N]; LAST] };
        let [_, second, third, _] = series.first_chunk().unwrap_or(nothing);
        let last = series.last_chunk().unwrap_or(nothing).each_ref();
        Self { first: [size, second, third], last, terms: series.len() }
    }
}

/// The first lane of each row of several series, combined to rows with one lane per series.
#[inline(always)]
fn first_lanes<const N: usize, const M: usize, const ROWS: usize>(
    rows: [[&[f64; M]; ROWS]; N],
) -> [[f64; N]; ROWS] {
    std::array::from_fn(|row| lanes(|i| rows[i][row][0]))
}

/// The radius of convergence, (|cₙ|/|cₖ|)^{1/(k−n)} with n among the first and k among the last; infinite if the last coefficients vanish.
///
/// All computations of a lane are in one closure, which is compiled to vector instructions: as loops over rows they took five times as long.
#[inline(always)]
fn log2_radius<const N: usize>(sizes: &Sizes<N>) -> Log2Radius<N> {
    /// Base-2 logarithm of the smallest positive number.
    const LEAST: f64 = -1074.0;
    /// Base-2 logarithm of the magnitude below which coefficients may have underflowed.
    const TINY: f64 = -600.0;
    let Sizes { first: [size, second, third], last: [a, b, c, d], terms } = sizes;
    let from = terms.saturating_sub(LAST);
    let parts = |k: usize| [0, 1, 2].map(|n| RECIPROCALS[(from + k).saturating_sub(n)]);
    let [of_a, of_b, of_c, of_d] = [parts(0), parts(1), parts(2), parts(3)];
    let mut radii = [f64::INFINITY; N];
    let mut largest = [LEAST; N];
    for lane in 0..N {
        let first = |x: f64| larger(LEAST, log2(x.abs()));
        let first = [first(size[lane]), first(second[lane]), first(third[lane])];
        largest[lane] = larger(larger(first[0], first[1]), first[2]);
        let underflows = LEAST < largest[lane] && largest[lane] < TINY;
        let least_last = if underflows { LEAST } else { f64::NEG_INFINITY };
        let by = |last: f64, parts: [f64; FIRST]| {
            let last = larger(least_last, log2(last.abs()));
            let ratios =
                [(first[0] - last) * parts[0], (first[1] - last) * parts[1], (first[2] - last) * parts[2]];
            larger(larger(larger(f64::NEG_INFINITY, ratios[0]), ratios[1]), ratios[2])
        };
        let least = |a: f64, b: f64| if b < a { b } else { a };
        let pairs =
            [least(by(a[lane], of_a), by(b[lane], of_b)), least(by(c[lane], of_c), by(d[lane], of_d))];
        radii[lane] = least(f64::INFINITY, least(pairs[0], pairs[1]));
    }
    Log2Radius {
        of_sizes: lanes(|lane| if largest[lane] > LEAST { radii[lane] } else { f64::INFINITY }),
        of_nothing: lanes(|lane| if largest[lane] > LEAST { f64::INFINITY } else { radii[lane] }),
    }
}

/// The numbers 1/n.
static RECIPROCALS: [f64; HIGHEST_ORDER + 1] = {
    let mut reciprocals = [f64::INFINITY; HIGHEST_ORDER + 1];
    let mut n = 1;
    while n <= HIGHEST_ORDER {
        reciprocals[n] = 1.0 / count(n);
        n += 1;
    }
    reciprocals
};
