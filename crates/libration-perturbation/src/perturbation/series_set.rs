//! All series of one family of motions, over any ring: harmonics, turning points, and all quantities as
//! functions of the amplitude.

use super::half_turns::BothTurns;
use super::lindstedt::{Family, Wave};
use super::shape::Shape;
use libration_numbers::internals::series::truncated::{SeriesPowers, powers, powers_of_inverse, reciprocal};
use libration_numbers::{
    algebra::Ring,
    internals::algebra::{HarmonicPair, Place},
};

/// The series of a family by powers of its variable, and of its amplitudes.
#[derive(Clone, Debug)]
pub struct SeriesSet<E> {
    pub frequency: Vec<E>,
    pub(crate) harmonics: Vec<Vec<HarmonicPair<E>>>,
    pub x_max: Vec<E>,
    pub x_min: Vec<E>,
    pub(crate) of_amplitude: Option<OfAmplitude<E>>,
    pub(crate) of_half_swing: Option<OfAmplitude<E>>,
}

/// The series by powers of an amplitude. Harmonics are cosines, of mirrored motions sines.
#[derive(Clone, Debug)]
pub(crate) struct OfAmplitude<E> {
    pub(crate) frequency: Vec<E>,
    pub(crate) period: Vec<E>,
    pub(crate) epsilon: Vec<E>,
    pub(crate) harmonics: Vec<Vec<E>>,
}

impl<E: Clone> SeriesSet<E> {
    /// All series of a family; `None` when a number is not in the ring.
    pub(crate) fn new<R: Ring<Element = E>>(ring: &R, family: Family<E>, shape: Shape) -> Option<Self> {
        let turning_points = shape.turning_points(ring, &family)?;
        Self::with_turning_points(ring, family, turning_points, shape)
    }

    /// The same where the turning points are not sums of the harmonics that are known.
    pub(crate) fn with_turning_points<R: Ring<Element = E>>(
        ring: &R,
        family: Family<E>,
        turning_points: BothTurns<E>,
        shape: Shape,
    ) -> Option<Self> {
        let of = |amplitude: &[E]| OfAmplitude::new(ring, &family, amplitude, shape.wave());
        let of_amplitude = if shape == Shape::Cycle { None } else { Some(of(&turning_points.0)?) };
        let of_half_swing = match shape {
            Shape::Asymmetric => Some(of(&half_swing(ring, &turning_points)?)?),
            _ => None,
        };
        let (x_max, x_min) = turning_points;
        let Family { frequency, harmonics } = family;
        Some(Self { frequency, harmonics, x_max, x_min, of_amplitude, of_half_swing })
    }

    /// The numbers of all series, in a fixed order.
    pub(crate) fn numbers(&self) -> Vec<E> {
        let mut numbers = vec![];
        self.each(&mut |number: &E| numbers.push(number.clone()));
        numbers
    }

    fn each(&self, visit: &mut impl FnMut(&E)) {
        self.frequency.iter().for_each(&mut *visit);
        for harmonic in self.harmonics.iter().flatten() {
            visit(&harmonic.cosine);
            visit(&harmonic.sine);
        }
        self.x_max.iter().chain(&self.x_min).for_each(&mut *visit);
        for of in [&self.of_amplitude, &self.of_half_swing].into_iter().flatten() {
            let series = of.frequency.iter().chain(&of.period).chain(&of.epsilon);
            series.chain(of.harmonics.iter().flatten()).for_each(&mut *visit);
        }
    }

    /// The least order of an expansion that contains each number, in the order of [`Self::numbers`], if this one extends to `order`; series in one
    /// variable are a family.
    pub(crate) fn places(&self, order: usize) -> Vec<Place> {
        let of = |family: usize, series: &[E]| places_of(family, series.len(), order);
        let of_variable = |family: usize, of_own: &OfAmplitude<E>| OfAmplitude {
            frequency: of(family, &of_own.frequency),
            period: of(family, &of_own.period),
            epsilon: of(family, &of_own.epsilon),
            harmonics: of_own.harmonics.iter().map(|series| of(family, series)).collect(),
        };
        let both = |position: Place| HarmonicPair { cosine: position, sine: position };
        let of_harmonic =
            |series: &Vec<HarmonicPair<E>>| places_of(0, series.len(), order).into_iter().map(both).collect();
        let positions = SeriesSet {
            frequency: of(0, &self.frequency),
            harmonics: self.harmonics.iter().map(of_harmonic).collect(),
            x_max: of(0, &self.x_max),
            x_min: of(0, &self.x_min),
            of_amplitude: self.of_amplitude.as_ref().map(|of_amplitude| of_variable(1, of_amplitude)),
            of_half_swing: self.of_half_swing.as_ref().map(|of_half_swing| of_variable(2, of_half_swing)),
        };
        positions.numbers()
    }

    /// The set of an expansion to a lower order.
    pub(crate) fn without_last(mut self, orders: usize) -> Self {
        fn shortened<T>(series: &mut Vec<T>, orders: usize) {
            series.truncate(series.len().saturating_sub(orders));
        }
        for series in [&mut self.frequency, &mut self.x_max, &mut self.x_min] {
            shortened(series, orders);
        }
        self.harmonics.iter_mut().for_each(|series| shortened(series, orders));
        for of in [&mut self.of_amplitude, &mut self.of_half_swing].into_iter().flatten() {
            let series = [&mut of.frequency, &mut of.period, &mut of.epsilon];
            series.into_iter().chain(&mut of.harmonics).for_each(|series| shortened(series, orders));
        }
        self
    }

    /// The part of the set that another one, of a lower order, has too.
    pub(crate) fn in_common_with(self, lower: &Self) -> Self {
        let orders = self.order().saturating_sub(lower.order());
        let mut common = self.without_last(orders);
        common.harmonics.truncate(lower.harmonics.len());
        let pairs = [
            (&mut common.of_amplitude, &lower.of_amplitude),
            (&mut common.of_half_swing, &lower.of_half_swing),
        ];
        for (set, lower) in pairs {
            if let (Some(higher), Some(lower)) = (set, lower) {
                higher.harmonics.truncate(lower.harmonics.len());
            }
        }
        common
    }

    /// The order to which the displacement is given.
    pub(crate) fn order(&self) -> usize {
        self.x_max.len().saturating_sub(1)
    }

    /// The set with other numbers, taken in the order of [`Self::numbers`]; `None` if there are too few.
    pub(crate) fn with_numbers<T>(&self, mut numbers: impl Iterator<Item = T>) -> Option<SeriesSet<T>> {
        let mut list = |length: usize| (0..length).map(|_| numbers.next()).collect::<Option<Vec<T>>>();
        let frequency = list(self.frequency.len())?;
        let mut harmonics = vec![];
        for series in &self.harmonics {
            let mut pairs = list(2 * series.len())?.into_iter();
            let next = || Some(HarmonicPair { cosine: pairs.next()?, sine: pairs.next()? });
            harmonics.push(std::iter::from_fn(next).collect());
        }
        let (x_max, x_min) = (list(self.x_max.len())?, list(self.x_min.len())?);
        let mut of = |of: &Option<OfAmplitude<E>>| match of {
            None => Some(None),
            Some(of) => {
                let (frequency, period) = (list(of.frequency.len())?, list(of.period.len())?);
                let epsilon = list(of.epsilon.len())?;
                let harmonics = of.harmonics.iter().map(|h| list(h.len())).collect::<Option<_>>()?;
                Some(Some(OfAmplitude { frequency, period, epsilon, harmonics }))
            }
        };
        let (of_amplitude, of_half_swing) = (of(&self.of_amplitude)?, of(&self.of_half_swing)?);
        Some(SeriesSet { frequency, harmonics, x_max, x_min, of_amplitude, of_half_swing })
    }
}

impl<E: Clone> OfAmplitude<E> {
    fn new<R: Ring<Element = E>>(ring: &R, family: &Family<E>, amplitude: &[E], wave: Wave) -> Option<Self> {
        let inverse = powers_of_inverse(ring, amplitude)?;
        let Family { frequency, harmonics } = composed(ring, family, &inverse);
        let period = reciprocal(ring, &frequency)?;
        let harmonics =
            harmonics.into_iter().map(|h| h.into_iter().map(|pair| wave.of(pair)).collect()).collect();
        Some(Self { frequency, period, epsilon: inverse.first(), harmonics })
    }
}

/// The positions of the terms of a series, whose last term has the order of the expansion.
fn places_of(family: usize, length: usize, order: usize) -> Vec<Place> {
    let position = |n: usize| Place { order: (n + order + 1).saturating_sub(length), family };
    (0..length).map(position).collect()
}

/// The family with its variable replaced by a series in another one.
pub(crate) fn substituted<R: Ring>(
    ring: &R,
    family: &Family<R::Element>,
    variable: &[R::Element],
) -> Option<Family<R::Element>> {
    Some(composed(ring, family, &powers(ring, variable)?))
}

/// The family with the inverse function of a series for its variable.
pub(crate) fn by_inverse<R: Ring>(
    ring: &R,
    family: &Family<R::Element>,
    series: &[R::Element],
) -> Option<Family<R::Element>> {
    Some(composed(ring, family, &powers_of_inverse(ring, series)?))
}

pub(crate) fn composed<R: Ring>(
    ring: &R,
    family: &Family<R::Element>,
    powers: &SeriesPowers<R::Element>,
) -> Family<R::Element> {
    let compose = |part: fn(&HarmonicPair<R::Element>) -> &R::Element,
                   series: &[HarmonicPair<R::Element>]| {
        powers.composed(ring, &series.iter().map(|h| part(h).clone()).collect::<Vec<_>>())
    };
    let harmonic = |series: &Vec<HarmonicPair<R::Element>>| {
        let (cosines, sines) = (compose(|h| &h.cosine, series), compose(|h| &h.sine, series));
        cosines.into_iter().zip(sines).map(|(cosine, sine)| HarmonicPair { cosine, sine }).collect()
    };
    Family {
        frequency: powers.composed(ring, &family.frequency),
        harmonics: family.harmonics.iter().map(harmonic).collect(),
    }
}

/// Half the distance between the turning points.
pub(crate) fn half_swing<R: Ring>(
    ring: &R,
    (x_max, x_min): &BothTurns<R::Element>,
) -> Option<Vec<R::Element>> {
    x_max.iter().zip(x_min).map(|(max, min)| ring.over_integer(&ring.subtract(max, min), 2)).collect()
}
