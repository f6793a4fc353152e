//! Autocorrelation of residuals, and the test of whether they are noise.

use crate::statistics::count;

/// Autocorrelation of consecutive residuals.
#[derive(Clone, Debug, PartialEq)]
pub struct Autocorrelation {
    /// Autocorrelations by lag in rows, from lag zero; the first is 1.
    pub correlations: Vec<f64>,
    /// Number of rows after which residuals are independent: 1 + 2 Σ ρₖ up to a window of six such times, at least 1 (A. Sokal,
    /// *Monte Carlo Methods in Statistical Mechanics*, doi:10.1007/978-1-4899-0319-8_6).
    pub time: f64,
    /// Ljung's and Box's n(n + 2) Σ ρₖ²/(n − k) over the first lags, less its mean for noise, over its standard deviation
    /// (Biometrika 65, 297 (1978), doi:10.1093/biomet/65.2.297).
    pub excess: f64,
}

/// Lags of the test: with 10 and 40 the same of twelve recordings (`search.rs`) were found not to be noise.
const LAGS: usize = 20;
/// Lags of the correlation time: with 300 no T0 and no uncertainty changed by a twentieth.
const LONGEST_LAG: usize = 1000;

impl Autocorrelation {
    /// Computes the autocorrelation of several series of residuals, without products across series.
    #[must_use]
    pub fn of_series(series: &[Vec<f64>]) -> Self {
        let rows: usize = series.iter().map(Vec::len).sum();
        let sum = |lag: usize| -> f64 {
            let products = series.iter().flat_map(|one| one.iter().zip(one.iter().skip(lag)));
            products.map(|(a, b)| a * b).sum()
        };
        let variance = sum(0);
        let longest = series.iter().map(Vec::len).max().unwrap_or(0).saturating_sub(1);
        let mut correlations = vec![1.0];
        let mut time: f64 = 1.0;
        for lag in 1..=longest.min(LONGEST_LAG) {
            let correlation = if variance > 0.0 { sum(lag) / variance } else { 0.0 };
            correlations.push(correlation);
            if count(lag) <= 6.0 * time {
                time = (time + 2.0 * correlation).max(1.0);
            } else if lag >= LAGS {
                break;
            }
        }
        let n = count(rows);
        let lags = LAGS.min(rows / 5).min(correlations.len() - 1);
        let terms = (1..=lags).map(|lag| correlations[lag] * correlations[lag] / (n - count(lag)));
        let statistic = n * (n + 2.0) * terms.sum::<f64>();
        let degrees = count(lags.max(1));
        Self { correlations, time, excess: (statistic - degrees) / (2.0 * degrees).sqrt() }
    }

    /// Returns `true` if the residuals are consistent with independent ones; noise fails the test once in some ten thousand times.
    #[must_use]
    pub fn is_noise(&self) -> bool {
        self.excess < 5.0
    }
}
