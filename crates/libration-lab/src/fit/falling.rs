//! A falling amplitude by its rate of fall.

/// The amplitudes at these increasing positions, from the amplitude at the first, by the classical Runge–Kutta method with steps of at most this
/// size. The rate is that of the decrease; amplitudes are not below zero.
pub(super) fn falling(
    first: f64,
    positions: impl IntoIterator<Item = f64>,
    longest_step: f64,
    rate: impl Fn(f64) -> f64,
) -> Vec<f64> {
    let mut amplitude = first;
    let mut last = None;
    let mut amplitudes = vec![];
    for position in positions {
        let duration = position - last.unwrap_or(position);
        let steps = (duration / longest_step).ceil().clamp(1.0, 1000.0);
        let step = duration / steps;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 1000")]
        for _ in 0..steps as usize {
            let a = rate(amplitude);
            let b = rate(amplitude - 0.5 * step * a);
            let c = rate(amplitude - 0.5 * step * b);
            let d = rate(amplitude - step * c);
            amplitude = (amplitude - step / 6.0 * (a + 2.0 * b + 2.0 * c + d)).max(0.0);
        }
        amplitudes.push(amplitude);
        last = Some(position);
    }
    amplitudes
}
