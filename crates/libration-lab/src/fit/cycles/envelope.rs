//! Which damping the falling amplitude prefers: each combination of dry friction, linear and quadratic damping through
//! the extremes, by the exact loss of energy at any amplitude, compared by what they leave.
//!
//! The comparison is Akaike's, corrected for few data: `AICc` = n ln(χ²/n) + 2k + 2k(k + 1)/(n − k − 1), k counting the
//! unknown noise too. Residuals that hang together count for fewer: n(1 − ρ)/(1 + ρ).
//!
//! Reference: K. P. Burnham and D. R. Anderson, *Model Selection and Multimodel Inference*, 2nd ed., Springer 2002,
//! doi:10.1007/b97636, sections 2.4 and 2.6.

use nalgebra::{DMatrix, DVector};

use super::decay_rates::DecayRates;
use super::{CyclesError, HalfSwing};
use crate::fit::trace::{DampingTerm, DampingTerms};
use crate::statistics::akaike;
use crate::statistics::{median, robust_deviation};

/// Laws whose `AICc` differ by less than this are not separated by the data.
pub const SEPARATED: f64 = 4.0;
const MOST_ROUNDS: usize = 30;
/// Extremes further from the curve than so many robust standard deviations do not count.
const OUTLIER: f64 = 6.0;
/// Fewer extremes than this tell nothing about the law.
const FEWEST: usize = 5;

/// A coefficient of the damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficient {
    /// Of which kind; it says the unit.
    pub term: DampingTerm,
    /// In the unit of the term.
    pub value: f64,
    /// From the scatter of the extremes, which may hang together.
    pub uncertainty: f64,
}

/// One law through the extremes.
#[derive(Clone, Debug, PartialEq)]
pub struct EnvelopeFit {
    /// Which kinds of damping it has.
    pub damping: DampingTerms,
    /// At the time of the first half swing, in radians.
    pub amplitude: f64,
    /// In the order of the terms.
    pub coefficients: Vec<Coefficient>,
    /// The root mean square of what it leaves, in radians.
    pub rms: f64,
    /// How much its `AICc` is above that of the best law.
    pub aicc_difference: f64,
    /// The amplitude at each half swing, in radians.
    pub fitted: Vec<f64>,
}

/// The laws of the falling amplitude, the best one first. A law in which a coefficient would be negative is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Envelope {
    /// At least one.
    pub fits: Vec<EnvelopeFit>,
    /// How many of the extremes are as good as independent.
    pub independent: f64,
    /// How many extremes are far from every law and do not count.
    pub outliers: usize,
}

impl Envelope {
    /// The law that the data prefer.
    #[must_use]
    pub fn preferred(&self) -> &EnvelopeFit {
        &self.fits[0]
    }

    /// The laws that the data do not separate from the preferred one: `AICc` within [`SEPARATED`] of it.
    pub fn not_separated(&self) -> impl Iterator<Item = &EnvelopeFit> {
        self.fits[1..].iter().filter(|fit| fit.aicc_difference < SEPARATED)
    }

    /// What the data say, as a sentence.
    #[must_use]
    pub fn verdict(&self) -> String {
        let preferred = named(self.preferred().damping);
        let others: Vec<String> = self.not_separated().map(|fit| named(fit.damping)).collect();
        match &others[..] {
            [] => format!("the falling amplitude prefers {preferred}"),
            others => format!(
                "the falling amplitude prefers {preferred}, but cannot separate it from {} (AICc within {SEPARATED})",
                others.join(", ")
            ),
        }
    }
}

fn named(damping: DampingTerms) -> String {
    if damping == DampingTerms::UNDAMPED { "no damping".to_owned() } else { format!("{damping} damping") }
}

/// The laws through these half swings of a pendulum of this ω0.
pub(super) fn envelope(half_swings: &[HalfSwing], omega0: f64) -> Result<Envelope, CyclesError> {
    if half_swings.len() < FEWEST {
        return Err(CyclesError::TooFewHalfSwings { found: half_swings.len(), needed: FEWEST });
    }
    let largest = half_swings.iter().map(|half| half.amplitude).fold(0.0, f64::max);
    let mut fall = Fall {
        half_swings,
        rates: DecayRates::new(omega0, largest),
        weights: half_swings.iter().map(|half| 1.0 / half.uncertainty.max(1e-9 * largest)).collect(),
        substep: std::f64::consts::PI / omega0,
    };
    let full = DampingTerms::all().into_iter().max_by_key(|terms| terms.count()).unwrap_or_default();
    let outliers = fall.drop_outliers(full);
    let curves: Vec<Curve> = DampingTerms::all().into_iter().filter_map(|terms| fall.fit(terms)).collect();
    let physical = |curve: &Curve| curve.parameters[1..].iter().all(|&coefficient| coefficient >= 0.0);
    let best = curves.iter().min_by(|a, b| a.chi2.total_cmp(&b.chi2));
    let counted = fall.weights.iter().filter(|&&weight| weight > 0.0).count();
    #[expect(clippy::cast_precision_loss, reason = "no trace in memory has 2^53 rows")]
    let counted = counted as f64;
    let independent = best.map_or(counted, |best| counted * independence(&fall, best)).max(3.0);
    let score = |curve: &Curve| aicc(curve.chi2 / counted, independent, curve.parameters.len());
    let mut fits: Vec<(f64, EnvelopeFit)> = curves
        .iter()
        .filter(|curve| physical(curve))
        .filter_map(|curve| Some((score(curve)?, fall.described(curve, counted, independent))))
        .collect();
    fits.sort_by(|a, b| a.0.total_cmp(&b.0));
    let Some(lowest) = fits.first().map(|fit| fit.0) else {
        return Err(CyclesError::TooFewHalfSwings { found: half_swings.len(), needed: FEWEST });
    };
    let fits = fits.into_iter().map(|(score, fit)| EnvelopeFit { aicc_difference: score - lowest, ..fit });
    Ok(Envelope { fits: fits.collect(), independent, outliers })
}

/// `AICc` from the mean square; none where there are too few data for so many parameters.
fn aicc(mean_square: f64, independent: f64, parameters: usize) -> Option<f64> {
    #[expect(clippy::cast_precision_loss, reason = "at most five")]
    let cost = akaike::cost(independent, parameters as f64 + 1.0)?;
    Some(independent * libm::log(mean_square.max(f64::MIN_POSITIVE)) + cost)
}

/// (1 − ρ)/(1 + ρ) with the correlation of neighbouring residuals; that of either side counts half, so that a centre a
/// little off does not pass for independence.
fn independence(fall: &Fall<'_>, best: &Curve) -> f64 {
    let residuals: Vec<f64> = fall.residuals(&best.fitted);
    let square: f64 = residuals.iter().map(|r| r * r).sum();
    let lagged =
        |lag: usize| residuals.iter().zip(&residuals[lag..]).map(|(a, b)| a * b).sum::<f64>() / square;
    let correlation = (0.5 * (lagged(1) + lagged(2))).clamp(0.0, 0.95);
    if correlation.is_nan() { 1.0 } else { (1.0 - correlation) / (1.0 + correlation) }
}

/// The falling amplitude.
struct Fall<'a> {
    half_swings: &'a [HalfSwing],
    rates: DecayRates,
    /// One over the uncertainties; zero for outliers.
    weights: Vec<f64>,
    /// Steps of the integration are at most this long.
    substep: f64,
}

/// A law with its parameters: the first amplitude, then the coefficients.
struct Curve {
    terms: DampingTerms,
    parameters: Vec<f64>,
    /// Of the weighted residuals.
    covariance: DMatrix<f64>,
    chi2: f64,
    fitted: Vec<f64>,
}

impl Fall<'_> {
    /// The parameters by Marquardt's method, beginning with those of a linear equation; none where the data are too few.
    fn fit(&self, terms: DampingTerms) -> Option<Curve> {
        let mut parameters = self.guess(terms)?;
        let mut chi2 = self.chi2(terms, &parameters);
        let mut damping = 1e-3;
        for _ in 0..MOST_ROUNDS {
            let (matrix, residuals) = self.linearised(terms, &parameters);
            let normal = matrix.transpose() * &matrix;
            let mut damped = normal.clone();
            for k in 0..damped.nrows() {
                damped[(k, k)] *= 1.0 + damping;
            }
            let step = damped.cholesky()?.solve(&(matrix.transpose() * residuals));
            let moved: Vec<f64> = parameters.iter().zip(step.iter()).map(|(p, s)| p + s).collect();
            let renewed = self.chi2(terms, &moved);
            if renewed.is_nan() || renewed > chi2 {
                damping *= 10.0;
                continue;
            }
            let settled = chi2 - renewed <= 1e-10 * chi2;
            (parameters, chi2, damping) = (moved, renewed, damping * 0.1);
            if settled {
                break;
            }
        }
        let (matrix, _) = self.linearised(terms, &parameters);
        let covariance = (matrix.transpose() * matrix).cholesky()?.inverse();
        let fitted = self.amplitudes(terms, &parameters);
        Some(Curve { terms, parameters, covariance, chi2, fitted })
    }

    /// A(t) = A0 − Σ cₙ∫φₙ dt with the measured amplitudes inside the integrals.
    fn guess(&self, terms: DampingTerms) -> Option<Vec<f64>> {
        let used = self.weights.iter().filter(|&&weight| weight > 0.0).count();
        if used < terms.count() + 2 {
            return None;
        }
        let mut columns = vec![vec![1.0; self.half_swings.len()]];
        for term in terms.iter() {
            let rate = |half: &HalfSwing| self.rates.at(term, half.amplitude);
            let mut integral = vec![0.0];
            for pair in self.half_swings.windows(2) {
                let mean = 0.5 * (rate(&pair[0]) + rate(&pair[1]));
                integral.push(integral[integral.len() - 1] - mean * (pair[1].time - pair[0].time));
            }
            columns.push(integral);
        }
        let matrix =
            DMatrix::from_fn(self.half_swings.len(), columns.len(), |i, j| columns[j][i] * self.weights[i]);
        let right =
            DVector::from_fn(self.half_swings.len(), |i, _| self.half_swings[i].amplitude * self.weights[i]);
        let solution = (matrix.transpose() * &matrix).cholesky()?.solve(&(matrix.transpose() * right));
        Some(solution.iter().copied().collect())
    }

    /// The derivatives of the weighted amplitudes, and the weighted residuals.
    fn linearised(&self, terms: DampingTerms, parameters: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
        let fitted = self.amplitudes(terms, parameters);
        let residuals = DVector::from_vec(self.residuals(&fitted));
        let mut matrix = DMatrix::zeros(fitted.len(), parameters.len());
        for k in 0..parameters.len() {
            let mut moved = parameters.to_vec();
            let step = 1e-5 * if k == 0 { parameters[0] } else { self.typical(terms, k) };
            moved[k] += step;
            for (row, value) in self.amplitudes(terms, &moved).iter().enumerate() {
                matrix[(row, k)] = (value - fitted[row]) / step * self.weights[row];
            }
        }
        (matrix, residuals)
    }

    /// The coefficient with which a kind of damping alone would halve the amplitude in this time.
    fn typical(&self, terms: DampingTerms, parameter: usize) -> f64 {
        let (first, last) = (self.half_swings[0], self.half_swings[self.half_swings.len() - 1]);
        let term = terms.iter().nth(parameter - 1).unwrap_or(DampingTerm::Linear);
        0.5 * first.amplitude / (self.rates.at(term, first.amplitude) * (last.time - first.time))
    }

    /// The amplitudes at the half swings, by the rule of Runge and Kutta.
    fn amplitudes(&self, terms: DampingTerms, parameters: &[f64]) -> Vec<f64> {
        let rate = |amplitude: f64| -> f64 {
            terms.iter().zip(&parameters[1..]).map(|(term, c)| -c * self.rates.at(term, amplitude)).sum()
        };
        let mut amplitude = parameters[0];
        let mut amplitudes = vec![amplitude];
        for pair in self.half_swings.windows(2) {
            let duration = pair[1].time - pair[0].time;
            let steps = (duration / self.substep).ceil().clamp(1.0, 1000.0);
            let step = duration / steps;
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 1000")]
            for _ in 0..steps as usize {
                let a = rate(amplitude);
                let b = rate(amplitude + 0.5 * step * a);
                let c = rate(amplitude + 0.5 * step * b);
                let d = rate(amplitude + step * c);
                amplitude = (amplitude + step / 6.0 * (a + 2.0 * b + 2.0 * c + d)).max(0.0);
            }
            amplitudes.push(amplitude);
        }
        amplitudes
    }

    fn residuals(&self, fitted: &[f64]) -> Vec<f64> {
        let rows = self.half_swings.iter().zip(fitted).zip(&self.weights);
        rows.map(|((half, fitted), weight)| (half.amplitude - fitted) * weight).collect()
    }

    fn chi2(&self, terms: DampingTerms, parameters: &[f64]) -> f64 {
        self.residuals(&self.amplitudes(terms, parameters)).iter().map(|r| r * r).sum()
    }

    /// Takes the weight from extremes far from the law with all kinds of damping, and says how many they are.
    fn drop_outliers(&mut self, full: DampingTerms) -> usize {
        let mut dropped = 0;
        for _ in 0..5 {
            let Some(curve) = self.fit(full) else { break };
            let residuals = self.residuals(&curve.fitted);
            let Some(middle) = median(residuals.clone()) else { break };
            let deviation = robust_deviation(&residuals).unwrap_or(0.0);
            let far = |r: f64| deviation > 0.0 && (r - middle).abs() > OUTLIER * deviation;
            let rows: Vec<usize> = (0..residuals.len()).filter(|&row| far(residuals[row])).collect();
            for &row in &rows {
                self.weights[row] = 0.0;
            }
            dropped += rows.len();
            if rows.is_empty() {
                break;
            }
        }
        dropped
    }

    fn described(&self, curve: &Curve, counted: f64, independent: f64) -> EnvelopeFit {
        #[expect(clippy::cast_precision_loss, reason = "at most four")]
        let dof = (counted - curve.parameters.len() as f64).max(1.0);
        let scale = curve.chi2 / dof * counted / independent;
        let coefficients = curve.terms.iter().enumerate().map(|(k, term)| Coefficient {
            term,
            value: curve.parameters[k + 1],
            uncertainty: (scale * curve.covariance[(k + 1, k + 1)]).sqrt(),
        });
        let counts = self.half_swings.iter().zip(&curve.fitted).zip(&self.weights).filter(|row| *row.1 > 0.0);
        let square: f64 =
            counts.map(|((half, fitted), _)| (half.amplitude - fitted) * (half.amplitude - fitted)).sum();
        EnvelopeFit {
            damping: curve.terms,
            amplitude: curve.parameters[0],
            coefficients: coefficients.collect(),
            rms: (square / counted).sqrt(),
            aicc_difference: 0.0,
            fitted: curve.fitted.clone(),
        }
    }
}
