//! Forces that may be hidden in a step: in `f64` they have no effect at its start, but act inside it.
//!
//! Far out, e^(−x²) underflows in every coefficient, and also at the end of a step that passes to the other side. So a step ends where such a
//! formula is largest or smallest: there the equations of motion show its effect.
//!
//! # Method
//! Terms that act only inside a step (e^(−x²), 1/cosh² x, (1 + x²)^(−50), a high power on the way to a turning point and back) are expected if
//! an exponent, a hyperbolic argument, a divisor or the base of a high power changes by more than the series can represent. The step ends where
//! that quantity turns, and is compared with the equations inside too, at points closer and closer to its end.

use super::boundary::reached;
use crate::taylor::step::block::{Block, Row};
use crate::taylor::step::largest_change::{largest_change, largest_changes};
use crate::taylor::step::sign_change::{scaled, sign_changes};
use libration_kernels::elementary::count;
use libration_numbers::internals::algebra::Growth;
use libration_numbers::internals::expression::{Operation, Tape};

/// The way in which a value on the tape enters an expression that can change by orders of magnitude.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Enters {
    Exponent,
    /// cosh, sinh and tanh: they are smallest, or turn fastest, at zero.
    Hyperbolic,
    /// A divisor, through a power whose exponent may be large.
    Divisor,
    /// A factor, with this exponent.
    Power(f64),
}

/// A value on the tape, given by its slot, that is the argument of a steep function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::taylor) struct Steep<P> {
    pub(in crate::taylor) of: P,
    enters: Enters,
    followed: Followed,
}

impl<P> Steep<P> {
    fn new(of: P, enters: Enters) -> Self {
        Self { of, enters, followed: enters.followed() }
    }

    pub(in crate::taylor) fn divisor(of: P) -> Self {
        Self::new(of, Enters::Divisor)
    }

    /// The same argument with another slot.
    pub(in crate::taylor) fn moved<Q>(&self, of: Q) -> Steep<Q> {
        Steep { of, enters: self.enters, followed: self.followed }
    }
}

/// The arguments of such functions in the first `formulas` formulas on a tape, and the bases of powers beyond a third of the order: about zero,
/// series of this order contain hardly any terms of these powers, or none.
pub(in crate::taylor) fn steep_places(tape: &Tape, formulas: usize, order: usize) -> Vec<Steep<usize>> {
    let high = |&(_, exponent): &(usize, f64)| 3.0 * exponent > count(order);
    let powers = powers(tape, formulas).into_iter().filter(high);
    let mut list: Vec<_> = powers.map(|(of, exponent)| Steep::new(of, Enters::Power(exponent))).collect();
    for slot in reached(tape, formulas) {
        let steep = match tape.operations()[slot] {
            Operation::Exp(of) => Steep::new(of, Enters::Exponent),
            Operation::Paired { function, of, .. } | Operation::Tangent { function, of }
                if function.growth() == Growth::Hyperbolic =>
            {
                Steep::new(of, Enters::Hyperbolic)
            }
            _ => continue,
        };
        if !tape.is_constant(steep.of) && !list.contains(&steep) {
            list.push(steep);
        }
    }
    list
}

/// The factors of products that are powers, each with the largest exponent.
fn powers(tape: &Tape, formulas: usize) -> Vec<(usize, f64)> {
    let mut of: Vec<(usize, f64)> = (0..tape.operations().len()).map(|slot| (slot, 1.0)).collect();
    for (slot, operation) in tape.operations().iter().enumerate() {
        match *operation {
            Operation::Multiply(a, b) if of[a].0 == of[b].0 => of[slot] = (of[a].0, of[a].1 + of[b].1),
            Operation::Power(a, ref exponent) => of[slot] = (of[a].0, of[a].1 * exponent.to_f64()),
            _ => {}
        }
    }
    let mut largest: Vec<(usize, f64)> = vec![];
    for slot in reached(tape, formulas).into_iter().filter(|&slot| !tape.is_constant(slot)) {
        let (base, exponent) = of[slot];
        match largest.iter_mut().find(|(other, _)| *other == base) {
            Some((_, most)) => *most = most.max(exponent),
            None => largest.push((base, exponent)),
        }
    }
    largest
}

/// The changes that the series can represent.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Followed {
    /// Change of the expression that contains the value, in powers of e.
    powers: f64,
    /// Change of the value below which the expression always changes by less: a number, and a fraction of its size.
    change: f64,
    part: f64,
}

impl Enters {
    fn followed(self) -> Followed {
        /// Change in powers of e: the terms of eᶻ decrease from the order z on, and the smallest order is 6.
        const POWERS: f64 = 6.0;
        let no_change = Followed { powers: POWERS, change: 0.0, part: 0.0 };
        match self {
            Self::Exponent | Self::Hyperbolic => Followed { change: POWERS, ..no_change },
            Self::Power(exponent) => Followed { part: libm::expm1(POWERS / exponent), ..no_change },
            // A change so small that the tenth or hundredth power does not vanish either.
            Self::Divisor => Followed { powers: 1.0, part: -libm::expm1(-1.0), ..no_change },
        }
    }
}

impl Followed {
    #[inline(always)]
    fn includes(&self, change: f64, value: f64) -> bool {
        change < self.change + self.part * value.abs()
    }
}

/// Distance from zero, relative to its size, below which a divisor may touch zero; this is the case of a boundary.
const BLUR: f64 = 1e-12;

impl Steep<Row> {
    /// Returns `true` if the value changes by more than the series can represent in a step of this length, in units of the block.
    pub(in crate::taylor) fn is_unseen<const N: usize>(
        &self,
        block: &Block<N>,
        lane: usize,
        length: f64,
    ) -> bool {
        let series = &block[self.of];
        !self.followed.includes(largest_change(series, lane, length), series[0][lane])
            && (self.enters != Enters::Divisor || self.first_turn(block, lane, length).is_some())
    }

    /// Returns `true` if the value changes by less in all lanes, in steps of these lengths.
    #[inline(always)]
    pub(in crate::taylor) fn is_seen<const N: usize>(&self, block: &Block<N>, lengths: &[f64; N]) -> bool {
        let series = &block[self.of];
        let changes = largest_changes(series, lengths);
        let mut is_seen = true;
        for lane in 0..N {
            is_seen &= self.followed.includes(changes[lane], series[0][lane]);
        }
        is_seen
    }

    /// The fraction of a step of this length after which the argument has its
    /// first maximum or minimum, if that is far from the value at the start.
    pub(in crate::taylor) fn first_turn<const N: usize>(
        &self,
        block: &Block<N>,
        lane: usize,
        length: f64,
    ) -> Option<f64> {
        self.first_turn_of(&scaled(block[self.of].iter().map(|c| c[lane]), length))
    }
}

impl<P> Steep<P> {
    /// The same fraction, given the series of the argument in powers of the fraction of a step.
    pub(in crate::taylor) fn first_turn_of(&self, series: &[f64]) -> Option<f64> {
        if series.iter().any(|c| !c.is_finite()) {
            return None;
        }
        let slopes: Vec<f64> = series[1..].iter().zip((1..).map(f64::from)).map(|(c, n)| n * c).collect();
        let mut turns = sign_changes(&slopes);
        match self.enters {
            Enters::Exponent | Enters::Power(_) => {}
            Enters::Hyperbolic => turns.extend(sign_changes(series)),
            // The zero of a divisor is a boundary.
            Enters::Divisor if sign_changes(series).is_empty() => {}
            Enters::Divisor => return None,
        }
        let value = |part: f64| series.iter().rev().fold(0.0, |sum, c| sum * part + c);
        let blur = BLUR * series.iter().map(|c| c.abs()).sum::<f64>();
        let touches = |value: f64| self.enters == Enters::Divisor && value.abs() <= blur;
        let is_far = |part: &f64| {
            let value = value(*part);
            self.change(series[0], value) > self.followed.powers && !touches(value)
        };
        turns.into_iter().filter(is_far).reduce(f64::min)
    }

    /// The change of the expression that contains the value, between two of its values, in powers of e.
    fn change(&self, from: f64, to: f64) -> f64 {
        match self.enters {
            Enters::Exponent => (to - from).abs(),
            Enters::Hyperbolic => (to.abs() - from.abs()).abs(),
            Enters::Divisor => libm::log((to / from).abs()).abs(),
            Enters::Power(exponent) => exponent * libm::log((to / from).abs()),
        }
    }
}
