//! The times and places of animations.

use libration_queries::internals::animation::{Playing, SampledCoordinates};

#[test]
fn a_second_is_a_second_where_that_can_be_watched() {
    for (to, speed, frames) in
        [(10.0, 1.0, 301), (30.0, 1.0, 901), (30.1, 2.0, 453), (-100.0, 5.0, 601), (1e-3, 1e-3, 31)]
    {
        let playing = Playing::new(0.0, to);
        assert!((playing.speed / speed - 1.0).abs() < 1e-12, "{to}: {}", playing.speed);
        let times = playing.times();
        assert_eq!((times.len(), times[0], times.last()), (frames, 0.0, Some(&to)));
    }
}

#[test]
fn coordinates_between_samples_are_on_straight_lines() {
    let sampled = SampledCoordinates { times: &[0.0, -1.0, -3.0], values: &[vec![0.0, 2.0, 6.0]] };
    for (time, value) in [(0.0, 0.0), (-0.5, 1.0), (-1.0, 2.0), (-2.0, 4.0), (-3.0, 6.0), (-4.0, 6.0)] {
        assert!((sampled.value(0, time) - value).abs() < 1e-15, "{time}");
    }
}
