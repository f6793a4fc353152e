//! An oscillator about its equilibrium in the form of the computation: a tape and exact numbers, or their substitutes.

use super::conservative;
use super::gauge::Gauge;
use super::half_turns::half_turns;
use super::limit_cycle::{Excitation, highest_harmonic, limit_cycle};
use super::lindstedt::{Centre, Family, family};
use super::series_set::{SeriesSet, by_inverse, half_swing, substituted};
use super::shape::Shape;
use libration_numbers::internals::expression::{Jet, Tape};
use libration_numbers::internals::progress::Watch;
use libration_numbers::internals::series::truncated::{powers, powers_of_inverse};
use libration_numbers::{
    algebra::{Rational, Ring},
    internals::algebra::{Number, PhaseRing},
};

/// The kind of periodic motion that is expanded, with its parameters.
#[derive(Clone, Debug)]
pub enum Motion<N> {
    /// A family about a centre, in a gauge.
    Centre { gauge: Gauge, shape: Shape },
    /// The limit cycle of a self-excitation of total degree `degree`.
    LimitCycle(Selected<N>),
}

/// The limit cycle that the self-excitation selects at lowest order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Selected<N> {
    /// The amplitude, in units of √`unit_squared`.
    pub(crate) amplitude: N,
    pub(crate) unit_squared: N,
    /// The derivative of the condition with respect to the amplitude.
    pub(crate) slope: N,
    /// The total degree of the acceleration in x and x′.
    pub(crate) degree: usize,
    /// `true` if the acceleration is odd.
    pub(crate) symmetric: bool,
}

/// An oscillator and the question about it. `N` is the kind of its numbers.
#[derive(Clone, Debug)]
pub struct Model<N> {
    /// The acceleration as a function of x, x′ and, for limit cycles, the parameter μ.
    pub tape: Tape,
    /// The values of the slots of the tape at the equilibrium; empty for limit cycles.
    pub values: Vec<N>,
    pub omega0_squared: N,
    pub uses_velocity: bool,
    pub motion: Motion<N>,
    pub order: usize,
}

impl<N> Model<N> {
    /// The highest harmonic that any product of the expansion needs.
    pub(crate) fn highest_harmonic(&self) -> usize {
        match self.motion {
            Motion::Centre { .. } => self.order,
            Motion::LimitCycle(ref selected) => highest_harmonic(selected.degree, self.order + 1),
        }
    }

    /// All series, over a ring into which `number` converts the numbers of the model and `root` their roots; if it is
    /// cancelled, up to the last order that was solved. `None` if one of them is not in the ring.
    pub(crate) fn series<R: PhaseRing>(
        &self,
        ring: &R,
        number: impl Fn(&N) -> Option<Number<R>>,
        root: impl Fn(&N) -> Option<Number<R>>,
        watch: &Watch<'_>,
    ) -> Option<SeriesSet<Number<R>>> {
        let values = self.values.iter().map(&number).collect::<Option<Vec<_>>>()?;
        let omega0_squared = number(&self.omega0_squared)?;
        let numbers = Numbers { values, omega0: root(&self.omega0_squared), omega0_squared };
        match &self.motion {
            Motion::Centre { gauge, shape } => {
                let family = self.centre_family(ring, &numbers, gauge, *shape, watch)?;
                SeriesSet::new(ring.numbers(), family, *shape)
            }
            Motion::LimitCycle(selected) => {
                let (field, unit) = (ring.numbers(), root(&selected.unit_squared)?);
                let excitation = Excitation {
                    tape: &self.tape,
                    omega0: numbers.omega0?,
                    amplitude: field.multiply(&number(&selected.amplitude)?, &unit),
                    slope: number(&selected.slope)?,
                    degree: selected.degree,
                    symmetric: selected.symmetric,
                };
                let family = limit_cycle(ring, &excitation, self.order, watch)?;
                SeriesSet::new(field, in_units(field, family, &unit)?, Shape::Cycle)
            }
        }
    }

    fn centre_family<R: PhaseRing>(
        &self,
        ring: &R,
        given: &Numbers<Number<R>>,
        gauge: &Gauge,
        shape: Shape,
        watch: &Watch<'_>,
    ) -> Option<Family<Number<R>>> {
        let numbers = ring.numbers();
        let omega0 = if self.uses_velocity { Some(given.omega0.clone()?) } else { None };
        let values = given.values.iter().map(|value| constant(ring, value)).collect();
        let omega0_squared = given.omega0_squared.clone();
        let centre = Centre { tape: &self.tape, values, omega0_squared, omega0, wave: shape.wave() };
        let family = family(ring, centre, &self.fundamental(numbers, gauge)?, watch)?;
        let order = family.harmonics.first().map_or(0, Vec::len) - 1;
        match gauge {
            Gauge::Fundamental | Gauge::Coefficients(_) => Some(family),
            Gauge::XMax => by_inverse(numbers, &family, &shape.turning_points(numbers, &family)?.0),
            Gauge::HalfSwing => {
                by_inverse(numbers, &family, &half_swing(numbers, &shape.turning_points(numbers, &family)?)?)
            }
            Gauge::Energy => {
                let x = self.displacement(numbers, given.values.clone(), &given.omega0_squared, order)?;
                let inverse = powers_of_inverse(numbers, &half_turns(numbers, &family).0)?.first();
                let first_harmonic = powers(numbers, &x)?.composed(numbers, &inverse);
                substituted(numbers, &family, &first_harmonic)
            }
            Gauge::Nome => substituted(numbers, &family, &of_nome(numbers, order)?),
        }
    }

    /// The displacement as a series in √(2E)/ω0.
    pub(crate) fn displacement<R: Ring>(
        &self,
        ring: &R,
        values: Vec<R::Element>,
        omega0_squared: &R::Element,
        order: usize,
    ) -> Option<Vec<R::Element>> {
        conservative::displacement(ring, &self.tape, values, omega0_squared, order)
    }

    /// 0, A₁, A₂, …; for named gauges those of the fundamental one.
    fn fundamental<R: Ring>(&self, ring: &R, gauge: &Gauge) -> Option<Vec<R::Element>> {
        let mut list = vec![ring.zero(); self.order + 1];
        match gauge {
            Gauge::Coefficients(coefficients) => {
                for (a, coefficient) in list.iter_mut().skip(1).zip(coefficients) {
                    *a = ring.rational(coefficient)?;
                }
            }
            _ => *list.get_mut(1)? = ring.rational(&Rational::from(1))?,
        }
        Some(list)
    }
}

impl Model<Rational> {
    /// Numbers with irrational roots that the computation needs.
    pub(crate) fn irrational_roots(&self) -> impl Iterator<Item = &Rational> {
        let unit = match &self.motion {
            Motion::LimitCycle(selected) => Some(&selected.unit_squared),
            Motion::Centre { .. } => None,
        };
        let omega0_squared = self.uses_velocity.then_some(&self.omega0_squared);
        omega0_squared.into_iter().chain(unit).filter(|square| square.square_root().is_none())
    }
}

/// The pendulum's first harmonic 8√q/(1 + q) with ε = 8√q.
fn of_nome<R: Ring>(ring: &R, order: usize) -> Option<Vec<R::Element>> {
    let mut term = ring.rational(&Rational::from(1))?;
    let mut series = vec![ring.zero(); order + 1];
    for a in series.iter_mut().skip(1).step_by(2) {
        *a = term.clone();
        term = ring.over_integer(&ring.negate(&term), 64)?;
    }
    Some(series)
}

struct Numbers<E> {
    values: Vec<E>,
    omega0_squared: E,
    omega0: Option<E>,
}

/// A number as a sum of harmonics.
fn constant<R: PhaseRing>(ring: &R, value: &Number<R>) -> R::Element {
    let mean = libration_numbers::internals::algebra::HarmonicPair {
        cosine: value.clone(),
        sine: ring.numbers().zero(),
    };
    ring.sum_of_harmonics(&[(0, mean)])
}

/// The harmonics divided by a unit of length.
fn in_units<R: Ring>(
    ring: &R,
    mut family: Family<R::Element>,
    unit: &R::Element,
) -> Option<Family<R::Element>> {
    let per_unit = ring.divide(&ring.rational(&Rational::from(1))?, unit)?;
    for harmonic in family.harmonics.iter_mut().flatten() {
        harmonic.cosine = ring.multiply(&harmonic.cosine, &per_unit);
        harmonic.sine = ring.multiply(&harmonic.sine, &per_unit);
    }
    Some(family)
}

/// The values of the slots of a tape at x, x′ = 0; `None` if they are not in the ring.
pub fn values_at<R: Ring>(ring: &R, tape: &Tape, x: R::Element) -> Option<Vec<R::Element>> {
    let jet = Jet::new(ring, tape, &[x, ring.zero()]).ok()?;
    Some(jet.values().cloned().collect())
}
