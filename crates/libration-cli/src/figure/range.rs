//! Axis ends and tick distances that people read easily.

/// The distance 1, 2 or 5 times a power of ten that divides the range into three to ten parts.
pub(crate) fn tick_step(from: f64, to: f64) -> f64 {
    let rough = (to - from).abs() / 8.0;
    if !rough.is_finite() || rough <= 0.0 {
        return 1.0;
    }
    let power = 10f64.powf(rough.log10().floor());
    let factors = [1.0, 2.0, 5.0, 10.0];
    factors.into_iter().map(|factor| factor * power).find(|step| *step >= rough).unwrap_or(rough)
}

/// The smallest range between multiples of its tick distance that holds all the values, with a little room.
pub(crate) fn around(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let finite = values.into_iter().filter(|value| value.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    if low > high {
        return (-1.0, 1.0);
    }
    let room = if high > low { 0.04 * (high - low) } else { 0.1 * high.abs().max(1e-12) };
    let (low, high) = (low - room, high + room);
    let step = tick_step(low, high);
    ((low / step).floor() * step, (high / step).ceil() * step)
}

/// The powers of ten that hold the values, and three more below.
pub(crate) fn decades(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let positive = values.into_iter().filter(|value| *value > 0.0 && value.is_finite());
    let (low, high) = positive.fold((f64::INFINITY, 0.0), |(l, h), v| (v.min(l), v.max(h)));
    if high <= 0.0 {
        return (1e-16, 1.0);
    }
    (10f64.powf((low.log10().floor() - 3.0).max(-18.0)), 10f64.powf(high.log10().ceil()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_divide_the_range_into_three_to_ten_parts() {
        for range in [1e-9, 0.3, 1.0, 3.7, 180.0, 1e7] {
            let parts = range / tick_step(0.0, range);
            assert!((3.5..10.1).contains(&parts), "{range}: {parts}");
        }
    }

    #[test]
    fn the_range_holds_the_values() {
        assert_eq!(around([1.0, 9.0]), (0.0, 10.0));
        assert_eq!(around([f64::NAN]), (-1.0, 1.0));
    }
}
