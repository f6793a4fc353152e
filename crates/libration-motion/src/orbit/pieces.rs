//! Check of a strongly unstable orbit, piece by piece.

use super::shooting::Newton;
use crate::periodic::{Checked, Frame, Piece};

impl Newton<'_> {
    /// `true` if there is an orbit of the equation within the errors of this one, integrated piece by piece over its period. The components that
    /// Newton's method holds keep their values. `growth` is that of deviations over the period.
    pub(super) fn closes_by_pieces(&self, start: &[f64], period: f64, growth: f64) -> bool {
        let numbers = start.len();
        let is_own = self.unknowns.period;
        let period_alone = is_own.then_some(self.at.period);
        let unknowns: Vec<f64> = self.at.state.iter().copied().chain(period_alone).collect();
        let units: Vec<f64> = self.sizes.iter().copied().chain(period_alone).collect();
        let errors = start.iter().zip(&self.sizes).map(|(error, size)| error / size);
        let errors: Vec<f64> = errors.chain(is_own.then_some(period / self.at.period)).collect();
        let held = (0..numbers).filter(|number| !self.unknowns.free.contains(number));
        let conditions: Vec<Vec<f64>> = held
            .map(|held| (0..units.len()).map(|number| if number == held { 1.0 } else { 0.0 }).collect())
            .collect();
        let shift = vec![0.0; numbers];
        let frame = Frame { units: &units, shift: &shift, conditions: &conditions };
        let piece = |parts: [f64; 2], state: &[f64], further: &[f64]| {
            let whole = further.first().copied().unwrap_or(self.at.period);
            let times = parts.map(|part| whole * part);
            let variations = self.rounds.variations(state, times).ok()?;
            let mut by_further = vec![];
            if is_own {
                let rates = variations.rates.each_ref().map(|rate| &rate[..]);
                by_further.push(Piece::by_duration(&variations.by_start, rates, parts));
            }
            Some(Piece { end: variations.end, by_start: variations.by_start, by_further })
        };
        let state_at = |part: f64| Some(self.round.path.state_at(part * self.at.period));
        Checked { frame, position: &unknowns, errors: &errors, growth }.closes(state_at, piece)
    }
}
