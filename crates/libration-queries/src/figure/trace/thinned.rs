//! Reduction of dense points that could not be distinguished, with the extremes kept.

use crate::output::number::count;

/// More points than this on one pair of axes would not be seen.
pub const MOST: usize = 3000;

/// The points in their order; of very many, the lowest and the highest in each interval.
pub fn thinned(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    if points.len() <= MOST {
        return points;
    }
    points.chunks((2 * points.len()).div_ceil(MOST)).flat_map(extremes).collect()
}

/// One point of each interval, at varying positions so that the spacing of the rows does not show, and all points further from zero than four
/// standard deviations, of which chance makes one in 16 000: the distribution of the values remains visible, which the extremes of each interval
/// would hide.
pub fn representative(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    const FAR: f64 = 4.0;
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let stretch = one_of(points.len());
    if stretch == 1 {
        return points;
    }
    let far = FAR * (points.iter().map(|point| point.1 * point.1).sum::<f64>() / count(points.len())).sqrt();
    let chosen = |number: usize, length: usize| {
        let position = (GOLDEN * count(number)).fract() * count(length);
        (0..length).take_while(|&k| count(k) <= position).count() - 1
    };
    let of_stretch = |(number, chunk): (usize, &[(f64, f64)])| {
        let one = chosen(number, chunk.len());
        let kept = chunk.iter().enumerate().filter(|(k, point)| *k == one || point.1.abs() > far);
        kept.map(|(_, point)| *point).collect::<Vec<_>>()
    };
    points.chunks(stretch).enumerate().flat_map(of_stretch).collect()
}

/// Number of points represented by each drawn point.
pub(super) fn one_of(points: usize) -> usize {
    points.div_ceil(MOST).max(1)
}

fn extremes(chunk: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let extreme = |best: fn(f64, f64) -> bool| {
        let better = |best_place: usize, candidate: usize| {
            if best(chunk[candidate].1, chunk[best_place].1) { candidate } else { best_place }
        };
        (0..chunk.len()).reduce(better).unwrap_or(0)
    };
    let (low, high) = (extreme(|a, b| a < b), extreme(|a, b| a > b));
    let mut places = vec![low.min(high), low.max(high)];
    places.dedup();
    places.into_iter().map(|index| chunk[index]).collect()
}
