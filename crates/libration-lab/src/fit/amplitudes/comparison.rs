//! Comparison of the laws by Akaike's criterion.

use super::law::DecayLaw;
use super::search::{DecayLawFit, first_zero, fit, parameters};
use super::{AmplitudeTable, AmplitudesError};
use crate::fit::cycles::SEPARATED;
use crate::fit::damping_model::DampingModel;
use crate::fit::significance::limit_of_chance;
use crate::statistics::student::probability_beyond;
use crate::statistics::{akaike, count};
use libration::internals::InOrder;

/// All laws that could be fitted, and the choice among them.
pub(super) struct LawComparison<'a> {
    pub(super) law: DecayLaw<'a>,
    /// Laws with at least one kind of damping: simpler ones first, and laws of the same number of kinds by their misfit.
    pub(super) laws: Vec<Compared>,
    /// Index of the law that is reported.
    pub(super) chosen: usize,
    /// `true` if the reported law was given.
    pub(super) is_given: bool,
    /// Index of the simplest law that the rows do not separate from the best one.
    pub(super) preferred: usize,
    /// Excess above which the rows separate a law from the best one.
    separated: f64,
}

/// A law with its standing.
pub(super) struct Compared {
    pub(super) fit: DecayLawFit,
    /// `None` where the rows are too few for the criterion.
    pub(super) aicc: Option<f64>,
    /// Excess of the criterion, or of the misfit where there is none, over the least one.
    pub(super) excess: f64,
    /// The probability that chance makes the improvement over the best simpler law as large.
    pub(super) chance: Option<f64>,
}

impl<'a> LawComparison<'a> {
    /// Fits all laws, and chooses the given one, or the simplest one that is not separated from the best.
    pub(super) fn new(
        table: &'a AmplitudeTable,
        given: Option<DampingModel>,
    ) -> Result<Self, AmplitudesError> {
        let needed = parameters(table, DampingModel::UNDAMPED) + 1 + usize::from(!table.weighted);
        if table.len() < needed {
            return Err(AmplitudesError::TooFewRows { rows: table.len(), needed });
        }
        let zero = first_zero(table);
        let readings = table.rows.iter().map(|row| (row.value - zero).abs());
        let law = DecayLaw::new(table, 1.2 * table.reading.amplitude(readings.fold(0.0, f64::max)));
        let mut fits: Vec<DecayLawFit> =
            DampingModel::all().into_iter().filter_map(|terms| fit(&law, terms)).collect();
        let is_physical =
            |fit: &DecayLawFit| fit.parameters[1..=fit.terms.count()].iter().all(|&rate| rate >= 0.0);
        if let Some(terms) = given
            && !fits.iter().any(|fit| fit.terms == terms && is_physical(fit))
        {
            return Err(AmplitudesError::Law(terms));
        }
        fits.retain(is_physical);
        let laws = compared(table, &fits);
        let separated = separated(table);
        let preferred =
            laws.iter().position(|law| law.excess <= separated).ok_or(AmplitudesError::NotFalling)?;
        let chosen = given.and_then(|terms| laws.iter().position(|law| law.fit.terms == terms));
        if let (Some(terms), None) = (given, chosen) {
            return Err(AmplitudesError::Law(terms));
        }
        let (chosen, is_given) = (chosen.unwrap_or(preferred), given.is_some());
        Ok(Self { law, laws, chosen, is_given, preferred, separated })
    }

    /// Other laws that the rows do not separate from the preferred one; none where a law is given.
    pub(super) fn not_separated(&self) -> impl Iterator<Item = &Compared> {
        let others =
            self.laws.iter().enumerate().filter(|(index, _)| !self.is_given && *index != self.chosen);
        others.map(|(_, law)| law).filter(|law| law.excess <= self.separated)
    }

    /// The Akaike weight of a law: e^(−Δ/2), where the excess Δ is scaled so that the limit of separation, which depends on the degrees of freedom,
    /// becomes that of known scatter.
    pub(super) fn weight(&self, law: &Compared) -> f64 {
        libm::exp(-0.5 * law.excess.max(0.0) * SEPARATED / self.separated)
    }

    /// The law that the rows prefer to a given one, which they refute.
    pub(super) fn preferred_to_given(&self) -> Option<&Compared> {
        (self.laws[self.chosen].excess > self.separated).then(|| &self.laws[self.preferred])
    }
}

/// The excess from which laws are separated: an improvement of χ² by 4, which chance gives a wrong law over the right one at most in one table in 44;
/// where the scatter is unknown the excess n ln(1 + t²/ν) that is as improbable by Student's t with ν degrees of freedom.
fn separated(table: &AmplitudeTable) -> f64 {
    let one_kind = DampingModel::all().into_iter().find(|terms| terms.count() == 1);
    let parameters = one_kind.map_or(0, |terms| parameters(table, terms));
    match table.len().checked_sub(parameters).filter(|dof| !table.weighted && *dof > 0).map(count) {
        Some(dof) => {
            let t = limit_of_chance(SEPARATED.sqrt(), dof);
            SEPARATED.max(count(table.len()) * libm::log1p(t * t / dof))
        }
        None => SEPARATED,
    }
}

fn compared(table: &AmplitudeTable, fits: &[DecayLawFit]) -> Vec<Compared> {
    let rows = count(table.len());
    let dof = |fit: &DecayLawFit| table.len() - parameters(table, fit.terms);
    // Stated uncertainties that are too small by one factor would separate laws that they do not.
    let birge = fits.iter().filter(|fit| dof(fit) > 0).map(|fit| fit.chi2 / count(dof(fit)));
    let scale = if table.weighted { birge.fold(f64::INFINITY, f64::min).clamp(1.0, f64::MAX) } else { 1.0 };
    let misfit = |fit: &DecayLawFit| {
        let spread: f64 = fit.deviations.iter().map(|deviation| 2.0 * libm::log(*deviation)).sum();
        match table.weighted {
            true => fit.chi2 / scale + spread,
            false => akaike::misfit_of_scatter(fit.chi2 / rows, rows) + spread,
        }
    };
    let aicc = |fit: &DecayLawFit| {
        let parameters = parameters(table, fit.terms) + usize::from(!table.weighted);
        Some(misfit(fit) + akaike::cost(rows, count(parameters))?)
    };
    let damped = || fits.iter().filter(|fit| fit.terms != DampingModel::UNDAMPED);
    let has_criterion = damped().any(|fit| aicc(fit).is_some());
    // Where the rows are too few for the criterion laws of one kind of damping compare by their misfit.
    let score = |fit: &DecayLawFit| match has_criterion {
        true => aicc(fit),
        false => (fit.terms.count() == 1).then(|| misfit(fit)),
    };
    let least = damped().filter_map(score).fold(f64::INFINITY, f64::min);
    let mut laws: Vec<Compared> = damped()
        .map(|fit| Compared {
            aicc: aicc(fit),
            excess: score(fit).map_or(f64::INFINITY, |score| score - least),
            chance: chance(fit, fits, dof(fit)),
            fit: fit.clone(),
        })
        .collect();
    laws.put_in_order(|a, b| {
        a.fit.terms.count().cmp(&b.fit.terms.count()).then(a.excess.total_cmp(&b.excess))
    });
    laws
}

/// Probability by the F test of the last term. It uses the scatter, so that a common factor of all uncertainties does not matter.
fn chance(law: &DecayLawFit, all: &[DecayLawFit], dof: usize) -> Option<f64> {
    let simpler = all.iter().filter(|fit| fit.terms.count() + 1 == law.terms.count());
    let simpler = simpler.filter(|simpler| simpler.terms.is_part_of(law.terms)).map(|simpler| simpler.chi2);
    let simpler = simpler.fold(f64::INFINITY, f64::min);
    (dof > 0 && simpler.is_finite()).then(|| {
        let square = (simpler - law.chi2).max(0.0) / (law.chi2 / count(dof));
        if square.is_nan() { 1.0 } else { probability_beyond(square.sqrt(), dof) }
    })
}
