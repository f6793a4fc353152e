//! Passes over elliptic integrals and functions with varying parameters.

use crate::work::{Failure, Work};
use libration::elliptic::{
    JacobiSlices, LengthMismatch, Moduli, complete_firsts, complete_seconds, incomplete_firsts,
    incomplete_seconds, jacobi_functions,
};
use std::time::{Duration, Instant};

impl Work {
    /// K of the parameters.
    pub(crate) fn complete_firsts(&mut self) -> Result<Duration, Failure> {
        self.timed(|it| complete_firsts(Moduli::Parameters(&it.parameters), &mut it.angles))
    }

    /// E of the parameters.
    pub(crate) fn complete_seconds(&mut self) -> Result<Duration, Failure> {
        self.timed(|it| complete_seconds(Moduli::Parameters(&it.parameters), &mut it.angles))
    }

    /// F of the amplitudes.
    pub(crate) fn incomplete_firsts(&mut self) -> Result<Duration, Failure> {
        self.timed(|it| incomplete_firsts(&it.amplitudes, Moduli::Parameters(&it.parameters), &mut it.angles))
    }

    /// E of the amplitudes.
    pub(crate) fn incomplete_seconds(&mut self) -> Result<Duration, Failure> {
        self.timed(|it| {
            incomplete_seconds(&it.amplitudes, Moduli::Parameters(&it.parameters), &mut it.angles)
        })
    }

    /// sn, cn, dn and am of the times.
    pub(crate) fn jacobi(&mut self) -> Result<Duration, Failure> {
        self.timed(|it| {
            let [dn, am] = &mut it.others;
            let results = JacobiSlices { sn: &mut it.angles, cn: &mut it.velocities, dn, am };
            jacobi_functions(&it.times, Moduli::Parameters(&it.parameters), results)
        })
    }

    fn timed(
        &mut self,
        pass: impl FnOnce(&mut Self) -> Result<(), LengthMismatch>,
    ) -> Result<Duration, Failure> {
        let [dn, am] = &mut self.others;
        for results in [&mut self.angles, &mut self.velocities, dn, am] {
            results.resize(self.parameters.len(), 0.0);
        }
        let start = Instant::now();
        pass(self)?;
        Ok(start.elapsed())
    }
}
