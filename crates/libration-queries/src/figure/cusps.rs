//! Sizes on a logarithmic axis: where a quantity changes sign, its size runs down to zero.

/// Halvings of the distance to a change of sign: enough for every axis.
const HALVINGS: i32 = 60;

/// The sizes of a sampled quantity, with the approach to each change of sign, between its samples a line.
pub fn sizes(samples: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut sizes = vec![];
    for pair in samples.windows(2) {
        sizes.push((pair[0].0, pair[0].1.abs()));
        if pair[0].1 * pair[1].1 < 0.0 {
            sizes.extend(cusp(pair[0], pair[1]));
        }
    }
    sizes.extend(samples.last().map(|(x, y)| (*x, y.abs())));
    sizes
}

/// The points of a cusp: down from one side and up to the other, in steps that halve.
fn cusp(before: (f64, f64), after: (f64, f64)) -> impl Iterator<Item = (f64, f64)> {
    let zero = before.0 - before.1 * (after.0 - before.0) / (after.1 - before.1);
    let beside = move |(x, y): (f64, f64), k: i32| {
        let part = 0.5f64.powi(k);
        (zero + part * (x - zero), (part * y).abs())
    };
    let down = (1..HALVINGS).map(move |k| beside(before, k));
    let up = (1..HALVINGS).rev().map(move |k| beside(after, k));
    down.chain([(zero, 0.0)]).chain(up)
}
