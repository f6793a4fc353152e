//! The Taylor series of a system about a state.

use super::System;
use crate::algebra::Doubles;
use crate::expression::{Jet, NoSeries};

/// Makes series about one state after the other, always in the same memory.
#[derive(Debug)]
pub(super) struct Expander<'a> {
    system: &'a System,
    order: u32,
    jet: Option<Jet<'a, Doubles>>,
    /// One coefficient of each input.
    inputs: Vec<f64>,
}

impl<'a> Expander<'a> {
    pub(super) fn new(system: &'a System, order: u32) -> Self {
        Self { system, order, jet: None, inputs: vec![] }
    }

    /// Fills in the coefficients up to the order, of the coordinates and then of the velocities, whose first are given.
    ///
    /// x₍ₙ₎ = v₍ₙ₋₁₎/n and v₍ₙ₎ = a₍ₙ₋₁₎/n, where each a₍ₙ₎ needs no more than x₍ₙ₎ and v₍ₙ₎.
    pub(super) fn expand(
        &mut self,
        time: f64,
        signs: &[f64],
        series: &mut [Vec<f64>],
    ) -> Result<(), NoSeries> {
        let coordinates = self.system.coordinates();
        self.begin(time, signs, series)?;
        for (n, divisor) in (1..).zip(1..=self.order) {
            for i in 0..coordinates {
                let (speed, acceleration) = (series[coordinates + i][n - 1], self.formula(i)[n - 1]);
                series[i].push(speed / f64::from(divisor));
                series[coordinates + i].push(acceleration / f64::from(divisor));
            }
            if divisor < self.order {
                self.extend(n, series)?;
            }
        }
        Ok(())
    }

    /// What stands between the bars of an absolute value, as a series of one term less than the order.
    pub(super) fn argument(&self, modulus: usize) -> &[f64] {
        self.formula(self.system.coordinates() + modulus)
    }

    /// The accelerations in a state, in the place of the series.
    pub(super) fn accelerations(&mut self, time: f64, signs: &[f64], state: &[f64]) -> Vec<f64> {
        let mut series: Vec<Vec<f64>> = state.iter().map(|&value| vec![value]).collect();
        match self.begin(time, signs, &mut series) {
            Ok(()) => (0..self.system.coordinates()).map(|i| self.formula(i)[0]).collect(),
            Err(_) => vec![f64::NAN; self.system.coordinates()],
        }
    }

    fn formula(&self, number: usize) -> &[f64] {
        self.jet.as_ref().map_or(&[], |jet| jet.result(number))
    }

    fn begin(&mut self, time: f64, signs: &[f64], series: &mut [Vec<f64>]) -> Result<(), NoSeries> {
        self.inputs.clear();
        for one in series {
            one.truncate(1);
            self.inputs.extend_from_slice(one);
        }
        self.inputs.push(time);
        self.inputs.extend_from_slice(signs);
        if let Some(jet) = &mut self.jet {
            return jet.restart(&self.inputs);
        }
        self.jet = Some(Jet::new(&Doubles, self.system.tape(), &self.inputs)?);
        Ok(())
    }

    fn extend(&mut self, n: usize, series: &[Vec<f64>]) -> Result<(), NoSeries> {
        for (input, one) in self.inputs.iter_mut().zip(series) {
            *input = one[n];
        }
        let others = &mut self.inputs[series.len()..];
        others.fill(0.0);
        others[0] = if n == 1 { 1.0 } else { 0.0 };
        self.jet.as_mut().map_or(Ok(()), |jet| jet.extend(&self.inputs))
    }
}
