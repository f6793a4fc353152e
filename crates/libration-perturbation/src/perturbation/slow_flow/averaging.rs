//! Krylov, Bogoliubov and Mitropolsky's averaging, one power of the amplitude after the other.
//!
//! With x = xₑ + Σ Aⁿγʲxₙⱼ(ψ), ψ′ = Σ Aⁿγʲwₙⱼ and A′ = A·Σ Aⁿγʲαₙⱼ the time derivative is D = ψ′∂ψ + A′∂A, and the equation of
//! motion D²x = F(x, Dx) reads for Aⁿγʲ, with ω0 = w₀₀ and x₁₀ = cos ψ,
//!
//! ```text
//! ω0²(xₙⱼ″ + xₙⱼ) = Rₙⱼ + 2ω0(wₙ₋₁,ⱼ·cos ψ + αₙ₋₁,ⱼ·sin ψ),
//! ```
//!
//! where Rₙⱼ is known from what comes before. That the motion goes on as it began fixes wₙ₋₁,ⱼ and αₙ₋₁,ⱼ; a free wave of xₙⱼ is
//! left, which the meaning of A fixes.
//!
//! The small parameter is ε = γA^q. As a rule q = 0; where its force does not vanish with the amplitude, as dry friction, q = 1
//! makes it one order higher, and A∂A is n − qj.

use super::phase_functions::{Coefficient, PhaseFunctions, Response};
use libration_numbers::internals::expression::{Jet, Tape};
use libration_numbers::internals::progress::Watch;
use libration_numbers::series::PowerSeries;
use libration_numbers::{algebra::Ring, internals::algebra::HarmonicPair};

/// The definition of A.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Amplitude {
    /// The first harmonic is A·cos ψ.
    FirstHarmonic,
    /// The motion turns at A for ψ = 0.
    TurningPoint,
}

/// The equation to average, and the orders.
#[derive(Debug)]
pub(super) struct Averaging<'a, R: PhaseFunctions> {
    /// The acceleration as a function of x, x′ and ε.
    pub(super) tape: &'a Tape,
    pub(super) equilibrium: R::Element,
    pub(super) omega0: Coefficient<R>,
    pub(super) amplitude: Amplitude,
    /// q.
    pub(super) lift: usize,
    /// The highest n.
    pub(super) order: usize,
    /// The highest j.
    pub(super) parameter_order: usize,
}

/// xₙⱼ, αₙⱼ and wₙⱼ, by n and j.
pub(super) struct Averaged<R: PhaseFunctions> {
    pub(super) displacement: Vec<Vec<R::Element>>,
    pub(super) growth: Vec<Vec<Coefficient<R>>>,
    pub(super) frequency: Vec<Vec<Coefficient<R>>>,
}

/// The reason why there are no series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Failed {
    /// A number that is not in the ring, or a force without power series.
    NoSeries,
    /// The equilibrium moves with the parameter, although q = 0.
    MovingEquilibrium,
    Interrupted,
}

impl<R: PhaseFunctions + Clone> Averaging<'_, R> {
    pub(super) fn solve(&self, ring: &R, watch: &Watch<'_>) -> Result<Averaged<R>, Failed> {
        let series = PowerSeries { coefficients: ring.clone(), terms: self.parameter_order + 1 };
        let mut solution = Solution::new(self, &series).ok_or(Failed::NoSeries)?;
        if solution.jet.result(0).iter().any(|value| !series.is_zero(value)) {
            return Err(Failed::MovingEquilibrium);
        }
        for n in 1..=self.order {
            watch.reached(n).map_err(|_| Failed::Interrupted)?;
            solution.extend(n).ok_or(Failed::NoSeries)?;
        }
        Ok(solution.averaged)
    }
}

struct Solution<'a, R: PhaseFunctions> {
    question: &'a Averaging<'a, R>,
    series: &'a PowerSeries<R>,
    jet: Jet<'a, PowerSeries<R>>,
    position_gains: Vec<Vec<R::Element>>,
    velocity_gains: Vec<Vec<R::Element>>,
    averaged: Averaged<R>,
    /// vₙⱼ of the velocity Dx.
    velocity: Vec<Vec<R::Element>>,
}

impl<'a, R: PhaseFunctions> Solution<'a, R> {
    fn new(question: &'a Averaging<'a, R>, series: &'a PowerSeries<R>) -> Option<Self> {
        let ring = &series.coefficients;
        let mut displacement = series.zero();
        displacement[0] = question.equilibrium.clone();
        let parameter = if question.lift == 0 { series.variable()? } else { series.zero() };
        let jet = Jet::new(series, question.tape, &[displacement, series.zero(), parameter]).ok()?;
        let numbers = vec![vec![ring.numbers().zero(); series.terms]; question.order + 1];
        Some(Self {
            question,
            series,
            position_gains: jet.gains(0).ok()?,
            velocity_gains: jet.gains(1).ok()?,
            jet,
            averaged: Averaged {
                displacement: vec![series.zero()],
                growth: numbers.clone(),
                frequency: numbers,
            },
            velocity: vec![series.zero()],
        })
    }

    /// Solves the equations of Aⁿ, one power of γ after the other.
    fn extend(&mut self, n: usize) -> Option<()> {
        let lifted = self.question.lift == 1 && n == 1;
        let parameter = if lifted { self.series.variable()? } else { self.series.zero() };
        self.jet.extend(&[self.series.zero(), self.series.zero(), parameter]).ok()?;
        self.averaged.displacement.push(self.series.zero());
        self.velocity.push(self.series.zero());
        for j in 0..self.series.terms {
            if (n, j) == (1, 0) {
                self.begin()?;
            } else {
                self.solve(n, j)?;
            }
            let only = |list: &[R::Element]| {
                let mut series = self.series.zero();
                series[j] = list[j].clone();
                series
            };
            let (position, velocity) = (only(&self.averaged.displacement[n]), only(&self.velocity[n]));
            self.jet.amend(&self.position_gains, &position);
            self.jet.amend(&self.velocity_gains, &velocity);
        }
        Some(())
    }

    /// x₁₀ = cos ψ.
    fn begin(&mut self) -> Option<()> {
        let (ring, omega0) = (&self.series.coefficients, &self.question.omega0);
        let numbers = ring.numbers();
        let one = numbers.rational(&1.into())?;
        self.averaged.frequency[0][0] = omega0.clone();
        let wave = |cosine, sine| ring.wave(HarmonicPair { cosine, sine });
        self.averaged.displacement[1][0] = wave(one, numbers.zero());
        self.velocity[1][0] = wave(numbers.zero(), numbers.negate(omega0));
        Some(())
    }

    fn solve(&mut self, n: usize, j: usize) -> Option<()> {
        let ring = &self.series.coefficients;
        let (numbers, omega0) = (ring.numbers(), &self.question.omega0);
        let drift = self.transported(&self.averaged.displacement, n, j);
        self.velocity[n][j] = drift.clone();
        let residual = ring.subtract(&self.jet.result(0)[n][j], &self.transported(&self.velocity, n, j));
        let Response { secular, forced } = ring.response(&residual)?;
        let rate = |part| numbers.divide(&numbers.negate(part), &numbers.times_integer(omega0, 2));
        let (frequency, growth) = (rate(&secular.cosine)?, rate(&secular.sine)?);
        let compliance = numbers.divide(&numbers.rational(&1.into())?, &numbers.multiply(omega0, omega0))?;
        let forced = ring.times_number(&forced, &compliance);
        let free = match self.question.amplitude {
            Amplitude::FirstHarmonic => None,
            Amplitude::TurningPoint => Some(self.free_wave(&forced, &drift, &growth)?),
        };
        let displacement = free.map_or_else(|| forced.clone(), |free| ring.add(&forced, &ring.wave(free)));
        let turn = HarmonicPair { cosine: growth.clone(), sine: numbers.negate(&frequency) };
        let fast = ring.times_number(&ring.slope(&displacement), omega0);
        self.velocity[n][j] = ring.add(&ring.add(&drift, &fast), &ring.wave(turn));
        self.averaged.displacement[n][j] = displacement;
        self.averaged.frequency[n - 1][j] = frequency;
        self.averaged.growth[n - 1][j] = growth;
        Some(())
    }

    /// The wave in addition to a forced motion with which neither xₙⱼ nor vₙⱼ has a value at ψ = 0.
    fn free_wave(
        &self,
        forced: &R::Element,
        drift: &R::Element,
        growth: &Coefficient<R>,
    ) -> Option<HarmonicPair<Coefficient<R>>> {
        let ring = &self.series.coefficients;
        let numbers = ring.numbers();
        let slow = numbers.divide(&numbers.add(&ring.at_start(drift), growth), &self.question.omega0)?;
        Some(HarmonicPair {
            cosine: numbers.negate(&ring.at_start(forced)),
            sine: numbers.negate(&numbers.add(&ring.at_start(&ring.slope(forced)), &slow)),
        })
    }

    /// The part of Aⁿγʲ in Dg that is known: Σ wₙ₋ₘ,ⱼ₋ᵢ·gₘᵢ′ + (m − qi)·αₙ₋ₘ,ⱼ₋ᵢ·gₘᵢ.
    fn transported(&self, g: &[Vec<R::Element>], n: usize, j: usize) -> R::Element {
        let ring = &self.series.coefficients;
        let numbers = ring.numbers();
        let mut sum = ring.zero();
        for (m, of_power) in g.iter().enumerate().take(n + 1).skip(1) {
            for (i, part) in of_power.iter().enumerate().take(j + 1).filter(|(_, part)| !ring.is_zero(part)) {
                let frequency = &self.averaged.frequency[n - m][j - i];
                if !numbers.is_zero(frequency) {
                    sum = ring.add(&sum, &ring.times_number(&ring.slope(part), frequency));
                }
                let degree =
                    i64::try_from(m).unwrap_or(0) - i64::try_from(self.question.lift * i).unwrap_or(0);
                let growth = numbers.times_integer(&self.averaged.growth[n - m][j - i], degree);
                if !numbers.is_zero(&growth) {
                    sum = ring.add(&sum, &ring.times_number(part, &growth));
                }
            }
        }
        sum
    }
}
